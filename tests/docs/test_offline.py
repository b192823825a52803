"""The list of the site's files, and the page of a reader's own work."""

from __future__ import annotations

import hashlib
import json

import pytest
from bs4 import BeautifulSoup
from contact_book.offline import offline_list
from sample_book import Sample


@pytest.fixture(scope="module")
def listed(built: Sample) -> dict[str, dict[str, str | int]]:
    made = json.loads((built.site / "offline.json").read_text("utf-8"))
    assert made["format"] == "contact-offline/1"
    files: dict[str, dict[str, str | int]] = made["files"]
    return files


def test_every_page_and_every_part_of_one_is_listed(
    built: Sample, listed: dict[str, dict[str, str | int]]
) -> None:
    every = {page.relative_to(built.site).as_posix() for page in built.site.rglob("*.html")}
    pages = {page for page in every if not page.startswith("embed/")}
    assert pages <= set(listed)
    for page in pages:
        loaded = BeautifulSoup(built.page(page), "html.parser")
        for tag in loaded.select("script[src], link[rel=stylesheet][href], img[src]"):
            address = str(tag.get("src") or tag["href"]).partition("?")[0]
            place = ((built.site / page).parent / address).resolve()
            assert place.relative_to(built.site).as_posix() in listed, f"{page}: {address}"


def test_each_file_is_listed_as_it_is(
    built: Sample, listed: dict[str, dict[str, str | int]]
) -> None:
    for name, entry in listed.items():
        content = (built.site / name).read_bytes()
        assert hashlib.sha256(content).hexdigest().startswith(str(entry["hash"])), name
        assert entry["bytes"] == len(content), name
        assert 0 < int(entry["transfer"]) <= len(content) + 64, name


def test_the_list_knows_neither_itself_nor_the_worker_nor_hidden_files(
    listed: dict[str, dict[str, str | int]],
) -> None:
    assert not {"offline.json", "sw.js"} & set(listed)
    left_out = ("_sources/", "embed/")
    assert not [name for name in listed if "/." in f"/{name}" or name.startswith(left_out)]


def test_a_version_is_its_files(sample: Sample) -> None:
    site = sample.root / "site"
    site.mkdir()
    (site / "a.html").write_text("a")
    first = offline_list(site)
    assert offline_list(site) == first
    (site / "a.html").write_text("b")
    assert json.loads(offline_list(site))["version"] != json.loads(first)["version"]


def test_the_page_of_ones_work_names_every_exercise_and_serves_without_script(
    built: Sample,
) -> None:
    page = BeautifulSoup(built.page("your_work.html"), "html.parser")
    element = page.select("contact-work")[0]
    (chapter,) = json.loads(element.select("script")[0].get_text())["chapters"]
    assert chapter["href"] == "chapters/01_lines.html"
    (exercise,) = chapter["exercises"]
    assert exercise["id"] == "01_lines/distance"
    page_of, _, anchor = exercise["href"].partition("#")
    lesson = BeautifulSoup(built.page(page_of), "html.parser")
    assert lesson.select(f"section#{anchor}.exercise")
    assert "contact export" in element.get_text()
