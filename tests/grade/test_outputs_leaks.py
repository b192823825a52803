"""A real grading of submissions that tell all they are asked: what private tests ask comes out in
no file but the instructor's own."""

from __future__ import annotations

import copy
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(ROOT / "grading")]

from reports.__main__ import main  # noqa: E402

PROGRAM = ROOT / "build" / "dev" / "bin" / "contact"
PRIVATE = HERE / "private"
EXERCISE = "02_triangles/ray_triangle"

Json = dict[str, Any]

HEAD = """\
#include "ray_triangle.hpp"
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace exercise {
std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  std::ostringstream all;
  all.precision(17);
  all << "ARGUMENTS " << ray.origin.transpose() << " | " << triangle.c.transpose();
"""
TELLERS = {
    "prints": "std::cout << all.str() << std::endl; std::cerr << all.str(); return std::nullopt;",
    "throws": "throw std::runtime_error(all.str());",
    "refuses": "throw std::invalid_argument(all.str());",
    "echoes": "return contact::TriangleHit<double>{ray.origin.x(), triangle.c};",
}


@pytest.fixture(scope="module")
def graded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("leaks")
    for name, body in TELLERS.items():
        file = folder / "submissions" / name / "ray_triangle.cpp"
        file.parent.mkdir(parents=True)
        file.write_text(f"{HEAD}  {body}\n}}\n}}  // namespace exercise\n")
    results = folder / "results"
    words = ["--exercises", EXERCISE, "--private", str(PRIVATE), "--seed", "leaks"]
    due = ["--due", "2999-01-01T00:00+00:00"]
    done = subprocess.run(
        [str(PROGRAM), "grade", str(folder / "submissions"), "-o", str(results), *words, *due],
        env={**os.environ, "CONTACT_ROOT": str(ROOT)},
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return results


def kept_back(document: Json, name: str) -> list[str]:
    """Every text of this student's verdict that belongs to a test which is not shown now."""
    private = {
        test["name"]
        for test in document["exercises"][0]["tests"]
        if test["visibility"] in ("hidden", "after_due")
    }
    assert len(private) == 2
    one = next(one for one in document["submissions"] if one["id"] == name)
    texts: list[str] = []
    for test in one["exercises"][0]["verdict"]["tests"]:
        failure = test.get("failure", {})
        if test["name"] in private:
            texts += [value["text"] for value in failure.get("inputs", [])]
            texts += [failure[part] for part in ("got", "right", "reason") if part in failure]
    return [text for text in texts if any(letter.isdigit() for letter in text)]


@pytest.mark.parametrize("name", TELLERS)
def test_what_a_private_test_asked_reaches_no_student(graded: Path, name: str) -> None:
    document = json.loads((graded / "results.json").read_text())
    secrets = kept_back(document, name)
    assert secrets, "the instructor's own file holds it, so there is something to look for"
    for file in [*graded.glob("students/*/*"), graded / "class.html", graded / "gradebook.csv"]:
        if file.name == "gradescope.json":
            continue
        text = file.read_text()
        for secret in secrets:
            assert secret not in text, file
        assert "rays from far away" not in text, file
    # Gradescope is given what it shall show after the due date, marked so; never what is hidden.
    given = json.loads((graded / "students" / name / "gradescope.json").read_text())
    now = {**given, "tests": [one for one in given["tests"] if one["visibility"] == "visible"]}
    for secret in secrets:
        assert secret not in json.dumps(now, ensure_ascii=False)
    assert "rays from far away" not in json.dumps(given)


def test_what_the_program_printed_is_kept_with_the_values(graded: Path) -> None:
    document = json.loads((graded / "results.json").read_text())
    one = next(one for one in document["submissions"] if one["id"] == "prints")
    assert "ARGUMENTS " in one["exercises"][0]["verdict"]["output"]
    for file in graded.glob("students/prints/*"):
        assert "ARGUMENTS " not in file.read_text(), file
    page = (graded / "students/prints/report.html").read_text()
    assert "What your program printed is not shown" in page


def test_public_tests_tell_the_same_student_everything(graded: Path) -> None:
    page = (graded / "students/throws/report.html").read_text()
    assert "ARGUMENTS " in page, "an exception in a test that is shown is shown"


def slept(document: Json, *parts: str) -> Json:
    """The same grading, in which these parts took 7 s more."""
    longer = copy.deepcopy(document)
    for one in longer["submissions"]:
        for unit in one["exercises"]:
            times = unit["verdict"]["times"]
            for part in parts:
                times[part] += 7.0
            times["tests"] = [seconds + 7.0 for seconds in times["tests"]]
    return longer


def made_for_students(folder: Path, document: Json) -> dict[str, bytes]:
    """What may be passed on of this grading, by file."""
    folder.mkdir()
    (folder / "results.json").write_text(json.dumps(document))
    now = ["--due", "2999-01-01T00:00+00:00", "--now", "2026-06-01T00:00+00:00"]
    assert main([str(folder), *now]) == 0
    files = {file for file in folder.rglob("*") if file.is_file()}
    files.remove(folder / "results.json")
    return {str(file.relative_to(folder)): file.read_bytes() for file in files}


def with_visibility(document: Json, kind: str) -> Json:
    """The same grading, in which every test but the first is shown so."""
    other = copy.deepcopy(document)
    for test in other["exercises"][0]["tests"][1:]:
        test["visibility"] = kind
    return other


@pytest.mark.parametrize("kind", ["hidden", "values_withheld", "after_due"])
def test_how_long_kept_back_tests_ran_is_in_no_file(
    graded: Path, tmp_path: Path, kind: str
) -> None:
    document = with_visibility(json.loads((graded / "results.json").read_text()), kind)
    before = made_for_students(tmp_path / "before", document)
    assert len(before) > len(TELLERS)
    assert made_for_students(tmp_path / "after", slept(document, "run")) == before
    built = made_for_students(tmp_path / "built", slept(document, "compile"))
    told = {Path(name).name for name, text in built.items() if text != before[name]}
    assert told == {"gradescope.json", "junit.xml"}, "the compiler has seen no input"


def test_where_all_is_shown_the_time_is_too(graded: Path, tmp_path: Path) -> None:
    document = with_visibility(json.loads((graded / "results.json").read_text()), "shown")
    before = made_for_students(tmp_path / "before", document)
    after = made_for_students(tmp_path / "after", slept(document, "run"))
    told = {Path(name).name for name, text in after.items() if text != before[name]}
    assert told == {"gradescope.json", "junit.xml"}
