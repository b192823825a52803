"""A report that cannot be written is named, and what was there before it stays whole."""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "grading")]

import outputs_class as made  # noqa: E402


def reports(folder: Path, max_bytes: int, *words: str) -> subprocess.CompletedProcess[str]:
    """Under a limit a write ends as on a full disk: with a reason, and no name."""

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (max_bytes, max_bytes))

    return subprocess.run(
        [sys.executable, "-m", "reports", str(folder), *words],
        env={**os.environ, "PYTHONPATH": str(ROOT / "grading"), "PYTHONDONTWRITEBYTECODE": "1"},
        preexec_fn=limit,
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.parametrize(
    ("format_", "file"),
    [("html", "students/ada/report.html"), ("class", "class.html")],
)
def test_a_report_for_which_there_is_no_room_is_named(
    tmp_path: Path, format_: str, file: str
) -> None:
    listed = made.exercises()[:1]
    one = made.submission("ada", [made.absent(listed[0], "missing")])
    (tmp_path / "results.json").write_text(json.dumps(made.document(listed, [one])))
    assert reports(tmp_path, 1 << 20, "--formats", format_).returncode == 0
    before = (tmp_path / file).read_bytes()
    assert len(before) > 1000
    done = reports(tmp_path, 1000, "--formats", format_)
    assert done.returncode == 3
    assert done.stderr.startswith(f"reports: {tmp_path / file} cannot be written: ")
    assert "None" not in done.stderr
    assert (tmp_path / file).read_bytes() == before
    assert [one.name for one in (tmp_path / file).parent.glob(".*")] == [], "no half of a report"
