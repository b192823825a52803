"""Selects the part of long lists of tests that one run takes.

`tools/turn` holds a number that each landing raises by one. A run takes every `each`-th item of
such a list, so `each` landings in a row take them all. Items that the change touches are taken in
every run. tests/browser/sample.mjs does the same for the tests of the page, and
tests/setup/test_turns.py compares the two.

From the environment:
  CONTACT_ALL       takes everything
  CONTACT_TURN      a number instead of the one in tools/turn: takes again what that turn took
  CONTACT_TOUCHED   JSON, {"figures": ["01_planes"], "page": ["*"]}: what the change touches of each
                    kind (tools/touched.py); "*" is everything of that kind
  CONTACT_CHAPTERS  names of chapters between commas: everything of them, and nothing else
  CONTACT_SLICES    a file to which each list adds one line of JSON: what was taken and what was not
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import TypeVar

Item = TypeVar("Item")

# Kinds of which the chapters that are asked for say nothing.
OF_NO_CHAPTER = ("hostile", "explain", "authors", "tidy", "grading", "builder")

TURN = Path(__file__).resolve().parent / "turn"


def read_turn(text: str, where: str) -> int:
    if not text.strip().isdecimal():
        raise ValueError(f"{where} must hold one whole number, and holds {text.strip()[:40]!r}")
    return int(text)


def turn() -> int:
    """The number of this landing."""
    given = os.environ.get("CONTACT_TURN")
    if given is not None:
        return read_turn(given, "CONTACT_TURN")
    return read_turn(TURN.read_text(), str(TURN))


def in_turn(index: int, each: int, number: int, within: int = 1) -> bool:
    """Whether turn `number` takes item `index` of a list of which it takes every `each`-th.

    `within`: of a list inside another one that is taken only in every `within`-th turn. It moves on
    by one each time that it is taken: by the turn's own number, some items would never be.
    """
    return (index + number // within) % each == 0


def touches(names: Iterable[str], item: str) -> bool:
    """Whether one of the names is "*", or stands in the item's name."""
    return any(name == "*" or name in item for name in names)


def chapters_asked_for() -> list[str]:
    """The chapters that alone are checked; none: all of them."""
    return [one for one in os.environ.get("CONTACT_CHAPTERS", "").split(",") if one]


def wanted(item: str) -> bool:
    """Whether something with this name is checked."""
    chapters = chapters_asked_for()
    return not chapters or touches(chapters, item)


def sample(
    of: Sequence[Item],
    each: int,
    what: str,
    *,
    kind: str | None = None,
    within: int = 1,
    name: Callable[[Item], str] = str,
) -> list[Item]:
    """Every `each`-th of them, and what the change touches.

    `what`: the name of the list in the table at the end of a run; "" keeps it out of the table.
    `kind`: what CONTACT_TOUCHED calls them. Without a kind the list goes by turns only, in the
    checks of one chapter too.
    """
    every = "CONTACT_ALL" in os.environ
    touched: Sequence[str] = ()
    if kind is not None:
        touched = json.loads(os.environ.get("CONTACT_TOUCHED") or "{}").get(kind, ())
        if chapters_asked_for() and kind not in OF_NO_CHAPTER:
            of = [one for one in of if wanted(name(one))]
            every = True
    number = turn()
    taken = [
        every or in_turn(i, each, number, within) or touches(touched, name(one))
        for i, one in enumerate(of)
    ]
    if what:
        record(
            what,
            [name(one) for one, take in zip(of, taken, strict=True) if take],
            [name(one) for one, take in zip(of, taken, strict=True) if not take],
        )
    return [one for one, take in zip(of, taken, strict=True) if take]


def record(what: str, ran: Sequence[str], left: Sequence[str]) -> None:
    """Says in CONTACT_SLICES, if it is set, what of a list was taken and what was not."""
    file = os.environ.get("CONTACT_SLICES")
    if file and (ran or left):
        line = json.dumps({"what": what, "ran": list(ran), "left": list(left)})
        with Path(file).open("a") as opened:
            opened.write(line + "\n")
