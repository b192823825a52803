"""The submissions that attack the grader, and what each must get.

A file tests/grade/hostile/NAME.cpp is a right answer with an attack in it, between lines //[attack
and //]attack; without them it is the attack's honest twin, which must get full marks. Its first
lines say what it tries and what it must get:

    // Tries:     what, in a sentence
    // Exercise:  01_planes/signed_distance
    // Ordinary:  full marks | exit status 0     (what it achieves where tests and answer are one
    //                                           program; left out if nothing)
    // Points:    0 of 8
    // Tests:     all stopped | 1-3 passed, 4-6 stopped or failed | does not compile
    // Says:      words | other words            (each of its failures holds one of them)
    // Seconds:   10                          (it costs no more on the clock, and is not graded
    //                                        again alone; left out if it may)
    // Reduced:   what the reduced level cannot keep from it; left out if nothing

What must not succeed prints "GOT IT: ..." where it does. Words like @SECRET@ are replaced by values
that exist only while the test runs.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
REGION = re.compile(r"^ *//\[attack\n.*?^ *//\]attack\n", re.DOTALL | re.MULTILINE)
KEYS = ("Tries", "Exercise", "Ordinary", "Points", "Tests", "Says", "Seconds", "Reduced")
NO_COMPILE = "does not compile"


@dataclass(frozen=True)
class Specimen:
    name: str
    tries: str
    exercise: str
    ordinary: str
    points: float
    max_points: float
    tests: str
    says: tuple[str, ...]
    seconds: float | None
    reduced: str
    text: str

    @property
    def twin(self) -> str:
        return REGION.sub("", self.text)

    @property
    def earns_all(self) -> bool:
        return self.points == self.max_points

    def allowed(self, count: int) -> list[set[str]]:
        """Of each test, how it may end."""
        result: list[set[str]] = [set() for _ in range(count)]
        for part in self.tests.split(", "):
            places, _, statuses = part.partition(" ")
            first, _, last = (f"1-{count}" if places == "all" else places).partition("-")
            for at in range(int(first), int(last or first) + 1):
                result[at - 1] = set(statuses.split(" or "))
        return result


def filled(text: str, words: Mapping[str, str]) -> str:
    """The text with what exists only while the test runs."""
    return re.sub(r"@([A-Z_]+)@", lambda word: words[word[1]], text)


def read(file: Path) -> Specimen:
    text = file.read_text()
    header: dict[str, str] = {}
    key = ""
    for line in text.splitlines():
        if not line.startswith("//") or line.startswith("//["):
            break
        if start := re.match(r"// ([A-Z][a-z]+): +(.*)", line):
            key = start[1]
            assert key in KEYS, f"{file.name}: what is {key}?"
            header[key] = start[2]
        else:
            header[key] += " " + line.removeprefix("//").strip()
    points, _, most = header["Points"].partition(" of ")
    says = [words.strip() for words in header.get("Says", "").split("|")]
    return Specimen(
        name=file.stem,
        tries=header["Tries"],
        exercise=header["Exercise"],
        ordinary=header.get("Ordinary", ""),
        points=float(points),
        max_points=float(most),
        tests=header["Tests"],
        says=tuple(words for words in says if words),
        seconds=float(header["Seconds"]) if "Seconds" in header else None,
        reduced=header.get("Reduced", ""),
        text=text,
    )


def corpus() -> list[Specimen]:
    return [read(file) for file in sorted((HERE / "hostile").glob("*.cpp"))]


def different_twins(specimens: Sequence[Specimen]) -> list[Specimen]:
    """Of specimens whose twins are the same code under other comments, the first alone."""
    first: dict[tuple[str, str], Specimen] = {}
    for specimen in specimens:
        code = re.sub(r"//.*", "", specimen.twin)
        first.setdefault((specimen.exercise, " ".join(code.split())), specimen)
    return list(first.values())


def misses(specimen: Specimen, entry: Mapping[str, Any]) -> list[str]:
    """What of its verdict an exercise's entry in results.json does not fulfil."""
    verdict = entry.get("verdict")
    if verdict is None:
        return [f"no verdict: {entry.get('status')}: {entry.get('problem')}"]
    found = []
    if specimen.points < specimen.max_points and entry["points"] > specimen.points:
        found.append(f"{entry['points']} points, {specimen.points} are its own")
    if specimen.tests == NO_COMPILE:
        if verdict["verdict"] != "does_not_compile" or entry["gradable"]:
            found.append(f"{verdict['verdict']}, and should not compile")
        return found + unsaid(specimen, [text_of(verdict.get("compile_error", {}))])
    tests = verdict["tests"]
    for test, allowed in zip(tests, specimen.allowed(len(tests)), strict=True):
        if test["status"] not in allowed:
            reason = test.get("failure", {}).get("reason", "")
            found.append(f"{test['name']}: {test['status']} ({reason}), not {' or '.join(allowed)}")
    stopped = [test["failure"]["reason"] for test in tests if test["status"] == "stopped"]
    if (
        not found
        and "passed or stopped" not in specimen.tests
        and entry["points"] != specimen.points
    ):
        found.append(f"{entry['points']} points, not {specimen.points}")
    return found + unsaid(specimen, stopped)


def unsaid(specimen: Specimen, reasons: list[str]) -> list[str]:
    if not specimen.says:
        return []
    return [
        f'"{reason}" says nothing of {" or ".join(specimen.says)}'
        for reason in reasons
        if not any(words in reason for words in specimen.says)
    ]


def text_of(error: Mapping[str, Any]) -> str:
    return " ".join(str(error.get(key, "")) for key in ("message", "explanation", "full"))


def loot(entry: Mapping[str, Any]) -> list[str]:
    """What an attack says that it got."""
    verdict = entry.get("verdict") or {}
    said = [verdict.get("output", ""), *verdict.get("warnings", [])]
    said += [remark["message"] for remark in verdict.get("diagnostics", [])]
    return [line for text in said for line in text.splitlines() if "GOT IT: " in line]
