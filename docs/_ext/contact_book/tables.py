"""Tables made from data."""

from __future__ import annotations

from collections.abc import Sequence

from docutils import nodes
from sphinx.writers.html5 import HTML5Translator

from contact_book.html import attributes, renders, slots
from contact_book.nodes import component, make_component, make_slot

Cell = nodes.Node | Sequence[nodes.Node]


def _row(cells: Sequence[Cell]) -> nodes.row:
    row = nodes.row()
    for cell in cells:
        content = [cell] if isinstance(cell, nodes.Node) else list(cell)
        row += nodes.entry("", nodes.paragraph("", "", *content))
    return row


def table(
    heads: Sequence[str], rows: Sequence[Sequence[Cell]], title: str, classes: Sequence[str]
) -> nodes.table:
    """A table with a caption and a head row."""
    made = nodes.table("", nodes.title("", title), classes=list(classes))
    group = nodes.tgroup(cols=len(heads))
    group += [nodes.colspec(colwidth=1) for _ in heads]
    head = nodes.thead("", _row([nodes.Text(text) for text in heads]))
    body = nodes.tbody("", *[_row(row) for row in rows])
    group += [head, body]
    made += group
    return made


def scrolled(content: nodes.table, label: str) -> component:
    """A long table in a box that scrolls on screen and is whole on paper."""
    return make_component("wide", {"label": label}, [make_slot("table", [content])])


@renders("wide")
def wide_html(translator: HTML5Translator, node: component) -> str:
    """The box can be reached and scrolled from the keyboard."""
    role = attributes(
        class_="wide", role="region", tabindex="0", **{"aria-label": node["data"]["label"]}
    )
    return f"<div{role}>{slots(translator, node)['table'][0]}</div>\n"
