"""Why an answer has its mark: all that an instructor needs to answer a request for a regrade.

It shows everything, also what the student's report withholds, and says what that is. The mark's
history is that of the results which earlier runs have left under RESULTS/earlier.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from reports.moment import moment
from reports.results import (
    Exercise,
    ReportError,
    Results,
    Submission,
    TestResult,
    Unit,
    read_results,
)
from reports.text import clean, clean_line
from reports.visibility import Policy, SeenTest, see_unit
from reports.words import STATUS_WORDS, UNIT_WORDS, compile_text, failure_lines, of, points_text

INDENT = "    "


@dataclass(frozen=True)
class Asked:
    """One exercise of one submission."""

    results: Results
    submission: Submission
    exercise: Exercise
    unit: Unit


def find(results: Results, student: str, exercise: str) -> Asked:
    """The exercise, by its id or its name alone, of a student, by id or name.

    @throws ReportError if there is none or more than one
    """
    found = [one for one in results.submissions if student in (one.id, one.name)]
    if len(found) != 1:
        known = ", ".join(one.id for one in results.submissions[:10])
        more = len(results.submissions) - 10
        raise ReportError(
            f"{'nobody' if not found else 'more than one'} is called {clean_line(student)}; "
            f"the ids are {known}{f' and {more} more' if more > 0 else ''}"
        )
    units = [
        unit
        for unit in found[0].units
        if exercise == unit.exercise or exercise == unit.exercise.rpartition("/")[2]
    ]
    if len(units) != 1:
        known = ", ".join(unit.exercise for unit in found[0].units)
        raise ReportError(
            f"{found[0].id} has {'no' if not units else 'more than one'} exercise "
            f"{clean_line(exercise)}; there is {known or 'none'}"
        )
    return Asked(results, found[0], results.exercise(units[0].exercise), units[0])


def why(folder: Path, student: str, exercise: str, policy: Policy) -> str:
    """The whole text."""
    asked = find(read_results(folder), student, exercise)
    parts = [head(asked), circumstances(folder, asked.results), *outcome(asked)]
    if asked.unit.verdict:
        seen = {test.name: test for test in see_unit(asked.unit, asked.results, policy).tests}
        for test in asked.unit.verdict.tests:
            parts += test_lines(test, asked.exercise, seen.get(test.name))
    parts += history(folder, asked)
    parts += limits(folder)
    return "\n".join(parts)


def head(asked: Asked) -> str:
    unit, who = asked.unit, asked.submission
    name = f" ({who.name})" if who.name and who.name != who.id else ""
    mark = "no mark" if unit.points is None else f"{of(unit.points, unit.max_points)} points"
    return f"{who.id}{name}, {asked.exercise.id} “{asked.exercise.title}”: {mark}"


def circumstances(folder: Path, results: Results) -> str:
    """When, with what and where it was graded; the seed is in results.json, which is secret."""
    when = clean_line(str(_json(folder / "run.json").get("finished", "")))
    seed = clean_line(str(_json(folder / "results.json").get("seed")))
    return (
        f"Graded{f' {when}' if when else ''} by Contact Hours {results.version}, "
        f"seed {seed}, isolation {results.machine.level}."
    )


def limits(folder: Path) -> Iterator[str]:
    """Those of the run, by name."""
    given = _json(folder / "results.json").get("limits", {})
    told = {name: value for name, value in given.items() if not isinstance(value, dict | list)}
    if told:
        yield "\nLimits:"
    for name, value in sorted(told.items()):
        yield f"{INDENT}{clean_line(str(name))}: {clean_line(str(value))}"


def outcome(asked: Asked) -> Iterator[str]:
    """What there is to say of the answer as a whole."""
    unit = asked.unit
    state = unit.verdict.outcome if unit.verdict else unit.status
    yield f"The answer: {UNIT_WORDS[state]}."
    if unit.problem:
        yield _indented(unit.problem)
    if unit.verdict and unit.verdict.compile_error:
        yield _indented(compile_text(see_unit(unit, asked.results, Policy())))
    for remark in unit.verdict.diagnostics if unit.verdict else ():
        words = remark.words or remark.message
        yield _indented(f"line {remark.line}: {remark.severity}: {words}")
    if unit.verdict and unit.verdict.output:
        yield f"{INDENT}it printed:\n{_indented(unit.verdict.output, 2)}"


def test_lines(test: TestResult, exercise: Exercise, seen: SeenTest | None) -> Iterator[str]:
    spec = next((one for one in exercise.tests if one.name == test.name), None)
    private = ", private" if spec and spec.private else ""
    yield f"\n{of(test.points, test.max_points)}  {STATUS_WORDS[test.status]}  {test.name}{private}"
    if test.same_as:
        yield f"{INDENT}for the same cause as: {test.same_as}"
    if test.failure:
        stopped = test.status == "stopped"
        yield from (_indented(line) for line in failure_lines(test.failure, False, stopped=stopped))
        if test.failure.misconceptions:
            yield f"{INDENT}misconception: {', '.join(test.failure.misconceptions)}"
    if test.status != "passed":
        yield f"{INDENT}The student's report shows {_shown(seen)}."


def _shown(seen: SeenTest | None) -> str:
    if seen is None:
        return "only the points of such tests in sum"
    if seen.status is None:
        return "its name and points until the due date"
    return "the question and the hint, without values" if seen.withheld else "all of this"


def history(folder: Path, asked: Asked) -> Iterator[str]:
    """Its marks in earlier runs, oldest first, and what changed the last one."""
    marks = list(_earlier_marks(folder, asked))
    if marks:
        yield "\nEarlier marks:"
        yield from (f"{INDENT}{mark}" for mark in marks)
    for change in _json(folder / "changes.json").get("changes", []):
        same = change.get("submission") == asked.submission.id
        if same and change.get("exercise") == asked.exercise.id:
            before, after = (_mark(change.get(key)) for key in ("before", "after"))
            reasons = ", ".join(clean_line(str(reason)) for reason in change.get("why", []))
            yield f"The last run changed it from {before} to {after}, because of: {reasons}."


def _earlier_marks(folder: Path, asked: Asked) -> Iterator[str]:
    for earlier in sorted((folder / "earlier").glob("*/results.json")):
        for one in _json(earlier).get("submissions", []):
            for unit in one.get("exercises", []) if one.get("id") == asked.submission.id else []:
                if unit.get("id") == asked.exercise.id:
                    yield f"until {earlier.parent.name}: {_mark(unit.get('points'))}"


def _mark(points: object) -> str:
    return points_text(float(points)) if isinstance(points, int | float) else "no mark"


def _json(file: Path) -> dict[str, Any]:
    """An object of a file that the grader wrote; empty if it is not there."""
    try:
        read = json.loads(file.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return {}
    except ValueError as error:
        raise ReportError(
            f"{file} cannot be read: {error}. Grade again to write it anew."
        ) from None
    return read if isinstance(read, dict) else {}


def _indented(text: str, times: int = 1) -> str:
    return "\n".join(INDENT * times + line for line in clean(text).splitlines())


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m reports.why", description=__doc__)
    parser.add_argument("results", type=Path, metavar="RESULTS", help="what contact grade -o wrote")
    parser.add_argument("student", metavar="STUDENT", help="id or name")
    parser.add_argument("exercise", metavar="EXERCISE", help="as 02_triangles/ray_triangle")
    parser.add_argument("--due", type=moment, metavar="TIME", help="when work is due")
    given = parser.parse_args(arguments)
    policy = Policy(due=given.due, now=datetime.now(UTC))
    try:
        print(why(given.results, given.student, given.exercise, policy))
    except (ReportError, OSError) as error:
        print(f"contact: {error}", file=sys.stderr)
        return 3
    return 0


if __name__ == "__main__":
    sys.exit(main())
