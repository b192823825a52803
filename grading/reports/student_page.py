"""students/ID/report.html: first the next steps, then all details."""

from __future__ import annotations

from dataclasses import dataclass

from reports.page import render
from reports.visibility import NOT_GRADED, OUTPUT_WITHHELD, SeenSubmission, SeenUnit
from reports.words import (
    HIDDEN_NAME,
    HIDDEN_WORDS,
    LATER_WORDS,
    SEVERAL_WORDS,
    compile_text,
    hint_line,
    not_graded_sentence,
    points_text,
    unit_points,
    unit_problem,
    unit_state,
)

MAX_STEPS = 3


@dataclass(frozen=True)
class Step:
    """Something to do next."""

    unit: SeenUnit
    what: str
    why: str


def student_page(submission: SeenSubmission) -> str:
    """The whole page."""
    steps = next_steps(submission)
    return render(
        "student.html",
        submission=submission,
        steps=steps[:MAX_STEPS],
        more=len(steps) - len(steps[:MAX_STEPS]),
        anchor=_anchor,
        state=unit_state,
        problem=unit_problem,
        compile_text=compile_text,
        hidden_name=HIDDEN_NAME,
        hidden_words=HIDDEN_WORDS,
        later_words=LATER_WORDS,
        several_words=SEVERAL_WORDS,
        output_withheld=OUTPUT_WITHHELD,
        unit_points=unit_points,
        not_graded=not_graded_sentence(submission),
    )


def next_steps(submission: SeenSubmission) -> list[Step]:
    """What to do, the cheapest first: what does not compile, what fails, what is not begun."""
    compile_first: list[Step] = []
    repair: list[Step] = []
    begin: list[Step] = []
    for unit in submission.units:
        title = unit.exercise.title
        worth = points_text(unit.max_points)
        if unit.status == NOT_GRADED:
            continue
        if unit.status == "refused":
            compile_first.append(Step(unit, f"Hand in a file for “{title}” again", unit.problem))
        elif unit.status != "graded" or unit.outcome == "not_attempted":
            begin.append(Step(unit, f"Begin “{title}”", f"It is worth {worth} points."))
        elif unit.outcome == "does_not_compile":
            error = unit.compile_error
            why = (error.explanation or error.message) if error else ""
            place = f"Line {error.line}: " if error and error.line else ""
            compile_first.append(Step(unit, f"Make “{title}” compile", place + why))
        elif failing := _first_failing(unit):
            repair.append(Step(unit, f"Repair “{title}”", failing))
    return compile_first + repair + begin


def _first_failing(unit: SeenUnit) -> str:
    for test in unit.tests:
        if test.status in ("failed", "stopped") and test.failure:
            said = hint_line(test.failure) or test.failure.reason or test.failure.asked
            return f"Not yet: {test.name}. {said[:1].upper()}{said[1:]}"
    for test in unit.tests:
        if test.status == "not_attempted":
            return f"Not attempted yet: {test.name}."
    return ""


def _anchor(unit: SeenUnit) -> str:
    return unit.exercise.id.replace("/", "-")
