"""What a student sees of a test: everything, or, where exercise.toml says so, none of its values:
neither the input nor what came back nor what is right."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from wrong_answers import wrong_answer

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build" / "dev" / "bin" / "contact"
EXERCISE = "02_triangles/ray_triangle"
FIRST = 'name = "a ray hits where it passes inside the triangle and misses beside it"\n'

Result = subprocess.CompletedProcess[str]
Contact = Callable[..., Result]


@pytest.fixture
def book(tmp_path: Path) -> Path:
    """The book, of which exercises/ may be changed; the rest is the real one."""
    root = tmp_path / "book"
    root.mkdir()
    for name in ("build", "chapters", "cli", "grading", "solutions", "tests"):
        (root / name).symlink_to(ROOT / name)
    shutil.copytree(ROOT / "exercises", root / "exercises")
    return root


@pytest.fixture
def contact(book: Path, tmp_path: Path) -> Contact:
    def run(*words: str) -> Result:
        environment = {
            **os.environ,
            "CONTACT_ROOT": str(book),
            "CONTACT_WORK": str(tmp_path / "work"),
        }
        return subprocess.run(
            [str(PROGRAM), *words],
            capture_output=True,
            text=True,
            env=environment,
            cwd=tmp_path,
            timeout=600,
            check=False,
        )

    return run


def say(book: Path, line: str) -> int:
    """Adds a line to the first test of ray_triangle, and returns its number."""
    toml = book / "exercises" / EXERCISE / "exercise.toml"
    text = toml.read_text()
    assert FIRST in text
    toml.write_text(text.replace(FIRST, FIRST + line + "\n"))
    return toml.read_text().splitlines().index(line) + 1


def first_test(result: Result) -> dict[str, Any]:
    test: dict[str, Any] = json.loads(result.stdout)["results"][0]["tests"][0]
    return test


WRONG = str(wrong_answer(EXERCISE, "beta_sign"))


def test_a_test_shows_its_values_unless_it_is_told_not_to(contact: Contact) -> None:
    shown = first_test(contact("check", WRONG, "--json"))
    assert shown["status"] == "failed"
    assert "visibility" not in shown
    assert [given["name"] for given in shown["failure"]["inputs"]] == ["ray", "triangle"]
    assert shown["failure"]["right"]


def test_withheld_values_are_nowhere(book: Path, contact: Contact) -> None:
    shown = first_test(contact("check", WRONG, "--json"))["failure"]
    say(book, 'visibility = "values_withheld"')
    result = contact("check", WRONG, "--json")
    test = first_test(result)
    assert test["status"] == "failed"
    assert test["visibility"] == "values_withheld"
    failure = test["failure"]
    assert failure["asked"] == shown["asked"]
    assert failure["hint"] == shown["hint"]
    assert failure["inputs"] == []
    assert "got" not in failure
    assert "right" not in failure
    assert "allowed" not in failure

    printed = contact("check", WRONG, "--all").stdout
    assert "this test does not show its values" in printed
    own = printed.split(test["name"] + "\n")[2].split("\n\n")[0]
    assert "asked" in own
    assert "hint" in own
    for word in ("input", "got", "right", "allowed"):
        assert f"    {word}" not in own
    # The exercise's other tests show theirs.
    assert "    right" in printed.replace(own, "")


def test_the_points_are_the_same(book: Path, contact: Contact) -> None:
    before = json.loads(contact("check", WRONG, "--json").stdout)["results"][0]
    say(book, 'visibility = "values_withheld"')
    after = json.loads(contact("check", WRONG, "--json").stdout)["results"][0]
    for name in ("points", "max_points", "verdict"):
        assert before[name] == after[name]


@pytest.mark.parametrize("word", ["hidden", "after_due"])
def test_a_test_that_everybody_has_cannot_be_hidden(
    word: str, book: Path, contact: Contact
) -> None:
    line = say(book, f'visibility = "{word}"')
    for result in (contact("check", "ray_triangle"), contact("dev", "check", "--files")):
        said = " ".join((result.stdout + result.stderr).split())
        assert result.returncode in (1, 3)
        assert f"exercise.toml:{line}: visibility" in said.replace("exercise.toml: ", "")
        assert "is for private tests (contact grade --private)" in said


@pytest.mark.parametrize("value", ['"secret"', '"Hidden"', '""', "true", '["shown"]'])
def test_other_words_are_refused(value: str, book: Path, contact: Contact) -> None:
    line = say(book, f"visibility = {value}")
    result = contact("check", "ray_triangle")
    assert result.returncode == 3
    assert f"exercise.toml:{line}: visibility is" in " ".join(result.stderr.split())
    assert '"values_withheld"' in result.stderr


@pytest.mark.parametrize("member", ["withheld = true", 'visible = "shown"', "point = 3"])
def test_a_misspelt_member_is_no_silent_default(member: str, book: Path, contact: Contact) -> None:
    line = say(book, member)
    result = contact("check", "ray_triangle")
    assert result.returncode == 3
    said = " ".join(result.stderr.split())
    assert f"exercise.toml:{line}: a test has no '{member.split()[0]}'" in said
