"""`{mutants}`: how many small changes of the solutions the tests catch, chapter by chapter.

grading/mutants/mutants.py --keep counts them and stores the counts, one file a chapter.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path

from docutils import nodes

from contact_book.chapter import chapter_link
from contact_book.directive import BookDirective
from contact_book.errors import BookError
from contact_book.tables import Cell, scrolled, table

Counts = Mapping[str, int]

# Each mutant ends as one of these, and each wrong answer has one of these said of it.
_ENDED = ("killed", "equivalent", "also_right", "left")
_SAID = ("one_hint", "several", "noted", "no_hint")
_SUMS = {"mutants": _ENDED, "killed_by_an_answer": _SAID}
KEYS = (*_SUMS, *_ENDED, *_SAID)
HEADS = (
    "Chapter",
    "Mutants",
    "Caught",
    "Equivalent",
    "Also right",
    "Left",
    "By an answer",
    "One hint",
    "Note or several",
    "None",
)


def kept_file(root: Path, slug: str) -> Path:
    return root / "grading" / "mutants" / "kept" / f"{slug}.json"


def _checked(counts: object, where: str) -> Counts:
    if not isinstance(counts, dict):
        raise BookError(f"{where}: the counts must be an object")
    for key in KEYS:
        count = counts.get(key)
        if type(count) is not int or count < 0:
            raise BookError(f"{where}: '{key}' must be a number of mutants, not {count!r}")
    for whole, parts in _SUMS.items():
        if counts[whole] != sum(counts[part] for part in parts):
            raise BookError(f"{where}: '{whole}' is not the sum of {', '.join(parts)}")
    return counts


def read_kept(path: Path, where: str) -> dict[str, Counts]:
    """The counts of a chapter's exercises, by name."""
    try:
        said = json.loads(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise BookError(f"{where} is not JSON: {error}") from None
    if not isinstance(said, dict) or not said:
        raise BookError(f"{where} must hold an object with the counts of each exercise")
    return {name: _checked(counts, f"{where}: {name}") for name, counts in said.items()}


def summed(rows: Iterable[Counts]) -> dict[str, int]:
    listed = list(rows)
    return {key: sum(row[key] for row in listed) for key in KEYS}


def percent(part: int, whole: int) -> str:
    """Rounded, but all only of all and nothing only of nothing."""
    if whole == 0:
        return "–"
    rounded = round(100 * part / whole)
    if 0 < part < whole:
        rounded = min(max(rounded, 1), 99)
    return f"{rounded}\N{NO-BREAK SPACE}%"


def mistakes(counts: Counts) -> int:
    """Neither equivalent nor another right answer."""
    return counts["killed"] + counts["left"]


def told(counts: Counts) -> int:
    """Wrong answers of which the tests say something more than that they are wrong."""
    return counts["killed_by_an_answer"] - counts["no_hint"]


def cells(counts: Counts) -> list[str]:
    numbers = [
        *(counts[key] for key in ("mutants", *_ENDED, "killed_by_an_answer", "one_hint")),
        counts["several"] + counts["noted"],
        counts["no_hint"],
    ]
    return [f"{number:,}" for number in numbers]


def total_cells(counts: Counts) -> list[str]:
    """The sums; with percentages, where they are parts of what should be caught or explained."""
    made = cells(counts)
    made[1] += f" ({percent(counts['killed'], mistakes(counts))})"
    answers = counts["killed_by_an_answer"]
    for column, part in (
        (6, counts["one_hint"]),
        (7, counts["several"] + counts["noted"]),
        (8, counts["no_hint"]),
    ):
        made[column] += f" ({percent(part, answers)})"
    return made


def summary(counts: Counts) -> str:
    return (
        f"The tests catch {percent(counts['killed'], mistakes(counts))} of the mutants that are "
        "neither equivalent nor also right. Of those caught by a wrong answer, "
        f"{percent(told(counts), counts['killed_by_an_answer'])} get a hint, several or a note."
    )


class Mutants(BookDirective):
    """A row for each chapter whose counts are kept, then their sums."""

    def build(self) -> list[nodes.Node]:
        rows: list[list[Cell]] = []
        found: list[Counts] = []
        for slug, chapter in self.book.chapters.items():
            path = kept_file(self.book.root, slug)
            where = self.book.relative(path)
            if not path.is_file():
                if chapter.exercises:
                    self.depends(path)
                    self.missing_product(
                        f"{where} is missing: contact dev mutants --keep {slug} writes it"
                    )
                continue
            self.depends(path)
            counts = summed(read_kept(path, where).values())
            found.append(counts)
            link = chapter_link(chapter, self.env.docname)
            rows.append([link, *map(nodes.Text, cells(counts))])
        if not found:
            return [nodes.paragraph("", "No mutants are counted yet.", classes=["not-built"])]
        whole = summed(found)
        rows.append([nodes.strong("", text) for text in ("All", *total_cells(whole))])
        made = table(HEADS, rows, "What the tests say of the mutants", ["mutants"])
        return [
            scrolled(made, "Mutants, chapter by chapter"),
            nodes.paragraph("", summary(whole)),
        ]
