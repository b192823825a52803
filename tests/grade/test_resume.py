"""A grading that is killed at any point continues where it stopped: no unit is graded twice, and
the results are those of an undisturbed run."""

from __future__ import annotations

import os
import signal
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from graded_class import SOLUTION, WRONG, Grader, kill, running_from, until, without_times

STUDENTS = {f"student{i}": SOLUTION if i % 2 else WRONG for i in range(6)}


def fill(grader: Grader) -> None:
    for student, text in STUDENTS.items():
        grader.hand_in(student, text)


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> object:
    grader = Grader(tmp_path_factory.mktemp("undisturbed") / "class")
    fill(grader)
    grader.grade("--seed", "s")
    grader.clean()
    return without_times(grader.document())


def finished_once(grader: Grader) -> None:
    finished = grader.counts("finish")
    assert set(finished) == set(STUDENTS)
    # A worker that is killed between its result and its line in the log has said one line too few.
    assert set(finished.values()) == {1}


@pytest.mark.parametrize("lines", [1, 4, 9])
def test_a_coordinator_that_is_killed(grader: Grader, undisturbed: object, lines: int) -> None:
    fill(grader)
    process = grader.start("--seed", "s", "--workers", "2")
    until(lambda: len(grader.log()) >= lines)
    process.kill()
    process.communicate()
    # Its workers end by themselves, and take their folders with them.
    until(lambda: not running_from(grader.folder), 30)
    until(lambda: not list(grader.temporary.iterdir()), 10)
    before = grader.counts("finish")
    assert sum(before.values()) < len(STUDENTS)
    summary = grader.grade("--seed", "s", "--workers", "2")
    assert summary["units"]["reused"] >= sum(before.values())
    assert summary["units"]["reused"] + summary["units"]["graded"] == len(STUDENTS)
    for student in before:
        assert grader.counts("start")[student] == 1
    finished_once(grader)
    assert without_times(grader.document()) == undisturbed


def test_a_machine_that_stops(grader: Grader, undisturbed: object) -> None:
    """Everything is killed at once, so nothing cleans up but the next run."""
    fill(grader)
    process = grader.start("--seed", "s", "--workers", "2")
    until(lambda: len(grader.log()) >= 6)
    os.kill(process.pid, signal.SIGSTOP)
    for pid in grader.workers():
        kill(pid)
    process.kill()
    process.communicate()
    until(lambda: not running_from(grader.folder), 30)
    assert list(grader.temporary.iterdir())
    before = grader.counts("finish")
    grader.grade("--seed", "s", "--workers", "2")
    for student in before:
        assert grader.counts("start")[student] == 1
    finished_once(grader)
    assert without_times(grader.document()) == undisturbed


def test_a_worker_that_is_killed(grader: Grader, undisturbed: object) -> None:
    fill(grader)
    process = grader.start("--seed", "s", "--workers", "2")
    until(lambda: len(grader.log()) >= 3)
    kill(grader.workers()[0])
    output, errors = process.communicate(timeout=300)
    assert process.returncode == 0, output + errors
    finished_once(grader)
    assert max(grader.counts("start").values()) <= 2
    assert without_times(grader.document()) == undisturbed


def test_ctrl_c_leaves_nothing_but_what_is_graded(grader: Grader, undisturbed: object) -> None:
    fill(grader)
    process = grader.start("--seed", "s", "--workers", "2")
    until(lambda: len(grader.log()) >= 4)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "the same command continues" in errors
    grader.clean()
    assert not (grader.results / "results.json").exists()
    grader.grade("--seed", "s")
    finished_once(grader)
    assert without_times(grader.document()) == undisturbed


def test_a_result_that_was_cut_off_is_graded_again(grader: Grader) -> None:
    fill(grader)
    grader.grade()
    before = without_times(grader.document())
    units = sorted((grader.results / ".grade/units").glob("*/*.json"))
    assert len(units) == len(STUDENTS)
    units[0].write_bytes(units[0].read_bytes()[:100])
    units[1].write_text("")
    units[2].unlink()
    assert grader.grade()["units"] == {"graded": 3, "reused": 3, "alone": 0}
    assert without_times(grader.document()) == before
