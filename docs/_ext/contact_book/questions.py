"""Reads and checks the questions that authors write."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from contact_book.book import Book, Chapter
from contact_book.errors import BookError, unknown
from contact_book.toml import Table

KINDS = ("predict", "choose", "order", "construct")


Answer = float | int | list[int] | None


@dataclass(frozen=True)
class Wrong:
    """Feedback for a wrong answer that can be recognised."""

    answer: Any
    why: str


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
    figure: str
    goal: str
    wrong: tuple[Wrong, ...]

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


def _question(chapter: Chapter, row: Table) -> Question:
    kind = row.need("kind", str)
    if kind not in KINDS:
        raise unknown("kind of question", kind, KINDS, row.where)
    objective = row.need("objective", str)
    known = [item.id for item in chapter.objectives]
    if objective not in known:
        raise unknown("objective", objective, known, row.where)
    choices = row.strings("items" if kind == "order" else "options")
    figure = row.need("figure", str) if kind == "construct" else ""
    if figure and figure not in [f"{chapter.slug}/{name}" for name in chapter.figures]:
        raise unknown("figure", figure, chapter.figures, row.where)
    return Question(
        chapter=chapter,
        id=row.need("id", str),
        kind=kind,
        objective=objective,
        text=row.need("text", str),
        explain=row.need("explain", str),
        choices=tuple(choices),
        answer=_check_answer(row, kind, choices),
        unit=row.get("unit", str, ""),
        tolerance=row.need("tolerance", float) if kind == "predict" else 0.0,
        figure=figure,
        goal=row.need("goal", str) if kind == "construct" else "",
        wrong=tuple(
            Wrong(item.data.get("answer"), item.need("why", str)) for item in row.tables("wrong")
        ),
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
