"""Named regions of a source file: the lines between `// [name]` and `// [/name]`."""

from __future__ import annotations

import re
import textwrap
from dataclasses import dataclass

from book_json import BookError

_INLINE = re.compile(r"^\s*(?P<macro>CONTACT_[A-Z]+_INLINE )")
_MARKER = re.compile(r"^\s*//\s*\[(?P<close>/?)(?P<name>[a-z0-9][a-z0-9_-]*)\]\s*$")


@dataclass(frozen=True)
class Region:
    """A stretch of a file; `first` and `last` are its one-based lines without the markers."""

    name: str
    first: int
    last: int
    text: str


def find_regions(text: str, where: str) -> dict[str, Region]:
    """Every region of `text`; regions may nest, and markers never appear in what is shown."""
    lines = text.splitlines()
    opened: dict[str, int] = {}
    spans: dict[str, tuple[int, int]] = {}
    markers: set[int] = set()
    for number, line in enumerate(lines, start=1):
        match = _MARKER.match(line)
        if match is None:
            continue
        markers.add(number)
        name = match["name"]
        if not match["close"]:
            if name in opened or name in spans:
                raise BookError(f"{where}:{number}: region '{name}' is opened twice")
            opened[name] = number
        elif name in opened:
            spans[name] = (opened.pop(name) + 1, number - 1)
        else:
            raise BookError(f"{where}:{number}: region '{name}' is closed but was never opened")
    for name, number in opened.items():
        raise BookError(f"{where}:{number}: region '{name}' is never closed")
    regions = {}
    for name, (first, last) in spans.items():
        shown = [lines[n - 1] for n in range(first, last + 1) if n not in markers]
        body = textwrap.dedent("\n".join(shown)).strip("\n")
        if not body.strip():
            raise BookError(f"{where}:{first}: region '{name}' is empty")
        regions[name] = Region(name, first, last, body + "\n")
    return regions


def region(text: str, name: str, where: str) -> Region:
    """The region called `name`, or an error that lists the regions there are."""
    regions = find_regions(text, where)
    if name not in regions:
        there = ", ".join(sorted(regions)) or "none"
        raise BookError(f"unknown region '{name}' in {where}; there is: {there}")
    return regions[name]


def without_inline_macro(text: str) -> str:
    """A source file's functions as a reader wants them: without the macro that says whether they
    are inline, and with the rest of their heads as far to the left as before it."""
    lines = []
    shift = depth = 0
    for line in text.split("\n"):
        match = _INLINE.match(line)
        if match is not None:
            line = line.replace(match["macro"], "", 1)
            shift, depth = len(match["macro"]), 0
        elif shift > 0 and line.startswith(" " * (shift + 1)):
            line = line[shift:]
        depth += line.count("(") - line.count(")")
        if depth == 0:
            shift = 0
        lines.append(line)
    return "\n".join(lines)


def without_markers(text: str) -> str:
    """The whole text, less its marker lines."""
    kept = [line for line in text.splitlines() if _MARKER.match(line) is None]
    return "\n".join(kept).strip("\n") + "\n"
