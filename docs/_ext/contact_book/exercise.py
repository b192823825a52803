"""`{exercise} NAME`: the brief, the contract, the points of each test, and how to start.

The page's script turns it into an editor in which the reader writes and checks the answer.
"""

from __future__ import annotations

import json
import os
import shlex
from pathlib import Path
from typing import Any, ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from forms import has_marks
from sphinx.writers.html5 import HTML5Translator

from contact_book.directive import BookDirective, open_book
from contact_book.errors import BookError
from contact_book.exercise_data import exercise_json, keep, note
from contact_book.exercises import KINDS, find_exercise, misconception_hints
from contact_book.exercises import Exercise as ExerciseData
from contact_book.html import (
    attributes,
    base_path,
    can_run_scripts,
    embed_address,
    embed_link,
    render,
    renders,
    slots,
)
from contact_book.listing import listing
from contact_book.nodes import component, make_component, make_slot, slot
from contact_book.tables import table
from contact_book.try_mine import tie


def _number(value: float) -> str:
    return f"{value:g}"


def pack_option(exercise: ExerciseData) -> str:
    """What a command names before its own words, if the exercise is of the pack that is served."""
    pack = os.environ.get("CONTACT_BOOK_PACK", "")
    if not pack or not (Path(pack) / "exercises" / exercise.ref).is_dir():
        return ""
    return f" --pack {shlex.quote(pack)}"


class Exercise(BookDirective):
    required_arguments = 1
    has_content = True
    option_spec: ClassVar[dict[str, Any]] = dict.fromkeys(
        ("figure", "call", "only-for", "start"), directives.unchanged_required
    )

    def build(self) -> list[nodes.Node]:
        exercise = find_exercise(self.book, self.arguments[0].strip(), self.here, self.source)
        self.read(exercise)
        section = nodes.section(
            "",
            ids=[f"exercise-{exercise.name.replace('_', '-')}"],
            names=[f"exercise {exercise.ref}"],
            classes=["exercise"],
        )
        section += nodes.title("", f"Exercise: {exercise.title}")
        section += self.facts(exercise)
        section += self.markdown(exercise.brief)
        section += self.bench(exercise)
        return [section]

    def read(self, exercise: ExerciseData) -> None:
        files = exercise.sources
        self.depends(*files, self.book.root / "chapters" / "misconceptions.toml")
        for path in files:
            if not path.is_file():
                raise BookError(f"{self.book.relative(path)} is missing")
        note(self.env, exercise.ref)
        self.needs_script()

    def bench(self, exercise: ExerciseData) -> component:
        # What a test may say of a mistake is for the script alone, and not for the search.
        misconceptions = {
            name: make_slot("misconception", self.markdown(hint))
            for name, hint in misconception_hints(self.book, exercise).items()
        }
        parts = [
            make_slot("contract", [self.source_file(exercise.contract, "The contract, ")]),
            *self.given(exercise),
            make_slot("stub", [self.source_file(exercise.stub, "Where you begin, ")]),
            make_slot("commands", [self.commands(exercise)]),
            make_slot("points", [self.points(exercise)]),
            *[make_slot("hint", self.markdown(hint)) for hint in exercise.hints],
        ]
        data = {
            "exercise": exercise,
            "misconceptions": misconceptions,
            "mine": self.mine(exercise),
        }
        return make_component("exercise", data, parts)

    def mine(self, exercise: ExerciseData) -> str | None:
        """How the figure of the lesson calls what the reader writes."""
        found = tie(
            self.book, exercise.chapter, exercise.contract, self.options, list(self.content)
        )
        if found is None:
            return None
        _, figure = found["figure"].split("/")
        self.depends(exercise.chapter.folder / "figures" / f"{figure}.cpp")
        return json.dumps(found, ensure_ascii=False)

    def given(self, exercise: ExerciseData) -> list[slot]:
        if exercise.given is None:
            return []
        return [make_slot("given", [self.source_file(exercise.given, "The code to break, ")])]

    def facts(self, exercise: ExerciseData) -> nodes.paragraph:
        words = [KINDS[exercise.kind].capitalize(), f"{_number(exercise.points)} points"]
        if exercise.minutes:
            words.append(f"about {exercise.minutes} minutes")
        if exercise.name not in exercise.chapter.in_lesson:
            words.append("further practice")
        return nodes.paragraph("", " · ".join(words), classes=["facts"])

    def source_file(self, path: Path, label: str) -> nodes.Element:
        text = path.read_text(encoding="utf-8")
        return listing(text, "cpp", [nodes.Text(label), nodes.literal(path.name, path.name)])

    def commands(self, exercise: ExerciseData) -> nodes.Element:
        contact = f"./contact{pack_option(exercise)}"
        text = f"{contact} start {exercise.ref}\n{contact} watch\n"
        copy = f"work/{exercise.ref}.cpp"
        box = nodes.container(classes=["commands"])
        words = nodes.paragraph("", "Make your own copy, ")
        words += nodes.literal(copy, copy)
        words += nodes.Text(", and be told after every save which tests pass:")
        box += words
        box += listing(text, "console", [])
        return box

    def points(self, exercise: ExerciseData) -> nodes.Element:
        rows = [
            [nodes.Text(test.name), nodes.Text(_number(test.points))] for test in exercise.tests
        ]
        return table(["What must hold", "Points"], rows, "What the tests ask", ["points"])


def inputs_json(exercise: ExerciseData) -> str | None:
    """The fields in which a reader types an input; a figure is named as its element is."""
    if not exercise.inputs:
        return None
    chapter = exercise.chapter.slug
    fields = [
        {**one, "figure": f"{chapter}/{one['figure']}" if one["figure"] else ""}
        for one in exercise.inputs
    ]
    return json.dumps(fields, ensure_ascii=False)


def hints_html(hints: list[str]) -> str:
    """One collapsed hint inside the next, so that a reader opens only as many as are needed."""
    html = ""
    for index, hint in reversed(list(enumerate(hints))):
        label = "A hint" if index == 0 else "One more hint"
        html = f"<details><summary>{label}</summary>{hint}{html}</details>"
    return f'<div class="hints">{html}</div>\n' if html else ""


@renders("exercise")
def exercise_html(translator: HTML5Translator, node: component) -> str:
    exercise: ExerciseData = node["data"]["exercise"]
    parts = slots(translator, node)
    hints = parts.get("hint", [])
    given = "".join(f'<div class="given">{part}</div>' for part in parts.get("given", []))
    inner = (
        f'<div class="contract">{parts["contract"][0]}</div>'
        f"{given}"
        f'<div class="stub">{parts["stub"][0]}</div>'
        f"{parts['commands'][0]}{parts['points'][0]}{hints_html(hints)}"
    )
    if not can_run_scripts(translator):
        return inner
    misconceptions = {
        name: render(translator, words) for name, words in node["data"]["misconceptions"].items()
    }
    book = open_book(translator.config)
    keep(book.products, exercise_json(book, exercise, hints, misconceptions))
    forms = {"forms": ""} if has_marks(exercise.ref, book.root) else {}
    where = attributes(
        name=exercise.ref,
        base=base_path(translator),
        inputs=inputs_json(exercise),
        mine=node["data"]["mine"],
        **forms,
    )
    alone = embed_link(embed_address(translator, "exercise", exercise.ref), "exercise")
    foot = f'<p class="embed-foot">{alone}</p>\n' if alone else ""
    return f"<contact-exercise{where}>{inner}</contact-exercise>\n{foot}"
