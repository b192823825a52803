"""start, reset, hint, solution, list and progress: the student's copies and record."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

Run = Callable[..., subprocess.CompletedProcess[str]]
ROOT = Path(__file__).resolve().parents[2]
COMMANDS = ["list", "start", "check", "watch", "hint", "solution", "reset", "ask", "progress"]
COMMANDS += ["export", "import", "ladder", "new", "doctor", "dev"]
STUB = (ROOT / "exercises/02_triangles/ray_triangle/ray_triangle.cpp").read_text()


def test_start_copies_the_stub(contact: Run, work: Path) -> None:
    done = contact("start", "ray_triangle")
    assert done.returncode == 0
    assert (work / "02_triangles/ray_triangle.cpp").read_text() == STUB


def test_start_never_overwrites(contact: Run, answer: Callable[[str], Path]) -> None:
    copy = answer("// mine\n")
    done = contact("start", "02_triangles/ray_triangle")
    assert done.returncode == 0
    assert "was not changed" in done.stdout
    assert copy.read_text() == "// mine\n"


def test_start_with_gaps_fails_to_compile_until_they_are_filled(
    contact: Run, work: Path, solution: str, marked: str
) -> None:
    assert contact("start", "ray_triangle", "--form", "fill").returncode == 0
    copy = work / "02_triangles/ray_triangle.cpp"
    text = copy.read_text()
    assert "/* gap 1 */" in text
    assert "//?" not in text
    assert "does not compile" in contact("check", "ray_triangle").stdout
    marks = [line.strip() for line in marked.splitlines() if line.lstrip().startswith("//?")]
    gaps = [line.removeprefix("//? gap: ") for line in marks if line.startswith("//? gap: ")]
    for number, gap in enumerate(gaps, 1):
        text = text.replace(f"/* gap {number} */", gap)
    copy.write_text(text)
    assert contact("check", "ray_triangle").returncode == 0
    record = json.loads((work / "progress.json").read_text())
    assert list(record["exercises"]["02_triangles/ray_triangle"]["passed_as"]) == ["fill"]
    assert "02_triangles/ray_triangle (fill)" in contact("progress").stdout
    # After a reset it is written from the stub.
    contact("reset", "ray_triangle")
    copy.write_text(solution)
    assert contact("check", "ray_triangle").returncode == 0
    record = json.loads((work / "progress.json").read_text())
    assert set(record["exercises"]["02_triangles/ray_triangle"]["passed_as"]) == {"fill", "write"}
    assert "Not written from the stub" not in contact("progress").stdout


def test_start_with_lines_to_order_is_not_attempted(contact: Run, work: Path) -> None:
    assert contact("start", "ray_triangle", "--form", "order").returncode == 0
    text = (work / "02_triangles/ray_triangle.cpp").read_text()
    assert "contact::todo();" in text
    # A line of a wrong answer, among those of the solution.
    assert "//   if (std::abs(det) < 1e-8) return std::nullopt;" in text
    done = contact("check", "ray_triangle", "--json")
    assert json.loads(done.stdout)["results"][0]["verdict"] == "not_attempted"


def test_start_in_a_form_never_overwrites(contact: Run, answer: Callable[[str], Path]) -> None:
    copy = answer("// mine\n")
    assert "was not changed" in contact("start", "ray_triangle", "--form", "fill").stdout
    assert copy.read_text() == "// mine\n"


def test_an_exercise_without_marks_can_only_be_written(contact: Run, work: Path) -> None:
    done = contact("start", "first_hit", "--form", "order")
    assert done.returncode != 0
    assert "can only be written" in done.stderr
    assert not (work / "02_triangles/first_hit.cpp").exists()


def test_the_solution_is_shown_without_its_marks(contact: Run, marked: str) -> None:
    shown = contact("solution", "ray_triangle", "--give-up").stdout
    assert "//?" in marked
    assert "//?" not in shown
    assert "if (det == 0) return std::nullopt;" in shown


def test_start_takes_a_chapter(contact: Run, work: Path) -> None:
    assert contact("start", "02_triangles").returncode == 0
    names = {copy.stem for copy in (work / "02_triangles").iterdir()}
    assert names == {folder.name for folder in (ROOT / "exercises/02_triangles").iterdir()}


def test_reset_keeps_a_copy(contact: Run, work: Path, answer: Callable[[str], Path]) -> None:
    copy = answer("// first\n")
    assert contact("reset", "ray_triangle").returncode == 0
    assert copy.read_text() == STUB
    copy.write_text("// second\n")
    done = contact("reset", "ray_triangle")
    kept = sorted((work / ".kept/02_triangles").iterdir())
    assert {file.read_text() for file in kept} == {"// first\n", "// second\n"}
    assert any(file.name in done.stdout for file in kept)


def test_reset_of_a_pristine_copy_keeps_nothing(contact: Run, work: Path) -> None:
    contact("start", "ray_triangle")
    assert contact("reset", "ray_triangle").returncode == 0
    assert not (work / ".kept").exists()


def test_hints_come_one_at_a_time(contact: Run) -> None:
    first = contact("hint", "ray_triangle").stdout
    second = contact("hint", "ray_triangle").stdout
    assert "Hint 1 of" in first
    assert "Hint 2 of" in second
    again = contact("hint", "ray_triangle", "--again").stdout
    assert "Hint 1 of" in again
    assert "Hint 2 of" in again
    assert "Hint 3 of" not in again


def test_the_solution_opens_after_passing(
    contact: Run, solution: str, answer: Callable[[str], Path]
) -> None:
    shut = contact("solution", "ray_triangle")
    assert shut.returncode == 1
    assert shut.stdout == ""
    answer(solution)
    assert contact("check", "ray_triangle").returncode == 0
    opened = contact("solution", "ray_triangle")
    assert opened.returncode == 0
    assert opened.stdout.strip() == solution.strip()


def test_the_solution_opens_for_who_gives_up(contact: Run, solution: str) -> None:
    assert contact("solution", "ray_triangle", "--give-up").stdout.strip() == solution.strip()
    record = json.loads(contact("progress", "--json").stdout)
    assert record["exercises"]["02_triangles/ray_triangle"]["solution_shown"] is True


def test_list_says_how_far_each_has_come(
    contact: Run, solution: str, answer: Callable[[str], Path]
) -> None:
    def status() -> str:
        document = json.loads(contact("list", "--json").stdout)
        assert document["format"] == "contact-list/1"
        entries = {e["id"]: e for chapter in document["chapters"] for e in chapter["exercises"]}
        return str(entries["02_triangles/ray_triangle"]["status"])

    assert status() == "not_started"
    contact("start", "ray_triangle")
    assert status() == "started"
    answer(solution)
    contact("check", "ray_triangle")
    assert status() == "passed"


def test_progress_counts_attempts_and_keeps_the_best(
    contact: Run, solution: str, spoiled: Callable[[str], str], answer: Callable[[str], Path]
) -> None:
    answer(solution)
    contact("check", "ray_triangle")
    answer(spoiled("return std::nullopt;"))
    contact("check", "ray_triangle")
    answer("does not compile")
    contact("check", "ray_triangle")
    answer(STUB)
    contact("check", "ray_triangle")
    record = json.loads(contact("progress", "--json").stdout)
    entry = record["exercises"]["02_triangles/ray_triangle"]
    assert entry["attempts"] == 2
    assert entry["best_points"] == entry["max_points"]
    assert entry["passed"]


@pytest.mark.parametrize("broken", ["{", "[]", '{"format": "other"}', '{"exercises": {"a": 1}}'])
def test_a_broken_record_is_kept_aside(contact: Run, work: Path, broken: str) -> None:
    work.mkdir()
    (work / "progress.json").write_text(broken)
    done = contact("hint", "ray_triangle")
    assert done.returncode == 0
    assert "kept as" in done.stderr
    (aside,) = work.glob("progress.json.broken-*")
    assert aside.read_text() == broken
    assert json.loads((work / "progress.json").read_text())["format"] == "contact-progress/1"


def test_what_others_wrote_into_the_record_stays(contact: Run, work: Path) -> None:
    work.mkdir()
    record = {"format": "contact-progress/1", "exercises": {}, "questions": {"00/a": "right"}}
    (work / "progress.json").write_text(json.dumps(record))
    contact("hint", "ray_triangle")
    assert json.loads((work / "progress.json").read_text())["questions"] == {"00/a": "right"}


def test_a_wrong_name_is_a_usage_error_that_helps(contact: Run) -> None:
    done = contact("start", "ray_triangel")
    assert done.returncode == 2
    assert "ray_triangle" in done.stderr


@pytest.mark.parametrize("words", [["start"], ["watch"], ["export", "a.zip"], ["dev", "check"]])
def test_a_misspelt_chapter_is_told_the_nearest(contact: Run, words: list[str]) -> None:
    done = contact(*words, "02_triangels")
    assert done.returncode == 2
    assert "no exercise or chapter called '02_triangels'" in done.stderr
    assert "02_triangles" in done.stderr


def test_a_name_like_no_exercise_of_its_chapter_is_told_all_of_them(contact: Run) -> None:
    done = contact("check", "08_convex_hull/turn")
    assert done.returncode == 2
    names = "orientation, hull_2d, wrap_step, hull_vertices and break_angles"
    assert f"The exercises of 08_convex_hull are {names}." in done.stderr
    assert "Did you mean" not in done.stderr
    done = contact("check", "08_convex_hull/hul2d")
    assert "Did you mean 08_convex_hull/hull_2d?" in done.stderr
    done = contact("check", "98_nowhere/turn")
    assert "The exercise" not in done.stderr


@pytest.mark.parametrize(
    "words", [[], ["nonsense"], ["list", "--nonsense"], ["start"], ["new", "chapter", "polygons"]]
)
def test_usage_errors(contact: Run, words: list[str]) -> None:
    assert contact(*words).returncode == 2


@pytest.mark.parametrize("size", ["-3", "0", "many"])
def test_a_number_that_cannot_be_is_named(contact: Run, size: str) -> None:
    done = contact("ladder", "triangles", "--size", size)
    assert done.returncode == 2
    assert f"--size: {size} is not a whole number from 1" in done.stderr


def test_outside_the_book_is_trouble(contact: Run, tmp_path: Path) -> None:
    assert contact("list", CONTACT_ROOT=str(tmp_path)).returncode == 3


@pytest.mark.parametrize(
    "words",
    [
        [],
        *[[command] for command in COMMANDS],
        ["dev", "check"],
        ["new", "chapter"],
        ["new", "exercise"],
    ],
)
def test_every_command_has_help(contact: Run, words: list[str]) -> None:
    done = contact(*words, "--help")
    assert done.returncode == 0
    assert "Usage" in done.stdout


def test_help_says_the_exit_codes(contact: Run) -> None:
    text = contact("--help").stdout
    for word in ("serve", "test", "setup", "130", "NO_COLOR", "CONTACT_WORK"):
        assert word in text
