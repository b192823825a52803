"""What every lesson of this book itself must hold to."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
from contact_book.book import Book, Chapter
from markdown_it import MarkdownIt
from mdit_py_plugins.colon_fence import colon_fence_plugin
from mdit_py_plugins.dollarmath import dollarmath_plugin
from mdit_py_plugins.myst_role import myst_role_plugin
from sample_book import ROOT

BOOK = Book(ROOT, Path())
LESSONS = [chapter for chapter in BOOK.chapters.values() if chapter.has_lesson]

# Names of the glossary that need no link, because they are ordinary words too (a moment of time,
# balls that stick together), or are used for another term (a manifold of contacts).
ORDINARY = {"manifold", "moment", "slice", "stick", "sticking", "support"}


@pytest.mark.parametrize("place", range(len(LESSONS)), ids=[lesson.slug for lesson in LESSONS])
def test_a_lesson_recalls_those_one_three_and_seven_before_it(place: int) -> None:
    recalled = {name.split("/")[0] for name in LESSONS[place].recall}
    assert {LESSONS[place - back].slug for back in (1, 3, 7) if back <= place} <= recalled


@pytest.mark.parametrize("chapter", LESSONS, ids=[chapter.slug for chapter in LESSONS])
def test_a_lesson_links_to_what_its_lectures_get_wrong(chapter: Chapter) -> None:
    text = chapter.lesson.read_text(encoding="utf-8")
    written = {path.stem for path in (chapter.folder / "lectures").glob("*.md")}
    assert {name for name in written if f"{{errata}}`{name}`" not in text} == set()


def glossary() -> list[tuple[list[str], str]]:
    """The names of each entry, and what it says."""
    text = (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8")
    _, _, entries = text.partition(":::{glossary}\n")
    found = []
    for entry in entries.removesuffix(":::\n").strip().split("\n\n"):
        lines = entry.splitlines()
        names = [line for line in lines if not line.startswith(" ")]
        found.append((names, " ".join(line.strip() for line in lines[len(names) :])))
    return found


def marked_terms(slug: str) -> set[str]:
    """What a lesson links to the glossary or marks for the index, in small letters."""
    chapter = BOOK.chapters[slug]
    if not chapter.has_lesson:
        return set()
    text = " ".join(chapter.lesson.read_text(encoding="utf-8").split())
    marks = re.findall(r"\{(?:term|index)\}`(?:[^`<]*<)?([^`>]*)>?`", text)
    return {mark.lower() for mark in marks}


@pytest.mark.parametrize(("names", "said"), glossary(), ids=[names[0] for names, _ in glossary()])
def test_a_lesson_teaches_the_term_or_it_will_come(names: list[str], said: str) -> None:
    chapters = re.findall(r"\{chapter\}`(\w+)`", said)
    assert chapters, f"{names[0]} names no chapter"
    lower = {name.lower() for name in names}
    first = chapters[0]
    assert lower & marked_terms(first) or "will come" in said, f"{first} does not mark {names[0]}"


def test_the_glossary_is_in_order() -> None:
    first = [names[0].lower() for names, _ in glossary()]
    assert first == sorted(first)


# --- Where a lesson first uses a term, it links to the glossary -----------------------------------

MARKDOWN = MarkdownIt("commonmark").enable("table")
for plugin in (colon_fence_plugin, dollarmath_plugin, myst_role_plugin):
    MARKDOWN.use(plugin)

# The first name of the entry, for each of its names in small letters.
ENTRY_OF = {name.lower(): names[0] for names, _ in glossary() for name in names}


def forms(name: str) -> Iterator[str]:
    """A name as lessons write it, in words with a space between: an abbreviation in capitals."""
    name = (name if name.isupper() else name.lower()).replace("–", "-")
    yield from (name, f"{name}s", f"{name}es", f"{name}'s", f"{name.removesuffix('y')}ies")


FORMS = {
    form: names[0]
    for names, _ in glossary()
    for name in names
    if name not in ORDINARY
    for form in forms(name)
}
MAX_WORDS = max(form.count(" ") + 1 for form in FORMS)


class Use(NamedTuple):
    entry: str
    linked: bool
    words: str


def uses_in(text: str) -> Iterator[Use]:
    """The longest first: a bounding volume hierarchy is not a bounding volume."""
    said = re.findall(r"[\w'-]+|[^\w\s]", text.replace("’", "'").replace("–", "-"))
    place = 0
    while place < len(said):
        for count in range(MAX_WORDS, 0, -1):
            words = " ".join(said[place : place + count])
            entry = FORMS.get(words) or FORMS.get(words.lower())
            if entry:
                yield Use(entry, False, words)
                break
        place += count


def uses(lesson: str) -> Iterator[Use]:
    """The terms in what everyone reads: not in directives, headings, code and formulas."""
    heading = False
    for block in MARKDOWN.parse(lesson):
        if block.type.startswith("heading"):
            heading = block.type == "heading_open"
        if heading:
            continue
        text = ""
        for part in block.children or ():
            role = part.meta.get("name")
            if role == "term":
                yield from uses_in(text)
                text = ""
                words, _, name = part.content.rstrip(">").rpartition("<")
                entry = ENTRY_OF[" ".join(name.lower().split()).replace("’", "'")]
                yield Use(entry, True, words.strip() or name)
            elif part.type == "text":
                text += part.content
            elif part.type == "softbreak":
                text += " "
            elif role == "index":
                text += part.content.partition("<")[0]
            elif part.type not in ("em_open", "em_close", "strong_open", "strong_close"):
                text += "|"
        yield from uses_in(text)


def not_linked(lesson: str) -> dict[str, str]:
    """Entries of the glossary whose first use is no link, with the words of that use."""
    first: dict[str, Use] = {}
    for use in uses(lesson):
        first.setdefault(use.entry, use)
    return {entry: use.words for entry, use in first.items() if not use.linked}


def linked_again(lesson: str) -> set[str]:
    links = Counter(use.entry for use in uses(lesson) if use.linked)
    return {entry for entry, times in links.items() if times > 1}


@pytest.mark.parametrize("chapter", LESSONS, ids=[chapter.slug for chapter in LESSONS])
def test_a_lesson_links_each_term_once_where_it_first_uses_it(chapter: Chapter) -> None:
    lesson = chapter.lesson.read_text(encoding="utf-8")
    assert not_linked(lesson) == {}
    assert linked_again(lesson) == set()


@pytest.mark.parametrize(
    ("lesson", "missing"),
    [
        ("A {term}`broad phase`. Broad phases.", {}),
        ("{term}`Trees <BVH>` of boxes. An AABB\ntree.", {}),
        ("_Broad\nphases_ first, then a {term}`broad phase`.", {"broad phase": "Broad phases"}),
        ("| a |\n|---|\n| {index}`ulps <ulp>` |", {"ulp": "ulps"}),
        ("- Rays of _triangle soups_", {"ray": "Rays", "triangle soup": "triangle soups"}),
        (
            "**Bounding volume hierarchies**",
            {"bounding volume hierarchy": "Bounding volume hierarchies"},
        ),
        ("# An ulp\n$ulp$ and `ulp`\n\n:::{deeper} Ulp\nAn ulp.\n:::\n\nAt that moment.", {}),
        ("He sat; a semi-implicit Euler", {"symplectic Euler": "semi-implicit Euler"}),
    ],
)
def test_a_first_use_is_found(lesson: str, missing: dict[str, str]) -> None:
    assert not_linked(lesson) == missing


def test_a_second_link_is_found() -> None:
    assert linked_again("An {term}`ulp` or {term}`unit in the last place`.") == {"ulp"}


def test_ordinary_words_are_names_of_the_glossary() -> None:
    assert {name for name in ORDINARY if name not in ENTRY_OF} == set()


# --- Formulas are formulas ------------------------------------------------------------------------


def raw_formulas(lesson: str) -> list[str]:
    """Text that is meant as a formula and is shown as it is written: a line of it that begins like
    an item of a list ends it.
    """
    parts = (part for block in MARKDOWN.parse(lesson) for part in block.children or ())
    return [
        part.content
        for part in parts
        if part.type == "text" and re.search(r"\$|\\[A-Za-z]", part.content)
    ]


@pytest.mark.parametrize("chapter", LESSONS, ids=[chapter.slug for chapter in LESSONS])
def test_no_formula_is_shown_as_it_is_written(chapter: Chapter) -> None:
    assert raw_formulas(chapter.lesson.read_text(encoding="utf-8")) == []


def test_a_formula_that_a_list_ends_is_found() -> None:
    assert raw_formulas("With $a =\n\\sin b$ it is $0$.\n") == []
    assert raw_formulas("With $a = (b\n- \\sin c)$ it is.\n") == [
        "With $a = (b",
        "\\sin c)$ it is.",
    ]
