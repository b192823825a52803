"""What a header touches, compared with what the compiler has read for all that is built."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "dev"
sys.path.insert(0, str(ROOT / "tools"))

from touched import CODE, EVERYTHING, read_book, touched_by  # noqa: E402

BOOK = read_book(ROOT)


def included_in_the_build() -> dict[str, set[str]]:
    """Of each header of tests and chapters, the chapters whose objects the compiler made of it."""
    if not (BUILD / "build.ninja").exists() or not shutil.which("ninja"):
        pytest.skip("nothing is built in build/dev")
    command = ["ninja", "-C", str(BUILD), "-t", "deps"]
    listed = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    of_a_chapter = re.compile(
        r"(?:reference_tests|hard_cases|example|figure|ladder|exercise|headers_alone)_(\d\d_\w+)\.dir/"
    )
    chapters = sorted(BOOK.builds_on)
    found: dict[str, set[str]] = {}
    chapter = None
    for line in listed.splitlines():
        if not line.startswith(" "):
            fits = of_a_chapter.search(line) if line.endswith("(VALID)") else None
            chapter = next((c for c in chapters if fits and fits[1].startswith(c)), None)
        elif chapter:
            # Some are named from the root, and some from the build's folder.
            name = os.path.relpath(BUILD / line[4:], ROOT)
            if re.match(r"(chapters|tests)/.*\.hpp$", name):
                found.setdefault(name, set()).add(chapter)
    return found


def test_who_compiles_a_header_is_touched_by_it() -> None:
    included = included_in_the_build()
    if not included:
        pytest.skip("no chapter is built in build/dev")
    missed = {}
    for header, chapters in included.items():
        if not (ROOT / header).exists():
            continue
        found = touched_by([header], BOOK)
        names = {name for kind in CODE for name in found.get(kind, ())}
        if EVERYTHING not in names and not chapters <= names:
            missed[header] = chapters - names
    assert missed == {}
