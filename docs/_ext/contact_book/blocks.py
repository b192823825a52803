"""No block inside a paragraph, and no name twice on a page: as XHTML has it, and HTML too.

Breathe 4.36 puts lists, formulas and paragraphs of a comment inside one paragraph, and gives every
class's list of members the same name.
"""

from __future__ import annotations

from docutils import nodes
from sphinx.application import Sphinx

_MEMBERS = "breathe-section-title-"


def _is_block(node: nodes.Node) -> bool:
    return isinstance(node, nodes.Body) and not isinstance(node, nodes.Inline)


def _pieces(paragraph: nodes.paragraph) -> list[nodes.Node]:
    """The paragraph's own words as paragraphs, and the blocks that stood between them."""
    made: list[nodes.Node] = []
    words: list[nodes.Node] = []

    def end() -> None:
        if any(word.astext().strip() or not isinstance(word, nodes.Text) for word in words):
            made.append(nodes.paragraph("", "", *words, classes=list(paragraph["classes"])))
        words.clear()

    for child in paragraph.children:
        if _is_block(child):
            end()
            made.append(child)
        else:
            words.append(child)
    end()
    return made


def lift_blocks(app: Sphinx, doctree: nodes.document) -> None:
    # From the inside out, so that what is lifted is lifted all the way.
    for paragraph in reversed(list(doctree.findall(nodes.paragraph))):
        if any(_is_block(child) for child in paragraph.children) and paragraph.parent is not None:
            pieces = _pieces(paragraph)
            paragraph.children.clear()
            paragraph.replace_self(pieces)
    for title in doctree.findall(nodes.Element):
        names: list[str] = title.get("ids", [])
        if any(name.startswith(_MEMBERS) for name in names):
            title["ids"] = [name for name in names if not name.startswith(_MEMBERS)]


def connect(app: Sphinx) -> None:
    app.connect("doctree-read", lift_blocks)
