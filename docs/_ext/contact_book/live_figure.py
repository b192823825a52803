"""`{live-figure} NAME`: a picture that the page replaces by the figure itself."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.writers.html5 import HTML5Translator

from contact_book.directive import BookDirective
from contact_book.errors import unknown
from contact_book.html import (
    attributes,
    base_path,
    can_run_scripts,
    embed_address,
    embed_link,
    renders,
    slots,
)
from contact_book.nodes import component, make_component, make_slot

_VIEW_BOX = re.compile(r"viewBox=\"\s*\S+\s+\S+\s+(?P<width>[\d.]+)\s+(?P<height>[\d.]+)\s*\"")


def size_of(svg: Path) -> tuple[str, str] | None:
    """The drawing's width and height, so that the page does not jump when it arrives."""
    match = _VIEW_BOX.search(svg.read_text(encoding="utf-8")[:4000])
    return (match["width"], match["height"]) if match else None


class LiveFigure(BookDirective):
    required_arguments = 1
    has_content = True

    def build(self) -> list[nodes.Node]:
        chapter, name = self.book.split(self.arguments[0].strip(), self.here, self.source)
        if name not in chapter.figures:
            raise unknown("figure", name, chapter.figures, f"chapters/{chapter.slug}/figures")
        folder = Path(self.config.contact_web) / "figures" / chapter.slug
        picture, facts = folder / f"{name}.svg", folder / f"{name}.json"
        self.depends(picture, facts)
        self.needs_script()
        data: dict[str, Any] = {"name": f"{chapter.slug}/{name}", "describe": "", "size": None}
        data["picture"] = picture.is_file()
        if picture.is_file():
            data["size"] = size_of(picture)
            if facts.is_file():
                data["describe"] = json.loads(facts.read_text(encoding="utf-8"))["describe"]
        else:
            self.missing_figure(f"the picture of figure {data['name']} is not built: {picture}")
        caption: list[nodes.Node] = []
        if self.content:
            # A link must stand in an element of text.
            caption = [nodes.inline("", "", *self.inline_markdown("\n".join(self.content)))]
        return [make_component("live-figure", data, [make_slot("caption", caption)])]


def figure_id(translator: HTML5Translator, name: str) -> str | None:
    """The name of the figure's position in its page; None where the page has shown it already."""
    seen: set[str] = translator.__dict__.setdefault("contact_figures", set())
    if name in seen:
        return None
    seen.add(name)
    return f"figure-{name.split('/')[1].replace('_', '-')}"


@renders("live-figure")
def live_figure_html(translator: HTML5Translator, node: component) -> str:
    data = node["data"]
    caption = "".join(slots(translator, node)["caption"])
    base = base_path(translator)
    if data["picture"]:
        width, height = data["size"] or (None, None)
        source = f"{base}figures/{data['name']}.svg"
        inner = f"<img{attributes(src=source, alt=data['describe'], width=width, height=height)}/>"
    else:
        inner = '<p class="not-built">This figure is still being built.</p>'
    if can_run_scripts(translator):
        inner = (
            f"<contact-figure{attributes(name=data['name'], base=base)}>{inner}</contact-figure>"
        )
    alone = embed_link(embed_address(translator, "figure", data["name"]), "figure")
    words = f"<figcaption>{caption}{alone}</figcaption>" if caption or alone else ""
    where = attributes(id=figure_id(translator, data["name"]))
    return f'<figure class="live"{where}>{inner}{words}</figure>\n'
