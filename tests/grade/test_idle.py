"""A submission that only waits is stopped soon, whatever else the machine does; one that waits for
a core is not."""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build" / "dev" / "bin" / "contact"
HOSTILE = ROOT / "tests" / "grade" / "hostile"
EXERCISE = "01_planes/signed_distance"
WAITED = (
    "waited for {} in all and did nothing: a sleep, a lock that it holds itself, or a read of "
    "something that never comes"
)

Result = dict[str, Any]


def hostile(name: str) -> Path:
    return HOSTILE / f"{name}.cpp"


def grade(*files: Path, profile: Path | None = None) -> list[Result]:
    limits = [] if profile is None else ["--profile", str(profile)]
    words = ["dev", "grade-unit", "--as-built", "--json", "--exercise", EXERCISE, *limits]
    done = subprocess.run(
        [str(PROGRAM), *words, *map(str, files)],
        capture_output=True,
        text=True,
        env={**os.environ, "CONTACT_ROOT": str(ROOT)},
        stdin=subprocess.DEVNULL,
        timeout=600,
    )
    assert done.returncode in (0, 1), done.stderr
    results: list[Result] = json.loads(done.stdout)["results"]
    return results


@contextlib.contextmanager
def busy_core(count: int = 6) -> Iterator[None]:
    """One core for all that is started here, and others that never give it up."""
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {max(cores)})
    # Each in a session of its own, to which many kernels give a share of its own.
    loop = ["sh", "-c", "while :; do :; done"]
    busy = [subprocess.Popen(loop, start_new_session=True) for _ in range(count)]
    try:
        yield
    finally:
        for process in busy:
            process.kill()
            process.wait()
        os.sched_setaffinity(0, cores)


def ends(result: Result) -> list[tuple[str, str]]:
    return [(test["status"], test.get("failure", {}).get("reason", "")) for test in result["tests"]]


def test_verdicts_do_not_depend_on_what_else_the_machine_does() -> None:
    names = ("sleeper", "naps_before_answers", "slow_but_right", "sleeps_when_it_ends")
    files = [hostile(name) for name in names]
    alone = grade(*files)
    with busy_core():
        beside = grade(*files)
    passed, stopped = ("passed", ""), ("stopped", WAITED.format("1 second"))
    one_stopped = [passed] * 3 + [stopped] + [passed] * 2
    expected = [one_stopped, [passed] * 6, [passed] * 6, one_stopped]
    assert [ends(result) for result in alone] == expected
    assert [ends(result) for result in beside] == expected
    # Nothing of this is near a limit, so that none is run again.
    assert not any(result["near_limit"] for result in alone)
    assert not any(result["near_limit"] for result in beside)
    # It was in want of a core for more than a second in all, in each test for long.
    worked = sum(test["seconds"] for test in beside[2]["tests"])
    assert beside[2]["seconds"]["run"] > 3 * worked


def test_who_answers_at_once_is_never_idle(tmp_path: Path) -> None:
    """However often tests and answers wait for each other, and for a core."""
    profile = tmp_path / "profile.toml"
    profile.write_text("idle_seconds = 0.1\n")
    with busy_core(count=3):
        results = grade(
            *[ROOT / "solutions" / EXERCISE / "signed_distance.cpp"] * 3, profile=profile
        )
    assert [result["verdict"] for result in results] == ["passed"] * 3


def test_once_some_tests_have_waited_the_others_may_only_a_little(tmp_path: Path) -> None:
    profile = tmp_path / "profile.toml"
    profile.write_text("idle_seconds = 0.4\nidle_seconds_in_all = 0.8\n")
    (result,) = grade(hostile("sleeps_before_main"), profile=profile)
    long, short = WAITED.format("0.4 seconds"), WAITED.format("0.04 seconds")
    assert ends(result) == [("stopped", long)] * 2 + [("stopped", short)] * 4
    assert not result["near_limit"]


def test_whoever_must_wait_is_given_the_time(tmp_path: Path) -> None:
    profile = tmp_path / "profile.toml"
    profile.write_text("idle_seconds = 0.1\n")
    (result,) = grade(hostile("naps_before_answers"), profile=profile)
    assert ("stopped", WAITED.format("0.1 seconds")) in ends(result)
    profile.write_text("idle_seconds = 30\n")
    (result,) = grade(hostile("naps_before_answers"), profile=profile)
    assert result["verdict"] == "passed"


@pytest.mark.parametrize("workers", ["1", "3"])
def test_a_sleeper_is_graded_once(workers: str, tmp_path: Path) -> None:
    for student in ("ada", "bo", "cy"):
        file = tmp_path / "class" / student / f"{EXERCISE}.cpp"
        file.parent.mkdir(parents=True)
        file.write_text((HOSTILE / "sleeper.cpp").read_text())
    words = ["grade", str(tmp_path / "class"), "-o", str(tmp_path / "marks"), "--json"]
    done = subprocess.run(
        [str(PROGRAM), *words, "--exercises", EXERCISE, "--workers", workers],
        capture_output=True,
        text=True,
        env={**os.environ, "CONTACT_ROOT": str(ROOT)},
        stdin=subprocess.DEVNULL,
        timeout=600,
    )
    assert done.returncode == 0, done.stderr
    units = [json.loads(file.read_text()) for file in (tmp_path / "marks").glob(".grade/units/*/*")]
    assert [unit["verdict"]["points"] for unit in units] == [7] * 3
    assert [unit["reruns"] for unit in units] == [0] * 3
    assert all(unit["seconds"] < 10 for unit in units)
