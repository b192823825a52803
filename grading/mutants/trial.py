"""Compiles answers as `contact check` does, and runs the tests of an exercise on them."""

from __future__ import annotations

import json
import os
import resource
import subprocess
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

Json = dict[str, Any]

# Also of a program that sleeps; per mutant.
MAX_SECONDS = 20.0
MEMORY_MB = "512"


class TrialError(Exception):
    """What prevents trying anything."""


@dataclass(frozen=True)
class Bundle:
    """What CMake knows of an exercise (exercises.json)."""

    compiler: str
    flags: tuple[str, ...]
    link_flags: tuple[str, ...]
    tests: Path

    @staticmethod
    def of(build: Json, exercise: str) -> Bundle:
        entry = build["exercises"].get(exercise)
        if entry is None:
            raise TrialError(f"{exercise} is not in exercises.json: configure again")
        tests = Path(entry["test_object"])
        if not tests.exists():
            raise TrialError(f"{exercise}: {tests} is not built")
        include = [f"-I{folder}" for folder in (*build["include"], *entry["include"])]
        return Bundle(
            build["compiler"],
            (*build["compile_flags"], "-include", build["pch"], *include),
            tuple(build["link_flags"]),
            tests,
        )

    def compile(self, source: Path, output: Path, *more: str) -> str:
        """Writes the object; what the compiler said if there is none."""
        command = [self.compiler, *self.flags, *more, "-c", str(source), "-o", str(output)]
        done = subprocess.run(
            command,
            capture_output=True,
            text=True,
            env={**os.environ, "LC_ALL": "C.UTF-8"},
            check=False,
        )
        return "" if done.returncode == 0 else done.stderr or "the compiler failed"

    def link(self, thing: Path, program: Path) -> None:
        command = [self.compiler, *self.link_flags, str(thing), str(self.tests), "-o", str(program)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise TrialError(done.stderr)


@dataclass(frozen=True)
class Trial:
    """How the tests ended: `status` is that of the first that did not pass."""

    status: str  # "passed", "failed", "stopped", "not_attempted"
    test: str
    failure: Json
    seconds: float  # of processor time

    @property
    def misconceptions(self) -> list[str]:
        found: list[str] = self.failure.get("misconceptions", [])
        return found


def run(program: Path, environment: Mapping[str, str], limit: float) -> Trial:
    """Runs the tests up to the first that does not pass. `limit`: seconds of processor time."""
    whole = max(1, round(limit + 0.5))

    def limited() -> None:
        resource.setrlimit(resource.RLIMIT_CPU, (whole, whole + 1))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    output = b""
    with subprocess.Popen(
        [str(program), "-r", "contact", "--abort"],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        env={**os.environ, "CONTACT_MEMORY_MB": MEMORY_MB, **environment},
        preexec_fn=limited,
    ) as process:
        try:
            # On a busy machine a process gets a small share of a processor: what waits is told
            # from what computes by the limit on its processor time.
            output, _ = process.communicate(timeout=MAX_SECONDS + 10 * whole)
        except subprocess.TimeoutExpired:
            process.kill()
            output, _ = process.communicate()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return _read(output.decode(errors="replace"), seconds)


def _read(output: str, seconds: float) -> Trial:
    started = ""
    done = False
    for line in output.splitlines():
        try:
            event = json.loads(line)
        except ValueError:
            continue  # what the solution prints
        if not isinstance(event, dict):
            continue
        if event.get("event") == "start":
            started = event["test"]
        elif event.get("event") == "end" and event["status"] != "passed":
            return Trial(event["status"], event["test"], event.get("failure", {}), seconds)
        elif event.get("event") == "done":
            done = True
    if done:
        return Trial("passed", "", {}, seconds)
    return Trial("stopped", started, {}, seconds)


def processor_seconds() -> float:
    """Of this process and its children, so far."""
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + children.ru_utime + children.ru_stime
