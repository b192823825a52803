"""What the tables of hard cases and of measurements show, and what they leave out."""

from __future__ import annotations

from typing import Any

import pytest
from contact_book.errors import BookError
from contact_book.hard_cases import chosen, in_words
from contact_book.ladder import columns


def test_chosen_cases_keep_their_order() -> None:
    cases = [{"name": name} for name in ("one", "two", "three")]
    assert chosen(cases, []) == cases
    assert chosen(cases, ["three", "one"]) == [cases[0], cases[2]]
    with pytest.raises(BookError, match='there is no hard case "four"'):
        chosen(cases, ["one", "four"])


def measured(median: float | None, largest: float | None) -> dict[str, Any]:
    time = {"ns_median": 2.0, "ns_q1": 1.0, "ns_q3": 3.0}
    error = {"error_median": median, "error_max": largest}
    row = {"family": "f", "method": "m", "n": 1000, "wrong": 7, **error, **time}
    return {
        "families": [{"id": "f", "title": "points"}],
        "methods": [{"id": "m", "title": "sum", "scalar": "float"}],
        "results": [row],
    }


def test_a_ladder_without_errors_has_no_columns_for_them() -> None:
    heads, rows = columns(measured(None, None))
    assert heads == ["Inputs", "Method", "Wrong answers", "Time, ns: median (quartiles)"]
    assert rows == [["points", "sum, float", "7 of 1,000", "2 (1–3)"]]


def test_an_error_that_a_row_has_is_shown() -> None:
    heads, rows = columns(measured(None, 0.5))
    assert heads[3] == "Largest error"
    assert rows[0][3] == "0.5"


def test_a_case_keeps_the_sign_of_its_exponent() -> None:
    assert in_words("thrown-at-1e-200-metres") == "thrown at 1e-200 metres"
