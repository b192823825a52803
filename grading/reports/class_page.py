"""class.html: the results of the class, for teaching. It is meant to be projected."""

from __future__ import annotations

from markupsafe import Markup

from reports.class_data import STATES, ClassData
from reports.page import render

# How the bar of an exercise is filled for each state.
FILLS = {
    "passed": "fill-right",
    "failed": "fill-wrong",
    "does_not_compile": "fill-warn",
    "refused": "fill-refused",
}
WIDTH = 480
HEIGHT = 192
BASE = 150


def class_page(data: ClassData, again: str = "") -> str:
    """The whole page. `again` is the command that grades what could not be."""
    return render(
        "class.html",
        data=data,
        again=again,
        states=STATES,
        fills=list(FILLS.items()),
        histogram=histogram(data.bins),
        bins=_bin_names(data),
    )


def histogram(bins: list[int]) -> Markup:
    """How many students have which share of the points, as a picture. Numbers only come in."""
    most = max([*bins, 1])
    wide = WIDTH / len(bins)
    parts = []
    for place, count in enumerate(bins):
        tall = round(count / most * (BASE - 26), 1)
        x = round(place * wide + 4, 1)
        middle = round(place * wide + wide / 2, 1)
        if count:
            parts.append(
                f'<rect class="bar" x="{x}" y="{BASE - tall}" width="{wide - 8}" height="{tall}"/>'
                f'<text class="count" x="{middle}" y="{BASE - tall - 6}">{count}</text>'
            )
        parts.append(f'<text class="tick" x="{place * wide}" y="{BASE + 19}">{place * 10}</text>')
    parts.append(f'<text class="tick" x="{WIDTH}" y="{BASE + 19}">100</text>')
    parts.append(f'<line class="axis" x1="0" y1="{BASE}" x2="{WIDTH}" y2="{BASE}"/>')
    parts.append(
        f'<text class="tick" x="{WIDTH // 2}" y="{BASE + 39}">percent of all points</text>'
    )
    return Markup(
        f'<svg class="histogram" viewBox="-14 0 {WIDTH + 28} {HEIGHT}" aria-hidden="true">'
        f"{''.join(parts)}</svg>"
    )


def _bin_names(data: ClassData) -> list[tuple[str, int]]:
    step = 100 // len(data.bins)
    names = [f"{start} to under {start + step} %" for start in range(0, 100 - step, step)]
    names.append(f"{100 - step} to 100 %")
    return list(zip(names, data.bins, strict=True))
