"""The book as found on disk. `chapters/` is the only registry; nothing is listed anywhere."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from book_json import book_json

from contact_book.errors import BookError, unknown
from contact_book.toml import Table, read_toml

PARTS = (
    "Before",
    "Part I. Where things meet",
    "Part II. What happens then",
    "Part III. Together",
)
_SLUG = re.compile(r"\d\d_[a-z][a-z0-9_]*")


@dataclass(frozen=True)
class Objective:
    id: str
    text: str


@dataclass(frozen=True)
class Source:
    lecture: str
    topic: str


@dataclass(frozen=True)
class Lecture:
    """One that the chapters name among their sources."""

    title: str
    about: str


@dataclass(frozen=True)
class Chapter:
    """One folder of `chapters/`, as its chapter.toml describes it."""

    root: Path
    slug: str
    title: str
    part: int
    status: str
    tooltip: str
    builds_on: tuple[str, ...]
    in_lesson: tuple[str, ...]
    recall: tuple[str, ...]
    exercises: tuple[str, ...]
    objectives: tuple[Objective, ...]
    sources: tuple[Source, ...]

    @property
    def folder(self) -> Path:
        return self.root / "chapters" / self.slug

    @property
    def number(self) -> int:
        return int(self.slug[:2])

    @property
    def lesson(self) -> Path:
        return self.folder / "lesson.md"

    @property
    def has_lesson(self) -> bool:
        return self.status == "lesson" and self.lesson.is_file()

    @property
    def headers(self) -> list[Path]:
        return sorted((self.folder / "contact").rglob("*.hpp"))

    @property
    def figures(self) -> list[str]:
        return sorted(path.stem for path in (self.folder / "figures").glob("*.cpp"))

    @property
    def examples(self) -> list[str]:
        return sorted(path.stem for path in (self.folder / "examples").glob("*.cpp"))


def _chapter(root: Path, slug: str, said: dict[str, Any]) -> Chapter:
    if not _SLUG.fullmatch(slug):
        raise BookError(f"chapters/{slug}: a chapter's folder is two digits, '_' and a name")
    return Chapter(
        root=root,
        slug=slug,
        title=said["title"],
        part=said["part"],
        status=said["status"],
        tooltip=said["tooltip"],
        builds_on=tuple(said["builds_on"]),
        in_lesson=tuple(said["in_lesson"]),
        recall=tuple(said["recall"]),
        exercises=tuple(said["exercises"]),
        objectives=tuple(Objective(**row) for row in said["objectives"]),
        sources=tuple(Source(**row) for row in said["sources"]),
    )


class Book:
    """Everything the pages are made from, read when first asked for."""

    def __init__(self, root: Path, products: Path) -> None:
        self.root = root
        self.products = products

    @cached_property
    def registry(self) -> dict[str, Any]:
        """build/book.json, which is brought up to date first."""
        return book_json(self.root)

    @cached_property
    def chapters(self) -> dict[str, Chapter]:
        for file, problem in self.registry["problems"].items():
            if file.startswith("chapters/") and file.endswith("/chapter.toml"):
                raise BookError(problem)
        said = self.registry["chapters"]
        return {slug: _chapter(self.root, slug, said[slug]) for slug in sorted(said)}

    @cached_property
    def lectures(self) -> dict[str, Lecture]:
        """By the id that `sources` use; none if there is no list of them."""
        path = self.root / "chapters" / "lectures.toml"
        if not path.is_file():
            return {}
        table = self.table(path)
        found = {}
        for name in table.data:
            row = Table(table.need(name, dict), f"{table.where}: {name}")
            found[name] = Lecture(row.need("title", str), row.need("about", str))
        return found

    def said_in(self, kind: str, name: str, path: Path) -> dict[str, Any]:
        """What a file says, by its entry in build/book.json."""
        problem = self.registry["problems"].get(self.relative(path))
        if problem:
            raise BookError(problem)
        if name not in self.registry[kind]:
            raise BookError(f"{self.relative(path)} does not exist")
        said: dict[str, Any] = self.registry[kind][name]
        return said

    def chapter(self, slug: str, where: str) -> Chapter:
        if slug not in self.chapters:
            raise unknown("chapter", slug, self.chapters, where)
        return self.chapters[slug]

    def split(self, name: str, here: str | None, where: str) -> tuple[Chapter, str]:
        """`NAME` in the chapter `here`, or `NN_slug/NAME` from anywhere."""
        slug, slash, rest = name.partition("/")
        if slash:
            return self.chapter(slug, where), rest
        if here is None:
            raise BookError(f"'{name}' needs its chapter before it, as in 02_triangles/{name}")
        return self.chapter(here, where), name

    def relative(self, path: Path) -> str:
        return os.path.relpath(path, self.root)

    def header(self, include: str) -> Path | None:
        """The file that `#include <include>` finds in the chapters."""
        for chapter in self.chapters.values():
            path = chapter.folder / include
            if path.is_file():
                return path
        return None

    def table(self, path: Path) -> Table:
        return read_toml(path, self.relative(path))
