"""`{syllabus}` and `{course}`: what an instructor plans a course with, made from the chapters.

A course is a list of meetings. Each line of its content names the chapters of one meeting, which
come after the chapters that they build on.
"""

from __future__ import annotations

from collections.abc import Container, Iterable

from docutils import nodes

from contact_book.book import Chapter
from contact_book.chapter import chapter_link, joined, page_link
from contact_book.directive import BookDirective
from contact_book.errors import BookError
from contact_book.exercises import Exercise, find_exercise, lesson_time
from contact_book.questions import load_questions
from contact_book.tables import Cell, scrolled, table


class _Planned(BookDirective):
    """What both directives ask of a chapter."""

    def read_lesson(self, chapter: Chapter) -> int:
        """Minutes of the lesson, without its exercises."""
        self.depends(chapter.folder / "chapter.toml", chapter.lesson)
        return lesson_time(self.book, chapter).lesson

    def exercises(self, chapter: Chapter, in_lesson: bool) -> list[Exercise]:
        where = f"chapters/{chapter.slug}/chapter.toml"
        found = [
            find_exercise(self.book, name, chapter.slug, where)
            for name in chapter.exercises
            if (name in chapter.in_lesson) == in_lesson
        ]
        self.depends(*(exercise.toml for exercise in found))
        return found

    def listed(self, exercises: Iterable[Exercise]) -> list[nodes.Node]:
        here = self.env.docname
        return joined(
            [
                page_link(f"chapters/{exercise.chapter.slug}", exercise.name, here)
                for exercise in exercises
            ]
        ) or [nodes.Text("none")]


def _minutes(exercises: Iterable[Exercise]) -> int:
    return sum(exercise.minutes for exercise in exercises)


def require_order(meetings: Iterable[Iterable[Chapter]], lessons: Container[str]) -> None:
    """Raises BookError unless each chapter comes once, and after those lessons it builds on."""
    met: set[str] = set()
    for number, chapters in enumerate(meetings, 1):
        for chapter in chapters:
            if chapter.slug in met:
                raise BookError(f"meeting {number}: {chapter.slug} is in the course twice")
            late = [slug for slug in chapter.builds_on if slug in lessons and slug not in met]
            if late:
                raise BookError(
                    f"meeting {number}: {chapter.slug} builds on {', '.join(late)}, "
                    "which the course does not name before"
                )
            met.add(chapter.slug)


class Syllabus(_Planned):
    """All lessons, with the time that each takes and what it builds on."""

    def build(self) -> list[nodes.Node]:
        rows = [self.row(chapter) for chapter in self.book.chapters.values() if chapter.has_lesson]
        heads = [
            "Chapter",
            "Lesson, min",
            "Questions",
            "Exercises in it, min",
            "Further exercises, min",
            "Builds on",
        ]
        title = "The chapters, and how long they take"
        return [scrolled(table(heads, rows, title, ["syllabus"]), f"{title}, may scroll sideways")]

    def row(self, chapter: Chapter) -> list[Cell]:
        inside, further = (self.exercises(chapter, within) for within in (True, False))
        earlier = [
            f"{self.book.chapter(slug, self.source).number:02d}" for slug in chapter.builds_on
        ]
        return [
            [nodes.Text(f"{chapter.number:02d} "), chapter_link(chapter, self.env.docname)],
            nodes.Text(str(self.read_lesson(chapter))),
            nodes.Text(str(len(load_questions(self.book, chapter)))),
            nodes.Text(f"{len(inside)}: {_minutes(inside)}"),
            nodes.Text(f"{len(further)}: {_minutes(further)}"),
            nodes.Text(", ".join(earlier) or "–"),
        ]


class Course(_Planned):
    """The argument is the title; each line of the content names the chapters of a meeting."""

    required_arguments = 1
    has_content = True

    def build(self) -> list[nodes.Node]:
        meetings = [self.meeting(line) for line in self.content if line.strip()]
        if not meetings:
            raise BookError("needs a line for each meeting, as in 00_vectors 01_planes")
        lessons = {slug for slug, chapter in self.book.chapters.items() if chapter.has_lesson}
        require_order(meetings, lessons)
        title = self.arguments[0]
        rows = [self.row(number, chapters) for number, chapters in enumerate(meetings, 1)]
        heads = ["Meeting", "Read before", "In the lesson", "Assignment", "Min", "Points"]
        return [scrolled(table(heads, rows, title, ["course"]), f"{title}, may scroll sideways")]

    def meeting(self, line: str) -> list[Chapter]:
        chapters = [self.book.chapter(slug, self.source) for slug in line.split()]
        for chapter in chapters:
            if not chapter.has_lesson:
                raise BookError(f"chapters/{chapter.slug} has no lesson to read before a meeting")
        return chapters

    def row(self, number: int, chapters: list[Chapter]) -> list[Cell]:
        inside = [each for chapter in chapters for each in self.exercises(chapter, True)]
        further = [each for chapter in chapters for each in self.exercises(chapter, False)]
        reading = sum(self.read_lesson(chapter) for chapter in chapters)
        read: list[nodes.Node] = [chapter_link(chapter, self.env.docname) for chapter in chapters]
        points = sum(exercise.points for exercise in further)
        return [
            nodes.Text(str(number)),
            joined(read),
            self.listed(inside),
            self.listed(further),
            nodes.Text(f"{reading} + {_minutes(inside)} + {_minutes(further)}"),
            nodes.Text(f"{points:g}"),
        ]
