"""where: every file of an exercise or a chapter, and nothing of another."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
Run = Callable[..., subprocess.CompletedProcess[str]]
EXERCISE = "02_triangles/ray_triangle"


def lines(contact: Run, *words: str) -> list[str]:
    done = contact("where", *words)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def tracked(*folders: str) -> set[str]:
    command = ["git", "ls-files", "--", *folders]
    return set(subprocess.run(command, cwd=ROOT, capture_output=True, text=True).stdout.split())


def test_an_exercise_is_all_that_lies_under_its_name(contact: Run) -> None:
    found = lines(contact, EXERCISE)
    assert len(found) == len(set(found))
    assert found[:2] == [f"exercises/{EXERCISE}/ray_triangle{end}" for end in (".hpp", ".cpp")]
    assert tracked(f"exercises/{EXERCISE}", f"solutions/{EXERCISE}") <= set(found)
    assert "tests/02_triangles/ray_triangle_test.cpp" in found
    assert "tests/02_triangles/hard_cases.json" in found
    assert not [file for file in found if "first_hit" in file]
    assert all((ROOT / file).is_file() for file in found)


def test_a_chapter_is_all_that_lies_under_its_slug(contact: Run) -> None:
    slug = "02_triangles"
    wanted = tracked(*(f"{top}/{slug}" for top in ("chapters", "exercises", "solutions", "tests")))
    found = set(lines(contact, slug))
    assert wanted <= found
    assert {file for file in found - wanted if not file.startswith("build/site/")} == set()
    assert found == set(lines(contact, "triangles"))


def test_a_wrong_answer_that_is_kept_as_a_patch_is_one_of_them(contact: Run) -> None:
    exercise = "12_momentum/force_curve"
    patches = {file for file in tracked(f"solutions/{exercise}") if file.endswith(".patch")}
    assert patches
    for name in (exercise, "12_momentum"):
        assert patches <= set(lines(contact, name))
    found = json.loads("\n".join(lines(contact, exercise, "--json")))
    assert {one["kind"] for one in found if one["file"] in patches} == {"wrong answer"}


def test_as_json_each_file_has_its_kind(contact: Run) -> None:
    found = json.loads("\n".join(lines(contact, EXERCISE, "--json")))
    kinds = {entry["kind"] for entry in found}
    assert {"contract", "stub", "solution", "wrong answer", "tests", "hard cases"} <= kinds
    assert [entry["file"] for entry in found] == lines(contact, EXERCISE)


def test_the_students_copy_is_named_where_it_lies(contact: Run, work: Path) -> None:
    assert contact("start", EXERCISE).returncode == 0
    assert str(work / f"{EXERCISE}.cpp") in lines(contact, EXERCISE)


def test_what_nobody_knows_is_told_the_nearest_names(contact: Run) -> None:
    done = contact("where", "02_triangels")
    assert done.returncode == 2
    assert "02_triangles" in done.stderr
