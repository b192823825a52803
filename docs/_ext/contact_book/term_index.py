"""The book's index: terms with the titles of the pages that say something of them.

Sphinx's own would number the pages, and hold every name that the code declares; those have the
pages of the reference code and the search.
"""

from __future__ import annotations

import re
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

_DECLARED = re.compile(r"\(C\+\+ [a-z ]+\)$")
_PAGE = "genindex"

Link = tuple[str, str]
Below = list[tuple[str, list[Link]]]
Row = tuple[str, tuple[list[Link], Below, str | None]]


def only_terms(index: list[tuple[str, list[Row]]]) -> list[tuple[str, list[Row]]]:
    """Without what the code declares; a letter that has nothing left goes."""

    def named(row: Row) -> bool:
        name, (_, below, _) = row
        declared = [bool(_DECLARED.search(under)) for under, _ in below]
        return not _DECLARED.search(name) and not (declared and all(declared))

    kept = [(letter, [row for row in rows if named(row)]) for letter, rows in index]
    return [(letter, rows) for letter, rows in kept if rows]


def show_index(
    app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.document | None
) -> str | None:
    if page != _PAGE:
        return None
    context["genindexentries"] = only_terms(context["genindexentries"])
    if app.builder.name == "epub":
        return None
    uris = {app.builder.get_relative_uri(_PAGE, name): name for name in app.env.titles}

    def places(links: list[Link]) -> list[tuple[str, str, bool]]:
        found: dict[str, tuple[str, str, bool]] = {}
        for main, link in links:
            name = uris[link.partition("#")[0]]
            found.setdefault(name, (app.env.titles[name].astext(), link, bool(main)))
        return list(found.values())

    context["places"] = places
    return "index_of_terms.html"
