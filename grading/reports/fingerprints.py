"""What two C++ texts have in common although names, comments and layout were changed.

A text is cut into words and signs, without comments; every name counts as the same word, and so
does every number. Runs of these are fingerprints, of which winnowing keeps one in each window: if
two texts share a run of `LONGEST_UNSEEN + 1` words and signs, they share a fingerprint.

Source: Schleimer, Wilkerson and Aiken, *Winnowing: Local Algorithms for Document Fingerprinting*,
SIGMOD 2003.
"""

from __future__ import annotations

import re
import zlib
from collections import defaultdict
from dataclasses import dataclass

RUN = 12
WINDOW = 6
LONGEST_UNSEEN = RUN + WINDOW - 2

# Each alternative takes a character at least and never goes back, so the time is linear for every
# text. Comments are removed before.
_TOKEN = re.compile(
    r"""(?P<text>"(?:[^"\\\n]|\\.)*"?|'(?:[^'\\\n]|\\.)*'?)
      | (?P<number>\.?[0-9](?:[eEpP][+-]|['\w.])*)
      | (?P<word>\w+)
      | (?P<sign>\S)""",
    re.X | re.S,
)
_KEYWORDS = """
auto bool break case char class const constexpr continue default do double else enum false float for
if int long namespace return short signed static struct switch template true typename unsigned using
void while
"""
_KEPT = frozenset(_KEYWORDS.split())


@dataclass(frozen=True)
class Token:
    """A word or sign, with its line, from 1."""

    kind: str
    line: int


def without_comments(text: str) -> str:
    """The text with each comment as blanks, on as many lines."""
    parts: list[str] = []
    at = 0
    for found in re.finditer(r'//|/\*|"', text):
        if found.start() < at:
            continue
        parts.append(text[at : found.start()])
        if found[0] == '"':
            literal = re.compile(r'"(?:[^"\\\n]|\\.)*"?', re.S).match(text, found.start())
            end = literal.end() if literal else len(text)
            parts.append(text[found.start() : end])
        else:
            stop = "\n" if found[0] == "//" else "*/"
            end = text.find(stop, found.start() + 2)
            end = len(text) if end < 0 else end + (0 if stop == "\n" else 2)
            parts.append(" " + "\n" * text.count("\n", found.start(), end))
        at = end
    return "".join([*parts, text[at:]])


def tokens(text: str) -> list[Token]:
    """All of a text; names are `x`, numbers `0`, literals `""`."""
    found: list[Token] = []
    line, at = 1, 0
    plain = without_comments(text)
    for match in _TOKEN.finditer(plain):
        line += plain.count("\n", at, match.start())
        at = match.start()
        kind = match[0]
        if match.lastgroup == "word" and kind not in _KEPT:
            kind = "x"
        elif match.lastgroup == "number":
            kind = "0"
        elif match.lastgroup == "text":
            kind = '""'
        found.append(Token(kind, line))
    return found


def fingerprints(of: list[Token]) -> dict[tuple[str, ...], list[int]]:
    """The runs that winnowing keeps, and the positions at which each begins."""
    kinds = [token.kind for token in of]
    runs = [tuple(kinds[i : i + RUN]) for i in range(len(kinds) - RUN + 1)]
    order = [zlib.crc32("\x1f".join(run).encode()) for run in runs]
    kept: set[int] = set()
    for begin in range(max(1, len(runs) - WINDOW + 1) if runs else 0):
        window = range(begin, min(begin + WINDOW, len(runs)))
        kept.add(min(window, key=lambda i: (order[i], -i)))
    found: dict[tuple[str, ...], list[int]] = defaultdict(list)
    for i in sorted(kept):
        found[runs[i]].append(i)
    return dict(found)
