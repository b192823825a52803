"""Terms: the glossary, definitions on the page, the index, and where the search leads."""

from __future__ import annotations

import json
from typing import Any

import pytest
from bs4 import BeautifulSoup, Tag
from sample_book import Sample

LESSON = "chapters/01_lines/lesson.md"


def parsed(sample: Sample, page: str) -> BeautifulSoup:
    return BeautifulSoup(sample.page(page), "html.parser")


def links(page: BeautifulSoup) -> list[Tag]:
    return [
        link
        for link in page.select("article a:has(> .std-term)")
        if not link.find_parent(hidden=True)
    ]


def search_index(sample: Sample) -> dict[str, Any]:
    text = sample.page("searchindex.js")
    found: dict[str, Any] = json.loads(text.removeprefix("Search.setIndex(").removesuffix(")"))
    return found


def test_a_term_links_to_its_entry_under_any_name(built: Sample) -> None:
    page = parsed(built, "chapters/01_lines.html")
    assert [(link.get_text(), link["href"]) for link in links(page)] == [
        ("Signed distance", "../glossary.html#term-signed-distance"),
        ("signed distance", "../glossary.html#term-signed-distance"),
        ("Hesse’s value", "../glossary.html#term-Hesses-value"),
    ]
    glossary = parsed(built, "glossary.html")
    assert glossary.find(id="term-Hesses-value")


def test_a_page_holds_the_definitions_of_the_terms_that_it_links_to(built: Sample) -> None:
    page = parsed(built, "chapters/01_lines.html")
    [box] = page.select(".definitions")
    assert box.has_attr("hidden")
    [definition] = box.select(".definition")
    names = str(definition["data-terms"]).split()
    assert {"term-signed-distance", "term-Hesses-value"} <= set(names)
    assert "The distance of a point from a line" in definition.get_text()
    assert "Also: oriented distance, Hesse’s value" in definition.get_text()
    assert definition.select("math")
    assert [link["href"] for link in definition.select("a")] == [
        "../glossary.html#term-normal",
        "#",
    ]


def test_the_search_finds_the_words_of_a_definition_in_the_glossary_alone(built: Sample) -> None:
    found = search_index(built)
    page = found["docnames"].index("glossary")
    assert found["terms"]["perpendicular"] == page


@pytest.mark.parametrize(
    "name", ["signed distance", "oriented distance", "hesse’s value", "normal"]
)
def test_the_search_leads_to_the_lesson_that_teaches_a_term(name: str, built: Sample) -> None:
    found = search_index(built)
    places = found["indexentries"][name]
    first = [(found["docnames"][page], anchor) for page, anchor, main in places if main]
    [(page, anchor)] = first
    assert page == "chapters/01_lines"
    assert parsed(built, f"{page}.html").find(id=anchor)
    assert "glossary" in {found["docnames"][page] for page, _, main in places if not main}


def test_the_search_leads_to_the_glossary_where_no_lesson_teaches_a_term(built: Sample) -> None:
    found = search_index(built)
    [(page, _, main)] = found["indexentries"]["support function"]
    assert (found["docnames"][page], main) == ("glossary", True)


def test_the_index_names_the_pages(built: Sample) -> None:
    page = parsed(built, "genindex.html")
    said = {" ".join(item.get_text().split()): item for item in page.select(".term-index li")}
    assert "signed distance: Lines, Glossary" in said
    assert {"half-plane: Lines", "outline: Lines"} <= said.keys()
    assert "support function: Glossary" in said
    first = said["oriented distance: Lines, Glossary"].select("a")[0]
    assert str(first["href"]).startswith("chapters/01_lines.html#term-signed-distance")
    assert first.select("strong")
    assert not [words for words in said if "C++" in words]
    assert len({heading["id"] for heading in page.select("h2")}) == len(page.select("h2")) > 2


def test_the_contents_lead_to_glossary_and_index(built: Sample) -> None:
    sidebar = parsed(built, "index.html").select_one(".sidebar-tree")
    assert sidebar is not None
    assert {"glossary.html", "genindex.html"} <= {link["href"] for link in sidebar.select("a")}


def test_an_unknown_term_fails_the_build(sample: Sample) -> None:
    sample.edit(LESSON, "{term}`Hesse's value`", "{term}`Hess value`")
    made = sample.make()
    assert made.returncode == 1
    assert "term not in glossary: 'Hess value'" in made.stderr
    assert f"{LESSON}:69: WARNING: term not" in made.stderr


def test_the_search_keeps_the_terms_of_pages_that_are_not_built_again(sample: Sample) -> None:
    assert sample.make().returncode == 0
    before = search_index(sample)["indexentries"]
    sample.edit("docs/your_work.md", "# ", "# Now ")
    made = sample.make()
    assert made.returncode == 0, made.stderr
    after = search_index(sample)["indexentries"]
    assert {name: sorted(of) for name, of in after.items()} == {
        name: sorted(of) for name, of in before.items()
    }


def test_a_changed_definition_reaches_the_pages(sample: Sample) -> None:
    assert sample.make().returncode == 0
    sample.edit("docs/glossary.md", "The distance of a point", "The very distance of a point")
    sample.edit("docs/glossary.md", "oriented distance\n", "oriented gap\n")
    made = sample.make()
    assert made.returncode == 0, made.stderr
    [definition] = parsed(sample, "chapters/01_lines.html").select(".definition")
    assert "The very distance" in definition.get_text()
    found = search_index(sample)
    assert "oriented distance" not in found["indexentries"]
    assert {main for _, _, main in found["indexentries"]["oriented gap"]} == {True, False}
