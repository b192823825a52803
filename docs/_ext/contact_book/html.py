"""HTML of components: a custom element around a fallback that works without it."""

from __future__ import annotations

import json
from collections.abc import Callable
from html import escape

from docutils import nodes
from sphinx.util.docutils import SphinxTranslator
from sphinx.writers.html5 import HTML5Translator

from contact_book.nodes import component, slot

Renderer = Callable[[HTML5Translator, component], str]
RENDERERS: dict[str, Renderer] = {}
# The kinds that write their ids themselves.
ANCHORED = {"deeper"}


def renders(kind: str) -> Callable[[Renderer], Renderer]:
    """Registers the function that makes the HTML of components of this kind."""

    def register(function: Renderer) -> Renderer:
        RENDERERS[kind] = function
        return function

    return register


def render(translator: HTML5Translator, node: nodes.Element) -> str:
    """The HTML of a node's children, made by the translator's own visitors."""
    start = len(translator.body)
    for child in node.children:
        child.walkabout(translator)
    html = "".join(translator.body[start:])
    del translator.body[start:]
    return html.strip()


def slots(translator: HTML5Translator, node: component) -> dict[str, list[str]]:
    """The rendered slots of a component, by name, in order."""
    found: dict[str, list[str]] = {}
    for child in node.children:
        if isinstance(child, slot):
            found.setdefault(child["name"], []).append(render(translator, child))
    return found


def attributes(**values: str | None) -> str:
    """HTML attributes, escaped, with a leading space; None is left out."""
    pairs = [(name, value) for name, value in values.items() if value is not None]
    return "".join(f' {name.rstrip("_")}="{escape(value)}"' for name, value in pairs)


def json_script(data: object) -> str:
    """JSON inside HTML that no `</script>` in the data can end."""
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    safe = text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")
    return f'<script type="application/json">{safe}</script>'


def base_path(translator: HTML5Translator) -> str:
    """The way from this page to the built components."""
    docname = translator.builder.current_docname
    return "../" * docname.count("/") + "_static/contact/"


def embed_address(translator: HTML5Translator, kind: str, ref: str) -> str | None:
    """Where a lesson's figure, exercise or question stands alone (embeds.py); other pages: None."""
    docname = translator.builder.current_docname
    if not can_run_scripts(translator) or not docname.startswith("chapters/"):
        return None
    chapter, name = ref.split("/")
    return "../" * docname.count("/") + f"embed/{chapter}/{kind}/{name}.html"


def embed_link(address: str | None, kind: str) -> str:
    """The quiet link to that page; nothing where there is no such page."""
    about = f"This {kind} alone, to put into a page of yours"
    where = attributes(class_="embed-link", href=address, title=about)
    return f"<a{where}>Embed</a>" if address else ""


def can_run_scripts(translator: HTML5Translator) -> bool:
    """An e-book gets the fallback alone."""
    return translator.builder.name != "epub"


def visit_component(translator: HTML5Translator, node: component) -> None:
    if node["kind"] not in ANCHORED:
        # What an author's `(name)=` before it gave it.
        translator.body += [f"<span{attributes(id=name)}></span>" for name in node["ids"]]
    translator.body.append(RENDERERS[node["kind"]](translator, node))
    raise nodes.SkipNode


def visit_through(translator: SphinxTranslator, node: nodes.Element) -> None:
    """In other formats a component is its content."""


def depart_through(translator: SphinxTranslator, node: nodes.Element) -> None:
    """Nothing to close."""
