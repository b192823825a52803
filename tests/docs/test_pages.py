"""Every page that is built: the sample's, and the book's own if it has been built."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from bs4 import BeautifulSoup
from sample_book import ROOT, Sample

COMPONENTS = "contact-figure, contact-question, contact-ladder, contact-exercise"
_ELSEWHERE = re.compile(r"^(?:https?:)?//")


@cache
def parsed(path: Path) -> BeautifulSoup:
    """Read once for all tests, which only look at it: parsing takes longer than they do."""
    return BeautifulSoup(path.read_text(encoding="utf-8"), "html.parser")


def pages(site: Path) -> Iterator[tuple[Path, BeautifulSoup]]:
    for path in sorted(site.rglob("*.html")):
        # The pages to embed repeat the lessons, word for word (test_embeds.py).
        if path.relative_to(site).parts[0] not in ("_static", "embed"):
            yield path, parsed(path)


@pytest.fixture(params=["sample", "book"])
def site(request: pytest.FixtureRequest, built: Sample) -> Path:
    if request.param == "sample":
        return built.site
    book = ROOT / "build" / "site"
    if not (book / "index.html").is_file():
        pytest.skip("the book itself is not built: cmake --build build/dev --target docs")
    return book


def test_nothing_is_loaded_from_another_host(site: Path) -> None:
    loads = {"script": "src", "img": "src", "link": "href", "iframe": "src", "source": "src"}
    found = [
        f"{path.name}: {tag[attribute]}"
        for path, page in pages(site)
        for name, attribute in loads.items()
        for tag in page.select(f"{name}[{attribute}]")
        if _ELSEWHERE.match(str(tag[attribute])) and "canonical" not in tag.get("rel", [])
    ]
    assert found == []


def test_no_style_asks_another_host(site: Path) -> None:
    asked = re.compile(r"(?:url\(|@import\s+)[\"']?(?:https?:)?//")
    found = [str(path) for path in site.rglob("*.css") if asked.search(path.read_text("utf-8"))]
    assert found == []


def test_every_font_a_style_names_is_there(site: Path) -> None:
    for style in site.rglob("*.css"):
        for name in re.findall(r"url\([\"']?([^)\"']+\.woff2?)", style.read_text("utf-8")):
            assert (style.parent / name).is_file(), f"{style.name} asks for {name}"
            assert name.endswith("woff2")


def test_all_mathematics_is_rendered(site: Path) -> None:
    for path, page in pages(site):
        for element in page.select("span.math, div.math"):
            assert element.select("math"), f"{path.name}: {element.get_text()}"
        code = page.select("script, pre, code")
        hidden = {id(text) for element in code for text in element.strings}
        words = "".join(text for text in page.strings if id(text) not in hidden)
        assert "\\(" not in words, path.name
        assert "\\frac" not in words, path.name
        assert "$$" not in words, path.name


def test_every_component_says_something_without_script(site: Path) -> None:
    seen = 0
    for path, page in pages(site):
        for element in page.select(
            "contact-figure, contact-question, contact-ladder, contact-exercise"
        ):
            seen += 1
            words = [
                text
                for text in element.find_all(string=True)
                if text.parent and text.parent.name != "script" and text.strip()
            ]
            pictures = [image for image in element.select("img") if image.get("alt")]
            assert words or pictures, f"{path.name}: {element.name} {element.get('name')}"
    assert seen > 0


def test_links_between_pages_lead_somewhere(site: Path) -> None:
    for path, page in pages(site):
        for link in page.select("a[href]"):
            target = str(link["href"]).partition("#")[0].partition("?")[0]
            if target and "://" not in target and not target.startswith(("mailto:", "data:")):
                assert (path.parent / target).resolve().exists(), f"{path.name}: {target}"


def test_each_page_has_one_first_heading_and_its_language(site: Path) -> None:
    for path, page in pages(site):
        if path.name == "search.html":
            continue  # its script writes the heading
        assert len(page.select("h1")) == 1, path.name
        assert page.select_one("html[lang=en]"), path.name
