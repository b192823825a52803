"""API pages are stale when a header or the Doxygen output for it changes."""

from __future__ import annotations

from pathlib import Path

from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment

from contact_book.directive import depend, open_book, slug_of


def depend_on_headers(app: Sphinx, docname: str, source: list[str]) -> None:
    """Called when a page is read; notes what an API page is made from."""
    slug = slug_of(docname)
    if not docname.startswith("api/") or slug is None:
        return
    xml = Path(app.config.breathe_projects["contact"])
    for header in open_book(app.config).chapter(slug, docname).headers:
        depend(app.env, header)
        group = f"group__header__{header.stem.replace('_', '__')}.xml"
        depend(app.env, xml / group)


def forget_gone(
    app: Sphinx, env: BuildEnvironment, added: set[str], changed: set[str], removed: set[str]
) -> list[str]:
    """The pages that show a class that is gone from the headers; to be called before Breathe.

    Breathe asks for the age of each file of Doxygen's that a page was made from, also of one that
    is not there any more.
    """
    read = getattr(env, "breathe_file_state", {})
    gone = [file for file in read if not Path(file).is_file()]
    pages = {page for file in gone for page in read.pop(file)[1]}
    return sorted(pages - removed)
