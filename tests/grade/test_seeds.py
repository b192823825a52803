"""A grading seed changes the questions, and nothing else: what is right stays right, what is wrong
stays wrong, and what was learnt by heart under the book's own seed is worth nothing.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from sample import sample
from wrong_answers import wrong_answers

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "dev"
TOMLS = sorted((ROOT / "exercises").glob("*/*/exercise.toml"))
EXERCISES = [f"{toml.parent.parent.name}/{toml.parent.name}" for toml in TOMLS]
# In an exercise that breaks code the answer is the input, so there is no question to change: what
# is learnt by heart there is an input that breaks the code, and that is the answer.
ASKING = [
    exercise
    for exercise, toml in zip(EXERCISES, TOMLS, strict=True)
    if "breaks" not in tomllib.loads(toml.read_text(encoding="utf-8"))
]
# Words, digits, hexadecimal digits, a number that is too long for one, and a single character.
SEEDS = [
    "autumn term",
    "7",
    "9f86d081884c7d659a2feaa0c55ad015",
    "18446744073709551616",
    "0",
    *[f"seed {number}" for number in range(15)],
]


def description() -> dict[str, Any]:
    loaded: dict[str, Any] = json.loads((BUILD / "exercises.json").read_text())
    return loaded


def events(
    program: Path, folder: Path, seed: str | None, *, questions: bool, only: str = ""
) -> list[Any]:
    """What a program of tests says as it runs: all of them, or one alone."""
    told = folder / f"{program.name}.events"
    environment = {**os.environ, "CONTACT_SEED": seed or ""}
    environment.pop("CONTACT_TELL_QUESTIONS", None)
    if seed is None:
        del environment["CONTACT_SEED"]
    if questions:
        environment["CONTACT_TELL_QUESTIONS"] = "1"
    # Catch2 reads a comma, a bracket and an asterisk in a test's name as its own signs.
    named = [re.sub(r"([\\,\[*])", r"\\\1", only)] if only else []
    subprocess.run(
        [str(program), "-r", f"contact::out={told}", *named],
        env=environment,
        capture_output=True,
        timeout=300,
        check=False,
    )
    return [json.loads(line) for line in told.read_text().splitlines()]


def statuses(program: Path, folder: Path, seed: str | None, only: str = "") -> dict[str, str]:
    said = events(program, folder, seed, questions=False, only=only)
    return {event["test"]: event["status"] for event in said if event["event"] == "end"}


def asked(program: Path, folder: Path, seed: str | None) -> dict[str, list[Any]]:
    """The inputs of every question, test by test."""
    inputs: dict[str, list[Any]] = {}
    test = ""
    for event in events(program, folder, seed, questions=True):
        if event["event"] == "start":
            test = event["test"]
            inputs[test] = []
        elif event["event"] == "question":
            inputs[test].append(event["failure"]["inputs"])
    return inputs


def linked(exercise: str, source: Path, folder: Path) -> Path:
    """The program that `contact check` runs, of this answer."""
    build = description()
    parts = build["exercises"][exercise]
    program = folder / source.stem
    subprocess.run(
        [
            build["compiler"],
            *build["compile_flags"],
            *["-include", build["pch"]],
            *[f"-I{place}" for place in (*build["include"], *parts["include"])],
            *["-w", "-c", str(source), "-o", f"{program}.o"],
        ],
        check=True,
    )
    subprocess.run(
        [
            build["compiler"],
            *build["link_flags"],
            *[f"{program}.o", parts["test_object"], "-o", str(program)],
        ],
        check=True,
    )
    return program


@pytest.mark.parametrize("exercise", ASKING)
def test_questions_change_with_the_seed(exercise: str, tmp_path: Path) -> None:
    program = BUILD / "exercises" / exercise / "linked"
    by_seed = [asked(program, tmp_path, seed) for seed in (None, *SEEDS[:4])]
    changing = set()
    for one in by_seed:
        for other in by_seed:
            if one is other:
                continue
            changed = {test for test, inputs in one.items() if inputs != other[test]}
            assert changed, f"{exercise}: no test asks anything else under another seed"
            changing.add(frozenset(changed))
    assert len(changing) == 1, f"{exercise}: {changing}"
    random = next(iter(changing))
    for test in random:
        # Nearly every question is new, and not only their order.
        first = {json.dumps(inputs) for inputs in by_seed[0][test]}
        second = {json.dumps(inputs) for inputs in by_seed[1][test]}
        assert len(first & second) <= len(first) / 20, f"{exercise}, {test}"
        assert len(second) >= 50, f"{exercise}, {test}: so few questions are learnt by heart"
    # The same seed asks the same, and an empty one is none.
    assert asked(program, tmp_path, SEEDS[0]) == by_seed[1]
    assert asked(program, tmp_path, "") == by_seed[0]


@pytest.mark.parametrize(
    "exercise", sample(EXERCISES, 3, "exercises under many seeds", kind="exercises")
)
def test_solutions_pass_and_wrong_answers_fail_under_any_seed(
    exercise: str, tmp_path: Path
) -> None:
    solution = BUILD / "exercises" / exercise / "linked"
    for seed in SEEDS:
        ended = statuses(solution, tmp_path, seed)
        assert ended, f"{exercise}: it says nothing"
        assert set(ended.values()) == {"passed"}, f"{exercise}, seed {seed!r}: {ended}"
    wrong = wrong_answers(exercise)
    assert wrong
    with ThreadPoolExecutor(2) as pool:
        programs = list(pool.map(lambda file: linked(exercise, file, tmp_path), wrong))
    for i, (file, program) in enumerate(zip(wrong, programs, strict=True)):
        caught_by = re.search(r"^// caught by: (.+)$", file.read_text(), re.MULTILINE)
        assert caught_by
        # A third of the seeds, other ones of the next wrong answer and in the next turn.
        for seed in sample(SEEDS[i % 3 :] + SEEDS[: i % 3], 3, "", within=3):
            # Another test may never end with a wrong answer under some seed.
            status = statuses(program, tmp_path, seed, only=caught_by[1])[caught_by[1]]
            assert status == "failed", f"{file}, seed {seed!r}: {caught_by[1]} is {status}"


# What every answer to signed_distance and side says it was asked, and what it answered.
REMEMBERS = """
#include "signed_distance.hpp"
#include <cstdio>
namespace {
struct Known { double a, b, c, d, x, y, z, distance; int side; };
const Known known[] = {
%s};
const Known* recall(const exercise::PlaneEquation& p, const Eigen::Vector3d& q) {
  for (const Known& k : known) {
    if (k.a == p.a && k.b == p.b && k.c == p.c && k.d == p.d && k.x == q.x() && k.y == q.y() &&
        k.z == q.z())
      return &k;
  }
  return nullptr;
}
}
namespace exercise {
double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Known* k = recall(plane, point);
  return k != nullptr ? k->distance : 0;
}
int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Known* k = recall(plane, point);
  return k != nullptr ? k->side : 0;
}
}
"""
LISTENS = """
#include "signed_distance.hpp"
#include <cstdio>
#include <cstdlib>
namespace exercise {
namespace {
double value(const PlaneEquation& p, const Eigen::Vector3d& q) {
  return Eigen::Vector3d(p.a, p.b, p.c).dot(q) + p.d;
}
int sign(double v) { return v > 0 ? 1 : (v < 0 ? -1 : 0); }
void note(const PlaneEquation& p, const Eigen::Vector3d& q) {
  static std::FILE* file = std::fopen(std::getenv("CONTACT_NOTES"), "w");
  std::fprintf(file, "{%a, %a, %a, %a, %a, %a, %a, %a, %d},\\n", p.a, p.b, p.c, p.d, q.x(),
               q.y(), q.z(), value(p, q) / Eigen::Vector3d(p.a, p.b, p.c).norm(),
               sign(value(p, q)));
  std::fflush(file);
}
}
double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  note(plane, point);
  return value(plane, point) / Eigen::Vector3d(plane.a, plane.b, plane.c).norm();
}
int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  note(plane, point);
  return sign(value(plane, point));
}
}
"""


def test_what_was_learnt_by_heart_fails_under_another_seed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    exercise = "01_planes/signed_distance"
    listens = tmp_path / "listens.cpp"
    listens.write_text(LISTENS)
    notes = tmp_path / "notes"
    monkeypatch.setenv("CONTACT_NOTES", str(notes))
    ended = statuses(linked(exercise, listens, tmp_path), tmp_path, None)
    assert set(ended.values()) == {"passed"}

    remembers = tmp_path / "remembers.cpp"
    remembers.write_text(REMEMBERS % notes.read_text())
    program = linked(exercise, remembers, tmp_path)
    assert set(statuses(program, tmp_path, None).values()) == {"passed"}
    for seed in SEEDS:
        failed = {t for t, s in statuses(program, tmp_path, seed).items() if s != "passed"}
        assert failed == {"random points agree with exact arithmetic"}
