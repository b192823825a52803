"""Small classes, graded as an instructor does."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "grading" / "book"))

from wrong_answers import wrong_answer  # noqa: E402

# A program beside the build's own stays the same while that is built again.
PROGRAM = Path(os.environ.get("CONTACT_PROGRAM", ROOT / "build/dev/bin/contact"))
EXERCISE = "01_planes/signed_distance"
STUB = (ROOT / f"exercises/{EXERCISE}/signed_distance.cpp").read_text()
SOLUTION = (ROOT / f"solutions/{EXERCISE}/signed_distance.cpp").read_text()
WRONG = wrong_answer(EXERCISE, "offset_sign").read_text()

Done = subprocess.CompletedProcess[str]
Document = dict[str, Any]


def greedy(megabytes: int) -> str:
    """Added to an answer: it takes this much memory before anything else."""
    return (
        "\n#include <cstdlib>\n#include <cstring>\n#include <new>\n"
        f"struct Greedy {{ char* all; Greedy() : all(new char[{megabytes} << 20]) {{"
        f" std::memset(all, 1, {megabytes} << 20); }} }} greedy;\n"
    )


def running_from(folder: Path) -> list[str]:
    """Processes whose arguments name something in a folder."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            command = (process / "cmdline").read_bytes().decode(errors="replace")
        except OSError:
            continue
        if f"{folder}/" in command:
            found.append(command.replace("\0", " "))
    return found


def until(holds: Callable[[], bool], seconds: float = 120.0) -> None:
    end = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < end, "it never came to that"
        time.sleep(0.002)


@dataclass
class Grader:
    """`contact grade` in a folder of its own."""

    folder: Path
    root: Path = ROOT
    program: Path = PROGRAM
    submissions: Path = field(init=False)
    results: Path = field(init=False)
    temporary: Path = field(init=False)

    def __post_init__(self) -> None:
        self.submissions = self.folder / "submissions"
        self.results = self.folder / "results"
        self.temporary = self.folder / "tmp"
        self.submissions.mkdir(parents=True)
        self.temporary.mkdir()

    def hand_in(self, student: str, text: str = SOLUTION, exercise: str = EXERCISE) -> Path:
        file = self.submissions / student / f"{exercise}.cpp"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        return file

    def command(self, *words: str, exercises: str = "signed_distance") -> list[str]:
        given = [str(self.program), "grade", str(self.submissions), "-o", str(self.results)]
        return [*given, "--exercises", exercises, *words]

    def environment(self) -> dict[str, str]:
        return {
            **os.environ,
            "CONTACT_ROOT": str(self.root),
            "TMPDIR": str(self.temporary),
            "NO_COLOR": "1",
        }

    def run(self, *words: str, exercises: str = "signed_distance") -> Done:
        return self._run(self.command(*words, exercises=exercises))

    def run_as(self, *words: str) -> Done:
        """With these words after `grade`, and no others."""
        return self._run([str(self.program), "grade", *words])

    def _run(self, command: list[str]) -> Done:
        return subprocess.run(
            command,
            capture_output=True,
            text=True,
            env=self.environment(),
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
            timeout=600,
        )

    def grade(self, *words: str, exercises: str = "signed_distance", code: int = 0) -> Document:
        """Grades and returns what is printed as JSON."""
        done = self.run("--json", *words, exercises=exercises)
        assert done.returncode == code, done.stdout + done.stderr
        printed: Document = json.loads(done.stdout)
        return printed

    def start(self, *words: str) -> subprocess.Popen[str]:
        return subprocess.Popen(
            self.command(*words),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env=self.environment(),
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
        )

    # What a run left -----------------------------------------------------------------------------

    def document(self, name: str = "results.json") -> Document:
        document: Document = json.loads((self.results / name).read_text())
        return document

    def submission(self, id_: str) -> Document:
        found: list[Document] = [
            entry for entry in self.document()["submissions"] if entry["id"] == id_
        ]
        assert len(found) == 1, [entry["id"] for entry in self.document()["submissions"]]
        return found[0]

    def unit(self, id_: str, exercise: str = EXERCISE) -> Document:
        entry = self.submission(id_)
        assert "problem" not in entry, entry["problem"]
        units: list[Document] = entry["exercises"]
        return next(unit for unit in units if unit["id"] == exercise)

    def points(self) -> dict[str, float]:
        return {entry["id"]: entry["points"] for entry in self.document()["submissions"]}

    def log(self) -> list[list[str]]:
        file = self.results / ".grade/log"
        if not file.exists():
            return []
        return [line.split("\t") for line in file.read_text().splitlines() if line.count("\t") >= 3]

    def counts(self, what: str) -> Counter[str]:
        """How often each student's unit was started, or finished."""
        return Counter(line[1] for line in self.log() if line[0] == what)

    def workers(self) -> list[int]:
        """Process ids of the workers that began something, the last first."""
        pids = [int(line[-1].rpartition(":")[2]) for line in self.log() if line[0] == "start"]
        return list(dict.fromkeys(reversed(pids)))

    def clean(self) -> None:
        """Holds that no process and no temporary folder is left."""
        until(lambda: not running_from(self.folder), 20)
        assert list(self.temporary.iterdir()) == []


def kill(pid: int) -> None:
    """A process may have ended by itself meanwhile."""
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        return


def without_times(document: object) -> object:
    """A document without what differs each time."""
    if isinstance(document, Mapping):
        return {
            key: without_times(value)
            for key, value in document.items()
            if key not in ("seconds", "times")
        }
    if isinstance(document, list):
        return [without_times(value) for value in document]
    return document
