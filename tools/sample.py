"""What a run tests of what is too much for every run: another part of it with each commit, so that
a few commits have tested all. With CONTACT_ALL=1 it is everything."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import TypeVar

Item = TypeVar("Item")


def turn() -> int:
    """A number that differs from commit to commit."""
    command = ["git", "-C", str(Path(__file__).parent), "rev-parse", "HEAD"]
    head = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return int(head[:8], 16)


def sample(of: Sequence[Item], each: int) -> list[Item]:
    """Every `each`-th of them."""
    if "CONTACT_ALL" in os.environ:
        return list(of)
    first = turn()
    return [one for i, one in enumerate(of) if (i + first) % each == 0]
