"""A pack that is used as a teacher and students do: made, listed, checked and graded."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from packs import CHAPTER, EXERCISE, ROOT, change, in_pack, new_pack, tree_state

ANSWERS = ROOT / "cli/authors/templates/pack/solutions" / EXERCISE


@pytest.fixture(scope="module")
def before() -> str:
    return tree_state()


@pytest.fixture(scope="module")
def pack(before: str, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One pack for all tests that build: a build of a pack's own takes the compiler a while."""
    return new_pack(tmp_path_factory.mktemp("packs") / "My course")


@pytest.fixture
def copy(pack: Path) -> Iterator[Path]:
    """Where the student's copy is, which is gone after the test."""
    yield pack / "work" / f"{EXERCISE}.cpp"
    shutil.rmtree(pack / "work", ignore_errors=True)


@pytest.fixture
def kept(pack: Path, tmp_path: Path) -> Iterator[Path]:
    """The pack, whose own files are afterwards as before. A build of another takes long."""
    trees = ("chapters", "tests")
    for tree in trees:
        shutil.copytree(pack / tree, tmp_path / tree)
    yield pack
    for tree in trees:
        shutil.rmtree(pack / tree)
        shutil.copytree(tmp_path / tree, pack / tree, copy_function=shutil.copy)


def answer(name: str = "overlap_depth") -> str:
    return (ANSWERS / f"{name}.cpp.in").read_text()


def test_new_pack_names_itself_after_its_folder(pack: Path) -> None:
    assert 'name = "my-course"\n' in (pack / "pack.toml").read_text()


def test_new_pack_takes_the_author(pack: Path) -> None:
    assert 'authors = ["A. Teacher"]\n' in (pack / "pack.toml").read_text()


def test_new_pack_ignores_what_is_not_the_authors(pack: Path) -> None:
    subprocess.run(["git", "init", "-q", str(pack)], check=True)
    (pack / "work").mkdir(exist_ok=True)
    (pack / "work" / "mine.cpp").touch()
    done = subprocess.run(
        ["git", "-C", str(pack), "check-ignore", "-q", "work/mine.cpp"], check=False
    )
    assert done.returncode == 0


def test_list_shows_the_exercises_of_the_pack_alone(pack: Path) -> None:
    document = json.loads(in_pack(pack, "list", "--json").stdout)
    found = [one["id"] for chapter in document["chapters"] for one in chapter["exercises"]]
    assert found == [EXERCISE]


def test_start_writes_into_the_packs_work(pack: Path, copy: Path) -> None:
    in_pack(pack, "start", "overlap_depth")
    assert "contact::todo()" in copy.read_text()


def test_the_solution_passes(pack: Path, copy: Path) -> None:
    in_pack(pack, "start", "overlap_depth")
    copy.write_text(answer())
    done = in_pack(pack, "check", "overlap_depth")
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize(
    ("name", "words"),
    [("negative_depth", "your depth is below zero"), ("one_radius", "inside the second")],
)
def test_a_wrong_answer_gets_the_hint_of_the_pack(
    pack: Path, copy: Path, name: str, words: str
) -> None:
    in_pack(pack, "start", "overlap_depth")
    copy.write_text(answer(f"wrong/{name}"))
    done = in_pack(pack, "check", "overlap_depth")
    assert done.returncode == 1
    assert words in " ".join(done.stdout.split())


def test_dev_check_passes(pack: Path) -> None:
    done = in_pack(pack, "dev", "check")
    assert done.returncode == 0, done.stdout + done.stderr


def test_two_submissions_are_graded(pack: Path, tmp_path: Path) -> None:
    for student, text in (("ada", answer()), ("bob", answer("wrong/negative_depth"))):
        file = tmp_path / "submissions" / student / f"{EXERCISE}.cpp"
        file.parent.mkdir(parents=True)
        file.write_text(text)
    results = tmp_path / "marks"
    words = ("grade", str(tmp_path / "submissions"), "-o", str(results), "--accept-weak")
    done = in_pack(pack, *words)
    assert done.returncode == 0, done.stdout + done.stderr
    document = json.loads((results / "results.json").read_text())
    marks = {one["id"]: one["points"] for one in document["submissions"]}
    assert marks == {"ada": 5.0, "bob": 4.0}


def test_a_chapter_and_an_exercise_are_made_in_the_pack(tmp_path: Path) -> None:
    pack = new_pack(tmp_path / "pack")
    in_pack(pack, "new", "chapter", "51_more")
    done = in_pack(pack, "new", "exercise", "51_more/something_new")
    assert done.returncode == 0, done.stderr
    document = json.loads(in_pack(pack, "list", "--json").stdout)
    assert [one["id"] for one in document["chapters"][1]["exercises"]] == ["51_more/something_new"]


def test_headers_of_the_pack_and_of_the_book_are_for_the_tests(pack: Path, kept: Path) -> None:
    contact = kept / f"chapters/{CHAPTER}/contact"
    contact.mkdir()
    (contact / "own_depth.hpp").write_text(
        "#pragma once\n#include <contact/plane.hpp>\nnamespace contact {\n"
        "inline constexpr double own_depth = 1;\n}\n"
    )
    change(
        kept / f"chapters/{CHAPTER}/chapter.toml", '["00_vectors"]', '["00_vectors", "01_planes"]'
    )
    tests = kept / f"tests/{CHAPTER}/overlap_depth_test.cpp"
    change(tests, "{{3, 0, 0}, 2}, 1);", "{{3, 0, 0}, 2}, contact::own_depth);")
    line = "#include <support/exercise.hpp>"
    change(tests, line, f"{line}\n#include <contact/own_depth.hpp>")
    done = in_pack(pack, "dev", "check", "overlap_depth")
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_book_is_left_as_it_was(pack: Path, before: str, tmp_path: Path) -> None:
    in_pack(pack, "list")
    in_pack(pack, "dev", "check", "--files")
    in_pack(pack, "new", "chapter", "52_last")
    shutil.rmtree(pack / "chapters" / "52_last")
    assert tree_state() == before
