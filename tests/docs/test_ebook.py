"""The EPUB file of the sample, and of the book if it is built: whole, and XHTML to the letter."""

from __future__ import annotations

import posixpath
import shutil
import subprocess
import zipfile
from collections import Counter
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest
from lxml import etree
from sample_book import ROOT, Sample

XHTML = "{http://www.w3.org/1999/xhtml}"
OPF = "{http://www.idpf.org/2007/opf}"
BLOCKS = ("p", "div", "ul", "ol", "dl", "pre", "table", "section", "figure")


@dataclass
class EBook:
    path: Path

    @cached_property
    def files(self) -> dict[str, bytes]:
        with zipfile.ZipFile(self.path) as archive:
            return {name: archive.read(name) for name in archive.namelist()}

    @cached_property
    def manifest(self) -> dict[str, etree._Element]:
        listing = etree.fromstring(self.files["content.opf"])
        return {unquote(str(item.get("href"))): item for item in listing.iter(f"{OPF}item")}

    @cached_property
    def pages(self) -> dict[str, etree._Element]:
        """Parsed as XML: what is not well-formed is no page."""
        return {
            name: etree.fromstring(self.files[name], etree.XMLParser(resolve_entities=False))
            for name in self.manifest
            if name.endswith(".xhtml")
        }


@pytest.fixture(scope="module")
def of_sample(tmp_path_factory: pytest.TempPathFactory) -> EBook:
    sample = Sample(tmp_path_factory.mktemp("ebook"))
    made = sample.make("--complete", "--builder", "epub")
    assert made.returncode == 0, made.stdout + made.stderr
    return EBook(sample.site / "contact-hours.epub")


@pytest.fixture(params=["sample", "book"])
def ebook(request: pytest.FixtureRequest, of_sample: EBook) -> EBook:
    if request.param == "sample":
        return of_sample
    path = ROOT / "build" / "site" / "contact-hours.epub"
    if not path.is_file():
        pytest.skip("the e-book is not built: cmake --build build/dev --target docs")
    return EBook(path)


def test_the_archive_says_first_what_it_is(ebook: EBook) -> None:
    with zipfile.ZipFile(ebook.path) as archive:
        first = archive.infolist()[0]
        assert (first.filename, first.compress_type) == ("mimetype", zipfile.ZIP_STORED)
        assert archive.read("mimetype") == b"application/epub+zip"
        assert archive.testzip() is None


def test_the_manifest_names_every_file_and_nothing_else(ebook: EBook) -> None:
    around = {"mimetype", "META-INF/container.xml", "content.opf"}
    assert set(ebook.manifest) == set(ebook.files) - around
    for name, page in ebook.pages.items():
        said = set(str(ebook.manifest[name].get("properties", "")).split()) - {"nav"}
        there = {
            kind
            for kind, space in (
                ("svg", "http://www.w3.org/2000/svg"),
                ("mathml", "http://www.w3.org/1998/Math/MathML"),
            )
            if page.find(f".//{{{space}}}*") is not None
        }
        assert said == there, name


def test_every_link_and_every_picture_is_there(ebook: EBook) -> None:
    names = {
        name: {str(node.get("id")) for node in page.iter() if node.get("id")}
        for name, page in ebook.pages.items()
    }
    seen = Counter[str]()
    for page_name, page in ebook.pages.items():
        for node in page.iter(f"{XHTML}a", f"{XHTML}img", f"{XHTML}link"):
            address = node.get("href") or node.get("src")
            target = urlsplit(str(address))
            if address is None or target.scheme in ("https", "http", "mailto"):
                continue
            folder = posixpath.dirname(page_name)
            file = posixpath.normpath(posixpath.join(folder, unquote(target.path)))
            file = file if target.path else page_name
            assert file in ebook.manifest, f"{page_name}: {address}"
            if target.fragment:
                assert target.fragment in names[file], f"{page_name}: {address}"
            seen[etree.QName(node).localname] += 1
        for picture in page.iter(f"{XHTML}img"):
            assert str(picture.get("alt", "")).strip(), page_name
    assert seen["a"] > 0
    assert seen["img"] > 0


def test_every_page_is_xhtml_without_script_or_control(ebook: EBook) -> None:
    for name, page in ebook.pages.items():
        twice = Counter(node.get("id") for node in page.iter() if node.get("id"))
        assert [text for text, count in twice.items() if count > 1] == [], name
        for tag in ("script", "button", "input", "select", "textarea", "iframe", "form"):
            assert page.find(f".//{XHTML}{tag}") is None, f"{name}: {tag}"
        for node in page.iter():
            if isinstance(node.tag, str):
                assert not etree.QName(node).localname.startswith("contact-"), name
        for tag in BLOCKS:
            assert page.find(f".//{XHTML}p//{XHTML}{tag}") is None, f"{name}: {tag} in p"


def test_the_contents_lead_to_every_lesson(ebook: EBook) -> None:
    linked = {
        str(link.get("href")).partition("#")[0]
        for link in ebook.pages["nav.xhtml"].iter(f"{XHTML}a")
    }
    lessons = {name for name in ebook.pages if name.startswith("chapters/")}
    assert lessons
    assert lessons <= linked


def test_what_moves_in_the_page_is_a_picture_code_or_text(of_sample: EBook) -> None:
    page = of_sample.files["chapters/01_lines.xhtml"].decode()
    words = "".join(map(str, of_sample.pages["chapters/01_lines.xhtml"].itertext()))
    assert "_static/contact/figures/01_lines/point_line.svg" in of_sample.manifest
    for there in ("Drag the point.", "double distance(", "12 of 1,000", "Divide by the length"):
        assert there in words, there
    assert "point_line.svg" in page
    assert "<svg" in page
    assert "var(--" not in page
    assert "katex" not in page
    assert "<math" in page


def test_epubcheck_has_nothing_to_say(of_sample: EBook) -> None:
    """If Debian's epubcheck is installed; otherwise the tests above replace it."""
    book = ROOT / "build" / "site" / "contact-hours.epub"
    ebook = EBook(book) if book.is_file() else of_sample
    program = shutil.which("epubcheck")
    java = shutil.which("java")
    if program is None or java is None:
        return
    done = subprocess.run(
        [java, "-jar", program, str(ebook.path)], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
