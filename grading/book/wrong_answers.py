"""Writes wrong answers as C++ files. Each is stored as a whole file, or as a patch against the
solution.

    wrong_answers.py [--root ROOT] [--output FOLDER] [EXERCISE...]
        writes every one whole, as FOLDER/NN_slug/NAME/x.cpp (build/wrong), and prints those that
        cannot be written, a line each
    wrong_answers.py --as-patch FILE.cpp...
        keeps these as patches from now on

`solutions/NN_slug/NAME/wrong/x.patch` begins with the lines that every wrong answer begins with
(`// misconception: ID`, `// caught by: TEST`, `// seen: WHERE`, the last with further lines that
begin with three spaces), and a unified diff follows them. The wrong answer is those lines, then the
solution with the diff applied, without the marks (marks.py).

Only this file applies patches: `contact dev check` and the tests all ask it. It needs nothing but
Python.
"""

from __future__ import annotations

import argparse
import difflib
import os
import re
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from marks import without_marks

ROOT = Path(__file__).resolve().parents[2]
_HEADER = ("// misconception: ", "// caught by: ", "// seen: ", "//   ")
_HUNK = re.compile(r"@@ -(\d+)(?:,(\d+))? \+(\d+)(?:,(\d+))? @@")


class PatchError(Exception):
    """A patch that cannot be applied, and why."""


def header_size(lines: Sequence[str]) -> int:
    """How many lines of a wrong answer stand before its code."""
    for index, line in enumerate(lines):
        if not line.startswith(_HEADER):
            return index
    return len(lines)


def _split(hunk: Sequence[str]) -> tuple[list[str], list[str]]:
    """The lines of a hunk as they were, and as they are to be."""
    before, after = [], []
    for line in hunk:
        # Editors take the space from an empty line of context.
        mark, text = (line[0], line[1:]) if line.strip() else (" ", "\n")
        if mark not in " -+":
            raise PatchError(f"a line of a hunk begins with ' ', '-' or '+', not: {line.rstrip()}")
        if mark != "+":
            before.append(text)
        if mark != "-":
            after.append(text)
    return before, after


def _position(lines: Sequence[str], part: Sequence[str], begin: int, said: int) -> int:
    """Where `part` stands in `lines`: where it is said to, or in one other place after `begin`."""
    size = len(part)
    if said >= begin and list(lines[said : said + size]) == list(part):
        return said
    places = [
        at
        for at in range(begin, len(lines) - size + 1)
        if list(lines[at : at + size]) == list(part)
    ]
    if len(places) != 1:
        raise PatchError("is nowhere in the solution" if not places else "fits in several places")
    return places[0]


def apply(patch: str, solution: str) -> str:
    """The wrong answer that a patch describes."""
    lines = patch.splitlines(keepends=True)
    size = header_size(lines)
    header, rest = lines[:size], lines[size:]
    if [line.startswith(mark) for line, mark in zip(header, _HEADER, strict=False)][:2] != [
        True
    ] * 2:
        raise PatchError("it must begin with `// misconception: ...` and `// caught by: ...`")
    if len(rest) < 2 or not (rest[0].startswith("--- ") and rest[1].startswith("+++ ")):
        raise PatchError("after these lines it must go on with `--- ...` and `+++ ...`")
    begins = [index for index, line in enumerate(rest) if line.startswith("@@ ")]
    if begins[:1] != [2]:
        raise PatchError("after `+++ ...` it must go on with `@@ -... +... @@`")
    old = solution.splitlines(keepends=True)
    new: list[str] = []
    done = 0
    for begin, end in zip(begins, [*begins[1:], len(rest)], strict=True):
        said = _HUNK.match(rest[begin])
        if said is None:
            raise PatchError(f"this says no lines: {rest[begin].rstrip()}")
        before, after = _split(rest[begin + 1 : end])
        counts = int(said[2] or 1), int(said[4] or 1)
        if counts != (len(before), len(after)):
            raise PatchError(
                f"{said[0]} has {len(before)} lines before and {len(after)} after the change, not "
                f"{counts[0]} and {counts[1]}"
            )
        try:
            at = _position(old, before, done, int(said[1]) - (1 if before else 0))
        except PatchError as error:
            raise PatchError(f"{said[0]} does not apply: what it changes {error}") from None
        new += [*old[done:at], *after]
        done = at + len(before)
    return "".join([*header, *new, *old[done:]])


def as_patch(wrong: str, solution: str, names: tuple[str, str]) -> str:
    """The patch that describes a wrong answer."""
    lines = wrong.splitlines(keepends=True)
    size = header_size(lines)
    made = difflib.unified_diff(solution.splitlines(keepends=True), lines[size:], *names)
    patch = "".join(lines[:size]) + "".join(made).replace("\n \n", "\n\n")
    # Twice, for empty lines one after the other.
    patch = patch.replace("\n \n", "\n\n")
    if apply(patch, solution) != wrong:
        raise PatchError("no patch describes it: does each line end with a line feed?")
    return patch


def sources(exercise: str, root: Path = ROOT) -> list[Path]:
    """The files as they are kept: x.cpp and x.patch, by their names."""
    folder = root / "solutions" / exercise / "wrong"
    kept = [file for file in folder.glob("*") if file.suffix in (".cpp", ".patch")]
    return sorted(kept, key=lambda file: (file.stem, file.suffix))


def text_of(source: Path) -> str:
    """The C++ of a wrong answer, whichever way it is kept."""
    text = source.read_text(encoding="utf-8")
    if source.suffix == ".cpp":
        return text
    if source.with_suffix(".cpp").exists():
        raise PatchError(f"{source.stem}.cpp is there as well: keep one of the two")
    folder = source.parent.parent
    solution = folder / f"{folder.name}.cpp"
    if not solution.is_file():
        raise PatchError(f"there is no {solution.name} that it could change")
    return apply(text, without_marks(solution.read_text(encoding="utf-8")))


def _write(file: Path, text: str) -> None:
    """Whole or not at all, and not if it is so already: tests read it side by side."""
    if file.is_file() and file.read_text(encoding="utf-8") == text:
        return
    file.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.NamedTemporaryFile(
        "w", encoding="utf-8", dir=file.parent, prefix=f".{file.name}.", delete=False
    ) as part:
        part.write(text)
    Path(part.name).replace(file)


def write_whole(exercise: str, output: Path, root: Path = ROOT) -> tuple[list[Path], list[str]]:
    """Writes an exercise's wrong answers as C++; the files, and what is wrong with the others."""
    folder = output / exercise
    written, problems = [], []
    for source in sources(exercise, root):
        try:
            _write(folder / f"{source.stem}.cpp", text_of(source))
            written.append(folder / f"{source.stem}.cpp")
        except (PatchError, OSError, UnicodeDecodeError) as error:
            problems.append(f"{source.relative_to(root)}: {error}")
    for file in folder.glob("*.cpp"):
        if file not in written:
            file.unlink(missing_ok=True)
    return written, problems


def wrong_answers(exercise: str) -> list[Path]:
    """What a test reads: the book's wrong answers to an exercise, as C++."""
    written, problems = write_whole(exercise, ROOT / "build" / "wrong")
    if problems:
        raise PatchError("; ".join(problems))
    return written


def wrong_answer(exercise: str, name: str) -> Path:
    """One of them, by its name without the ending."""
    return next(file for file in wrong_answers(exercise) if file.stem == name)


def _keep_as_patch(file: Path) -> None:
    folder = file.resolve().parent.parent
    solution = folder / f"{folder.name}.cpp"
    names = (solution.name, f"wrong/{file.name}")
    shown = without_marks(solution.read_text(encoding="utf-8"))
    patch = as_patch(file.read_text(encoding="utf-8"), shown, names)
    file.with_suffix(".patch").write_text(patch, encoding="utf-8")
    file.unlink()


def main(words: Sequence[str] | None = None) -> int:
    about, _, _ = (__doc__ or "").partition("\n")
    parser = argparse.ArgumentParser(description=about)
    parser.add_argument("--root", type=Path, default=ROOT)
    parser.add_argument("--output", type=Path)
    parser.add_argument("--as-patch", action="store_true", help="keep these files as patches")
    parser.add_argument("names", nargs="*", metavar="EXERCISE|FILE")
    options = parser.parse_args(words)
    if options.as_patch:
        for name in options.names:
            _keep_as_patch(Path(name))
        return 0
    root = Path(os.path.abspath(options.root))  # noqa: PTH100 - links stay as they are
    folders = (root / "solutions").glob("*/*/wrong")
    exercises = options.names or sorted(
        folder.parent.relative_to(root / "solutions").as_posix() for folder in folders
    )
    output = options.output or root / "build" / "wrong"
    problems = [line for name in exercises for line in write_whole(name, output, root)[1]]
    for line in problems:
        print(line)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
