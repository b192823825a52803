"""What the lectures get wrong: a page for each, and links to it."""

from __future__ import annotations

from bs4 import BeautifulSoup
from sample_book import Sample

LESSON = "chapters/01_lines/lesson.md"
FILE = "chapters/01_lines/lectures/L20.md"


def test_a_lecture_has_a_page_with_each_chapter_under_its_title(built: Sample) -> None:
    page = BeautifulSoup(built.page("lectures/L20.html"), "html.parser")
    article = page.select_one("article")
    assert article is not None
    headings = [heading.get_text().removesuffix("#") for heading in article.select("h1, h2, h3")]
    assert headings == ["Lines, lectured", "Lines", "The sign of a distance"]
    links = [str(link["href"]) for link in article.select("p a")]
    assert links == ["../chapters/01_lines.html", "../chapters/01_lines.html#beside-the-line"]
    assert not (built.site / "lectures/L21.html").exists()


def test_a_lesson_links_to_its_part_of_the_page(built: Sample) -> None:
    page = BeautifulSoup(built.page("chapters/01_lines.html"), "html.parser")
    [link] = page.select('article a[href^="../lectures/"]')
    assert link.get_text() == "Lines, lectured (L20)"
    address, _, name = str(link["href"]).partition("#")
    target = BeautifulSoup(built.page(f"chapters/{address}"), "html.parser").find(id=name)
    assert target is not None
    heading = target.find_parent("section") if target.name == "span" else target
    assert heading is not None
    assert "The sign of a distance" in heading.get_text()


def test_the_pages_stand_in_the_contents(built: Sample) -> None:
    page = BeautifulSoup(built.page("index.html"), "html.parser")
    sidebar = page.select_one(".sidebar-tree")
    assert sidebar is not None
    captions = [caption.get_text() for caption in sidebar.select("p.caption")]
    assert "What the lectures get wrong" in captions
    assert sidebar.select_one('a[href="lectures/L20.html"]')


def test_a_link_to_what_is_not_written_fails_the_build(sample: Sample) -> None:
    sample.edit(LESSON, "{errata}`L20`", "{errata}`L20`, {errata}`L21`, {errata}`L22`")
    made = sample.make()
    assert made.returncode == 1
    assert "chapters/01_lines/lectures/L21.md does not exist" in made.stderr
    assert "unknown lecture 'L22' in chapters/lectures.toml; there is: L20, L21" in made.stderr


def test_a_mistake_is_told_where_its_author_finds_it(sample: Sample) -> None:
    sample.edit(FILE, "With", "{doc}`nowhere`. With")
    made = sample.make()
    assert made.returncode == 1
    assert f"{FILE}:3" in made.stderr
    (sample.root / FILE).rename(sample.root / FILE.replace("L20", "L99"))
    made = sample.make()
    assert made.returncode == 1
    assert "unknown lecture 'L99.md' in chapters/01_lines/lectures" in made.stderr
