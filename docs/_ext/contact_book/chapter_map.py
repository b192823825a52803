"""`{chapter-map}`: a map of the chapters and their prerequisites; each box is a link.

Boxes are HTML and keep their font size at any width; only the lines behind them stretch. It needs
no script. An e-book has only the cards, which give the same information in words.
"""

from __future__ import annotations

from typing import Any

from docutils import nodes
from sphinx.writers.html5 import HTML5Translator

from contact_book.chapter import chapter_link
from contact_book.directive import BookDirective
from contact_book.html import attributes, can_run_scripts, renders, slots
from contact_book.map_layout import COLUMNS, WIDE, Band, Box, Layout, direct, lay_out, stood_on
from contact_book.nodes import component, make_component, make_slot


class ChapterMap(BookDirective):
    """The map alone; `{chapter-cards}` says what each chapter is about."""

    def build(self) -> list[nodes.Node]:
        chapters = self.book.chapters
        for chapter in chapters.values():
            self.depends(chapter.folder / "chapter.toml")
        layout = lay_out(chapters)
        links = [
            make_slot("link", [nodes.inline("", "", chapter_link(box.chapter, self.env.docname))])
            for box in layout.boxes.values()
        ]
        below = {
            slug: [chapters[earlier].title for earlier in direct(slug, chapters)]
            for slug in layout.boxes
        }
        arrows = {line.later for line in layout.lines}
        data = {"layout": layout, "below": below, "arrows": arrows, "ground": stood_on(chapters)}
        return [make_component("chapter-map", data, links)]


def _place(row: int, column: int, rows: int, columns: int) -> str:
    return f"grid-area:{row}/{column}/span {rows}/span {columns}"


def _band(band: Band) -> str:
    where = attributes(class_="band", style=_place(band.row, band.column, band.rows, band.span))
    return f"<div{where}><span>{band.name}</span></div>"


def _box(box: Box, link: str, data: dict[str, Any]) -> str:
    """A chapter, followed by its prerequisites in words for readers who cannot see the lines."""
    chapter = box.chapter
    kind = "lesson" if chapter.has_lesson else "code-only"
    notes = [] if chapter.has_lesson else ["code only"]
    notes += ["every chapter stands on it"] if chapter.slug in data["ground"] else []
    code = f'<span class="kind">{", ".join(notes)}</span>' if notes else ""
    below = data["below"][chapter.slug]
    words = f'<span class="builds-on"> builds on {", ".join(below)}</span>' if below else ""
    where = attributes(
        class_=" ".join(
            ["box", kind]
            + ["on"] * (chapter.slug in data["arrows"])
            + ["wide"] * (box.span == COLUMNS)
        ),
        style=_place(box.row, box.column, 1, box.span),
        title=chapter.tooltip or None,
    )
    number = f'<span class="number">{chapter.number:02d}</span>'
    return f"<li{where}><span>{number} {link} {code}{words}</span></li>"


def _lines(layout: Layout) -> str:
    paths = "".join(f'<path d="{line.path}"/>' for line in layout.lines)
    box = f"0 0 {COLUMNS * WIDE} {layout.height}"
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}" preserveAspectRatio="none" '
        f'aria-hidden="true" focusable="false">{paths}</svg>'
    )


@renders("chapter-map")
def chapter_map_html(translator: HTML5Translator, node: component) -> str:
    if not can_run_scripts(translator):
        return ""
    layout: Layout = node["data"]["layout"]
    links = slots(translator, node)["link"]
    boxes = "".join(
        _box(box, link, node["data"])
        for box, link in zip(layout.boxes.values(), links, strict=True)
    )
    rows = " ".join(f"{height / 10:g}rem" for height in layout.heights)
    return (
        f'<nav class="chapter-map" aria-label="Map of the chapters" style="--rows:{rows}">'
        f"{''.join(_band(band) for band in layout.bands)}{_lines(layout)}<ol>{boxes}</ol></nav>\n"
    )
