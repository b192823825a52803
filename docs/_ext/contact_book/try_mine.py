"""How an exercise is tied to a figure of its lesson, whose numbers then go to a reader's own code.

    :::{exercise} ray_triangle
    :figure: ray_triangle
    :call: ray_triangle({origin, through - origin}, {a, b, c})
    :only-for: segment = 0: a ray, not a segment
    hit: mine.has_value() = hit
    t: mine->t = t if hit
    :::

`call` is C++ that calls a function of the contract; every name in it is a field of the figure. In
the lines below, `mine` is the result, and on the right is the field in which the figure has the
book's answer; after `if`, the field that says whether there is one; after `while`, the field that
says whether the two are compared, as the figure's own answer may be rounded or about another case.

`only-for` names a number of the figure, given or computed, that says whether the contract holds;
`start`, optional, a state by its label, in which it does: the page shows that first if the number
has another value.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from contact_book.book import Book, Chapter
from contact_book.errors import BookError, unknown

_FIGURE = re.compile(
    r"\bFIGURE\(\s*\w+\s*,\s*FIELDS\((?P<inputs>[^)]*)\)\s*,\s*\w+\s*,"
    r"\s*FIELDS\((?P<outputs>[^)]*)\)\s*\)"
)
_CALL = re.compile(r"(?P<function>[a-z]\w*)\((?P<arguments>.*)\)", re.DOTALL)
_ROW = re.compile(
    r"(?P<label>[^:]+):\s+(?P<mine>.*\bmine\b.*?)\s+=\s+(?P<book>[a-z]\w*)(?:\[(?P<index>\d+)\])?"
    r"(?:\s+if\s+(?P<when>[a-z]\w*))?(?:\s+while\s+(?P<asked>[a-z]\w*))?"
)
_ONLY = re.compile(r"(?P<field>[a-z]\w*)\s*=\s*(?P<value>-?\d+(?:\.\d+)?)\s*:\s*(?P<words>.+)")
# Not a member, and not qualified.
_NAME = re.compile(r"(?<![\w.:>])[A-Za-z_]\w*(?![\w:])")
_MEMBER = re.compile(r"->\s*\w+")
_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


@dataclass(frozen=True)
class Fields:
    """What a figure's C++ reads and gives."""

    inputs: tuple[str, ...]
    outputs: tuple[str, ...]


def fields_of(figure: Path, shown: str) -> Fields:
    match = _FIGURE.search(_COMMENT.sub("", figure.read_text(encoding="utf-8")))
    if not match:
        raise BookError(f"{shown} has no FIGURE(Input, FIELDS(...), Output, FIELDS(...))")
    inputs, outputs = (
        tuple(name.strip() for name in match[kind].split(",")) for kind in ("inputs", "outputs")
    )
    return Fields(inputs, outputs)


def _split(text: str) -> list[str]:
    """At the commas that no bracket encloses."""
    parts, depth, part = [], 0, ""
    for sign in text:
        depth += (sign in "({[") - (sign in ")}]")
        if sign == "," and depth == 0:
            parts.append(part.strip())
            part = ""
        else:
            part += sign
    return [*parts, part.strip()] if part.strip() or parts else []


def parameters(contract: str) -> dict[str, int]:
    """The functions that a contract declares, and how many parameters each has."""
    text = re.sub(r"^#.*$", "", _COMMENT.sub("", contract), flags=re.MULTILINE)
    found: dict[str, int] = {}
    for match in re.finditer(r"[\w>&*]\s+(\w+)\(([^()]*)\)\s*;", text):
        # A comma of a template's arguments separates no parameters.
        found[match[1]] = len(_split(re.sub(r"<[^<>]*>", "", match[2])))
    return found


def _need(name: str, known: tuple[str, ...], figure: str) -> None:
    if name not in known:
        raise unknown("field", name, known, f"figure {figure}")


def tie(
    book: Book, chapter: Chapter, contract: Path, options: dict[str, str], lines: list[str]
) -> dict[str, Any] | None:
    """The tie as the page's script reads it, or nothing; raises BookError if it fits neither."""
    if not options and not any(line.strip() for line in lines):
        return None
    for option in ("figure", "call"):
        if option not in options:
            raise BookError(f"an exercise tied to a figure needs :{option}:")
    name = options["figure"].strip()
    if name not in chapter.figures:
        raise unknown("figure", name, chapter.figures, f"chapters/{chapter.slug}/figures")
    source = chapter.folder / "figures" / f"{name}.cpp"
    fields = fields_of(source, book.relative(source))
    every = fields.inputs + fields.outputs
    # After %, as in the lesson itself, stands a comment.
    plain = [line.partition(" %")[0] for line in lines]
    rows = [_row(line, name, fields) for line in plain if line.strip()]
    if not rows:
        raise BookError("an exercise tied to a figure needs a line LABEL: mine... = FIELD")
    call, used = _call(options["call"], contract, name, every)
    if not used:
        raise BookError(f":call: uses no field of figure {name}, so moving it changes nothing")
    return {
        "figure": f"{chapter.slug}/{name}",
        "call": call,
        "fields": used,
        "only": _only(options.get("only-for"), name, every),
        "start": _start(options.get("start"), source.with_suffix(".ts")),
        "rows": rows,
    }


def _call(text: str, contract: Path, figure: str, known: tuple[str, ...]) -> tuple[str, list[str]]:
    match = _CALL.fullmatch(text.strip())
    if not match:
        raise BookError(f":call: is FUNCTION(ARGUMENTS), not '{text}'")
    declared = parameters(contract.read_text(encoding="utf-8"))
    if match["function"] not in declared:
        raise unknown("function", match["function"], declared, contract.name)
    given = len(_split(match["arguments"]))
    needed = declared[match["function"]]
    if given != needed:
        raise BookError(
            f":call: gives {given} arguments, and {match['function']} has {needed} parameters"
        )
    used = list(dict.fromkeys(_NAME.findall(_MEMBER.sub("", match["arguments"]))))
    for name in used:
        _need(name, known, figure)
    return text.strip(), used


def _row(line: str, figure: str, fields: Fields) -> dict[str, Any]:
    match = _ROW.fullmatch(line.strip())
    if not match:
        raise BookError(
            f"'{line.strip()}' is not LABEL: mine... = FIELD, with if FIELD or while FIELD"
        )
    for part in ("book", "when", "asked"):
        if match[part] is not None:
            _need(match[part], fields.outputs, figure)
    return {
        "label": match["label"].strip(),
        "mine": match["mine"],
        "book": match["book"],
        "index": None if match["index"] is None else int(match["index"]),
        "when": match["when"],
        "asked": match["asked"],
    }


def _start(label: str | None, drawn: Path) -> str | None:
    if label is not None and f'label: "{label}"' not in drawn.read_text(encoding="utf-8"):
        raise BookError(f":start: is a state of figure {drawn.stem}, and {label!r} is none")
    return label


def _only(text: str | None, figure: str, known: tuple[str, ...]) -> dict[str, Any] | None:
    if text is None:
        return None
    match = _ONLY.fullmatch(text.strip())
    if not match:
        raise BookError(f":only-for: is FIELD = NUMBER: WORDS, not '{text}'")
    _need(match["field"], known, figure)
    return {"field": match["field"], "value": float(match["value"]), "words": match["words"]}
