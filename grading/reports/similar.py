"""Which answers to an exercise are alike where few others are: for an instructor to read, and no
proof that anyone copied.

What many answers share, or the stub, says nothing: an exercise suggests it. So only what is rare
counts: runs of code and whole lines that at most the square root of twice the number of answers
have (7 of 30, 14 of 100), or three. The book's solution is compared as if somebody had handed it
in.
"""

from __future__ import annotations

import argparse
import itertools
import math
import sys
from collections import defaultdict
from collections.abc import Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from reports.fingerprints import RUN, Token, fingerprints, tokens
from reports.page import render
from reports.results import Exercise, ReportError, Results, read_results
from reports.text import clean

SOLUTION = "the book's solution"
# Fewer words and signs in common are not listed, nor are more pairs of an exercise.
LEAST_TOKENS = 2 * RUN
MOST_PAIRS = 50
# Shorter lines say nothing.
LEAST_LINE = 12

# What each answer consists of.
Parts = Sequence[Mapping[Any, object]]


@dataclass
class Answer:
    """A text that was handed in."""

    who: str
    text: str
    tokens: list[Token] = field(default_factory=list)
    runs: dict[tuple[str, ...], list[int]] = field(default_factory=dict)
    lines: dict[str, list[int]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.tokens = tokens(self.text)
        self.runs = fingerprints(self.tokens)
        found: dict[str, list[int]] = defaultdict(list)
        for number, line in enumerate(self.text.splitlines(), 1):
            bare = "".join(line.split())
            if len(bare) >= LEAST_LINE:
                found[bare].append(number)
        self.lines = dict(found)


@dataclass(frozen=True)
class Pair:
    """Two answers, and what they have in common and few others."""

    a: Answer
    b: Answer
    tokens: int  # of the one that has fewer in common
    share: float  # of all tokens of that answer
    lines: int  # that are equal to the last character but blanks
    marked: tuple[frozenset[int], frozenset[int]]  # the lines of each that have something in common


def rare(
    owners: Mapping[Hashable, set[int]], answers: int, given: Iterable[Hashable]
) -> set[Hashable]:
    """What at least two have, but few, and nobody was given."""
    most = max(3, math.isqrt(2 * answers))
    return {what for what, who in owners.items() if 2 <= len(who) <= most} - set(given)


def _owners(parts: Parts) -> dict[Hashable, set[int]]:
    owners: dict[Hashable, set[int]] = defaultdict(set)
    for number, part in enumerate(parts):
        for what in part:
            owners[what].add(number)
    return owners


def pairs(answers: Sequence[Answer], given: Answer) -> list[Pair]:
    """The pairs that have more in common than the least, most first."""
    shared: dict[tuple[int, int], tuple[set[Hashable], set[Hashable]]] = defaultdict(
        lambda: (set(), set())
    )
    everything: tuple[tuple[Parts, Iterable[Hashable]], ...] = (
        ([one.runs for one in answers], given.runs),
        ([one.lines for one in answers], given.lines),
    )
    for kind, (parts, known) in enumerate(everything):
        owners = _owners(parts)
        for what in rare(owners, len(answers), known):
            for two in itertools.combinations(sorted(owners[what]), 2):
                shared[two][kind].add(what)
    found = [_pair(answers[i], answers[j], *common) for (i, j), common in shared.items()]
    enough = [pair for pair in found if pair.tokens >= LEAST_TOKENS or pair.lines >= 3]
    return sorted(enough, key=lambda pair: (-pair.tokens, -pair.lines, pair.a.who, pair.b.who))


def _pair(a: Answer, b: Answer, runs: set[Hashable], lines: set[Hashable]) -> Pair:
    covered = [_covered(one, runs) for one in (a, b)]
    fewer = min((len(part), len(one.tokens)) for part, one in zip(covered, (a, b), strict=True))
    marked = tuple(
        frozenset(one.tokens[at].line for at in part)
        | {number for line in lines for number in one.lines.get(str(line), ())}
        for part, one in zip(covered, (a, b), strict=True)
    )
    return Pair(a, b, fewer[0], fewer[0] / max(1, fewer[1]), len(lines), (marked[0], marked[1]))


def _covered(answer: Answer, runs: set[Hashable]) -> set[int]:
    """The positions of the tokens in these runs."""
    return {
        at + k
        for run, begins in answer.runs.items()
        if run in runs
        for at in begins
        for k in range(RUN)
    }


def handed_in(folder: Path, results: Results, exercise: str) -> list[Answer]:
    """All answers to an exercise that the results have kept."""
    found = []
    for one in results.submissions:
        file = folder / ".grade" / "submissions" / one.id / f"{exercise}.cpp"
        if file.is_file() and not file.is_symlink():
            found.append(Answer(one.id, file.read_text(encoding="utf-8", errors="replace")))
    return found


def compare(
    folder: Path, results: Results, exercise: Exercise, book: Path
) -> tuple[int, list[Pair]]:
    """How many answers there are, and the pairs that are alike."""
    answers = handed_in(folder, results, exercise.id)
    count = len(answers)
    name = exercise.id.rpartition("/")[2]
    solution = book / "solutions" / exercise.id / f"{name}.cpp"
    if solution.is_file():
        answers.append(Answer(SOLUTION, solution.read_text(encoding="utf-8")))
    given = [book / "exercises" / exercise.id / f"{name}{end}" for end in (".cpp", ".hpp")]
    texts = [file.read_text(encoding="utf-8") for file in given if file.is_file()]
    return count, pairs(answers, Answer("", "\n".join(texts)))


def page(compared: Sequence[tuple[Exercise, int, list[Pair]]]) -> str:
    """All pairs, each with both texts side by side."""
    sections = [
        {
            "exercise": exercise,
            "count": count,
            "more": max(0, len(found) - MOST_PAIRS),
            "pairs": [
                {
                    "pair": pair,
                    "sides": [
                        (one.who, list(enumerate(clean(one.text).splitlines(), 1)), marked)
                        for one, marked in zip((pair.a, pair.b), pair.marked, strict=True)
                    ],
                }
                for pair in found[:MOST_PAIRS]
            ],
        }
        for exercise, count, found in compared
    ]
    return render("similar.html", sections=sections)


def summary(compared: Sequence[tuple[Exercise, int, list[Pair]]]) -> str:
    lines = []
    for exercise, count, found in compared:
        answers = f"{count} {'answer' if count == 1 else 'answers'}"
        alike = f"{len(found)} {'pair' if len(found) == 1 else 'pairs'}"
        lines.append(f"{exercise.id}: {answers}, {alike} alike where few others are.")
        for pair in found[:5]:
            lines.append(
                f"    {pair.a.who} and {pair.b.who}: {100 * pair.share:.0f} % of the shorter text, "
                f"{pair.lines} lines alike to the character"
            )
        if len(found) > 5:
            lines.append(f"    and {len(found) - 5} more")
    return "\n".join(lines)


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m reports.similar", description=__doc__)
    parser.add_argument("results", type=Path, metavar="RESULTS", help="what contact grade -o wrote")
    parser.add_argument("book", type=Path, metavar="BOOK", help="the folder of the book")
    given = parser.parse_args(arguments)
    try:
        results = read_results(given.results)
        compared = [
            (exercise, *compare(given.results, results, exercise, given.book))
            for exercise in results.exercises
        ]
        out = given.results / "similar.html"
        out.write_text(page(compared), encoding="utf-8")
    except (ReportError, OSError) as error:
        print(f"contact: {error}", file=sys.stderr)
        return 3
    print(summary(compared))
    print(f"Side by side: {out}. Being alike is no proof of copying: read the texts.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
