"""What a release attaches, and when there is none."""

from __future__ import annotations

import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from release import ReleaseError, make, version_of  # noqa: E402

CHANGELOG = """# Changelog

## [Unreleased]

### Added

- What comes next.

## [1.2.3] - 2026-12-01

### Added

- What came.

## [1.2.2] - 2026-11-01

- What was before.
"""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(ContactHours VERSION 1.2.3 LANGUAGES CXX)\n"
    )
    (tmp_path / "CHANGELOG.md").write_text(CHANGELOG)
    for name, text in {
        "index.html": "home",
        "searchindex.js": "{}",
        "contact-hours.epub": "book",
        "chapters/01_planes.html": "planes",
    }.items():
        file = tmp_path / "build" / "site" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return tmp_path


def test_this_project_has_a_version() -> None:
    assert version_of(ROOT).count(".") == 2


def test_the_zip_has_every_file_of_the_book_in_one_folder(project: Path) -> None:
    with zipfile.ZipFile(make(project, "v1.2.3").book) as made:
        assert made.read("contact-hours-1.2.3/book/chapters/01_planes.html") == b"planes"
        names = made.namelist()
        modes = {entry.external_attr >> 16 for entry in made.infolist()}
        readme = made.read("contact-hours-1.2.3/README.txt").decode()
    assert len(names) == 5
    assert modes == {0o644}
    assert all(name.startswith("contact-hours-1.2.3/") for name in names)
    assert "--directory book" in readme


def test_the_same_book_gives_the_same_bytes(project: Path) -> None:
    first = make(project, "v1.2.3").book.read_bytes()
    page = project / "build" / "site" / "index.html"
    page.write_text(page.read_text())
    assert make(project, "v1.2.3").book.read_bytes() == first


def test_the_ebook_is_named_after_the_version(project: Path) -> None:
    made = make(project, "v1.2.3").ebook
    assert (made.name, made.read_text()) == ("contact-hours-1.2.3.epub", "book")


def test_the_notes_are_what_the_changelog_says_of_the_version(project: Path) -> None:
    assert make(project, "v1.2.3").notes.read_text() == "### Added\n\n- What came.\n"


@pytest.mark.parametrize("tag", ["1.2.3", "v1.2.4", "v1.2.3-rc1", ""])
def test_a_tag_that_is_not_the_version_is_refused(project: Path, tag: str) -> None:
    with pytest.raises(ReleaseError, match=r"version in CMakeLists.txt is 1\.2\.3"):
        make(project, tag)


def test_a_version_without_notes_is_refused(project: Path) -> None:
    (project / "CHANGELOG.md").write_text(CHANGELOG.replace("[1.2.3]", "[1.2.30]"))
    with pytest.raises(ReleaseError, match=r"says nothing of 1\.2\.3"):
        make(project, "v1.2.3")


@pytest.mark.parametrize("name", ["index.html", "searchindex.js", "contact-hours.epub"])
def test_a_book_that_is_not_whole_is_refused(project: Path, name: str) -> None:
    (project / "build" / "site" / name).unlink()
    with pytest.raises(ReleaseError, match=f"build/site/{name} is not there"):
        make(project, "v1.2.3")
    assert not (project / "build" / "published").exists()
