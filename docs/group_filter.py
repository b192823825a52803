#!/usr/bin/env python3
"""Doxygen's input filter: puts what a header declares into a group of the header's own.

A page can then show a header with one directive, without declaring the namespace again for each.
Lines keep their numbers.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

_OPEN = re.compile(r"^(namespace contact(?:::\w+)* \{)$", re.MULTILINE)
# "Limits:" and "Source:" in a doc comment become paragraphs with a heading.
_HEADED = re.compile(r"^(\s*/// (?:.*[.;)] )?)(Limits|Source): ", re.MULTILINE)
_CLOSE = re.compile(r"^(\}  // namespace contact(?:::\w+)*)$", re.MULTILINE)


def group_of(header: Path) -> str:
    """The group's name, as the API page writes it."""
    return f"header_{header.stem}"


def include_name(header: Path) -> str:
    """What a program writes between < and >: the path from the chapter's folder contact/."""
    folders = header.parts[:-1]
    if "contact" not in folders:
        return f"contact/{header.name}"
    last = len(folders) - 1 - folders[::-1].index("contact")
    return "/".join(header.parts[last:])


def grouped(text: str, header: Path) -> str:
    """The header with its group opened and closed just inside the namespace."""
    name = group_of(header)
    text = _OPEN.sub(rf"\1 /** @addtogroup {name} {include_name(header)} */ /** @{{ */", text)
    while _HEADED.search(text):
        text = _HEADED.sub(lambda m: f"{m[1]}@{m[2].lower()} ", text)
    return _CLOSE.sub(r"/** @} */ \1", text)


if __name__ == "__main__":
    path = Path(sys.argv[1])
    sys.stdout.write(grouped(path.read_text(encoding="utf-8"), path))
