"""What the lectures get wrong: a page for each lecture, put together from the chapters' words.

`chapters/NN_slug/lectures/L20.md` holds sections (###), one an erratum. `{errata}`L20`` in a lesson
links to the chapter's part of that lecture's page.
"""

from __future__ import annotations

import re
from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx.util.docutils import SphinxRole

from contact_book.book import Book, Chapter
from contact_book.directive import open_book, source_of
from contact_book.errors import BookError, unknown

_LESSON_LINK = re.compile(r"\(\.\./(?:\.\./(?P<slug>\d\d_[a-z0-9_]+)/)?lesson\.md")
# Where a chapter's words begin in a page, for locations.py.
MARKER = "% from "


def errata_file(chapter: Chapter, lecture: str) -> Path:
    return chapter.folder / "lectures" / f"{lecture}.md"


def errata_label(chapter: Chapter, lecture: str) -> str:
    return f"errata-{lecture.lower()}-{chapter.slug}"


def faulted(book: Book) -> dict[str, list[Chapter]]:
    """The chapters that say something of a lecture, by the lecture's id, in the book's order."""
    found: dict[str, list[Chapter]] = {lecture: [] for lecture in book.lectures}
    for chapter in book.chapters.values():
        for path in sorted((chapter.folder / "lectures").glob("*")):
            if path.suffix != ".md" or path.stem not in found:
                where = book.relative(path.parent)
                raise unknown("lecture", path.name, [f"{name}.md" for name in found], where)
            found[path.stem].append(chapter)
    return {lecture: chapters for lecture, chapters in found.items() if chapters}


def _part(book: Book, chapter: Chapter, lecture: str) -> str:
    path = errata_file(chapter, lecture)
    text = path.read_text(encoding="utf-8")
    text = _LESSON_LINK.sub(lambda link: f"(../chapters/{link['slug'] or chapter.slug}.md", text)
    head = f"({errata_label(chapter, lecture)})=\n## {chapter.title}\n\n"
    lesson = f"The lesson: {{chapter}}`{chapter.slug}`.\n\n"
    return f"{head}{lesson}{MARKER}{book.relative(path)}\n{text.strip()}"


def errata_pages(book: Book) -> dict[str, str]:
    """The pages, by their place in the staged folder."""
    made = {}
    for lecture, chapters in faulted(book).items():
        said = book.lectures[lecture]
        intro = (
            f"{said.about} The book takes topics and numbers from it. This page says, chapter by "
            "chapter, where its slides are wrong or leave something open."
        )
        parts = [_part(book, chapter, lecture) for chapter in chapters]
        text = "\n\n".join([f"# {said.title}", intro, *parts])
        made[f"lectures/{lecture}.md"] = f"{text}\n"
    return made


class ErrataRole(SphinxRole):
    """`{errata}`L20`` in a lesson, or `{errata}`08_convex_hull/L20`` anywhere."""

    def link(self) -> addnodes.pending_xref:
        book = open_book(self.config)
        here = self.env.docname.rpartition("/")[2]
        chapter, lecture = book.split(
            self.text.strip(), here if here[:2].isdigit() else None, source_of(self.env.docname)
        )
        if lecture not in book.lectures:
            raise unknown("lecture", lecture, book.lectures, "chapters/lectures.toml")
        path = errata_file(chapter, lecture)
        self.env.note_dependency(str(path))
        if not path.is_file():
            raise BookError(f"{book.relative(path)} does not exist")
        title = f"{book.lectures[lecture].title} ({lecture})"
        return addnodes.pending_xref(
            "",
            nodes.inline("", title, classes=["std", "std-ref"]),
            refdomain="std",
            reftype="ref",
            reftarget=errata_label(chapter, lecture),
            refdoc=self.env.docname,
            refexplicit=True,
            refwarn=True,
        )

    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        try:
            return [self.link()], []
        except BookError as error:
            message = self.inliner.reporter.error(f"errata: {error}", line=self.lineno)
            return [self.inliner.problematic(self.rawtext, self.rawtext, message)], [message]
