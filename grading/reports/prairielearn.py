"""results.json for PrairieLearn's external graders.

A file that does not compile is `gradable: false`, so it uses up no attempt and loses no points. A
submission with a part that could not be graded is also `gradable: false` and has no score.
PrairieLearn accepts at most a megabyte; the longest texts are cut, and the message says so.
"""

from __future__ import annotations

import json
from typing import Any

from reports.text import cut
from reports.visibility import OUTPUT_WITHHELD, SeenSubmission, SeenTest, SeenUnit, machine_sentence
from reports.words import (
    HIDDEN_NAME,
    HIDDEN_WORDS,
    LATER_NAME,
    LATER_WORDS,
    STATUS_WORDS,
    UNIT_WORDS,
    not_graded_sentence,
    number,
    of,
    test_text,
    unit_problem,
    unit_state,
)

Json = dict[str, Any]

MAX_BYTES = 1_000_000
# Texts are cut to each of these in turn until the whole fits.
CUTS = (8000, 2000, 500, 120)
CUT_WORDS = "Long texts in this report are cut, because it may have no more than 1 MB."


def prairielearn(submission: SeenSubmission) -> Json:
    """The whole document, of MAX_BYTES at most."""
    document = _document(submission)
    for length in CUTS:
        if size(document) <= MAX_BYTES:
            return document
        document = _shortened(_document(submission), length)
    while document["tests"] and size(document) > MAX_BYTES:
        left_out = document["tests"][-1 - len(document["tests"]) // 4 :]
        document["tests"] = document["tests"][: -len(left_out)]
    return document


def size(document: Json) -> int:
    """Bytes of the file."""
    return len(json.dumps(document, ensure_ascii=False, indent=1).encode())


def _document(submission: SeenSubmission) -> Json:
    most = submission.max_points
    tests: list[Json] = []
    for unit in submission.units:
        tests += _unit_tests(unit)
    points = submission.points or 0.0
    document: Json = {
        "gradable": submission.gradable,
        "score": min(1.0, round(points / most, 6)) if most > 0 else 0.0,
        "message": _message(submission),
        "output": "\n\n".join(_outputs(submission)),
        "tests": tests,
    }
    if submission.not_graded:
        # A score of the rest would be taken for the total.
        document["gradable"] = False
        del document["score"]
        document["format_errors"] = [not_graded_sentence(submission)]
    elif not submission.gradable:
        document["format_errors"] = _format_errors(submission)
    return document


def _message(submission: SeenSubmission) -> str:
    parts = [f"{of(submission.points or 0.0, submission.max_points)} points."]
    if submission.not_graded:
        parts = [not_graded_sentence(submission), "This costs you no attempt."]
    elif not submission.gradable:
        parts = ["There is nothing here that can be graded; this costs you no attempt."]
    if submission.later:
        parts.append("Some results are shown after the due date.")
    if sentence := machine_sentence(submission.not_enforced):
        parts.append(sentence)
    return " ".join(parts)


def _outputs(submission: SeenSubmission) -> list[str]:
    parts = []
    if submission.ignored:
        parts.append(f"Files that answer to no exercise: {', '.join(submission.ignored)}")
    for unit in submission.units:
        if unit.output:
            parts.append(f"Printed by {unit.exercise.id}:\n{unit.output}")
        elif unit.output_withheld:
            parts.append(f"{unit.exercise.id}: {OUTPUT_WITHHELD}")
    return parts


def _format_errors(submission: SeenSubmission) -> list[str]:
    if submission.problem:
        return [submission.problem]
    errors = [
        f"{unit.exercise.id}: {unit_problem(unit)}"
        for unit in submission.units
        if unit.status == "refused" or unit.outcome == "does_not_compile"
    ]
    return errors or ["No file answers to an exercise."]


def _unit_tests(unit: SeenUnit) -> list[Json]:
    problem = unit_problem(unit)
    entries = [_test(unit, test, told=not problem) for test in unit.tests if test.status]
    waiting = [test.name for test in unit.tests if test.status is None]
    if unit.later:
        entries.append(
            {
                "name": f"{unit.exercise.title}: {LATER_NAME.lower()}",
                "description": "; ".join(waiting),
                "points": number(unit.later.points),
                "max_points": number(unit.later.max_points),
                "message": LATER_WORDS,
                "output": "",
            }
        )
    if unit.hidden:
        entries.append(
            {
                "name": f"{unit.exercise.title}: {HIDDEN_NAME.lower()}",
                "description": HIDDEN_WORDS,
                "points": number(unit.hidden.points),
                "max_points": number(unit.hidden.max_points),
                "message": "",
                "output": "",
            }
        )
    if problem and entries:
        state = UNIT_WORDS[unit_state(unit)]
        entries[0] |= {"message": state[0].upper() + state[1:] + ".", "output": problem}
    return entries


def _test(unit: SeenUnit, test: SeenTest, told: bool) -> Json:
    status = STATUS_WORDS[test.status or "not_attempted"]
    return {
        "name": f"{unit.exercise.title}: {test.name}",
        "description": unit.exercise.id,
        "points": number(test.points or 0.0),
        "max_points": number(test.max_points),
        "message": status[0].upper() + status[1:] + "." if told else "",
        "output": test_text(test) if told else "",
    }


def _shortened(document: Json, length: int) -> Json:
    def short(text: str) -> str:
        return cut(text, characters=length, lines=60)

    document["message"] = f"{short(document['message'])} {CUT_WORDS}"
    document["output"] = short(document["output"])
    if "format_errors" in document:
        document["format_errors"] = [short(text) for text in document["format_errors"][:50]]
    for test in document["tests"]:
        test["output"] = short(test["output"])
    return document


def not_graded(reason: str) -> Json:
    """When grading itself fails: nothing that counts."""
    return {
        "gradable": False,
        "message": (
            "Your files have arrived, but they could not be graded: something failed on our side,"
            " not on yours. This costs you no attempt."
        ),
        "output": "",
        "format_errors": [f"Not graded: {reason}"],
        "tests": [],
    }
