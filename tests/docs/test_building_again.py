"""A second build does only what is stale, and a new chapter needs no list."""

from __future__ import annotations

import os
import re
import shutil

import pytest
from sample_book import Sample


def test_a_change_in_a_header_reaches_the_lesson_that_shows_it(sample: Sample) -> None:
    assert sample.make("--skip-api").returncode == 0
    sample.edit("chapters/01_lines/contact/line.hpp", "The first coefficient", "What x is times")
    assert sample.make("--skip-api").returncode == 0
    assert "What x is times" in sample.page("chapters/01_lines.html")


def test_a_picture_that_arrives_later_is_shown(sample: Sample) -> None:
    picture = sample.root / "web" / "figures" / "01_lines" / "point_line.svg"
    kept = picture.with_suffix(".kept")
    picture.rename(kept)
    assert sample.make("--skip-api").returncode == 0
    kept.rename(picture)
    assert sample.make("--skip-api").returncode == 0
    assert "point_line.svg" in sample.page("chapters/01_lines.html")


def test_a_page_whose_picture_is_not_built_is_not_read_in_every_build(sample: Sample) -> None:
    """The checks build the figures of some chapters: the others' pages wait for theirs."""
    for figure in (sample.root / "web" / "figures" / "01_lines").iterdir():
        figure.rename(figure.with_name(f"{figure.name}.kept"))
    made = sample.make("--skip-api", "--complete", "--some-figures")
    assert made.returncode == 0, made.stderr
    page = sample.build / "site" / "chapters" / "01_lines.html"
    os.utime(page, ns=(page.stat().st_atime_ns, page.stat().st_mtime_ns + 1))
    written = page.stat().st_mtime_ns
    assert sample.make("--skip-api", "--complete", "--some-figures").returncode == 0
    assert page.stat().st_mtime_ns == written


def test_a_chapter_is_found_by_its_folder_and_gone_with_it(sample: Sample) -> None:
    assert sample.make("--skip-api").returncode == 0
    folder = sample.root / "chapters" / "02_more"
    folder.mkdir()
    (folder / "lesson.md").write_text("# More\n\nAfter [lines](../01_lines/lesson.md).\n", "utf-8")
    old = (sample.root / "chapters" / "00_numbers" / "chapter.toml").read_text("utf-8")
    new = (
        old.replace("reference", "lesson")
        .replace("Numbers", "More")
        .replace("part = 0", "part = 1")
    )
    (folder / "chapter.toml").write_text(new, "utf-8")
    made = sample.make("--skip-api")
    assert made.returncode == 0, made.stderr
    assert 'href="chapters/02_more.html"' in sample.page("index.html")
    assert 'href="01_lines.html"' in sample.page("chapters/02_more.html")
    # A page that did not change itself: its sidebar leads to the new one.
    assert 'href="02_more.html"' in sample.page("chapters/01_lines.html")
    shutil.rmtree(folder)
    assert sample.make("--skip-api").returncode == 0
    assert "02_more" not in sample.page("index.html")


def test_a_build_that_was_stopped_before_its_search_index_is_completed(sample: Sample) -> None:
    assert sample.make("--skip-api").returncode == 0
    index = sample.build / "site" / "searchindex.js"
    whole = index.read_text("utf-8")
    index.unlink()
    sample.edit("chapters/01_lines/contact/line.hpp", "The first coefficient", "What x is times")
    made = sample.make("--skip-api")
    assert made.returncode == 0, made.stderr
    pages = re.compile(r'"?docnames"?: ?\[(.*?)\]')
    assert pages.findall(index.read_text("utf-8")) == pages.findall(whole) != []


def test_what_a_lesson_names_of_the_code_is_linked_when_its_page_is_there(sample: Sample) -> None:
    """The lessons are served before Doxygen has run: a name without a page is no fault then."""
    with (sample.root / "chapters" / "01_lines" / "lesson.md").open("a", encoding="utf-8") as file:
        file.write("\nThe sign is that of {cpp:func}`contact::side`.\n")
    first = sample.make("--skip-api")
    assert first.returncode == 0, first.stderr
    assert "contact::side()" in sample.page("chapters/01_lines.html")
    assert "api/01_lines.html#" not in sample.page("chapters/01_lines.html")
    whole = sample.make()
    assert whole.returncode == 0, whole.stderr
    assert "api/01_lines.html#" in sample.page("chapters/01_lines.html")


def test_programs_run_only_when_newer_than_what_they_said(sample: Sample) -> None:
    programs = sample.root / "bin"
    programs.mkdir()
    program = programs / "ladder_01_lines"
    kept = sample.root / "products" / "ladders" / "01_lines.json"
    program.write_text(f'#!/bin/sh\ncp {kept} "$6"\n', "utf-8")
    program.chmod(0o755)
    said = sample.build / "docs-data" / "ladders" / "01_lines.json"
    os.utime(said, (0, 0))
    first = sample.make("--skip-api", "--programs", str(programs))
    assert "ladder of 01_lines" in first.stdout
    again = sample.make("--skip-api", "--programs", str(programs))
    assert "ladder of 01_lines" not in again.stdout
    program.write_text("#!/bin/sh\necho 'the method slide is gone' >&2\nexit 1\n", "utf-8")
    os.utime(program)
    failing = sample.make("--skip-api", "--programs", str(programs))
    assert failing.returncode == 1
    assert "the method slide is gone" in failing.stderr


def test_without_an_e_book_the_home_page_says_how_to_make_it(
    sample: Sample, monkeypatch: pytest.MonkeyPatch
) -> None:
    with (sample.root / "docs" / "index.md").open("a", encoding="utf-8") as index:
        index.write("\n:::{e-book-link}\n:::\n")
    assert sample.make("--skip-api").returncode == 0
    assert 'href="contact-hours.epub"' in sample.page("index.html")
    monkeypatch.setenv("CONTACT_BOOK_EBOOK", "0")
    assert sample.make("--skip-api").returncode == 0
    assert 'href="contact-hours.epub"' not in sample.page("index.html")
    assert "./contact serve --ebook" in sample.page("index.html")


def test_a_name_declared_twice_does_not_double_with_each_build(sample: Sample) -> None:
    def size() -> int:
        return (sample.build / "doctrees" / "environment.pickle").stat().st_size

    twice = (
        "\n/// Also a line.\nstruct Line {\n  int a;  ///< a number\n};\n\n}  // namespace contact"
    )
    sample.edit("chapters/00_numbers/contact/number.hpp", "}  // namespace contact", twice)
    made = sample.make()
    assert "Duplicate C++ declaration" in made.stderr
    first = size()
    for _ in range(5):
        # All pages are read again.
        for page in (sample.build / "docs-src").rglob("*.*"):
            page.touch()
        sample.make()
    assert size() < 1.5 * first


def test_a_struct_that_is_gone_from_a_header_is_gone_from_its_page(sample: Sample) -> None:
    struct = "\n/// Three of them.\nstruct Gone {\n  int a;  ///< a number\n};\n"
    end = "\n}  // namespace contact"
    header = "chapters/00_numbers/contact/number.hpp"
    sample.edit(header, end, struct + end)
    first = sample.make()
    assert first.returncode == 0, first.stderr
    assert "Gone" in sample.page("api/00_numbers.html")
    sample.edit(header, struct, "")
    again = sample.make()
    assert again.returncode == 0, again.stderr
    assert "Gone" not in sample.page("api/00_numbers.html")
