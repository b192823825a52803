"""The table of what the tests say of small changes of the solutions."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from bs4 import BeautifulSoup
from contact_book.errors import BookError
from contact_book.mutants import percent, read_kept
from sample_book import Sample

ROOT = Path(__file__).resolve().parents[2]
KEPT = "grading/mutants/kept/01_lines.json"


def counts(**changed: int | str) -> dict[str, Any]:
    """Ten mutants: seven caught, six of them by a wrong answer."""
    ended = {"mutants": 10, "killed": 7, "equivalent": 1, "also_right": 1, "left": 1}
    said = {"killed_by_an_answer": 6, "one_hint": 2, "several": 1, "noted": 2, "no_hint": 1}
    return {**ended, **said, **changed}


def write(file: Path, kept: object) -> Path:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(kept), encoding="utf-8")
    return file


def test_the_page_shows_the_sums_and_percentages_of_the_kept_counts(sample: Sample) -> None:
    sample.edit("docs/index.md", ":::{chapter-map}", ":::{mutants}\n:::\n\n:::{chapter-map}")
    file = write(sample.root / KEPT, {"distance": counts(killed="seven")})
    made = sample.make()
    assert made.returncode == 1
    assert "docs/index.md:6: " in made.stderr
    assert f"{KEPT}: distance: 'killed' must be a number of mutants, not 'seven'" in made.stderr

    more = counts(mutants=1004, killed=1001, killed_by_an_answer=1000, no_hint=995)
    write(file, {"distance": counts(), "line": more})
    made = sample.make()
    assert made.returncode == 0, made.stderr
    page = BeautifulSoup(sample.page("index.html"), "html.parser")
    rows = [
        [cell.get_text(strip=True).replace("\N{NO-BREAK SPACE}", " ") for cell in row.select("td")]
        for row in page.select("table.mutants tbody tr")
    ]
    sums = ["1,014", "1,008", "2", "2", "2", "1,006", "4", "6", "996"]
    assert [row[1:] for row in rows[:-1]] == [sums]
    shares = {1: " (99 %)", 6: " (1 %)", 7: " (1 %)", 8: " (99 %)"}
    assert rows[-1] == ["All", *(text + shares.get(at, "") for at, text in enumerate(sums))]
    link = page.select_one("table.mutants tbody a")
    assert link is not None
    assert link["href"] == "chapters/01_lines.html"


@pytest.mark.parametrize(
    ("kept", "problem"),
    [
        ([], "must hold an object with the counts of each exercise"),
        ({"distance": 3}, "kept: distance: the counts must be an object"),
        ({"distance": counts(left=-1)}, "'left' must be a number of mutants, not -1"),
        ({"distance": counts(left=2)}, "'mutants' is not the sum of killed, equivalent, also_"),
        ({"distance": counts(noted=3)}, "'killed_by_an_answer' is not the sum of one_hint, sev"),
    ],
)
def test_a_malformed_file_is_refused(tmp_path: Path, kept: object, problem: str) -> None:
    file = write(tmp_path / "kept.json", kept)
    with pytest.raises(BookError, match=problem):
        read_kept(file, "kept")


def test_a_file_that_is_no_json_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "kept.json"
    file.write_text("{\n", encoding="utf-8")
    with pytest.raises(BookError, match=r"kept is not JSON: .* line 2"):
        read_kept(file, "kept")


def test_a_percentage_is_all_only_of_all() -> None:
    shown = [percent(*of) for of in ((999, 1000), (1000, 1000), (1, 1000), (0, 1000), (0, 0))]
    assert [text.replace("\N{NO-BREAK SPACE}", " ") for text in shown] == [
        *("99 %", "100 %", "1 %", "0 %", "–")
    ]


def test_every_exercise_has_kept_counts_that_add_up() -> None:
    files = sorted((ROOT / "grading/mutants/kept").glob("*.json"))
    kept = {
        f"{file.stem}/{name}": counts
        for file in files
        for name, counts in read_kept(file, file.name).items()
    }
    exercises = ROOT.glob("exercises/*/*/exercise.toml")
    assert sorted(kept) == sorted(f"{file.parts[-3]}/{file.parts[-2]}" for file in exercises)
