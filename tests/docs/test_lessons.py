"""What every lesson of this book itself must hold to."""

from __future__ import annotations

from pathlib import Path

import pytest
from contact_book.book import Book, Chapter
from sample_book import ROOT

BOOK = Book(ROOT, Path())
LESSONS = [chapter for chapter in BOOK.chapters.values() if chapter.has_lesson]


@pytest.mark.parametrize("place", range(len(LESSONS)), ids=[lesson.slug for lesson in LESSONS])
def test_a_lesson_recalls_those_one_three_and_seven_before_it(place: int) -> None:
    recalled = {name.split("/")[0] for name in LESSONS[place].recall}
    assert {LESSONS[place - back].slug for back in (1, 3, 7) if back <= place} <= recalled


@pytest.mark.parametrize("chapter", LESSONS, ids=[chapter.slug for chapter in LESSONS])
def test_a_lesson_links_to_what_its_lectures_get_wrong(chapter: Chapter) -> None:
    text = chapter.lesson.read_text(encoding="utf-8")
    written = {path.stem for path in (chapter.folder / "lectures").glob("*.md")}
    assert {name for name in written if f"{{errata}}`{name}`" not in text} == set()
