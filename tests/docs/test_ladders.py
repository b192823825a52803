"""The measurements that the book keeps: they hold what the ladders declare, and what failed."""

from __future__ import annotations

import json
import re
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
