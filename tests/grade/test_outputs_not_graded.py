"""What could not be graded is a zero in no format, and its student reads that it is not theirs."""

from __future__ import annotations

import csv
import io
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from bs4 import BeautifulSoup
from lxml import etree

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "grading")]

import outputs_class as made  # noqa: E402
from reports.__main__ import main  # noqa: E402

Json = dict[str, Any]

WHY = "signal 9 ended the worker"
NAMING = "cannot read /marks/.grade/submissions/zq-naming/02_triangles/ray_triangle.cpp"
AGAIN = "./contact grade 'hand ins' -o marks"
# A word of what each student must read, wherever there is a word.
OURS = "not your fault"


def class_document() -> Json:
    """Some with one exercise of three that could not be graded, one with none that could be."""
    listed = made.exercises()
    answers = made.verdicts()

    def solved(place: int) -> Json:
        return made.unit(listed[place]["id"], answers[listed[place]["id"]]["solution"])

    def failed(place: int) -> Json:
        kinds = answers[listed[place]["id"]]
        wrong = next(kind for kind in kinds if kind.startswith("wrong"))
        return made.unit(listed[place]["id"], kinds[wrong])

    return made.document(
        listed,
        [
            made.submission("zq-whole", [solved(0), failed(1), solved(2)]),
            made.submission("zq-part", [solved(0), failed(1), made.not_graded(listed[2], WHY)]),
            made.submission(
                "zq-naming", [solved(0), solved(1), made.not_graded(listed[2], NAMING)]
            ),
            made.submission("zq-none", [made.not_graded(one, WHY) for one in listed]),
        ],
    )


@pytest.fixture(scope="module")
def document() -> Json:
    return class_document()


@pytest.fixture(scope="module")
def graded(document: Json, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("not_graded")
    (folder / "results.json").write_text(json.dumps(document))
    # Of an earlier run, in which it had a mark.
    old = folder / "students" / "zq-part" / "classroom50.json"
    old.parent.mkdir(parents=True)
    old.write_text("{}")
    assert main([str(folder), f"--again={AGAIN}"]) == 0
    return folder


STUDENTS = ("zq-part", "zq-naming", "zq-none")


def of(graded: Path, student: str, name: str) -> str:
    return (graded / "students" / student / name).read_text()


def test_the_gradebook_has_an_empty_cell_and_an_empty_total(graded: Path, document: Json) -> None:
    raw = (graded / "gradebook.csv").read_bytes().decode()
    rows = {row["id"]: row for row in csv.DictReader(io.StringIO(raw, newline=""))}
    ids = [one["id"] for one in document["exercises"]]
    by_id = {one["id"]: one for one in document["submissions"]}
    assert float(rows["zq-whole"]["total"]) == by_id["zq-whole"]["points"]
    assert [rows["zq-none"][id_] for id_ in ids] == ["", "", ""]
    for student in STUDENTS:
        assert rows[student]["total"] == ""
        assert rows[student][ids[2]] == ""
        assert f"{ids[2]} could not be graded and has no mark: " in rows[student]["remarks"]
    assert float(rows["zq-part"][ids[0]]) == by_id["zq-part"]["exercises"][0]["points"]
    assert WHY in rows["zq-part"]["remarks"]
    assert NAMING in rows["zq-naming"]["remarks"]


@pytest.mark.parametrize("student", STUDENTS)
def test_no_system_finds_a_score(graded: Path, student: str) -> None:
    for name in ("gradescope", "prairielearn"):
        text = of(graded, student, f"{name}.json")
        given = json.loads(text)
        jsonschema.validate(given, json.loads((HERE / "schemas" / f"{name}.json").read_text()))
        assert "score" not in given
        assert OURS in text
    gradescope = json.loads(of(graded, student, "gradescope.json"))
    assert not [test for test in gradescope["tests"] if {"score", "max_score"} & set(test)]
    prairielearn = json.loads(of(graded, student, "prairielearn.json"))
    assert prairielearn["gradable"] is False
    assert OURS in prairielearn["format_errors"][0]
    assert "costs you no attempt" in prairielearn["message"]
    assert " points." not in prairielearn["message"]
    assert not (graded / "students" / student / "classroom50.json").exists()


def test_who_has_marks_for_all_is_told_them(graded: Path, document: Json) -> None:
    points = document["submissions"][0]["points"]
    assert json.loads(of(graded, "zq-whole", "gradescope.json"))["score"] == points
    assert json.loads(of(graded, "zq-whole", "prairielearn.json"))["gradable"] is True
    assert json.loads(of(graded, "zq-whole", "classroom50.json"))["score"] == points
    for name in ("gradescope.json", "prairielearn.json", "junit.xml", "report.html"):
        assert OURS not in of(graded, "zq-whole", name)


@pytest.mark.parametrize("student", STUDENTS)
def test_junit_has_an_error_and_no_points(graded: Path, student: str, document: Json) -> None:
    xsd = etree.XMLSchema(etree.parse(str(HERE / "schemas" / "junit-10.xsd")))
    tree = etree.parse(str(graded / "students" / student / "junit.xml"))
    xsd.assertValid(tree)
    suites = {suite.get("name"): suite for suite in tree.getroot().iter("testsuite")}
    suite = suites[document["exercises"][2]["id"]]
    (case,) = suite.findall("testcase")
    (error,) = case
    assert (error.tag, error.get("type")) == ("error", "not_graded")
    assert OURS in str(error.get("message"))
    assert [suite.get(key) for key in ("tests", "errors", "failures", "skipped")] == [*"1100"]
    names = {one.get("name") for one in suite.iter("property")}
    assert "points" not in names
    if student != "zq-none":
        other = suites[document["exercises"][0]["id"]]
        assert "points" in {one.get("name") for one in other.iter("property")}


def test_a_student_reads_whom_to_ask_and_no_points(graded: Path, document: Json) -> None:
    title = document["exercises"][2]["title"]
    page = BeautifulSoup(of(graded, "zq-part", "report.html"), "html.parser")
    said = page.get_text(" ", strip=True)
    assert f"“{title}” could not be graded" in said
    assert "ask your instructor" in said
    units = document["submissions"][1]["exercises"]
    told = sum(unit["points"] for unit in units[:2])
    most = sum(unit["max_points"] for unit in units[:2])
    mark = page.select_one("p.mark")
    assert mark is not None
    assert mark.get_text().startswith(f"{told:g} of {most:g} points without what could not")
    article = page.select("article")[2]
    assert f"no mark of {units[2]['max_points']:g} points" in article.get_text()
    assert "0 of" not in article.get_text()
    steps = " ".join(step.get_text() for step in page.select(".next li"))
    assert title not in steps, "nothing of it is theirs to do"

    said = BeautifulSoup(of(graded, "zq-naming", "report.html"), "html.parser").get_text()
    assert "Nothing is left to do" not in said
    assert "not every hidden one" not in said
    none = BeautifulSoup(of(graded, "zq-none", "report.html"), "html.parser").select_one("p.mark")
    assert none is not None
    assert none.get_text() == "No mark yet"


def test_why_is_for_the_instructor(graded: Path) -> None:
    for student in STUDENTS:
        for file in (graded / "students" / student).iterdir():
            assert "signal 9" not in file.read_text(), file
            assert "/marks/.grade" not in file.read_text(), file


def test_the_class_page_begins_with_it_and_counts_it_nowhere(
    graded: Path, document: Json, tmp_path: Path
) -> None:
    page = BeautifulSoup((graded / "class.html").read_text(), "html.parser")
    first = page.find("h2")
    assert first is not None
    assert first.get_text() == "Could not be graded"
    section = first.find_parent("section")
    assert section is not None
    said = " ".join(section.get_text(" ").split())
    title = document["exercises"][2]["title"]
    assert f"{title}: 3 submissions 2: {WHY}" in said
    assert "1: results.json and gradebook.csv say why" in said, "where the reason names a student"
    assert section.pre is not None
    assert section.pre.get_text() == AGAIN
    assert "zq-" not in (graded / "class.html").read_text()

    # The rest of the page is that of a class whose other exercises are these.
    def numbers(page: BeautifulSoup) -> list[str]:
        for part in page.select("section[aria-labelledby=not-graded]"):
            part.decompose()
        return [
            " ".join(row.get_text(" ").split())
            for row in page.select("section.exercise, .brief .row, .histogram, ol.troubles")
        ]

    known = json.loads(json.dumps(document))
    for one in known["submissions"]:
        one["exercises"] = [unit for unit in one["exercises"] if unit["status"] == "graded"]
    # The chart of marks includes only students with a complete mark.
    (tmp_path / "results.json").write_text(json.dumps(known))
    assert main([str(tmp_path), "--formats", "class"]) == 0
    other = BeautifulSoup((tmp_path / "class.html").read_text(), "html.parser")
    assert numbers(page) == numbers(other)
    assert "Median mark" in page.get_text()


def test_an_exercise_of_which_nothing_is_known_has_no_mean(tmp_path: Path) -> None:
    listed = made.exercises()[:1]
    one = made.submission("zq-none", [made.not_graded(listed[0], WHY)])
    (tmp_path / "results.json").write_text(json.dumps(made.document(listed, [one])))
    assert main([str(tmp_path)]) == 0
    page = BeautifulSoup((tmp_path / "class.html").read_text(), "html.parser")
    (mean,) = page.select("section.exercise .mean")
    assert mean.get_text() == "not graded"
    assert "0 %" not in " ".join(row.get_text() for row in page.select(".brief .count"))


def test_the_pages_are_accessible(graded: Path) -> None:
    files = [graded / "class.html"]
    files += [graded / "students" / student / "report.html" for student in STUDENTS]
    done = subprocess.run(
        ["node", str(HERE / "outputs_pages.mjs"), *map(str, files)],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    if done.stdout.strip() == "no browser":
        pytest.skip("no Chromium found (set CHROMIUM to one)")
    assert json.loads(done.stdout) == {str(file): [] for file in files}


@pytest.mark.parametrize("points", [0.0, 3.0])
def test_a_number_of_points_for_it_is_refused(
    tmp_path: Path, document: Json, capsys: pytest.CaptureFixture[str], points: float
) -> None:
    whole = json.loads(json.dumps(document))
    whole["submissions"][1]["exercises"][2]["points"] = points
    (tmp_path / "results.json").write_text(json.dumps(whole))
    assert main([str(tmp_path)]) == 3
    assert "submissions/1/exercises/2/points" in capsys.readouterr().err
