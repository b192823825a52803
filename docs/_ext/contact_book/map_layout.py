"""The position of each chapter on the map, and the route of each line from its prerequisites.

Rows run down the page, and the prerequisites of a chapter are always above it. The parts of the
book are side by side, in four columns, so that the map also fits a phone.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from contact_book.book import PARTS, Chapter

COLUMNS = 4
# The grid's rows, in tenths of a rem: a chapter's, and that of the name of a part.
ROW, LABEL = 56, 26
# Above and below each box, where the lines turn.
GAP = 10
# A column's width in the drawing, which is stretched to the page's.
WIDE = 100
_LANE = 2.5


@dataclass(frozen=True)
class Box:
    """A chapter: columns and grid rows count from one, as CSS counts them."""

    chapter: Chapter
    row: int
    column: int
    span: int

    @property
    def middle(self) -> float:
        return (self.column - 1 + self.span / 2) * WIDE


@dataclass(frozen=True)
class Band:
    """A part: the columns it takes and its grid rows, the name's included."""

    name: str
    row: int
    rows: int
    column: int
    span: int


@dataclass(frozen=True)
class Line:
    earlier: str
    later: str
    path: str


@dataclass
class Layout:
    boxes: dict[str, Box] = field(default_factory=dict)
    bands: list[Band] = field(default_factory=list)
    lines: list[Line] = field(default_factory=list)
    heights: list[int] = field(default_factory=list)

    @property
    def height(self) -> int:
        return sum(self.heights)

    def top(self, row: int) -> int:
        """Where a grid row begins."""
        return sum(self.heights[: row - 1])


def _ancestors(slug: str, chapters: dict[str, Chapter]) -> set[str]:
    found: set[str] = set()
    left = list(chapters[slug].builds_on)
    while left:
        earlier = left.pop()
        if earlier in chapters and earlier not in found:
            found.add(earlier)
            left += chapters[earlier].builds_on
    return found


def direct(slug: str, chapters: dict[str, Chapter]) -> list[str]:
    """What a chapter builds on, without what it builds on through another chapter anyway."""
    named = [earlier for earlier in chapters[slug].builds_on if earlier in chapters]
    through: set[str] = set()
    for earlier in named:
        through |= _ancestors(earlier, chapters)
    return [earlier for earlier in named if earlier not in through]


def stood_on(chapters: dict[str, Chapter]) -> set[str]:
    """The bars of the chapters on which all later ones build: lines from them would give no
    information."""
    first = [slug for slug, chapter in chapters.items() if chapter.part == 0]
    later = [slug for slug, chapter in chapters.items() if chapter.part != 0]
    return {slug for slug in first if all(slug in _ancestors(other, chapters) for other in later)}


class _Placer:
    def __init__(self, chapters: dict[str, Chapter]) -> None:
        self.chapters = chapters
        self.layout = Layout()
        self.taken: set[tuple[int, int]] = set()

    def place(self, chapter: Chapter, first_row: int, columns: range) -> Box:
        """In the first row below all its prerequisites, as close to directly below them as there is
        space."""
        earlier = [self.layout.boxes[slug] for slug in chapter.builds_on if slug in self.placed]
        row = max([first_row, *(box.row + 1 for box in earlier)])
        near = [
            self.layout.boxes[slug]
            for slug in direct(chapter.slug, self.chapters)
            if slug in self.placed and self.placed[slug].span == 1
        ]
        while all((row, column) in self.taken for column in columns):
            row += 1
        free = [column for column in columns if (row, column) not in self.taken]
        wanted = sum(box.middle for box in near) / len(near) if near else 0
        column = min(free, key=lambda column: abs((column - 0.5) * WIDE - wanted))
        self.taken.add((row, column))
        return Box(chapter, row, column, 1)

    @property
    def placed(self) -> dict[str, Box]:
        return self.layout.boxes

    def bar(self, group: Sequence[Chapter]) -> None:
        """What comes before the book's parts: each as wide as the map."""
        for chapter in group:
            self.layout.heights.append(ROW)
            row = len(self.layout.heights)
            self.layout.boxes[chapter.slug] = Box(chapter, row, 1, COLUMNS)

    def beside(self, parts: Sequence[tuple[str, Sequence[Chapter]]]) -> None:
        """Parts side by side, under their names."""
        label = len(self.layout.heights) + 1
        span = COLUMNS // len(parts)
        columns = [range(1 + i * span, 1 + (i + 1) * span) for i in range(len(parts))]
        part_of = {c.slug: i for i, (_, group) in enumerate(parts) for c in group}
        order = sorted((c for _, group in parts for c in group), key=lambda c: c.slug)
        for chapter in order:
            where = columns[part_of[chapter.slug]]
            self.layout.boxes[chapter.slug] = self.place(chapter, label + 1, where)
        last = max(self.layout.boxes[chapter.slug].row for chapter in order)
        self.layout.heights += [LABEL, *[ROW] * (last - label)]
        for (name, _), where in zip(parts, columns, strict=True):
            self.layout.bands.append(Band(name, label, last - label + 1, where.start, span))


def _line(layout: Layout, earlier: Box, later: Box, lane: int) -> str:
    """From the foot of one box to the head of another, round the boxes between."""
    start = layout.top(earlier.row + 1) - GAP
    end = layout.top(later.row) + GAP
    from_x = later.middle if earlier.span == COLUMNS else earlier.middle
    to_x = later.middle
    between = [
        box
        for box in layout.boxes.values()
        if earlier.row < box.row < later.row and box.column == later.column and box.span == 1
    ]
    if from_x == to_x and not between:
        return f"M{from_x:g} {start}V{end}"
    if later.row == earlier.row + 1:
        bend = (start + end) / 2
        return f"M{from_x:g} {start}C{from_x:g} {bend:g} {to_x:g} {bend:g} {to_x:g} {end}"
    # Down the alley beside the later box, on the side that the line comes from.
    left = from_x < to_x or (from_x == to_x and later.column > 1)
    beside = (later.column - 1 if left else later.column) * WIDE
    alley = beside + (lane % 3 - 1) * _LANE
    into = layout.top(earlier.row + 1) + GAP
    out = layout.top(later.row) - GAP
    bend, turn = (start + into) / 2, (out + end) / 2
    return (
        f"M{from_x:g} {start}C{from_x:g} {bend:g} {alley:g} {bend:g} {alley:g} {into}"
        f"V{out}C{alley:g} {turn:g} {to_x:g} {turn:g} {to_x:g} {end}"
    )


def lay_out(chapters: dict[str, Chapter]) -> Layout:
    """The map of these chapters, which come in the order of their numbers."""
    placer = _Placer(chapters)
    groups = [
        (name, [chapter for chapter in chapters.values() if chapter.part == part])
        for part, name in enumerate(PARTS)
    ]
    placer.bar(groups[0][1])
    side_by_side = [(name, group) for name, group in groups[1:3] if group]
    if side_by_side:
        placer.beside(side_by_side)
    if groups[3][1]:
        placer.beside([groups[3]])
    layout = placer.layout
    ground = stood_on(chapters)
    for lane, slug in enumerate(layout.boxes):
        if slug in ground:
            continue
        for other in layout.boxes:
            if slug in direct(other, chapters):
                path = _line(layout, layout.boxes[slug], layout.boxes[other], lane)
                layout.lines.append(Line(slug, other, path))
    return layout
