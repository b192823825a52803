"""gradebook.csv: one row a student, a column an exercise, for spreadsheets and learning systems.

    id            as the submission is called
    name          if the list of identifiers has one
    NN_slug/NAME  points in that exercise, one column each; empty if it could not be graded
    total         the sum; empty if something could not be graded, so that nothing imports a zero
    max_points    what could be had
    remarks       what was refused or could not be graded, and why
    not_enforced  what the machine could not enforce; empty if it enforced everything

UTF-8 without a byte order mark, commas, every cell quoted, lines end with CR LF (RFC 4180). A cell
that a spreadsheet would read as a formula gets an apostrophe before it.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Mapping, Sequence

from reports.visibility import NOT_GRADED, SeenSubmission, SeenUnit
from reports.words import points_text

# What begins a formula, at the start of a cell or behind what another locale takes for its end.
_FORMULA = re.compile(r"(?:^|(?<=[,;|\t\"']))(\s*)(?=[=+\-@\t\r＝＋－＠−])")


def gradebook(
    submissions: Sequence[SeenSubmission],
    exercises: Sequence[str],
    reasons: Mapping[tuple[str, str], str],
) -> str:
    """The whole file. `reasons` says, by submission and exercise, why something is not graded."""
    text = io.StringIO()
    writer = csv.writer(text, quoting=csv.QUOTE_ALL, lineterminator="\r\n")
    header = ["id", "name", *exercises, "total", "max_points", "remarks", "not_enforced"]
    writer.writerow(header)
    for submission in submissions:
        units = {unit.exercise.id: unit for unit in submission.units}
        writer.writerow(
            [
                defused(submission.id),
                defused(submission.name),
                *(_cell(units[one].points) if one in units else "" for one in exercises),
                _cell(submission.points),
                points_text(submission.max_points),
                defused("; ".join(_remarks(submission, reasons))),
                defused("; ".join(submission.not_enforced)),
            ]
        )
    return text.getvalue()


def _cell(points: float | None) -> str:
    return "" if points is None else points_text(points)


def defused(cell: str) -> str:
    """One line of text that no spreadsheet takes for a formula."""
    one_line = " ".join(cell.split("\n"))
    return _FORMULA.sub(r"'\1", one_line)


def _remarks(submission: SeenSubmission, reasons: Mapping[tuple[str, str], str]) -> list[str]:
    if submission.problem:
        return [f"refused: {submission.problem}"]
    remarks = [
        _remark(unit, reasons.get((submission.id, unit.exercise.id), ""))
        for unit in submission.units
    ]
    if submission.ignored:
        remarks.append(f"{len(submission.ignored)} files answer to no exercise")
    return [remark for remark in remarks if remark]


def _remark(unit: SeenUnit, reason: str) -> str:
    if unit.status == NOT_GRADED:
        return f"{unit.exercise.id} could not be graded and has no mark: {reason}"
    if unit.status == "refused":
        return f"{unit.exercise.id} refused: {unit.problem}"
    if unit.status == "missing":
        return f"{unit.exercise.id} not handed in"
    if unit.outcome == "does_not_compile":
        return f"{unit.exercise.id} does not compile"
    return ""
