"""Styles and scripts of the site have no comments and no needless spaces."""

from __future__ import annotations

import pytest
from contact_book.minify import _FILES
from sample_book import ROOT, Sample


@pytest.mark.parametrize("name", _FILES)
def test_a_file_of_the_site_has_lines_of_hundreds_of_characters(built: Sample, name: str) -> None:
    text = (built.site / "_static" / name).read_text(encoding="utf-8")
    # The text between backquotes keeps its lines.
    assert len(text) / len(text.splitlines()) > 150


def test_ours_says_what_it_said(built: Sample) -> None:
    ours = (built.site / "_static" / "book.css").read_text(encoding="utf-8")
    source = (ROOT / "docs" / "_static" / "book.css").read_text(encoding="utf-8")
    assert ours.count("@media") == source.count("@media")
    assert len(ours) < 0.9 * len(source)
