"""The page of answers, for paper, for the e-book and for a browser without scripts.

stage.py writes the page with one section for each chapter that has questions; `{answers} NN_slug`
fills a section. Each answer links back to its question, and each question to its answer (ask.py).
"""

from __future__ import annotations

from docutils import nodes
from sphinx.writers.html5 import HTML5Translator

from contact_book.ask import ANSWERS_PAGE, Asking, answer_id, asked_html
from contact_book.book import Book
from contact_book.errors import BookError
from contact_book.html import attributes, renders, slots
from contact_book.nodes import component
from contact_book.questions import Gap, Question, load_questions

_INTRO = """---
nosearch: true
---
# Answers

The answers to the questions of the lessons, chapter by chapter. Answer a question before you look
here: each answer links back to its question.
"""


def answers_page(book: Book) -> dict[str, str]:
    """The page by its name in the staged folder; none for a book without questions."""
    parts = [
        f"## {chapter.title}\n\n:::{{answers}} {chapter.slug}\n:::"
        for chapter in book.chapters.values()
        if chapter.has_lesson and (chapter.folder / "questions.toml").is_file()
    ]
    return {f"{ANSWERS_PAGE}.md": "\n\n".join([_INTRO.strip(), *parts, ""])} if parts else {}


class Answers(Asking):
    """The answers to a chapter's questions."""

    required_arguments = 1

    def build(self) -> list[nodes.Node]:
        chapter = self.book.chapter(self.arguments[0].strip(), self.source)
        questions = load_questions(self.book, chapter)
        if not questions:
            raise BookError(f"chapters/{chapter.slug}/questions.toml has no question")
        return [self.component("answer", question) for question in questions.values()]


def quantity(value: float, unit: str) -> str:
    return f"{value:.15g} {unit}".strip()


def _gap_html(gap: Gap) -> str:
    return f"<li>{gap.label}: {quantity(gap.answer, gap.unit)}</li>"


def shown_answer(question: Question, parts: dict[str, list[str]]) -> str:
    """The answer in words; a construction has none but its explanation."""
    if question.kind == "predict":
        return f"<p>{quantity(question.answer, question.unit)}</p>"
    if question.kind == "choose":
        return f"<p>{parts['choice'][question.answer]}</p>"
    if question.kind == "order":
        items = "".join(f"<li>{parts['choice'][index]}</li>" for index in question.answer)
        return f"<ol>{items}</ol>"
    if question.kind == "complete":
        return f"<ol>{''.join(_gap_html(gap) for gap in question.gaps)}</ol>"
    return ""


@renders("answer")
def answer_html(translator: HTML5Translator, node: component) -> str:
    question: Question = node["data"]["question"]
    parts = slots(translator, node)
    builder = translator.builder
    lesson = builder.get_relative_uri(builder.current_docname, f"chapters/{question.chapter.slug}")
    criteria = "".join(f"<li>{item}</li>" for item in parts.get("criterion", []))
    weigh = f"<p>A good answer says:</p><ul>{criteria}</ul>" if criteria else ""
    return (
        f'<div class="question"{attributes(id=answer_id(question))}>'
        f"{asked_html(question, parts)}"
        f'<div class="key"><p class="kind">Answer</p>{shown_answer(question, parts)}'
        f'<div class="explain">{parts["explain"][0]}</div>{weigh}</div>'
        f'<p class="to-answer"><a href="{lesson}#question-{question.id}">'
        "Back to the question</a></p></div>\n"
    )
