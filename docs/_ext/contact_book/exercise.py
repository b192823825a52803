"""`{exercise} NAME`: what to do, the contract, what each test is worth, and how to begin."""

from __future__ import annotations

from docutils import nodes
from sphinx.writers.html5 import HTML5Translator

from contact_book.directive import BookDirective
from contact_book.errors import BookError
from contact_book.exercises import KINDS, find_exercise
from contact_book.exercises import Exercise as ExerciseData
from contact_book.html import renders, slots
from contact_book.listing import listing
from contact_book.nodes import component, make_component, make_slot
from contact_book.tables import table


def _number(value: float) -> str:
    return f"{value:g}"


class Exercise(BookDirective):
    required_arguments = 1

    def build(self) -> list[nodes.Node]:
        exercise = find_exercise(self.book, self.arguments[0].strip(), self.here, self.source)
        self.depends(exercise.folder / "exercise.toml", exercise.contract)
        if not exercise.contract.is_file():
            raise BookError(f"{self.book.relative(exercise.contract)} is missing")
        section = nodes.section(
            "",
            ids=[f"exercise-{exercise.name.replace('_', '-')}"],
            names=[f"exercise {exercise.ref}"],
            classes=["exercise"],
        )
        section += nodes.title("", f"Exercise: {exercise.title}")
        section += self.facts(exercise)
        section += self.markdown(exercise.brief)
        section += self.contract(exercise)
        section += self.commands(exercise)
        section += self.points(exercise)
        if exercise.hints:
            section += self.hints(exercise)
        return [section]

    def facts(self, exercise: ExerciseData) -> nodes.paragraph:
        total = sum(test.points for test in exercise.tests)
        words = [KINDS[exercise.kind].capitalize(), f"{_number(total)} points"]
        if exercise.minutes:
            words.append(f"about {exercise.minutes} minutes")
        return nodes.paragraph("", " · ".join(words), classes=["facts"])

    def contract(self, exercise: ExerciseData) -> nodes.Element:
        text = exercise.contract.read_text(encoding="utf-8")
        name = f"{exercise.name}.hpp"
        label = [nodes.Text("The contract, "), nodes.literal(name, name)]
        return listing(text, "cpp", label)

    def commands(self, exercise: ExerciseData) -> nodes.Element:
        text = f"./contact start {exercise.ref}\n./contact watch\n"
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

    def hints(self, exercise: ExerciseData) -> nodes.Node:
        slots = [make_slot("hint", self.markdown(hint)) for hint in exercise.hints]
        return make_component("hints", {}, slots)


@renders("hints")
def hints_html(translator: HTML5Translator, node: component) -> str:
    """One collapsed hint inside the next, so that a reader opens only as many as are needed."""
    hints = slots(translator, node)["hint"]
    html = ""
    for index, hint in reversed(list(enumerate(hints))):
        label = "A hint" if index == 0 else "One more hint"
        html = f"<details><summary>{label}</summary>{hint}{html}</details>"
    return f'<div class="hints">{html}</div>\n'
