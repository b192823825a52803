"""Writes the pages that somebody waits for first.

While `./contact serve` builds the lessons it answers already (tools/serve.py). It tells here, in a
folder with two files of names, one a line, which pages were asked for, and is told which can be
read. Without CONTACT_BOOK_PAGES the pages are written in the order of the book.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence, Set
from pathlib import Path

from sphinx.application import Sphinx
from sphinx.builders.html import StandaloneHTMLBuilder


class PagesInOrder(Sequence[str]):
    """The names of pages; which is next is decided when it is asked for."""

    def __init__(self, names: Set[str], folder: Path | None) -> None:
        self._names = sorted(names, key=_rank)
        self._folder = folder

    def __len__(self) -> int:
        return len(self._names)

    def __getitem__(self, at: int) -> str:  # type: ignore[override]
        return self._names[at]

    def __iter__(self) -> Iterator[str]:
        left = list(self._names)
        while left:
            name = next((one for one in self._wanted() if one in left), left[0])
            left.remove(name)
            yield name
            # Who asks for the next one has written this one.
            if self._folder and self._folder.is_dir():
                with (self._folder / "ready").open("a", encoding="utf-8") as ready:
                    ready.write(f"{name}\n")

    def _wanted(self) -> list[str]:
        """The last one first."""
        try:
            return (
                (self._folder / "wanted").read_text("utf-8").split()[::-1] if self._folder else []
            )
        except FileNotFoundError:
            return []


def _rank(name: str) -> tuple[bool, bool, str]:
    """The home page, the lessons, the rest."""
    return (name != "index", not name.startswith("chapters/"), name)


class Pages(StandaloneHTMLBuilder):
    """Sphinx's `html`, in that order."""

    def write_documents(self, docnames: Set[str]) -> None:
        folder = os.environ.get("CONTACT_BOOK_PAGES")
        self._write_serial(PagesInOrder(docnames, Path(folder) if folder else None))


def connect(app: Sphinx) -> None:
    app.add_builder(Pages, override=True)
