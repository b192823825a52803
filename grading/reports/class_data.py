"""The counts on the class page. They contain no name, no id and no line of a student's code.

Only what a student may see is counted test by test, since the page is made to be projected.
"""

from __future__ import annotations

import os
import re
import statistics
import tomllib
from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from reports.mistakes import MISTAKES, OTHER
from reports.results import Exercise
from reports.visibility import NOT_GRADED, SeenSubmission, SeenUnit
from reports.words import unit_state

# The states of an exercise, best first, in the order of its bar.
STATES = (
    "passed",
    "failed",
    "does_not_compile",
    "refused",
    "not_attempted",
    "untouched",
    "missing",
)
# Replaces a reason that names a student.
UNTOLD = "results.json and gradebook.csv say why"
BINS = 10
MAX_TROUBLES = 5
# A misconception is mentioned if at least this share of those who fail a test has it.
WORTH_SAYING = 0.2


@dataclass
class TestRow:
    name: str
    passed: int = 0
    wrong: int = 0  # failed or stopped
    untried: int = 0  # not attempted, skipped, or never run
    misconceptions: Counter[str] = field(default_factory=Counter)

    @property
    def students(self) -> int:
        return self.passed + self.wrong + self.untried


@dataclass
class ExerciseRow:
    exercise: Exercise
    states: Counter[str] = field(default_factory=Counter)
    points: list[float] = field(default_factory=list)
    tests: dict[str, TestRow] = field(default_factory=dict)
    later: list[str] = field(default_factory=list)
    hidden_points: float = 0.0
    hidden_most: float = 0.0
    # Units that could not be graded. Nothing else here counts them.
    not_graded: int = 0
    reasons: Counter[str] = field(default_factory=Counter)
    mistakes: Counter[str] = field(default_factory=Counter)

    @property
    def unknown(self) -> bool:
        """Nothing of it could be graded."""
        return bool(self.not_graded) and not self.points

    @property
    def mean(self) -> float:
        return statistics.fmean(self.points) if self.points else 0.0

    @property
    def share(self) -> float:
        return self.mean / self.exercise.max_points if self.exercise.max_points else 0.0

    @property
    def hidden_share(self) -> float:
        return self.hidden_points / self.hidden_most


@dataclass
class Misconception:
    id: str
    summary: str
    hint: str
    students: int
    where: list[str]


@dataclass
class Mistake:
    words: str
    files: int
    students: int
    where: list[str]


@dataclass
class Trouble:
    """A test that many fail, and what most of them believe."""

    exercise: Exercise
    test: TestRow
    misconception: Misconception | None
    of_them: int


@dataclass
class ClassData:
    students: int
    refused: int
    shares: list[float]
    bins: list[int]
    rows: list[ExerciseRow]
    troubles: list[Trouble]
    misconceptions: list[Misconception]
    mistakes: list[Mistake]
    uncompiled_students: int
    full_marks: int
    max_points: float
    not_enforced: tuple[str, ...]

    @property
    def not_graded(self) -> list[ExerciseRow]:
        """The exercises of which something could not be graded."""
        return [row for row in self.rows if row.not_graded]

    @property
    def weakest(self) -> list[ExerciseRow]:
        """The exercises, fewest points first; last those of which nothing is known."""
        return sorted(self.rows, key=lambda row: (row.unknown, row.share, row.exercise.id))

    @property
    def refused_exercises(self) -> int:
        """How many files were refused, or would have been in a submission that was."""
        return sum(row.states["refused"] for row in self.rows)

    @property
    def median(self) -> float:
        return statistics.median(self.shares) if self.shares else 0.0


def class_data(
    submissions: Sequence[SeenSubmission],
    exercises: Sequence[Exercise],
    not_enforced: tuple[str, ...],
    reasons: Mapping[tuple[str, str], str],
) -> ClassData:
    """Counts over all submissions. `reasons` says, by submission and exercise, why something could
    not be graded."""
    book = book_of_misconceptions()
    rows = {exercise.id: ExerciseRow(exercise) for exercise in exercises}
    believed: dict[str, set[int]] = defaultdict(set)
    hints: dict[str, str] = {}
    believed_in: dict[str, set[str]] = defaultdict(set)
    mistaken: dict[str, list[int]] = defaultdict(list)
    mistaken_in: dict[str, set[str]] = defaultdict(set)
    for number, submission in enumerate(submissions):
        for unit in submission.units:
            row = rows[unit.exercise.id]
            if unit.status == NOT_GRADED:
                row.not_graded += 1
                reason = reasons.get((submission.id, unit.exercise.id), "")
                row.reasons[reason if nameless(reason, submissions) else UNTOLD] += 1
                continue
            _count(row, unit)
            for test in unit.tests:
                failure = test.failure
                if failure and failure.known:
                    believed[failure.known].add(number)
                    believed_in[failure.known].add(unit.exercise.title)
                    hints.setdefault(failure.known, failure.hint)
            if unit.outcome == "does_not_compile":
                words = _mistake(unit)
                row.mistakes[words] += 1
                mistaken[words].append(number)
                mistaken_in[words].add(unit.exercise.title)
    misconceptions = [
        Misconception(
            id=id_,
            summary=book.get(id_, ("", ""))[0] or id_.replace("-", " "),
            hint=book.get(id_, ("", ""))[1] or hints[id_],
            students=len(who),
            where=sorted(believed_in[id_]),
        )
        for id_, who in believed.items()
    ]
    misconceptions.sort(key=lambda one: (-one.students, one.id))
    mistakes = [
        Mistake(words, len(who), len(set(who)), sorted(mistaken_in[words]))
        for words, who in mistaken.items()
    ]
    mistakes.sort(key=lambda one: (one.words == OTHER, -one.files, one.words))
    shares = [
        one.points / one.max_points if one.max_points else 0.0
        for one in submissions
        if one.points is not None
    ]
    ordered = [rows[exercise.id] for exercise in exercises]
    return ClassData(
        students=len(submissions),
        refused=sum(bool(one.problem) for one in submissions),
        shares=shares,
        bins=_bins(shares),
        rows=ordered,
        troubles=_troubles(ordered, {one.id: one for one in misconceptions}),
        misconceptions=misconceptions,
        mistakes=mistakes,
        uncompiled_students=len({one for who in mistaken.values() for one in who}),
        full_marks=sum(share >= 1.0 for share in shares),
        max_points=max((one.max_points for one in submissions), default=0.0),
        not_enforced=not_enforced,
    )


def nameless(text: str, submissions: Sequence[SeenSubmission]) -> bool:
    """Whether a text of the grader's names no student."""
    words = set(re.split(r"[^\w.@+~-]+", text.casefold()))
    for one in submissions:
        names = [one.id, *one.name.split()]
        if any(name.casefold() in words or (len(name) > 3 and name in text) for name in names):
            return False
    return True


def book_of_misconceptions() -> dict[str, tuple[str, str]]:
    """The misconceptions of the book, and of the pack that is graded: id to summary and hint."""
    root = Path(os.environ.get("CONTACT_ROOT") or Path(__file__).resolve().parents[2])
    found: dict[str, tuple[str, str]] = {}
    for folder in (root, Path(os.environ.get("CONTACT_PACK") or root)):
        file = folder / "chapters" / "misconceptions.toml"
        if not file.is_file():
            continue
        table = tomllib.loads(file.read_text(encoding="utf-8"))
        for id_, entry in table.items():
            if isinstance(entry, dict):
                found[id_] = (str(entry.get("summary", "")), str(entry.get("hint", "")))
    return found


def _count(row: ExerciseRow, unit: SeenUnit) -> None:
    row.states[unit_state(unit)] += 1
    row.points.append(unit.points or 0.0)
    if unit.hidden:
        row.hidden_points += unit.hidden.points
        row.hidden_most += unit.hidden.max_points
    ran = unit.status == "graded" and unit.outcome != "does_not_compile"
    for test in unit.tests:
        if test.status is None:
            if test.name not in row.later:
                row.later.append(test.name)
            continue
        counted = row.tests.setdefault(test.name, TestRow(test.name))
        if not ran or test.status in ("not_attempted", "skipped"):
            counted.untried += 1
        elif test.status == "passed":
            counted.passed += 1
        else:
            counted.wrong += 1
            if test.failure and test.failure.known:
                counted.misconceptions[test.failure.known] += 1


def _mistake(unit: SeenUnit) -> str:
    errors = [remark for remark in unit.diagnostics if remark.severity == "error"]
    for remark in errors[:1]:
        return MISTAKES.get(remark.mistake, OTHER)
    return OTHER


def _bins(shares: Sequence[float]) -> list[int]:
    bins = [0] * BINS
    for share in shares:
        bins[min(BINS - 1, int(share * BINS))] += 1
    return bins


def _troubles(
    rows: Sequence[ExerciseRow], misconceptions: dict[str, Misconception]
) -> list[Trouble]:
    found = []
    for row in rows:
        for test in row.tests.values():
            if test.wrong == 0:
                continue
            id_, count = max(test.misconceptions.items(), key=lambda one: one[1], default=("", 0))
            worth = count >= max(2, WORTH_SAYING * test.wrong)
            found.append(Trouble(row.exercise, test, misconceptions[id_] if worth else None, count))
    found.sort(key=lambda one: (-one.test.wrong, one.exercise.id, one.test.name))
    return _distinct(found)[:MAX_TROUBLES]


def _distinct(troubles: Sequence[Trouble]) -> list[Trouble]:
    """Without those that an earlier one of the same exercise explains already."""
    told: set[tuple[str, str | None]] = set()
    kept = []
    for trouble in troubles:
        key = (trouble.exercise.id, trouble.misconception.id if trouble.misconception else None)
        if key not in told:
            kept.append(trouble)
        told.add(key)
    return kept
