"""A second grading over the same results: what is reused, which marks moved and why, and that
nothing of the first is lost."""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from graded_class import EXERCISE, ROOT, SOLUTION, WRONG, Document, Grader, greedy, without_times


def earlier(grader: Grader) -> list[Path]:
    return sorted((grader.results / "earlier").glob("*"))


def changes(grader: Grader) -> list[Document]:
    document = grader.document("changes.json")
    assert document["format"] == "contact-grade-changes/1"
    found: list[Document] = document["changes"]
    return found


@pytest.fixture(scope="module")
def first(tmp_path_factory: pytest.TempPathFactory) -> Grader:
    """What every second grading here begins with: graded once, for all."""
    grader = Grader(tmp_path_factory.mktemp("first") / "class")
    grader.hand_in("ada")
    grader.hand_in("bob", WRONG)
    grader.hand_in("cyd", WRONG)
    grader.grade("--seed", "s")
    grader.clean()
    return grader


@pytest.fixture
def graded(first: Grader, grader: Grader) -> Grader:
    """A copy, to be graded again."""
    shutil.copytree(first.submissions, grader.submissions, dirs_exist_ok=True)
    shutil.copytree(first.results, grader.results)
    return grader


def test_nothing_new_moves_nothing(graded: Grader) -> None:
    before = (graded.results / "results.json").read_bytes()
    done = graded.run()
    assert done.returncode == 0
    assert "3 of 3 units are graded already" in done.stderr
    assert "No mark moved." in done.stdout
    assert (graded.results / "results.json").read_bytes() == before
    assert not (graded.results / "earlier").exists()
    assert graded.counts("start") == {"ada": 1, "bob": 1, "cyd": 1}


def test_new_code(graded: Grader) -> None:
    before = graded.document()
    wrong = graded.points()["bob"]
    graded.hand_in("bob", SOLUTION)
    done = graded.run()
    assert done.returncode == 0
    assert "1 mark moved:" in done.stdout
    (row,) = [line.split() for line in done.stdout.splitlines() if line.strip().startswith("bob")]
    assert row == ["bob", EXERCISE, f"{wrong:g}", "8", "code"]
    (change,) = changes(graded)
    assert change["why"] == ["code"]
    assert (change["submission"], change["exercise"]) == ("bob", EXERCISE)
    assert (change["before"], change["after"], change["max_points"]) == (wrong, 8, 8)
    assert {(test["before"], test["after"]) for test in change["tests"]} == {("failed", "passed")}
    # Only bob was graded again, and what he had handed in and got is kept.
    assert graded.counts("start") == {"ada": 1, "bob": 2, "cyd": 1}
    (kept,) = earlier(graded)
    assert graded.document(f"earlier/{kept.name}/results.json") == before
    assert (kept / f"submissions/bob/{EXERCISE}.cpp").read_text() == WRONG
    assert str(kept.name) in done.stdout


def test_a_file_that_is_gone_moves_the_mark_and_is_kept(graded: Grader) -> None:
    (graded.submissions / "ada" / f"{EXERCISE}.cpp").unlink()
    graded.grade()
    (change,) = changes(graded)
    assert (change["before"], change["after"], change["why"]) == (8, 0, ["code"])
    (kept,) = earlier(graded)
    assert (kept / f"submissions/ada/{EXERCISE}.cpp").read_text() == SOLUTION
    # What it got is still known, should it come back.
    graded.hand_in("ada")
    assert graded.grade()["units"] == {"graded": 0, "reused": 3, "alone": 0}
    assert graded.points()["ada"] == 8
    assert len(earlier(graded)) == 2


def test_marks_that_come_and_go_are_marks_that_moved(graded: Grader) -> None:
    wrong = graded.points()["cyd"]
    shutil.rmtree(graded.submissions / "ada")
    (graded.submissions / "ada.zip").write_text("no archive")
    shutil.rmtree(graded.submissions / "cyd")
    graded.hand_in("dan")
    done = graded.run()
    assert done.returncode == 1
    assert "No mark moved" not in done.stdout
    assert "3 marks moved:" in done.stdout
    told = [" ".join(line.split()) for line in done.stdout.splitlines()]
    assert f"ada {EXERCISE} 8 0 code, refused" in told
    assert f"cyd {EXERCISE} {wrong:g} none not handed in any more" in told
    assert f"dan {EXERCISE} none 8 new" in told
    found = {change["submission"]: change for change in changes(graded)}
    assert {id_: (one["before"], one["after"], one["why"]) for id_, one in found.items()} == {
        "ada": (8, 0, ["code", "refused"]),
        "cyd": (wrong, None, ["not handed in any more"]),
        "dan": (None, 8, ["new"]),
    }
    assert {one["max_points"] for one in found.values()} == {8}
    assert {test["after"] for test in found["ada"]["tests"]} == {None}
    assert {test["before"] for test in found["dan"]["tests"]} == {None}
    # And back again.
    (graded.submissions / "ada.zip").unlink()
    graded.hand_in("ada")
    graded.grade()
    (change,) = changes(graded)
    assert (change["submission"], change["before"], change["after"]) == ("ada", 0, 8)
    assert change["why"] == ["code"]


def test_marks_of_other_exercises(graded: Grader) -> None:
    graded.grade(exercises="sphere_plane")
    reasons = {(one["exercise"], one["after"] is None, *one["why"]) for one in changes(graded)}
    assert reasons == {
        (EXERCISE, True, "not asked for any more"),
        ("01_planes/sphere_plane", False, "new"),
    }


def contents(folder: Path) -> dict[Path, bytes]:
    lock = folder / ".grade/lock"
    files = (file for file in folder.rglob("*") if file.is_file() and file != lock)
    return {file: file.read_bytes() for file in files}


def test_another_class_is_not_graded_into_the_same_results(graded: Grader) -> None:
    before = contents(graded.results)
    shutil.rmtree(graded.submissions)
    graded.hand_in("zoe")
    done = graded.run()
    assert done.returncode == 3
    assert "Is this another class? Then give another folder with -o" in done.stderr
    assert contents(graded.results) == before
    # One that is still there makes it the same class.
    graded.hand_in("bob", WRONG)
    assert graded.run().returncode == 0


def test_other_limits(graded: Grader) -> None:
    graded.hand_in("ada", SOLUTION + greedy(200))
    graded.grade()
    profile = graded.folder / "profile.toml"
    profile.write_text("memory_mb = 100\n")
    summary = graded.grade("--profile", str(profile))
    assert summary["units"] == {"graded": 3, "reused": 0, "alone": 0}
    (change,) = changes(graded)
    assert (change["submission"], change["before"], change["after"]) == ("ada", 8, 0)
    assert change["why"] == ["limits"]
    assert summary["changes"] == changes(graded)


def test_another_seed(grader: Grader) -> None:
    """An answer that is wrong or right by the last bit of the first number that it is asked."""
    name = "double signed_distance("
    assert SOLUTION.count(name) == 1
    fickle = SOLUTION.replace(name, "double honest(") + (
        "\n#include <cstdint>\n#include <cstring>\nnamespace exercise {\n"
        "double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {\n"
        "  static int calls = 0;\n  std::uint64_t bits = 0;\n"
        "  std::memcpy(&bits, &plane.a, sizeof bits);\n"
        "  return honest(plane, point) + (calls++ == 0 && (bits & 1) != 0 ? 1.0 : 0.0);\n}\n"
        "}  // namespace exercise\n"
    )
    grader.hand_in("ada", fickle)
    grader.grade("--seed", "0")
    for seed in range(1, 12):
        grader.grade("--seed", str(seed))
        if changes(grader):
            break
    (change,) = changes(grader)
    assert change["why"] == ["seed"]
    assert [test["name"] for test in change["tests"]] == [
        "random points agree with exact arithmetic"
    ]


def test_other_tests(grader: Grader) -> None:
    """Tests of the instructor's own are added to those of the book."""
    ray = "02_triangles/ray_triangle"
    private = grader.folder / "private"
    shutil.copytree(ROOT / "tests/grade/private", private)
    private.chmod(0o700)
    grader.hand_in("ada", (ROOT / f"solutions/{ray}/ray_triangle.cpp").read_text(), ray)
    grader.grade(exercises="ray_triangle")
    book = grader.points()["ada"]
    grader.grade("--private", str(private), exercises="ray_triangle")
    (change,) = changes(grader)
    assert change["why"] == ["tests"]
    assert (change["before"], change["after"]) == (book, change["max_points"])
    assert change["after"] > book
    assert {test["before"] for test in change["tests"]} == {None}
    tests = grader.document()["exercises"][0]["tests"]
    assert {test["name"] for test in tests if test["private"]} == {
        test["name"] for test in change["tests"]
    }


def test_another_grader_grades_all_again(graded: Grader) -> None:
    before = graded.document()
    own = graded.folder.parent / "bin"
    own.mkdir()
    for name in ("contact", "contact-grade", "contact-box", "contact-explain"):
        shutil.copy2(graded.program.parent / name, own)
    graded.program = own / "contact"
    program = own / "contact-grade"
    assert graded.grade()["units"]["reused"] == 3
    # A byte after its end changes nothing that it does.
    with program.open("ab") as file:
        file.write(b"\0")
    assert graded.grade()["units"] == {"graded": 3, "reused": 0, "alone": 0}
    assert changes(graded) == []
    after = graded.document()
    for document in (before, after):
        for submission in document["submissions"]:
            for unit in submission["exercises"]:
                unit["key"].pop("grader")
    assert without_times(after) == without_times(before)


def test_results_that_were_written_to_are_not_replaced(graded: Grader) -> None:
    file = graded.results / "results.json"
    file.write_text("{}")
    graded.hand_in("bob", SOLUTION)
    done = graded.run()
    assert done.returncode == 3
    assert "is not as it was written" in done.stderr
    assert file.read_text() == "{}"


def test_the_limits_of_time_stay(graded: Grader) -> None:
    file = graded.results / ".grade/RUN.json"
    run = json.loads(file.read_text())
    measured = run["test_seconds"][EXERCISE]
    # As a machine would have found on which the solution takes longer.
    run["test_seconds"][EXERCISE] = measured + 40
    file.write_text(json.dumps(run))
    graded.grade()
    assert graded.document(".grade/RUN.json")["test_seconds"][EXERCISE] == measured + 40
    graded.grade("--recalibrate")
    assert graded.document(".grade/RUN.json")["test_seconds"][EXERCISE] == measured


def test_why_a_mark_is_what_it_is(graded: Grader) -> None:
    done = graded.run_as("-o", str(graded.results), "--why", "bob", EXERCISE)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith(f"bob, {EXERCISE} ")
    assert "seed s" in done.stdout
    assert "The student's report shows all of this." in done.stdout
    assert not (graded.results / "earlier").exists()


def test_why_needs_the_results_and_no_submissions(graded: Grader) -> None:
    without = graded.run_as("--why", "bob", EXERCISE)
    assert without.returncode == 2
    assert "--output is required" in without.stderr
    both = graded.run_as(str(graded.submissions), "-o", "x", "--why", "bob", EXERCISE)
    assert both.returncode == 2
    nobody = graded.run_as("-o", str(graded.results), "--why", "eve", EXERCISE)
    assert nobody.returncode == 3
    assert "nobody is called eve" in nobody.stderr
