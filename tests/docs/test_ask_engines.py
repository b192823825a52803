"""The page "Ask the engines": numbers as they are written, and rows of its tables."""

from __future__ import annotations

import json
from typing import Any

import pytest
from contact_book.ask_engines import RECORD, error_of, milliseconds, number, row
from sample_book import ROOT

ENGINE: dict[str, Any] = {"id": "rapier3d", "title": "Rapier", "iterations": "iterations"}
QUESTION: dict[str, Any] = {"id": "fall", "duration": 1, "unit": "m"}


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (9600, "9600"),
        (-3.009, "−3.009"),
        (0, "0"),
        (None, "none"),
        (-7.0259e-05, "−7 · 10<sup>−5</sup>"),
    ],
)
def test_a_value_has_ten_digits_or_a_power_of_ten(value: float | None, text: str) -> None:
    assert number(value) == text


@pytest.mark.parametrize(
    ("error", "text"),
    [
        (0, "0"),
        (186, "190"),
        (0.02083, "0.021"),
        (2288, "2.3 · 10<sup>3</sup>"),
        (9.99e-9, "1 · 10<sup>−8</sup>"),
        (None, "–"),
    ],
)
def test_an_error_has_two_digits(error: float | None, text: str) -> None:
    assert error_of(error) == text


def test_a_time_is_in_milliseconds_or_seconds() -> None:
    assert [milliseconds(ms) for ms in (0.0281, 13.4, 5900)] == ["0.028 ms", "13 ms", "5.9 s"]


def test_an_engine_that_was_not_asked_says_so() -> None:
    assert "does not answer this" in row(ENGINE, QUESTION, None)


def test_a_row_shows_the_settings_of_the_best_answer() -> None:
    best = {"value": 15.0, "error": 1e-3, "ms": 2, "settings": {"step": 1 / 480, "iterations": 16}}
    shown = row(ENGINE, QUESTION, {"value": 14.9, "error": 0.1, "ms": 1, "best": best})
    assert "step 1/480 s, 16 iterations" in shown


def test_what_an_engine_threw_is_escaped() -> None:
    answer = {"value": None, "error": None, "ms": 1, "failed": "a < b"}
    assert "a &lt; b" in row({**ENGINE, "id": "book"}, QUESTION, answer)


def test_the_record_has_twenty_questions_and_an_answer_of_the_book_to_each() -> None:
    record = json.loads((ROOT / RECORD).read_text(encoding="utf-8"))
    asked = [question["id"] for question in record["questions"]]
    assert len(asked) >= 20
    assert all("book" in record["answers"][name] for name in asked)
