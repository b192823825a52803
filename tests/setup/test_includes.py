"""Which folder may include from which: exactly the arrows in CONTRIBUTING.md."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)[>"]', re.MULTILINE)
# The room of a file; the first that fits. A folder that is not named is a room by itself.
ROOMS: Sequence[tuple[str, str]] = (
    (r"chapters/[^/]+/(contact|src)/", "chapters/*/contact"),
    (r"chapters/[^/]+/figures/", "chapters/*/figures"),
    (r"chapters/", "chapters/*/ladder"),
    (r"tests/support/", "tests/support"),
    (r"page/figure/", "page/figure"),
    (r"((?:grading|cli)/[^/]+)/", r"\1"),
    (r"([^/]+)/", r"\1"),
)
# Where a name after #include is looked for, if no file of that name lies beside.
FOLDERS = ("", "grading", "cli", "tests", "page", "page/figure")
FOLDERS_OF_EACH = ("chapters/*", "exercises/*/*")
# Not the project's own sources, or none yet: templates have tokens for names.
OTHERS = {"node_modules", "third_party", "templates"}

Arrows = dict[tuple[str, str], list[str]]  # from, to, and the includes that make it


def room_of(file: str) -> str:
    for pattern, name in ROOMS:
        if fits := re.match(pattern, file):
            return fits.expand(name)
    raise AssertionError(f"{file} lies in no room")


def sources(root: Path) -> Iterator[Path]:
    """All C++ that lies in a room."""
    for folder in sorted(root.iterdir()):
        if not folder.is_dir() or folder.name in ("build", "work") or folder.name[0] == ".":
            continue
        for file in sorted(folder.rglob("*.[ch]pp")):
            if not OTHERS & set(file.relative_to(root).parts):
                yield file


def finder(root: Path) -> Callable[[str], set[Path]]:
    """The files of the root that a name may mean; each name is looked for once."""
    folders = [root / name for name in FOLDERS]
    folders += [folder for pattern in FOLDERS_OF_EACH for folder in sorted(root.glob(pattern))]

    @cache
    def find(name: str) -> set[Path]:
        return {(folder / name).resolve() for folder in folders if (folder / name).is_file()}

    return find


def included(
    root: Path, file: Path, find: Callable[[str], set[Path]]
) -> Iterator[tuple[str, set[Path]]]:
    """Each name that a source includes, and the files of the root that it may mean."""
    for mark, name in INCLUDE.findall(file.read_text(encoding="utf-8")):
        beside = file.parent / name
        found = {beside.resolve()} if mark == '"' and beside.is_file() else find(name)
        # A submission that attacks the grader includes what is none of the book's.
        yield name, {one for one in found if one.is_relative_to(root)}


def arrows_of(root: Path) -> Arrows:
    find = finder(root)
    found: Arrows = {}
    for file in sources(root):
        name = file.relative_to(root).as_posix()
        room = room_of(name)
        for words, targets in included(root, file, find):
            for other in {room_of(one.relative_to(root).as_posix()) for one in targets} - {room}:
                found.setdefault((room, other), []).append(f"{name} includes {words} of {other}")
    return found


def drawn(text: str) -> dict[str, list[str]]:
    """The picture: a line a room, and behind its arrow the rooms that it may include, in order."""
    pictures = [one for one in re.findall(r"^```\n(.*?)^```$", text, re.M | re.S) if " -> " in one]
    assert len(pictures) == 1
    rooms: dict[str, list[str]] = {}
    # A line that begins with blanks goes on with the one before.
    for line in re.sub(r"\n +", " ", pictures[0]).splitlines():
        room, _, others = (part.strip() for part in line.partition("->"))
        if room:
            assert room not in rooms
            rooms[room] = [other.strip() for other in others.split(",") if other.strip()]
    return rooms


PICTURE = drawn((ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8"))


def not_drawn(arrows: Arrows, picture: Mapping[str, Sequence[str]]) -> list[str]:
    return [
        line
        for (room, other), lines in sorted(arrows.items())
        if other not in picture.get(room, ())
        for line in lines
    ]


def test_the_picture_shows_every_include_and_no_arrow_that_none_needs() -> None:
    arrows = arrows_of(ROOT)
    assert not_drawn(arrows, PICTURE) == []
    drawn_arrows = {(room, other) for room, others in PICTURE.items() for other in others}
    assert sorted(drawn_arrows - arrows.keys()) == []


def test_the_picture_shows_every_room() -> None:
    files = [file.relative_to(ROOT).as_posix() for file in sources(ROOT)]
    assert len(files) > 1000
    assert {room_of(file) for file in files} == PICTURE.keys()


def test_no_two_rooms_include_each_other() -> None:
    """Every arrow of the picture goes down."""
    order = {room: place for place, room in enumerate(PICTURE)}
    up = [
        (room, other)
        for room, others in PICTURE.items()
        for other in others
        if order[other] <= order[room]
    ]
    assert up == []


def test_the_page_compiles_nothing_of_the_program() -> None:
    scripts = sorted((ROOT / "page" / "wasm").glob("*.mjs"))
    assert scripts
    pattern = re.compile(r'inRoot\(\s*"cli"|["\'`/]cli/')
    assert [file.name for file in scripts if pattern.search(file.read_text(encoding="utf-8"))] == []


def test_no_chapter_knows_a_type_of_the_graders() -> None:
    chapters = [file for file in sources(ROOT) if file.is_relative_to(ROOT / "chapters")]
    assert len(chapters) > 100
    assert [file for file in chapters if "grading::" in file.read_text(encoding="utf-8")] == []


@pytest.mark.parametrize(
    ("file", "line"),
    [
        ("chapters/01_lines/contact/line.hpp", "#include <scenes/plan_report.hpp>"),
        ("chapters/01_lines/src/line.cpp", '#include "../../../cli/scenes/plan_report.hpp"'),
        ("chapters/01_lines/examples/line.cpp", "#  include <cli/scenes/plan_report.hpp>"),
        ("chapters/01_lines/contact/line.hpp", "#include <book/book.hpp>"),
        ("page/figure/contact/figure.hpp", '#include "scenes/plan_report.hpp"'),
        ("grading/grade/session.cpp", '#include "../../cli/scenes/plan_report.hpp"'),
        ("grading/book/book_files.cpp", '#include "../grade/session.hpp"'),
        ("grading/sandbox/box.cpp", "#include <grade/session.hpp>"),
        ("exercises/01_lines/cross/cross.hpp", '#include "book/book.hpp"'),
    ],
)
def test_an_include_in_the_wrong_direction_is_found(tmp_path: Path, file: str, line: str) -> None:
    headers = ("cli/scenes/plan_report.hpp", "grading/book/book.hpp", "grading/grade/session.hpp")
    for name in (*headers, file):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("#pragma once\n")
    assert arrows_of(tmp_path) == {}
    (tmp_path / file).write_text(f"#pragma once\n{line}\n")
    assert len(not_drawn(arrows_of(tmp_path), PICTURE)) == 1


def test_a_header_of_the_same_name_beside_a_source_is_its_own(tmp_path: Path) -> None:
    for name in ("cli/report.hpp", "chapters/01_lines/src/report.hpp"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("#pragma once\n")
    (tmp_path / "chapters/01_lines/src/line.cpp").write_text('#include "report.hpp"\n')
    assert arrows_of(tmp_path) == {}
