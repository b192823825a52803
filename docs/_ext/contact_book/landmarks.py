"""Names for the parts of the theme's pages that assistive technology lists.

Furo 2025.12 gives its two side columns no names, and captions in the sidebar the role of a heading
without a level.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

_NAMES = {
    '<aside class="sidebar-drawer">': '<aside class="sidebar-drawer" aria-label="The book">',
    '<aside class="toc-drawer">': '<aside class="toc-drawer" aria-label="This page">',
    '<aside class="toc-drawer no-toc">': '<aside class="toc-drawer no-toc" aria-label="This page">',
}


def plain_captions(
    app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.document | None
) -> None:
    """Captions in the sidebar are labels of lists, not headings of the page."""
    tree = context.get("furo_navigation_tree")
    if isinstance(tree, str):
        context["furo_navigation_tree"] = tree.replace(' role="heading"', "")


def name_columns(app: Sphinx, error: Exception | None) -> None:
    """Writes the names into the built pages."""
    if error is not None or app.builder.name != "html":
        return
    for path in Path(app.outdir).rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        named = text
        for old, new in _NAMES.items():
            named = named.replace(old, new)
        if named != text:
            path.write_text(named, encoding="utf-8")
