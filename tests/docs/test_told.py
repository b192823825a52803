"""Tables of hard cases are checked in, so that a page needs no program; here the programs run."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TOLD = sorted(ROOT.glob("tests/*/hard_cases.told.json"))


def test_what_the_pages_show_of_hard_cases_is_what_the_programs_say() -> None:
    command = [sys.executable, str(ROOT / "docs" / "tell_hard_cases.py"), "--check"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert len(TOLD) >= 11
