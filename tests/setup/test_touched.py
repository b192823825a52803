"""What a change touches: compared with what sources include, and with cases written by hand. With
what a compiler has read it is compared in tests/built."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from touched import (  # noqa: E402
    CODE,
    EVERYTHING,
    Book,
    base_of_landing,
    changed_since,
    chapters_of,
    narrowed,
    read_book,
    touched_by,
)

BOOK = read_book(ROOT)
CHAPTERS = sorted(BOOK.builds_on)


def touched(*files: str, book: Book = BOOK) -> dict[str, set[str]]:
    return touched_by(files, book)


# --- Against the tree -----------------------------------------------------------------------------


def test_every_header_touches_who_includes_it_by_its_text() -> None:
    # The same without a build: a closure of its own over names, which in contact/ are unique.
    text = {
        file: set(re.findall(r"#include <contact/(?:\w+/)?(\w+)\.hpp>", file.read_text()))
        for folder in ("chapters", "tests", "page/figure")
        for file in (ROOT / folder).rglob("*.[ch]pp")
    }
    headers = sorted(ROOT.glob("chapters/*/contact/**/*.hpp"))
    assert len({header.stem for header in headers}) == len(headers) > 50
    for header in headers:
        closed = {header.stem}
        while True:
            more = {f.stem for f in headers if text[f] & closed} - closed
            if not more:
                break
            closed |= more
        using = {
            file.relative_to(ROOT).parts[1]
            for file, names in text.items()
            if names & closed and re.match(r"\d\d_", file.relative_to(ROOT).parts[1])
        }
        found = touched(header.relative_to(ROOT).as_posix())
        assert using <= found["tests"], header
        assert header.relative_to(ROOT).parts[1] in found["headers"]


def test_every_file_of_a_chapter_touches_it() -> None:
    for chapter in CHAPTERS:
        for folder in ("chapters", "exercises", "solutions", "tests"):
            for file in (ROOT / folder / chapter).rglob("*"):
                if file.is_file() and "__pycache__" not in file.parts:
                    name = file.relative_to(ROOT).as_posix()
                    assert chapter in chapters_of(touched(name), BOOK), name


# --- By hand --------------------------------------------------------------------------------------


SMALL = Book(
    builds_on={
        "00_a": frozenset(),
        "01_b": frozenset({"00_a"}),
        "02_c": frozenset({"01_b"}),
        "03_d": frozenset({"00_a"}),
    },
    included_by={"tests/01_b/truth.hpp": frozenset({"tests/03_d/hard_cases.cpp"})},
)


def small(*files: str) -> dict[str, set[str]]:
    return touched(*files, book=SMALL)


def test_a_header_touches_whatever_builds_on_it() -> None:
    found = small("chapters/01_b/contact/plane.hpp")
    assert found == {kind: {"01_b", "02_c"} for kind in CODE}
    assert small("chapters/00_a/contact/x.hpp")["figures"] == {"00_a", "01_b", "02_c", "03_d"}
    assert small("chapters/01_b/src/plane.cpp") == found


def test_a_lesson_touches_its_page_alone() -> None:
    assert small("chapters/01_b/lesson.md") == {"page": {"01_b"}}


def test_an_exercise_touches_its_chapter() -> None:
    assert small("exercises/01_b/x/x.hpp") == {"exercises": {"01_b"}, "page": {"01_b"}}
    assert small("solutions/02_c/x/wrong/y.cpp")["exercises"] == {"02_c"}


def test_a_header_of_tests_touches_who_includes_it() -> None:
    found = small("tests/01_b/truth.hpp")
    assert found["tests"] == {"01_b", "03_d"}
    assert found["page"] == {"01_b"}


@pytest.mark.parametrize(
    ("file", "kinds"),
    [
        ("tests/support/oracle.hpp", {"tests", "exercises"}),
        ("tests/support/ladder.cpp", {"ladder"}),
        ("grading/contact/value.hpp", {"tests", "exercises", "tidy"}),
        ("grading/contract/contract_generator.py", {"tests", "exercises"}),
        ("grading/diagnosis/claims.cpp", {"explain"}),
        ("cmake/ContactTargets.cmake", {*CODE, "authors"}),
        ("page/wasm/flags.mjs", {"figures", "ladder", "exercises", "page"}),
        ("page/web/src/figure.ts", {"figures", "ladder", "exercises", "page"}),
        ("docs/_ext/contact_book/ask.py", {"page", "builder"}),
    ],
)
def test_what_all_share_touches_all(file: str, kinds: set[str]) -> None:
    found = small(file)
    assert {kind for kind, names in found.items() if EVERYTHING in names} == kinds
    if kinds != {"explain"}:
        assert chapters_of(found, SMALL) == sorted(SMALL.builds_on)


@pytest.mark.parametrize(
    "file",
    ["README.md", "tools/serve.py", "tests/serve/test_serve.py", "page/wasm/loader.test.mjs"],
)
def test_what_no_chapter_is_made_of_touches_none(file: str) -> None:
    assert small(file) == {}


def test_a_source_that_judges_is_linted_and_its_header_lints_all() -> None:
    assert small("grading/run/runner.cpp")["tidy"] == {"grading/run/runner.cpp"}
    assert small("grading/run/runner.hpp")["tidy"] == {EVERYTHING}
    assert small(".clang-tidy")["tidy"] == {EVERYTHING}


def test_a_template_is_built_and_touches_no_chapter() -> None:
    assert small("cli/authors/templates/figure.cpp") == {"authors": {EVERYTHING}}
    assert small("cli/authors/dev_check.hpp") == {}


@pytest.mark.parametrize(
    ("file", "kind"),
    [
        ("grading/grade/session.cpp", "grading"),
        ("cli/grade/grade.cpp", "grading"),
        ("tests/grade/test_slurm.py", "grading"),
        ("tests/docs/test_map.py", "builder"),
    ],
)
def test_what_lies_around_grading_and_the_book_touches_no_chapter(file: str, kind: str) -> None:
    found = small(file)
    assert found[kind] == {EVERYTHING}
    assert chapters_of(found, SMALL) == []


def test_an_attack_touches_itself() -> None:
    assert small("tests/grade/hostile/fork_bomb.cpp") == {"hostile": {"fork_bomb"}}


# --- What a run takes of it -----------------------------------------------------------------------


def test_a_run_takes_all_that_a_narrow_change_touches() -> None:
    narrow = {
        "tests": {"02_triangles"},
        "figures": {EVERYTHING},
        "page": set(CHAPTERS),
        "tidy": {"*"},
    }
    assert narrowed(narrow, BOOK) == (narrow, [])


def test_of_a_change_that_touches_nearly_everything_the_turn_selects() -> None:
    half, more = set(CHAPTERS[: len(CHAPTERS) // 2]), set(CHAPTERS[: len(CHAPTERS) // 2 + 1])
    wide = {"headers": half, "tests": {EVERYTHING}, "page": {EVERYTHING}, "tidy": {EVERYTHING}}
    taken, by_turn = narrowed({**wide, "figures": more}, BOOK)
    assert by_turn == ["tests", "figures", "page"]
    assert taken == {"headers": half, "tidy": {EVERYTHING}}
    assert narrowed({**wide, "figures": half}, BOOK)[1] == []


# --- Which files have changed ---------------------------------------------------------------------


def git(folder: Path, *words: str) -> str:
    identity = ("-c", "user.name=A", "-c", "user.email=a@b.c", "-c", "commit.gpgsign=false")
    command = ["git", "-C", str(folder), *identity, *words]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


def put(file: Path, text: str) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)


def landed(folder: Path, turn: int, **files: str) -> str:
    for name, text in {"tools/turn": f"{turn}\n", **files}.items():
        put(folder / name, text)
    git(folder, "add", "-A")
    git(folder, "commit", "-q", "-m", "docs: go on")
    return git(folder, "rev-parse", "HEAD")


def test_committed_changed_new_and_deleted_files_count(tmp_path: Path) -> None:
    git(tmp_path, "init", "-q", "-b", "main")
    first = landed(tmp_path, 1, gone="a", kept="a", changed="a", **{"with space": "a"})
    (tmp_path / "gone").unlink()
    landed(tmp_path, 2, committed="a")
    put(tmp_path / "changed", "b")
    put(tmp_path / "with space", "b")
    put(tmp_path / "new/file", "b")
    assert changed_since(tmp_path, first) == [
        "changed",
        "committed",
        "gone",
        "new/file",
        "tools/turn",
        "with space",
    ]
    assert changed_since(tmp_path, "0123456789") is None


def test_only_what_this_branch_changed_counts(tmp_path: Path) -> None:
    git(tmp_path, "init", "-q", "-b", "main")
    landed(tmp_path, 1)
    git(tmp_path, "switch", "-q", "-c", "other")
    landed(tmp_path, 2, mine="a")
    git(tmp_path, "switch", "-q", "main")
    landed(tmp_path, 2, theirs="a")
    git(tmp_path, "switch", "-q", "other")
    assert changed_since(tmp_path, "main") == ["mine", "tools/turn"]


def test_a_landing_begins_where_the_last_one_ended(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("CONTACT_SINCE", raising=False)
    git(tmp_path, "init", "-q", "-b", "main")
    assert base_of_landing(tmp_path) is None
    first = landed(tmp_path, 1)
    assert base_of_landing(tmp_path) is None
    second = landed(tmp_path, 2, a="a")
    assert base_of_landing(tmp_path) == first
    git(tmp_path, "update-ref", "refs/remotes/origin/main", second)
    landed(tmp_path, 3, b="b")
    assert base_of_landing(tmp_path) == "origin/main"
    monkeypatch.setenv("CONTACT_SINCE", first)
    assert base_of_landing(tmp_path) == first
    # What a push to a new branch gives.
    monkeypatch.setenv("CONTACT_SINCE", "0" * 40)
    assert base_of_landing(tmp_path) == "origin/main"
