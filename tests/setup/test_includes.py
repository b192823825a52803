"""Which folder may include from which: the book's code knows nothing of the program beside it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)[>"]', re.MULTILINE)
# What a source may not read, and where a name after #include is looked for there.
FORBIDDEN = {"cli": ("", "cli"), "grading": ("", "grading")}
# What is compiled for the page or for a chapter; page/wasm runs the grading library in the page.
WITHOUT = {"chapters": ("cli", "grading"), "page": ("cli",)}


def sources(root: Path, folder: str) -> Iterator[Path]:
    for file in sorted((root / folder).rglob("*")):
        parts = file.relative_to(root).parts
        if file.suffix in (".cpp", ".hpp") and not {"node_modules", "third_party"} & set(parts):
            yield file


def included(root: Path, file: Path, tree: str) -> list[str]:
    """What a source includes from a folder of the root, by any of the names that find it there."""
    found = []
    for mark, name in INCLUDE.findall(file.read_text(encoding="utf-8")):
        beside = (file.parent / name).resolve()
        if mark == '"' and beside.is_file():
            targets = [beside]
        else:
            targets = [(root / start / name).resolve() for start in FORBIDDEN[tree]]
        if any(target.is_file() and target.is_relative_to(root / tree) for target in targets):
            found.append(f"{file.relative_to(root)} includes {name} of {tree}/")
    return found


def wrong_directions(root: Path) -> list[str]:
    return [
        line
        for folder, trees in WITHOUT.items()
        for file in sources(root, folder)
        for tree in trees
        for line in included(root, file, tree)
    ]


def test_chapters_and_the_page_include_nothing_of_the_program() -> None:
    assert len(list(sources(ROOT, "chapters"))) > 100
    assert wrong_directions(ROOT) == []


def test_the_page_compiles_nothing_of_the_program() -> None:
    scripts = sorted((ROOT / "page" / "wasm").glob("*.mjs"))
    assert scripts
    pattern = re.compile(r'inRoot\(\s*"cli"|["\'`/]cli/')
    assert [file.name for file in scripts if pattern.search(file.read_text(encoding="utf-8"))] == []


def test_no_chapter_knows_a_type_of_the_graders() -> None:
    files = sources(ROOT, "chapters")
    assert [file for file in files if "grading::" in file.read_text(encoding="utf-8")] == []


@pytest.mark.parametrize(
    ("file", "line"),
    [
        ("chapters/01_lines/contact/line.hpp", "#include <scenes/scene_file.hpp>"),
        ("chapters/01_lines/src/line.cpp", '#include "../../../cli/plan_report.hpp"'),
        ("chapters/01_lines/examples/line.cpp", "#  include <cli/plan_report.hpp>"),
        ("chapters/01_lines/contact/line.hpp", "#include <book.hpp>"),
        ("page/figure/contact/figure.hpp", '#include "plan_report.hpp"'),
    ],
)
def test_an_include_in_the_wrong_direction_is_found(tmp_path: Path, file: str, line: str) -> None:
    for name in ("cli/scenes/scene_file.hpp", "cli/plan_report.hpp", "grading/book.hpp", file):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("#pragma once\n")
    assert wrong_directions(tmp_path) == []
    (tmp_path / file).write_text(f"#pragma once\n{line}\n")
    assert len(wrong_directions(tmp_path)) == 1


def test_a_header_of_the_same_name_beside_a_source_is_its_own(tmp_path: Path) -> None:
    for name in ("cli/report.hpp", "chapters/01_lines/src/report.hpp"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("#pragma once\n")
    (tmp_path / "chapters/01_lines/src/line.cpp").write_text('#include "report.hpp"\n')
    assert wrong_directions(tmp_path) == []
