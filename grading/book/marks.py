"""Reads the marks in a solution, which divide it into pieces to explain, to order and to fill.

A comment that begins with `//?` begins a piece, and gives the reason for its lines. In the same
comment, `//? gap: CODE` names a part of the piece that a reader fills in. A piece ends before the
next mark, or at the `}` that closes its function:

    //? Vertex a becomes the origin, so the edges from it span the plane.
    //? gap: triangle.b - triangle.a
    const Eigen::Vector3d e1 = triangle.b - triangle.a;

The other lines are fixed. Without the lines of the marks, the file is the solution as it is shown.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

MARK = "//?"
_GAP = "gap:"


class MarkError(Exception):
    """Marks that cannot be used, and why."""


@dataclass(frozen=True)
class Part:
    """Lines of a solution: a piece if there is a reason, else fixed."""

    text: str
    reason: str = ""
    gaps: tuple[str, ...] = ()

    @property
    def is_piece(self) -> bool:
        return bool(self.reason)


def _is_mark(line: str) -> bool:
    return line.lstrip().startswith(MARK)


def without_marks(text: str) -> str:
    """The solution as it is shown."""
    return "".join(line for line in text.splitlines(keepends=True) if not _is_mark(line))


def _piece(mark: list[str], lines: list[str], number: int) -> Part:
    words = [line.strip().removeprefix(MARK).strip() for line in mark]
    reason = " ".join(word for word in words if not word.startswith(_GAP))
    if not reason:
        raise MarkError(f"line {number}: a mark must give a reason for the lines below it")
    gaps = tuple(word.removeprefix(_GAP).strip() for word in words if word.startswith(_GAP))
    return Part("".join(lines), reason, gaps)


def parts_of(text: str) -> list[Part]:
    """The parts of a solution in their order; their texts joined are the solution as shown."""
    lines = text.splitlines(keepends=True)
    begins = [0]
    for at, line in enumerate(lines):
        first_of_mark = _is_mark(line) and not (at > 0 and _is_mark(lines[at - 1]))
        if first_of_mark or line.startswith("}"):
            begins.append(at)
    parts = []
    for begin, end in pairwise([*begins, len(lines)]):
        mark = [line for line in lines[begin:end] if _is_mark(line)]
        rest = lines[begin + len(mark) : end]
        if mark:
            parts.append(_piece(mark, rest, begin + 1))
        elif rest:
            parts.append(Part("".join(rest)))
    return parts
