"""Runs the stages of ./contact test, two at a time: one that compiles beside one that waits.

Each stage is a process of its own (`tools/test.py --alone STAGE`), with its output in
build/logs/stage-STAGE.log: the output of two stages is not mixed, and the processor time of each is
counted for it alone.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import steps
from stages import LATE, Lane, Row, Stage, Tally, result, row_from_json

TEST = Path(__file__).resolve().parent / "test.py"
# Seconds in which a stage that is stopped ends its own commands.
PATIENCE = 30.0


@dataclass(frozen=True)
class Running:
    stage: Stage
    process: subprocess.Popen[bytes]
    log: Path
    row: Path

    def ended(self) -> Row:
        """Its row; where there is none, what the stage said."""
        try:
            return row_from_json(self.stage, self.row.read_text(encoding="utf-8"))
        except (OSError, ValueError, KeyError, TypeError):
            why = (
                f"{self.stage.name} ended with {self.process.returncode} before it could say what "
                f"it found; all of it: {self.log.relative_to(steps.ROOT)}"
            )
            return Row(self.stage, Tally(failed=1, why=[why], names=[why]))


def environment(stage: Stage, until: float | None) -> dict[str, str]:
    """What tools/steps.py reads: until when the stage may run, and whether at a low priority."""
    extra = {}
    if stage.may_wait and until is not None:
        extra["CONTACT_UNTIL"] = str(until)
        if stage.low_priority:
            extra["CONTACT_LOW_PRIORITY"] = "1"
    return extra


def start(stage: Stage, command: Sequence[str], until: float | None = None) -> Running:
    log, row, slices = (
        steps.LOGS / f"stage-{stage.name}.{kind}" for kind in ("log", "json", "slices")
    )
    for file in (row, slices):
        file.unlink(missing_ok=True)
    with log.open("wb") as output:
        process = subprocess.Popen(
            [*command, stage.name, "--row", str(row)],
            env={**os.environ, "CONTACT_SLICES": str(slices), **environment(stage, until)},
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
    return Running(stage, process, log, row)


def next_in(lane: Lane, waiting: Sequence[Stage], unfinished: set[str]) -> Stage | None:
    """The first stage of this lane whose needs have ended; the order within a lane is kept."""
    for stage in waiting:
        if stage.lane is lane:
            return None if unfinished.intersection(stage.needs) else stage
    return None


def run_all(
    stages: Sequence[Stage],
    command: Sequence[str] = (sys.executable, str(TEST), "--alone"),
    until: float | None = None,
) -> list[Row]:
    """Their rows, in the order of `stages`. One that needs a failed one fails without running.

    `until`: the moment, of time.monotonic(), from which on nothing begins that may wait.
    """
    rows: dict[str, Row] = {}
    running: dict[Lane, Running] = {}
    try:
        while len(rows) < len(stages):
            for lane in Lane:
                if lane not in running:
                    start_next(lane, stages, rows, running, command, until)
            if not running and len(rows) < len(stages):
                raise RuntimeError("a stage needs one that comes after it")
            ended = [lane for lane, one in running.items() if one.process.poll() is not None]
            for lane in ended:
                one = running.pop(lane)
                rows[one.stage.name] = one.ended()
                tell(one, rows[one.stage.name])
            if running and not ended:
                time.sleep(0.05)
    except BaseException:
        stop(running)
        raise
    return [rows[stage.name] for stage in stages]


def start_next(
    lane: Lane,
    stages: Sequence[Stage],
    rows: dict[str, Row],
    running: dict[Lane, Running],
    command: Sequence[str],
    until: float | None,
) -> None:
    begun = rows.keys() | {one.stage.name for one in running.values()}
    waiting = [stage for stage in stages if stage.name not in begun]
    unfinished = {stage.name for stage in stages} - rows.keys()
    while stage := next_in(lane, waiting, unfinished):
        failed = [need for need in stage.needs if need in rows and rows[need].tally.failed]
        missing = [need for need in stage.needs if need in rows and rows[need].cut_short]
        over = stage.may_wait and until is not None and time.monotonic() >= until
        if not failed and not missing and not over:
            print(f"{stage.name}: {stage.what}")
            running[lane] = start(stage, command, until)
            return
        if failed:
            why = f"{stage.name} was not run: it needs {failed[0]}, which failed"
            rows[stage.name] = Row(stage, Tally(failed=1, why=[why], names=[why]))
        else:
            why = f"{stage.name} was not run: {'it needs ' + missing[0] if missing else LATE}"
            rows[stage.name] = Row(stage, Tally(skipped=1, why=[why]), cut_short=True)
        print(f"    {why}")
        waiting.remove(stage)
        unfinished.remove(stage.name)


def tell(one: Running, row: Row) -> None:
    print(one.log.read_text(encoding="utf-8", errors="replace"), end="")
    for why in row.tally.why:
        print("\n".join(f"    {line}" for line in why.splitlines()))
    counts = f"{row.tally.passed} passed, {row.tally.failed} failed, {row.tally.skipped} skipped"
    print(f"{row.stage.name}: {result(row)} in {row.seconds:.0f} s ({counts})")


def stop(running: Mapping[Lane, Running]) -> None:
    """Asks all of them to end their commands; what does not listen is ended with its group."""
    for one in running.values():
        one.process.send_signal(signal.SIGTERM)
    until = time.monotonic() + PATIENCE
    for one in running.values():
        try:
            one.process.wait(max(0.1, until - time.monotonic()))
        except subprocess.TimeoutExpired:
            steps.stop(one.process)
