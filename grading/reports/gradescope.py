"""results.json for Gradescope, as its "Autograder Specifications" describe it.

Every text is of format "text": nothing of a submission is ever rendered. Gradescope knows the due
date and its exceptions, so a test that is shown after it is handed over whole, marked
`after_due_date`, unless --due says that it has passed. Hidden tests are one entry an exercise with
the sum of their points: an entry marked `hidden` would also hide the student's total.

If something could not be graded there is no score, neither in total nor of a test. Gradescope
requires one of them, so it treats such a file as a failed run and records no mark.
"""

from __future__ import annotations

from typing import Any

from reports.visibility import OUTPUT_WITHHELD, SeenSubmission, SeenTest, SeenUnit, machine_sentence
from reports.words import (
    HIDDEN_NAME,
    HIDDEN_WORDS,
    REFUSED_NAME,
    not_graded_sentence,
    number,
    test_text,
    unit_problem,
)

Json = dict[str, Any]


def gradescope(submission: SeenSubmission) -> Json:
    """The whole document. `submission` is seen with host_waits."""
    tests: list[Json] = []
    if submission.problem:
        refusal = _entry("0", REFUSED_NAME, submission.problem, 0.0, submission.max_points)
        tests.append(refusal)
    for place, unit in enumerate(submission.units, start=1):
        tests += _unit_tests(place, unit)
    document: Json = {
        "score": number(submission.points or 0.0),
        "execution_time": round(sum(unit.seconds for unit in submission.units), 3),
        "output": "\n\n".join(_overview(submission)),
        "output_format": "text",
        "test_output_format": "text",
        "test_name_format": "text",
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "extra_data": {
            "format": "contact-gradescope/1",
            "gradable": submission.gradable,
            "not_enforced": list(submission.not_enforced),
        },
        "tests": tests,
    }
    return without_score(document) if submission.not_graded else document


def without_score(document: Json) -> Json:
    """The same as no mark."""
    tests = [
        {name: value for name, value in test.items() if name not in ("score", "max_score")}
        for test in document["tests"]
    ]
    kept = {name: value for name, value in document.items() if name != "score"}
    return kept | {"tests": tests, "extra_data": {**document["extra_data"], "graded": False}}


def _overview(submission: SeenSubmission) -> list[str]:
    parts = []
    if sentence := not_graded_sentence(submission):
        parts.append(sentence)
    if submission.problem:
        parts.append(f"{REFUSED_NAME}: {submission.problem}")
    uncompiled = [
        unit.exercise.id for unit in submission.units if unit.outcome == "does_not_compile"
    ]
    if uncompiled:
        parts.append(f"Does not compile, so no test could run: {', '.join(uncompiled)}.")
    if submission.ignored:
        parts.append(f"Files that answer to no exercise: {', '.join(submission.ignored)}")
    if not parts:
        parts.append("Each test below says what it asked and what came back.")
    if sentence := machine_sentence(submission.not_enforced):
        parts.append(sentence)
    return parts


def _unit_tests(number_: int, unit: SeenUnit) -> list[Json]:
    title = unit.exercise.title
    problem = unit_problem(unit)
    entries = []
    if problem:
        entries.append(
            _entry(
                f"{number_}.0",
                f"{title}: {_why(unit)}",
                output=problem,
                status="failed",
                tags=[unit.exercise.id],
            )
        )
    for place, test in enumerate(unit.tests, start=1):
        entries.append(_test(f"{number_}.{place}", title, test, unit, told=not problem))
    if unit.hidden:
        entries.append(
            _entry(
                f"{number_}.{len(unit.tests) + 1}",
                f"{title}: {HIDDEN_NAME.lower()}",
                output=HIDDEN_WORDS,
                points=unit.hidden.points,
                max_points=unit.hidden.max_points,
                tags=[unit.exercise.id, "hidden"],
            )
        )
    if unit.output:
        entries.append(
            _entry(f"{number_}.out", f"{title}: what your program printed", output=unit.output)
        )
    elif unit.output_withheld and entries:
        entries[0]["output"] = f"{entries[0]['output']}\n{OUTPUT_WITHHELD}".strip()
    return entries


def _why(unit: SeenUnit) -> str:
    return {
        "refused": "refused",
        "missing": "not handed in",
        "untouched": "as it was given",
        "not_graded": "could not be graded",
    }.get(unit.status, "does not compile")


def _test(number_: str, title: str, test: SeenTest, unit: SeenUnit, told: bool) -> Json:
    text = test_text(test) if told else ""
    return _entry(
        number_,
        f"{title}: {test.name}",
        output=text,
        points=test.points or 0.0,
        max_points=test.max_points,
        status="passed" if test.status == "passed" else "failed",
        tags=[unit.exercise.id, test.status or "later"],
        visibility="after_due_date" if test.later else "visible",
    )


def _entry(
    number_: str,
    name: str,
    output: str,
    points: float | None = None,
    max_points: float | None = None,
    status: str | None = None,
    tags: list[str] | None = None,
    visibility: str = "visible",
) -> Json:
    entry: Json = {}
    if points is not None and max_points is not None:
        entry |= {"score": number(points), "max_score": number(max_points)}
        status = status or ("passed" if points >= max_points else "failed")
    if status:
        entry["status"] = status
    return entry | {
        "name": name,
        "name_format": "text",
        "number": number_,
        "output": output,
        "output_format": "text",
        "tags": tags or [],
        "visibility": visibility,
    }


def not_graded(reason: str) -> Json:
    """If grading itself fails, this tells the student that it is not a mark."""
    words = (
        "Your files have arrived, but they could not be graded: something failed on our side, not"
        " on yours. This is no mark. Your teacher can see why and start the grading again;"
        " you need not hand in anything new."
    )
    return {
        "output": words,
        "output_format": "text",
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "extra_data": {"format": "contact-gradescope/1", "graded": False},
        "tests": [
            _entry(
                "1",
                "Not graded yet: this is no mark",
                output=f"{words}\n\nFor your teacher: {reason}",
                status="failed",
                tags=["not-graded"],
            )
        ],
    }
