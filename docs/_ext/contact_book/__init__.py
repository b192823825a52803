"""The Sphinx extension of the book: its directives, its mathematics, its built products."""

from __future__ import annotations

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.typing import ExtensionMetadata

from contact_book.answers import Answers
from contact_book.api import depend_on_headers, forget_gone
from contact_book.ask import Question, Recall
from contact_book.ask_engines import AskEngines
from contact_book.assets import add_script, copy_components
from contact_book.blocks import connect as connect_blocks
from contact_book.chapter import (
    ChapterFoot,
    ChapterHead,
    ChapterRole,
    Objectives,
    append_frame,
    place_head,
)
from contact_book.chapter_map import ChapterMap
from contact_book.deeper import Deeper
from contact_book.ebook import connect as connect_ebook
from contact_book.embeds import write_embeds
from contact_book.errata import ErrataRole
from contact_book.exercise import Exercise
from contact_book.exercise_data import connect as connect_exercise_data
from contact_book.fonts import copy_fonts, subset_fonts
from contact_book.hard_cases import HardCases
from contact_book.highlight import mark_less
from contact_book.home import BookContents, ChapterCards, EBookLink, read_again
from contact_book.html import depart_through, visit_component, visit_through
from contact_book.ladder import Ladder, draw_ahead
from contact_book.landmarks import name_columns, plain_captions
from contact_book.listing import Code, Example, Measured
from contact_book.live_figure import LiveFigure
from contact_book.locations import name_authors_files
from contact_book.maths import visit_block, visit_inline
from contact_book.minify import minify
from contact_book.mutants import Mutants
from contact_book.nodes import component, slot
from contact_book.offline import write_offline
from contact_book.page_order import connect as connect_page_order
from contact_book.scene_player import ScenePlayer
from contact_book.syllabus import Course, Syllabus
from contact_book.term_index import show_index
from contact_book.terms import connect as connect_terms
from contact_book.your_work import YourWork
from contact_book.your_work import read_again as read_your_work_again

DIRECTIVES = {
    "live-figure": LiveFigure,
    "scene-player": ScenePlayer,
    "exercise": Exercise,
    "your-work": YourWork,
    "ask-engines": AskEngines,
    "question": Question,
    "recall": Recall,
    "answers": Answers,
    "ladder": Ladder,
    "hard-cases": HardCases,
    "mutants": Mutants,
    "example": Example,
    "code": Code,
    "measured": Measured,
    "objectives": Objectives,
    "deeper": Deeper,
    "chapter-head": ChapterHead,
    "chapter-foot": ChapterFoot,
    "chapter-map": ChapterMap,
    "chapter-cards": ChapterCards,
    "book-contents": BookContents,
    "e-book-link": EBookLink,
    "syllabus": Syllabus,
    "course": Course,
}


def _add_node(app: Sphinx, node: type[nodes.Element]) -> None:
    through = (visit_through, depart_through)
    html = (visit_component, depart_through) if node is component else through
    app.add_node(node, html=html, epub=html, latex=through, text=through, man=through)


def setup(app: Sphinx) -> ExtensionMetadata:
    app.add_config_value("contact_root", "", "env", str)
    app.add_config_value("contact_products", "", "env", str)
    app.add_config_value("contact_web", "", "env", str)
    app.add_config_value("contact_node", "", "env", str)
    app.add_config_value("contact_plotter", "", "env", str)
    # A page that lacks something is read again each time (home.py), so this makes none stale.
    app.add_config_value("contact_complete", False, "", bool)
    app.add_config_value("contact_some_figures", False, "", bool)
    app.add_config_value("contact_fonts", None, "", str)
    # Whether Doxygen documents the headers; every page is written anew when that changes.
    app.add_config_value("contact_api", True, "html", bool)
    # Whether the e-book is, or will be, in the folder of the pages.
    app.add_config_value("contact_ebook", True, "", bool)
    for name, directive in DIRECTIVES.items():
        app.add_directive(name, directive, override=True)
    app.add_role("chapter", ChapterRole())
    app.add_role("errata", ErrataRole())
    for node in (component, slot):
        _add_node(app, node)
    app.add_html_math_renderer("katex", (visit_inline, None), (visit_block, None))
    app.add_css_file("katex/katex.css")
    mark_less()
    connect_exercise_data(app)
    connect_ebook(app)
    connect_page_order(app)
    connect_blocks(app)
    connect_terms(app)
    app.connect("builder-inited", name_authors_files)
    app.connect("builder-inited", copy_fonts)
    app.connect("builder-inited", copy_components)
    app.connect("env-get-outdated", forget_gone, priority=100)
    app.connect("env-get-outdated", read_again)
    app.connect("env-get-outdated", read_your_work_again)
    app.connect("env-before-read-docs", draw_ahead)
    app.connect("source-read", append_frame)
    app.connect("source-read", depend_on_headers)
    app.connect("doctree-read", place_head)
    app.connect("html-page-context", add_script)
    app.connect("html-page-context", show_index)
    app.connect("html-page-context", plain_captions, priority=900)
    app.connect("build-finished", name_columns)
    app.connect("build-finished", subset_fonts)
    app.connect("build-finished", minify, priority=800)
    app.connect("build-finished", write_embeds, priority=850)
    app.connect("build-finished", write_offline, priority=900)
    # Another env_version: what was kept by an earlier build is not read.
    return {
        "version": "1",
        "env_version": 1,
        "parallel_read_safe": False,
        "parallel_write_safe": True,
    }
