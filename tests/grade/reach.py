"""Where no namespaces are, or a user without rights grades, that user must get to the book."""

from __future__ import annotations

from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PYTHON = ROOT / "build" / "venv" / "bin" / "python"


def closed_folder(file: Path) -> Path | None:
    """The folder on the path of a file that other users cannot enter, if there is one."""
    return next((one for one in file.resolve().parents if not one.stat().st_mode & 0o001), None)


def skip_if_closed(*more: Path) -> None:
    for file in (ROOT / "contact", *more):
        closed = closed_folder(file)
        if closed is not None:
            pytest.skip(f"{closed} lets no other user in, so not to {file}")
