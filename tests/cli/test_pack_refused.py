"""A bad pack is refused, with the file and the line of each fault."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from packs import CHAPTER, EXERCISE, ROOT, change, in_pack, new_pack

VERSION = re.search(r"ContactHours VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())
assert VERSION is not None


@pytest.fixture
def pack(tmp_path: Path) -> Path:
    return new_pack(tmp_path / "pack")


def refused(pack: Path, file: str, line: int) -> str:
    """What is said of this line, after which nothing is done."""
    done = in_pack(pack, "list")
    assert done.returncode == 3
    assert done.stdout == ""
    start = f"{pack / file}:{line}: "
    (found,) = [one.strip() for one in done.stderr.splitlines() if start in one]
    return found.removeprefix(start)


@pytest.mark.parametrize("key", ["name", "title", "book", "authors"])
def test_a_missing_key(pack: Path, key: str) -> None:
    file = pack / "pack.toml"
    file.write_text(re.sub(rf"(?m)^{key} = .*\n", "", file.read_text()))
    assert refused(pack, "pack.toml", 1) == f"the key '{key}' is missing"


def test_an_unknown_key(pack: Path) -> None:
    line = change(pack / "pack.toml", "authors = ", 'colour = "red"\nauthors = ')
    assert "unknown key 'colour'" in refused(pack, "pack.toml", line)


def test_a_file_that_is_no_toml(pack: Path) -> None:
    line = change(pack / "pack.toml", "authors = ", "authors ! ")
    assert refused(pack, "pack.toml", line)


def test_no_range_of_versions(pack: Path) -> None:
    line = change(pack / "pack.toml", 'book = ">=', 'book = "about ')
    assert "is a range of versions" in refused(pack, "pack.toml", line)


def with_range(pack: Path, text: str) -> int:
    file = pack / "pack.toml"
    file.write_text(re.sub(r'(?m)^book = ".*"', f'book = "{text}"', file.read_text()))
    return file.read_text().splitlines().index(f'book = "{text}"') + 1


@pytest.mark.parametrize("text", [">=99", "99.1", "<0.0.1", ">=0,<0", "==99.1.2"])
def test_another_version(pack: Path, text: str) -> None:
    said = refused(pack, "pack.toml", with_range(pack, text))
    assert VERSION is not None
    assert f"needs version {text} of the book, and this book is version {VERSION[1]}" in said


@pytest.mark.parametrize(
    "text", ["0", ">=0.0.1, <99", f"=={VERSION[1]}", VERSION[1], ">0.0,<=99.9.9"]
)
def test_a_version_that_is_allowed(pack: Path, text: str) -> None:
    with_range(pack, text)
    assert in_pack(pack, "list").returncode == 0


def renamed_exercise(pack: Path, name: str) -> int:
    shutil.move(pack / f"exercises/{EXERCISE}", pack / f"exercises/{CHAPTER}/{name}")
    chapter = pack / f"chapters/{CHAPTER}/chapter.toml"
    return change(chapter, 'exercises = ["overlap_depth"]', f'exercises = ["{name}"]')


def test_the_name_of_an_exercise_of_the_book(pack: Path) -> None:
    line = renamed_exercise(pack, "ray_triangle")
    said = refused(pack, f"chapters/{CHAPTER}/chapter.toml", line)
    assert "02_triangles/ray_triangle" in said


@pytest.mark.parametrize(
    ("slug", "words"),
    [("50_triangles", "a chapter of this name"), ("02_first", "a chapter of this number")],
)
def test_the_name_of_a_chapter_of_the_book(pack: Path, slug: str, words: str) -> None:
    for tree in ("chapters", "exercises", "solutions", "tests"):
        (pack / tree / CHAPTER).rename(pack / tree / slug)
    said = refused(pack, f"chapters/{slug}/chapter.toml", 1)
    assert words in said
    assert "02_triangles" in said


def test_the_name_of_a_header_of_the_book(pack: Path) -> None:
    header = f"chapters/{CHAPTER}/contact/shapes.hpp"
    (pack / header).parent.mkdir()
    (pack / header).touch()
    assert "00_vectors" in refused(pack, header, 1)


def test_a_misconception_of_the_book(pack: Path) -> None:
    file = pack / "chapters/misconceptions.toml"
    line = change(file, "[one-radius]", "[touching-rejected]")
    assert "touching-rejected" in refused(pack, "chapters/misconceptions.toml", line)


@pytest.mark.parametrize("tree", ["chapters", "exercises"])
def test_a_folder_that_is_missing(pack: Path, tree: str) -> None:
    shutil.rmtree(pack / tree)
    assert f"the folder {tree}/ is missing" in refused(pack, "pack.toml", 1)


def test_the_folder_of_an_exercise_that_is_missing(pack: Path) -> None:
    shutil.rmtree(pack / f"exercises/{EXERCISE}")
    text = (pack / f"chapters/{CHAPTER}/chapter.toml").read_text()
    line = text[: text.index("overlap_depth")].count("\n") + 1
    said = refused(pack, f"chapters/{CHAPTER}/chapter.toml", line)
    assert f"exercises/{EXERCISE}/ is missing" in said


def test_a_solution_that_is_missing(pack: Path) -> None:
    (pack / f"solutions/{EXERCISE}/overlap_depth.cpp").unlink()
    said = refused(pack, f"exercises/{EXERCISE}/exercise.toml", 1)
    assert f"solutions/{EXERCISE}/overlap_depth.cpp" in said


def test_a_chapter_that_nothing_has(pack: Path) -> None:
    line = change(pack / f"chapters/{CHAPTER}/chapter.toml", "00_vectors", "00_victors")
    assert "00_victors" in refused(pack, f"chapters/{CHAPTER}/chapter.toml", line)


def test_an_unknown_key_of_an_exercise(pack: Path) -> None:
    line = change(pack / f"exercises/{EXERCISE}/exercise.toml", "minutes = ", "minute = ")
    said = refused(pack, f"exercises/{EXERCISE}/exercise.toml", line)
    assert "unknown key 'minute'" in said


def test_a_folder_without_a_pack(tmp_path: Path) -> None:
    assert "new pack" in refused(tmp_path, "pack.toml", 1)


def test_dev_check_finds_what_nothing_would_build(pack: Path) -> None:
    (pack / f"chapters/{CHAPTER}/examples").mkdir()
    done = in_pack(pack, "dev", "check", "--files")
    assert done.returncode == 1
    assert "examples: nothing uses this in a pack" in done.stdout


def test_a_new_pack_goes_into_no_folder_with_files(tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text("mine")
    done = in_pack(None, "new", "pack", str(tmp_path))
    assert done.returncode == 3
    assert [file.name for file in tmp_path.iterdir()] == ["mine.txt"]


def test_a_new_pack_is_not_inside_the_book() -> None:
    done = in_pack(None, "new", "pack", str(ROOT / "build" / "my_pack"))
    assert done.returncode == 2
    assert not (ROOT / "build" / "my_pack").exists()


@pytest.mark.parametrize(
    "words", [("exercise", "50_first_steps/ray_triangle"), ("chapter", "60_triangles")]
)
def test_new_takes_no_name_of_the_book(pack: Path, words: tuple[str, str]) -> None:
    done = in_pack(pack, "new", *words)
    assert done.returncode == 3
    assert "02_triangles" in done.stderr


def script(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [str(ROOT / "contact"), *words], capture_output=True, text=True, timeout=60, check=False
    )


@pytest.mark.parametrize(
    "words", [("test",), ("setup",), ("simulate", "x"), ("dev", "mutants"), ("new", "pack")]
)
def test_commands_of_the_book_are_refused(pack: Path, words: tuple[str, ...]) -> None:
    done = script("--pack", str(pack), *words)
    assert done.returncode == 2
    assert "use it without --pack" in done.stderr


def test_the_script_names_a_folder_that_is_not_there(tmp_path: Path) -> None:
    done = script("--pack", str(tmp_path / "nowhere"), "list")
    assert done.returncode == 2
    assert str(tmp_path / "nowhere") in done.stderr
