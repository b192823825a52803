"""What a test keeps to itself occurs in no file that a student could get: all are searched."""

from __future__ import annotations

import itertools
import json
import sys
from pathlib import Path
from typing import Any

import pytest

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "grading")]

import outputs_class as made  # noqa: E402
from reports.__main__ import main  # noqa: E402

Json = dict[str, Any]

EXERCISE = "02_triangles/ray_triangle"
BEFORE = ["--due", "2026-06-02T00:00+00:00", "--now", "2026-06-01T23:59+00:00"]
AFTER = ["--due", "2026-06-02T00:00+00:00", "--now", "2026-06-02T00:00+00:00"]

# Each part of a failure is a word of its own, so that it can be found wherever it comes out.
PARTS = ("asked", "input", "got", "right", "allowed", "reason", "hint")


def word(test: str, part: str) -> str:
    return f"{test}-{part}-word"


def failing(test: str, status: str) -> Json:
    return {
        "name": f"the test {test}",
        "status": status,
        "points": 0.0,
        "max_points": 2.0,
        "seconds": 0.001,
        "failure": {
            "asked": word(test, "asked"),
            "inputs": [{"name": "ray", "text": word(test, "input")}],
            "got": word(test, "got"),
            "right": word(test, "right"),
            "allowed": word(test, "allowed"),
            "misconceptions": ["absolute-epsilon"],
            "hint": word(test, "hint"),
            "reason": f"threw an exception: {word(test, 'reason')}",
        },
    }


def results(status: str = "failed", **visibility: str) -> Json:
    """One submission that fails every test of one exercise; each test is named as its visibility
    is given here."""
    tests = [
        {
            "name": f"the test {name}",
            "points": 2.0,
            "visibility": kind,
            "private": kind in ("hidden", "after_due"),
        }
        for name, kind in visibility.items()
    ]
    listed = {
        "id": EXERCISE,
        "title": "A ray and a triangle",
        "objective": "ray-triangle",
        "max_points": 2.0 * len(tests) + 1,
        "tests": [{"name": "a passed one", "points": 1.0, "visibility": "shown"}, *tests],
    }
    passed = {"name": "a passed one", "status": "passed", "points": 1.0, "max_points": 1.0}
    verdict = {
        "exercise": EXERCISE,
        "verdict": "failed",
        "points": 1.0,
        "max_points": listed["max_points"],
        "tests": [passed, *(failing(name, status) for name in visibility)],
        "diagnostics": [],
        "warnings": [],
        "output": "printed-by-the-program",
    }
    one = made.submission("somebody", [made.unit(EXERCISE, verdict)])
    return made.document([listed], [one])


def write(folder: Path, document: Json, *words: str) -> dict[str, str]:
    """Every file that is made, by name."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "results.json").write_text(json.dumps(document))
    assert main([str(folder), *words]) == 0
    return {
        file.name: file.read_text()
        for file in folder.rglob("*")
        if file.is_file() and file.name != "results.json"
    }


STUDENTS_OWN = ("gradescope.json", "prairielearn.json", "classroom50.json", "junit.xml")


def test_a_shown_test_tells_everything(tmp_path: Path) -> None:
    files = write(tmp_path, results(open="shown"))
    for name in ("report.html", *STUDENTS_OWN):
        assert all(word("open", part) in files[name] for part in PARTS), name
        assert "the test open" in files[name]
        if name != "classroom50.json":
            assert "printed-by-the-program" in files[name], name


def same(document: Json, name: str, first: str) -> Json:
    """One test fails for the same cause as another."""
    for test in document["submissions"][0]["exercises"][0]["verdict"]["tests"]:
        if test["name"] == f"the test {name}":
            test["same_as"] = f"the test {first}"
    return document


def test_one_mistake_is_told_once(tmp_path: Path) -> None:
    document = same(results(open="shown", other="shown"), "other", "open")
    page = write(tmp_path, document)["report.html"]
    assert "The same mistake also fails: “the test other”." in page
    assert "The same mistake as in “the test open”" in page


@pytest.mark.parametrize(("first", "other"), [("secret", "open"), ("open", "secret")])
def test_no_mistake_is_told_by_the_name_of_a_hidden_test(
    tmp_path: Path, first: str, other: str
) -> None:
    document = same(results(open="shown", secret="hidden"), other, first)
    for text in write(tmp_path, document).values():
        assert "test secret" not in text
        assert "same mistake" not in text


@pytest.mark.parametrize("status", ["failed", "stopped"])
def test_withheld_values_are_in_no_file(tmp_path: Path, status: str) -> None:
    files = write(tmp_path, results(status, kept="values_withheld"))
    for name, text in files.items():
        # An exception's text may be the input; so may what came back and what was printed.
        for part in ("input", "got", "right", "allowed", "reason"):
            assert word("kept", part) not in text, (name, part)
        assert "printed-by-the-program" not in text, name
    for name in ("report.html", *STUDENTS_OWN):
        assert "the test kept" in files[name]
        assert word("kept", "asked") in files[name], name
        assert word("kept", "hint") in files[name], name
        # Why an answer is wrong may be told by its values; why a test was stopped is not.
        assert ("it threw an exception" in files[name]) == (status == "stopped"), name


@pytest.mark.parametrize("status", ["passed", "failed", "stopped", "skipped", "not_attempted"])
@pytest.mark.parametrize("words", [BEFORE, AFTER, []])
def test_of_a_hidden_test_there_is_nothing_but_its_points_in_sum(
    tmp_path: Path, status: str, words: list[str]
) -> None:
    files = write(tmp_path, results(status, secret="hidden", other="hidden"), *words)
    for name, text in files.items():
        for test in ("secret", "other"):
            assert f"test {test}" not in text, name
            assert not any(word(test, part) in text for part in PARTS), name
        assert "printed-by-the-program" not in text, name
    assert "0 of 4" in files["report.html"]
    given = json.loads(files["gradescope.json"])
    entry = next(test for test in given["tests"] if "hidden" in test["tags"])
    assert (entry["score"], entry["max_score"], entry["visibility"]) == (0, 4, "visible")
    assert "hidden tests" in files["prairielearn.json"]


def test_a_test_that_nobody_listed_is_hidden(tmp_path: Path) -> None:
    document = results(open="shown")
    document["submissions"][0]["exercises"][0]["verdict"]["tests"].append(
        failing("unlisted", "failed")
    )
    files = write(tmp_path, document)
    for name, text in files.items():
        assert "test unlisted" not in text, name
        assert not any(word("unlisted", part) in text for part in PARTS), name
        assert "printed-by-the-program" not in text, name
    given = json.loads(files["gradescope.json"])
    hidden = [test["max_score"] for test in given["tests"] if "hidden" in test["tags"]]
    assert hidden == [2], "its points count among the hidden ones"


def test_before_the_due_date_a_test_has_a_name_and_points_and_no_result(tmp_path: Path) -> None:
    files = write(tmp_path, results(later="after_due"), *BEFORE)
    for name, text in files.items():
        if name == "gradescope.json":
            continue  # Gradescope hides it itself.
        assert not any(word("later", part) in text for part in PARTS), name
        assert "printed-by-the-program" not in text, name
    for name in ("report.html", "prairielearn.json", "classroom50.json", "junit.xml"):
        assert "the test later" in files[name], name
    assert "1 of 1 points" in files["report.html"]
    assert "2 more are decided by tests that are shown after the due date" in files["report.html"]


def test_without_a_due_date_it_has_not_passed(tmp_path: Path) -> None:
    files = write(tmp_path, results(later="after_due"))
    assert word("later", "right") not in files["report.html"]


def test_once_the_due_date_has_come_all_is_told(tmp_path: Path) -> None:
    files = write(tmp_path, results(later="after_due"), *AFTER)
    for name in ("report.html", *STUDENTS_OWN):
        assert all(word("later", part) in files[name] for part in PARTS), name
    assert "printed-by-the-program" in files["report.html"]
    given = json.loads(files["gradescope.json"])
    assert {test["visibility"] for test in given["tests"]} == {"visible"}


def test_gradescope_is_told_what_to_keep_until_the_due_date(tmp_path: Path) -> None:
    given = json.loads(write(tmp_path, results(later="after_due"), *BEFORE)["gradescope.json"])
    for test in given["tests"]:
        later = "the test later" in test["name"]
        assert test["visibility"] == ("after_due_date" if later else "visible")
        assert later or not any(word("later", part) in test["output"] for part in PARTS)
    assert "printed-by-the-program" not in json.dumps(given)


@pytest.mark.parametrize("host", ["gradescope.json", "report.html"])
def test_a_reason_names_no_test_that_its_student_may_not_know(tmp_path: Path, host: str) -> None:
    document = results(secret="hidden", open="shown", built="shown")
    tests = document["submissions"][0]["exercises"][0]["verdict"]["tests"]
    for test, needed in zip(tests[2:], ["the test secret", "the test open"], strict=True):
        test["status"] = "skipped"
        test["failure"] = {"asked": "", "reason": f"it counts once this passes: {needed}"}
    text = write(tmp_path, document)[host]
    assert "test secret" not in text
    assert "it counts once a test that it builds on passes" in text
    assert "it counts once this passes: the test open" in text


def test_the_mark_itself_is_never_held_back(tmp_path: Path) -> None:
    kinds = {"open": "shown", "kept": "values_withheld", "later": "after_due", "secret": "hidden"}
    document = results(**kinds)
    unit = document["submissions"][0]["exercises"][0]
    for test in unit["verdict"]["tests"]:
        test |= {"status": "passed", "points": test["max_points"]}
        test.pop("failure", None)
    unit["points"] = unit["verdict"]["points"] = 9.0
    document["submissions"][0]["points"] = 9.0
    files = write(tmp_path, document, *BEFORE)
    assert json.loads(files["gradescope.json"])["score"] == 9
    assert json.loads(files["prairielearn.json"])["score"] == 1.0
    assert json.loads(files["classroom50.json"])["score"] == 9
    assert '"9","9",' in files["gradebook.csv"]
    # The source of the page has no more than it shows.
    assert "7 of 7 points" in files["report.html"]


def test_nobody_reads_the_seed(tmp_path: Path) -> None:
    for name, text in write(tmp_path, results(open="shown")).items():
        assert "autumn-lilac-4711" not in text, name


def test_every_mixture_keeps_what_it_must(tmp_path: Path) -> None:
    kinds = ("shown", "values_withheld", "hidden")
    for number, (one, two) in enumerate(itertools.product(kinds, kinds)):
        files = write(tmp_path / str(number), results("stopped", first=one, second=two))
        for name, text in files.items():
            for test, kind in (("first", one), ("second", two)):
                if kind != "shown":
                    assert word(test, "input") not in text, (name, one, two)
            if {one, two} != {"shown"}:
                assert "printed-by-the-program" not in text, (name, one, two)
