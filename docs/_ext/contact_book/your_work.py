"""`{your-work}`: the page of a reader's own work. Its content is shown without scripts."""

from __future__ import annotations

from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.writers.html5 import HTML5Translator

from contact_book.book import Chapter
from contact_book.directive import BookDirective
from contact_book.exercises import KINDS, Exercise, find_exercise
from contact_book.html import attributes, base_path, can_run_scripts, json_script, renders, slots
from contact_book.nodes import component, make_component, make_slot

PAGE = "contact-your-work"


class YourWork(BookDirective):
    has_content = True

    def build(self) -> list[nodes.Node]:
        self.env.metadata[self.env.docname][PAGE] = "yes"
        chapters = [
            (chapter, [self.exercise(chapter, name) for name in chapter.exercises])
            for chapter in self.book.chapters.values()
            if chapter.has_lesson and chapter.exercises
        ]
        words = make_slot("without", self.markdown("\n".join(self.content)))
        return [make_component("your-work", {"chapters": chapters}, [words])]

    def exercise(self, chapter: Chapter, name: str) -> Exercise:
        self.depends(chapter.folder / "chapter.toml")
        exercise = find_exercise(self.book, name, chapter.slug, self.source)
        self.depends(exercise.toml)
        return exercise


def _listed(chapter: Chapter, exercises: list[Exercise], page: str) -> dict[str, Any]:
    return {
        "slug": chapter.slug,
        "title": chapter.title,
        "href": page,
        "exercises": [
            {
                "id": exercise.ref,
                "title": exercise.title,
                "points": exercise.points,
                "kind": KINDS[exercise.kind],
                "href": f"{page}#exercise-{exercise.name.replace('_', '-')}",
            }
            for exercise in exercises
        ],
    }


@renders("your-work")
def your_work_html(translator: HTML5Translator, node: component) -> str:
    without = slots(translator, node)["without"][0]
    if not can_run_scripts(translator):
        return without
    builder = translator.builder
    chapters = [
        _listed(
            chapter,
            exercises,
            builder.get_relative_uri(builder.current_docname, f"chapters/{chapter.slug}"),
        )
        for chapter, exercises in node["data"]["chapters"]
    ]
    script = json_script({"chapters": chapters})
    where = attributes(base=base_path(translator))
    return f"<contact-work{where}>{script}{without}</contact-work>\n"


def read_again(
    app: Sphinx, env: BuildEnvironment, added: object, changed: object, removed: object
) -> list[str]:
    """The page lists the exercises of all chapters, also of one that is new."""
    return [name for name, data in env.metadata.items() if PAGE in data]
