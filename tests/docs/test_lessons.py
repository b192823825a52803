"""What every lesson of this book itself must hold to."""

from __future__ import annotations

import re
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


def glossary() -> list[tuple[list[str], str]]:
    """The names of each entry, and what it says."""
    text = (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8")
    _, _, entries = text.partition(":::{glossary}\n")
    found = []
    for entry in entries.removesuffix(":::\n").strip().split("\n\n"):
        lines = entry.splitlines()
        names = [line for line in lines if not line.startswith(" ")]
        found.append((names, " ".join(line.strip() for line in lines[len(names) :])))
    return found


def marked_terms(slug: str) -> set[str]:
    """What a lesson links to the glossary or marks for the index, in small letters."""
    chapter = BOOK.chapters[slug]
    if not chapter.has_lesson:
        return set()
    text = " ".join(chapter.lesson.read_text(encoding="utf-8").split())
    marks = re.findall(r"\{(?:term|index)\}`(?:[^`<]*<)?([^`>]*)>?`", text)
    return {mark.lower() for mark in marks}


@pytest.mark.parametrize(("names", "said"), glossary(), ids=[names[0] for names, _ in glossary()])
def test_a_lesson_teaches_the_term_or_it_will_come(names: list[str], said: str) -> None:
    chapters = re.findall(r"\{chapter\}`(\w+)`", said)
    assert chapters, f"{names[0]} names no chapter"
    lower = {name.lower() for name in names}
    first = chapters[0]
    assert lower & marked_terms(first) or "will come" in said, f"{first} does not mark {names[0]}"


def test_the_glossary_is_in_order() -> None:
    first = [names[0].lower() for names, _ in glossary()]
    assert first == sorted(first)
