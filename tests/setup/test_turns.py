"""What goes by turns: each slice comes within three landings, alike in Python and in the page."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import page_parts  # noqa: E402
import steps  # noqa: E402
from sample import in_turn, sample, turn  # noqa: E402

LANDINGS = range(41, 71)
CHAPTERS = sorted(folder.parent.name for folder in ROOT.glob("chapters/*/chapter.toml"))
EXERCISES = sorted(
    f"{file.parents[1].name}/{file.parent.name}"
    for file in ROOT.glob("exercises/*/*/exercise.toml")
)
# Files with a list of which a turn takes less than a third, because a third takes longer than a run
# has: the attacks that stand before honest answers, a sixth of those that a turn takes.
ABOVE_THREE = {"tests/grade/hostile_run.py": 6}


@pytest.fixture(autouse=True)
def plain(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a run of all checks has set says nothing here."""
    for name in list(os.environ):
        if name.startswith("CONTACT_") and name != "CONTACT_ROOT":
            monkeypatch.delenv(name)


@pytest.mark.parametrize("each", [1, 2, 3])
@pytest.mark.parametrize("count", [1, 2, 3, 4, 16, 21, 65])
def test_thirty_landings_take_every_slice_within_three(
    count: int, each: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    taken = []
    for number in LANDINGS:
        monkeypatch.setenv("CONTACT_TURN", str(number))
        taken.append(sample(range(count), each, ""))
    for start in range(len(LANDINGS) - 2):
        assert sorted({item for slice_ in taken[start : start + 3] for item in slice_}) == list(
            range(count)
        )
    # And no run takes much more than its share.
    assert max(len(slice_) for slice_ in taken) <= -(-count // each)


@pytest.mark.parametrize("outer", [2, 3, 6])
@pytest.mark.parametrize("inner", [2, 3, 4, 5, 6, 9])
def test_a_list_inside_another_is_wholly_taken(outer: int, inner: int) -> None:
    # By the turn's own number half of the inner items would never come where outer and inner are
    # both even.
    landings = outer * inner
    for start in LANDINGS:
        seen = {
            (i, j)
            for number in range(start, start + landings)
            for i in range(7)
            if in_turn(i, outer, number)
            for j in range(inner)
            if in_turn(j, inner, number, within=outer)
        }
        assert seen == {(i, j) for i in range(7) for j in range(inner)}


def callers() -> list[Path]:
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--", "*.py", "*.mjs"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    if listed.returncode != 0:
        pytest.skip("there is no git here to list the project's files")
    files = [ROOT / name for name in listed.stdout.split("\0") if name]
    imports = re.compile(r"^from sample import|^import .*/sample\.mjs\"", re.M)
    here = Path(__file__).resolve()
    return [
        file
        for file in files
        if file != here and file.is_file() and imports.search(file.read_text())
    ]


def test_what_takes_more_than_three_landings_is_listed() -> None:
    above = {}
    called = 0
    for file in callers():
        text = file.read_text()
        # Of a list whose shares are named, the name has its number in the same file.
        each = re.findall(r"\bsample\((?:[^,()]|\([^()]*\))+, (\w+),", text)
        each += re.findall(r"^(?:const )?EACH = (\d+);?$", text, re.M)
        called += len(each)
        most = max((int(one) for one in each if one.isdecimal()), default=0)
        if most > 3:
            above[file.relative_to(ROOT).as_posix()] = most
    assert called >= 14
    assert above == ABOVE_THREE


# --- What is compiled for the page ----------------------------------------------------------------

KINDS = ("figures", "ladder", "page")


def taken_in_the_browser(environment: Mapping[str, str]) -> dict[str, list[str]]:
    """What the tests in a browser take of each kind, and under "all" the chapters there are."""
    script = (
        'import { chaptersTaken, withParts } from "./tests/browser/sample.mjs";'
        "const kinds = JSON.parse(process.argv[1]);"
        "const taken = Object.fromEntries(kinds.map((kind) => [kind, chaptersTaken(kind)]));"
        "console.log(JSON.stringify({ ...taken, all: withParts }));"
    )
    done = subprocess.run(
        ["node", "--input-type=module", "--eval", script, json.dumps(KINDS)],
        cwd=ROOT,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=True,
    )
    said: dict[str, list[str]] = json.loads(done.stdout)
    return said


@pytest.mark.parametrize(
    "environment",
    [
        {"CONTACT_TURN": "41"},
        {"CONTACT_TURN": "42", "CONTACT_TOUCHED": '{"page": ["15_restitution"]}'},
        {"CONTACT_TURN": "43", "CONTACT_TOUCHED": '{"figures": ["*"], "ladder": ["19_"]}'},
        {"CONTACT_CHAPTERS": "02_triangles,12_momentum"},
        {"CONTACT_ALL": "1"},
    ],
)
def test_what_a_browser_tests_is_compiled(
    environment: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    told = taken_in_the_browser(environment)
    assert told.pop("all") == page_parts.WITH_PARTS
    assert told == {kind: page_parts.chapters_of(kind) for kind in KINDS}
    assert set(page_parts.chapters()) == {slug for taken in told.values() for slug in taken}


def test_three_landings_compile_each_figure_and_ladder(monkeypatch: pytest.MonkeyPatch) -> None:
    for start in LANDINGS[:3]:
        seen: list[str] = []
        for number in range(start, start + 3):
            monkeypatch.setenv("CONTACT_TURN", str(number))
            seen += page_parts.chapters()
            assert page_parts.player_is_tested() == (page_parts.SCENES in page_parts.chapters())
        assert sorted(seen) == page_parts.WITH_PARTS


def only(step: object) -> list[str]:
    """What a step asks page/wasm/build.mjs for."""
    monkey = pytest.MonkeyPatch()
    asked: list[str] = []
    with monkey.context() as patched:
        patched.setattr(steps, "run", lambda command, *_, **__: asked.extend(command))
        step.run()  # type: ignore[attr-defined]
    assert asked[:4] == ["node", "wasm/build.mjs", "figures", "ladders"]
    return asked[4:]


def test_what_tests_name_is_compiled_in_each_turn(monkeypatch: pytest.MonkeyPatch) -> None:
    for number in LANDINGS[:3]:
        monkeypatch.setenv("CONTACT_TURN", str(number))
        [step] = page_parts.figures_and_ladders()
        asked = only(step)
        assert {"02_triangles/ray_triangle", "12_momentum/force_time", "--drop-outdated"} <= set(
            asked
        )
        assert set(page_parts.chapters()) <= set(asked)
        # And not the whole book.
        assert asked.count("--only") < len(page_parts.FIGURES) / 2


def test_a_chapter_without_figures_compiles_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CONTACT_CHAPTERS", "18_contacts")
    with monkeypatch.context() as patched:
        for name in ("WITH_PARTS", "EXERCISES"):
            left = [one for one in getattr(page_parts, name) if not one.startswith("18_")]
            assert len(left) < len(getattr(page_parts, name))
            patched.setattr(page_parts, name, left)
        assert page_parts.figures_and_ladders() == page_parts.compiler_and_exercises() == []
    monkeypatch.setenv("CONTACT_CHAPTERS", "02_triangles")
    [step] = page_parts.figures_and_ladders()
    assert {name.split("/")[0] for name in page_parts.exercises()} == {"02_triangles"}
    # The rest of the book stays as it is.
    assert only(step) == ["--only", "02_triangles"]


def test_the_pages_link_to_the_e_book_where_it_is_built(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    said: list[tuple[bool, str]] = []
    built = False
    monkeypatch.setattr(steps, "EBOOK", tmp_path / "some.epub")
    monkeypatch.setattr(
        steps,
        "run",
        lambda *_, extra, **__: said.append((built, extra["CONTACT_BOOK_EBOOK"])),
    )
    for number in LANDINGS[:3]:
        monkeypatch.setenv("CONTACT_TURN", str(number))
        steps.EBOOK.touch()
        built = page_parts.ebook() != []
        page_parts.pages().run()
        assert steps.EBOOK.exists() == built
    assert sorted(said) == [(False, "0"), (False, "0"), (True, "1")]
    monkeypatch.setenv("CONTACT_TOUCHED", '{"page": ["*"]}')
    assert page_parts.ebook() != []


def test_everything_is_compiled_when_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CONTACT_ALL", "1")
    [step] = page_parts.figures_and_ladders()
    assert only(step) == []


# --- What is taken whatever the turn --------------------------------------------------------------


def both(
    items: list[str], each: int, environment: Mapping[str, str], **options: object
) -> list[str]:
    """What Python and JavaScript take, which must be the same, and be told in the same words."""
    script = (
        'import { sample } from "./tests/browser/sample.mjs";'
        "const [items, each, options] = JSON.parse(process.argv[1]);"
        'console.log(JSON.stringify(sample(items, each, "things", options)));'
    )
    program = (
        "import json, sys; sys.path.insert(0, 'tools'); from sample import sample;"
        "items, each, options = json.loads(sys.argv[1]);"
        "print(json.dumps(sample(items, each, 'things', **options)))"
    )
    given = json.dumps([items, each, options])
    said = []
    for command in (
        ["node", "--input-type=module", "--eval", script, given],
        [sys.executable, "-c", program, given],
    ):
        done = subprocess.run(
            command,
            cwd=ROOT,
            env={**os.environ, **environment},
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        said.append(json.loads(done.stdout))
    assert said[0] == said[1]
    return list(said[0])


def test_python_and_javascript_take_the_same(tmp_path: Path) -> None:
    slices = tmp_path / "slices"
    told = {"CONTACT_SLICES": str(slices)}
    # Without a number in the environment, that of tools/turn.
    assert both(EXERCISES, 3, told) == sample(EXERCISES, 3, "")
    for number in (0, 7, 8, 9):
        given = {**told, "CONTACT_TURN": str(number)}
        taken = both(EXERCISES, 3, given)
        assert taken == EXERCISES[(-number) % 3 :: 3]
        assert both(EXERCISES, 4, given, within=3) == EXERCISES[-(number // 3) % 4 :: 4]
    lines = slices.read_text().splitlines()
    assert len(lines) == 18
    for mine, other in zip(lines[::2], lines[1::2], strict=True):
        assert json.loads(mine) == json.loads(other)
    assert json.loads(lines[0])["what"] == "things"
    assert sorted([*json.loads(lines[0])["ran"], *json.loads(lines[0])["left"]]) == EXERCISES


def test_what_the_change_touches_is_always_taken() -> None:
    touched = json.dumps({"exercises": [CHAPTERS[1]], "page": ["*"]})
    own = [name for name in EXERCISES if name.startswith(CHAPTERS[1])]
    assert own
    for number in (3, 4, 5):
        given = {"CONTACT_TOUCHED": touched, "CONTACT_TURN": str(number)}
        taken = both(EXERCISES, 3, given, kind="exercises")
        assert set(taken) == set(own) | set(EXERCISES[-number % 3 :: 3])
        # Of another kind it touches nothing, and of a third everything.
        assert both(EXERCISES, 3, given, kind="figures") == EXERCISES[-number % 3 :: 3]
        assert both(EXERCISES, 3, given, kind="page") == EXERCISES


def test_one_chapter_alone_is_wholly_taken() -> None:
    given = {"CONTACT_CHAPTERS": f"{CHAPTERS[1]},{CHAPTERS[2]}"}
    wanted = [name for name in EXERCISES if name.startswith((CHAPTERS[1], CHAPTERS[2]))]
    assert both(EXERCISES, 3, given, kind="exercises") == wanted
    # What is of no chapter goes by turns all the same.
    assert len(both(EXERCISES, 3, given)) < len(EXERCISES) / 2


def test_everything_is_taken_when_asked_for() -> None:
    assert both(EXERCISES, 3, {"CONTACT_ALL": "1"}) == EXERCISES


def test_a_turn_that_is_no_number_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CONTACT_TURN", "seven")
    with pytest.raises(ValueError, match="CONTACT_TURN must hold one whole number"):
        turn()
