"""A student who is no longer in the results is not in students/ either, and none of their files is
lost."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "grading")]

import outputs_class as made  # noqa: E402
from graded_class import Grader  # noqa: E402
from reports.__main__ import main  # noqa: E402

Json = dict[str, Any]
STAMP = re.compile(r"\d{4}-\d\d-\d\dT\d\d-\d\d-\d\dZ(-\d+)?")


def class_of(*ids: str) -> Json:
    listed = made.exercises()[:1]
    one = [made.submission(id_, [made.absent(listed[0], "missing")]) for id_ in ids]
    return made.document(listed, one)


def write(folder: Path, *ids: str) -> None:
    folder.mkdir(exist_ok=True)
    (folder / "results.json").write_text(json.dumps(class_of(*ids)))
    assert main([str(folder)]) == 0


def names(folder: Path) -> list[str]:
    return sorted(entry.name for entry in folder.iterdir())


def files(folder: Path) -> dict[str, bytes]:
    return {file.name: file.read_bytes() for file in folder.iterdir()}


def test_a_student_who_withdrew_is_kept_beside_the_results_they_were_in(grader: Grader) -> None:
    grader.hand_in("ada")
    bob = grader.hand_in("bob")
    grader.grade("--seed", "s")
    students = grader.results / "students"
    pages = files(students / "bob")
    assert "report.html" in pages
    bob.unlink()
    bob.parent.rmdir()
    bob.parent.parent.rmdir()
    grader.grade()
    assert names(students) == ["ada"]
    (kept,) = (grader.results / "earlier").iterdir()
    assert "results.json" in names(kept)
    assert files(kept / "students" / "bob") == pages


def test_where_no_results_were_kept_a_folder_of_now_is_made(tmp_path: Path) -> None:
    write(tmp_path, "ada", "bob", "../cy")
    write(tmp_path, "ada", "bob", "../cy")
    assert not (tmp_path / "earlier").exists(), "nobody is gone"
    # The second write's: some of them say when they were written.
    pages = files(tmp_path / "students" / "bob")
    write(tmp_path, "ada")
    assert names(tmp_path / "students") == ["ada"]
    (kept,) = (tmp_path / "earlier").iterdir()
    assert STAMP.fullmatch(kept.name)
    assert names(kept / "students") == ["%2E.%2Fcy", "bob"]
    assert files(kept / "students" / "bob") == pages


def test_pages_that_are_kept_never_give_way(tmp_path: Path) -> None:
    """Also where the last results that were kept are of the same student."""
    for round_ in ("first", "second"):
        write(tmp_path, "ada", "bob")
        (tmp_path / "students" / "bob" / "notes.txt").write_text(round_)
        kept = tmp_path / "earlier" / "2026-06-01T12-00-00Z"
        kept.mkdir(parents=True, exist_ok=True)
        (kept / "results.json").write_text(json.dumps(class_of("ada", "bob")))
        write(tmp_path, "ada")
    notes = {file.read_text(): file for file in tmp_path.glob("earlier/*/students/bob/notes.txt")}
    assert set(notes) == {"first", "second"}
    assert notes["first"].parents[2] == kept


def test_results_of_others_are_not_taken_for_theirs(tmp_path: Path) -> None:
    kept = tmp_path / "earlier" / "2026-06-01T12-00-00Z-10"
    kept.mkdir(parents=True)
    (kept / "results.json").write_text(json.dumps(class_of("dan")))
    older = tmp_path / "earlier" / "2026-06-01T12-00-00Z-9"
    older.mkdir()
    (older / "results.json").write_text(json.dumps(class_of("bob")))
    write(tmp_path, "ada", "bob")
    write(tmp_path, "ada")
    assert names(kept) == names(older) == ["results.json"]
    assert len(list(tmp_path.glob("earlier/*/students/bob/report.html"))) == 1


def test_what_is_no_folder_of_a_student_stays(tmp_path: Path) -> None:
    write(tmp_path, "ada")
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "students" / "link").symlink_to(tmp_path / "elsewhere")
    (tmp_path / "students" / "all.zip").write_text("")
    write(tmp_path, "ada")
    assert names(tmp_path / "students") == ["ada", "all.zip", "link"]
    assert not (tmp_path / "earlier").exists()
