"""`{question}` and `{recall}`: questions that the page checks and that also work on paper.

No answer stands under its question: without scripts and in the e-book each question links to its
answer on the page of answers (answers.py).
"""

from __future__ import annotations

import re
from typing import Any

from bs4 import BeautifulSoup
from docutils import nodes
from sphinx.writers.html5 import HTML5Translator

from contact_book.directive import BookDirective
from contact_book.errors import BookError
from contact_book.html import (
    attributes,
    base_path,
    can_run_scripts,
    embed_address,
    json_script,
    renders,
    slots,
)
from contact_book.nodes import component, make_component, make_slot, slot
from contact_book.questions import GAP, Wrong, find_question
from contact_book.questions import Question as QuestionData

LABELS = {
    "predict": "Predict",
    "choose": "Choose",
    "order": "Put in order",
    "construct": "Construct",
    "complete": "Complete",
    "say-why": "Say why",
}
ANSWERS_PAGE = "answers"
# Where a gap was in a line, while the line is parsed as Markdown.
_HELD = re.compile("\ue000(.*?)\ue001")


class Asking(BookDirective):
    """What every directive does that shows questions."""

    def ask(self, name: str) -> component:
        question = find_question(self.book, name, self.here, self.source)
        self.needs_script()
        # A link must stand in text, which a slot is not.
        wrong = [*question.wrong, *(item for gap in question.gaps for item in gap.wrong)]
        whys = [nodes.inline("", "", *self.inline_markdown(item.why)) for item in wrong]
        return self.component("question", question, [make_slot("why", [why]) for why in whys])

    def component(
        self, kind: str, question: QuestionData, more: tuple[slot, ...] | list[slot] = ()
    ) -> component:
        """A component with the question's own words, and those in `more`."""
        self.depends(question.chapter.folder / "questions.toml")
        fields = [make_slot("text", self.inline_markdown(question.text))]
        fields += [make_slot("choice", self.inline_markdown(item)) for item in question.choices]
        for line in question.lines or [cell for row in question.table for cell in row]:
            fields.append(make_slot("line", self.gapped(line)))
        fields.append(make_slot("explain", self.markdown(question.explain)))
        fields += [make_slot("criterion", self.inline_markdown(it)) for it in question.criteria]
        return make_component(kind, {"question": question}, [*fields, *more])

    def gapped(self, text: str) -> list[nodes.Node]:
        """A line's Markdown; each gap is an element that names it by its class."""
        holder = nodes.inline("", "", *self.inline_markdown(GAP.sub("\ue000\\1\ue001", text)))
        for words in list(holder.findall(nodes.Text)):
            pieces = _HELD.split(words)
            if len(pieces) > 1:
                made: list[nodes.Node] = [nodes.Text(piece) for piece in pieces]
                for n in range(1, len(pieces), 2):
                    classes = ["gap", f"gap-{pieces[n]}"]
                    made[n] = nodes.inline("", "______", classes=classes)
                words.parent.replace(words, made)
        return list(holder.children)


class Question(Asking):
    required_arguments = 1

    def build(self) -> list[nodes.Node]:
        return [self.ask(self.arguments[0].strip())]


class Recall(Asking):
    """The questions from earlier chapters that chapter.toml asks again."""

    optional_arguments = 1

    def build(self) -> list[nodes.Node]:
        slug = self.arguments[0].strip() if self.arguments else self.here
        if slug is None:
            raise BookError("needs a chapter here, as in {recall} 02_triangles")
        chapter = self.book.chapter(slug, self.source)
        self.depends(chapter.folder / "chapter.toml")
        if not chapter.recall:
            raise BookError(f"chapters/{chapter.slug}/chapter.toml lists no recall questions")
        return [self.ask(name) for name in chapter.recall]


def _wrong(items: tuple[Wrong, ...], whys: list[str]) -> list[dict[str, Any]]:
    """The wrong answers; takes their words from the front of `whys`."""
    return [{"answer": item.answer, "why": whys.pop(0)} for item in items]


def payload(question: QuestionData, parts: dict[str, list[str]]) -> dict[str, Any]:
    """The data that the page's element needs in addition to the text, which it takes from the
    fallback."""
    whys = list(parts.get("why", []))
    data: dict[str, Any] = {
        "id": question.ref,
        "kind": question.kind,
        "objective": question.objective,
        "wrong": _wrong(question.wrong, whys),
    }
    if question.kind == "predict":
        data |= {"answer": question.answer, "unit": question.unit, "tolerance": question.tolerance}
        data |= {} if question.convert else {"convert": False}
    elif question.kind == "construct":
        data |= {"figure": question.figure, "goal": question.goal}
    elif question.kind == "complete":
        data["gaps"] = [
            {
                "id": gap.id,
                "label": gap.label,
                "answer": gap.answer,
                "unit": gap.unit,
                "tolerance": gap.tolerance,
                **({} if gap.convert else {"convert": False}),
                "wrong": _wrong(gap.wrong, whys),
            }
            for gap in question.gaps
        ]
    elif question.kind != "say-why":
        data |= {"answer": question.answer}
    return data


def _has_text(cell: str) -> bool:
    """Whether words are left of a table's cell without its formulas and its marks."""
    plain = BeautifulSoup(cell, "html.parser")
    for formula in plain.select(".katex, math"):
        formula.decompose()
    return any(letter.isalnum() for letter in plain.get_text())


def lines_html(question: QuestionData, parts: dict[str, list[str]]) -> str:
    """What is to be completed, with its gaps."""
    texts = iter(parts.get("line", []))
    if question.lines:
        return '<ol class="lines">' + "".join(f"<li>{text}</li>" for text in texts) + "</ol>"
    if not question.table:
        return ""
    head, *rows = ([next(texts) for _ in row] for row in question.table)
    # A head of a formula or of nothing has no text that a screen reader takes for one.
    heads = "".join(
        f'<th scope="col">{cell}</th>' if _has_text(cell) else f"<td>{cell}</td>" for cell in head
    )
    body = "".join(
        (f'<tr><th scope="row">{first}</th>' if _has_text(first) else f"<tr><td>{first}</td>")
        + "".join(f"<td>{cell}</td>" for cell in rest)
        + "</tr>"
        for first, *rest in rows
    )
    return (
        '<div class="wide"><table class="lines">'
        f"<thead><tr>{heads}</tr></thead><tbody>{body}</tbody></table></div>"
    )


def asked_html(question: QuestionData, parts: dict[str, list[str]]) -> str:
    """The kind, the text, and what is chosen from, put in order or completed."""
    choices = ""
    if question.choices:
        choices = "<ul>" + "".join(f"<li>{item}</li>" for item in parts["choice"]) + "</ul>"
    return (
        f'<p class="kind">{LABELS[question.kind]}</p>'
        f'<div class="asked">{parts["text"][0]}</div>{choices}{lines_html(question, parts)}'
    )


def answer_id(question: QuestionData) -> str:
    """The name of the answer on the page of answers."""
    return f"answer-{question.chapter.slug}-{question.id}"


@renders("question")
def question_html(translator: HTML5Translator, node: component) -> str:
    question: QuestionData = node["data"]["question"]
    parts = slots(translator, node)
    builder = translator.builder
    answers = builder.get_relative_uri(builder.current_docname, ANSWERS_PAGE)
    scripts = can_run_scripts(translator)
    own = attributes(id=None if scripts else f"question-{question.id}")
    fallback = (
        f'<div class="question"{own}>{asked_html(question, parts)}'
        f'<p class="to-answer"><a href="{answers}#{answer_id(question)}">'
        "Answer, at the end of the book</a></p></div>"
    )
    if not scripts:
        return fallback
    criteria = "".join(f"<li>{item}</li>" for item in parts.get("criterion", []))
    # What a browser does not show: the script's words for afterwards.
    after = f'<template><div class="explain">{parts["explain"][0]}</div>' + (
        f'<ul class="criteria">{criteria}</ul></template>' if criteria else "</template>"
    )
    script = json_script(payload(question, parts))
    where = attributes(
        base=base_path(translator),
        id=f"question-{question.id}",
        embed=embed_address(translator, "question", question.ref),
    )
    return f"<contact-question{where}>{script}{fallback}{after}</contact-question>\n"
