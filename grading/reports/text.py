"""Makes text from a submission safe to show: every character visible, long texts cut.

Names, program output, compiler messages and exceptions may hold anything: terminal escapes, marks
that turn the direction of writing, zero bytes, half surrogates, a line of a megabyte. What comes
out of `clean` holds printable characters, newlines and tabs only, so it is valid in XML 1.0, in
UTF-8 and on a terminal. Escaping for HTML, JSON, XML and CSV is each format's own.
"""

from __future__ import annotations

import unicodedata

MAX_CHARACTERS = 20_000
MAX_LINES = 400
MAX_IN_LINE = 2_000
# Marks above and below one letter; text in real languages has no more.
MAX_MARKS = 4

# Letters that are drawn as nothing: fillers, and the Braille pattern without a dot.
_BLANK = {0x00AD, 0x034F, 0x115F, 0x1160, 0x17B4, 0x17B5, 0x180E, 0x2800, 0x3164, 0xFFA0, 0xFFFC}
_HIDDEN_KINDS = {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}


def visible(text: str) -> str:
    """The text with every character that cannot be seen replaced by one that can."""
    text = text.replace("\r\n", "\n")
    if text.isascii() and text.isprintable():
        return text  # Most are.
    shown: list[str] = []
    marks = 0
    for character in text:
        kind = unicodedata.category(character)
        marks = marks + 1 if kind in ("Mn", "Me") else 0
        if marks <= MAX_MARKS:
            shown.append(_stand_in(character, kind))
    return "".join(shown)


def _stand_in(character: str, kind: str) -> str:
    code = ord(character)
    if character in "\n\t":
        return character
    if code < 0x20:
        return chr(0x2400 + code)
    if code == 0x7F:
        return "\u2421"
    if kind in _HIDDEN_KINDS or code in _BLANK or 0xFE00 <= code <= 0xFE0F:
        return f"⟨U+{code:04X}⟩"
    return character


def cut(
    text: str,
    characters: int = MAX_CHARACTERS,
    lines: int = MAX_LINES,
    in_line: int = MAX_IN_LINE,
    whole: int | None = None,
) -> str:
    """The beginning of a long text and how long it was; `whole` if some of it went before."""
    whole = len(text) if whole is None else whole
    kept: list[str] = []
    room = characters
    for row in text.split("\n")[:lines]:
        if room <= 0:
            break
        allowed = min(in_line, room)
        kept.append(row if len(row) <= allowed else f"{row[:allowed]} […]")
        room -= min(len(row), allowed) + 1
    short = "\n".join(kept)
    if short == text and len(text) == whole:
        return text
    return f"{short}\n[cut here: {whole} characters in all]"


def clean(text: str) -> str:
    """A text of several lines, fit to be shown."""
    # What will not be shown need not be looked at.
    beginning = text[: 2 * MAX_CHARACTERS]
    shown = visible(beginning)
    return cut(shown, whole=len(shown) if beginning == text else len(text))


def clean_line(text: str, characters: int = 200) -> str:
    """A text of one line: names, ids, paths."""
    shown = visible(text[: 2 * characters]).replace("\n", "␊").replace("\t", " ").strip()
    return shown if len(shown) <= characters else f"{shown[:characters]}…"
