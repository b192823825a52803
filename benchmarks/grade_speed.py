"""Measures how many units a second `contact grade` judges, compared with a naive script.

    build/venv/bin/python benchmarks/grade_speed.py [--quick] [--json FILE]

200 submissions are made from the book's solutions, stubs and wrong answers, drawn by a seeded
generator; no two files are equal. A *unit* is one exercise of one submission. They are graded in
blocks. In each block three measurements are made, in an order that rotates from block to block, so
that other work on the machine affects all of them equally:

  one worker   `contact grade BLOCK -o RESULTS --workers 1`, from the command to its end: taking
               the submissions in, calibrating, compiling, running and judging in boxes, reports
               (what a run does once, it does once a block: blocks are large, as classes are)
  two workers  the same with --workers 2
  the naive    on a sample of the block's units: the compiler for the student's file and for the
  way          exercise's tests, the linker with Catch2, the program. The same compiler and flags
               (-O1), the same linker, the same test files. It has no precompiled header, no box
               and no report, and what no exercise changes (Catch2, the asking, main) is compiled
               before and not timed

The marks of all three must agree, test by test. The rate is a core's: one worker does one unit
after the other, as the naive way does. Also printed is what a call across the proxy takes.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import random
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import IO, Any

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "grading" / "book"))

from wrong_answers import wrong_answers  # noqa: E402

BUILD = ROOT / "build" / "dev"
PROGRAM = BUILD / "bin" / "contact"
WANTED_RATIO = 5.0
WANTED_SPEED_UP = 1.8
# Of the tests' random cases: a wrong answer may get through with one seed and not with another.
TESTS_SEED = "speed"
# What a class hands in: more is right than wrong, and some never began.
MIX = {"solution": 0.45, "wrong": 0.40, "stub": 0.15}


@dataclass(frozen=True)
class Unit:
    submission: str
    exercise: str
    kind: str
    file: Path


@dataclass
class Timed:
    """One way to grade, over all blocks."""

    units: list[int] = field(default_factory=list)
    seconds: list[float] = field(default_factory=list)

    def add(self, units: int, seconds: float) -> None:
        self.units.append(units)
        self.seconds.append(seconds)

    def rates(self) -> list[float]:
        return [n / s for n, s in zip(self.units, self.seconds, strict=True)]


def timed(
    command: list[str], log: IO[str] | int, more: dict[str, str] | None = None
) -> tuple[float, int]:
    """Seconds by the clock, and the exit code."""
    start = time.perf_counter()
    done = subprocess.run(command, stdout=log, stderr=log, env={**os.environ, **(more or {})})
    return time.perf_counter() - start, done.returncode


def must(command: list[str]) -> None:
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")


# ---- Submissions


def exercises() -> list[str]:
    listed = json.loads((BUILD / "exercises.json").read_text())["exercises"]
    return sorted(listed)


def text_of(exercise: str, kind: str, draw: random.Random) -> str:
    name = exercise.partition("/")[2]
    if kind == "stub":
        return (ROOT / "exercises" / exercise / f"{name}.cpp").read_text()
    folder = ROOT / "solutions" / exercise
    if kind == "solution":
        return (folder / f"{name}.cpp").read_text()
    return draw.choice(wrong_answers(exercise)).read_text()


def varied(text: str, student: str, draw: random.Random) -> str:
    """The same answer written differently: a comment, an unused name, blank lines."""
    mark = draw.randrange(10**9)
    return (
        f"// {student}, version {mark}\n{text}\n\n"
        f"namespace {{\n[[maybe_unused]] constexpr int attempt_{mark} = {mark};\n}}\n"
    )


def make_block(folder: Path, names: list[str], each: int, draw: random.Random) -> list[Unit]:
    units = []
    for name in names:
        for exercise in draw.sample(exercises(), each):
            kind = draw.choices(list(MIX), weights=list(MIX.values()))[0]
            file = folder / name / f"{exercise}.cpp"
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(varied(text_of(exercise, kind, draw), name, draw))
            units.append(Unit(name, exercise, kind, file))
    return units


# ---- The ways to grade


def statuses(tests: list[dict[str, Any]]) -> dict[str, str]:
    return {test["name"]: test["status"] for test in tests}


Marks = dict[tuple[str, str], dict[str, str]]


def grade(block: Path, results: Path, workers: int, timing: Timed, units: int) -> Marks:
    command = [str(PROGRAM), "grade", str(block), "-o", str(results)]
    command += ["--workers", str(workers), "--seed", TESTS_SEED]
    with (results.parent / f"{results.name}.log").open("w+") as log:
        seconds, code = timed(command, log)
        if code != 0:
            log.seek(0)
            sys.exit(f"{' '.join(command)} ended with {code}:\n{log.read()}")
    timing.add(units, seconds)
    marks: Marks = {}
    for submission in json.loads((results / "results.json").read_text())["submissions"]:
        for unit in submission["exercises"]:
            if "verdict" in unit:
                marks[submission["id"], unit["id"]] = statuses(unit["verdict"]["tests"])
    return marks


class Naive:
    """Compile two files, link, run."""

    def __init__(self, folder: Path) -> None:
        build = json.loads((BUILD / "exercises.json").read_text())
        self.build = build
        self.folder = folder
        self.compile = [build["compiler"], *build["compile_flags"]]
        chapters = sorted(str(place) for place in (ROOT / "chapters").glob("[0-9]*"))
        self.places = [f"-I{place}" for place in (*chapters, ROOT / "tests", ROOT / "grading")]
        self.host = []
        for name in ("exercise", "runner"):
            self.host.append(str(folder / f"{name}.o"))
            source = str(ROOT / "tests" / "support" / f"{name}.cpp")
            must([*self.compile, *self.places, "-c", source, "-o", self.host[-1]])

    def once(self, unit: Unit) -> tuple[float, dict[str, str]]:
        chapter, name = unit.exercise.split("/")
        contract = [f"-I{place}" for place in self.build["exercises"][unit.exercise]["include"]]
        includes = [*(f"-I{place}" for place in self.build["include"]), *contract]
        answer, tests, program, told = (
            str(self.folder / part) for part in ("answer.o", "tests.o", "program", "events")
        )
        source = str(ROOT / "tests" / chapter / f"{name}_test.cpp")
        total = 0.0
        for command in (
            [*self.compile, *includes, "-c", str(unit.file), "-o", answer],
            [*self.compile, *contract, *self.places, "-c", source, "-o", tests],
            [
                *[self.build["compiler"], *self.build["link_flags"], answer, tests, *self.host],
                *["-lCatch2", "-o", program],
            ],
            [program, "-r", f"contact::out={told}"],
        ):
            seconds, code = timed(command, subprocess.DEVNULL, {"CONTACT_SEED": TESTS_SEED})
            if code != 0 and command[0] != program:
                sys.exit(f"{' '.join(command)} ended with {code}")
            total += seconds
        events = [json.loads(line) for line in Path(told).read_text().splitlines()]
        return total, {e["test"]: e["status"] for e in events if e["event"] == "end"}

    def sample(self, units: list[Unit], timing: Timed) -> Marks:
        marks: Marks = {}
        total = 0.0
        for unit in units:
            seconds, marks[unit.submission, unit.exercise] = self.once(unit)
            total += seconds
        timing.add(len(units), total)
        return marks


def hold_together(one: Marks, other: Marks, what: str) -> None:
    """Every test that both ran ended alike. A test that is skipped in grading ran in the naive
    way, which knows nothing of what a test requires."""
    for unit, tests in other.items():
        for name, status in tests.items():
            if one[unit][name] not in (status, "skipped"):
                sys.exit(f"{what} disagree on {unit}, {name}: {one[unit][name]}, {status}")


# ---- What is said


def machine() -> dict[str, Any]:
    cpu = platform.machine()
    with Path("/proc/cpuinfo").open() as lines:
        for line in lines:
            if line.startswith("model name"):
                cpu = line.partition(":")[2].strip()
                break
    system = platform.freedesktop_os_release().get("PRETTY_NAME", platform.system())
    return {"cpu": cpu, "cores": os.cpu_count(), "os": system}


def machine_id(about: dict[str, Any]) -> str:
    words = re.sub(r"[^a-z0-9]+", "-", str(about["cpu"]).lower()).strip("-")
    return f"{words}-{about['cores']}-cores"


def spread(values: list[float]) -> dict[str, float]:
    return {"median": statistics.median(values), "least": min(values), "most": max(values)}


def said(figure: dict[str, float]) -> str:
    return f"{figure['median']:.2f} ({figure['least']:.2f} to {figure['most']:.2f})"


def proxy_call() -> dict[str, float]:
    """Microseconds of a call across the proxy: medians of 20,001 calls, repeated."""
    runs = []
    for _ in range(5):
        command = [str(PROGRAM), "dev", "call-time", "--json"]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")
        runs.append(json.loads(done.stdout)["microseconds"])
    return {way: statistics.median(run[way] for run in runs) for way in runs[0]}


def main() -> int:
    options = argparse.ArgumentParser(description="Compare the speed of grading with a script's.")
    options.add_argument("--submissions", type=int, default=200, help="made (default 200)")
    options.add_argument("--each", type=int, default=2, help="exercises in each (default 2)")
    options.add_argument("--blocks", type=int, default=2, help="timed apart (default 2)")
    options.add_argument(
        "--sample", type=int, default=12, help="units of a block graded naively (default 12)"
    )
    options.add_argument("--seed", type=int, default=2026, help="of the submissions")
    options.add_argument("--quick", action="store_true", help="a tenth of it: for a try")
    options.add_argument("--json", type=Path, help="where the figures go; else to results/")
    arguments = options.parse_args()
    if arguments.quick:
        arguments.submissions, arguments.blocks, arguments.sample = 20, 2, 3

    load = os.getloadavg()[0]
    if load > 0.5:
        print(f"The load here is {load:.1f}: figures by the clock mean little.", file=sys.stderr)
    draw = random.Random(arguments.seed)
    names = [f"student-{number:03}" for number in range(arguments.submissions)]
    ways = {name: Timed() for name in ("one worker", "two workers", "the naive way")}
    kinds: dict[str, int] = dict.fromkeys(MIX, 0)
    folder = Path(tempfile.mkdtemp(prefix="grade-speed-"))
    try:
        naive = Naive(folder)
        for number in range(arguments.blocks):
            block = folder / f"block-{number}"
            units = make_block(block, names[number :: arguments.blocks], arguments.each, draw)
            for unit in units:
                kinds[unit.kind] += 1
            sample = draw.sample(units, min(arguments.sample, len(units)))
            marks: dict[str, Marks] = {}
            order = list(ways)
            for name in order[number % 3 :] + order[: number % 3]:
                if name == "the naive way":
                    marks[name] = naive.sample(sample, ways[name])
                else:
                    workers = 1 if name == "one worker" else 2
                    results = folder / f"results-{number}-{workers}"
                    marks[name] = grade(block, results, workers, ways[name], len(units))
                    shutil.rmtree(results)
            hold_together(marks["one worker"], marks["two workers"], "one worker and two")
            hold_together(marks["one worker"], marks["the naive way"], "grading and the naive way")
            print(f"block {number + 1} of {arguments.blocks} done", file=sys.stderr)
    finally:
        shutil.rmtree(folder, ignore_errors=True)

    about = machine()
    figures: dict[str, Any] = {
        "format": "contact-grade-speed/1",
        "machine": about,
        "load": load,
        "date": datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%SZ"),
        "seed": arguments.seed,
        "submissions": len(names),
        "units": kinds,
        "blocks": arguments.blocks,
        "sample": arguments.sample * arguments.blocks,
        "ways": {
            name: {
                "units": sum(way.units),
                "units_per_second": spread(way.rates()),
            }
            for name, way in ways.items()
        },
    }
    one, two, plain = ways.values()
    ratio = [a / b for a, b in zip(one.rates(), plain.rates(), strict=True)]
    speed_up = [a / b for a, b in zip(one.seconds, two.seconds, strict=True)]
    figures["ratio"] = spread(ratio)
    figures["two_workers_against_one"] = spread(speed_up)
    figures["proxy_call_microseconds"] = call = proxy_call()

    print(f"{about['cpu']}, {about['cores']} cores, {about['os']}; load {load:.1f}")
    print(f"{len(names)} submissions: " + ", ".join(f"{n} {kind}" for kind, n in kinds.items()))
    for name, way in figures["ways"].items():
        print(f"{name:14} {said(way['units_per_second'])} units a second")
    print(f"one worker is {said(figures['ratio'])} times the naive way; {WANTED_RATIO} is wanted")
    print(
        f"two workers are {said(figures['two_workers_against_one'])} times one;"
        f" {WANTED_SPEED_UP} is wanted"
    )
    print(
        f"a call across the proxy takes {call['in_boxes']:.1f} microseconds in boxes,"
        f" {call['without_boxes']:.1f} without"
    )
    print("medians of blocks, in brackets the least and the most")

    place = arguments.json
    if place is None and not arguments.quick:
        place = ROOT / "benchmarks" / "results" / f"grade_speed.{machine_id(about)}.json"
    if place:
        place.write_text(json.dumps(figures, indent=1) + "\n")
    good = (
        figures["ratio"]["median"] >= WANTED_RATIO
        and figures["two_workers_against_one"]["median"] >= WANTED_SPEED_UP
    )
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
