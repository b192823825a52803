"""The faces of the site hold what the book is written in, and little else."""

from __future__ import annotations

import html
from pathlib import Path

import pytest
from contact_book.fonts import characters, faces, formulas, plain, shrink
from fontTools.ttLib import TTFont
from sample_book import ROOT, Sample

PACKAGES = ROOT / "page" / "node_modules"


def letters(face: Path) -> set[str]:
    return set(map(chr, TTFont(face).getBestCmap()))


@pytest.mark.parametrize("name", sorted(faces(PACKAGES)))
def test_a_face_has_every_letter_of_the_book_that_it_ever_had(built: Sample, name: str) -> None:
    words, maths = characters(built.site)
    wanted = maths if name.startswith("katex/") else words
    ours = built.site / "_static" / name
    assert wanted & letters(faces(PACKAGES)[name]) <= letters(ours)
    assert ours.stat().st_size < faces(PACKAGES)[name].stat().st_size


def test_a_face_is_the_same_bytes_each_time() -> None:
    font = faces(PACKAGES)["katex/fonts/KaTeX_Main-Regular.woff2"].read_bytes()
    assert shrink(font, set("x=1")) == shrink(font, set("1x="))


def test_only_the_letters_of_formulas_count_as_mathematics() -> None:
    page = (
        '<p>words <span class="katex"><span class="katex-html"><span class="mord">x</span>'
        '<span style="a"><svg><path d="M0"/></svg>&lt;</span></span></span> and more '
        '"\\u003cspan class=\\"katex-html\\">y\\u003c/span>"</p>'
    )
    assert html.unescape("".join(formulas(plain(page)))) == "x<y"
