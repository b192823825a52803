"""How an exercise is tied to a figure: a tie that fits neither is refused."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from contact_book.errors import BookError
from contact_book.try_mine import parameters, tie

FIGURE = """// FIGURE(Old, FIELDS(x), Old, FIELDS(y)) in a comment is none.
FIGURE(Input, FIELDS(mass, velocity, e), Output,
       FIELDS(problem, after,
              approach, place))
"""
CONTRACT = """#pragma once
namespace exercise {
struct Body {
  double mass;  ///< kg
};
/// not_declared(a, b);
double collide(const Body& first, const std::array<double, 2>& masses,
               double e);
}  // namespace exercise
"""
OPTIONS = {"figure": "head_on", "call": "collide({mass, velocity.x()}, {1, 2}, e)"}
ROWS = ["after: mine = after if approach"]


def tied(folder: Path, options: dict[str, str], rows: list[str]) -> dict[str, Any] | None:
    (folder / "figures").mkdir(exist_ok=True)
    (folder / "figures" / "head_on.cpp").write_text(FIGURE)
    (folder / "figures" / "head_on.ts").write_text('{ label: "head-on", fields: { e: 1 } }')
    contract = folder / "collide.hpp"
    contract.write_text(CONTRACT)
    chapter: Any = SimpleNamespace(slug="13_lines", folder=folder, figures=["head_on"])
    book: Any = SimpleNamespace(relative=lambda path: path.name)
    return tie(book, chapter, contract, options, rows)


def test_a_tie_names_the_fields_that_go_to_the_function(tmp_path: Path) -> None:
    found = tied(tmp_path, {**OPTIONS, "only-for": "e = 1: elastic bodies"}, ROWS)
    assert found is not None
    assert found["figure"] == "13_lines/head_on"
    assert found["fields"] == ["mass", "velocity", "e"]
    assert found["only"] == {"field": "e", "value": 1.0, "words": "elastic bodies"}
    assert found["rows"] == [
        {"label": "after", "mine": "mine", "book": "after", "index": None, "when": "approach"}
        | {"asked": None}
    ]


def test_a_contract_may_be_about_what_the_figure_computes(tmp_path: Path) -> None:
    options = {**OPTIONS, "only-for": "approach = 1: bodies that approach", "start": "head-on"}
    found = tied(tmp_path, options, ROWS)
    assert found is not None
    assert (found["only"]["field"], found["start"]) == ("approach", "head-on")


def test_a_row_may_be_compared_only_sometimes(tmp_path: Path) -> None:
    found = tied(tmp_path, OPTIONS, ["after: mine = after while approach"])
    assert found is not None
    assert (found["rows"][0]["when"], found["rows"][0]["asked"]) == (None, "approach")


def test_most_exercises_have_no_figure(tmp_path: Path) -> None:
    assert tied(tmp_path, {}, []) is None


def test_a_comma_of_a_template_separates_no_parameters() -> None:
    assert parameters(CONTRACT) == {"collide": 3}


@pytest.mark.parametrize(
    ("options", "rows", "message"),
    [
        ({"figure": "head"}, ROWS, "unknown figure 'head'"),
        ({"call": "collide({mas, 1}, {1, 2}, e)"}, ROWS, "unknown field 'mas' in figure head_on"),
        ({"call": "colide({mass, 1}, {1, 2}, e)"}, ROWS, "unknown function 'colide'"),
        ({"call": "collide({mass, 1}, e)"}, ROWS, "gives 2 arguments, and collide has 3"),
        ({"call": "collide({1, 1}, {1, 2}, 1)"}, ROWS, "uses no field of figure head_on"),
        ({"only-for": "k = 1: elastic bodies"}, ROWS, "unknown field 'k'"),
        (
            {"start": "sidelong"},
            ROWS,
            ":start: is a state of figure head_on, and 'sidelong' is none",
        ),
        ({"only-for": "e is 1"}, ROWS, ":only-for: is FIELD = NUMBER: WORDS"),
        ({}, ["after: mine = afterwards"], "unknown field 'afterwards'"),
        ({}, ["after: mine = after if hit"], "unknown field 'hit'"),
        ({}, ["after: yours = after"], "is not LABEL: mine... = FIELD"),
        ({}, [], "needs a line LABEL: mine... = FIELD"),
    ],
)
def test_what_fits_neither_is_refused(
    tmp_path: Path, options: dict[str, str], rows: list[str], message: str
) -> None:
    with pytest.raises(BookError) as error:
        tied(tmp_path, {**OPTIONS, **options}, rows)
    assert message in str(error.value)


def test_a_call_without_a_figure_is_refused(tmp_path: Path) -> None:
    with pytest.raises(BookError, match="needs :figure:"):
        tied(tmp_path, {"call": OPTIONS["call"]}, ROWS)
