"""The book together with a pack, from which `./contact --pack FOLDER serve` builds the pages."""

from __future__ import annotations

import shutil
import sys
import tomllib
from pathlib import Path

import pytest
from packs import CHAPTER, EXERCISE, ROOT, new_pack, tree_state

sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "grading" / "book")]

from book_json import book_json  # noqa: E402
from pack_book import pack_book  # noqa: E402


@pytest.fixture(scope="module")
def pack(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return new_pack(tmp_path_factory.mktemp("packs") / "pack")


@pytest.fixture(scope="module")
def both(pack: Path) -> Path:
    return pack_book(pack)


def times(folder: Path) -> dict[Path, int]:
    return {
        file: file.lstat().st_mtime_ns
        for file in folder.rglob("*")
        if file.is_file() and "node_modules" not in file.parts and "build" not in file.parts
    }


def test_it_is_in_the_packs_build(pack: Path, both: Path) -> None:
    assert both == pack / "build" / "book"


def test_chapters_of_both_are_there(both: Path) -> None:
    assert {"02_triangles", CHAPTER} <= set(book_json(both)["chapters"])


def test_exercises_of_both_are_there(both: Path) -> None:
    assert {"02_triangles/ray_triangle", EXERCISE} <= set(book_json(both)["exercises"])


def test_files_of_both_are_understood(both: Path) -> None:
    assert book_json(both)["problems"] == {}


def test_misconceptions_of_both_are_there(both: Path) -> None:
    found = tomllib.loads((both / "chapters/misconceptions.toml").read_text())
    assert {"touching-rejected", "one-radius"} <= set(found)


def test_what_is_installed_is_that_of_the_book(both: Path) -> None:
    assert (both / "build/venv").resolve() == (ROOT / "build/venv").resolve()


def test_the_second_time_nothing_is_written(pack: Path, both: Path) -> None:
    before = times(both)
    pack_book(pack)
    assert times(both) == before


def test_an_exercise_that_was_deleted_is_gone(tmp_path: Path) -> None:
    pack = new_pack(tmp_path / "pack")
    pack_book(pack)
    shutil.rmtree(pack / "exercises" / EXERCISE)
    assert not (pack_book(pack) / "exercises" / EXERCISE).exists()


def test_the_packs_own_files_stay_as_they_are(pack: Path, both: Path) -> None:
    before = {file: time for file, time in times(pack).items() if both not in file.parents}
    pack_book(pack)
    assert {file: time for file, time in times(pack).items() if both not in file.parents} == before


def test_the_books_folder_stays_as_it_is(pack: Path) -> None:
    before = tree_state()
    pack_book(pack)
    assert tree_state() == before
