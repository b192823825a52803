"""The data of exercises for the page's script: one JSON file for each, and one for the book.

It contains the files of an exercise as the command line reads them, so that both judge from the
same source.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from forms import form_data
from marks import MarkError, without_marks
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from wrong_answers import PatchError

from contact_book.book import Book, Chapter
from contact_book.directive import open_book
from contact_book.errors import BookError
from contact_book.exercises import Exercise, find_exercise

_ON_THIS_PAGE = "contact-exercises"


def _write(path: Path, data: Mapping[str, Any]) -> None:
    """Whole or not at all: pages are written by several processes."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f"{path.name}.part")
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    part.write_text(text + "\n", encoding="utf-8")
    part.replace(path)


def _texts(book: Book, paths: Sequence[Path]) -> dict[str, str]:
    return {book.relative(path): path.read_text(encoding="utf-8") for path in paths}


def exercise_json(
    book: Book, exercise: Exercise, hints: Sequence[str], misconceptions: Mapping[str, str]
) -> dict[str, Any]:
    """One exercise; hints and the hints of misconceptions are HTML already."""
    texts = _texts(book, exercise.sources)
    solution = book.relative(exercise.solution)
    texts[solution] = without_marks(texts[solution])
    return {
        "format": "contact-exercise/1",
        "id": exercise.ref,
        "chapter": exercise.chapter.slug,
        "name": exercise.name,
        "title": exercise.title,
        "kind": exercise.kind,
        "points": exercise.points,
        "files": texts,
        "hints": list(hints),
        "misconceptions": dict(misconceptions),
        **_form(book, exercise),
    }


def _form(book: Book, exercise: Exercise) -> dict[str, Any]:
    """What the page makes the other forms of, if the solution has marks."""
    try:
        data = form_data(exercise.ref, book.root)
    except (MarkError, PatchError) as error:
        raise BookError(f"{book.relative(exercise.solution)}: {error}") from None
    return {} if data is None else {"form": data}


def _exercises(book: Book, chapter: Chapter) -> list[Exercise]:
    """Those of a chapter that has a page; its page says what is wrong with one of them."""
    if not chapter.has_lesson:
        return []
    shelf = book.root / "exercises" / chapter.slug
    names = [name for name in chapter.exercises if (shelf / name / "exercise.toml").is_file()]
    return [find_exercise(book, name, chapter.slug, chapter.slug) for name in names]


def book_json(book: Book) -> dict[str, Any]:
    """What a record of progress is reported with, and the shapes that a message may name."""
    chapters = list(book.chapters.values())
    exercises = [item for chapter in chapters for item in _exercises(book, chapter)]
    files = [chapter.folder / "chapter.toml" for chapter in chapters]
    files += [exercise.toml for exercise in exercises]
    shapes = [chapter.folder / "contact" / "shapes.hpp" for chapter in chapters]
    files += [file for file in shapes if file.is_file()]
    shared = book.root / "chapters" / "misconceptions.toml"
    return {
        "format": "contact-book/1",
        "files": _texts(book, [*files, shared] if shared.is_file() else files),
        "exercises": [exercise.ref for exercise in exercises],
        "titles": {exercise.ref: exercise.title for exercise in exercises},
        "points": {exercise.ref: exercise.points for exercise in exercises},
    }


def kept(products: Path, ref: str) -> Path:
    """Where an exercise's JSON stays between builds, which write only the pages that changed."""
    return products / "exercises" / f"{ref}.json"


def keep(products: Path, data: Mapping[str, Any]) -> None:
    _write(kept(products, str(data["id"])), data)


def note(env: BuildEnvironment, ref: str) -> None:
    """This page has the exercise."""
    env.metadata[env.docname].setdefault(_ON_THIS_PAGE, []).append(ref)


def _noted(env: BuildEnvironment) -> dict[str, list[str]]:
    return {name: data.get(_ON_THIS_PAGE, []) for name, data in env.metadata.items()}


def read_again(
    app: Sphinx, env: BuildEnvironment, added: object, changed: object, removed: object
) -> list[str]:
    """The pages whose exercises' data has gone."""
    products = Path(app.config.contact_products)
    return [
        name
        for name, refs in _noted(env).items()
        if not all(kept(products, ref).is_file() for ref in refs)
    ]


def publish(app: Sphinx, error: object) -> None:
    """Writes the data to the folder of the pages: before the pages, which can be read at once.

    And after them, for a build that has none to write (`error` is Sphinx's, if it failed).
    """
    if isinstance(error, Exception) or app.builder.format != "html" or app.builder.name == "epub":
        return
    products = Path(app.config.contact_products)
    target = Path(app.outdir) / "_static" / "contact" / "exercises"
    wanted = {ref for refs in _noted(app.env).values() for ref in refs}
    for ref in sorted(wanted):
        if kept(products, ref).is_file():
            _write(target / f"{ref}.json", json.loads(kept(products, ref).read_text("utf-8")))
    _write(target / "book.json", book_json(open_book(app.config)))
    current = {target / f"{ref}.json" for ref in wanted} | {target / "book.json"}
    for file in sorted(set(target.rglob("*.json")) - current):
        file.unlink()


def connect(app: Sphinx) -> None:
    app.connect("env-get-outdated", read_again)
    app.connect("write-started", publish)
    # Before what looks at all that the site is written in.
    app.connect("build-finished", publish, priority=400)
