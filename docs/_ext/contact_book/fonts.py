"""The faces of the text and of the mathematics, served from the book itself, as woff2 alone."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

from sphinx.application import Sphinx
from sphinx.builders import _epub_base

_OTHER_FORMATS = re.compile(r',url\([^)]*\.(?:woff|ttf)\) format\("[a-z]+"\)')
_TEXT_FACES = ("400-normal", "400-italic", "600-normal")


# Sphinx 8.2 does not know it, and would leave the fonts out of an e-book.
_epub_base.MEDIA_TYPES.setdefault(".woff2", "font/woff2")


def copy_fonts(app: Sphinx) -> None:
    """Copies KaTeX's style with its fonts, and the faces that book.css names."""
    packages = Path(app.config.contact_node) / "node_modules"
    if app.builder.format != "html" or not packages.is_dir():
        return
    static = Path(app.outdir) / "_static"
    katex = packages / "katex" / "dist"
    (static / "katex" / "fonts").mkdir(parents=True, exist_ok=True)
    style = _OTHER_FORMATS.sub("", (katex / "katex.min.css").read_text(encoding="utf-8"))
    (static / "katex" / "katex.css").write_text(style, encoding="utf-8")
    for font in (katex / "fonts").glob("*.woff2"):
        shutil.copy2(font, static / "katex" / "fonts" / font.name)
    text = packages / "@fontsource" / "source-serif-4" / "files"
    (static / "fonts").mkdir(parents=True, exist_ok=True)
    for face in _TEXT_FACES:
        font = text / f"source-serif-4-latin-{face}.woff2"
        if font.is_file():
            shutil.copy2(font, static / "fonts" / font.name)
