"""`{question}` and `{recall}`: questions that the page checks and that also work on paper."""

from __future__ import annotations

from typing import Any

from docutils import nodes
from sphinx.writers.html5 import HTML5Translator

from contact_book.directive import BookDirective
from contact_book.errors import BookError
from contact_book.html import attributes, base_path, can_run_scripts, json_script, renders, slots
from contact_book.nodes import component, make_component, make_slot
from contact_book.questions import Question as QuestionData
from contact_book.questions import find_question

LABELS = {
    "predict": "Predict",
    "choose": "Choose",
    "order": "Put in order",
    "construct": "Construct",
}


class Question(BookDirective):
    required_arguments = 1

    def build(self) -> list[nodes.Node]:
        return [self.ask(self.arguments[0].strip())]

    def ask(self, name: str) -> component:
        question = find_question(self.book, name, self.here, self.source)
        self.depends(question.chapter.folder / "questions.toml")
        self.needs_script()
        fields = [make_slot("text", self.inline_markdown(question.text))]
        fields += [make_slot("choice", self.inline_markdown(item)) for item in question.choices]
        fields += [make_slot("explain", self.markdown(question.explain))]
        # A link must stand in text, which a slot is not.
        whys = [nodes.inline("", "", *self.inline_markdown(item.why)) for item in question.wrong]
        fields += [make_slot("why", [why]) for why in whys]
        return make_component("question", {"question": question}, fields)


class Recall(Question):
    """The questions from earlier chapters that chapter.toml asks again."""

    required_arguments = 0
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


def payload(question: QuestionData, parts: dict[str, list[str]]) -> dict[str, Any]:
    """The data that the page's element needs in addition to the text, which it takes from the
    fallback."""
    data: dict[str, Any] = {
        "id": question.ref,
        "kind": question.kind,
        "objective": question.objective,
        "wrong": [
            {"answer": item.answer, "why": why}
            for item, why in zip(question.wrong, parts.get("why", []), strict=True)
        ],
    }
    if question.kind == "predict":
        data |= {"answer": question.answer, "unit": question.unit, "tolerance": question.tolerance}
    elif question.kind == "construct":
        data |= {"figure": question.figure, "goal": question.goal}
    else:
        data |= {"answer": question.answer}
    return data


def shown_answer(question: QuestionData, parts: dict[str, list[str]]) -> str:
    """The answer as words, for the reader without the page's script."""
    if question.kind == "predict":
        unit = f" {question.unit}" if question.unit else ""
        return f"<p>{question.answer:.15g}{unit}</p>"
    if question.kind == "choose":
        return f"<p>{parts['choice'][question.answer]}</p>"
    if question.kind == "order":
        items = "".join(f"<li>{parts['choice'][index]}</li>" for index in question.answer)
        return f"<ol>{items}</ol>"
    return ""


@renders("question")
def question_html(translator: HTML5Translator, node: component) -> str:
    question: QuestionData = node["data"]["question"]
    parts = slots(translator, node)
    choices = ""
    if question.choices:
        choices = "<ul>" + "".join(f"<li>{item}</li>" for item in parts["choice"]) + "</ul>"
    fallback = (
        f'<div class="question"><p class="kind">{LABELS[question.kind]}</p>'
        f'<div class="asked">{parts["text"][0]}</div>{choices}'
        f"<details><summary>Answer</summary>{shown_answer(question, parts)}"
        f'<div class="explain">{parts["explain"][0]}</div></details></div>'
    )
    if not can_run_scripts(translator):
        return fallback
    script = json_script(payload(question, parts))
    where = attributes(base=base_path(translator), id=f"question-{question.id}")
    return f"<contact-question{where}>{script}{fallback}</contact-question>\n"
