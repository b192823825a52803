"""What stands at the head and foot of every lesson, all of it from chapter.toml."""

from __future__ import annotations

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxRole

from contact_book.book import Chapter
from contact_book.directive import BookDirective, open_book, slug_of, source_of
from contact_book.errors import BookError
from contact_book.exercises import lesson_time

_PLACED = "contact-objectives"


def page_link(docname: str, text: str, here: str) -> addnodes.pending_xref:
    """A link to another page of the book, checked when it is resolved."""
    return addnodes.pending_xref(
        "",
        nodes.inline("", text, classes=["doc"]),
        refdomain="std",
        reftype="doc",
        reftarget=f"/{docname}",
        refdoc=here,
        refexplicit=True,
        refwarn=True,
    )


def chapter_link(chapter: Chapter, here: str) -> nodes.Node:
    """A link to the lesson, to the code alone where there is no lesson, or just the title."""
    if chapter.has_lesson:
        return page_link(f"chapters/{chapter.slug}", chapter.title, here)
    if chapter.headers:
        return page_link(f"api/{chapter.slug}", chapter.title, here)
    return nodes.inline("", chapter.title)


def joined(items: list[nodes.Node]) -> list[nodes.Node]:
    """The items with commas between them."""
    made: list[nodes.Node] = []
    for index, item in enumerate(items):
        if index:
            made.append(nodes.Text(", "))
        made.append(item)
    return made


def minutes(count: int) -> str:
    return f"{count} minute{'' if count == 1 else 's'}"


class ChapterDirective(BookDirective):
    """A directive about the chapter it stands in."""

    optional_arguments = 1

    @property
    def chapter(self) -> Chapter:
        slug = self.arguments[0].strip() if self.arguments else self.here
        if slug is None:
            raise BookError("needs a chapter here, as in {objectives} 02_triangles")
        chapter = self.book.chapter(slug, self.source)
        self.depends(chapter.folder / "chapter.toml")
        return chapter

    def objectives(self, chapter: Chapter) -> nodes.Element:
        box = nodes.container(classes=["objectives"])
        box += nodes.paragraph("", "After this chapter you can", classes=["lead"])
        items = nodes.bullet_list("", bullet="-")
        for objective in chapter.objectives:
            item = nodes.list_item("", ids=[f"objective-{objective.id}"])
            item += nodes.paragraph("", "", *self.inline_markdown(objective.text))
            items += item
        box += items
        return box


class Objectives(ChapterDirective):
    def build(self) -> list[nodes.Node]:
        chapter = self.chapter
        if not chapter.objectives:
            raise BookError(f"chapters/{chapter.slug}/chapter.toml has no objectives")
        self.env.metadata[self.env.docname][_PLACED] = "yes"
        return [self.objectives(chapter)]


class ChapterHead(ChapterDirective):
    """Added to every lesson by `append_frame`, then moved to its place under the title."""

    def times(self) -> list[str]:
        time = lesson_time(self.book, self.chapter)
        words = f"About {minutes(time.lesson)}"
        if time.exercises:
            words += f", and {minutes(time.exercises)} of exercises"
        beside = [(time.further, "further practice"), (time.deeper, "Deeper boxes")]
        more = [f"{minutes(count)} of {what}" for count, what in beside if count]
        return [words, *([f"Optional: {', '.join(more)}"] if more else [])]

    def build(self) -> list[nodes.Node]:
        chapter = self.chapter
        head = nodes.container(classes=["chapter-head"])
        if chapter.tooltip:
            words = self.inline_markdown(chapter.tooltip)
            head += nodes.paragraph("", "", *words, classes=["tooltip"])
        facts = nodes.paragraph(classes=["facts"])
        self.depends(chapter.lesson)
        facts += [nodes.inline("", words) for words in self.times()]
        if chapter.builds_on:
            earlier = [self.book.chapter(slug, self.source) for slug in chapter.builds_on]
            links = joined([chapter_link(item, self.env.docname) for item in earlier])
            facts += nodes.inline("", "", nodes.Text("Builds on "), *links)
        if chapter.headers:
            link = page_link(f"api/{chapter.slug}", "Reference code", self.env.docname)
            facts += nodes.inline("", "", link)
        head += facts
        if chapter.objectives and _PLACED not in self.env.metadata[self.env.docname]:
            head += self.objectives(chapter)
        return [head]


class ChapterFoot(ChapterDirective):
    """Where the chapter's matter comes from."""

    def build(self) -> list[nodes.Node]:
        chapter = self.chapter
        if not chapter.sources:
            return []
        foot = nodes.container(classes=["chapter-foot"])
        foot += nodes.paragraph("", "Sources", classes=["lead"])
        items = nodes.bullet_list("", bullet="-")
        for source in chapter.sources:
            words = [nodes.strong("", source.lecture), nodes.Text(f": {source.topic}")]
            items += nodes.list_item("", nodes.paragraph("", "", *words))
        foot += items
        return [foot]


class ChapterRole(SphinxRole):
    """`{chapter}`01_planes`` links a chapter by its folder's name."""

    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        book = open_book(self.config)
        try:
            chapter = book.chapter(self.text.strip(), source_of(self.env.docname))
        except BookError as error:
            message = self.inliner.reporter.error(str(error), line=self.lineno)
            return [nodes.problematic(self.rawtext, self.rawtext)], [message]
        return [chapter_link(chapter, self.env.docname)], []


def append_frame(app: Sphinx, docname: str, source: list[str]) -> None:
    """Adds head and foot at the end of a lesson, where they move none of its line numbers."""
    if docname.startswith("chapters/") and slug_of(docname):
        source[0] += "\n\n:::{chapter-foot}\n:::\n\n:::{chapter-head}\n:::\n"


def place_head(app: Sphinx, doctree: nodes.document) -> None:
    """Moves the head from the end of the lesson to just under its title."""
    for head in list(doctree.findall(nodes.container)):
        if "chapter-head" not in head["classes"]:
            continue
        first = next(iter(doctree.findall(nodes.section)), None)
        if first is None or head.parent is None:
            return
        head.parent.remove(head)
        first.insert(1, head)
        for foot in list(doctree.findall(nodes.container)):
            if "chapter-foot" in foot["classes"] and foot.parent is not None:
                foot.parent.remove(foot)
                first += foot
        return
