"""The hints that readers have judged: that the file is whole, and names what the book has."""

from __future__ import annotations

import json
import tomllib
from collections import Counter
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
VERDICTS = ("true", "question", "misleading", "false")
KEYS = {
    "exercise",
    "line",
    "was",
    "now",
    "test",
    "inputs",
    "got",
    "right",
    "misconception",
    "hint",
    "verdict",
    "reason",
}

Row = dict[str, Any]

JUDGED: Row = json.loads((ROOT / "grading/mutants/judged.json").read_text())
ROWS: list[Row] = JUDGED["hints"]


def counts(verdicts: list[str]) -> dict[str, int]:
    counted = Counter(verdicts)
    return {verdict: counted[verdict] for verdict in VERDICTS}


def before(row: Row) -> str:
    verdict: str = row["mended"]["verdict"] if "mended" in row else row["verdict"]
    return verdict


def test_two_hundred_hints_each_drawn_once() -> None:
    assert len(ROWS) == 200
    assert len(ROWS) < JUDGED["of"]
    drawn = {
        tuple(row[key] for key in ("exercise", "line", "was", "now", "test", "inputs"))
        for row in ROWS
    }
    assert len(drawn) == len(ROWS)
    assert [row["exercise"] for row in ROWS] == sorted(row["exercise"] for row in ROWS)
    for row in ROWS:
        assert row.keys() - {"mended"} == KEYS, row
        assert row["hint"], row


def test_none_is_false_and_each_that_is_not_plainly_true_has_a_reason() -> None:
    for row in ROWS:
        assert row["verdict"] in VERDICTS, row
        assert row["verdict"] != "false", row
        assert (row["verdict"] == "true") == (row["reason"] == ""), row


def test_the_counts_before_and_after_mending_are_those_of_the_rows() -> None:
    assert JUDGED["after"] == counts([row["verdict"] for row in ROWS])
    assert JUDGED["before"] == counts([before(row) for row in ROWS])


def test_what_was_mended_has_another_text_and_says_why() -> None:
    for row in ROWS:
        if "mended" not in row:
            continue
        mended = row["mended"]
        assert mended.keys() == {"verdict", "hint", "why"}, row
        assert mended["verdict"] in VERDICTS, row
        assert mended["hint"] != row["hint"], row
        assert mended["why"], row


def test_exercises_and_misconceptions_exist() -> None:
    known = tomllib.loads((ROOT / "chapters/misconceptions.toml").read_text())
    for row in ROWS:
        exercise = ROOT / "exercises" / row["exercise"] / "exercise.toml"
        assert exercise.exists(), row
        for id_ in filter(None, row["misconception"].split(" or ")):
            assert id_ in known, row
            assert id_ in tomllib.loads(exercise.read_text())["misconceptions"], row


def test_the_judged_hints_are_those_that_are_shown() -> None:
    known = tomllib.loads((ROOT / "chapters/misconceptions.toml").read_text())
    for row in ROWS:
        if row["misconception"]:
            shown = " / ".join(known[id_]["hint"] for id_ in row["misconception"].split(" or "))
            assert row["hint"] == shown, "reworded: judge it again"
