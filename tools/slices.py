"""What a stage took of the lists that go by turns, as its processes have said it."""

from __future__ import annotations

import json
import textwrap
from dataclasses import dataclass, field
from pathlib import Path

WIDTH = 120


@dataclass
class Slice:
    """Of a list that goes by turns, what a run took and what it left."""

    ran: list[str] = field(default_factory=list)
    left: list[str] = field(default_factory=list)


def read_slices(file: Path) -> dict[str, Slice]:
    """What has been written of each list: several processes may have drawn the same one."""
    slices: dict[str, Slice] = {}
    if file.exists():
        for line in file.read_text().splitlines():
            said = json.loads(line)
            of = slices.setdefault(said["what"], Slice())
            of.ran += [name for name in said["ran"] if name not in of.ran]
            of.left += [name for name in said["left"] if name not in of.left]
    for of in slices.values():
        of.left = [name for name in of.left if name not in of.ran]
    return slices


def slice_in_words(what: str, of: Slice) -> str:
    """A paragraph of the closing table."""
    whole = len(of.ran) + len(of.left)
    if not of.left:
        return f"  {what}: all {whole} ran"
    says = (
        f"{what}: {len(of.ran)} of {whole} ran: {', '.join(of.ran) or 'none'}; "
        f"not run: {', '.join(of.left)}"
    )
    return textwrap.fill(
        says,
        width=WIDTH,
        initial_indent="  ",
        subsequent_indent="      ",
        break_on_hyphens=False,
        break_long_words=False,
    )
