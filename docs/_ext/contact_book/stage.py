"""Copies the input of Sphinx into one folder: the book's pages, the lessons, an API page for each
header."""

from __future__ import annotations

import re
from pathlib import Path

from contact_book.answers import answers_page
from contact_book.book import Book, Chapter
from contact_book.errata import errata_pages

_LESSON_LINK = re.compile(r"\(\.\./(\d\d_[a-z0-9_]+)/lesson\.md")
_CONCEPT = re.compile(r"^template <[^\n]*>\nconcept (?P<name>\w+) =.*?;\n(?!\s)", re.M | re.S)
_DECLARES = re.compile(r"^namespace contact", re.M)
_ABOUT = re.compile(r"\A/// @file\n(?P<about>(?:///[^\n]*\n)+)")


def lesson_page(text: str) -> str:
    """The lesson with links between lessons turned to the pages; no line moves."""
    return _LESSON_LINK.sub(r"(\1.md", text)


def header_section(chapter: Chapter, header: Path, *, full: bool) -> str:
    """One header's part of the API page. Breathe drops a concept's body, so it is shown as code."""
    name = header.relative_to(chapter.folder).as_posix()
    text = header.read_text(encoding="utf-8")
    label = header.name.replace("_", "__").replace(".", "_8")
    parts = [f"({label})=\n## `{name}`"]
    about = _ABOUT.match(text)
    if about:
        parts.append(re.sub(r"^/// ?", "", about["about"], flags=re.M).strip())
    if not full:
        return "\n\n".join(parts)
    for match in _CONCEPT.finditer(text):
        parts.append(f":::{{doxygenconcept}} contact::{match['name']}\n:::")
        parts.append(f"```cpp\n{match[0]}```")
    if _DECLARES.search(text):
        parts.append(f":::{{doxygennamespace}} header_{header.stem}\n:content-only:\n:::")
    return "\n\n".join(parts)


def api_page(chapter: Chapter, *, full: bool) -> str:
    """The chapter's headers; without `full`, only what each is about, and no Doxygen."""
    parts = [f"# {chapter.title}: the code"]
    if chapter.has_lesson:
        parts.append(f"What it is for is told in {{chapter}}`{chapter.slug}`.")
    parts += [header_section(chapter, header, full=full) for header in chapter.headers]
    return "\n\n".join(parts) + "\n"


def api_index(chapters: list[Chapter]) -> str:
    intro = (
        "# Reference code\n\n"
        "What the tests check, the figures run and the ladders time. "
        "Each chapter's headers build only on those of the chapters before it.\n\n"
        "```cpp\n#include <contact/plane.hpp>\n```\n\n"
        if chapters
        else "# Reference code\n\nThere is none yet.\n\n"
    )
    pages = "\n".join(chapter.slug for chapter in chapters)
    return f"{intro}:::{{toctree}}\n:maxdepth: 1\n\n{pages}\n:::\n"


def pages(book: Book, docs: Path, *, api: bool) -> dict[str, str]:
    """Every source file by its place in the staged folder."""
    # A folder of pages has an index of its own.
    folders = [docs, *(path.parent for path in docs.glob("*/index.md"))]
    files = sorted(path for folder in folders for path in folder.glob("*.md"))
    made = {path.relative_to(docs).as_posix(): path.read_text(encoding="utf-8") for path in files}
    for chapter in book.chapters.values():
        if chapter.has_lesson:
            text = chapter.lesson.read_text(encoding="utf-8")
            made[f"chapters/{chapter.slug}.md"] = lesson_page(text)
    coded = [chapter for chapter in book.chapters.values() if chapter.headers]
    made |= {f"api/{chapter.slug}.md": api_page(chapter, full=api) for chapter in coded}
    made["api/index.md"] = api_index(coded)
    return made | answers_page(book) | errata_pages(book)


def stage(book: Book, docs: Path, target: Path, *, api: bool = True) -> list[str]:
    """Writes what changed, removes what is gone, and says which files it wrote."""
    wanted = pages(book, docs, api=api)
    written = []
    for name, text in wanted.items():
        path = target / name
        if path.is_file() and path.read_text(encoding="utf-8") == text:
            continue
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        written.append(name)
    for path in target.rglob("*.md"):
        if path.relative_to(target).as_posix() not in wanted:
            path.unlink()
    return written
