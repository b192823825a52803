"""The cards of the chapters and the table of contents, generated from the existing chapters."""

from __future__ import annotations

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.writers.html5 import HTML5Translator

from contact_book.book import PARTS, Chapter
from contact_book.chapter import chapter_link, joined, minutes
from contact_book.directive import BookDirective, other_dependencies_changed
from contact_book.errata import faulted
from contact_book.exercises import lesson_time
from contact_book.html import can_run_scripts, renders
from contact_book.nodes import component, make_component
from contact_book.run import EBOOK


def _parts(chapters: list[Chapter]) -> list[tuple[str, list[Chapter]]]:
    found = [(name, [c for c in chapters if c.part == part]) for part, name in enumerate(PARTS)]
    return [(name, group) for name, group in found if group]


class ChapterCards(BookDirective):
    """What each chapter is about."""

    def build(self) -> list[nodes.Node]:
        box = nodes.container(classes=["chapter-cards"])
        for name, chapters in _parts(list(self.book.chapters.values())):
            box += nodes.paragraph("", name, classes=["part"])
            cards = nodes.bullet_list("", bullet="-", classes=["cards"])
            cards += [self.card(chapter) for chapter in chapters]
            box += cards
        return [box]

    def card(self, chapter: Chapter) -> nodes.list_item:
        self.depends(chapter.folder / "chapter.toml")
        kind = "lesson" if chapter.has_lesson else "code-only"
        item = nodes.list_item(classes=["card", kind])
        title = nodes.paragraph(classes=["name"])
        title += nodes.inline("", f"{chapter.number:02d}", classes=["number"])
        title += nodes.Text(" ")
        title += chapter_link(chapter, self.env.docname)
        item += title
        if chapter.tooltip:
            item += nodes.paragraph("", "", *self.inline_markdown(chapter.tooltip))
        facts = nodes.paragraph(classes=["facts"])
        if chapter.has_lesson:
            self.depends(chapter.lesson)
            time = lesson_time(self.book, chapter)
            words = minutes(time.lesson)
            if time.exercises:
                words += f", and {time.exercises} of exercises"
            facts += nodes.inline("", words)
        if not chapter.has_lesson:
            facts += nodes.inline("", "code only")
        if chapter.builds_on:
            earlier = [self.book.chapter(slug, self.source) for slug in chapter.builds_on]
            titles: list[nodes.Node] = [nodes.Text(other.title) for other in earlier]
            facts += nodes.inline("", "", nodes.Text("builds on "), *joined(titles))
        item += facts
        return item


class EBookLink(BookDirective):
    """Where the site has the book as one file; it is made after the pages."""

    def build(self) -> list[nodes.Node]:
        return [make_component("e-book-link", {})]


@renders("e-book-link")
def e_book_link_html(translator: HTML5Translator, node: component) -> str:
    if not can_run_scripts(translator):
        return ""
    builder = translator.builder
    if not builder.config.contact_ebook:
        return "<p>It is not built here: <code>./contact serve --ebook</code> builds it.</p>\n"
    root = "../" * builder.current_docname.count("/")
    return f'<p><a href="{root}{EBOOK}" download="">Contact Hours as an EPUB file</a></p>\n'


class BookContents(BookDirective):
    """The hidden tables of contents behind the sidebar, one for each part, and one for the code."""

    def build(self) -> list[nodes.Node]:
        lessons = [chapter for chapter in self.book.chapters.values() if chapter.has_lesson]
        blocks = [
            self.toctree(name, [f"chapters/{chapter.slug}" for chapter in group])
            for name, group in _parts(lessons)
        ]
        lectures = [f"lectures/{lecture}" for lecture in faulted(self.book)]
        if lectures:
            blocks.append(self.toctree("What the lectures get wrong", lectures))
        blocks.append(self.toctree("Reference code", ["api/index"]))
        return self.markdown("\n\n".join(blocks))

    def toctree(self, caption: str, pages: list[str]) -> str:
        lines = [":::{toctree}", ":hidden:", f":caption: {caption}", "", *pages, ":::"]
        return "\n".join(lines)


def read_again(
    app: Sphinx, env: BuildEnvironment, added: object, changed: object, removed: object
) -> list[str]:
    """The home page shows which chapters there are; other pages may lack what is built by now."""
    incomplete = [name for name, data in env.metadata.items() if "contact-incomplete" in data]
    changed_beside = [name for name in env.metadata if other_dependencies_changed(env, name)]
    return ["index", *incomplete, *changed_beside]
