"""The chapter for instructors says what is so: its commands, what they print, limits and files."""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import subprocess
import zipfile
from pathlib import Path
from typing import Any

import pytest
from wrong_answers import wrong_answer

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build" / "dev" / "bin" / "contact"
EXERCISE = "02_triangles/ray_triangle"
PAGE = (ROOT / "docs" / "grading.md").read_text()
CONSOLE = re.findall(r"^```console\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL)
COMMANDS = [line[2:] for block in CONSOLE for line in block.splitlines() if line.startswith("$ ")]

Result = subprocess.CompletedProcess[str]


def contact(folder: Path, *words: str) -> Result:
    return subprocess.run(
        [str(PROGRAM), *words],
        capture_output=True,
        text=True,
        env={**os.environ, "CONTACT_ROOT": str(ROOT)},
        cwd=folder,
        timeout=600,
        check=False,
    )


def run(folder: Path, command: str) -> Result:
    """A command of the page; ./contact hands it to the program."""
    words = shlex.split(command)
    if words[0] != "./contact":
        return subprocess.run(words, cwd=folder, capture_output=True, text=True, check=True)
    return contact(folder, *words[1:])


@pytest.fixture(scope="module")
def graded(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[Result]]:
    """The class of the page: one is right, one has a sign wrong, one does not compile; then that
    one hands in again, and all are graded with private tests."""
    folder = tmp_path_factory.mktemp("class")
    solution = (ROOT / "solutions" / EXERCISE / "ray_triangle.cpp").read_text()
    submissions = folder / "submissions"
    ada = submissions / "ada" / f"{EXERCISE}.cpp"
    ada.parent.mkdir(parents=True)
    ada.write_text(solution)
    with zipfile.ZipFile(submissions / "ben.zip", "w") as archive:
        wrong = wrong_answer(EXERCISE, "beta_sign")
        archive.writestr(f"{EXERCISE}.cpp", wrong.read_text())
    cy = submissions / "cy_ray_triangle.cpp"
    cy.write_text(solution.replace("return", "retrun"))
    shutil.copytree(Path(__file__).parent / "private", folder / "private")

    ran = [run(folder, COMMANDS[0])]
    cy.write_text(solution)
    private = next(i for i, command in enumerate(COMMANDS) if "--private" in command)
    run(folder, COMMANDS[private - 1])
    ran.append(run(folder, COMMANDS[private]))
    return folder, ran


def test_the_first_command_prints_what_the_page_shows(graded: tuple[Path, list[Result]]) -> None:
    first = graded[1][0]
    assert first.returncode == 0, first.stderr
    # The page's machine enforces everything; what another does not is said in lines of its own.
    said = re.sub(r"Not enforced on this machine:\n(  .*\n)+", "", first.stdout)
    assert said.splitlines() == CONSOLE[0].splitlines()[1:]


def test_the_second_moves_the_marks_that_the_page_shows(
    graded: tuple[Path, list[Result]],
) -> None:
    again = graded[1][1]
    assert again.returncode == 0, again.stderr
    shown = re.search(r"^```text\n(\d+ marks moved:\n.*?)^```", PAGE, re.MULTILINE | re.DOTALL)
    assert shown
    assert shown[1] in again.stdout


def test_every_option_exists() -> None:
    helped: dict[str, str] = {}
    for command in COMMANDS:
        words = shlex.split(command)
        if words[0] != "./contact" or words[1] in ("setup", "serve", "test"):
            continue
        name = words[1]
        helped.setdefault(name, contact(ROOT, name, "--help").stdout)
        for word in words[2:]:
            if word.startswith("-"):
                assert re.search(rf"(^|[\s,]){re.escape(word)}\b", helped[name]), command
    options = set(re.findall(r"`(--[a-z-]+)", PAGE))
    for option in options:
        assert any(option in text for text in helped.values()), option


def rows(heading: str) -> list[list[str]]:
    """The cells of the table under a heading, without its head."""
    section = PAGE.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    lines = [line for line in section.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split(" | ")] for line in lines[2:]]


def test_the_table_of_limits_is_the_graders(graded: tuple[Path, list[Result]]) -> None:
    results: dict[str, Any] = json.loads((graded[0] / "marks" / "results.json").read_text())
    shown = {row[0].strip("`"): float(row[1]) for row in rows("Limits")}
    assert shown == {name: float(value) for name, value in results["limits"].items()}


def test_the_profile_of_the_page_is_understood(
    graded: tuple[Path, list[Result]], tmp_path: Path
) -> None:
    profile = re.search(r"^```toml\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL)
    assert profile
    file = tmp_path / "slow-machine.toml"
    file.write_text(profile[1])
    results = tmp_path / "marks"
    words = ["--exercises", "ray_triangle", "--profile", str(file), "--formats", "gradebook"]
    ran = contact(tmp_path, "grade", str(graded[0] / "submissions"), "-o", str(results), *words)
    assert ran.returncode == 0, ran.stderr
    limits = json.loads((results / "results.json").read_text())["limits"]
    assert limits["memory_mb"] == 1024
    assert limits["test_cpu_seconds"] == 20


def test_every_file_that_is_written_is_in_the_table(
    graded: tuple[Path, list[Result]],
) -> None:
    marks = graded[0] / "marks"
    patterns = [
        re.compile(
            re.escape(row[0].strip("`")).replace("ID", "[^/]+")
            + ("" if "." in row[0].rpartition("/")[2] else ".*")
        )
        for row in rows("What is written")
    ]
    written = [str(file.relative_to(marks)) for file in marks.rglob("*") if file.is_file()]
    assert len(written) > 20
    for name in written:
        assert any(pattern.fullmatch(name) for pattern in patterns), name
    for pattern in patterns:
        assert any(pattern.fullmatch(name) for name in written), pattern.pattern


def test_visibilities_are_the_graders() -> None:
    named = {row[0].strip('`"') for row in rows("What a student sees")}
    source = (ROOT / "grading" / "book" / "book.cpp").read_text()
    assert named == set(re.findall(r'\{Visibility::\w+, "(\w+)"\}', source))
