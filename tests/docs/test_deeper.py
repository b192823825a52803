"""Deeper boxes: closed at first in the page, a section in the e-book, found by the search."""

from __future__ import annotations

import json

from bs4 import BeautifulSoup
from sample_book import Sample

LESSON = "chapters/01_lines/lesson.md"


def test_a_box_is_closed_at_first_and_needs_no_script(built: Sample) -> None:
    page = BeautifulSoup(built.page("chapters/01_lines.html"), "html.parser")
    [box] = page.select("details.deeper")
    assert not box.has_attr("open")
    assert box["id"] == "deeper-beside-n-an-outline"
    summary = box.select_one("summary")
    assert summary is not None
    assert summary.get_text().startswith("Deeper Beside ")
    assert summary.select("math")
    assert summary.select("#beside-the-line")
    assert box.select_one(".inside .literal-block-wrapper pre")
    assert "strip" in box.get_text()


def test_the_search_finds_the_words_of_a_box(built: Sample) -> None:
    index = built.page("searchindex.js").removeprefix("Search.setIndex(").removesuffix(")")
    found = json.loads(index)
    assert found["docnames"][found["terms"]["strip"]] == "chapters/01_lines"


def test_an_empty_box_and_a_title_used_twice_fail_the_build(sample: Sample) -> None:
    text = (sample.root / LESSON).read_text(encoding="utf-8")
    again = ":::{deeper} Empty\n:::\n\n:::{deeper} Twice\na\n:::\n\n:::{deeper} Twice\nb\n:::\n"
    (sample.root / LESSON).write_text(f"{text}\n{again}", encoding="utf-8")
    made = sample.make()
    assert made.returncode == 1
    assert "the box 'Empty' is empty" in made.stderr
    assert "two boxes of this page are called 'Twice'" in made.stderr
