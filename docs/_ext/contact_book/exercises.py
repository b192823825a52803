"""Exercises as described by the files of their folders."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from lesson_minutes import Lesson, Tally, lesson_of

from contact_book.book import Book, Chapter
from contact_book.errors import BookError, unknown

KINDS = {
    "worked": "worked example",
    "completion": "complete it",
    "blank": "from a blank page",
    "transfer": "on your own",
    "break": "break it",
}


@dataclass(frozen=True)
class Points:
    """What one test is worth."""

    name: str
    points: float


@dataclass(frozen=True)
class Exercise:
    chapter: Chapter
    name: str
    folder: Path
    title: str
    objective: str
    kind: str
    minutes: int
    brief: str
    hints: tuple[str, ...]
    misconceptions: tuple[str, ...]
    tests: tuple[Points, ...]
    #: The name of the given code, which is wrong; empty in exercises that ask for code.
    breaks: str
    #: For each function that returns an input: what the page's fields begin with.
    inputs: tuple[dict[str, Any], ...]

    @property
    def ref(self) -> str:
        return f"{self.chapter.slug}/{self.name}"

    @property
    def points(self) -> float:
        return sum(test.points for test in self.tests)

    @property
    def toml(self) -> Path:
        return self.folder / "exercise.toml"

    @property
    def contract(self) -> Path:
        return self.folder / f"{self.name}.hpp"

    @property
    def stub(self) -> Path:
        return self.folder / f"{self.name}.cpp"

    @property
    def given(self) -> Path | None:
        return self.folder / self.breaks if self.breaks else None

    @property
    def sources(self) -> list[Path]:
        """What a reader is shown: described, contract, stub, solution, code to break."""
        files = [self.toml, self.contract, self.stub, self.solution]
        return files if self.given is None else [*files, self.given]

    @property
    def solution(self) -> Path:
        return self.chapter.root / "solutions" / self.ref / f"{self.name}.cpp"


def find_exercise(book: Book, name: str, here: str | None, where: str) -> Exercise:
    """The exercise called `NAME` in the chapter `here`, or `NN_slug/NAME`."""
    chapter, short = book.split(name, here, where)
    shelf = book.root / "exercises" / chapter.slug
    folder = shelf / short
    if not (folder / "exercise.toml").is_file():
        known = [path.parent.name for path in shelf.glob("*/exercise.toml")]
        raise unknown("exercise", short, known, f"exercises/{chapter.slug}")
    said = book.said_in("exercises", f"{chapter.slug}/{short}", folder / "exercise.toml")
    kind = said["kind"]
    if kind not in KINDS:
        where = book.relative(folder / "exercise.toml")
        raise unknown("kind of exercise", kind, KINDS, where)
    return Exercise(
        chapter=chapter,
        name=short,
        folder=folder,
        title=said["title"],
        objective=said["objective"],
        kind=kind,
        minutes=said["minutes"],
        brief=said["brief"],
        hints=tuple(said["hints"]),
        misconceptions=tuple(said["misconceptions"]),
        tests=tuple(Points(test["name"], test["points"]) for test in said["tests"]),
        breaks=said["breaks"],
        inputs=tuple(said["inputs"]),
    )


@dataclass(frozen=True)
class LessonTime:
    """How many minutes a lesson takes, and what goes with it."""

    lesson: int
    exercises: int
    further: int
    deeper: int


def lesson_time(book: Book, chapter: Chapter) -> LessonTime:
    where = f"chapters/{chapter.slug}/chapter.toml"
    for name in chapter.in_lesson:
        if name not in chapter.exercises:
            raise unknown("exercise", name, chapter.exercises, f"{where}: in_lesson")
    minutes = {
        name: find_exercise(book, name, chapter.slug, where).minutes for name in chapter.exercises
    }
    in_lesson = sum(minutes[name] for name in chapter.in_lesson)
    said = book.registry["chapters"][chapter.slug]
    try:
        lesson = lesson_of(book.root, chapter.slug, said)
    except BookError:
        # The directive that cannot be counted says why, at its line in the lesson.
        lesson = Lesson(chapter.slug, Tally(), Tally())
    return LessonTime(
        lesson=max(1, round(lesson.main.minutes)),
        exercises=in_lesson,
        further=sum(minutes.values()) - in_lesson,
        deeper=round(lesson.deeper.minutes),
    )


def misconception_hints(book: Book, exercise: Exercise) -> dict[str, str]:
    """The hint shown with a test that recognises one of the exercise's misconceptions."""
    if not exercise.misconceptions:
        return {}
    path = book.root / "chapters" / "misconceptions.toml"
    if not path.is_file():
        raise BookError(f"{book.relative(path)} does not exist")
    problem = book.registry["problems"].get(book.relative(path))
    if problem:
        raise BookError(problem)
    shared = book.registry["misconceptions"]
    where = book.relative(exercise.toml)
    hints = {}
    for name in exercise.misconceptions:
        if name not in shared:
            raise unknown("misconception", name, shared, where)
        hints[name] = shared[name]["hint"]
    return hints
