"""The map of the chapters: right for any book that obeys the rule that nothing builds on itself."""

from __future__ import annotations

import random
import re
from itertools import pairwise
from pathlib import Path

import pytest
from contact_book.book import Chapter
from contact_book.map_layout import COLUMNS, GAP, WIDE, Layout, direct, lay_out


def chapter(number: int, part: int, builds_on: list[str]) -> Chapter:
    return Chapter(
        root=Path(),
        slug=f"{number:02d}_chapter",
        title=f"Chapter {number}",
        part=part,
        status="reference",
        tooltip="",
        builds_on=tuple(builds_on),
        in_lesson=(),
        recall=(),
        exercises=(),
        objectives=(),
        sources=(),
    )


def book(seed: int) -> dict[str, Chapter]:
    """A random book: an opening, then chapters of three parts, each on some of those before it."""
    rng = random.Random(seed)
    parts = [0, *sorted(rng.choice([1, 1, 1, 2, 2, 3]) for _ in range(rng.randint(0, 20)))]
    made: dict[str, Chapter] = {}
    for number, part in enumerate(parts):
        earlier = rng.sample(sorted(made), min(len(made), rng.randint(0, 3)))
        one = chapter(number, part, earlier)
        made[one.slug] = one
    return made


SEEDS = range(20)


@pytest.mark.parametrize("seed", SEEDS)
def test_what_a_chapter_builds_on_is_above_it_and_boxes_do_not_meet(seed: int) -> None:
    chapters = book(seed)
    layout = lay_out(chapters)
    assert set(layout.boxes) == set(chapters)
    cells = [
        (box.row, column)
        for box in layout.boxes.values()
        for column in range(box.column, box.column + box.span)
    ]
    assert len(cells) == len(set(cells))
    assert all(1 <= column <= COLUMNS for _, column in cells)
    for slug, one in chapters.items():
        for earlier in one.builds_on:
            assert layout.boxes[earlier].row < layout.boxes[slug].row


@pytest.mark.parametrize("seed", SEEDS)
def test_every_part_is_in_its_own_band(seed: int) -> None:
    layout = lay_out(book(seed))
    for box in layout.boxes.values():
        around = [
            band
            for band in layout.bands
            if band.row < box.row < band.row + band.rows
            and band.column <= box.column < band.column + band.span
        ]
        assert len(around) == (0 if box.chapter.part == 0 else 1)


def reachable(slug: str, steps: dict[str, set[str]]) -> set[str]:
    found: set[str] = set()
    left = list(steps[slug])
    while left:
        earlier = left.pop()
        if earlier not in found:
            found.add(earlier)
            left += steps[earlier]
    return found


@pytest.mark.parametrize("seed", SEEDS)
def test_lines_say_all_of_builds_on_and_nothing_twice(seed: int) -> None:
    chapters = book(seed)
    named = {slug: set(one.builds_on) for slug, one in chapters.items()}
    drawn = {slug: set(direct(slug, chapters)) for slug in chapters}
    for slug in chapters:
        assert drawn[slug] <= named[slug]
        assert reachable(slug, drawn) == reachable(slug, named)
    lines = {(line.earlier, line.later) for line in lay_out(chapters).lines}
    ground = {earlier for slug in drawn for earlier in drawn[slug]} - {one for one, _ in lines}
    # Only the chapters on which the whole book builds have no lines.
    for slug in ground:
        assert chapters[slug].part == 0
        assert all(slug in reachable(x, named) for x, one in chapters.items() if one.part != 0)
    assert lines == {(e, slug) for slug in drawn for e in drawn[slug] if e not in ground}


def corners(path: str, layout: Layout) -> list[tuple[float, float]]:
    """The points that a line goes through, where it changes from curve to straight."""
    x = y = 0.0
    points = []
    for command, text in re.findall(r"([MCV])([^MCV]*)", path):
        numbers = [float(word) for word in text.split()]
        if command == "V":
            y = numbers[-1]
        else:
            x, y = numbers[-2:]
        points.append((x, y))
    assert all(0 <= x <= COLUMNS * WIDE and 0 <= y <= layout.height for x, y in points)
    return points


@pytest.mark.parametrize("seed", SEEDS)
def test_no_line_runs_behind_a_box(seed: int) -> None:
    layout = lay_out(book(seed))
    for line in layout.lines:
        ends = {line.earlier, line.later}
        for (x0, y0), (x1, y1) in pairwise(corners(line.path, layout)):
            for slug, box in layout.boxes.items():
                top, bottom = layout.top(box.row) + GAP, layout.top(box.row + 1) - GAP
                if slug in ends or min(y0, y1) >= bottom or max(y0, y1) <= top:
                    continue
                # A box keeps at least 3 % of its column free at each side.
                left = (box.column - 1 + 0.03) * WIDE
                right = (box.column - 1 + box.span - 0.03) * WIDE
                assert max(x0, x1) <= left or min(x0, x1) >= right, (line, slug)
