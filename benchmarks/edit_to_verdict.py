"""Measures the time from a save to its verdict in `contact watch`, compared with a lower bound.

    build/venv/bin/python benchmarks/edit_to_verdict.py [--repeats 25] [--json FILE]

Three measurements alternate, so that other work on the machine affects all of them equally:

  edit to verdict  the solution of ray_triangle is saved by rename into a folder that `contact
                   watch` watches, until the line with the verdict is read from its output
  the floor        plain commands: compile that one file with the precompiled header, link it with
                   the compiled tests, run
  two full files   compile the student's file without the precompiled header and the tests' file,
                   link both with Catch2, run: what a plain Makefile would do

Each run changes a comment, so that no two files are the same. Medians and quartiles are printed;
the ratio is the median over pairs of neighbouring runs.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import IO

ROOT = Path(__file__).resolve().parents[1]
BUILD = ROOT / "build" / "dev"
PROGRAM = BUILD / "bin" / "contact"
EXERCISE = "02_triangles/ray_triangle"
SOLUTION = ROOT / "solutions" / EXERCISE / "ray_triangle.cpp"
MOST = 1.25


def run(*command: str | Path) -> None:
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} failed:\n{done.stdout}{done.stderr}")


def edited(turn: int) -> str:
    return SOLUTION.read_text() + f"\n// edit {turn}\n"


class Floor:
    """Plain commands, from the same description that the program reads."""

    def __init__(self, folder: Path) -> None:
        build = json.loads((BUILD / "exercises.json").read_text())
        exercise = build["exercises"][EXERCISE]
        includes = [f"-I{place}" for place in (*build["include"], *exercise["include"])]
        self.folder = folder
        self.compile = [build["compiler"], *build["compile_flags"]]
        self.prelude = ["-include", build["pch"]]
        self.includes = includes
        self.link = [build["compiler"], *build["link_flags"]]
        self.tests = exercise["test_object"]

    def once(self, turn: int) -> float:
        source, made, program = (self.folder / name for name in ("plain.cpp", "plain.o", "plain"))
        source.write_text(edited(turn))
        start = time.perf_counter()
        run(*self.compile, *self.prelude, *self.includes, "-c", source, "-o", made)
        run(*self.link, made, self.tests, "-o", program)
        run(program, "-r", f"contact::out={self.folder / 'events'}")
        return time.perf_counter() - start

    def both(self, turn: int) -> float:
        """The student's file without the precompiled header, and the tests' own file."""
        source = self.folder / "both.cpp"
        source.write_text(edited(turn))
        chapters = sorted((ROOT / "chapters").glob("[0-9]*"))
        places = [*chapters, ROOT / "tests", ROOT / "grading"]
        tests = ROOT / "tests" / "02_triangles" / "ray_triangle_test.cpp"
        host = [ROOT / "tests" / "support" / f"{name}.cpp" for name in ("exercise", "runner")]
        objects = []
        for name in host:
            objects.append(self.folder / f"{name.stem}.o")
            if not objects[-1].exists():  # not timed: compiled only once
                run(*self.compile, *[f"-I{p}" for p in places], "-c", name, "-o", objects[-1])
        start = time.perf_counter()
        run(*self.compile, *self.includes, "-c", source, "-o", self.folder / "both.o")
        run(
            *self.compile,
            *self.includes,
            *[f"-I{place}" for place in places],
            "-c",
            tests,
            "-o",
            self.folder / "both_tests.o",
        )
        program = self.folder / "both"
        parts = [self.folder / "both.o", self.folder / "both_tests.o", *objects]
        run(*self.link, *parts, "-lCatch2", "-o", program)
        run(program, "-r", f"contact::out={self.folder / 'events'}")
        return time.perf_counter() - start


class Watch:
    """`contact watch` on a folder of copies of its own."""

    def __init__(self, folder: Path) -> None:
        self.copy = folder / "work" / f"{EXERCISE}.cpp"
        environment = {
            **os.environ,
            "CONTACT_ROOT": str(ROOT),
            "CONTACT_WORK": str(folder / "work"),
        }
        self.process = subprocess.Popen(
            [PROGRAM, "watch", "ray_triangle"],
            stdout=subprocess.PIPE,
            text=True,
            env=environment,
        )
        self.read_until("Watching")

    def read_until(self, text: str) -> None:
        lines: IO[str] | None = self.process.stdout
        assert lines is not None
        for line in lines:
            if text in line:
                return
        sys.exit(f"contact watch ended before it said {text!r}")

    def once(self, turn: int) -> float:
        beside = self.copy.with_suffix(".new")
        beside.write_text(edited(turn))
        start = time.perf_counter()
        beside.rename(self.copy)
        self.read_until(f"{EXERCISE}: passed")
        return time.perf_counter() - start

    def end(self) -> None:
        self.process.terminate()
        self.process.wait()


def summary(times: list[float]) -> dict[str, float]:
    low, middle, high = statistics.quantiles(times, n=4)
    return {"median": middle, "q1": low, "q3": high, "runs": len(times)}


def main() -> int:
    options = argparse.ArgumentParser(description="Time from a save to its verdict.")
    options.add_argument("--repeats", type=int, default=25, help="timed runs of each (default 25)")
    options.add_argument("--json", type=Path, help="also write the figures here")
    arguments = options.parse_args()

    folder = Path(tempfile.mkdtemp(prefix="edit-to-verdict-"))
    try:
        floor = Floor(folder)
        watch = Watch(folder)
        ways: dict[str, Callable[[int], float]] = {
            "edit to verdict": watch.once,
            "the floor": floor.once,
            "two full files": floor.both,
        }
        times: dict[str, list[float]] = {name: [] for name in ways}
        for turn in range(arguments.repeats + 1):
            for name, once in ways.items():
                # The slow way needs no more than a few turns, and the first of each only warms up.
                if name == "two full files" and turn > 3:
                    continue
                seconds = once(turn)
                if turn > 0:
                    times[name].append(seconds)
        watch.end()
    finally:
        shutil.rmtree(folder, ignore_errors=True)

    figures = {name: summary(taken) for name, taken in times.items()}
    # Of runs that follow one another, so that a busy moment counts on both sides.
    pairs = zip(times["edit to verdict"], times["the floor"], strict=True)
    ratio = statistics.median(watched / plain for watched, plain in pairs)
    for name, figure in figures.items():
        print(
            f"{name:16}  median {figure['median']:.3f} s"
            f"  (quartiles {figure['q1']:.3f} - {figure['q3']:.3f}, {figure['runs']:.0f} runs)"
        )
    print(
        f"edit to verdict is {ratio:.2f} times the floor (median of pairs);"
        f" at most {MOST} is wanted"
    )
    if arguments.json:
        arguments.json.write_text(json.dumps({"ratio": ratio, **figures}, indent=1) + "\n")
    return 0 if ratio <= MOST else 1


if __name__ == "__main__":
    sys.exit(main())
