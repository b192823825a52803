"""What an instructor reads to answer a request for a regrade."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import pytest

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "grading")]

import outputs_class as made  # noqa: E402
from reports.why import main  # noqa: E402

Json = dict[str, Any]

EXERCISE = "02_triangles/ray_triangle"
FAILURE = {
    "asked": "Does the ray hit?",
    "inputs": [{"name": "ray", "text": "the-input"}],
    "got": "the-answer",
    "right": "the-right-one",
    "misconceptions": ["absolute-epsilon"],
    "hint": "Compare with zero itself.",
}


def results(visibility: str = "shown", points: float = 0.0) -> Json:
    """Of two students, of whom one has failed the second of two tests."""
    names = ("the middle", "an edge")
    tests: list[Json] = [
        {"name": name, "status": "passed", "points": 1.0, "max_points": 1.0} for name in names
    ]
    tests[1] |= {"status": "failed", "points": points, "failure": FAILURE}
    verdict = {"verdict": "failed", "points": 1 + points, "max_points": 2.0, "tests": tests}
    listed = {
        "id": EXERCISE,
        "title": "A ray and a triangle",
        "objective": "rays",
        "max_points": 2.0,
        "tests": [{"name": name, "points": 1.0, "visibility": visibility} for name in names],
    }
    students = [
        made.submission("ada", [made.unit(EXERCISE, verdict)], name="Ada L."),
        made.submission("cy", [made.absent(listed, "missing")]),
    ]
    return made.document([listed], students)


def write(folder: Path, document: Json, name: str = "results.json") -> Path:
    (folder / name).parent.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text(json.dumps(document))
    return folder


def told(capsys: pytest.CaptureFixture[str], *arguments: str | Path) -> str:
    assert main([str(one) for one in arguments]) == 0
    return capsys.readouterr().out


def test_it_shows_all_values_the_seed_and_the_mark(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    said = told(capsys, write(tmp_path, results()), "ada", "ray_triangle")
    assert said.startswith(f"ada (Ada L.), {EXERCISE} “A ray and a triangle”: 1 of 2 points\n")
    for value in ("the-input", "the-answer", "the-right-one", "Compare with zero", "autumn-lilac"):
        assert value in said
    assert "misconception: absolute-epsilon" in said


@pytest.mark.parametrize(
    ("visibility", "words"),
    [
        ("shown", "all of this"),
        ("values_withheld", "the question and the hint, without values"),
        ("after_due", "its name and points until the due date"),
        ("hidden", "only the points of such tests in sum"),
    ],
)
def test_it_says_what_the_student_sees(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], visibility: str, words: str
) -> None:
    due = ("--due", "2100-01-01T00:00+00:00")
    said = told(capsys, *due, write(tmp_path, results(visibility)), "ada", EXERCISE)
    assert f"The student's report shows {words}." in said
    assert "the-right-one" in said


def test_a_student_may_be_named_by_name(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert told(capsys, write(tmp_path, results()), "Ada L.", EXERCISE).startswith("ada (Ada L.)")


def test_it_tells_earlier_marks_and_why_they_changed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write(tmp_path, results(points=0.5))
    write(tmp_path, results(), "earlier/2026-10-01/results.json")
    change = {
        "submission": "ada",
        "exercise": EXERCISE,
        "before": 1,
        "after": 1.5,
        "why": ["tests"],
    }
    write(tmp_path, {"changes": [change]}, "changes.json")
    said = told(capsys, tmp_path, "ada", EXERCISE)
    assert "until 2026-10-01: 1\n" in said
    assert "The last run changed it from 1 to 1.5, because of: tests." in said


def test_nothing_handed_in_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert "The answer: nothing was handed in." in told(
        capsys, write(tmp_path, results()), "cy", EXERCISE
    )


@pytest.mark.parametrize(
    ("student", "exercise", "words"),
    [
        ("bob", EXERCISE, "nobody is called bob; the ids are ada, cy"),
        ("ada", "ray_sphere", f"ada has no exercise ray_sphere; there is {EXERCISE}"),
    ],
)
def test_what_is_not_there_is_refused_with_what_is(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    student: str,
    exercise: str,
    words: str,
) -> None:
    assert main([str(write(tmp_path, results())), student, exercise]) == 3
    assert words in capsys.readouterr().err
