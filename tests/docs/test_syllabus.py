"""What an instructor plans a course with: times from the chapters, and an order that works."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from bs4 import BeautifulSoup, Tag
from contact_book.book import Book, Chapter
from contact_book.errors import BookError
from contact_book.syllabus import require_order
from sample_book import ROOT, Sample


def rows(built: Sample, kind: str) -> list[list[str]]:
    """The cells of a table of the home page, without its head."""
    page = BeautifulSoup(built.page("index.html"), "html.parser")
    body = page.select_one(f"table.{kind} tbody")
    assert isinstance(body, Tag)
    return [
        [re.sub(r"\s+", " ", cell.get_text()).strip() for cell in row.select("td")]
        for row in body.select("tr")
    ]


def test_the_syllabus_lists_lessons_only(built: Sample) -> None:
    assert [row[0] for row in rows(built, "syllabus")] == ["01 Lines"]


def test_the_syllabus_counts_questions_and_exercises(built: Sample) -> None:
    ((_, _, questions, inside, further, earlier),) = rows(built, "syllabus")
    said = (built.root / "chapters/01_lines/questions.toml").read_text(encoding="utf-8")
    assert int(questions) == len(re.findall(r"^\[\[question\]\]", said, re.MULTILINE))
    toml = (built.root / "exercises/01_lines/distance/exercise.toml").read_text(encoding="utf-8")
    minutes = re.search(r"^minutes = (\d+)", toml, re.MULTILINE)
    assert minutes is not None
    assert inside == f"1: {minutes[1]}"
    assert further == "0: 0"
    assert earlier == "00"


def test_a_course_has_a_row_for_each_meeting(built: Sample) -> None:
    ((number, read, inside, further, _, points),) = rows(built, "course")
    assert (number, read, inside, further, points) == ("1", "Lines", "distance", "none", "0")


def test_a_course_with_a_wrong_chapter_is_refused(sample: Sample) -> None:
    sample.edit("docs/index.md", "One meeting\n01_lines", "One meeting\n01_lines 01_lines")
    made = sample.make()
    assert made.returncode != 0
    assert "meeting 1: 01_lines is in the course twice" in made.stdout + made.stderr


@pytest.fixture(scope="module")
def chapters() -> dict[str, Chapter]:
    return Book(ROOT, Path()).chapters


def test_an_order_with_what_is_built_on_before_passes(chapters: dict[str, Chapter]) -> None:
    require_order([[chapters["00_vectors"]], [chapters["12_momentum"]]], chapters)


def test_a_chapter_before_one_that_it_builds_on_is_refused(chapters: dict[str, Chapter]) -> None:
    with pytest.raises(BookError, match=r"meeting 1: 12_momentum builds on 00_vectors"):
        require_order([[chapters["12_momentum"], chapters["00_vectors"]]], chapters)
