"""The measurements that the book keeps: they hold what the ladders declare, and what failed."""

from __future__ import annotations

import html
import json
import math
import re
import subprocess
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
CHAPTERS = sorted(file.parent.name for file in ROOT.glob("chapters/*/ladder.cpp"))
_RECOMMENDED = re.compile(r'ladder\.recommend\("([^"]+)"\)')
_PART = re.compile(r"parts\.add\((measured_\w+)::experiment\(\)\)")


def kept(slug: str) -> list[dict[str, Any]]:
    files = sorted((ROOT / "benchmarks" / "results").glob(f"{slug}.*.json"))
    return [json.loads(file.read_text(encoding="utf-8")) for file in files]


def source_of(slug: str) -> str:
    """The ladder with the text of each part that a header of the chapter's tests defines."""
    source = (ROOT / "chapters" / slug / "ladder.cpp").read_text(encoding="utf-8")
    header = ROOT / "tests" / slug
    return _PART.sub(lambda part: (header / f"{part[1]}.hpp").read_text(encoding="utf-8"), source)


def test_every_ladder_has_been_measured() -> None:
    assert len(CHAPTERS) >= 11
    assert [slug for slug in CHAPTERS if not kept(slug)] == []


@pytest.mark.parametrize("slug", CHAPTERS)
def test_a_method_that_is_declared_exact_is_never_wrong(slug: str) -> None:
    for data in kept(slug):
        exact = {method["id"] for method in data["methods"] if method["exact"]}
        wrong = [row for row in data["results"] if row["method"] in exact and row["wrong"] > 0]
        assert wrong == []


@pytest.mark.parametrize("slug", CHAPTERS)
def test_the_recommended_method_is_the_one_that_the_source_names(slug: str) -> None:
    named = _RECOMMENDED.findall(source_of(slug))
    assert named
    for data in kept(slug):
        assert len(named) == len({row.get("part") for row in data["methods"]}), "one a question"
        assert [row["id"] for row in data["methods"] if row.get("recommended")] == named


@pytest.mark.parametrize("slug", CHAPTERS)
def test_where_a_method_is_wrong_an_input_is_kept_in_a_figure_or_with_the_reason_why_not(
    slug: str,
) -> None:
    figures = {file.stem for file in (ROOT / "chapters" / slug / "figures").glob("*.cpp")}
    lesson = (ROOT / "chapters" / slug / "lesson.md").read_text(encoding="utf-8")
    for data in kept(slug):
        for row in data["results"]:
            failure = row.get("failure")
            what = f"{row['method']}, {row['family']}"
            if row["wrong"] > 0:
                assert failure, what
            if not failure:
                continue
            assert failure["facts"], what
            if "figure" not in failure:
                assert failure["note"], what
                continue
            assert failure["figure"] in figures, what
            assert f"{{live-figure}} {failure['figure']}\n" in lesson, what


def _said(data: dict[str, Any], file: Path) -> str:
    """What the picture says of the book's choice."""
    file.write_text(json.dumps(data), encoding="utf-8")
    drawer = ROOT / "page" / "web" / "ladder_picture.mjs"
    done = subprocess.run(["node", str(drawer), str(file)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    said = re.search(r'<p class="proven">(.*?)</p>', done.stdout)
    assert said
    return html.unescape(re.sub(r"<[^>]*>", "", said[1]))


def test_of_the_depths_only_methods_with_no_larger_error_are_said_to_be_as_good(
    tmp_path: Path,
) -> None:
    for data in kept("09_separating_planes"):
        part: dict[str, list[Any]] = {key: [] for key in ("families", "methods")}
        for key, rows in part.items():
            rows += [row for row in data[key] if row["part"] == "How deep?"]
        assert part["families"]
        assert all(row["by_error"] for row in part["families"])
        ids = {row["id"] for row in part["methods"]}
        results = [row for row in data["results"] if row["method"] in ids]
        error = {id: max(r["error_max"] for r in results if r["method"] == id) for id in ids}
        time = {id: math.prod(r["ns_median"] for r in results if r["method"] == id) for id in ids}
        chosen = next(row["id"] for row in part["methods"] if row.get("recommended"))
        rivals = [id for id in ids if time[id] < time[chosen] and error[id] <= error[chosen]]
        assert "depth-centres" not in rivals
        assert error["depth-centres"] > 1
        said = _said({**data, **part, "results": results}, tmp_path / "depths.json")
        titles = {row["id"]: row["title"] for row in part["methods"]}
        assert "no error above" in said
        assert len(rivals) == 1
        assert f"“{titles[rivals[0]]} (double)” is faster and" in said
