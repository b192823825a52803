"""What the page's script is given of an exercise, and that the page itself stays light."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from bs4 import BeautifulSoup, Tag
from sample_book import HERE, Sample

SOURCES = HERE / "sample"
REF = "01_lines/distance"


def source(name: str) -> str:
    return (SOURCES / name).read_text(encoding="utf-8")


def read(site: Path, name: str) -> dict[str, Any]:
    path = site / "_static" / "contact" / "exercises" / f"{name}.json"
    loaded = json.loads(path.read_text(encoding="utf-8"))
    assert isinstance(loaded, dict)
    return loaded


@pytest.fixture(scope="module")
def element(built: Sample) -> Tag:
    page = BeautifulSoup(built.page("chapters/01_lines.html"), "html.parser")
    found = page.select("section.exercise > contact-exercise")
    assert len(found) == 1
    return found[0]


def test_the_element_says_which_exercise_it_is_and_where_its_files_are(element: Tag) -> None:
    assert element["name"] == REF
    assert element["base"] == "../_static/contact/"


@pytest.mark.parametrize(("part", "name"), [("contract", "distance.hpp"), ("stub", "distance.cpp")])
def test_a_listing_in_the_page_is_the_file_letter_by_letter(
    element: Tag, part: str, name: str
) -> None:
    listing = element.select(f":scope > .{part} pre")
    assert [pre.get_text() for pre in listing] == [source(f"exercises/{REF}/{name}")]


def test_the_page_holds_neither_the_solution_nor_what_a_test_may_say(built: Sample) -> None:
    page = built.page("chapters/01_lines.html")
    assert "hypot" not in page
    assert "grows with the" not in page
    assert "grows" not in built.page("searchindex.js")


def test_the_data_has_the_files_as_the_command_line_reads_them(built: Sample) -> None:
    data = read(built.site, REF)
    assert data["format"] == "contact-exercise/1"
    assert (data["id"], data["chapter"], data["name"]) == (REF, "01_lines", "distance")
    assert (data["title"], data["kind"]) == ("Distance from a line", "blank")
    assert data["points"] == 5
    names = [
        f"exercises/{REF}/exercise.toml",
        f"exercises/{REF}/distance.hpp",
        f"exercises/{REF}/distance.cpp",
        f"solutions/{REF}/distance.cpp",
    ]
    assert data["files"] == {name: source(name) for name in names}


def test_hints_and_misconceptions_are_html(built: Sample) -> None:
    data = read(built.site, REF)
    assert data["hints"][0] == "<p>A distance is never negative.</p>"
    assert len(data["hints"]) == 2
    assert list(data["misconceptions"]) == ["distance-without-length"]
    hint = data["misconceptions"]["distance-without-length"]
    assert "<em>length</em>" in hint
    assert 'class="katex"' in hint
    assert "<code" in hint


def test_the_book_is_described_for_a_report_of_progress(built: Sample) -> None:
    data = read(built.site, "book")
    assert data["format"] == "contact-book/1"
    names = ["chapters/00_numbers/chapter.toml", "chapters/01_lines/chapter.toml"]
    names += ["chapters/misconceptions.toml", "exercises/01_lines/distance/exercise.toml"]
    assert data["files"] == {name: source(name) for name in names}
    assert data["exercises"] == [REF]
    assert data["titles"] == {REF: "Distance from a line"}
    assert data["points"] == {REF: 5}


def test_data_follows_its_files_and_outlives_builds_that_write_no_page(sample: Sample) -> None:
    assert sample.make("--skip-api").returncode == 0
    before = read(sample.site, REF)
    assert sample.make("--skip-api").returncode == 0
    assert read(sample.site, REF) == before
    sample.edit(f"solutions/{REF}/distance.cpp", "std::hypot(a, b)", "std::sqrt(a * a + b * b)")
    assert sample.make("--skip-api").returncode == 0
    assert "sqrt" in read(sample.site, REF)["files"][f"solutions/{REF}/distance.cpp"]
    sample.edit("chapters/misconceptions.toml", "should not", "must not")
    assert sample.make("--skip-api").returncode == 0
    assert "must not" in read(sample.site, REF)["misconceptions"]["distance-without-length"]


def test_data_that_has_gone_is_made_again(sample: Sample) -> None:
    assert sample.make("--skip-api").returncode == 0
    (sample.build / "docs-data" / "exercises" / f"{REF}.json").unlink()
    assert sample.make("--skip-api").returncode == 0
    assert read(sample.site, REF)["id"] == REF


@pytest.mark.parametrize(
    ("name", "message"),
    [
        (f"exercises/{REF}/distance.cpp", f"exercises/{REF}/distance.cpp is missing"),
        (f"solutions/{REF}/distance.cpp", f"solutions/{REF}/distance.cpp is missing"),
    ],
)
def test_a_missing_file_is_an_error_at_the_directive(
    sample: Sample, name: str, message: str
) -> None:
    (sample.root / name).unlink()
    made = sample.make("--skip-api")
    assert made.returncode != 0
    assert message in made.stderr


def test_a_misconception_that_nobody_described_is_an_error(sample: Sample) -> None:
    sample.edit(f"exercises/{REF}/exercise.toml", "distance-without-length", "distance-withuot")
    made = sample.make("--skip-api")
    assert made.returncode != 0
    assert "unknown misconception 'distance-withuot'" in made.stderr
    assert "distance-without-length" in made.stderr


def test_an_e_book_has_the_listings_and_no_data(sample: Sample) -> None:
    target = sample.build / "epub"
    made = sample.make("--skip-api", "--builder", "epub", "--site", str(target))
    assert made.returncode == 0, made.stderr
    page = (target / "chapters" / "01_lines.xhtml").read_text("utf-8")
    words = BeautifulSoup(page, "html.parser").get_text()
    assert words.count("double distance(double a") == 2
    assert "contact::todo();" in words
    assert not list(target.rglob("*.json"))
