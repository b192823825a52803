"""The forms in which a reader can answer an exercise, all made from its one solution with marks
(marks.py) and its wrong answers.

    forms.py --form order|fill EXERCISE     prints the file to begin with
    forms.py --check [EXERCISE...]          prints what is wrong with the marks, a line each
    forms.py --output FOLDER EXERCISE...    writes FOLDER/NN_slug/NAME/{order,fill}.cpp for a check

In *order*, the pieces of each function are shuffled, with some of the wrong answers' pieces among
them. In *fill*, the gaps are empty. The page makes the same forms from `form_data`. It needs
nothing but Python.
"""

from __future__ import annotations

import argparse
import difflib
import random
import re
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

from marks import MARK, MarkError, Part, parts_of, without_marks
from wrong_answers import PatchError, header_size, sources, text_of

ROOT = Path(__file__).resolve().parents[2]
MAX_DISTRACTORS = 3
MIN_LINES = 3
_TOKEN = re.compile(r"[A-Za-z_]\w*|[\d.]+|\S")


@dataclass(frozen=True)
class Distractor:
    """A piece with a mistake in it: what a wrong answer has instead of piece `of`."""

    of: int
    text: str
    misconception: str


def solution_file(exercise: str, root: Path = ROOT) -> Path:
    return root / "solutions" / exercise / f"{exercise.rpartition('/')[2]}.cpp"


def has_marks(exercise: str, root: Path = ROOT) -> bool:
    return MARK in solution_file(exercise, root).read_text(encoding="utf-8")


def _code(text: str) -> list[str]:
    """The lines that are neither empty nor a comment alone."""
    lines = [line for line in text.splitlines() if line.strip()]
    return [line for line in lines if not line.lstrip().startswith("//")]


def _changed_piece(parts: Sequence[Part], wrong: str) -> tuple[int, str] | None:
    """The piece in which a wrong answer differs, and its text there; None if it differs elsewhere
    too."""
    lines = [(line, index) for index, part in enumerate(parts) for line in _code(part.text)]
    theirs = _code(wrong)
    matcher = difflib.SequenceMatcher(None, [line for line, _ in lines], theirs, autojunk=False)
    changes = [change for change in matcher.get_opcodes() if change[0] != "equal"]
    touched = {
        index
        for _, begin, end, _, _ in changes
        for _, index in (lines[begin:end] or lines[max(0, begin - 1) : begin])
    }
    if len(touched) != 1:
        return None
    (piece,) = touched
    first = next(at for at, (_, index) in enumerate(lines) if index == piece)
    size = sum(index == piece for _, index in lines)
    if not parts[piece].is_piece:
        return None
    rest = len(lines) - first - size
    text = "\n".join(theirs[first : len(theirs) - rest])
    return (piece, text) if text else None


def distractors(exercise: str, parts: Sequence[Part], root: Path = ROOT) -> list[Distractor]:
    """Wrong answers that differ from the solution in one piece: of each piece at most one, and
    few in all."""
    found: dict[int, Distractor] = {}
    own = {tuple(_code(part.text)) for part in parts}
    for source in sources(exercise, root):
        text = text_of(source)
        header, *_ = text.splitlines()
        lines = text.splitlines(keepends=True)
        body = "".join(lines[header_size(lines) :])
        changed = _changed_piece(parts, body)
        if changed is None or changed[0] in found or tuple(_code(changed[1])) in own:
            continue
        misconception = header.removeprefix("// misconception: ")
        found[changed[0]] = Distractor(*changed, misconception)
    return list(found.values())[:MAX_DISTRACTORS]


def _shuffled(count: int, pieces: int, name: str) -> list[int]:
    """Always the same order for one name. The first `pieces` are never in their right order."""
    kept = pieces if pieces > 1 else count
    order = list(range(count))
    while count > 1 and [at for at in order if at < kept] == list(range(kept)):
        random.Random(name).shuffle(order)
        name += "+"
    return order


def _runs(parts: Sequence[Part]) -> list[list[int]]:
    """The pieces that follow one another without a fixed part between: those of one function."""
    runs: list[list[int]] = []
    for index, part in enumerate(parts):
        if not part.is_piece:
            continue
        if index > 0 and parts[index - 1].is_piece:
            runs[-1].append(index)
        else:
            runs.append([index])
    return runs


def form_data(exercise: str, root: Path = ROOT) -> dict[str, Any] | None:
    """What the page makes the forms of; None if the solution has no marks.

    `parts` are fixed texts and pieces. `runs` are the rows of each function in their shuffled
    order: `[piece]`, or `[piece, distractor]` for what a wrong answer has instead of that piece.
    """
    if not has_marks(exercise, root):
        return None
    parts = parts_of(solution_file(exercise, root).read_text(encoding="utf-8"))
    wrong = distractors(exercise, parts, root)
    runs = []
    for run in _runs(parts):
        rows = [[index] for index in run]
        rows += [[item.of, at] for at, item in enumerate(wrong) if item.of in run]
        runs.append([rows[at] for at in _shuffled(len(rows), len(run), exercise)])
    return {
        "parts": [
            {"text": part.text, "reason": part.reason, "gaps": list(part.gaps)} for part in parts
        ],
        "runs": runs,
        "distractors": [{"text": item.text, "misconception": item.misconception} for item in wrong],
    }


def fill_text(parts: Sequence[Part]) -> str:
    """The solution with empty gaps; it does not compile until they are filled."""
    text, number = "", 0
    for part in parts:
        piece = part.text
        for gap in sorted(part.gaps, key=part.text.index):
            number += 1
            piece = piece.replace(gap, f"/* gap {number} */", 1)
        text += piece
    return text


def order_text(exercise: str, root: Path = ROOT) -> str:
    """The solution with its pieces shuffled in comments, with a todo() in each function."""
    data = form_data(exercise, root)
    if data is None:
        raise MarkError("its solution has no marks")
    text, runs = "", list(data["runs"])
    after_piece = False
    for part in data["parts"]:
        if not part["reason"]:
            text += part["text"]
            after_piece = False
            continue
        if after_piece:
            continue
        after_piece = True
        text += "  // Put these lines in order and remove `// `. Some may not belong here.\n"
        for row in runs.pop(0):
            piece = data["distractors"][row[1]] if len(row) > 1 else data["parts"][row[0]]
            text += "  //\n" + "".join(f"  // {line}\n" for line in _code(piece["text"]))
        text += "  contact::todo();\n"
    return text


def _gap_problem(part: Part, gap: str) -> str | None:
    code = without_comments(part.text)
    if part.text.count(gap) != 1:
        return f"the gap `{gap}` must occur exactly once in its piece"
    if len(_TOKEN.findall(gap)) < 2:
        return f"the gap `{gap}` is trivial: a gap has at least two tokens"
    if gap not in code:
        return f"the gap `{gap}` is in a comment"
    if gap == code.strip():
        return f"the gap `{gap}` is a whole piece"
    return None


def without_comments(text: str) -> str:
    return "\n".join(_code(text))


def problems_of(exercise: str, root: Path = ROOT) -> list[str]:
    """What is wrong with the marks of a solution."""
    text = solution_file(exercise, root).read_text(encoding="utf-8")
    try:
        parts = parts_of(text)
        wrong = distractors(exercise, parts, root)
    except (MarkError, PatchError) as error:
        return [str(error)]
    pieces = [part for part in parts if part.is_piece]
    problems = []
    if "".join(part.text for part in parts) != without_marks(text):
        problems.append("its parts joined are not the solution")
    lines = len(pieces) + len(wrong)
    if lines < MIN_LINES:
        problems.append(f"it has {lines} lines to order, at least {MIN_LINES} are needed")
    if not any(part.gaps for part in pieces):
        problems.append("it has no gap")
    for part in pieces:
        shown = part.text.strip().splitlines()[:1]
        if not _code(part.text):
            problems.append(f"the piece of the reason '{part.reason}' has no code")
        if not part.reason.endswith((".", "?")):
            problems.append(f"the reason of `{''.join(shown)}` must be a sentence")
        problems += [problem for gap in part.gaps if (problem := _gap_problem(part, gap))]
        places = sorted((part.text.find(gap), len(gap)) for gap in part.gaps)
        for (begin, size), (later, _) in pairwise(places):
            if begin + size > later:
                problems.append(f"two gaps of `{''.join(shown)}` overlap")
    for run in _runs(parts):
        if len({tuple(_code(parts[index].text)) for index in run}) != len(run):
            problems.append("two pieces of one function are equal")
    return problems


def text_of_form(exercise: str, form: str, root: Path = ROOT) -> str:
    if not has_marks(exercise, root):
        raise MarkError(f"{exercise} can only be written: its solution has no marks")
    if form == "order":
        return order_text(exercise, root)
    return fill_text(parts_of(solution_file(exercise, root).read_text(encoding="utf-8")))


def main(words: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n\n")[0])
    parser.add_argument("--root", type=Path, default=ROOT)
    parser.add_argument("--form", choices=("order", "fill"))
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--output", type=Path)
    parser.add_argument("exercises", nargs="*", metavar="EXERCISE")
    options = parser.parse_args(words)
    root = options.root.absolute()
    try:
        if options.form:
            (exercise,) = options.exercises
            sys.stdout.write(text_of_form(exercise, options.form, root))
            return 0
        status = 0
        for exercise in options.exercises:
            if not has_marks(exercise, root):
                continue
            problems = problems_of(exercise, root)
            for problem in problems:
                print(f"{exercise}: {problem}")
                status = 1
            if options.output and not problems:
                folder = options.output / exercise
                folder.mkdir(parents=True, exist_ok=True)
                for form in ("order", "fill"):
                    text = text_of_form(exercise, form, root)
                    (folder / f"{form}.cpp").write_text(text, encoding="utf-8")
    except (MarkError, PatchError) as error:
        print(error, file=sys.stderr)
        return 1
    return status


if __name__ == "__main__":
    sys.exit(main())
