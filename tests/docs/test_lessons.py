"""What every lesson of this book itself must hold to."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest
from contact_book.book import Book, Chapter
from contact_book.exercises import lesson_time
from sample_book import ROOT

BOOK = Book(ROOT, Path())
LESSONS = [chapter for chapter in BOOK.chapters.values() if chapter.has_lesson]


@pytest.mark.parametrize("chapter", LESSONS, ids=[chapter.slug for chapter in LESSONS])
def test_reading_and_the_first_exercises_take_about_45_minutes(chapter: Chapter) -> None:
    assert 35 <= lesson_time(BOOK, chapter).lesson <= 55


@pytest.mark.parametrize(
    ("before", "chapter"), list(pairwise(LESSONS)), ids=[chapter.slug for chapter in LESSONS[1:]]
)
def test_a_lesson_recalls_the_one_before_it(before: Chapter, chapter: Chapter) -> None:
    assert before.slug in {name.split("/")[0] for name in chapter.recall}
