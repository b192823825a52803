"""Decides what a student sees of a verdict; no other module does.

    shown            everything
    values_withheld  status, question and hint; not the input, what came back or what is right
    after_due        its name and what it is worth until the due date has passed, then everything
    hidden           nothing but that there are such tests, and their points in sum

What a submission returned, threw or printed may be the very input that it was called with. So the
answer is withheld with the input, a reason is given in our own words, and the program's output is
shown only if no test of the exercise withholds anything. The run time is a channel, too, because a
submission may sleep for a time that depends on its input. So in that case only the times of the
compiler and the linker are shown, which cannot depend on inputs. The mark itself is never withheld.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime

from reports.results import (
    CompileError,
    Diagnostic,
    Exercise,
    Failure,
    Machine,
    Results,
    Submission,
    TestResult,
    TestSpec,
    Unit,
    Verdict,
)

# The status of what could not be graded for a reason that is not the student's.
NOT_GRADED = "not_graded"
OUTPUT_WITHHELD = (
    "What your program printed is not shown, because some tests here do not show their values."
)


@dataclass(frozen=True)
class Policy:
    """When the due date is, and what time it is now."""

    due: datetime | None = None
    now: datetime | None = None
    # The system that shows the marks knows the due date itself, and is given all that it may show
    # then, marked so.
    host_waits: bool = False

    @property
    def due_passed(self) -> bool:
        return self.due is not None and self.now is not None and self.now >= self.due


@dataclass(frozen=True)
class SeenTest:
    """A test as its student sees it. Without a status it is shown after the due date."""

    name: str
    max_points: float
    points: float | None
    status: str | None
    failure: Failure | None = None
    # The input and what is right are not told.
    withheld: bool = False
    # Told now only to a system that waits for the due date itself.
    later: bool = False


@dataclass(frozen=True)
class Sum:
    """Tests of which only the points in sum may be told."""

    points: float
    max_points: float


@dataclass(frozen=True)
class SeenUnit:
    exercise: Exercise
    status: str
    outcome: str | None
    problem: str
    gradable: bool
    # None if it could not be graded. Then there are no tests either, and why is not told here.
    points: float | None
    max_points: float
    seconds: float
    tests: tuple[SeenTest, ...]
    hidden: Sum | None
    # Those of `tests` that have no status yet.
    later: Sum | None
    compile_error: CompileError | None
    diagnostics: tuple[Diagnostic, ...]
    warnings: tuple[str, ...]
    output: str
    output_withheld: bool

    @property
    def told_points(self) -> float | None:
        """The mark as far as it may be told before the due date."""
        if self.points is None:
            return None
        return self.points - (self.later.points if self.later else 0.0)

    @property
    def told_most(self) -> float:
        """Of how many points that is."""
        return self.max_points - (self.later.max_points if self.later else 0.0)


@dataclass(frozen=True)
class SeenSubmission:
    id: str
    name: str
    problem: str
    ignored: tuple[str, ...]
    # None if some unit could not be graded.
    points: float | None
    max_points: float
    units: tuple[SeenUnit, ...]
    not_enforced: tuple[str, ...]

    @property
    def not_graded(self) -> tuple[SeenUnit, ...]:
        """What could not be graded, through no fault of the student's."""
        return tuple(unit for unit in self.units if unit.status == NOT_GRADED)

    @property
    def later(self) -> Sum | None:
        waiting = [unit.later for unit in self.units if unit.later]
        if not waiting:
            return None
        return Sum(sum(one.points for one in waiting), sum(one.max_points for one in waiting))

    @property
    def told_points(self) -> float:
        """The points of all that could be graded, as far as they may be told."""
        if self.points is None:
            return sum(unit.told_points or 0.0 for unit in self.units)
        return self.points - (self.later.points if self.later else 0.0)

    @property
    def told_most(self) -> float:
        """Of how many points that is."""
        missing = sum(unit.max_points for unit in self.not_graded)
        return self.max_points - missing - (self.later.max_points if self.later else 0.0)

    @property
    def gradable(self) -> bool:
        """Whether there is anything to grade: an attempt that does not compile is none."""
        return not self.problem and any(
            unit.gradable and unit.status == "graded" for unit in self.units
        )


def see(submission: Submission, results: Results, policy: Policy) -> SeenSubmission:
    """All of a submission that its student may see."""
    return SeenSubmission(
        id=submission.id,
        name=submission.name,
        problem=submission.problem,
        ignored=submission.ignored,
        points=submission.points,
        max_points=submission.max_points,
        units=tuple(see_unit(unit, results, policy) for unit in submission.units),
        not_enforced=not_enforced(results.machine),
    )


def see_unit(unit: Unit, results: Results, policy: Policy) -> SeenUnit:
    """All of one exercise of a submission that its student may see."""
    exercise = results.exercise(unit.exercise)
    if unit.status == NOT_GRADED:
        return _without_result(unit, exercise)
    verdict = unit.verdict
    given = {test.name: test for test in verdict.tests} if verdict else {}
    listed = {spec.name: effective(spec, policy) for spec in exercise.tests}
    open_tests = {name for name, kind in listed.items() if kind != "hidden"}
    tests: list[SeenTest] = []
    hidden: list[tuple[float, float]] = []
    later: list[tuple[float, float]] = []
    for spec in exercise.tests:
        result = given.get(spec.name)
        points = result.points if result else 0.0
        kind = listed[spec.name]
        if kind == "hidden":
            hidden.append((points, spec.points))
        elif kind == "after_due" and not policy.host_waits:
            later.append((points, spec.points))
            tests.append(SeenTest(spec.name, spec.points, None, None, later=True))
        else:
            tests.append(_seen(spec, result, kind, open_tests))
    # A test that is not listed was nevertheless written by the instructor.
    hidden += [(test.points, test.max_points) for test in given.values() if test.name not in listed]
    everything = all(kind == "shown" for kind in listed.values()) and len(given) <= len(listed)
    output = verdict.output if verdict else ""
    return SeenUnit(
        exercise=exercise,
        status=unit.status,
        outcome=_outcome(verdict.outcome, tests) if verdict else None,
        problem=unit.problem,
        gradable=unit.gradable,
        points=unit.points,
        max_points=unit.max_points,
        seconds=_seconds(verdict, everything) if verdict else 0.0,
        tests=tuple(tests),
        hidden=_sum(hidden),
        later=_sum(later),
        compile_error=verdict.compile_error if verdict else None,
        diagnostics=verdict.diagnostics if verdict else (),
        warnings=verdict.warnings if verdict else (),
        output=output if everything else "",
        output_withheld=bool(output) and not everything,
    )


def _without_result(unit: Unit, exercise: Exercise) -> SeenUnit:
    """A unit that could not be graded. Why is about the machine, and not for the student."""
    return SeenUnit(
        exercise=exercise,
        status=unit.status,
        outcome=None,
        problem="",
        gradable=False,
        points=None,
        max_points=unit.max_points,
        seconds=0.0,
        tests=(),
        hidden=None,
        later=None,
        compile_error=None,
        diagnostics=(),
        warnings=(),
        output="",
        output_withheld=False,
    )


def _seconds(verdict: Verdict, everything: bool) -> float:
    return verdict.build_seconds + (verdict.run_seconds if everything else 0.0)


def effective(spec: TestSpec, policy: Policy) -> str:
    """How much of this test is shown now."""
    if spec.visibility == "after_due" and policy.due_passed:
        return "shown"
    return spec.visibility


def not_enforced(machine: Machine) -> tuple[str, ...]:
    """What this machine could not keep a submission from, as every report says."""
    missing = [measure.what for measure in machine.measures if not measure.enforced]
    if not missing and machine.level != "full":
        missing = [f"submissions were kept apart only in part (level {machine.level})"]
    return tuple(missing)


def machine_sentence(missing: Sequence[str]) -> str:
    """The same as a sentence; empty if all was enforced."""
    if not missing:
        return ""
    return f"The machine that graded this could not enforce: {'; '.join(missing)}."


def _seen(spec: TestSpec, result: TestResult | None, kind: str, open_tests: set[str]) -> SeenTest:
    if result is None:
        return SeenTest(spec.name, spec.points, 0.0, "not_attempted", later=kind == "after_due")
    failure = result.failure
    withheld = kind == "values_withheld"
    if failure is not None:
        failure = _told(failure, result.status, withheld, open_tests)
    return SeenTest(
        name=spec.name,
        max_points=spec.points,
        points=result.points,
        status=result.status,
        failure=failure,
        withheld=withheld and result.status in ("failed", "stopped"),
        later=kind == "after_due",
    )


def _told(failure: Failure, status: str, withheld: bool, open_tests: set[str]) -> Failure:
    if status == "skipped":
        return _only_reason(_why_skipped(failure.reason, open_tests))
    if not withheld:
        return failure
    return Failure(
        asked=failure.asked,
        inputs=(),
        got="",
        right="",
        allowed="",
        misconception=failure.misconception,
        hint=failure.hint,
        # Why an input does not break the code is told by its values.
        reason=_own_words(failure.reason) if failure.reason and status == "stopped" else "",
    )


def _only_reason(reason: str) -> Failure:
    return Failure("", (), "", "", "", "", "", reason)


def _why_skipped(reason: str, open_tests: set[str]) -> str:
    """The grader's words, if the test that they name is one that the student knows."""
    prefix, _, needed = reason.partition(": ")
    if needed in open_tests:
        return f"{prefix}: {needed}"
    return "it counts once a test that it builds on passes"


# The start of a reason, and its replacement if the reason may quote the submission.
_REASONS = (
    (re.compile(r"threw\b"), "it threw an exception that the contract does not know"),
    (re.compile(r".*\b(time|seconds?)\b", re.S), "it took too long"),
    (re.compile(r".*\bmemory\b", re.S), "it used more memory than it may"),
    (re.compile(r".*\b(crash|signal|segmentation|address)", re.S | re.I), "it crashed"),
    (re.compile(r".*\b(exit|ended)", re.S), "it ended before it had answered"),
    (re.compile(r".*\b(print|output)", re.S), "it printed more than it may"),
)


def _own_words(reason: str) -> str:
    for pattern, words in _REASONS:
        if pattern.match(reason):
            return words
    return "it gave no answer that could be read"


def _outcome(outcome: str, tests: Sequence[SeenTest]) -> str:
    """The verdict on the exercise, as far as the shown tests reveal it."""
    if outcome == "does_not_compile":
        return outcome
    told = [test.status for test in tests if test.status is not None]
    if told and all(status == "passed" for status in told):
        return "passed"
    if told and all(status == "not_attempted" for status in told):
        return "not_attempted"
    return "failed" if told else outcome


def _sum(points: Sequence[tuple[float, float]]) -> Sum | None:
    if not points:
        return None
    return Sum(sum(one for one, _ in points), sum(most for _, most in points))
