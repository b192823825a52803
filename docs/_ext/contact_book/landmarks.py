"""Names for the parts of the theme's pages that assistive technology lists.

Furo 2025.12 gives its two side columns no names, captions in the sidebar the role of a heading
without a level, and has the link to the top, which appears on the way up, outside all parts.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

_NAMES = {
    '<aside class="sidebar-drawer">': '<aside class="sidebar-drawer" aria-label="The book">',
    '<aside class="toc-drawer">': '<aside class="toc-drawer" aria-label="This page">',
    '<aside class="toc-drawer no-toc">': '<aside class="toc-drawer no-toc" aria-label="This page">',
}
# Not where it is within one: a page that has not changed is not written again.
_TO_TOP = re.compile(
    r'(?<!aria-label="Top">)<a href="#" class="back-to-top muted-link">.*?</a>', re.DOTALL
)


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
        named = _TO_TOP.sub(r'<nav aria-label="Top">\g<0></nav>', named)
        if named != text:
            path.write_text(named, encoding="utf-8")
