"""The ready autograder: unpacked as Gradescope unpacks it, it grades, and leaves a result that is
valid and honest whatever happens."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
import zipfile
from pathlib import Path
from typing import Any

import jsonschema
import pytest

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "grading"), str(ROOT / "grading" / "book")]

from reports.autograder import main as pack  # noqa: E402
from reports.autograder_run import MAX_FILES, _take  # noqa: E402
from wrong_answers import wrong_answer  # noqa: E402

Json = dict[str, Any]

EXERCISE = "02_triangles/ray_triangle"
SOLUTION = (ROOT / "solutions" / EXERCISE / "ray_triangle.cpp").read_text()
WRONG = wrong_answer(EXERCISE, "beta_sign").read_text()


@pytest.fixture(scope="module")
def archive(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("autograder") / "autograder.zip"
    assert pack([str(file), "--exercises", EXERCISE, "--seed", "violet-seed-31"]) == 0
    return file


@pytest.fixture
def unpacked(archive: Path, tmp_path: Path) -> Path:
    """/autograder as Gradescope makes it, before a submission."""
    root = tmp_path / "autograder"
    with zipfile.ZipFile(archive) as opened:
        for entry in opened.infolist():
            opened.extract(entry, root / "source")
            (root / "source" / entry.filename).chmod(entry.external_attr >> 16 & 0o777)
    shutil.copy2(root / "source" / "run_autograder", root / "run_autograder")
    (root / "submission").mkdir()
    return root


def run(root: Path, script: str = "run_autograder", **environment: str) -> str:
    """Runs it as the harness does, with this book, which is built, in place of the one in the
    archive."""
    done = subprocess.run(
        [str(root / script)],
        cwd=root,
        env={
            **os.environ,
            "AUTOGRADER_ROOT": str(root),
            "CONTACT_ROOT": str(ROOT),
            "GRADE_ROOT": str(root),
            **environment,
        },
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout + done.stderr


def result(root: Path, schema: str = "gradescope") -> Json:
    given: Json = json.loads((root / "results" / "results.json").read_text())
    jsonschema.validate(given, json.loads((HERE / "schemas" / f"{schema}.json").read_text()))
    return given


def test_the_archive_holds_what_gradescope_needs_at_its_root(archive: Path) -> None:
    with zipfile.ZipFile(archive) as opened:
        modes = {entry.filename: entry.external_attr >> 16 for entry in opened.infolist()}
        options = json.loads(opened.read("options.json"))
    for name in ("setup.sh", "run_autograder", "contact/contact"):
        assert modes[name] & 0o111, name
    assert options == {
        "format": "contact-autograder/1",
        "exercises": EXERCISE,
        "seed": "violet-seed-31",
    }
    for name in ("CMakeLists.txt", "grading/reports/results.schema.json", "docs/requirements.txt"):
        assert f"contact/{name}" in modes
    tracked = subprocess.run(
        ["git", "-C", str(ROOT), "ls-files"], capture_output=True, text=True, check=True
    ).stdout.split()
    needed = [name for name in tracked if not name.startswith(".")]
    assert {f"contact/{name}" for name in needed if (ROOT / name).is_file()} <= set(modes)
    assert not [name for name in modes if name.startswith(("contact/build/", "contact/work/"))]
    assert archive.stat().st_size < 10_000_000


def test_the_same_book_gives_the_same_archive(archive: Path, tmp_path: Path) -> None:
    again = tmp_path / "again.zip"
    assert pack([str(again), "--exercises", EXERCISE, "--seed", "violet-seed-31"]) == 0
    with zipfile.ZipFile(archive) as one, zipfile.ZipFile(again) as two:
        # Others may be at work on the book between the two.
        names = [name for name in one.namelist() if not name.startswith("contact/")]
        assert names == [name for name in two.namelist() if not name.startswith("contact/")]
        assert all(one.getinfo(n).date_time == two.getinfo(n).date_time for n in names)
        assert all(one.read(name) == two.read(name) for name in names)


@pytest.mark.parametrize("with_git", [True, False])
def test_only_the_book_is_packed_and_chapters_that_somebody_adds(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, with_git: bool
) -> None:
    book = tmp_path / "book"
    kept = [
        "contact",
        "grading/reports/x.py",
        "grading/build/x.cpp",
        "exercises/09_own/mine/mine.hpp",
    ]
    left = ["build/dev/x.o", "work/a.cpp", "submissions/ada/a.cpp", "results/students/ada/x.html"]
    for name in (*kept, *left, "grading/reports/__pycache__/x.pyc"):
        (book / name).parent.mkdir(parents=True, exist_ok=True)
        (book / name).write_text(name)
    (book / "grading" / "link.py").symlink_to("/etc/passwd")
    (book / ".gitignore").write_text("__pycache__/\n")
    if with_git:
        subprocess.run(["git", "init", "-q", str(book)], check=True)
    private = tmp_path / "private"
    private.mkdir()
    (private / "secret_test.cpp").write_text("secret")
    monkeypatch.setenv("CONTACT_ROOT", str(book))
    assert pack([str(tmp_path / "x.zip"), "--private", str(private)]) == 0
    with zipfile.ZipFile(tmp_path / "x.zip") as opened:
        names = {name for name in opened.namelist() if "/" in name}
    wanted = {f"contact/{name}" for name in (*kept, ".gitignore")}
    assert names == wanted | {"private/secret_test.cpp"}


def test_the_program_packs_it_too(tmp_path: Path) -> None:
    def contact(*words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [str(ROOT / "build" / "dev" / "bin" / "contact"), "grade", *words],
            cwd=tmp_path,
            env={**os.environ, "CONTACT_ROOT": str(ROOT)},
            capture_output=True,
            text=True,
            check=False,
        )

    settings = ["--exercises", "ray_triangle", "--due", "2026-06-02T00:00+02:00", "--accept-weak"]
    done = contact("--autograder", "a.zip", *settings, "--private", str(HERE / "private"))
    assert done.returncode == 0, done.stderr
    with zipfile.ZipFile(tmp_path / "a.zip") as opened:
        options = json.loads(opened.read("options.json"))
        assert f"private/{EXERCISE}/tests.toml" in opened.namelist()
    assert len(options.pop("seed")) == 32, "one for all who are graded with it"
    assert options == {
        "format": "contact-autograder/1",
        "exercises": EXERCISE,
        "due": "2026-06-01T22:00:00+00:00",
        "accept_weak": True,
    }
    assert contact("--autograder", "a.zip").returncode == 3
    assert contact("--autograder", "b.zip", "--due", "tomorrow").returncode == 2
    assert contact("--autograder", "b.zip", "--exercises", "no_such").returncode == 2
    assert contact("--autograder", "b.zip", "submissions").returncode == 2
    for words in (["submissions"], ["-o", "results"], []):
        assert contact(*words).returncode == 2
    assert not (tmp_path / "b.zip").exists()


def test_nothing_that_is_there_is_overwritten(
    archive: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = archive.read_bytes()
    assert pack([str(archive)]) == 3
    assert "there already" in capsys.readouterr().err
    assert archive.read_bytes() == before


@pytest.mark.parametrize("place", ["ray_triangle.cpp", "work/02_triangles/ray_triangle.cpp"])
def test_a_submission_is_graded(unpacked: Path, place: str) -> None:
    file = unpacked / "submission" / place
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(SOLUTION)
    said = run(unpacked)
    given = result(unpacked)
    assert given["score"] == 12, said
    assert all(test["status"] == "passed" for test in given["tests"])
    assert "violet-seed-31" not in json.dumps(given)


def test_a_wrong_answer_reads_its_hint(unpacked: Path) -> None:
    (unpacked / "submission" / "ray_triangle.cpp").write_text(WRONG)
    said = run(unpacked)
    given = result(unpacked)
    assert given["score"] < 12, said
    assert any("hint:" in test["output"] for test in given["tests"])


def test_prairielearn_grades_with_the_same_archive(unpacked: Path) -> None:
    student = unpacked / "student"
    student.mkdir()
    (student / "ray_triangle.cpp").write_text(SOLUTION)
    said = run(unpacked, "source/run_prairielearn", CONTACT_EXERCISES=EXERCISE)
    given = result(unpacked, "prairielearn")
    assert (given["gradable"], given["score"]) == (True, 1.0), said

    (student / "ray_triangle.cpp").write_text(SOLUTION.replace(";\n", "\n", 1))
    run(unpacked, "source/run_prairielearn")
    given = result(unpacked, "prairielearn")
    assert (given["gradable"], given["score"]) == (False, 0.0)
    assert "semicolon" in " ".join(given["format_errors"])


def test_when_grading_fails_the_student_is_told_that_it_is_no_mark(unpacked: Path) -> None:
    (unpacked / "submission" / "ray_triangle.cpp").write_text(SOLUTION)
    # setup.sh did not get as far as building the program.
    broken = unpacked / "source" / "contact"
    (broken / "build").mkdir()
    (broken / "build" / "venv").symlink_to(ROOT / "build" / "venv")
    said = run(unpacked, CONTACT_ROOT=str(broken))
    given = result(unpacked)
    assert "no mark" in given["output"]
    assert given["extra_data"]["graded"] is False
    assert "score" not in given
    assert "setup.sh did not build it" in said, "the teacher reads why"
    assert str(broken) not in json.dumps(given)


def test_when_not_even_python_is_there_a_result_is_left(unpacked: Path) -> None:
    said = run(unpacked, CONTACT_ROOT=str(unpacked / "source" / "contact"))
    given = result(unpacked)
    assert "no mark" in given["output"]
    assert given["extra_data"]["graded"] is False
    assert "score" not in given
    assert "did not start" in said
    (unpacked / "student").mkdir()
    run(unpacked, "source/run_prairielearn", CONTACT_ROOT=str(unpacked / "source" / "contact"))
    assert result(unpacked, "prairielearn")["gradable"] is False


def test_an_earlier_result_never_stands_for_a_later_submission(unpacked: Path) -> None:
    (unpacked / "results").mkdir()
    (unpacked / "results" / "results.json").write_text('{"score": 12}')
    run(unpacked, CONTACT_ROOT=str(unpacked / "source" / "contact"))
    assert "score" not in result(unpacked)


def test_a_grader_that_is_killed_leaves_no_mark(unpacked: Path, tmp_path: Path) -> None:
    (unpacked / "submission" / "ray_triangle.cpp").write_text(SOLUTION)
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    grader = subprocess.Popen(
        [str(unpacked / "run_autograder")],
        env={
            **os.environ,
            "AUTOGRADER_ROOT": str(unpacked),
            "CONTACT_ROOT": str(ROOT),
            "TMPDIR": str(scratch),
        },
        start_new_session=True,
    )
    try:
        while not (unpacked / "results" / "results.json").exists():
            assert grader.poll() is None
            time.sleep(0.005)
    finally:
        os.killpg(grader.pid, signal.SIGKILL)
        grader.wait()
    given = result(unpacked)
    assert given["extra_data"]["graded"] is False
    assert "no mark" in given["output"]


def test_links_and_special_files_are_handed_on_and_never_followed(tmp_path: Path) -> None:
    submission = tmp_path / "submission"
    deep = submission.joinpath(*["d"] * 60)
    deep.mkdir(parents=True)
    (submission / "link.cpp").symlink_to("/etc/passwd")
    (submission / "folder").symlink_to("/etc")
    os.mkfifo(submission / "pipe")
    (submission / "plain.cpp").write_text("int x;")
    taken = tmp_path / "taken"
    taken.mkdir()
    _take(submission, taken)
    copy = taken / "submission"
    assert (copy / "link.cpp").is_symlink()
    assert (copy / "folder").is_symlink()
    assert (copy / "pipe").is_fifo()
    assert (copy / "plain.cpp").read_text() == "int x;"
    assert not copy.joinpath(*["d"] * 50).exists()


def test_one_archive_is_handed_on_as_it_is(tmp_path: Path) -> None:
    submission = tmp_path / "submission"
    submission.mkdir()
    (submission / "contact-work-2026-06-01.zip").write_bytes(b"PK not really")
    taken = tmp_path / "taken"
    taken.mkdir()
    _take(submission, taken)
    assert (taken / "submission.zip").read_bytes() == b"PK not really"


def test_a_flood_of_files_is_cut_where_it_is_refused_anyway(tmp_path: Path) -> None:
    submission = tmp_path / "submission"
    submission.mkdir()
    for number in range(MAX_FILES + 200):
        (submission / f"f{number}").touch()
    taken = tmp_path / "taken"
    taken.mkdir()
    _take(submission, taken)
    assert len(list((taken / "submission").iterdir())) == MAX_FILES
