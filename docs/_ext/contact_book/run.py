"""Runs Sphinx as its own process, strictly."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

# The file name of the e-book, in the folder of the pages.
EBOOK = "contact-hours.epub"


def run_sphinx(
    builder: str,
    docs: Path,
    build: Path,
    target: Path,
    environment: Mapping[str, str],
    *,
    every_page: bool = False,
) -> int:
    """Sphinx's exit code; every warning counts as an error, after all of them are printed.

    Pages that did not change are not written again, unless `every_page` says so. All is read in
    one process: several are not faster for this book, and each time that Sphinx brings together
    what they have read, it doubles a C++ name that was ever declared twice.
    """
    command = [
        *(sys.executable, "-m", "sphinx", "-W", "-n", "-q"),
        *("-b", builder, "-c", str(docs), "-d", str(build / "doctrees")),
        *(("-a",) if every_page else ()),
        *(str(build / "docs-src"), str(target)),
    ]
    return subprocess.run(command, env=dict(environment), check=False).returncode
