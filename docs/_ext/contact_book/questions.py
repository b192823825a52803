"""Reads and checks the questions that authors write."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

from contact_book.book import Book, Chapter
from contact_book.errors import BookError, unknown
from contact_book.toml import Table

KINDS = ("predict", "choose", "order", "construct", "complete", "say-why")
# As many as a reader can weigh an answer against.
CRITERIA = 3

Answer = float | int | list[int] | None
# A gap in a line or a cell: {{name}}.
GAP = re.compile(r"\{\{([^{}]*)\}\}")
_GAP_ID = re.compile(r"[a-z][a-z0-9-]*")
_FORMULA = re.compile(r"\$[^$]*\$")


@dataclass(frozen=True)
class Wrong:
    """Feedback for a wrong answer that can be recognised."""

    answer: Any
    why: str


@dataclass(frozen=True)
class Gap:
    """A number that is missing in a question to complete."""

    id: str
    label: str
    answer: float
    unit: str
    tolerance: float
    convert: bool
    wrong: tuple[Wrong, ...]


@dataclass(frozen=True)
class Question:
    chapter: Chapter
    id: str
    kind: str
    objective: str
    text: str
    explain: str
    choices: tuple[str, ...]
    answer: Any
    unit: str
    tolerance: float
    convert: bool
    figure: str
    goal: str
    wrong: tuple[Wrong, ...]
    # The steps of a derivation, or the rows of a table with its heads first; `gaps` are in them.
    lines: tuple[str, ...]
    table: tuple[tuple[str, ...], ...]
    gaps: tuple[Gap, ...]
    criteria: tuple[str, ...]

    @property
    def ref(self) -> str:
        return f"{self.chapter.slug}/{self.id}"


def _check_answer(row: Table, kind: str, choices: list[str]) -> Answer:
    """The key, which must have the shape its kind needs."""
    if kind == "predict":
        return row.need("answer", float)
    if kind == "choose":
        index = row.need("answer", int)
        if len(choices) < 2:
            raise BookError(f"{row.where}: a choice needs at least two options")
        if not 0 <= index < len(choices):
            raise BookError(f"{row.where}: answer {index} is not the index of an option")
        return index
    if kind == "order":
        order = row.need("answer", list)
        if sorted(order) != list(range(len(choices))) or len(choices) < 2:
            raise BookError(f"{row.where}: answer must order the items 0 to {len(choices) - 1}")
        return order
    return None


def _wrong(row: Table) -> tuple[Wrong, ...]:
    return tuple(
        Wrong(item.data.get("answer"), item.need("why", str)) for item in row.tables("wrong")
    )


def _gaps(row: Table, texts: list[str]) -> tuple[Gap, ...]:
    """The gaps of a question to complete, in the order in which they stand in its texts."""
    gaps: dict[str, Gap] = {}
    for item in row.tables("gaps"):
        name = item.need("id", str)
        if not _GAP_ID.fullmatch(name):
            raise BookError(f"{row.where}: '{name}' is no name of a gap, such as after-hit")
        if name in gaps:
            raise BookError(f"{row.where}: two gaps are called '{name}'")
        gaps[name] = Gap(
            id=name,
            label=item.need("label", str),
            answer=item.need("answer", float),
            unit=item.get("unit", str, ""),
            tolerance=item.need("tolerance", float),
            convert=item.get("convert", bool, True),
            wrong=_wrong(item),
        )
    placed = [name for text in texts for name in GAP.findall(text)]
    if any(GAP.search(formula) for text in texts for formula in _FORMULA.findall(text)):
        raise BookError(f"{row.where}: a gap stands in the text, not in a formula")
    if sorted(placed) != sorted(gaps) or not gaps:
        raise BookError(
            f"{row.where}: each of its gaps stands once in lines or table, and at least one does"
        )
    return tuple(gaps[name] for name in placed)


def _table(row: Table) -> tuple[tuple[str, ...], ...]:
    rows = row.get("table", list, [])
    cells = [cell for line in rows if isinstance(line, list) for cell in line]
    sizes = {len(line) if isinstance(line, list) else 0 for line in rows}
    if rows and (len(sizes) > 1 or 0 in sizes or not all(isinstance(cell, str) for cell in cells)):
        raise BookError(f"{row.where}: table is a list of rows, each of as many texts")
    return tuple(tuple(line) for line in rows)


def _question(chapter: Chapter, row: Table) -> Question:
    kind = row.need("kind", str)
    if kind not in KINDS:
        raise unknown("kind of question", kind, KINDS, row.where)
    objective = row.need("objective", str)
    known = [item.id for item in chapter.objectives]
    if objective not in known:
        raise unknown("objective", objective, known, row.where)
    choices = row.strings("items" if kind == "order" else "options")
    lines, table, criteria = row.strings("lines"), _table(row), row.strings("criteria")
    gaps: tuple[Gap, ...] = ()
    if kind == "complete":
        if bool(lines) == bool(table):
            raise BookError(f"{row.where}: it has either lines or a table to complete")
        gaps = _gaps(row, lines or [cell for line in table for cell in line])
    if kind == "say-why" and len(criteria) != CRITERIA:
        raise BookError(f"{row.where}: a model answer has {CRITERIA} criteria")
    figure = row.need("figure", str) if kind == "construct" else ""
    if figure and figure not in [f"{chapter.slug}/{name}" for name in chapter.figures]:
        raise unknown("figure", figure, chapter.figures, row.where)
    return Question(
        chapter=chapter,
        id=row.need("id", str),
        kind=kind,
        objective=objective,
        text=row.need("text", str),
        explain=row.need("model" if kind == "say-why" else "explain", str),
        choices=tuple(choices),
        answer=_check_answer(row, kind, choices),
        unit=row.get("unit", str, ""),
        tolerance=row.need("tolerance", float) if kind == "predict" else 0.0,
        convert=row.get("convert", bool, True),
        figure=figure,
        goal=row.need("goal", str) if kind == "construct" else "",
        wrong=_wrong(row),
        lines=tuple(lines),
        table=table,
        gaps=gaps,
        criteria=tuple(criteria),
    )


def load_questions(book: Book, chapter: Chapter) -> dict[str, Question]:
    """The chapter's questions by id; none if it has no questions.toml."""
    path = chapter.folder / "questions.toml"
    if not path.is_file():
        return {}
    questions: dict[str, Question] = {}
    for row in book.table(path).tables("question"):
        named = Table(row.data, f"{book.relative(path)}: question '{row.need('id', str)}'")
        question = _question(chapter, named)
        if question.id in questions:
            raise BookError(f"{named.where}: the id is used twice")
        questions[question.id] = question
    return questions


def find_question(book: Book, name: str, here: str | None, where: str) -> Question:
    """The question called `ID` in the chapter `here`, or `NN_slug/ID`."""
    chapter, short = book.split(name, here, where)
    questions = load_questions(book, chapter)
    if short not in questions:
        raise unknown("question", short, questions, f"chapters/{chapter.slug}/questions.toml")
    return questions[short]
