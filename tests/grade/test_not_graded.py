"""A unit that cannot be graded for a reason of ours costs that unit only: all other marks are
written, it is a zero in none of the reports, and the command that is printed grades it alone."""

from __future__ import annotations

import ctypes
import os
import re
import shlex
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, cast

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from graded_class import (
    EXERCISE,
    PROGRAM,
    ROOT,
    SOLUTION,
    WRONG,
    Document,
    Done,
    Grader,
    kill,
    until,
    without_times,
)

STUDENTS = {f"student{i}": SOLUTION if i % 2 else WRONG for i in range(5)}
STRUCK = "student3"
# Far more than a unit takes here, also beside others.
SECONDS = 15
# Reports in which nothing differs from run to run.
SAME_BYTES = ("gradebook.csv", "class.html")
SAME_BYTES_OF_A_STUDENT = ("report.html", "prairielearn.json")


def fill(grader: Grader) -> None:
    for student, text in STUDENTS.items():
        grader.hand_in(student, text)


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> Grader:
    grader = Grader(tmp_path_factory.mktemp("undisturbed") / "class")
    fill(grader)
    grader.grade("--seed", "s")
    grader.clean()
    return grader


def marks(grader: Grader) -> Document:
    """results.json without times and without the limits on which marks do not depend."""
    document = cast("Document", without_times(grader.document()))
    del document["limits"]
    return document


def short_time(grader: Grader, seconds: float = SECONDS) -> list[str]:
    profile = grader.folder / "short time.toml"
    profile.write_text(f"unit_seconds = {seconds}\n")
    return ["--profile", str(profile)]


@contextmanager
def struck(grader: Grader, strike: Callable[[int], object]) -> Iterator[None]:
    """Each worker that begins that student's unit is struck as soon as it has."""
    over = threading.Event()
    threads: list[threading.Thread] = []

    def hunt() -> None:
        hunted: set[int] = set()
        while not over.wait(0.002):
            for line in grader.log():
                pid = int(line[-1].rpartition(":")[2])
                if line[0] == "start" and line[1] == STRUCK and pid not in hunted:
                    hunted.add(pid)
                    threads.append(threading.Thread(target=strike, args=(pid,)))
                    threads[-1].start()

    hunter = threading.Thread(target=hunt)
    hunter.start()
    try:
        yield
    finally:
        over.set()
        hunter.join()
        for thread in threads:
            thread.join()


def command_in(errors: str) -> str:
    found = re.search(r"this grades what is missing and nothing else:\n {2}(.+)\n", errors)
    assert found, errors
    # The script would bring the program up to date first.
    return found[1].replace(shlex.quote(str(ROOT / "contact")), shlex.quote(str(PROGRAM)), 1)


def type_in(grader: Grader, command: str) -> Done:
    return subprocess.run(
        ["sh", "-c", command],
        capture_output=True,
        text=True,
        env=grader.environment(),
        cwd=grader.folder,
        stdin=subprocess.DEVNULL,
        timeout=600,
    )


def held_to(grader: Grader, done: Done, undisturbed: Grader, reason: str) -> None:
    """The complete report on the unit; everything else is as without the failure."""
    assert done.returncode == 3, done.stdout + done.stderr
    assert f"{STRUCK}, {EXERCISE} could not be graded: {reason}" in done.stderr
    assert "4 with a whole mark" in done.stdout
    unit = grader.unit(STRUCK)
    assert unit["status"] == "not_graded"
    assert unit["points"] is None
    assert "verdict" not in unit
    assert unit["problem"].startswith(reason)
    assert grader.submission(STRUCK)["points"] is None
    before = {one["id"]: one for one in marks(undisturbed)["submissions"]}
    for one in marks(grader)["submissions"]:
        assert one["id"] == STRUCK or one == before[one["id"]]
    for student in STUDENTS:
        for name in SAME_BYTES_OF_A_STUDENT:
            file = Path("students") / student / name
            same = (grader.results / file).read_bytes() == (undisturbed.results / file).read_bytes()
            assert same == (student != STRUCK), file
    record = grader.document("run.json")
    assert record["counts"]["not_graded"] == 1

    # And the command grades it, and it alone.
    started = grader.counts("start")
    command = command_in(done.stderr)
    again = type_in(grader, command)
    assert again.returncode == 0, again.stdout + again.stderr
    assert "1 mark moved:" in again.stdout
    (row,) = [line.split() for line in again.stdout.splitlines() if line.strip().startswith(STRUCK)]
    assert row[:4] == [STRUCK, EXERCISE, "none", "8"]
    assert " ".join(row[4:]) == "could not be graded before"
    assert "4 of 5 units are graded already" in again.stderr
    assert grader.counts("start") - started == {STRUCK: 1}
    assert marks(grader) == marks(undisturbed)
    for name in SAME_BYTES:
        assert (grader.results / name).read_bytes() == (undisturbed.results / name).read_bytes()
    for student in STUDENTS:
        for name in SAME_BYTES_OF_A_STUDENT:
            file = Path("students") / student / name
            assert (grader.results / file).read_bytes() == (
                undisturbed.results / file
            ).read_bytes(), file


def test_a_worker_that_is_killed_each_time(grader: Grader, undisturbed: Grader) -> None:
    fill(grader)
    with struck(grader, kill):
        done = grader.run("--seed", "s", "--workers", "2")
    assert grader.counts("start")[STRUCK] == 3
    held_to(grader, done, undisturbed, "signal 9 ended the worker")


def test_a_worker_that_is_stopped(grader: Grader, undisturbed: Grader) -> None:
    fill(grader)
    with struck(grader, lambda pid: os.kill(pid, signal.SIGSTOP)):
        done = grader.run("--seed", "s", "--workers", "2", *short_time(grader))
    assert grader.counts("start")[STRUCK] == 2, "given once more, and not a third time"
    grader.clean()
    held_to(grader, done, undisturbed, f"grading it took longer than the {SECONDS} seconds")


def hang(pid: int, ends: list[int]) -> None:
    """Stops the thread that grades and no other, as an endless loop of ours would; notes how the
    process ends."""
    attach, all_threads = 16, 0x40000000
    ptrace = ctypes.CDLL(None, use_errno=True).ptrace
    ptrace.argtypes = [ctypes.c_long, ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p]
    if ptrace(attach, pid, None, None) != 0:
        ends.append(-ctypes.get_errno())
        return
    while True:
        _, status = os.waitpid(pid, all_threads)
        if not os.WIFSTOPPED(status):
            ends.append(status)
            return


def test_a_worker_ends_itself_if_our_own_code_hangs(grader: Grader, undisturbed: Grader) -> None:
    fill(grader)
    ends: list[int] = []
    with struck(grader, lambda pid: hang(pid, ends)):
        done = grader.run("--seed", "s", "--workers", "2", *short_time(grader))
    if any(end < 0 for end in ends):
        pytest.skip("this machine lets no process be traced")
    assert [os.waitstatus_to_exitcode(end) for end in ends] == [3, 3], "by itself, not by a signal"
    grader.clean()
    held_to(grader, done, undisturbed, f"grading it took longer than the {SECONDS} seconds")


def test_a_text_that_cannot_be_read(grader: Grader, undisturbed: Grader) -> None:
    # Every word of the command that a shell would read otherwise.
    grader.submissions = grader.submissions.rename(grader.folder / "it's *handed* in; $HOME")
    fill(grader)
    process = grader.start("--seed", "s", "--workers", "2")
    kept = grader.results / f".grade/submissions/{STRUCK}/{EXERCISE}.cpp"
    until(kept.is_file)
    kept.unlink()
    kept.mkdir()
    output, errors = process.communicate(timeout=300)
    done = Done(process.args, process.returncode, output, errors)
    assert grader.counts("trouble")[STRUCK] == 3
    held_to(grader, done, undisturbed, f"cannot read {kept}")


def test_what_is_printed_as_json(grader: Grader) -> None:
    grader.hand_in("ada")
    grader.hand_in(STRUCK)
    with struck(grader, kill):
        summary = grader.grade("--seed", "secret", code=3)
    assert summary["not_graded"] == 1
    (trouble,) = summary["could_not_be_graded"]
    assert (trouble["submission"], trouble["exercise"]) == (STRUCK, EXERCISE)
    assert "signal 9" in trouble["problem"]
    assert summary["mean"] == 8, "of those that have a mark"
    assert "secret" not in summary["again"], (
        "the folder keeps its seed, and the class page is shown"
    )
    assert "secret" not in (grader.results / "class.html").read_text()
    page = (grader.results / "class.html").read_text()
    assert STRUCK not in page
    assert grader.grade()["could_not_be_graded"] == []


def test_a_mark_that_is_lost_is_told_and_kept(grader: Grader) -> None:
    """A new submission that cannot be graded does not keep the mark of the earlier one."""
    fill(grader)
    grader.grade("--seed", "s")
    grader.hand_in(STRUCK, WRONG)
    with struck(grader, kill):
        done = grader.run("--seed", "s")
    assert done.returncode == 3
    assert grader.unit(STRUCK)["points"] is None
    (change,) = grader.document("changes.json")["changes"]
    assert (change["submission"], change["before"], change["after"]) == (STRUCK, 8, None)
    assert change["why"] == ["could not be graded"]
    (kept,) = (grader.results / "earlier").iterdir()
    earlier: Any = grader.document(f"earlier/{kept.name}/results.json")
    assert next(one for one in earlier["submissions"] if one["id"] == STRUCK)["points"] == 8


def test_a_solution_that_outlives_its_time_ends_the_run(grader: Grader) -> None:
    grader.hand_in("ada")
    done = grader.run(*short_time(grader, 0.05))
    assert done.returncode == 3
    assert f"the book's own solution of {EXERCISE} cannot be graded here, so nothing is" in (
        done.stderr
    )
    assert "the 0.05 seconds on the clock" in done.stderr
    assert not (grader.results / "results.json").exists()
    # What it left goes with the next run.
    grader.grade()
    assert grader.points() == {"ada": 8}


def test_how_long_a_unit_may_take_follows_from_its_limits(grader: Grader) -> None:
    grader.hand_in("ada")
    times = []
    for text in ("", "wall_extra = 11\n", "compile_cpu_seconds = 31\n", "unit_seconds = 77\n"):
        profile = grader.folder / "profile.toml"
        profile.write_text(text)
        grader.grade("--profile", str(profile))
        run = grader.document(".grade/RUN.json")
        times.append((run["unit_seconds"][EXERCISE], run["test_seconds"][EXERCISE]))
    tests = len(grader.document()["exercises"][0]["tests"])

    def declared(test: float, extra: float = 10, compiler: float = 30) -> float:
        """As docs/grading.md says it."""
        return 3 * (4 * compiler + extra) + 3 * tests * (4 * test + extra + 40) + 120

    assert times[0][0] == pytest.approx(declared(times[0][1]))
    assert times[1][0] == pytest.approx(declared(times[1][1], extra=11))
    assert times[2][0] == pytest.approx(declared(times[2][1], compiler=31))
    assert times[3][0] == 77
    tests = 5
    minutes = round(declared(5) / 60)
    page = " ".join((ROOT / "docs/grading.md").read_text().split())
    assert f"With the book's limits and five tests the limit is {minutes} minutes." in page
