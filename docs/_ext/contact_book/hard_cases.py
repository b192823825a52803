"""`{hard-cases}`: inputs on which simple methods fail, with the verdicts of the tests' own
program."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any, ClassVar

from docutils import nodes
from docutils.parsers.rst import directives

from contact_book.directive import BookDirective
from contact_book.errors import BookError
from contact_book.tables import scrolled, table

# What a page shows of a case.
_SHOWN = ("name", "why", "answer_text", "verdicts")


def told_file(root: Path, slug: str) -> Path:
    """The output of the chapter's program for its hard cases, checked in so that pages need no
    program.

    tests/docs/test_told.py compares it with the current output of the program.
    """
    return root / "tests" / slug / "hard_cases.told.json"


def told(said: str) -> str:
    """Of what a program says with --json, what a page shows: the file's text."""
    data = json.loads(said)
    cases = [{key: case[key] for key in _SHOWN} for case in data["cases"]]
    kept = {"methods": data["methods"], "cases": cases}
    return json.dumps(kept, indent=1, ensure_ascii=False) + "\n"


def in_words(name: str) -> str:
    """A case's name with spaces for its hyphens; the sign of an exponent (1e-200) stays."""
    return re.sub(r"(?<!\de)-", " ", name)


def _verdict(word: str) -> nodes.Node:
    return nodes.inline("", word, classes=["verdict", word])


def chosen(cases: list[dict[str, Any]], names: Sequence[str]) -> list[dict[str, Any]]:
    """The cases of these names, in the order of the chapter; all if there are no names."""
    there = {case["name"] for case in cases}
    for name in names:
        if name not in there:
            raise BookError(f'there is no hard case "{name}"')
    return [case for case in cases if not names or case["name"] in names]


class HardCases(BookDirective):
    """`:only:` names the cases to show, for a lesson whose whole table is too long."""

    optional_arguments = 1
    option_spec: ClassVar[dict[str, Any]] = {"only": directives.unchanged_required}

    def build(self) -> list[nodes.Node]:
        slug = self.arguments[0].strip() if self.arguments else self.here
        if slug is None:
            raise BookError("hard-cases needs a chapter here, as in {hard-cases} 02_triangles")
        chapter = self.book.chapter(slug, self.source)
        corpus = self.book.root / "tests" / slug / "hard_cases.json"
        if not corpus.is_file():
            raise BookError(f"tests/{slug}/hard_cases.json is missing")
        path = told_file(self.book.root, chapter.slug)
        self.depends(path)
        if not path.is_file():
            self.missing_product(f"{path} is missing: docs/tell_hard_cases.py {slug} writes it")
            words = "Nothing is known of the hard cases yet."
            return [nodes.paragraph("", words, classes=["not-built"])]
        self.depends(corpus)
        stored = json.loads(corpus.read_text(encoding="utf-8"))["cases"]
        asked = {case["name"]: case["question"].replace("_", " ") for case in stored}
        data = json.loads(path.read_text(encoding="utf-8"))
        for case in data["cases"]:
            if case["name"] not in asked:
                raise BookError(f'{path} has "{case["name"]}", which {corpus} has not')
        return self.tables(data, asked)

    def tables(self, data: dict[str, Any], asked: dict[str, str]) -> list[nodes.Node]:
        """One table for the questions that the same methods answer.

        `asked` has the question of each case.
        """
        groups: dict[tuple[str, ...], list[dict[str, Any]]] = {}
        for case in chosen(data["cases"], self.options.get("only", "").split()):
            methods = tuple(name for name in data["methods"] if name in case["verdicts"])
            groups.setdefault(methods, []).append(case)
        made: list[nodes.Node] = []
        for methods, cases in groups.items():
            made += self.group(methods, cases, asked)
        return made

    def group(
        self, methods: tuple[str, ...], cases: list[dict[str, Any]], asked: dict[str, str]
    ) -> list[nodes.Node]:
        rows = [self.row(methods, case) for case in cases]
        wrong = sum(1 for c in cases for m in methods if c["verdicts"][m] != "right")
        count = "1 hard case" if len(cases) == 1 else f"{len(cases)} hard cases"
        questions = ", ".join(dict.fromkeys(asked[case["name"]] for case in cases))
        words = f"{questions}: {count}; {wrong} of {len(cases) * len(methods)} answers are wrong"
        heads = ["Case", "Exact answer", *methods]
        # A page may show some cases and, in a box, all: regions need names of their own.
        number = self.env.new_serialno("hard-cases") + 1
        label = f"Hard cases, table {number}: {', '.join(methods)}"
        return [scrolled(table(heads, rows, words, ["hard-cases"]), label)]

    def row(self, methods: tuple[str, ...], case: dict[str, Any]) -> list[Any]:
        name = nodes.strong("", in_words(case["name"]))
        title = [name, nodes.Text(f" — {case['why']}")]
        verdicts = [_verdict(case["verdicts"][method]) for method in methods]
        return [title, nodes.Text(case["answer_text"]), *verdicts]
