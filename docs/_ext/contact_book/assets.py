"""Copies the built components to the pages, and adds their script to the pages that need it."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

from contact_book.your_work import PAGE as YOUR_WORK

SCRIPT = "contact/contact.js"
STYLE = "contact/contact.css"
WORK_SCRIPT = "contact/contact-work.js"
WORK_STYLE = "work.css"


def sync(source: Path, target: Path, pattern: str = "*") -> int:
    """Makes `target` a copy of `source`, touching only what differs; how many files it wrote.

    Its folder of exercises is not ours (exercise_data.py).
    """
    written = 0
    wanted: set[Path] = set()
    for path in sorted(source.rglob(pattern)):
        copy = target / path.relative_to(source)
        if path.is_dir():
            continue
        wanted.add(copy)
        new, old = path.stat(), copy.stat() if copy.is_file() else None
        if old and (old.st_size, old.st_mtime_ns) == (new.st_size, new.st_mtime_ns):
            continue
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(path, copy)
        written += 1
    for path in sorted(target.rglob("*")):
        ours = "exercises" not in path.relative_to(target).parts
        if ours and path.is_file() and path not in wanted:
            path.unlink()
    return written


def copy_components(app: Sphinx) -> None:
    """Copies build/web into the pages' static files; an e-book takes the pictures alone."""
    web = Path(app.config.contact_web)
    if app.builder.format == "html" and web.is_dir():
        pattern = "*.svg" if app.builder.name == "epub" else "*"
        sync(web, Path(app.outdir) / "_static" / "contact", pattern)


def add_script(
    app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.document | None
) -> None:
    """The script is a module, so it is deferred; pages without components do not load it."""
    if doctree is None or app.builder.name == "epub":
        return
    about = app.env.metadata.get(page, {})
    web = Path(app.config.contact_web)
    if "contact-components" in about:
        if (web / "contact.css").is_file():
            app.add_css_file(STYLE)
        if (web / "contact.js").is_file():
            app.add_js_file(SCRIPT, type="module")
    if YOUR_WORK in about:
        app.add_css_file(WORK_STYLE)
        if (web / "contact-work.js").is_file():
            app.add_js_file(WORK_SCRIPT, type="module")
