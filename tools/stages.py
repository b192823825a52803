"""What a stage of ./contact test is, how one runs, and the table of all of them."""

from __future__ import annotations

import json
import os
import resource
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, field
from enum import Enum
from pathlib import Path
from typing import Any

import steps
from sample import chapters_asked_for, turn
from slices import Slice, read_slices, slice_in_words


@dataclass
class Tally:
    """What a check found: counts, and for what failed or was not run, why."""

    passed: int = 0
    failed: int = 0
    skipped: int = 0
    why: list[str] = field(default_factory=list)
    names: list[str] = field(default_factory=list)  # of what failed
    explained: bool = False  # `why` says what failed, so nobody has to read the output for it

    def add(self, other: Tally) -> None:
        self.passed += other.passed
        self.failed += other.failed
        self.skipped += other.skipped
        self.why += other.why
        self.names += other.names


Check = Callable[[float], Tally]  # takes the seconds that are left

# Why something was not run, if $CONTACT_MINUTES said how long the run may take.
LATE = "the time of this run was over"


class Lane(Enum):
    """One stage of each lane runs at a time, so two cores always have something to do."""

    COMPILES = "compiles"  # keeps both cores busy by itself
    WAITS = "waits"  # for time limits, sleeping programs and a browser: about half its time


@dataclass(frozen=True)
class Stage:
    name: str
    what: str
    minutes: float  # a stage is stopped there, and has failed
    checks: Callable[[], Iterator[Check]]
    needs: tuple[str, ...] = ()
    lane: Lane = Lane.COMPILES
    # When the minutes that a run has are over, it does not begin, or is stopped: not a failure.
    may_wait: bool = False
    # In a run with such an end, what runs beside it has a processor first.
    low_priority: bool = False
    # Of what an earlier stage has begun, there may be nothing left.
    may_be_empty: bool = False


@dataclass
class Row:
    """What a stage found, how long it took on the clock and of processors, and what it left out."""

    stage: Stage
    tally: Tally
    seconds: float = 0.0
    used: float = 0.0
    slices: dict[str, Slice] = field(default_factory=dict)
    cut_short: bool = False  # by the end of the run: what it was to build may not be there

    def as_json(self) -> str:
        said = {name: getattr(self, name) for name in ("seconds", "used", "cut_short")}
        slices = {what: asdict(of) for what, of in self.slices.items()}
        return json.dumps({**said, "tally": asdict(self.tally), "slices": slices})


def row_from_json(stage: Stage, text: str) -> Row:
    said: dict[str, Any] = json.loads(text)
    slices = {what: Slice(**of) for what, of in said["slices"].items()}
    times = (said["seconds"], said["used"])
    return Row(stage, Tally(**said["tally"]), *times, slices, said.get("cut_short", False))


def processor_seconds() -> float:
    """What all commands that have ended took of processors."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run_stage(stage: Stage) -> Row:
    """Runs its checks, one after the other, in this process."""
    began = time.monotonic()
    used = processor_seconds()
    tally = Tally()
    try:
        for check in stage.checks():
            left = stage.minutes * 60 - (time.monotonic() - began)
            if steps.run_is_over():
                tally.add(Tally(skipped=1, why=[f"not run: the rest of {stage.name}: {LATE}"]))
                break
            if left <= 0:
                why = f"no time was left of {stage.minutes:g} minutes"
                tally.add(Tally(failed=1, why=[why], names=[f"{stage.name}: {why}"]))
                break
            tally.add(check(left))
    except OSError as error:
        why = f"{stage.name}: {error}"
        tally.add(Tally(failed=1, why=[why], names=[why]))
    # A chapter by itself may have no ladder, or no exercise.
    nothing = tally.passed + tally.failed + tally.skipped == 0
    if nothing and not stage.may_be_empty and not chapters_asked_for():
        why = f"{stage.name} found nothing to check"
        tally.add(Tally(failed=1, why=[why], names=[why]))
    slices = read_slices(Path(os.environ["CONTACT_SLICES"]))
    # What waits for another turn was not run.
    tally.skipped += sum(len(of.left) for of in slices.values())
    times = (time.monotonic() - began, processor_seconds() - used)
    return Row(stage, tally, *times, slices, steps.run_is_over())


def result(row: Row) -> str:
    if row.tally.failed:
        return "FAILED"
    if not row.tally.passed:
        return "not run"
    return "cut short" if row.cut_short else "passed"


def closing_table(rows: Sequence[Row], clock: float, limit: float) -> Tally:
    """Prints what each stage took, what went by turns, what failed, and last the sum.

    `clock`: the seconds that all of them took together; `limit`: what they are meant to stay under.
    """
    total = Tally()
    head = ("stage", "seconds", "cpu", "limit", "passed", "failed", "skipped")
    line = "{:13} {:>8} {:>8} {:>6} {:>7} {:>7} {:>8}  {}"
    print("\n" + line.format(*head, "result"))
    for row in rows:
        total.add(row.tally)
        numbers = (row.tally.passed, row.tally.failed, row.tally.skipped)
        times = (f"{row.seconds:.1f}", f"{row.used:.1f}", int(row.stage.minutes * 60))
        print(line.format(row.stage.name, *times, *numbers, result(row)))
    processors = sum(row.used for row in rows)
    print(f"{'all':10} {clock:8.1f} {processors:8.1f} {limit:6.0f}\n")
    if any(row.slices for row in rows):
        print(f"What goes by turns, in turn {turn()}; what did not run is counted as skipped:")
        for row in rows:
            for what, of in row.slices.items():
                print(slice_in_words(what, of))
            if row.slices and row.cut_short:
                print(f"  (of these, {row.stage.name} did not reach the end)")
        print()
    if late := [row.stage.name for row in rows if row.cut_short]:
        print(f"Not run, or not to the end, because the run's time was over: {', '.join(late)}\n")
    for name in total.names:
        print(f"failed: {name}")
    print(f"{total.passed} passed, {total.failed} failed, {total.skipped} skipped")
    return total
