"""Which files of docs/ become pages of the book."""

from __future__ import annotations

from pathlib import Path

from contact_book.book import Book
from contact_book.stage import pages
from sample_book import HERE


def staged(docs: Path, *names: str) -> set[str]:
    for name in names:
        path = docs / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("# A page\n", encoding="utf-8")
    made = pages(Book(HERE / "sample", docs), docs, api=False)
    return {name for name in names if name in made}


def test_a_folder_with_an_index_is_staged_with_its_pages(tmp_path: Path) -> None:
    there = staged(tmp_path, "index.md", "scenes/index.md", "scenes/stages.md")
    assert there == {"index.md", "scenes/index.md", "scenes/stages.md"}


def test_a_folder_without_an_index_is_left_out(tmp_path: Path) -> None:
    assert staged(tmp_path, "index.md", "build/notes.md") == {"index.md"}
