"""Checks the length of sources, except those that CONTRIBUTING lists with a reason."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from landing import Found

LONGEST = 500
KINDS = (".cpp", ".hpp", ".py", ".ts", ".mts", ".mjs", ".js", ".css")
# The table in CONTRIBUTING: its heading, and a row's first cell.
HEADING = "## Long files"
ROW = re.compile(r"^\| `([^`]+)` \| (.+?) \|$", re.MULTILINE)


def excused(contributing: str) -> dict[str, str]:
    """The files that may be longer, with the reason of each."""
    _, found, rest = contributing.partition(f"\n{HEADING}\n")
    return dict(ROW.findall(rest.partition("\n## ")[0])) if found else {}


def sources(root: Path) -> list[str]:
    """What is tracked and written here: code, not data and not what others wrote."""
    command = ["git", "-C", str(root), "ls-files", "-z"]
    listed = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return [
        name
        for name in listed.split("\0")
        if name.endswith(KINDS) and "third_party/" not in name and (root / name).is_file()
    ]


def check_lengths(root: Path) -> Found:
    """Sources of more lines than that are in the table, and no others are."""
    names = sources(root)
    lines = {name: (root / name).read_bytes().count(b"\n") for name in names}
    may = excused((root / "CONTRIBUTING.md").read_text(encoding="utf-8"))
    found = Found("the lengths of sources", looked=len(names))
    for name, count in lines.items():
        if count > LONGEST and name not in may:
            found.problems.append(
                f"{name} has {count} lines, of which {LONGEST} are allowed: split it by what it "
                f"does, or say in CONTRIBUTING ({HEADING.removeprefix('## ')}) why it is one piece"
            )
    for name in may:
        if lines.get(name, 0) <= LONGEST:
            found.problems.append(
                f"CONTRIBUTING lists {name} as long, which has {lines.get(name, 'no')} lines"
            )
    return found
