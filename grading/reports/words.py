"""The wording of results, for all formats."""

from __future__ import annotations

from reports.results import Failure
from reports.visibility import NOT_GRADED, SeenSubmission, SeenTest, SeenUnit, Sum

STATUS_WORDS = {
    "passed": "passed",
    "failed": "failed",
    "not_attempted": "not attempted",
    "stopped": "stopped",
    "skipped": "skipped",
}

UNIT_WORDS = {
    "missing": "nothing was handed in",
    "untouched": "as it was given",
    "refused": "refused",
    "not_graded": "could not be graded",
    "passed": "passed",
    "failed": "not passed yet",
    "not_attempted": "not attempted",
    "does_not_compile": "does not compile",
}

NOT_GRADED_WORDS = (
    "This could not be graded, and it is no mark. This is not your fault; ask your instructor."
)
REFUSED_NAME = "This submission was refused"
HIDDEN_NAME = "Hidden tests"
HIDDEN_WORDS = "Tests that are not shown. Only their points in sum are."
LATER_NAME = "Tests that are shown after the due date"
LATER_WORDS = "The result is shown after the due date."


def points_text(points: float) -> str:
    """3 for 3.0, 2.5 for 2.5."""
    return f"{round(points, 4):g}"


def of(points: float, most: float) -> str:
    return f"{points_text(points)} of {points_text(most)}"


def number(points: float) -> int | float:
    """A number for JSON: whole where it is whole."""
    rounded = round(points, 4)
    return int(rounded) if rounded.is_integer() else rounded


def unit_state(unit: SeenUnit) -> str:
    """The key of UNIT_WORDS: the state of an exercise."""
    return unit.outcome or "failed" if unit.status == "graded" else unit.status


def failure_lines(failure: Failure, withheld: bool, *, stopped: bool) -> list[str]:
    """A failure as plain text, in the order in which a check tells it."""
    lines = []
    if failure.asked:
        lines.append(f"asked:   {failure.asked}")
    lines += [f"  {name} = {text}" for name, text in failure.inputs]
    if failure.got:
        lines.append(f"got:     {failure.got}")
    if failure.right:
        lines.append(f"right:   {failure.right}")
    if failure.allowed:
        lines.append(f"allowed: {failure.allowed}")
    if failure.reason:
        lines.append(f"{'stopped: ' if stopped else 'why:     '}{failure.reason}")
    if failure.hint:
        lines.append(f"hint:    {failure.hint}")
    if withheld:
        lines.append("The values of this test are not shown.")
    return lines


def test_text(test: SeenTest) -> str:
    """What there is to say about a test under its name."""
    if test.status is None:
        return LATER_WORDS
    if test.failure is None:
        return ""
    if test.status == "skipped":
        return f"Skipped: {test.failure.reason}"
    return "\n".join(failure_lines(test.failure, test.withheld, stopped=test.status == "stopped"))


def compile_text(unit: SeenUnit) -> str:
    """Why a file does not compile: our words first, then the compiler's."""
    error = unit.compile_error
    if error is None:
        return "This file does not compile."
    place = f"line {error.line}: " if error.line else ""
    parts = [f"{place}{error.explanation or error.message}"]
    if error.excerpt:
        parts.append(error.excerpt)
    if error.explanation and error.message:
        parts.append(f"In the compiler's words: {error.message}")
    if error.contract:
        parts.append("The contract says:\n" + "\n".join(error.contract))
    return "\n".join(parts)


def unit_problem(unit: SeenUnit) -> str:
    """Why an exercise has no tests to show; empty if it has."""
    if unit.status == "refused":
        return unit.problem or "This file was refused."
    if unit.status == NOT_GRADED:
        return NOT_GRADED_WORDS
    if unit.status == "missing":
        return "Nothing was handed in for this exercise."
    if unit.status == "untouched":
        return "This file is unchanged."
    if unit.outcome == "does_not_compile":
        return compile_text(unit)
    return ""


def unit_points(unit: SeenUnit) -> str:
    """The mark as it is told; no number where there is none."""
    if unit.told_points is None:
        return f"no mark of {points_text(unit.told_most)}"
    return of(unit.told_points, unit.told_most)


def not_graded_sentence(submission: SeenSubmission) -> str:
    """Which exercises could not be graded; empty if all were."""
    titles = [f"“{unit.exercise.title}”" for unit in submission.not_graded]
    if not titles:
        return ""
    it = "it is" if len(titles) == 1 else "they are"
    return (
        f"{', '.join(titles)} could not be graded, and {it} no mark. This is not your fault; ask"
        " your instructor."
    )


def sum_text(points: Sum) -> str:
    return of(points.points, points.max_points)
