"""`{ask-engines}`: questions to engines, with their recorded answers; the page's script asks anew.

page/engines/record.mjs writes the record: what is asked, of whom, and the answers.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import partial
from html import escape
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.writers.html5 import HTML5Translator

from contact_book.directive import BookDirective
from contact_book.errors import BookError
from contact_book.exercises import find_exercise
from contact_book.html import attributes, base_path, can_run_scripts, renders
from contact_book.nodes import component, make_component

RECORD = Path("page", "engines", "recorded.json")
# What the page's script asks for the book's own answers.
MODULES = ("scenes/player.wasm", "engines/queries.wasm")
NOT_ASKED = "does not answer this"
NO_VALUE = "none"
# Outside of these an error is written with a power of ten.
SMALL, LARGE = 1e-3, 1e3
# Engines in which a geometric question depends on the switches, and what they set.
GEOMETRIC = {"jolt": "convex radius 0", "matter": "discs of 100 sides"}


class AskEngines(BookDirective):
    """The table of all questions, by chapter in the order of the record."""

    def build(self) -> list[nodes.Node]:
        file = self.book.root / RECORD
        self.depends(file)
        if not file.is_file():
            raise BookError(f"{RECORD} is missing: node page/engines/record.mjs writes it")
        record = json.loads(file.read_text(encoding="utf-8"))
        self.needs_script()
        modules = [Path(self.config.contact_web) / name for name in MODULES]
        self.depends(*modules)
        record["built"] = all(module.is_file() for module in modules)
        if not record["built"]:
            self.missing_figure(f"the book's answers to engines are not built: {modules[-1]}")
        lessons = {question["lesson"] for question in record["questions"]}
        record["lessons"] = {slug: self.lesson(slug) for slug in lessons}
        return [make_component("ask-engines", record)]

    def lesson(self, slug: str) -> dict[str, str]:
        """The lesson that explains a question, and its exercise in which code is broken."""
        chapter = self.book.chapter(slug, self.source)
        self.depends(chapter.folder / "chapter.toml")
        exercises = [find_exercise(self.book, n, slug, self.source) for n in chapter.exercises]
        broken = [exercise for exercise in exercises if exercise.kind == "break"]
        if not broken:
            raise BookError(f"chapters/{slug} has no exercise of the kind break")
        return {"title": chapter.title, "exercise": broken[0].name, "broken": broken[0].title}


def _power(value: float) -> str:
    """Two digits and a power of ten."""
    mantissa, _, exponent = f"{value:.1e}".partition("e")
    raised = str(int(exponent)).replace("-", "−")
    return f"{float(mantissa):g} · 10<sup>{raised}</sup>".replace("-", "−")


def number(value: float | None) -> str:
    """A value with up to ten digits; a very small one with two."""
    if value is None:
        return NO_VALUE
    if 0 < abs(value) < SMALL:
        return _power(value)
    return f"{value:.10g}".replace("-", "−")


def error_of(error: float | None) -> str:
    """An error with two digits, as the page's script writes it."""
    if error is None:
        return "–"
    if error == 0:
        return "0"
    if error < SMALL or error >= LARGE:
        return _power(error)
    return f"{float(f'{error:.2g}'):g}"


def milliseconds(ms: float) -> str:
    return f"{ms:.2g} ms" if ms < 100 else f"{ms / 1000:.2g} s"


def settings_of(engine: dict[str, Any], question: dict[str, Any], best: dict[str, Any]) -> str:
    """The settings of the best answer in a few words."""
    if "duration" not in question:
        return GEOMETRIC[engine["id"]]
    steps = round(1 / best["settings"]["step"])
    return (
        f"step 1/{steps} s, {best['settings']['iterations']} {engine['iterations'].split(';')[0]}"
    )


def cells(answer: dict[str, Any]) -> str:
    failed = f"<br><small>{escape(answer['failed'])}</small>" if "failed" in answer else ""
    value = f"<td>{number(answer['value'])}{failed}</td>"
    return f"{value}<td>{error_of(answer['error'])}</td><td>{milliseconds(answer['ms'])}</td>"


def row(engine: dict[str, Any], question: dict[str, Any], answer: dict[str, Any] | None) -> str:
    where = attributes(data_engine=engine["id"]).replace("data_engine", "data-engine")
    head = f'<tr{where}><th scope="row">{escape(engine["title"])}</th>'
    if answer is None:
        return f'{head}<td colspan="7" class="not-asked">{NOT_ASKED}</td></tr>'
    best = answer.get("best")
    geometric = "duration" not in question and engine["id"] not in GEOMETRIC
    if best is None or geometric:
        return (
            f'{head}{cells(answer)}<td colspan="4" class="not-asked">it has no settings</td></tr>'
        )
    used = escape(settings_of(engine, question, best))
    return f"{head}{cells(answer)}{cells(best)}<td><small>{used}</small></td></tr>"


HEAD = (
    '<thead><tr><td></td><th colspan="3" scope="colgroup">default settings</th>'
    '<th colspan="4" scope="colgroup">best of the settings tried</th></tr>'
    '<tr><th scope="col">engine</th>'
    + '<th scope="col">answer</th><th scope="col">error</th><th scope="col">time</th>' * 2
    + '<th scope="col">settings</th></tr></thead>'
)


def question_html(record: dict[str, Any], question: dict[str, Any], links: tuple[str, str]) -> str:
    name, unit = question["id"], escape(question["unit"])
    lesson = record["lessons"][question["lesson"]]
    exact = [
        f"<b>{number(question['exact']['value'])}</b> {unit}: {escape(question['exact']['how'])}"
    ]
    if "exact2" in question:
        other = question["exact2"]
        exact.append(f"In the plane <b>{number(other['value'])}</b> {unit}: {escape(other['how'])}")
    answers = record["answers"][name]
    rows = [row(one, question, answers.get(one["id"])) for one in record["engines"]]
    body = "".join(rows)
    of = f", in {unit}" if unit else ""
    table = f"<table><caption>Answers and errors{of}</caption>{HEAD}<tbody>{body}</tbody></table>"
    where = (
        f'<a href="{links[0]}">{escape(lesson["title"])}</a>, and break it: '
        f'<a href="{links[1]}">{escape(lesson["broken"])}</a>'
    )
    scrolled = f'role="region" tabindex="0" aria-label="Answers: {escape(name)}"'
    return (
        f'<section class="asked" data-question="{escape(name)}" id="ask-{escape(name)}">'
        f'<p class="question">{escape(question["text"])}</p>'
        f'<p class="exact">Exact: {". ".join(exact)}.</p>'
        f'<div class="wide" {scrolled}>{table}</div>'
        f'<p class="why">Explained in {where}</p></section>'
    )


def title_of(question: dict[str, Any]) -> str:
    return str(question["id"]).replace("-", " ")


def overview_html(record: dict[str, Any]) -> str:
    """All errors with default settings in one table."""
    engines = record["engines"]
    heads = "".join(f'<th scope="col">{escape(engine["title"])}</th>' for engine in engines)
    rows = []
    for question in record["questions"]:
        answers = record["answers"][question["id"]]
        errors = [answers.get(engine["id"]) for engine in engines]
        cells = [
            f"<td>{'<small>no</small>' if one is None else error_of(one['error'])}</td>"
            for one in errors
        ]
        unit = f" <small>{escape(question['unit'])}</small>" if question["unit"] else ""
        link = f'<a href="#ask-{escape(question["id"])}">{escape(title_of(question))}</a>{unit}'
        rows.append(f'<tr><th scope="row">{link}</th>{"".join(cells)}</tr>')
    caption = "<caption>Errors with default settings</caption>"
    head = f'<thead><tr><th scope="col">question</th>{heads}</tr></thead>'
    scrolled = 'role="region" tabindex="0" aria-label="Errors with default settings"'
    legend = (
        "<p>Errors with default settings, in the unit beside the question. “no”: the engine does "
        "not answer this. “–”: it was asked and gave no answer.</p>"
    )
    table = f"<table>{caption}{head}<tbody>{''.join(rows)}</tbody></table>"
    return f'{legend}<div class="wide overview" {scrolled}>{table}</div>'


def engines_html(record: dict[str, Any], to: Callable[[str], str]) -> str:
    """Versions, promises and settings of all engines; `to`: the address of a page of the book."""
    items = []
    for engine in record["engines"]:
        source = engine["source"]
        if engine["id"] == "book":
            source = to(source.removesuffix(".html"))
        promised = f'{escape(engine["promise"])} <a href="{escape(source)}">Source</a>.'
        if engine["id"] == "book":
            items.append(f"<dt>{escape(engine['title'])}</dt><dd>{promised}</dd>")
            continue
        size = f"{engine['bytes'] / 1e6:.1f} MB" if engine["bytes"] > 99999 else "under 0.1 MB"
        facts = [engine["version"], f"{engine['dimension']}D", engine["licence"], size]
        about = escape(", ".join(facts))
        default = ""
        if "defaults" in engine:
            step = round(1 / engine["defaults"]["step"])
            default = (
                f" By default the step is 1/{step} s with {engine['defaults']['iterations']} "
                f"iterations ({escape(engine['iterations'])}). Of the switches, "
                f"{escape(engine['switches'])}."
            )
        items.append(
            f"<dt>{escape(engine['title'])} <small>{about}</small></dt><dd>{promised}{default}</dd>"
        )
    return f'<dl class="engines">{"".join(items)}</dl>'


@renders("ask-engines")
def ask_engines_html(translator: HTML5Translator, node: component) -> str:
    record = node["data"]
    builder = translator.builder
    to = partial(builder.get_relative_uri, builder.current_docname)
    parts = []
    for question in record["questions"]:
        page = to(f"chapters/{question['lesson']}")
        exercise = record["lessons"][question["lesson"]]["exercise"].replace("_", "-")
        parts.append(question_html(record, question, (page, f"{page}#exercise-{exercise}")))
    megabytes = sum(engine.get("bytes", 0) for engine in record["engines"]) / 1e6
    recorded = (
        f'<p class="recorded">Recorded on {record["date"]} with Node {record["node"]} '
        f"on {escape(record['processor'])}; times are of one run after a first one. "
        f"Asking here loads all engines once, {megabytes:.1f} MB.</p>"
    )
    inner = overview_html(record) + recorded + "".join(parts) + engines_html(record, to)
    if not can_run_scripts(translator):
        return inner
    where = attributes(base=base_path(translator)) + ("" if record["built"] else " not-built")
    return f"<contact-engines{where}>{inner}</contact-engines>\n"
