"""Names, output, code and messages that attack the reader of a report: each format makes them
harmless."""

from __future__ import annotations

import csv
import io
import json
import sys
import unicodedata
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest
from lxml import etree

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "grading")]

import outputs_class as made  # noqa: E402
from reports.__main__ import main  # noqa: E402
from reports.folders import folder_name  # noqa: E402
from reports.gradebook import defused  # noqa: E402
from reports.text import MAX_CHARACTERS, clean, clean_line, visible  # noqa: E402

Json = dict[str, Any]

EXERCISE = "02_triangles/ray_triangle"
ATTACKS = {
    "markup": "</pre></code></script><script>alert(1)</script><img src=x onerror=alert(2)>",
    "attribute": "\"' onmouseover='alert(1)' x=\"",
    "template": "{{ 7*7 }}{% for x in y %}${1+1}",
    "terminal": "\x1b[2J\x1b]0;title\x07\x1b[31mred",
    "bidi": "admin\u202e\u2066nimda\u2069\u200f\u061c",
    "zero": "a\x00b\x01\x08\x7f\x85\x9b",
    "surrogate": "half \ud800 and \udfff end",
    "not-characters": "\ufffe\uffff\U0001ffff",
    "separators": "one\u2028two\u2029three\x0b\x0c",
    "invisible": "a\u200b\u200c\u2060\ufeff\u00ad\u3164b\U000e0041",
    "cdata": "]]> <![CDATA[ &xxe; <!ENTITY x SYSTEM 'file:///etc/passwd'>",
    "marks": "z" + "\u0301" * 500,
    "formula": "=cmd|' /C calc'!A0,\"\n@SUM(1+1)",
    "carriage": "first\r=1+1\rsecond\r\nthird",
    "markdown": "[x](javascript:alert(1)) **b** `c` <b>",
}
LONG_LINE = "L" * 1_000_000
DANGEROUS = {"Cc", "Cf", "Cs", "Cn", "Zl", "Zp"}


def document(text: str) -> Json:
    """A submission in which every text that comes from its author is `text`."""
    listed = {
        "id": EXERCISE,
        "title": "A ray and a triangle",
        "max_points": 3.0,
        "objective": "ray-triangle",
        "tests": [
            {"name": n, "points": 1.0, "visibility": "shown"} for n in ("one", "two", "three")
        ],
    }
    failure = {
        "asked": "?",
        "inputs": [{"name": "ray", "text": text}],
        "got": text,
        "right": "right",
        "reason": f"threw an exception: {text}",
    }
    tests = [
        {"name": name, "status": status, "points": 0.0, "max_points": 1.0, "failure": failure}
        for name, status in (("one", "failed"), ("two", "stopped"), ("three", "skipped"))
    ]
    verdict = {
        "exercise": EXERCISE,
        "verdict": "failed",
        "points": 0.0,
        "max_points": 3.0,
        "tests": tests,
        "warnings": [text],
        "output": text,
        "diagnostics": [
            {"line": 1, "column": 1, "severity": "warning", "message": text, "words": text}
        ],
    }
    broken = {
        **verdict,
        "verdict": "does_not_compile",
        "tests": [{k: v for k, v in test.items() if k != "failure"} for test in tests],
        "diagnostics": [
            {
                "line": 1,
                "column": 1,
                "severity": "error",
                "message": text,
                "words": text,
                "mistake": text,
            }
        ],
        "compile_error": {
            "line": 1,
            "column": 1,
            "message": text,
            "excerpt": text,
            "explanation": text,
            "contract": [{"file": "a.hpp", "line": 1, "text": text}],
            "full": text,
        },
    }
    return made.document(
        [listed],
        [
            made.submission("fails", [made.unit(EXERCISE, verdict)], name=text, ignored=[text]),
            made.submission("broken", [made.unit(EXERCISE, broken)], name=text),
            made.submission("refused", [made.absent(listed, "refused", text)], problem=text),
        ],
    )


@pytest.fixture(params=[*ATTACKS, "long"])
def attacked(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    """RESULTS of a class that attacks, with every report."""
    text = ATTACKS.get(request.param, LONG_LINE)
    (tmp_path / "results.json").write_text(json.dumps(document(text)))
    assert main([str(tmp_path)]) == 0
    return tmp_path


def written(folder: Path, pattern: str) -> list[Path]:
    found = [file for file in folder.glob(pattern) if file.name != "results.json"]
    assert found
    return found


class Tags(HTMLParser):
    """What a browser would take for tags, attributes and text."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.tags: set[str] = set()
        self.attributes: set[str] = set()
        self.links: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)
        self.attributes |= {name for name, _ in attrs}
        self.links += [value or "" for name, value in attrs if name in ("href", "src")]


TAGS = """
html head meta title style body main section article header footer h1 h2 h3 p a b i ul ol li dl dt
dd div span strong small code pre table caption thead tbody tr th td details summary svg rect text
line
"""
ATTRIBUTES = """
lang charset name content http-equiv class id style href scope aria-hidden aria-labelledby viewbox
x y x1 x2 y1 y2 width height
"""


def test_pages_hold_no_tag_and_no_attribute_but_the_templates_own(attacked: Path) -> None:
    for file in written(attacked, "**/*.html"):
        page = Tags()
        page.feed(file.read_text())
        page.close()
        assert page.tags <= set(TAGS.split()), file
        assert page.attributes <= set(ATTRIBUTES.split()), file
        assert all(link.startswith("#") for link in page.links), "nothing is fetched"


def test_nothing_that_cannot_be_seen_gets_into_any_file(attacked: Path) -> None:
    for file in written(attacked, "**/*.*"):
        if file.is_dir():
            continue
        text = file.read_bytes().decode("utf-8")
        for character in set(text) - {"\n", "\t", "\r"}:
            assert unicodedata.category(character) not in DANGEROUS, (file, hex(ord(character)))
        assert "\r" not in text or file.suffix == ".csv", file
        if file.suffix == ".json":
            for line in strings(json.loads(text)):
                hidden = [
                    c for c in line if unicodedata.category(c) in DANGEROUS and c not in "\n\t"
                ]
                assert not hidden, file


def strings(value: object) -> list[str]:
    if isinstance(value, str):
        return [value]
    if isinstance(value, dict):
        return [one for key, inner in value.items() for one in [key, *strings(inner)]]
    if isinstance(value, list):
        return [one for inner in value for one in strings(inner)]
    return []


def test_no_file_grows_without_end(attacked: Path) -> None:
    for file in written(attacked, "**/*.*"):
        if file.is_file():
            assert file.stat().st_size < 1_000_000, file
            for line in file.read_text().splitlines():
                assert len(line) < 60_000, file


def test_xml_is_well_formed_and_valid(attacked: Path) -> None:
    xsd = etree.XMLSchema(etree.parse(str(HERE / "schemas" / "junit-10.xsd")))
    parser = etree.XMLParser(resolve_entities=False, huge_tree=False)
    for file in written(attacked, "**/junit.xml"):
        xsd.assertValid(etree.parse(str(file), parser))


def test_no_cell_is_a_formula_to_any_spreadsheet(attacked: Path) -> None:
    text = (attacked / "gradebook.csv").read_bytes().decode("utf-8")
    for delimiter in (",", ";", "\t"):
        for row in csv.reader(io.StringIO(text, newline=""), delimiter=delimiter):
            for cell in row:
                assert not cell.lstrip().startswith(tuple("=+-@\t\r＝＋－＠")), (delimiter, cell)
    rows = list(csv.reader(io.StringIO(text, newline="")))
    assert len({len(row) for row in rows}) == 1
    assert len(rows) == 4


@pytest.mark.parametrize(
    ("cell", "safe"),
    [
        ("=1+1", "'=1+1"),
        ("  =1+1", "'  =1+1"),
        ("+49 30 1234", "'+49 30 1234"),
        ("-2", "'-2"),
        ("@SUM(A1)", "'@SUM(A1)"),
        ("＝1", "'＝1"),
        ("a;=1+1", "a;'=1+1"),
        ('a","=1', 'a","\'=1'),
        ("line\n=1", "line =1"),
        ("Ada Lovelace", "Ada Lovelace"),
        ("O'Neil-Smith, A.", "O'Neil-Smith, A."),
        ("x@example.org", "x@example.org"),
    ],
)
def test_a_formula_is_defused_and_a_name_stays(cell: str, safe: str) -> None:
    assert defused(cell) == safe


def test_the_class_page_holds_nothing_of_it(tmp_path: Path) -> None:
    (tmp_path / "results.json").write_text(json.dumps(document("Qwertzuiop=1<b>")))
    assert main([str(tmp_path), "--formats", "class"]) == 0
    assert "Qwertzuiop" not in (tmp_path / "class.html").read_text()


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("plain text", "plain text"),
        ("Grüße, Łódź, 東京, مرحبا, 🙂", "Grüße, Łódź, 東京, مرحبا, 🙂"),
        ("a\x1b[31mb", "a␛[31mb"),
        ("a\x00b", "a␀b"),
        ("a\rb\r\nc", "a␍b\nc"),
        ("a\u202eb", "a⟨U+202E⟩b"),
        ("a\ud800b", "a⟨U+D800⟩b"),
        ("\U000e0041", "⟨U+E0041⟩"),
        ("z" + "\u0301" * 500 + "a", "z" + "\u0301" * 4 + "a"),
    ],
)
def test_what_cannot_be_seen_is_made_visible(text: str, shown: str) -> None:
    assert visible(text) == shown


def test_what_is_too_long_is_cut_and_says_so() -> None:
    assert clean("x" * 100) == "x" * 100
    shown = clean(LONG_LINE)
    assert len(shown) < MAX_CHARACTERS
    assert "[…]" in shown
    assert "1000000 characters in all" in shown
    lines = clean("line\n" * 5000)
    assert lines.count("\n") <= 401
    assert "25000 characters in all" in lines
    assert clean_line("a\nb\tc") == "a␊b c"
    assert len(clean_line("x" * 1000)) == 201


@pytest.mark.parametrize(
    "id_", ["../../etc", "/etc/passwd", ".", "..", ".git", "a/b", "a\\b", "ü" * 200]
)
def test_an_id_is_one_folder_in_students(id_: str) -> None:
    name = folder_name(id_)
    assert "/" not in name
    assert "\\" not in name
    assert not name.startswith(".")
    assert 0 < len(name) < 128


def test_ids_that_can_be_folders_stay() -> None:
    for id_ in ("ada", "12345", "a.b@example.org", "x_y-z", "m~C3~BCller"):
        assert folder_name(id_) == id_
    assert folder_name("a/b") != folder_name("a%2Fb")
