"""Every question of the book is asked: the page of answers links back to each."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
ASKED = re.compile(r"^:{3,}\{question\} +(\S+)", re.MULTILINE)
CHAPTERS = sorted(file.parent for file in ROOT.glob("chapters/*/questions.toml"))


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda folder: folder.name)
def test_a_lesson_asks_each_of_its_questions_once(chapter: Path) -> None:
    written = tomllib.loads((chapter / "questions.toml").read_text(encoding="utf-8"))["question"]
    asked = ASKED.findall((chapter / "lesson.md").read_text(encoding="utf-8"))
    # A question of another chapter is asked again by the name NN_slug/ID.
    own = [name for name in asked if "/" not in name]
    assert sorted(own) == sorted(question["id"] for question in written)
