"""`{hard-cases}`: inputs that break plain methods, as the tests' own program judges them."""

from __future__ import annotations

import json
from typing import Any

from docutils import nodes

from contact_book.directive import BookDirective
from contact_book.errors import BookError
from contact_book.tables import scrolled, table


def _verdict(word: str) -> nodes.Node:
    return nodes.inline("", word, classes=["verdict", word])


class HardCases(BookDirective):
    optional_arguments = 1

    def build(self) -> list[nodes.Node]:
        slug = self.arguments[0].strip() if self.arguments else self.here
        if slug is None:
            raise BookError("hard-cases needs a chapter here, as in {hard-cases} 02_triangles")
        chapter = self.book.chapter(slug, self.source)
        corpus = self.book.root / "tests" / slug / "hard_cases.json"
        if not corpus.is_file():
            raise BookError(f"tests/{slug}/hard_cases.json is missing")
        path = self.book.products / "hard_cases" / f"{chapter.slug}.json"
        self.depends(path)
        if not path.is_file():
            self.missing_product(f"hard_cases_{slug} has not run: {path}")
            words = "The table of hard cases is still being built."
            return [nodes.paragraph("", words, classes=["not-built"])]
        return self.tables(json.loads(path.read_text(encoding="utf-8")))

    def tables(self, data: dict[str, Any]) -> list[nodes.Node]:
        """One table for each question the cases ask, since each has methods of its own."""
        groups: dict[tuple[str, ...], list[dict[str, Any]]] = {}
        for case in data["cases"]:
            methods = tuple(name for name in data["methods"] if name in case["verdicts"])
            groups.setdefault(methods, []).append(case)
        made: list[nodes.Node] = []
        for methods, cases in groups.items():
            made += self.group(methods, cases)
        return made

    def group(self, methods: tuple[str, ...], cases: list[dict[str, Any]]) -> list[nodes.Node]:
        rows = [self.row(methods, case) for case in cases]
        wrong = sum(1 for c in cases for m in methods if c["verdicts"][m] != "right")
        words = (
            f"{len(cases)} hard cases; {wrong} of {len(cases) * len(methods)} verdicts are wrong"
        )
        heads = ["Case", "Exact answer", *methods]
        label = f"Hard cases of {', '.join(methods)}"
        return [scrolled(table(heads, rows, words, ["hard-cases"]), label)]

    def row(self, methods: tuple[str, ...], case: dict[str, Any]) -> list[Any]:
        name = nodes.strong("", case["name"].replace("-", " "))
        title = [name, nodes.Text(f" — {case['why']}")]
        verdicts = [_verdict(case["verdicts"][method]) for method in methods]
        return [title, nodes.Text(case["answer_text"]), *verdicts]
