"""The fonts of the text and of the mathematics, served with the book, as woff2 only.

A page loads only the characters that the book uses, which halves the size of the fonts. A character
that a script adds later is drawn in the next font of its style.
"""

from __future__ import annotations

import hashlib
import html
import io
import logging
import os
import re
import shutil
import string
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path

from fontTools import subset
from sphinx.application import Sphinx

_OTHER_FORMATS = re.compile(r',url\([^)]*\.(?:woff|ttf)\) format\("[a-z]+"\)')
_TEXT_FACES = ("400-normal", "400-italic", "600-normal")
_FEATURES = ["kern", "liga", "ccmp", "locl", "mark", "mkmk", "tnum"]
_ALWAYS = set(string.digits + string.ascii_letters + string.punctuation + " ")
_TAG = re.compile(r"<(/?)span\b[^>]*>|<[^>]*>")
_MATHS = '<span class="katex-html"'

logging.getLogger("fontTools").setLevel(logging.WARNING)


def faces(packages: Path) -> dict[str, Path]:
    """Every face by its place in the site's static files."""
    katex = sorted((packages / "katex" / "dist" / "fonts").glob("*.woff2"))
    text = packages / "@fontsource" / "source-serif-4" / "files"
    named = [text / f"source-serif-4-latin-{face}.woff2" for face in _TEXT_FACES]
    found = {f"katex/fonts/{font.name}": font for font in katex}
    return found | {f"fonts/{font.name}": font for font in named if font.is_file()}


def copy_fonts(app: Sphinx) -> None:
    """Copies KaTeX's style, and the faces whole; `subset_fonts` makes those of the site smaller."""
    packages = Path(app.config.contact_node) / "node_modules"
    if app.builder.format != "html" or app.builder.name == "epub" or not packages.is_dir():
        return
    static = Path(app.outdir) / "_static"
    katex = (packages / "katex" / "dist" / "katex.min.css").read_text(encoding="utf-8")
    (static / "katex" / "fonts").mkdir(parents=True, exist_ok=True)
    (static / "fonts").mkdir(parents=True, exist_ok=True)
    (static / "katex" / "katex.css").write_text(_OTHER_FORMATS.sub("", katex), encoding="utf-8")
    for name, font in faces(packages).items():
        shutil.copyfile(font, static / name)


def plain(text: str) -> str:
    """A page, or data of one, with the HTML inside its JSON as HTML too."""
    return text.replace("\\u003c", "<").replace('\\"', '"')


def formulas(text: str) -> Iterator[str]:
    """The letters of each formula as KaTeX drew it, without the tags."""
    start = text.find(_MATHS)
    while start >= 0:
        depth, end = 0, start
        for tag in _TAG.finditer(text, start):
            yield text[end : tag.start()]
            end = tag.end()
            depth += {"": 1, "/": -1}.get(tag[1], 0)
            if depth == 0:
                break
        start = text.find(_MATHS, end)


def characters(site: Path) -> tuple[set[str], set[str]]:
    """What the book's pages and exercises are written in: all of it, and the formulas alone."""
    # The pages to embed (embeds.py) have no characters of their own.
    left_out = {"_static", "embed"}
    files = [
        page for page in site.rglob("*.html") if page.relative_to(site).parts[0] not in left_out
    ]
    files += (site / "_static" / "contact" / "exercises").rglob("*.json")
    words, maths = set(_ALWAYS), set(string.digits)
    for file in files:
        text = plain(file.read_text(encoding="utf-8"))
        words |= set(html.unescape(text))
        maths |= set(html.unescape("".join(formulas(text))))
    return words, maths


def shrink(font: bytes, wanted: set[str]) -> bytes:
    """The face with these characters alone; the same bytes each time."""
    options = subset.Options(flavor="woff2", hinting=False, layout_features=_FEATURES)
    face = subset.load_font(io.BytesIO(font), options)
    there = set(face.getBestCmap())
    # A face without a single letter is refused by browsers as broken.
    letters = there & set(map(ord, wanted)) or {min(there)}
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=sorted(letters))
    subsetter.subset(face)
    made = io.BytesIO()
    subset.save_font(face, made, options)
    return made.getvalue()


def kept(cache: Path, font: bytes, wanted: set[str]) -> bytes:
    """As `shrink`, but made once and kept by what it is made from."""
    recipe = [version("fonttools"), version("brotli"), *_FEATURES, "".join(sorted(wanted))]
    key = hashlib.sha256(font + "\0".join(recipe).encode()).hexdigest()
    file = cache / f"{key}.woff2"
    if not file.is_file():
        cache.mkdir(parents=True, exist_ok=True)
        # Builds of several books may share the folder.
        part = file.with_name(f"{key}.{os.getpid()}.part")
        part.write_bytes(shrink(font, wanted))
        part.replace(file)
    return file.read_bytes()


def subset_fonts(app: Sphinx, error: Exception | None) -> None:
    """Puts the small faces in the place of the whole ones, when all pages are written."""
    packages = Path(app.config.contact_node) / "node_modules"
    if error is not None or app.builder.name != "html" or not packages.is_dir():
        return
    words, maths = characters(Path(app.outdir))
    cache = Path(app.config.contact_fonts)
    for name, font in faces(packages).items():
        wanted = maths if name.startswith("katex/") else words
        face = kept(cache, font.read_bytes(), wanted)
        (Path(app.outdir) / "_static" / name).write_bytes(face)
