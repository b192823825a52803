"""Writes every report into RESULTS, each file completely and then renamed into place."""

from __future__ import annotations

import contextlib
import json
import os
from collections.abc import Sequence
from dataclasses import replace
from datetime import datetime
from pathlib import Path

from reports.class_data import class_data, nameless
from reports.class_page import class_page
from reports.classroom50 import classroom50
from reports.folders import folder_name, put_away
from reports.gradebook import gradebook
from reports.gradescope import gradescope
from reports.junit import junit
from reports.prairielearn import prairielearn
from reports.results import ReportError, Results, Submission
from reports.student_page import student_page
from reports.visibility import NOT_GRADED, Policy, not_enforced, see

# Each with the file it makes, in the student's folder or in RESULTS.
FORMATS = {
    "gradescope": "gradescope.json",
    "prairielearn": "prairielearn.json",
    "classroom50": "classroom50.json",
    "junit": "junit.xml",
    "html": "report.html",
    "gradebook": "gradebook.csv",
    "class": "class.html",
}


def write_reports(
    results: Results,
    folder: Path,
    formats: Sequence[str],
    due: datetime | None,
    now: datetime,
    again: str = "",
) -> int:
    """Writes these formats; returns how many files that were. `again` is the command that grades
    what could not be."""
    policy = Policy(due, now)
    folders = _folders(results.submissions)
    put_away(folder, folders.values())
    written = 0
    seen = [see(submission, results, policy) for submission in results.submissions]
    for submission, shown in zip(results.submissions, seen, strict=True):
        here = folder / "students" / folders[submission.id]
        texts: dict[str, str] = {}
        if "gradescope" in formats:
            waiting = see(submission, results, replace(policy, host_waits=True))
            texts["gradescope"] = _json(gradescope(waiting))
        if "prairielearn" in formats:
            texts["prairielearn"] = _json(prairielearn(shown))
        if "classroom50" in formats:
            if shown.not_graded:
                # There is no result without a score, and one of an earlier run is none of this.
                (here / FORMATS["classroom50"]).unlink(missing_ok=True)
            else:
                texts["classroom50"] = _json(classroom50(shown, os.environ, now))
        if "junit" in formats:
            texts["junit"] = junit(shown)
        if "html" in formats:
            texts["html"] = student_page(shown)
        for name, text in texts.items():
            _write(here / FORMATS[name], text)
        written += len(texts)
    reasons = {
        (one.id, unit.exercise): unit.problem
        for one in results.submissions
        for unit in one.units
        if unit.status == NOT_GRADED
    }
    if "gradebook" in formats:
        text = gradebook(seen, [exercise.id for exercise in results.exercises], reasons)
        _write(folder / FORMATS["gradebook"], text)
        written += 1
    if "class" in formats:
        data = class_data(seen, results.exercises, not_enforced(results.machine), reasons)
        told = again if nameless(again, seen) else ""
        _write(folder / FORMATS["class"], class_page(data, told))
        written += 1
    return written


def _folders(submissions: Sequence[Submission]) -> dict[str, str]:
    folders: dict[str, str] = {}
    for submission in submissions:
        if submission.id in folders:
            raise ReportError(f"results.json holds two submissions called {submission.id}")
        folders[submission.id] = folder_name(submission.id)
    return folders


def _json(document: object) -> str:
    return json.dumps(document, ensure_ascii=False, indent=1) + "\n"


def _write(file: Path, text: str) -> None:
    beside = file.with_name(f".{file.name}.{os.getpid()}")
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        beside.write_text(text, encoding="utf-8", newline="")
        beside.replace(file)
    except OSError as error:
        # A full disk names no file, and half a report is not to be passed on.
        with contextlib.suppress(OSError):
            beside.unlink()
        raise ReportError(
            f"{file} cannot be written: {error.strerror}."
            " Put that right and run the same command again."
        ) from None
