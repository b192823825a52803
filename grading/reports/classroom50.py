"""result.json for Classroom 50: the contract "classroom50/result/v1", with its hyphens.

Its scores are whole numbers. If points are not, all are multiplied by the same number,
`points-factor`. The runner gives the student and the assignment in the environment; without a
runner the submission's id is used. A result must have a score, so none is written if something
could not be graded.
"""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime
from fractions import Fraction
from math import lcm
from typing import Any

from reports.visibility import SeenSubmission, SeenUnit, machine_sentence
from reports.words import HIDDEN_NAME, LATER_NAME, REFUSED_NAME, test_text, unit_problem

Json = dict[str, Any]

SCHEMA = "classroom50/result/v1"
# Points beyond a thousandth are rounded.
FINEST = 1000


def classroom50(submission: SeenSubmission, environment: Mapping[str, str], now: datetime) -> Json:
    """The whole document."""
    factor = _factor(submission)
    tests: list[Json] = []
    if submission.problem:
        refusal = _entry("submission", REFUSED_NAME.lower(), 0.0, submission.max_points, factor)
        tests.append({**refusal, "output": submission.problem})
    for unit in submission.units:
        tests += _unit_tests(unit, factor)
    tag = environment.get("SUBMISSION_TAG") or f"submit/{submission.id}"
    commit = environment.get("COMMIT_URL") or tag
    document: Json = {
        "schema": SCHEMA,
        "classroom": environment.get("CLASSROOM") or "contact-hours",
        "assignment": environment.get("ASSIGNMENT") or "contact-hours",
        "assignment_type": environment.get("ASSIGNMENT_TYPE") or "individual",
        "owner": environment.get("OWNER") or environment.get("USERNAME") or submission.id,
        "submission": tag,
        "commit": commit,
        "release": environment.get("RELEASE_URL") or tag,
        "review": environment.get("REVIEW_URL") or commit,
        "datetime": now.strftime("%Y-%m-%dT%H:%M:%SZ"),
        "score": sum(test["score"] for test in tests),
        "max-score": sum(test["max-score"] for test in tests),
        "tests": tests,
        "points-factor": factor,
        "gradable": submission.gradable,
    }
    message = " ".join(
        part for part in (submission.problem, machine_sentence(submission.not_enforced)) if part
    )
    if message:
        document["message"] = message
    return document


def _factor(submission: SeenSubmission) -> int:
    points = [submission.max_points]
    for unit in submission.units:
        for test in unit.tests:
            points += [test.points or 0.0, test.max_points]
        for some in (unit.hidden, unit.later):
            points += [some.points, some.max_points] if some else []
    return lcm(1, *(_fraction(one).denominator for one in points))


def _fraction(points: float) -> Fraction:
    return Fraction(round(points * FINEST), FINEST)


def _unit_tests(unit: SeenUnit, factor: int) -> list[Json]:
    problem = unit_problem(unit)
    entries: list[Json] = []
    for test in unit.tests:
        if test.status is None:
            continue
        entry = _entry(unit.exercise.id, test.name, test.points or 0.0, test.max_points, factor)
        entry["passed"] = test.status == "passed"
        entry["status"] = test.status
        if text := problem if problem and not entries else "" if problem else test_text(test):
            entry["output"] = text
        entries.append(entry)
    if unit.later:
        entry = _entry(
            unit.exercise.id, LATER_NAME.lower(), unit.later.points, unit.later.max_points, factor
        )
        entry["names"] = [test.name for test in unit.tests if test.status is None]
        entries.append(entry)
    if unit.hidden:
        hidden = unit.hidden
        entries.append(
            _entry(unit.exercise.id, HIDDEN_NAME.lower(), hidden.points, hidden.max_points, factor)
        )
    return entries


def _entry(of: str, name: str, points: float, most: float, factor: int) -> Json:
    score = int(_fraction(points) * factor)
    max_score = int(_fraction(most) * factor)
    return {
        "test-name": f"{of}: {name}",
        "passed": score >= max_score,
        "score": score,
        "max-score": max_score,
    }
