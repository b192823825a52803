"""Stages of `./contact test` run two at a time, one of each lane, and wait for what they need."""

from __future__ import annotations

import importlib.util
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import lanes  # noqa: E402
import steps  # noqa: E402
from slices import Slice  # noqa: E402
from stages import LATE, Check, Lane, Row, Stage, Tally, result, row_from_json, run_stage  # noqa: E402


def load() -> ModuleType:
    # By its path: Python has a package of that name.
    spec = importlib.util.spec_from_file_location("contact_test", ROOT / "tools" / "test.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.modules["contact_test"] = module
    spec.loader.exec_module(module)
    return module


checks = load()

# A stage of these tests: says when it began and ended, and fails if its name says so.
PROGRAM = """
import json, os, pathlib, sys, time
folder, name, _, row = pathlib.Path(sys.argv[1]), *sys.argv[2:]
(folder / f"{name}.began").write_text(str(time.monotonic()))
if name.startswith("crash"):
    sys.exit("no row")
if name.startswith("meets"):
    # Goes on when the one beside it has begun as well.
    other = folder / "meets_a.began" if name == "meets_b" else folder / "meets_b.began"
    until = time.monotonic() + 20
    while not other.exists() and time.monotonic() < until:
        time.sleep(0.01)
    failed = not other.exists()
else:
    failed = name.startswith("fails")
(folder / f"{name}.ended").write_text(str(time.monotonic()))
tally = {"passed": 1, "failed": int(failed), "names": [name] if failed else []}
pathlib.Path(row).write_text(
    json.dumps({"seconds": 1.0, "used": 2.0, "tally": tally, "slices": {}}))
"""


def nothing() -> Iterator[Check]:
    yield lambda _: Tally()


def stage(name: str, *needs: str, lane: Lane = Lane.COMPILES) -> Stage:
    return Stage(name, "of a test", 1, nothing, needs, lane)


@pytest.fixture(autouse=True)
def logs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(steps, "LOGS", tmp_path)
    monkeypatch.setattr(steps, "ROOT", tmp_path)
    return tmp_path


def run(folder: Path, *stages: Stage) -> dict[str, Row]:
    rows = lanes.run_all(stages, (sys.executable, "-c", PROGRAM, str(folder)))
    assert [row.stage for row in rows] == list(stages)
    return {row.stage.name: row for row in rows}


def moment(folder: Path, name: str) -> float:
    return float((folder / name).read_text())


def test_one_of_each_lane_runs_at_a_time(logs: Path) -> None:
    rows = run(logs, stage("meets_a"), stage("meets_b", lane=Lane.WAITS))
    assert not any(row.tally.failed for row in rows.values())


def test_two_of_one_lane_run_in_their_order(logs: Path) -> None:
    run(logs, stage("first"), stage("second"))
    assert moment(logs, "first.ended") <= moment(logs, "second.began")


def test_a_stage_waits_for_what_it_needs_of_the_other_lane(logs: Path) -> None:
    run(logs, stage("first"), stage("second", "first", lane=Lane.WAITS))
    assert moment(logs, "first.ended") <= moment(logs, "second.began")


def test_a_stage_that_needs_a_failed_one_fails_without_running(logs: Path) -> None:
    rows = run(
        logs,
        stage("fails"),
        stage("second", "fails", lane=Lane.WAITS),
        stage("third", "second"),
        stage("other", lane=Lane.WAITS),
    )
    assert not (logs / "second.began").exists()
    assert rows["second"].tally.why == ["second was not run: it needs fails, which failed"]
    assert rows["third"].tally.failed == 1
    assert rows["other"].tally.failed == 0


def test_a_stage_that_dies_has_failed_and_names_its_log(logs: Path) -> None:
    rows = run(logs, stage("crash"), stage("after"))
    (why,) = rows["crash"].tally.why
    assert "stage-crash.log" in why
    assert rows["after"].tally.passed == 1


def test_a_need_that_comes_later_is_told(logs: Path) -> None:
    with pytest.raises(RuntimeError, match="comes after it"):
        run(logs, stage("first", "second"), stage("second"))


def test_a_row_comes_back_as_it_was() -> None:
    told = Tally(3, 1, 2, ["it failed"], ["some test"], explained=True)
    row = Row(stage("a"), told, 1.5, 2.5, {"figures": Slice(["x"], ["y"])})
    assert row_from_json(row.stage, row.as_json()) == row


def test_who_stops_it_stops_what_its_stages_run(tmp_path: Path) -> None:
    """A stage runs a command in a session of its own; it must not outlive the run."""
    code = f"""
import os, signal, sys
sys.path.insert(0, {str(ROOT / "tools")!r})
import pathlib, lanes, steps
from stages import Lane, Stage
steps.LOGS = pathlib.Path({str(tmp_path)!r})
signal.signal(signal.SIGTERM, signal.default_int_handler)
lanes.run_all([Stage("sleeps", "", 1, lambda: iter(()))], (sys.executable, "-c", {SLEEPS!r}))
"""
    process = subprocess.Popen([sys.executable, "-c", code], cwd=tmp_path)
    number = tmp_path / "number"
    until = time.monotonic() + 20
    while not (number.exists() and number.read_text()):
        assert time.monotonic() < until
        time.sleep(0.02)
    process.terminate()
    process.wait(20)
    assert not lives(int(number.read_text()))


SLEEPS = f"""
import os, pathlib, signal, sys
sys.path.insert(0, {str(ROOT / "tools")!r})
import steps
steps.LOGS = pathlib.Path.cwd()
signal.signal(signal.SIGTERM, signal.default_int_handler)
shell = "echo $$ > number.new && mv number.new number && exec sleep 60"
try:
    steps.run(["sh", "-c", shell], "sleeps", cwd=pathlib.Path.cwd())
except KeyboardInterrupt:
    sys.exit(130)
"""


def lives(process: int) -> bool:
    until = time.monotonic() + 5
    while time.monotonic() < until:
        try:
            os.kill(process, 0)
        except ProcessLookupError:
            return False
        time.sleep(0.05)
    os.kill(process, signal.SIGKILL)
    return True


# --- A run that has only so much time -------------------------------------------------------------


def test_what_may_wait_does_not_begin_when_the_time_of_the_run_is_over(logs: Path) -> None:
    command = (sys.executable, "-c", PROGRAM, str(logs))
    stages = [
        stage("every_run"),
        replace(stage("late"), may_wait=True),
        stage("needs_it", "late", lane=Lane.WAITS),
    ]
    rows = {row.stage.name: row for row in lanes.run_all(stages, command, until=time.monotonic())}
    assert rows["every_run"].tally == Tally(passed=1)
    assert not (logs / "late.began").exists()
    assert rows["late"].tally.why == [f"late was not run: {LATE}"]
    # What needs it is not run either, and has not failed.
    assert rows["needs_it"].tally.why == ["needs_it was not run: it needs late"]
    assert [row.tally.skipped for row in rows.values()] == [0, 1, 1]
    assert [row.tally.failed for row in rows.values()] == [0, 0, 0]


def test_only_what_may_wait_is_told_when_the_run_ends() -> None:
    assert lanes.environment(stage("every_run"), 5.0) == {}
    assert lanes.environment(stage("every_run"), None) == {}
    late = replace(stage("late"), may_wait=True)
    assert lanes.environment(late, 5.0) == {"CONTACT_UNTIL": "5.0"}
    beside = replace(late, low_priority=True)
    assert lanes.environment(beside, 5.0) == {"CONTACT_UNTIL": "5.0", "CONTACT_LOW_PRIORITY": "1"}
    assert lanes.environment(beside, None) == {}


def test_a_command_that_the_end_of_the_run_stops_has_not_failed(
    logs: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CONTACT_SLICES", str(logs / "slices"))
    monkeypatch.setenv("CONTACT_UNTIL", str(time.monotonic() + 0.5))
    never = checks.once("sleeping", ["sleep", "60"], cwd=logs)
    late = Stage("late", "", 1, lambda: iter([never, never]), may_wait=True)
    row = run_stage(late)
    assert row.cut_short
    assert row.tally.failed == 0
    assert row.tally.skipped == 2
    assert row.tally.why[0] == f"not run to its end: sleeping: {LATE}"
    assert result(row) == "not run"


@pytest.mark.parametrize(
    "says",
    [
        "FAILED: CMakeFiles/a.dir/b.cpp.o",
        " 7/47 Test #71: hard_cases_03_polygons .....***Failed    0.11 sec",
        "    not ok 3 - a figure is drawn",
        "...F....                                          [ 40%]",
    ],
)
def test_what_has_failed_before_it_was_stopped_has_failed(
    says: str, logs: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(checks, "ROOT", logs)
    monkeypatch.setenv("CONTACT_SLICES", str(logs / "slices"))
    monkeypatch.setenv("CONTACT_UNTIL", str(time.monotonic() + 1))
    fails = checks.once("fails", ["sh", "-c", 'echo "$0"; sleep 60', says], cwd=logs)
    row = run_stage(Stage("late", "", 1, lambda: iter([fails]), may_wait=True))
    assert row.tally.failed == 1


def test_what_hangs_has_failed_also_at_the_end_of_a_run(
    logs: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CONTACT_UNTIL", str(time.monotonic() - 1))
    log = logs / "a.log"
    assert checks.cut_off("a", steps.Done(None, "", 60.0, log)) is not None
    assert checks.cut_off("a", steps.Done(None, "", checks.HANGS_AFTER + 1, log)) is None


def test_a_stage_that_was_cut_short_does_not_say_that_it_passed() -> None:
    assert result(Row(stage("a"), Tally(passed=1))) == "passed"
    assert result(Row(stage("a"), Tally(passed=1), cut_short=True)) == "cut short"
    assert result(Row(stage("a"), Tally(passed=1, failed=1), cut_short=True)) == "FAILED"


def test_what_fails_before_the_end_of_the_run_has_failed(
    logs: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CONTACT_SLICES", str(logs / "slices"))
    monkeypatch.setenv("CONTACT_UNTIL", str(time.monotonic() + 60))
    monkeypatch.setattr(checks, "ROOT", logs)
    row = run_stage(Stage("a", "", 1, lambda: iter([checks.once("wrong", ["false"], cwd=logs)])))
    assert row.tally.failed == 1
    assert not row.cut_short
