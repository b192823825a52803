"""Wrong answers that are kept as patches: what they stand for, and when they stand for nothing."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "grading" / "book" / "wrong_answers.py"
sys.path.append(str(PROGRAM.parent))

from wrong_answers import (  # noqa: E402
    PatchError,
    apply,
    as_patch,
    header_size,
    sources,
    text_of,
    write_whole,
    wrong_answers,
)

HEADER = "// misconception: sign\n// caught by: a test\n// seen: https://a.b/c\n//   there\n"
SOLUTION = "".join(f"line {n};\n\n" for n in range(1, 13))
WRONG = HEADER + SOLUTION.replace("line 4;", "line -4;").replace("line 12;\n\n", "line 12;\n")
PATCH = as_patch(WRONG, SOLUTION, ("a", "b"))
IDS = sorted(f.parent.name + "/" + f.name for f in ROOT.glob("solutions/*/*") if f.is_dir())


@pytest.mark.parametrize("exercise", IDS)
def test_every_wrong_answer_of_the_book_can_be_had_whole(exercise: str) -> None:
    kept = sources(exercise)
    whole = wrong_answers(exercise)
    assert [file.stem for file in kept] == [file.stem for file in whole]
    name = exercise.split("/")[1]
    solution = (ROOT / "solutions" / exercise / f"{name}.cpp").read_text()
    for source, file in zip(kept, whole, strict=True):
        text = file.read_text()
        assert text == text_of(source)
        assert text.startswith("// misconception: ")
        assert text.partition("\n")[2].startswith("// caught by: ")
        if source.suffix == ".patch":
            lines = text.splitlines(keepends=True)
            assert lines[header_size(lines) :] != solution.splitlines(True)


def test_a_patch_is_what_an_answer_changes() -> None:
    assert apply(PATCH, SOLUTION) == WRONG
    assert PATCH.startswith(HEADER + "--- a\n+++ b\n@@ ")
    changed = [line for line in PATCH.splitlines()[6:] if line[:1] in ("-", "+")]
    assert changed == ["-line 4;", "+line -4;", "-"]


def test_other_programs_apply_it_as_well(tmp_path: Path) -> None:
    (tmp_path / "x.cpp").write_text(SOLUTION)
    done = subprocess.run(
        ["git", "apply", "-p0", "-"],
        input=PATCH.replace("--- a", "--- x.cpp").replace("+++ b", "+++ x.cpp"),
        text=True,
        capture_output=True,
        cwd=tmp_path,
    )
    assert done.returncode == 0, done.stderr
    assert HEADER + (tmp_path / "x.cpp").read_text() == WRONG


def test_it_follows_a_solution_that_changes_elsewhere() -> None:
    moved = "#include <cmath>\n" + SOLUTION
    assert apply(PATCH, moved) == HEADER + "#include <cmath>\n" + WRONG.removeprefix(HEADER)


@pytest.mark.parametrize(
    ("patch", "solution", "words"),
    [
        (PATCH, SOLUTION.replace("line 4;", "line four;"), "is nowhere in the solution"),
        (PATCH, "x\n" + SOLUTION + SOLUTION, "fits in several places"),
        (PATCH.removeprefix(HEADER), SOLUTION, "it must begin with `// misconception"),
        (HEADER + "line 1;\n", SOLUTION, "go on with `--- ...`"),
        (HEADER + "--- a\n+++ b\n", SOLUTION, "go on with `@@"),
        (PATCH.replace("+line -4;\n", ""), SOLUTION, "lines before and"),
        (PATCH.replace("-line 4;", "*line 4;"), SOLUTION, "a line of a hunk begins with"),
        (PATCH.replace("@@ -", "@@ ~", 1), SOLUTION, "this says no lines"),
    ],
)
def test_what_does_not_apply_says_why(patch: str, solution: str, words: str) -> None:
    with pytest.raises(PatchError, match=words):
        apply(patch, solution)


def test_the_folder_holds_what_there_is_and_nothing_else(tmp_path: Path) -> None:
    folder = tmp_path / "solutions/00_a/b/wrong"
    folder.mkdir(parents=True)
    (folder.parent / "b.cpp").write_text(SOLUTION)
    (folder / "whole.cpp").write_text(HEADER + "int x;\n")
    (folder / "small.cpp").write_text(WRONG)
    command = [sys.executable, str(PROGRAM), "--as-patch", str(folder / "small.cpp")]
    subprocess.run(command, check=True)
    assert sorted(file.name for file in folder.iterdir()) == ["small.patch", "whole.cpp"]
    output = tmp_path / "out"
    written, problems = write_whole("00_a/b", output, tmp_path)
    assert problems == []
    assert [file.name for file in written] == ["small.cpp", "whole.cpp"]
    assert written[0].read_text() == WRONG
    before = written[0].stat().st_mtime_ns

    (folder / "whole.cpp").unlink()
    write_whole("00_a/b", output, tmp_path)
    assert [file.name for file in (output / "00_a/b").iterdir()] == ["small.cpp"]
    assert written[0].stat().st_mtime_ns == before

    (folder / "small.cpp").write_text(WRONG)
    done = subprocess.run(
        [sys.executable, PROGRAM, "--root", tmp_path], capture_output=True, text=True
    )
    assert done.returncode == 1
    said = "solutions/00_a/b/wrong/small.patch: small.cpp is there as well: keep one of the two\n"
    assert done.stdout == said
