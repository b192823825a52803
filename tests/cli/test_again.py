"""check: what is said when several tests fail, or the same test again and again."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from wrong_answers import wrong_answer

Run = Callable[..., subprocess.CompletedProcess[str]]
Answer = Callable[[str], Path]
Spoiled = Callable[[str], str]

pytestmark = pytest.mark.usefixtures("clean_after")

EXERCISE = "02_triangles/ray_triangle"
RANDOM = "random rays agree with exact arithmetic"
# Only the random triangles have such a vertex: others have whole numbers, or tiny ones.
FRACTION = "std::abs(triangle.a.x()) > 0.01 && triangle.a.x() != std::round(triangle.a.x())"


def by_name(contact: Run) -> dict[str, dict[str, Any]]:
    done = contact("check", "ray_triangle", "--json")
    (result,) = json.loads(done.stdout)["results"]
    return {test["name"]: test for test in result["tests"]}


def entry(work: Path) -> dict[str, Any]:
    record = json.loads((work / "progress.json").read_text())
    return dict(record["exercises"][EXERCISE])


def wrong(spoiled: Spoiled, number: int) -> str:
    """A miss for what only the random test asks; the same mistake for every number."""
    return spoiled(f"const int version = {number}; if (version > 0 && {FRACTION}) return {{}};")


def test_more_is_said_each_time_with_other_code(
    contact: Run, spoiled: Spoiled, answer: Answer, work: Path, solution: str
) -> None:
    answer(wrong(spoiled, 1))
    assert "look" not in by_name(contact)[RANDOM]
    answer("// the same, with a comment\n" + wrong(spoiled, 1).replace("  ", "    "))
    assert "look" not in by_name(contact)[RANDOM]

    answer(wrong(spoiled, 2))
    look = by_name(contact)[RANDOM]["look"]
    assert look["right"] > 0
    assert look["wrong"] > 0
    assert look["right"] + look["wrong"] == 500
    assert len(look["right_inputs"]) == len(look["wrong_inputs"]) == 3
    assert "smaller" not in look

    answer(wrong(spoiled, 3))
    failed = by_name(contact)[RANDOM]
    smaller = failed["look"]["smaller"]
    assert smaller["got"] == failed["failure"]["got"] == "nullopt"
    assert "hint" not in failed["look"]
    texts = {given["name"]: given["text"] for given in smaller["inputs"]}
    given = {given["name"]: given["text"] for given in failed["failure"]["inputs"]}
    assert len(texts["triangle"]) < len(given["triangle"]) / 2
    # What is wrong is still there: a first vertex that is no whole number.
    (x,) = re.findall(r"a: \(([^,]*),", texts["triangle"])
    assert float(x) != round(float(x))
    assert "hints_shown" not in entry(work)

    answer(wrong(spoiled, 4))
    look = by_name(contact)[RANDOM]["look"]
    assert look["hint_number"] == 1
    assert look["hint"]
    assert entry(work)["hints_shown"] == 1
    assert by_name(contact)[RANDOM]["look"]["hint_number"] == 1
    assert entry(work)["hints_shown"] == 1

    answer(wrong(spoiled, 5))
    text = contact("check", "ray_triangle").stdout
    assert re.search(r"Of 500 questions in this test, your code\s+answers \d+ right", text)
    assert "With simpler inputs it is wrong too:" in text
    assert "Hint 2: " in text
    assert entry(work)["hints_shown"] == 2

    answer(solution)
    assert by_name(contact)[RANDOM]["status"] == "passed"
    assert entry(work)["failing"] == {}


def test_a_file_elsewhere_is_not_counted(contact: Run, spoiled: Spoiled, tmp_path: Path) -> None:
    for number in range(1, 4):
        (tmp_path / "ray_triangle.cpp").write_text(wrong(spoiled, number))
        done = contact("check", str(tmp_path / "ray_triangle.cpp"), "--json")
        assert '"look"' not in done.stdout


def test_one_mistake_is_told_once(contact: Run, answer: Answer) -> None:
    answer(wrong_answer(EXERCISE, "direction_normalised").read_text())
    tests = by_name(contact)
    first = "t is in multiples of the direction as it is given"
    assert tests[first]["failure"]["misconceptions"] == ["direction-normalised"]
    assert tests[RANDOM]["failure"]["misconceptions"] == ["direction-normalised"]
    assert tests[RANDOM]["same_as"] == first
    assert "same_as" not in tests[first]
    text = contact("check", "ray_triangle", "--all").stdout
    assert re.sub(r"\s+", " ", text).count(f"The same mistake also fails: {RANDOM}.") == 1


def test_one_crash_is_told_once(contact: Run, spoiled: Spoiled, answer: Answer) -> None:
    answer(spoiled("std::abort();"))
    first, *others = by_name(contact).values()
    assert {test["same_as"] for test in others} == {first["name"]}
    text = contact("check", "ray_triangle", "--all").stdout
    assert text.count("aborted") == 1


def test_two_wrong_answers_without_an_explanation_stay_two(
    contact: Run, spoiled: Spoiled, answer: Answer
) -> None:
    answer(spoiled("return {{{7, {7, 7, 7}}}};"))
    tests = by_name(contact).values()
    unexplained = [test for test in tests if not test.get("failure", {}).get("misconceptions")]
    assert len(unexplained) > 1
    assert not any("same_as" in test for test in unexplained)
