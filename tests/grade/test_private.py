"""Tests that are not in the book: read, checked, compiled, run, and kept from whom they grade."""

from __future__ import annotations

import json
import os
import shutil
import stat
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from reach import skip_if_closed
from wrong_answers import wrong_answer

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build" / "dev" / "bin" / "contact"
EXERCISE = "02_triangles/ray_triangle"
HERE = Path(__file__).resolve().parent / "private"
TEST = "ray_triangle_test.cpp"
FIRST = "a ray hits where it passes inside the triangle and misses beside it"
THIN = "a long thin triangle is hit like any other"
FAR = "rays from far away agree with exact arithmetic"

SOLUTION = (ROOT / "solutions" / EXERCISE / "ray_triangle.cpp").read_text()
# Right as far as the book's own tests look: they stay within a few lengths of the direction.
SHORT_SIGHTED = SOLUTION.replace("ray_triangle(", "whole(", 1) + (
    "\nnamespace exercise {\nstd::optional<contact::TriangleHit<double>> ray_triangle(\n"
    "    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {\n"
    "  const auto hit = whole(ray, triangle);\n"
    "  return hit && hit->t > 50 && hit->t < 1e6 ? std::nullopt : hit;\n}\n}\n"
)
BETA_SIGN = wrong_answer(EXERCISE, "beta_sign").read_text()

Result = subprocess.CompletedProcess[str]
Grade = Callable[..., Result]


@pytest.fixture
def private(tmp_path: Path) -> Path:
    return private_in(tmp_path)


def private_in(folder: Path) -> Path:
    private = folder / "private"
    shutil.copytree(HERE, private)
    private.chmod(0o700)
    return private


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    folder = tmp_path / "submissions"
    hand_in(folder, "careful", SOLUTION)
    return folder


def hand_in(folder: Path, student: str, text: str) -> None:
    file = folder / student / f"{EXERCISE}.cpp"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)


@pytest.fixture
def grade(tmp_path: Path, submissions: Path, private: Path) -> Grade:
    return grade_in(tmp_path, submissions, private)


def grade_in(folder: Path, submissions: Path, private: Path) -> Grade:
    def run(*words: str, **environment: str) -> Result:
        return subprocess.run(
            [
                *[str(PROGRAM), "grade", str(submissions), "-o", str(folder / "results")],
                *["--exercises", EXERCISE, "--private", str(private), *words],
            ],
            capture_output=True,
            text=True,
            env={**os.environ, "CONTACT_ROOT": str(ROOT), **environment},
            cwd=folder,
            stdin=subprocess.DEVNULL,
            timeout=600,
            check=False,
        )

    return run


@pytest.fixture(scope="module")
def three(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Grade]:
    """Three different students, graded: the folder, and a function that writes the reports
    again."""
    folder = tmp_path_factory.mktemp("three")
    submissions = folder / "submissions"
    for student, text in {
        "careful": SOLUTION,
        "short-sighted": SHORT_SIGHTED,
        "mistaken": BETA_SIGN,
    }.items():
        hand_in(submissions, student, text)
    grade = grade_in(folder, submissions, private_in(folder))
    result = grade()
    assert result.returncode == 0, result.stdout + result.stderr
    return folder, grade


def results(folder: Path) -> dict[str, Any]:
    loaded: dict[str, Any] = json.loads((folder / "results" / "results.json").read_text())
    return loaded


def unit_of(folder: Path, student: str) -> dict[str, Any]:
    for submission in results(folder)["submissions"]:
        if submission["id"] == student:
            unit: dict[str, Any] = submission["exercises"][0]
            return unit
    raise AssertionError(student)


def judged(folder: Path, student: str) -> dict[str, dict[str, Any]]:
    return {test["name"]: test for test in unit_of(folder, student)["verdict"]["tests"]}


def edit(file: Path, old: str, new: str) -> None:
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new, 1))


def said(result: Result) -> str:
    return " ".join((result.stdout + result.stderr).split())


# ---- What they are worth


def test_private_tests_count_after_the_books_own(three: tuple[Path, Grade]) -> None:
    folder, _ = three
    listed = results(folder)["exercises"][0]
    assert [test["name"] for test in listed["tests"]][-2:] == [THIN, FAR]
    assert [test["private"] for test in listed["tests"]].count(True) == 2
    by_name = {test["name"]: test for test in listed["tests"]}
    assert by_name[THIN]["visibility"] == "after_due"
    assert by_name[FAR]["visibility"] == "hidden"
    assert by_name[FIRST]["visibility"] == "shown"
    public = sum(test["points"] for test in listed["tests"] if not test["private"])
    assert listed["max_points"] == public + 5

    careful = unit_of(folder, "careful")
    assert careful["points"] == careful["max_points"] == public + 5

    far = judged(folder, "short-sighted")[FAR]
    assert far["status"] == "failed"
    assert unit_of(folder, "short-sighted")["points"] == public + 2
    # The instructor's record has everything.
    assert far["failure"]["inputs"]
    assert far["failure"]["right"]

    # What a private test requires may be the book's.
    mistaken = judged(folder, "mistaken")
    assert mistaken[FIRST]["status"] == "failed"
    assert mistaken[THIN]["status"] == "skipped"
    assert mistaken[THIN]["points"] == 0


def test_no_student_reads_what_is_hidden(three: tuple[Path, Grade]) -> None:
    folder, grade = three
    assert grade("--due", "2999-01-01T00:00").returncode == 0
    failure = judged(folder, "short-sighted")[FAR]["failure"]
    secrets = [FAR, *(given["text"] for given in failure["inputs"]), failure["right"]]
    files = [file for file in (folder / "results" / "students").rglob("*") if file.is_file()]
    assert len({file.parent.name for file in files}) == 3
    for file in files:
        text = file.read_text()
        for secret in secrets:
            assert secret not in text, f"{file}: {secret}"
            assert json.dumps(secret)[1:-1] not in text, f"{file}: {secret}"


def test_what_is_shown_after_the_due_date(three: tuple[Path, Grade]) -> None:
    folder, grade = three
    report = folder / "results" / "students" / "mistaken" / "report.html"
    why_skipped = f"it counts once this passes: {FIRST}"
    assert grade("--due", "2999-01-01T00:00").returncode == 0
    assert why_skipped not in report.read_text()
    assert grade("--due", "2001-01-01T00:00").returncode == 0
    assert why_skipped in report.read_text()
    assert FAR not in report.read_text()


# ---- Programs are kept, and made again when they must be


def test_what_has_not_changed_is_not_compiled_again(
    grade: Grade, private: Path, submissions: Path, tmp_path: Path
) -> None:
    hand_in(submissions, "short-sighted", SHORT_SIGHTED)
    first = grade()
    assert first.returncode == 0
    assert "Compiling the private tests of 02_triangles/ray_triangle" in first.stderr
    program = tmp_path / "results" / ".grade" / "private" / "02_triangles.ray_triangle" / "asks"
    # The user of a box may run it and not read it.
    assert stat.S_IMODE(program.stat().st_mode) == 0o711
    made = program.stat().st_mtime_ns
    again = grade()
    assert again.returncode == 0
    assert "Compiling the private tests" not in again.stderr
    assert program.stat().st_mtime_ns == made

    # An answer of the book's that passed now fails a private test that asks for more.
    edit(private / EXERCISE / TEST, "{number(), number(), -8}, 100)", "{0, 0, -8}, 1)")
    changed = grade()
    assert changed.returncode == 0
    assert "Compiling the private tests" in changed.stderr
    changes = json.loads((tmp_path / "results" / "changes.json").read_text())["changes"]
    assert [(change["submission"], change["why"]) for change in changes] == [
        ("short-sighted", ["tests"])
    ]
    assert changes[0]["after"] == changes[0]["before"] + 3


def test_other_points_are_another_mark_without_compiling(
    grade: Grade, private: Path, tmp_path: Path
) -> None:
    assert grade().returncode == 0
    before = unit_of(tmp_path, "careful")["points"]
    edit(private / EXERCISE / "tests.toml", "points = 3", "points = 4.5")
    result = grade()
    assert result.returncode == 0
    assert "Compiling the private tests" not in result.stderr
    assert unit_of(tmp_path, "careful")["points"] == before + 1.5


# ---- What is wrong with them is said

TOML = f"{EXERCISE}/tests.toml"


def a_test(**members: object) -> str:
    return "\n[[tests]]\n" + "".join(f"{k} = {json.dumps(v)}\n" for k, v in members.items())


@pytest.mark.parametrize(
    ("file", "old", "new", "sentence"),
    [
        (TOML, f'name = "{FAR}"', 'name = "another"', f"does not list the test '{FAR}'"),
        (TOML, "", a_test(name="nowhere", points=1), "lists the test 'nowhere', which no"),
        (TOML, f'name = "{FAR}"', f'name = "{FIRST}"', "the book's count too"),
        (TOML, f'name = "{FAR}"', f'name = "{THIN}"', "more than one test called"),
        (TOML, "points = 3", "points = 0", "needs points, a number above zero"),
        (TOML, "points = 3", "points = nan", "needs points, a number above zero"),
        (TOML, "points = 3", "worth = 3", "a test has no 'worth'"),
        (TOML, "points = 3", "points = 3\nrequires = ['no such']", "does not exist: 'no such'"),
        (TOML, "after_due", "never", "tests.toml:5: visibility is"),
        (TOML, "points = 3", "points = [", "tests.toml:"),
        (f"{EXERCISE}/{TEST}", "within(1e-9)", "within(1e-9", "does not compile"),
        (f"{EXERCISE}/{TEST}", "within(1e-9)", "within(1e-9", "error: expected"),
        (
            f"{EXERCISE}/{TEST}",
            "  generators::Random",
            "  void gone();\n  gone();\n  generators::Random",
            "do not link",
        ),
    ],
)
def test_what_is_wrong_is_said(
    file: str, old: str, new: str, sentence: str, grade: Grade, private: Path, tmp_path: Path
) -> None:
    if old:
        edit(private / file, old, new)
    else:
        with (private / file).open("a") as toml:
            toml.write(new)
    result = grade()
    assert result.returncode == 3, said(result)
    assert sentence in said(result)
    assert str(private) in said(result)
    assert not (tmp_path / "results" / "results.json").exists()


def test_what_the_compiler_says_of_a_macro_is_said_once(grade: Grade, private: Path) -> None:
    file = private / EXERCISE / TEST
    head = f'TEST_CASE("{THIN}") {{\n'
    edit(file, head, head + "  CHECK(gone(1) == 2);\n  CHECK(missing(1) == 2);\n")
    result = grade()
    assert result.returncode == 3
    assert result.stderr.count("CHECK(gone(1) == 2);") == 1
    assert result.stderr.count("gone’ was not declared") == 1
    assert result.stderr.count("missing’ was not declared") == 1


def test_a_folder_that_is_of_no_exercise(grade: Grade, private: Path) -> None:
    (private / EXERCISE).rename(private / "02_triangles" / "ray_triangel")
    result = grade()
    assert result.returncode == 3
    assert "there is no exercise 02_triangles/ray_triangel" in said(result)
    assert "did you mean 02_triangles/ray_triangle?" in said(result)


@pytest.mark.parametrize(
    ("gone", "sentence"),
    [
        (TOML, "has no tests.toml"),
        (f"{EXERCISE}/{TEST}", "has no ray_triangle_test.cpp"),
        ("02_triangles", "holds no tests"),
        (".", "there is no such folder"),
    ],
)
def test_what_is_missing_is_said(gone: str, sentence: str, grade: Grade, private: Path) -> None:
    path = private / gone
    if path.is_dir():
        shutil.rmtree(path)
    else:
        path.unlink()
    result = grade()
    assert result.returncode == 3
    assert sentence in said(result)


def test_a_source_that_would_be_passed_over_is_named(grade: Grade, private: Path) -> None:
    (private / EXERCISE / "more.cpp").write_text("// never compiled\n")
    result = grade()
    assert result.returncode == 3
    assert "call it more_test.cpp" in said(result)


def test_several_files_are_one_set_of_tests(grade: Grade, private: Path, tmp_path: Path) -> None:
    folder = private / EXERCISE
    text = (folder / TEST).read_text()
    cut = text.index(f'TEST_CASE("{FAR}")')
    head = text[: text.index(f'TEST_CASE("{THIN}")')]
    (folder / TEST).write_text(text[:cut])
    (folder / "shared.hpp").write_text(head)
    (folder / "far_test.cpp").write_text('#include "shared.hpp"\n' + text[cut:])
    assert grade().returncode == 0
    careful = unit_of(tmp_path, "careful")
    assert careful["points"] == careful["max_points"]


def test_a_solution_that_fails_a_private_test_stops_the_grading(
    grade: Grade, private: Path, tmp_path: Path
) -> None:
    edit(
        private / EXERCISE / TEST,
        "exact::exact_hit(ray, triangle)",
        "std::optional<contact::TriangleHit<double>>{}",
    )
    result = grade()
    assert result.returncode == 3
    assert EXERCISE in said(result)
    assert THIN in said(result)
    assert not (tmp_path / "results" / "results.json").exists()


# ---- They are kept from whom they grade


def test_a_folder_inside_the_submissions_is_refused(
    grade: Grade, private: Path, submissions: Path
) -> None:
    inside = submissions / "private"
    shutil.move(private, inside)
    private.symlink_to(inside)
    result = grade()
    assert result.returncode == 3
    assert "is inside" in said(result)


@pytest.mark.parametrize("level", ["", "reduced"])
def test_no_submission_reads_them_while_it_is_compiled(
    level: str, grade: Grade, private: Path, submissions: Path, tmp_path: Path
) -> None:
    if level == "reduced":
        skip_if_closed()
    test = private / EXERCISE / TEST
    hand_in(submissions, "includes", f'{SOLUTION}\n#include "{test}"\n')
    hand_in(
        submissions,
        "assembles",
        f'{SOLUTION}\nasm(".section .rodata\\n.incbin \\"{test}\\"\\n.text\\n");\n',
    )
    result = grade(**({"CONTACT_BOX_LEVEL": level} if level else {}))
    assert result.returncode == 0, said(result)
    for student in ("includes", "assembles"):
        unit = unit_of(tmp_path, student)
        assert unit["verdict"]["verdict"] == "does_not_compile"
        assert unit["points"] == 0
        # Its own line is in the message, and nothing of the file.
        assert "aimed" not in json.dumps(unit)


# A kernel without Landlock, which else closes all files to a box at level reduced: the system call
# that begins it fails as on one that does not know it.
WITHOUT_LANDLOCK = """
import ctypes, os, sys
seccomp = ctypes.CDLL("libseccomp.so.2")
seccomp.seccomp_init.restype = ctypes.c_void_p
allow, fail_as_unknown, landlock_create_ruleset = 0x7FFF0000, 0x00050000 | 38, 444
rules = ctypes.c_void_p(seccomp.seccomp_init(allow))
assert seccomp.seccomp_rule_add(rules, fail_as_unknown, landlock_create_ruleset, 0) == 0
assert seccomp.seccomp_load(rules) == 0
os.execv(sys.argv[1], sys.argv[1:])
"""


def test_tests_that_a_submission_could_read_are_refused(
    private: Path, submissions: Path, tmp_path: Path
) -> None:
    """There nothing but the rights of users keeps a submission's compiler from them."""
    skip_if_closed()
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place) / "private"
        shutil.copytree(private, folder)

        def grade(*words: str) -> Result:
            return subprocess.run(
                [
                    *[sys.executable, "-c", WITHOUT_LANDLOCK, str(PROGRAM), "grade"],
                    *[str(submissions), "-o", str(tmp_path / "results")],
                    *["--exercises", EXERCISE, "--private", str(folder), *words],
                ],
                capture_output=True,
                text=True,
                env={**os.environ, "CONTACT_ROOT": str(ROOT), "CONTACT_BOX_LEVEL": "reduced"},
                timeout=600,
                check=False,
            )

        Path(place).chmod(0o755)
        folder.chmod(0o755)
        refused = grade()
        assert refused.returncode == 3
        if os.geteuid() != 0:  # submissions are compiled as whoever grades
            assert "Grade as root" in said(refused)
            return
        assert f"chmod o-rwx {folder}" in said(refused)
        folder.chmod(0o750)
        assert grade().returncode == 0
        folder.chmod(0o755)
        assert grade("--accept-weak").returncode == 0
