"""contact grade: what it prints and writes, what it refuses, and that results do not depend on how
many workers there are or what else runs."""

from __future__ import annotations

import fcntl
import json
import multiprocessing
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import jsonschema
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from graded_class import (
    EXERCISE,
    ROOT,
    SOLUTION,
    STUB,
    WRONG,
    Grader,
    greedy,
    without_times,
)

SCHEMA = json.loads((ROOT / "grading/reports/results.schema.json").read_text())
HEAD = "double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {\n"
assert HEAD in SOLUTION
BROKEN = SOLUTION + "\nint missing_semicolon\n"


def test_a_class_is_graded(grader: Grader) -> None:
    grader.hand_in("ada")
    grader.hand_in("bob", WRONG)
    grader.hand_in("cyd", BROKEN)
    grader.hand_in("dan", STUB)
    (grader.submissions / "eve").mkdir()
    done = grader.run()
    assert done.returncode == 0, done.stderr
    assert "5 submissions graded" in done.stdout
    document = grader.document()
    jsonschema.validate(document, SCHEMA)
    assert [entry["id"] for entry in document["submissions"]] == ["ada", "bob", "cyd", "dan", "eve"]
    units = {name: grader.unit(name) for name in ("ada", "bob", "cyd", "dan", "eve")}
    assert {name: unit["status"] for name, unit in units.items()} == {
        "ada": "graded",
        "bob": "graded",
        "cyd": "graded",
        "dan": "untouched",
        "eve": "missing",
    }
    assert units["ada"]["points"] == units["ada"]["max_points"] == 8
    assert 0 < units["bob"]["points"] < 8
    assert units["ada"]["gradable"]
    assert not units["cyd"]["gradable"]
    assert units["cyd"]["verdict"]["verdict"] == "does_not_compile"
    mean = sum(grader.points().values()) / 5
    assert f"Mean: {mean:.2f} of 8 points" in done.stdout
    # Reports of every kind are there, and the record of the run.
    for name in ("class.html", "gradebook.csv", "students/ada/gradescope.json"):
        assert (grader.results / name).stat().st_size > 0
    record = grader.document("run.json")
    assert record["format"] == "contact-grade-record/1"
    assert record["units"] == {"graded": 3, "reused": 0, "alone": 0}
    # Each text that was handed in is stored unchanged; other users cannot read it.
    kept = grader.results / ".grade/submissions/cyd/01_planes/signed_distance.cpp"
    assert kept.read_text() == BROKEN
    assert (grader.results / ".grade").stat().st_mode & 0o077 == 0


def test_every_measure_that_is_not_enforced_is_said(grader: Grader) -> None:
    grader.hand_in("dan", STUB)
    done = grader.run()
    assert done.returncode == 0, done.stderr
    measures = grader.document()["machine"]["measures"]
    assert measures
    for measure in measures:
        assert (f"  {measure['what']} (" in done.stdout) == (not measure["enforced"])


def test_a_refusal_is_told_and_stops_nobody(grader: Grader) -> None:
    grader.hand_in("ada")
    (grader.submissions / "mallory.zip").write_bytes(b"PK\3\4 and no more")
    done = grader.run()
    assert done.returncode == 1
    assert "1 submission graded, 1 refused" in done.stdout
    assert "mallory: 'mallory.zip' cannot be used" in done.stdout
    assert grader.points() == {"ada": 8, "mallory": 0}


def test_the_seed_is_drawn_once_and_can_be_given(grader: Grader, tmp_path: Path) -> None:
    grader.hand_in("dan", STUB)
    grader.grade()
    drawn = grader.document()["seed"]
    assert len(drawn) == 32
    grader.grade()
    assert grader.document()["seed"] == drawn
    grader.grade("--seed", "an autumn term")
    assert grader.document()["seed"] == "an autumn term"
    other = Grader(tmp_path / "other")
    other.hand_in("dan", STUB)
    other.grade()
    assert other.document()["seed"] != drawn


def test_only_the_exercises_that_are_asked_for_count(grader: Grader) -> None:
    grader.hand_in("dan", STUB)
    grader.hand_in("dan", "int x;", "02_triangles/ray_triangle")
    grader.grade(exercises="01_planes")
    document = grader.document()
    ids = [exercise["id"] for exercise in document["exercises"]]
    assert EXERCISE in ids
    assert all(id_.startswith("01_planes/") for id_ in ids)
    submission = grader.submission("dan")
    assert submission["max_points"] == sum(e["max_points"] for e in document["exercises"])
    # A file for an exercise that is not asked for answers to one all the same.
    assert submission["ignored"] == []


# --- What is refused before anything is made ------------------------------------------------------


def test_command_lines_that_are_not_understood(grader: Grader) -> None:
    grader.hand_in("ada")
    for words, says in (
        (["--exercises", "rai_triangle"], "ray_triangle"),
        (["--formats", "pdf"], "pdf"),
        (["--due", "tomorrow"], "tomorrow"),
        (["--engine", "cloud"], "cloud"),
        (["--workers", "0"], "--workers"),
    ):
        done = grader.run(*words)
        assert done.returncode == 2, (words, done.stderr)
        assert says in done.stderr
    assert not grader.results.exists()


def test_what_is_missing_is_said_with_a_whole_command(grader: Grader) -> None:
    usage = "`contact grade FOLDER --output RESULTS` grades the submissions in FOLDER"
    for words, missing in (
        ([str(grader.submissions)], "--output is required"),
        ([], "A folder of submissions is required"),
        (["--output", str(grader.results)], "A folder of submissions is required"),
    ):
        done = grader.run_as(*words)
        assert done.returncode == 2
        assert f"{missing}: {usage}" in done.stderr
    assert not grader.results.exists()


def test_submissions_must_be_a_folder_apart_from_the_results(grader: Grader) -> None:
    grader.hand_in("ada")
    good = grader.results
    for results in (grader.submissions / "results", grader.submissions, grader.folder):
        grader.results = results
        done = grader.run()
        assert done.returncode == 2
        assert "must lie apart" in done.stderr
    assert sorted(path.name for path in grader.submissions.iterdir()) == ["ada"]
    grader.results = good
    grader.submissions = grader.folder / "nowhere"
    done = grader.run()
    assert done.returncode == 2
    assert "there is no folder of submissions" in done.stderr


def test_a_class_without_anybody_is_nothing_to_grade(grader: Grader) -> None:
    done = grader.run()
    assert done.returncode == 2
    assert "there is no submission in" in done.stderr


def test_a_class_of_which_everybody_is_refused_is_a_mistake(grader: Grader) -> None:
    # One student's folder.
    grader.submissions.mkdir(exist_ok=True)
    for name in ("signed_distance", "sphere_plane", "closest_point", "ray_triangle"):
        (grader.submissions / f"{name}.cpp").write_text(SOLUTION)
    done = grader.run(exercises="01_planes")
    assert done.returncode == 3
    assert "every submission was refused: the name 'closest_point.cpp' does not say" in done.stderr
    assert f"Is {grader.submissions} a folder of submissions" in done.stderr
    assert not grader.results.exists()


@pytest.mark.parametrize("students", [["ada"], ["ada", "bob", "cyd", "dan", "eve"]])
def test_a_table_of_another_class_is_a_mistake(grader: Grader, students: list[str]) -> None:
    for student in students:
        grader.hand_in(student)
    table = grader.folder / "ids.csv"
    table.write_text("entry,id\nzoe,1\n")
    done = grader.run("--ids", str(table))
    assert done.returncode == 3
    assert "every submission was refused: 'ada' is not in ids.csv" in done.stderr
    assert ("; and 2 more. Is " in done.stderr) == (len(students) == 5)
    assert not grader.results.exists()


def test_one_submission_alone_that_cannot_be_used_is_told_its_student(grader: Grader) -> None:
    (grader.submissions / "mallory.zip").write_bytes(b"PK\3\4 and no more")
    done = grader.run()
    assert done.returncode == 1
    assert "cannot be used" in grader.submission("mallory")["problem"]


def test_results_never_go_among_other_files(grader: Grader) -> None:
    grader.hand_in("ada")
    grader.results.mkdir()
    thesis = grader.results / "thesis.tex"
    thesis.write_text("dear")
    done = grader.run()
    assert done.returncode == 3
    assert "holds files that no grading made" in done.stderr
    assert [path.name for path in grader.results.iterdir()] == ["thesis.tex"]
    thesis.unlink()
    assert grader.run().returncode == 0


@pytest.mark.parametrize(
    ("python", "says"),
    [
        (None, "the reports is not there"),
        # As where a user may not look into the folder that the link leads to.
        ("python", "the reports cannot be reached"),
        ("/bin/false", "does not do so (it says nothing): run ./contact setup"),
    ],
)
def test_nothing_is_graded_that_no_report_could_be_made_of(
    grader: Grader, python: str | None, says: str
) -> None:
    grader.root = grader.folder / "book"
    programs = grader.root / "build/venv/bin"
    programs.mkdir(parents=True)
    (grader.root / "build/dev").symlink_to(ROOT / "build/dev")
    for part in ("chapters", "exercises", "grading", "solutions", "tests", "cmake", "page"):
        (grader.root / part).symlink_to(ROOT / part)
    if python is not None:
        (programs / "python").symlink_to(python)
    grader.hand_in("ada")
    done = grader.run()
    assert done.returncode == 3
    assert says in done.stderr
    assert not grader.results.exists()


def test_one_coordinator_at_a_time(grader: Grader) -> None:
    grader.hand_in("dan", STUB)
    grader.grade()
    lock = grader.results / ".grade/lock"
    with lock.open("r+") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        done = grader.run()
    assert done.returncode == 3
    assert "is being graded into already, by process " in done.stderr
    assert grader.run().returncode == 0


# --- Profiles -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("profile", "says"),
    [
        ("memory = 100", "profile.toml:1: there is no limit 'memory'. Did you mean memory_mb?"),
        ("\nbanana = 1", "profile.toml:2: there is no limit 'banana'; a profile may set"),
        ("calls = 1.5", "calls must be a whole number"),
        ("calls = '7'", "calls must be a whole number"),
        ("wall_factor = true", "wall_factor must be a number"),
        ("memory_mb = 1", "memory_mb must be between 32 and 65536"),
        ("test_cpu_seconds = -1", "test_cpu_seconds must be between 0.0 and 3600.0"),
        ("idle_seconds = 0", "idle_seconds must be between 0.1 and 3600.0"),
        ("wall_extra = nan", "wall_extra must be between"),
        ("calls = ", "profile.toml:1: "),
    ],
)
def test_bad_profiles(grader: Grader, profile: str, says: str) -> None:
    grader.hand_in("ada")
    file = grader.folder / "profile.toml"
    file.write_text(profile)
    done = grader.run("--profile", str(file))
    assert done.returncode == 3
    assert says in done.stderr
    assert not grader.results.exists()


def test_a_profile_is_printed_in_the_results_and_holds(grader: Grader) -> None:
    grader.hand_in("ada", SOLUTION + greedy(200))
    profile = grader.folder / "profile.toml"
    profile.write_text("memory_mb = 100\ntest_cpu_seconds = 2\n")
    grader.grade("--profile", str(profile))
    limits = grader.document()["limits"]
    assert (limits["memory_mb"], limits["test_cpu_seconds"]) == (100, 2.0)
    assert len(limits) == 19
    assert grader.points() == {"ada": 0}
    grader.grade()
    assert grader.points() == {"ada": 8}


def test_results_of_a_version_with_fewer_limits_are_graded_into(grader: Grader) -> None:
    grader.hand_in("ada")
    grader.grade()
    file = grader.results / ".grade/RUN.json"
    run = json.loads(file.read_text())
    del run["limits"]["idle_seconds"]
    file.write_text(json.dumps(run))
    grader.grade()
    assert grader.points() == {"ada": 8}


# --- The same each time ---------------------------------------------------------------------------


def _spin() -> None:
    while True:
        pass


@contextmanager
def load() -> Iterator[None]:
    """Twice as many busy processes as there are cores."""
    processes = [
        multiprocessing.get_context("spawn").Process(target=_spin, daemon=True)
        for _ in range(2 * (os.cpu_count() or 1))
    ]
    for process in processes:
        process.start()
    try:
        yield
    finally:
        for process in processes:
            process.kill()
            process.join()


def test_the_same_bytes_with_any_number_of_workers_and_under_load(tmp_path: Path) -> None:
    texts = {
        "ada": SOLUTION,
        "bob": WRONG,
        "cyd": BROKEN,
        "dan": STUB,
        "eve": SOLUTION + "\nstruct Crash { Crash() { __builtin_trap(); } } crash;\n",
        "fay": SOLUTION.replace(HEAD, HEAD + "  for (volatile int i = 0;; i = i) {}\n"),
        "gil": "#include <unistd.h>\n" + SOLUTION.replace(HEAD, HEAD + "  sleep(1000);\n"),
    }
    seen = []
    for name, workers, busy in (("1", 1, False), ("2", 2, False), ("8", 8, False), ("b", 2, True)):
        grader = Grader(tmp_path / name)
        for student, text in texts.items():
            grader.hand_in(student, text)
        profile = grader.folder / "profile.toml"
        profile.write_text("test_cpu_seconds = 0.5\nwall_extra = 60\n")
        words = ["--workers", str(workers), "--seed", "same", "--profile", str(profile)]
        if busy:
            with load():
                grader.grade(*words)
        else:
            grader.grade(*words)
        seen.append(json.dumps(without_times(grader.document()), indent=1))
        grader.clean()
    assert all(text == seen[0] for text in seen)


def test_near_a_limit_is_graded_once_more_alone_and_last(grader: Grader) -> None:
    slow = (
        "#include <ctime>\n"
        + SOLUTION
        + "\nnamespace { const bool slow = [] {"
        + " while (std::clock() < 4 * CLOCKS_PER_SEC / 10) {} return true; }(); }\n"
    )
    for student in ("ada", "bob", "cyd"):
        grader.hand_in(student)
    grader.hand_in("abe", slow)
    profile = grader.folder / "profile.toml"
    profile.write_text("test_cpu_seconds = 0.5\nwall_extra = 60\n")
    summary = grader.grade("--workers", "2", "--profile", str(profile))
    assert summary["units"] == {"graded": 4, "reused": 0, "alone": 1}
    lines = [(line[0], line[1], line[3]) for line in grader.log()]
    assert lines[-2:] == [("start", "abe", "alone"), ("finish", "abe", "alone")]
    assert grader.counts("finish") == {"ada": 1, "bob": 1, "cyd": 1, "abe": 2}
    assert grader.points()["abe"] == 8
    # What was run alone is believed: it is not run again.
    assert grader.grade("--profile", str(profile))["units"] == {
        "graded": 0,
        "reused": 4,
        "alone": 0,
    }
