"""build/book.json says what the chapters' files say, is never stale, and is what is read elsewhere:
by the program, which reads the files itself, and by CMake, which reads one line of them.
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "grading" / "book"))

from book_json import book_json  # noqa: E402

CHAPTER = "chapters/02_triangles/chapter.toml"
EXERCISE = "exercises/02_triangles/ray_triangle/exercise.toml"
WRITER = ROOT / "grading" / "book" / "book_json.py"


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """The files that say what there is, and no other."""
    for name in (CHAPTER, EXERCISE, "chapters/misconceptions.toml"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / name, tmp_path / name)
    return tmp_path


def edit(file: Path, old: str, new: str) -> None:
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new, 1))


def test_the_book_has_no_mistakes_in_it() -> None:
    registry = book_json()
    assert registry["problems"] == {}
    assert len(registry["chapters"]) == len(list(ROOT.glob("chapters/*/chapter.toml"))) > 10
    assert len(registry["exercises"]) == len(list(ROOT.glob("exercises/*/*/exercise.toml"))) > 40


def test_the_program_reads_the_same() -> None:
    program = ROOT / "build" / "dev" / "bin" / "contact"
    if not program.is_file():
        pytest.skip("the program is not built")
    done = subprocess.run(
        [program, "dev", "registry"], capture_output=True, text=True, check=True, cwd=ROOT
    )
    said: dict[str, Any] = json.loads(done.stdout)
    registry = book_json()
    for chapter in registry["chapters"].values():
        # What only a page needs.
        del chapter["in_lesson"], chapter["sources"]
    for exercise in registry["exercises"].values():
        del exercise["inputs"]
    for kind in ("chapters", "exercises", "misconceptions"):
        assert said[kind] == registry[kind]


def test_each_field_of_the_page_is_for_a_function_of_its_contract() -> None:
    breaking = {ref: said for ref, said in book_json()["exercises"].items() if said["breaks"]}
    assert breaking
    for ref, said in breaking.items():
        contract = (ROOT / "exercises" / ref / f"{ref.split('/')[1]}.hpp").read_text()
        declared = re.findall(r"^[\w:<>]+ (\w+)\(\);$", contract, re.MULTILINE)
        assert [one["function"] for one in said["inputs"]] == declared, ref
        for one in said["inputs"]:
            if not isinstance(one["start"], dict):
                continue
            # The members in their order, as C++ wants them.
            (members,) = re.findall(r"^struct \w+ \{\n(.*?)^\};", contract, re.M | re.S)
            assert list(one["start"]) == re.findall(r"^  \S+ (\w+);", members, re.MULTILINE), ref


def test_cmake_reads_the_same(tmp_path: Path) -> None:
    script = tmp_path / "script.cmake"
    slugs = sorted(book_json()["chapters"])
    script.write_text(
        "cmake_minimum_required(VERSION 3.25)\n"
        f'set(PROJECT_SOURCE_DIR "{ROOT}")\nset(CONTACT_CHAPTERS "{";".join(slugs)}")\n'
        f'include("{ROOT}/cmake/ContactChapters.cmake")\n'
        "foreach(chapter IN LISTS CONTACT_CHAPTERS)\n"
        '  contact_read_builds_on("${chapter}" earlier)\n'
        '  message(NOTICE "${chapter}: ${earlier}")\nendforeach()\n'
    )
    done = subprocess.run(["cmake", "-P", script], capture_output=True, text=True, check=True)
    read = dict(line.split(": ", 1) for line in done.stderr.splitlines())
    assert {slug: said["builds_on"] for slug, said in book_json()["chapters"].items()} == {
        slug: [name for name in read[slug].strip().split(";") if name] for slug in slugs
    }


def test_it_is_written_when_something_changed_and_only_then(copy: Path) -> None:
    file = copy / "build" / "book.json"
    first = book_json(copy)
    assert json.loads(file.read_text()) == first
    before = file.stat()
    (copy / CHAPTER).touch()
    assert book_json(copy) == first
    assert (file.stat().st_mtime_ns, file.stat().st_ino) == (before.st_mtime_ns, before.st_ino)

    edit(copy / CHAPTER, 'status = "lesson"', 'status = "reference"')
    assert book_json(copy)["chapters"]["02_triangles"]["status"] == "reference"
    (copy / EXERCISE).unlink()
    assert book_json(copy)["exercises"] == {}
    shutil.copy2(ROOT / EXERCISE, copy / EXERCISE)
    assert list(book_json(copy)["exercises"]) == ["02_triangles/ray_triangle"]
    file.write_text("{")
    assert list(book_json(copy)["exercises"]) == ["02_triangles/ray_triangle"]
    assert [entry.name for entry in file.parent.iterdir()] == ["book.json"]


@pytest.mark.parametrize(
    ("name", "old", "new", "words"),
    [
        (CHAPTER, 'status = "lesson"\n', "", "'status' is missing"),
        (CHAPTER, 'status = "lesson"', 'status = "draft"', "status is 'lesson' or 'reference'"),
        (CHAPTER, "part = 1", "part = 9", "part is 0 to 3, not 9"),
        (CHAPTER, "part = 1", 'part = "1"', "'part' should be int, not str"),
        (CHAPTER, "builds_on", "build_on", "unknown key 'build_on'; there is: builds_on, "),
        (CHAPTER, "[[objectives]]\nid", "[[objectives]]\nname", "objectives 1: 'id' is missing"),
        (EXERCISE, "[[tests]]\n", "[[tests]]\nworth = 1\n", "tests 1: unknown key 'worth'"),
        (EXERCISE, "[[tests]]\nname", "[[tests]]\nnom", "tests 1: 'name' is missing"),
        (EXERCISE, "hints = [", "hints = [1, ", "'hints' should hold strings, not 1"),
        (EXERCISE, 'title = "', 'title = x"', "line 1"),
    ],
)
def test_a_mistake_is_told_with_its_file_and_keeps_the_others(
    copy: Path, name: str, old: str, new: str, words: str
) -> None:
    edit(copy / name, old, new)
    registry = book_json(copy)
    assert list(registry["problems"]) == [name]
    told = registry["problems"][name]
    assert told.startswith(f"{name}: ")
    assert words in told
    assert len(registry["chapters"]) + len(registry["exercises"]) == 1
    done = subprocess.run(
        [sys.executable, WRITER, "--root", copy], capture_output=True, text=True, check=True
    )
    assert Path(done.stdout.strip()) == copy / "build" / "book.json"
    assert told in done.stderr
