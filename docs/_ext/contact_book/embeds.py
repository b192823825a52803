"""Pages to embed: each figure, exercise and question of a lesson alone, for pages of other sites.

They are cut out of the built lessons, so there is one renderer, and a page that an earlier build
wrote has them too. `embed/NN_slug/KIND/NAME.html` takes the lesson's address as its base: all that
is relative in a component, in its data too, means what it means in the lesson.
"""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from html import escape, unescape
from pathlib import Path

from sphinx.application import Sphinx

from contact_book.directive import open_book
from contact_book.html import attributes

FOLDER = "embed"
# What these pages share, and the script for the page around them.
SHARED = Path(__file__).parents[2] / "_embed"
_UP = "../../../"

_FIGURE = re.compile(
    r'<figure class="live"[^>]*><contact-figure name="(?P<ref>[^"]+)".*?</figure>', re.S
)
_EXERCISE = re.compile(
    r'<section class="exercise"[^>]*>(?:(?!<section).)*?<contact-exercise name="(?P<ref>[^"]+)"'
    r".*?</section>",
    re.S,
)
_QUESTION = re.compile(
    r'<contact-question [^>]*><script type="application/json">(?P<data>.*?)</script>'
    r".*?</contact-question>",
    re.S,
)
_ID = re.compile(r'<[^>]*? id="([^"]+)"')
_HEADING = re.compile(r"<h\d>(.*?)<a class=\"headerlink\"", re.S)
_TIE = re.compile(r'<contact-exercise [^>]*?\bmine="([^"]*)"')
_INPUTS = re.compile(r'<contact-exercise [^>]*?\binputs="([^"]*)"')
_STYLE = re.compile(r'<link rel="stylesheet"[^>]*>|<style>.*?</style>', re.S)
_SCRIPT = re.compile(r'<script[^>]* src="[^"]*/(?:contact/contact|book)\.js[^>]*></script>')


@dataclass(frozen=True)
class Piece:
    """What one page shows."""

    kind: str
    #: NN_slug/NAME
    ref: str
    #: The lesson it is cut out of, NN_slug.
    lesson: str
    #: Where it is in the lesson; empty for a figure that the page shows a second time.
    anchor: str
    html: str
    #: The figures that it works with, by name.
    uses: tuple[str, ...]
    #: Of an exercise, as its heading says it.
    title: str = ""

    @property
    def path(self) -> str:
        return path_of(self.kind, self.ref)


def path_of(kind: str, ref: str) -> str:
    """The page of NN_slug/NAME in the site."""
    chapter, name = ref.split("/")
    return f"{FOLDER}/{chapter}/{kind}/{name}.html"


def title_of(piece: Piece, web: Path) -> str:
    """What the page is called; a figure as its drawing is, once that is built."""
    facts = web / "figures" / f"{piece.ref}.json"
    if piece.kind == "figure" and facts.is_file():
        return f"Figure: {json.loads(facts.read_text(encoding='utf-8'))['title']}"
    return piece.title or f"A {piece.kind}"


def _anchor(html: str) -> str:
    """The id of the outermost element."""
    found = _ID.match(html)
    return found[1] if found else ""


def _exercise_figures(html: str) -> tuple[str, ...]:
    tie, inputs = _TIE.search(html), _INPUTS.search(html)
    named = [json.loads(unescape(tie[1]))] if tie else []
    named += json.loads(unescape(inputs[1])) if inputs else []
    return tuple(dict.fromkeys(one["figure"] for one in named if one.get("figure")))


def pieces(lesson: str, page: str) -> Iterator[Piece]:
    """Everything of a built lesson that has a page to embed, by kind."""
    for found in _FIGURE.finditer(page):
        yield Piece("figure", found["ref"], lesson, _anchor(found[0]), found[0], ())
    for found in _EXERCISE.finditer(page):
        html, heading = found[0], _HEADING.search(found[0])
        title = unescape(re.sub(r"<[^>]*>", "", heading[1])) if heading else ""
        uses = _exercise_figures(html)
        yield Piece("exercise", found["ref"], lesson, _anchor(html), html, uses, title)
    for found in _QUESTION.finditer(page):
        data = json.loads(found["data"])
        uses = (data["figure"],) if data.get("figure") else ()
        yield Piece("question", data["id"], lesson, _anchor(found[0]), found[0], uses)


def chosen(found: list[Piece]) -> dict[str, Piece]:
    """One piece for each page: of those with one name the first of its own chapter's lesson."""
    own = [piece for piece in found if piece.ref.startswith(f"{piece.lesson}/")]
    others = [piece for piece in found if not piece.ref.startswith(f"{piece.lesson}/")]
    made: dict[str, Piece] = {}
    for piece in (*own, *others):
        made.setdefault(piece.path, piece)
    return made


def page_html(piece: Piece, name: str, lesson: str, title: str, figures: list[str]) -> str:
    """A page called `name`; the styles and scripts are those of the lesson, called `title`."""
    head = lesson[: lesson.find("</head>")]
    styles = "\n".join(one for one in _STYLE.findall(head) if "copybutton.css" not in one)
    scripts = "\n".join(_SCRIPT.findall(lesson))
    place = f"../chapters/{piece.lesson}.html" + (f"#{piece.anchor}" if piece.anchor else "")
    base = attributes(href=f"{_UP}chapters/{piece.lesson}.html", target="_blank")
    # A construction is made in its figure; an exercise is only tried in it.
    first, last = (figures, []) if piece.kind == "question" else ([], figures)
    shown = "\n".join((*first, piece.html, *last))
    return f"""<!doctype html>
<html lang="en" data-content_root="../">
<head><meta charset="utf-8">
<base{base}>
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="robots" content="noindex">
<title>{escape(name)} - {escape(title)} - Contact Hours</title>
<link rel="icon" href="../_static/favicon.svg">
{styles}
<link rel="stylesheet" href="../{FOLDER}/page.css">
</head>
<body class="embedded">
<script src="../{FOLDER}/page.js"></script>
<div class="content">
<article role="main"><h1>{escape(name)}</h1>
{shown}
<p class="from">From <a{attributes(href=place)}>{escape(title)}</a>, Contact Hours</p>
</article>
</div>
{scripts}
</body>
</html>
"""


def _write(path: Path, text: str) -> None:
    if path.is_file() and path.read_text(encoding="utf-8") == text:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def write_embeds(app: Sphinx, error: Exception | None) -> None:
    """Writes the pages that changed, and removes those whose component is gone."""
    if error is not None or app.builder.name != "html":
        return
    site = Path(app.outdir)
    chapters, web = open_book(app.config).chapters, Path(app.config.contact_web)
    files = {slug: site / "chapters" / f"{slug}.html" for slug in sorted(chapters)}
    lessons = {
        slug: file.read_text(encoding="utf-8")
        for slug, file in files.items()
        if chapters[slug].has_lesson and file.is_file()
    }
    made = chosen([piece for slug, page in lessons.items() for piece in pieces(slug, page)])
    for path, piece in made.items():
        wanted = [path_of("figure", ref) for ref in piece.uses]
        figures = [made[figure].html for figure in wanted if figure in made]
        name, title = title_of(piece, web), chapters[piece.lesson].title
        _write(site / path, page_html(piece, name, lessons[piece.lesson], title, figures))
    for old in (site / FOLDER).rglob("*.html"):
        if old.relative_to(site).as_posix() not in made:
            old.unlink()
    (site / FOLDER).mkdir(exist_ok=True)
    for file in SHARED.iterdir():
        shutil.copyfile(file, site / FOLDER / file.name)
