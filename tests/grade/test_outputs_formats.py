"""Every format that a school's system reads is as that system's contract says, for a class of
real verdicts; marks are the same in all of them."""

from __future__ import annotations

import csv
import io
import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from lxml import etree

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "grading")]

import outputs_class as made  # noqa: E402
from reports import gradescope, results, write  # noqa: E402
from reports.__main__ import main  # noqa: E402

SCHEMAS = HERE / "schemas"
STUDENT_FILES = ("gradescope.json", "prairielearn.json", "classroom50.json", "junit.xml")

Json = dict[str, Any]


def schema(name: str) -> jsonschema.Draft202012Validator:
    return jsonschema.Draft202012Validator(json.loads((SCHEMAS / f"{name}.json").read_text()))


def write_results(folder: Path, document: Json) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "results.json").write_text(json.dumps(document))
    return folder


@pytest.fixture(scope="module")
def document() -> Json:
    whole = made.made_up_class(made.exercises(), made.verdicts(), students=24)
    listed = whole["exercises"]
    whole["submissions"].append(
        made.submission(
            "refused-whole",
            [],
            max_points=sum(entry["max_points"] for entry in listed),
            problem="the archive holds a link, work/a, so nothing of it was read",
        )
    )
    whole["submissions"].append(
        made.submission(
            "empty-handed", [made.absent(entry, "missing") for entry in listed], ignored=["a.txt"]
        )
    )
    broken = made.verdicts()
    whole["submissions"].append(
        made.submission(
            "broken-all",
            [made.unit(entry["id"], broken[entry["id"]]["broken semicolon"]) for entry in listed],
        )
    )
    return whole


@pytest.fixture(scope="module")
def graded(document: Json, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """RESULTS of that class, with every report."""
    folder = write_results(tmp_path_factory.mktemp("results"), document)
    assert main([str(folder)]) == 0
    return folder


def every(graded: Path, name: str) -> dict[str, Json]:
    found = {
        file.parent.name: json.loads(file.read_text()) for file in graded.glob(f"students/*/{name}")
    }
    assert len(found) == 27
    return found


def marks(document: Json) -> dict[str, float]:
    return {one["id"]: one["points"] for one in document["submissions"]}


def test_gradescope_has_the_fields_of_its_specification(graded: Path, document: Json) -> None:
    for student, given in every(graded, "gradescope.json").items():
        schema("gradescope").validate(given)
        assert given["score"] == marks(document)[student]
        assert sum(test.get("score", 0) for test in given["tests"]) == given["score"]
        formats = {test["output_format"] for test in given["tests"]} | {given["output_format"]}
        assert formats == {"text"}, "nothing of a submission is rendered"


def test_a_result_that_is_no_mark_is_valid_too() -> None:
    given = gradescope.not_graded("bubblewrap is not installed")
    schema("gradescope").validate(given)
    assert "no mark" in given["output"]
    assert given["extra_data"]["graded"] is False
    assert "score" not in json.dumps(given)


def test_prairielearn_has_the_fields_of_its_page(graded: Path, document: Json) -> None:
    for student, given in every(graded, "prairielearn.json").items():
        schema("prairielearn").validate(given)
        whole = next(one for one in document["submissions"] if one["id"] == student)
        assert given["score"] == pytest.approx(whole["points"] / whole["max_points"], abs=1e-5)
        assert (given["score"] == 1) == (whole["points"] == whole["max_points"])


def test_what_does_not_compile_is_not_gradable(graded: Path) -> None:
    all_of_them = every(graded, "prairielearn.json")
    for student in ("broken-all", "refused-whole", "empty-handed"):
        assert all_of_them[student]["gradable"] is False
        assert all_of_them[student]["format_errors"]
    assert "semicolon" in " ".join(all_of_them["broken-all"]["format_errors"])
    assert "a link, work/a" in all_of_them["refused-whole"]["format_errors"][0]
    assert sum(given["gradable"] for given in all_of_them.values()) >= 20


def test_prairielearn_is_cut_to_a_megabyte_and_says_so(tmp_path: Path) -> None:
    listed = made.exercises()
    answers = made.verdicts()[listed[0]["id"]]
    wrong = next(kind for kind in answers if kind.startswith("wrong"))
    verdict = json.loads(json.dumps(answers[wrong]))
    long = "\n".join(f"{line:06d} " + "x" * 90 for line in range(300))
    for test in verdict["tests"]:
        test |= {"status": "failed", "points": 0.0}
        test["failure"] = {
            "asked": "?",
            "inputs": [{"name": f"n{n}", "text": long} for n in range(12)],
            "got": long,
        }
    verdict["output"] = long
    units = [made.unit(listed[0]["id"], verdict)]
    folder = write_results(
        tmp_path / "r", made.document(listed[:1], [made.submission("long", units)])
    )
    assert main([str(folder), "--formats", "prairielearn"]) == 0
    file = folder / "students/long/prairielearn.json"
    assert 10_000 < file.stat().st_size <= 1_000_000
    given = json.loads(file.read_text())
    schema("prairielearn").validate(given)
    assert "1 MB" in given["message"]
    assert len(given["tests"]) == len(verdict["tests"]), "each test keeps its points"
    assert all("n0" in test["output"] for test in given["tests"]), (
        "cut fairly: each keeps its start"
    )


def test_classroom50_keeps_its_contract(graded: Path, document: Json) -> None:
    for student, given in every(graded, "classroom50.json").items():
        schema("classroom50").validate(given)
        assert given["score"] <= given["max-score"]
        assert given["score"] == sum(test["score"] for test in given["tests"])
        assert given["max-score"] == sum(test["max-score"] for test in given["tests"])
        assert all(test["score"] <= test["max-score"] for test in given["tests"])
        assert given["score"] == marks(document)[student] * given["points-factor"]


def test_classroom50_counts_in_whole_numbers(tmp_path: Path) -> None:
    listed = made.exercises()[:1]
    verdict = json.loads(json.dumps(made.verdicts()[listed[0]["id"]]["solution"]))
    for test, spec, points in zip(
        verdict["tests"], listed[0]["tests"], [0.5, 0.25, *[1.0] * 20], strict=False
    ):
        test["points"] = test["max_points"] = spec["points"] = points
    total = sum(test["points"] for test in verdict["tests"])
    verdict["points"] = verdict["max_points"] = listed[0]["max_points"] = total
    folder = write_results(
        tmp_path,
        made.document(listed, [made.submission("x", [made.unit(listed[0]["id"], verdict)])]),
    )
    assert main([str(folder), "--formats", "classroom50"]) == 0
    given = json.loads((folder / "students/x/classroom50.json").read_text())
    schema("classroom50").validate(given)
    assert given["points-factor"] == 4
    assert given["score"] == given["max-score"] == round(total * 4)


def test_classroom50_takes_who_and_where_from_its_runner(
    tmp_path: Path, document: Json, monkeypatch: pytest.MonkeyPatch
) -> None:
    runner = {
        "CLASSROOM": "geometry",
        "ASSIGNMENT": "planes",
        "SUBMISSION_TAG": "submit/2026-06-01T14-32-05Z-a1b2c3d",
        "OWNER": "somebody",
        "COMMIT_URL": "https://example.org/commit/1",
        "RELEASE_URL": "https://example.org/release/1",
        "REVIEW_URL": "https://example.org/compare/1",
    }
    for name, value in runner.items():
        monkeypatch.setenv(name, value)
    folder = write_results(tmp_path, {**document, "submissions": document["submissions"][:1]})
    words = [str(folder), "--formats", "classroom50", "--now", "2026-06-01T16:32:05+02:00"]
    assert main(words) == 0
    file = next(folder.glob("students/*/classroom50.json"))
    given = json.loads(file.read_text())
    fields = ("classroom", "assignment", "submission", "owner", "commit", "release", "review")
    assert [given[name] for name in fields] == list(runner.values())
    assert given["datetime"] == "2026-06-01T14:32:05Z"


def test_junit_is_valid_and_counts_what_it_holds(graded: Path) -> None:
    xsd = etree.XMLSchema(etree.parse(str(SCHEMAS / "junit-10.xsd")))
    files = list(graded.glob("students/*/junit.xml"))
    assert len(files) == 27
    kinds = set()
    for file in files:
        tree = etree.parse(str(file))
        xsd.assertValid(tree)
        for suite in tree.getroot().iter("testsuite"):
            for tag, key in (("failure", "failures"), ("error", "errors"), ("skipped", "skipped")):
                found = suite.findall(f"testcase/{tag}")
                assert int(suite.get(key, "")) == len(found)
                kinds |= {tag for _ in found}
            assert int(suite.get("tests", "")) == len(suite.findall("testcase"))
    assert kinds >= {"failure", "error"}


def test_a_submission_that_was_refused_whole_says_so_everywhere(
    graded: Path, document: Json
) -> None:
    for name in (*STUDENT_FILES, "report.html"):
        assert "the archive holds a link" in (graded / "students/refused-whole" / name).read_text()
    given = json.loads((graded / "students/refused-whole/classroom50.json").read_text())
    most = sum(exercise["max_points"] for exercise in document["exercises"])
    assert (given["score"], given["max-score"]) == (0, most)


def test_the_gradebook_has_a_row_a_student_and_a_column_an_exercise(
    graded: Path, document: Json
) -> None:
    raw = (graded / "gradebook.csv").read_bytes()
    assert raw.count(b"\r\n") == 28
    assert not raw.startswith(b"\xef\xbb\xbf")
    rows = list(csv.DictReader(io.StringIO(raw.decode("utf-8"), newline="")))
    ids = [exercise["id"] for exercise in document["exercises"]]
    assert list(rows[0]) == ["id", "name", *ids, "total", "max_points", "remarks", "not_enforced"]
    for row, one in zip(rows, document["submissions"], strict=True):
        assert row["id"] == one["id"]
        assert float(row["total"]) == one["points"] == sum(float(row[id_] or 0) for id_ in ids)
        assert float(row["max_points"]) == one["max_points"]
        assert row["not_enforced"] == ""
    remarks = {row["id"]: row["remarks"] for row in rows}
    assert remarks["refused-whole"].startswith("refused: the archive holds a link")
    assert "does not compile" in remarks["broken-all"]
    assert "not handed in" in remarks["empty-handed"]


def test_what_the_machine_could_not_enforce_stands_on_every_report(
    tmp_path: Path, document: Json
) -> None:
    what = "a limit on memory for all processes together"
    weak = {**document, "machine": made.document([], [], level="reduced")["machine"]}
    weak["submissions"] = document["submissions"][-3:] + document["submissions"][:2]
    folder = write_results(tmp_path, weak)
    assert main([str(folder)]) == 0
    written = [file for file in folder.rglob("*") if file.is_file() and file.name != "results.json"]
    assert len(written) == 5 * (len(STUDENT_FILES) + 1) + 2
    for file in written:
        assert what in file.read_text(), file


def test_the_same_results_give_the_same_bytes(tmp_path: Path, graded: Path, document: Json) -> None:
    again = write_results(tmp_path, document)
    moment = ["--now", "2026-06-01T12:00+00:00"]
    assert main([str(graded), *moment]) == 0
    assert main([str(again), *moment]) == 0
    for file in again.rglob("*.*"):
        if file.is_file():
            assert file.read_bytes() == (graded / file.relative_to(again)).read_bytes(), file


def test_only_what_was_asked_for_is_written(tmp_path: Path, document: Json) -> None:
    folder = write_results(tmp_path, {**document, "submissions": document["submissions"][:2]})
    assert main([str(folder), "--formats", "junit,gradebook"]) == 0
    names = {file.name for file in folder.rglob("*") if file.is_file()}
    assert names == {"results.json", "junit.xml", "gradebook.csv"}
    assert set(write.FORMATS) >= {"junit", "gradebook"}


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (lambda whole: whole.pop("machine"), "machine"),
        (lambda whole: whole.update(format="contact-grade/1"), "contact-grade/2"),
        (lambda whole: whole["submissions"][0].update(points=-1), "submissions/0/points"),
        (lambda whole: whole["submissions"][0].update(points=float("nan")), "NaN"),
        (
            lambda whole: whole["submissions"][0]["exercises"][0].update(id="09_none/none"),
            "09_none/none",
        ),
        (lambda whole: whole["submissions"].append(whole["submissions"][0]), "two submissions"),
    ],
)
def test_results_that_are_not_as_agreed_are_refused_with_their_place(
    tmp_path: Path,
    document: Json,
    capsys: pytest.CaptureFixture[str],
    spoil: Callable[[Json], object],
    words: str,
) -> None:
    whole = json.loads(json.dumps({**document, "submissions": document["submissions"][:2]}))
    spoil(whole)
    folder = write_results(tmp_path, whole)
    assert main([str(folder)]) == 3
    assert words in capsys.readouterr().err
    assert not (folder / "gradebook.csv").exists()


def test_a_folder_without_results_is_a_sentence(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "reports", str(tmp_path)],
        env={"PYTHONPATH": str(ROOT / "grading")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 3
    assert "results.json is not there" in done.stderr
    assert "Traceback" not in done.stderr


def test_the_schema_of_results_is_one() -> None:
    jsonschema.Draft202012Validator.check_schema(json.loads(results.SCHEMA.read_text()))
    for name in ("gradescope", "prairielearn", "classroom50"):
        jsonschema.Draft202012Validator.check_schema(schema(name).schema)
