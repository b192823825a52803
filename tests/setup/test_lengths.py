"""No source is longer than 500 lines, but those of which CONTRIBUTING says why."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from lengths import check_lengths, excused  # noqa: E402

TABLE = "# X\n\n## Long files\n\n| File | Why |\n|---|---|\n| `a/long.cpp` | one piece |\n\n## Y\n"


@pytest.fixture
def project(tmp_path: Path) -> Path:
    subprocess.run(["git", "init", "-q", str(tmp_path)], check=True)
    (tmp_path / "CONTRIBUTING.md").write_text(TABLE)
    put(tmp_path, "a/long.cpp", 501)
    return tmp_path


def put(root: Path, name: str, lines: int) -> None:
    (root / name).parent.mkdir(parents=True, exist_ok=True)
    (root / name).write_text("x\n" * lines)
    subprocess.run(["git", "-C", str(root), "add", name], check=True)


def test_the_sources_of_this_project() -> None:
    found = check_lengths(ROOT)
    assert found.problems == []
    assert found.looked > 500


def test_a_long_file_of_the_table_is_excused(project: Path) -> None:
    put(project, "b/short.py", 500)
    assert check_lengths(project).problems == []


@pytest.mark.parametrize("kind", ["cpp", "hpp", "py", "ts", "mjs", "css"])
def test_a_long_file_is_named_with_its_lines(project: Path, kind: str) -> None:
    put(project, f"b/one.{kind}", 501)
    (problem,) = check_lengths(project).problems
    assert problem.startswith(f"b/one.{kind} has 501 lines")


@pytest.mark.parametrize("name", ["b/data.json", "b/third_party/theirs.cpp", "b/lesson.md"])
def test_data_prose_and_what_others_wrote_may_be_long(project: Path, name: str) -> None:
    put(project, name, 2000)
    assert check_lengths(project).problems == []


def test_what_is_listed_must_be_there_and_long(project: Path) -> None:
    put(project, "a/long.cpp", 400)
    assert check_lengths(project).problems == [
        "CONTRIBUTING lists a/long.cpp as long, which has 400 lines"
    ]
    (project / "a/long.cpp").unlink()
    assert check_lengths(project).problems == [
        "CONTRIBUTING lists a/long.cpp as long, which has no lines"
    ]


def test_the_table_ends_with_its_section() -> None:
    assert excused(TABLE + "| `z.cpp` | of another table |\n") == {"a/long.cpp": "one piece"}
    assert excused("# no table\n") == {}
