"""Which page of the book is written next."""

from __future__ import annotations

from pathlib import Path

from contact_book.page_order import PagesInOrder

NAMES = {"api/01_a", "chapters/01_a", "chapters/02_b", "chapters/03_c", "glossary", "index"}
IN_ORDER = ["index", "chapters/01_a", "chapters/02_b", "chapters/03_c", "api/01_a", "glossary"]


def test_home_and_lessons_are_written_first() -> None:
    assert list(PagesInOrder(NAMES, None)) == IN_ORDER


def test_the_page_that_was_asked_for_last_is_next_and_told_when_it_is_written(
    tmp_path: Path,
) -> None:
    ready = tmp_path / "ready"
    written = []
    for name in PagesInOrder(NAMES, tmp_path):
        written.append(name)
        told = ready.read_text().split() if ready.exists() else []
        assert told == written[:-1]
        if name == "index":
            (tmp_path / "wanted").write_text("chapters/02_b\nnothing\nchapters/03_c\nindex\n")
    assert written == ["index", "chapters/03_c", "chapters/02_b", "chapters/01_a", *IN_ORDER[4:]]
    assert ready.read_text().split() == written
