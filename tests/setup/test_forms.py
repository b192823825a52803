"""The forms that are made of a solution with marks: pieces, gaps, shuffled lines, distractors."""

from __future__ import annotations

import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "grading" / "book" / "forms.py"
sys.path.append(str(PROGRAM.parent))

from forms import (  # noqa: E402
    distractors,
    fill_text,
    form_data,
    has_marks,
    order_text,
    problems_of,
    solution_file,
)
from marks import MarkError, parts_of, without_marks  # noqa: E402
from wrong_answers import as_patch, header_size, sources, text_of  # noqa: E402

REF = "01_lines/double"
MARKED = """#include "double.hpp"

// Doubles.
int doubled(int x) {
  //? A sum begins
  //? at zero.
  int sum = 0;

  //? Adding twice doubles.
  //? gap: sum + x
  sum = sum + x;
  sum += x;
  //? This is the sum.
  return sum;
}
"""
SHOWN = """#include "double.hpp"

// Doubles.
int doubled(int x) {
  int sum = 0;

  sum = sum + x;
  sum += x;
  return sum;
}
"""
HEADER = "// misconception: sign\n// caught by: a test\n"
BLANK = sorted(
    f"{file.parent.parent.name}/{file.parent.name}"
    for file in ROOT.glob("exercises/*/*/exercise.toml")
    if tomllib.loads(file.read_text(encoding="utf-8"))["kind"] == "blank"
)


def code(text: str) -> list[str]:
    lines = [line.strip() for line in text.splitlines()]
    return [line for line in lines if line and not line.startswith("//")]


@pytest.fixture
def root(tmp_path: Path) -> Path:
    folder = tmp_path / "solutions" / REF
    (folder / "wrong").mkdir(parents=True)
    (folder / "double.cpp").write_text(MARKED)
    return tmp_path


def put(root: Path, name: str, changed: str) -> None:
    (root / "solutions" / REF / "wrong" / name).write_text(HEADER + changed)


def test_marks_are_not_shown_and_divide_the_rest() -> None:
    assert without_marks(MARKED) == SHOWN
    parts = parts_of(MARKED)
    assert "".join(part.text for part in parts) == SHOWN
    assert [part.reason for part in parts] == [
        "",
        "A sum begins at zero.",
        "Adding twice doubles.",
        "This is the sum.",
        "",
    ]
    assert parts[2].gaps == ("sum + x",)


def test_a_mark_without_a_reason_is_refused() -> None:
    with pytest.raises(MarkError, match="line 4"):
        parts_of("int f() {\n  //? One.\n  g();\n  //? gap: 1 + 1\n  return 1 + 1;\n}\n")


def test_a_gap_is_a_hole_that_the_gap_fills() -> None:
    text = fill_text(parts_of(MARKED))
    assert "sum = /* gap 1 */;" in text
    assert text.replace("/* gap 1 */", "sum + x") == SHOWN


def test_gaps_are_numbered_as_they_stand() -> None:
    (part,) = parts_of(
        "  //? A product.\n  //? gap: c * d\n  //? gap: a * b\n  return a * b + c * d;\n"
    )
    assert fill_text([part]) == "  return /* gap 1 */ + /* gap 2 */;\n"


def test_a_wrong_answer_gives_the_piece_in_which_it_differs(root: Path) -> None:
    put(root, "minus.cpp", SHOWN.replace("sum += x", "sum -= x"))
    put(root, "two_pieces.cpp", SHOWN.replace("= 0", "= 1").replace("return sum", "return 0"))
    put(root, "fixed.cpp", SHOWN.replace("int x", "int y"))
    (found,) = distractors(REF, parts_of(MARKED), root)
    assert (found.of, found.misconception) == (2, "sign")
    assert code(found.text) == ["sum = sum + x;", "sum -= x;"]


def test_a_patch_is_against_the_solution_as_it_is_shown(root: Path) -> None:
    wrong = HEADER + SHOWN.replace("sum = 0", "sum = 1")
    patch = as_patch(wrong, SHOWN, ("a", "b"))
    file = root / "solutions" / REF / "wrong" / "one.patch"
    file.write_text(patch)
    assert text_of(file) == wrong
    assert [item.of for item in distractors(REF, parts_of(MARKED), root)] == [1]


@pytest.mark.parametrize(
    ("old", "new", "problem"),
    [
        ("gap: sum + x", "gap: sum", "must occur exactly once"),
        ("gap: sum + x", "gap: absent + x", "must occur exactly once"),
        ("gap: sum + x", "gap: +=", None),
        ("gap: sum + x", "gap: =", "must occur exactly once"),
        ("  //? gap: sum + x\n", "", "it has no gap"),
        ("This is the sum.", "This is the sum", "must be a sentence"),
        ("  //? Adding twice doubles.\n  //? gap: sum + x\n", "", "lines to order"),
        ("gap: sum + x", "gap: sum + x\n  //? gap: + x", "overlap"),
        ("int sum = 0;", "// nothing", "has no code"),
        ("return sum;", "sum = sum + x;\n  sum += x;", "are equal"),
    ],
)
def test_what_is_wrong_with_marks_is_said(
    root: Path, old: str, new: str, problem: str | None
) -> None:
    assert problems_of(REF, root) == []
    assert old in MARKED
    solution_file(REF, root).write_text(MARKED.replace(old, new))
    problems = problems_of(REF, root)
    if problem is None:
        assert problems == []
    else:
        assert any(problem in line for line in problems), problems
    done = subprocess.run(
        [sys.executable, str(PROGRAM), "--root", str(root), "--check", REF],
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stdout) == (
        1 if problems else 0,
        "".join(f"{REF}: {line}\n" for line in problems),
    )


def test_a_trivial_gap_is_refused(root: Path) -> None:
    solution_file(REF, root).write_text(MARKED.replace("gap: sum + x", "gap: sum += x;"))
    assert problems_of(REF, root) == []
    solution_file(REF, root).write_text(
        MARKED.replace("int sum = 0", "int sum = 17").replace("at zero.", "at 17.\n  //? gap: 17")
    )
    assert any("trivial" in line for line in problems_of(REF, root))


@pytest.mark.parametrize("exercise", BLANK)
def test_every_exercise_from_a_blank_page_has_usable_marks(exercise: str) -> None:
    assert has_marks(exercise)
    assert problems_of(exercise) == []


@pytest.mark.parametrize("exercise", BLANK)
def test_the_lines_are_shuffled_and_their_order_is_the_solution(exercise: str) -> None:
    data = form_data(exercise)
    assert data is not None
    runs = [[row for row in run if len(row) == 1] for run in data["runs"]]
    pieces = [at for at, part in enumerate(data["parts"]) if part["reason"]]
    assert sorted(row[0] for run in runs for row in run) == pieces
    rows = [run for run in data["runs"] if len(run) > 1]
    assert rows
    for run in rows:
        assert run != sorted(run, key=lambda row: (len(row), row))
        pieces = [row for row in run if len(row) == 1]
        assert len(pieces) == 1 or pieces != sorted(pieces)
    shown = without_marks(solution_file(exercise).read_text(encoding="utf-8"))
    assert "".join(part["text"] for part in data["parts"]) == shown
    assert order_text(exercise) == order_text(exercise)
    assert all(line in order_text(exercise) for line in code(shown))


@pytest.mark.parametrize("exercise", BLANK)
def test_a_distractor_in_its_position_is_a_wrong_answer(exercise: str) -> None:
    parts = parts_of(solution_file(exercise).read_text(encoding="utf-8"))
    bodies = []
    for source in sources(exercise):
        lines = text_of(source).splitlines(keepends=True)
        bodies.append(code("".join(lines[header_size(lines) :])))
    for item in distractors(exercise, parts):
        texts = [item.text + "\n" if at == item.of else part.text for at, part in enumerate(parts)]
        assert code("".join(texts)) in bodies
