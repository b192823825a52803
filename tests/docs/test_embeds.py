"""The pages to embed: one for each component of a lesson, with the lesson's own HTML."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import urljoin, urlsplit

import pytest
from bs4 import BeautifulSoup
from contact_book.embeds import chosen, pieces
from sample_book import ROOT, Sample

_SHOWN = re.compile(r'<article role="main"><h1>.*?</h1>\n(.*)\n<p class="from">', re.S)


@pytest.fixture(params=["sample", "book"], scope="module")
def site(request: pytest.FixtureRequest, built: Sample) -> Path:
    if request.param == "sample":
        return built.site
    book = ROOT / "build" / "site"
    if not (book / "embed").is_dir():
        pytest.skip("the book itself is not built: cmake --build build/dev --target docs")
    return book


def lessons(site: Path) -> dict[str, str]:
    return {file.stem: file.read_text("utf-8") for file in (site / "chapters").glob("*.html")}


def embeds(site: Path) -> dict[str, str]:
    files = sorted((site / "embed").rglob("*.html"))
    return {file.relative_to(site).as_posix(): file.read_text("utf-8") for file in files}


def names(lesson: str) -> Iterator[str]:
    """The pages that the components of a lesson have, by what the elements say of themselves."""
    for kind in ("figure", "exercise"):
        for ref in re.findall(rf'<contact-{kind} [^>]*?\bname="([^"]+)"', lesson):
            chapter, name = ref.split("/")
            yield f"embed/{chapter}/{kind}/{name}.html"
    for data in re.findall(r"<contact-question [^>]*><script[^>]*>(.*?)</script>", lesson, re.S):
        chapter, name = json.loads(data)["id"].split("/")
        yield f"embed/{chapter}/question/{name}.html"


def address(path: str, page: str, link: str) -> str:
    """Where a link of a page leads in the site; the page names its base."""
    base = re.search(r'<base href="([^"]+)"', page)
    assert base, path
    whole = urljoin(urljoin(f"http://book/{path}", str(base[1])), link)
    return whole.removeprefix("http://book/")


def test_each_component_of_a_lesson_has_one(site: Path) -> None:
    wanted = {name for lesson in lessons(site).values() for name in names(lesson)}
    assert wanted
    assert set(embeds(site)) == wanted


def test_its_html_is_the_lessons(site: Path) -> None:
    texts = lessons(site)
    for path, page in embeds(site).items():
        shown = _SHOWN.search(page)
        lesson = re.search(r'<base href="\.\./\.\./\.\./chapters/(\w+)\.html"', page)
        assert shown, path
        assert lesson, path
        figure = re.compile(r'\n?<figure class="live".*?</figure>\n?', re.S)
        whole = "/figure/" in path
        parts = [shown[1]] if whole else [figure.sub("", shown[1]), *figure.findall(shown[1])]
        for part in parts:
            assert part.strip() in texts[lesson[1]], path


def test_it_leads_back_to_its_position_in_the_lesson(site: Path) -> None:
    texts = lessons(site)
    tags = {"figure": "figure", "exercise": "section", "question": "contact-question"}
    for path, page in embeds(site).items():
        found = re.search(r'<p class="from">From <a href="([^"]+)">', page)
        assert found, path
        target = urlsplit(address(path, page, found[1]))
        assert target.path.startswith("chapters/"), path
        lesson, tag = texts[Path(target.path).stem], tags[path.split("/")[2]]
        places = re.findall(rf'<([\w-]+) [^<>]*?\bid="{target.fragment}"', lesson)
        assert places == [tag], f"{path}: {found[1]}"
        start = lesson.index(f'id="{target.fragment}"')
        follow = names(lesson[lesson.rindex("<", 0, start) :])
        assert next(name for name in follow if name.split("/")[2] == path.split("/")[2]) == path


def test_ids_are_unique_and_all_that_it_loads_is_there(site: Path) -> None:
    for path, page in embeds(site).items():
        # The theme gives a table's id to the box around it, too.
        own = re.sub(r'<div class="table-wrapper[^>]*>', "", page)
        ids = re.findall(r'<[a-z][^<>]*? id="([^"]+)"', own)
        assert len(ids) == len(set(ids)), path
        loaded = re.findall(r'<(?:script|link|img)\b[^<>]*? (?:src|href)="([^"]+)"', page)
        assert any(name.partition("?")[0].endswith("embed/page.js") for name in loaded), path
        for link in loaded:
            file = site / urlsplit(address(path, page, link)).path
            assert file.is_file(), f"{path}: {link}"


def test_a_search_engine_is_told_to_leave_it_out(site: Path) -> None:
    for path, page in embeds(site).items():
        assert '<meta name="robots" content="noindex">' in page, path
    assert "embed/" not in (site / "searchindex.js").read_text("utf-8")


def test_a_construction_has_its_figure_and_another_question_has_none(built: Sample) -> None:
    for name, figures in (("touch", ["01_lines/point_line"]), ("side", [])):
        page = BeautifulSoup(built.page(f"embed/01_lines/question/{name}.html"), "html.parser")
        assert [figure["name"] for figure in page.select("contact-figure")] == figures


def test_a_question_that_is_asked_again_is_shown_with_its_own_lesson() -> None:
    asked = (
        '<contact-question base="b" id="question-q"><script type="application/json">'
        '{"id":"01_lines/q","kind":"choose"}</script>%s</contact-question>'
    )
    later = list(pieces("00_numbers", asked % "later"))
    own = list(pieces("01_lines", asked % "own"))
    both, alone = chosen([*later, *own]), chosen(later)
    assert [piece.lesson for piece in both.values()] == ["01_lines"]
    assert [piece.lesson for piece in alone.values()] == ["00_numbers"]
    assert list(both) == list(alone) == ["embed/01_lines/question/q.html"]


def test_it_goes_when_the_lesson_no_longer_has_the_component(sample: Sample) -> None:
    assert sample.make().returncode == 0
    gone = sample.site / "embed/01_lines/question/how-far.html"
    other = sample.site / "embed/01_lines/question/steps.html"
    assert gone.is_file()
    before = other.read_text("utf-8")
    sample.edit("chapters/01_lines/lesson.md", ":::{question} how-far\n:::\n", "")
    assert sample.make().returncode == 0
    assert not gone.exists()
    assert other.read_text("utf-8") == before


def test_an_e_book_has_no_link_to_one(sample: Sample) -> None:
    made = sample.make("--builder", "epub")
    assert made.returncode == 0, made.stderr
    lesson = (sample.build / "epub" / "chapters" / "01_lines.xhtml").read_text("utf-8")
    assert "Drag the point" in lesson
    assert "embed" not in lesson


def test_the_addresses_that_the_documentation_names_exist() -> None:
    text = (ROOT / "docs" / "embed.md").read_text("utf-8")
    found = set(re.findall(r"embed/(\d\d_\w+)/(\w+)/([\w-]+)\.html", text))
    assert {kind for _, kind, _ in found} == {"figure", "exercise", "question"}
    for slug, kind, name in found:
        chapter = ROOT / "chapters" / slug
        if kind == "figure":
            assert (chapter / "figures" / f"{name}.ts").is_file()
        elif kind == "exercise":
            assert (ROOT / "exercises" / slug / name).is_dir()
        else:
            questions = (chapter / "questions.toml").read_text("utf-8")
            assert f'id = "{name}"' in questions
