"""Reads RESULTS/results.json: validates it against its schema and makes every text in it safe."""

from __future__ import annotations

import functools
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import jsonschema

from reports.text import clean, clean_line

SCHEMA = Path(__file__).with_name("results.schema.json")


class ReportError(Exception):
    """What the reader of the command line must put right, in a sentence."""


@dataclass(frozen=True)
class TestSpec:
    name: str
    points: float
    visibility: str
    private: bool


@dataclass(frozen=True)
class Exercise:
    id: str
    title: str
    objective: str
    max_points: float
    tests: tuple[TestSpec, ...]


@dataclass(frozen=True)
class Failure:
    asked: str
    inputs: tuple[tuple[str, str], ...]
    got: str
    right: str
    allowed: str
    misconceptions: tuple[str, ...]
    hint: str
    questions: tuple[str, ...]
    reason: str

    @property
    def known(self) -> str:
        """The misconception, if only one gives this answer; otherwise it is not known."""
        return self.misconceptions[0] if len(self.misconceptions) == 1 else ""


@dataclass(frozen=True)
class TestResult:
    name: str
    status: str
    points: float
    max_points: float
    failure: Failure | None
    # The earlier test that fails for the same cause.
    same_as: str = ""


@dataclass(frozen=True)
class Diagnostic:
    line: int
    column: int
    severity: str
    message: str
    words: str
    mistake: str


@dataclass(frozen=True)
class CompileError:
    line: int
    column: int
    message: str
    excerpt: str
    explanation: str
    contract: tuple[str, ...]
    full: str


@dataclass(frozen=True)
class Verdict:
    outcome: str
    tests: tuple[TestResult, ...]
    diagnostics: tuple[Diagnostic, ...]
    warnings: tuple[str, ...]
    output: str
    build_seconds: float
    run_seconds: float
    compile_error: CompileError | None


@dataclass(frozen=True)
class Unit:
    """One exercise of one submission."""

    exercise: str
    status: str
    problem: str
    gradable: bool
    # None if it could not be graded; then `problem` is the instructor's to read.
    points: float | None
    max_points: float
    verdict: Verdict | None


@dataclass(frozen=True)
class Submission:
    id: str
    name: str
    problem: str
    ignored: tuple[str, ...]
    # None if some unit of it has none.
    points: float | None
    max_points: float
    units: tuple[Unit, ...]


@dataclass(frozen=True)
class Measure:
    what: str
    enforced: bool
    how: str


@dataclass(frozen=True)
class Machine:
    level: str
    measures: tuple[Measure, ...]


@dataclass(frozen=True)
class Results:
    """A whole grading. It does not contain the seed of the random cases, which is secret."""

    version: str
    machine: Machine
    exercises: tuple[Exercise, ...]
    submissions: tuple[Submission, ...]

    def exercise(self, id_: str) -> Exercise:
        return next(exercise for exercise in self.exercises if exercise.id == id_)


@functools.cache
def _validator() -> jsonschema.Draft202012Validator:
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    return jsonschema.Draft202012Validator(schema)


def read_results(folder: Path) -> Results:
    """The results in this folder.

    @throws ReportError if there are none or they are not as agreed.
    """
    file = folder / "results.json"
    try:
        document = json.loads(file.read_text(encoding="utf-8"), parse_constant=_refuse)
    except FileNotFoundError:
        raise ReportError(
            f"{file} is not there. Name the folder that `contact grade … -o` wrote."
        ) from None
    except (OSError, ValueError) as error:
        raise ReportError(
            f"{file} cannot be read: {error}. Grade again to write it anew."
        ) from None
    for wrong in _validator().iter_errors(document):
        where = "/".join(str(step) for step in wrong.absolute_path) or "the top"
        raise ReportError(f"{file} is not as agreed at {where}: {clean_line(wrong.message)}")
    return from_document(document)


def _refuse(constant: str) -> float:
    raise ValueError(f"it holds {constant}, which is no number of points or seconds")


def from_document(document: dict[str, Any]) -> Results:
    """What a valid document says."""
    results = Results(
        version=clean_line(document.get("version", "")),
        machine=_machine(document["machine"]),
        exercises=tuple(_exercise(entry) for entry in document["exercises"]),
        submissions=tuple(_submission(entry) for entry in document["submissions"]),
    )
    known = {exercise.id for exercise in results.exercises}
    for submission in results.submissions:
        for unit in submission.units:
            if unit.exercise not in known:
                raise ReportError(
                    f"results.json grades {unit.exercise} for {submission.id},"
                    " but does not list it under exercises"
                )
    return results


def _machine(entry: dict[str, Any]) -> Machine:
    return Machine(
        level=entry["level"],
        measures=tuple(
            Measure(
                clean_line(measure["what"]), measure["enforced"], clean_line(measure.get("how", ""))
            )
            for measure in entry["measures"]
        ),
    )


def _exercise(entry: dict[str, Any]) -> Exercise:
    return Exercise(
        id=clean_line(entry["id"]),
        title=clean_line(entry["title"]),
        objective=clean_line(entry.get("objective", "")),
        max_points=float(entry["max_points"]),
        tests=tuple(
            TestSpec(
                clean_line(test["name"]),
                float(test["points"]),
                test["visibility"],
                bool(test.get("private", False)),
            )
            for test in entry["tests"]
        ),
    )


def _submission(entry: dict[str, Any]) -> Submission:
    return Submission(
        id=clean_line(entry["id"]),
        name=clean_line(entry.get("name", "")),
        problem=clean(entry.get("problem", "")),
        ignored=tuple(clean_line(path) for path in entry.get("ignored", [])),
        points=_mark(entry["points"]),
        max_points=float(entry["max_points"]),
        units=tuple(_unit(unit) for unit in entry["exercises"]),
    )


def _mark(points: float | None) -> float | None:
    return None if points is None else float(points)


def _unit(entry: dict[str, Any]) -> Unit:
    verdict = entry.get("verdict")
    return Unit(
        exercise=clean_line(entry["id"]),
        status=entry["status"],
        problem=clean(entry.get("problem", "")),
        gradable=entry["gradable"],
        points=_mark(entry["points"]),
        max_points=float(entry["max_points"]),
        verdict=_verdict(verdict) if verdict else None,
    )


def _verdict(entry: dict[str, Any]) -> Verdict:
    error = entry.get("compile_error")
    times = entry.get("times") or entry.get("seconds") or {}
    return Verdict(
        outcome=entry["verdict"],
        tests=tuple(_test(test) for test in entry["tests"]),
        diagnostics=tuple(_diagnostic(remark) for remark in entry.get("diagnostics", [])),
        warnings=tuple(clean(warning) for warning in entry.get("warnings", [])),
        output=clean(entry.get("output", "")),
        build_seconds=_seconds(times, "compile") + _seconds(times, "link"),
        run_seconds=_seconds(times, "run"),
        compile_error=_compile_error(error) if error else None,
    )


def _seconds(times: dict[str, Any], of: str) -> float:
    value = times.get(of)
    return float(value) if isinstance(value, int | float) and value > 0 else 0.0


def _test(entry: dict[str, Any]) -> TestResult:
    failure = entry.get("failure")
    return TestResult(
        name=clean_line(entry["name"]),
        status=entry["status"],
        points=float(entry["points"]),
        max_points=float(entry["max_points"]),
        failure=_failure(failure) if failure else None,
        same_as=clean_line(entry.get("same_as", "")),
    )


def _failure(entry: dict[str, Any]) -> Failure:
    return Failure(
        asked=clean(entry.get("asked", "")),
        inputs=tuple(
            (clean_line(value["name"]), clean(value["text"])) for value in entry.get("inputs", [])
        ),
        got=clean(entry.get("got", "")),
        right=clean(entry.get("right", "")),
        allowed=clean(entry.get("allowed", "")),
        misconceptions=tuple(clean_line(id_) for id_ in entry.get("misconceptions", [])),
        hint=clean(entry.get("hint", "")),
        questions=tuple(clean_line(text) for text in entry.get("questions", [])),
        reason=clean(entry.get("reason", "")),
    )


def _diagnostic(entry: dict[str, Any]) -> Diagnostic:
    return Diagnostic(
        line=entry["line"],
        column=entry["column"],
        severity=entry["severity"],
        message=clean(entry["message"]),
        words=clean(entry.get("words", "")),
        mistake=clean_line(entry.get("mistake", "")),
    )


def _compile_error(entry: dict[str, Any]) -> CompileError:
    return CompileError(
        line=entry.get("line", 0),
        column=entry.get("column", 0),
        message=clean(entry.get("message", "")),
        excerpt=clean(entry.get("excerpt", "")),
        explanation=clean(entry.get("explanation", "")),
        contract=tuple(clean(line["text"]) for line in entry.get("contract", [])),
        full=clean(entry.get("full", "")),
    )
