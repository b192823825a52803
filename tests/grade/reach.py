"""Where no namespaces are, or a user without rights grades, that user must get to the book."""

from __future__ import annotations

from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def closed_folder() -> Path | None:
    """The folder on the way to the book that lets nobody else in, if there is one."""
    return next((one for one in (ROOT, *ROOT.parents) if not one.stat().st_mode & 0o001), None)


def skip_if_closed() -> None:
    closed = closed_folder()
    if closed is not None:
        pytest.skip(f"{closed} lets no other user in, so only boxes with namespaces reach the book")
