"""`{deeper} TITLE`: a box for what a first reader can skip, closed at first.

The browser opens and closes it without a script; book.js opens it where an address, a search or the
printer leads into it.
"""

from __future__ import annotations

from docutils import nodes
from sphinx.writers.html5 import HTML5Translator

from contact_book.directive import BookDirective
from contact_book.errors import BookError
from contact_book.html import attributes, can_run_scripts, renders, slots
from contact_book.nodes import component, make_component, make_slot

_TITLES = "contact-deeper-titles"


class Deeper(BookDirective):
    required_arguments = 1
    has_content = True

    def build(self) -> list[nodes.Node]:
        title = self.inline_markdown(self.arguments[0])
        words = "".join(node.astext() for node in title)
        name = nodes.make_id(f"deeper {words}")
        titles: tuple[str, ...] = self.env.temp_data.get(_TITLES) or ()
        if name in titles:
            raise BookError(f"two boxes of this page are called '{words}'")
        self.env.temp_data[_TITLES] = (*titles, name)
        if not "".join(self.content).strip():
            raise BookError(f"the box '{words}' is empty")
        box = make_component(
            "deeper",
            {},
            [make_slot("title", title), make_slot("content", self.parse_content_to_nodes())],
        )
        box["ids"].append(name)
        return [box]


@renders("deeper")
def deeper_html(translator: HTML5Translator, node: component) -> str:
    parts = slots(translator, node)
    title, content = parts["title"][0], parts["content"][0]
    own, *others = sorted(node["ids"], key=lambda name: not name.startswith("deeper-"))
    anchors = "".join(f"<span{attributes(id=name)}></span>" for name in others)
    label = f'<span class="label">Deeper</span> {title}'
    if not can_run_scripts(translator):
        return (
            f'<section class="deeper"{attributes(id=own)}>{anchors}'
            f'<p class="deeper-title">{label}</p>\n{content}</section>\n'
        )
    return (
        f'<details class="deeper"{attributes(id=own)}><summary>{anchors}{label}</summary>\n'
        f'<div class="inside">{content}</div></details>\n'
    )
