"""Measures the cost of a dilute gas of hard balls, from 1,000 to 1,000,000 balls.

Events, bytes and instructions are the same in every run; times are not. Between two sizes the table
shows the exponent p with which a number grew, as N^p.

    cmake --build --preset release --target scene_growth
    build/venv/bin/python benchmarks/scene_growth.py

Instructions are those of the run only, counted by valgrind, which makes it about 50 times slower;
so they are counted up to 100,000 balls.
"""

from __future__ import annotations

import argparse
import json
import math
import re
import shutil
import subprocess
from pathlib import Path

PROGRAM = Path(__file__).resolve().parent.parent / "build" / "release" / "bin" / "scene_growth"
COLUMNS = ("hits", "cells_crossed", "bytes", "instructions", "processor_s", "clock_s")


def measured(balls: int, seconds: float) -> dict[str, float]:
    """One run."""
    run = subprocess.run(
        [PROGRAM, str(balls), str(seconds)], check=True, capture_output=True, text=True
    )
    values: dict[str, float] = json.loads(run.stdout)
    return values


def instructions(balls: int, seconds: float) -> int:
    """Of the run without what sets it up."""
    run = subprocess.run(
        [
            "valgrind",
            "--tool=callgrind",
            "--callgrind-out-file=/dev/null",
            "--collect-atstart=no",
            "--toggle-collect=run_gas",
            PROGRAM,
            str(balls),
            str(seconds),
        ],
        check=True,
        capture_output=True,
        text=True,
    )
    found = re.search(r"Collected : (\d+)", run.stderr)
    if not found:
        raise SystemExit(f"valgrind counted nothing:\n{run.stderr}")
    return int(found.group(1))


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("--balls", type=int, nargs="+", default=[1000, 10000, 100000, 1000000])
    parser.add_argument("--seconds", type=float, default=10.0, help="that the gas moves")
    parser.add_argument("--counted", type=int, default=100000, help="count instructions up to here")
    options = parser.parse_args()
    if not PROGRAM.exists():
        raise SystemExit(
            f"{PROGRAM} is missing: cmake --build --preset release --target scene_growth"
        )
    counts = shutil.which("valgrind") is not None
    if not counts:
        print("valgrind is missing: instructions are not counted")
    print(f"a dilute gas for {options.seconds:g} s")
    print(f"{'balls':>9}" + "".join(f"{name.replace('_', ' '):>16}" for name in COLUMNS))
    before: dict[str, float] = {}
    for balls in options.balls:
        row = measured(balls, options.seconds)
        if counts and balls <= options.counted:
            row["instructions"] = instructions(balls, options.seconds)
        if before:
            wider = math.log(row["balls"] / before["balls"])
            powers = [
                f"N^{math.log(row[name] / before[name]) / wider:.2f}"
                if row.get(name, 0) > 0 and before.get(name, 0) > 0
                else ""
                for name in COLUMNS
            ]
            print(f"{'':>9}" + "".join(f"{power:>16}" for power in powers))
        cells = [f"{row[name]:.10g}" if name in row else "not counted" for name in COLUMNS]
        print(f"{balls:>9}" + "".join(f"{cell:>16}" for cell in cells), flush=True)
        before = row


if __name__ == "__main__":
    main()
