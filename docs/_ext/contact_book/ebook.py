"""The book as one EPUB file: its pages without scripts, for old and new e-book readers.

Sphinx's builder writes it. This file adds: formulas as MathML only, a style sheet that old readers
understand instead of the site's, and the properties of each page in the manifest.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.builders.epub3 import Epub3Builder

STYLES = ("pygments.css", "ebook.css")
# Pages of the site that say nothing without a script.
LEFT_OUT = ("kitchen_sink",)

_ITEM = re.compile(r'<item id="[^"]*" href="(?P<href>[^"]*\.xhtml)"(?P<rest>[^>]*?) ?/>')
_CONTENT = {"mathml": "<math", "svg": "<svg"}
_MATHML = re.compile(r"<math\b.*?</math>", re.S)


def mathml(html: str) -> str:
    """The MathML in KaTeX's output, without the HTML for browsers."""
    match = _MATHML.search(html)
    return match[0] if match else html


class EBook(Epub3Builder):
    """Sphinx's `epub`, with what EPUB asks a manifest to say of pages."""

    def build_content(self) -> None:
        super().build_content()
        listing = Path(self.outdir) / "content.opf"
        text = listing.read_text(encoding="utf-8")
        listing.write_text(_ITEM.sub(self._described, text), encoding="utf-8")

    def _described(self, item: re.Match[str]) -> str:
        if "properties=" in item[0]:
            return item[0]
        page = (Path(self.outdir) / item["href"]).read_text(encoding="utf-8")
        found = [name for name, mark in _CONTENT.items() if mark in page]
        return item[0].replace("/>", f'properties="{" ".join(found)}"/>') if found else item[0]


def is_ebook(app: Sphinx) -> bool:
    return bool(app.builder.name == EBook.name)


def leave_out(app: Sphinx) -> None:
    """Whatever the site's static files are, an e-book has its own style and the pictures."""
    if not is_ebook(app):
        return
    static = [
        f"_static/{file.relative_to(root).as_posix()}"
        for root in (Path(app.confdir) / name for name in app.config.html_static_path)
        for file in root.rglob("*")
        if file.name not in STYLES
    ]
    theme = ["basic.css", "epub.css", "file.png", "minus.png", "plus.png"]
    copying = ["copybutton.css", "check-solid.svg", "copy-button.svg"]
    pages = [f"{page}.xhtml" for page in LEFT_OUT]
    app.config.epub_exclude_files = [
        *pages,
        *static,
        *(f"_static/{name}" for name in (*theme, *copying)),
    ]


def drop_raw_html(app: Sphinx, doctree: nodes.document, docname: str) -> None:
    """Tags that an author wrote by hand are for browsers, and need not be XML."""
    if is_ebook(app):
        for raw in list(doctree.findall(nodes.raw)):
            raw.parent.remove(raw)


def own_styles(
    app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.document | None
) -> None:
    """Called last, when every extension has named its files."""
    if not is_ebook(app):
        return
    context["css_files"] = [
        file for file in context["css_files"] if Path(str(file.filename)).name in STYLES
    ]
    context["script_files"] = []


def connect(app: Sphinx) -> None:
    app.add_builder(EBook, override=True)
    app.connect("builder-inited", leave_out)
    app.connect("doctree-resolved", drop_raw_html)
    app.connect("html-page-context", own_styles, priority=950)
