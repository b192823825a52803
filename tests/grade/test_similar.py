"""Which answers an instructor is told are alike."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "grading")]

import outputs_class as made  # noqa: E402
from reports.fingerprints import (  # noqa: E402
    LONGEST_UNSEEN,
    fingerprints,
    tokens,
    without_comments,
)
from reports.similar import SOLUTION, Answer, main, pairs  # noqa: E402

EXERCISE = "02_triangles/ray_triangle"
GIVEN = Answer("", "")

# Each does the same in its own way.
SUM_LOOP = """double total(const double* x, int n) {
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += x[i] * x[i];
  return sum > 0 ? sum : -sum;
}
"""
SUM_WHILE = """double total(const double* x, int n) {
  double all = 0.0;
  while (n > 0) { n = n - 1; all = all + x[n] * x[n]; }
  if (all < 0) return 0 - all;
  return all;
}
"""
SUM_BACK = """double total(const double* x, int n) {
  const double first = n == 0 ? 0 : x[0] * x[0];
  return n < 2 ? first : first + total(x + 1, n - 1);
}
"""
# The first with other names, numbers, comments and layout.
DISGUISED = """double total(const double* values, int count) { // mine
  double result = 0.0; /* starts
  here */ for (int k = 0; k < count; ++k)
      result += values[k] * values[k];
  return result > 0.0 ? result : -result;
}
"""


def found(*texts: str) -> list[tuple[str, str]]:
    answers = [Answer(chr(ord("a") + i), text) for i, text in enumerate(texts)]
    return [(pair.a.who, pair.b.who) for pair in pairs(answers, GIVEN)]


def test_other_names_comments_and_layout_hide_nothing() -> None:
    assert found(SUM_LOOP, SUM_WHILE, SUM_BACK, DISGUISED) == [("a", "d")]


def test_what_many_have_is_no_sign() -> None:
    assert found(*[SUM_LOOP] * 4, SUM_WHILE) == []


def test_a_group_of_a_quarter_of_the_class_is_found() -> None:
    others = [
        f"int own_{i}(int a) {{ return a {'+' * (i % 5 + 1)} {i} {'* a' * i}; }}" for i in range(23)
    ]
    assert len(found(*[SUM_LOOP] * 7, *others)) == 21


def test_what_the_stub_has_is_no_sign() -> None:
    answers = [Answer("a", SUM_LOOP), Answer("b", SUM_LOOP)]
    assert pairs(answers, Answer("", SUM_LOOP)) == []


def test_a_pair_is_marked_where_it_is_alike() -> None:
    own_a = "int mine(int a) {\n  if (a > 3) { while (a != 7) a = a * 5 - 1; }\n  return a;\n}\n"
    own_b = "bool other(double z) {\n  return z < 1 || (z > 2 && !(z == 5)) || z * z > 9;\n}\n"
    (pair,) = pairs([Answer("a", own_a + SUM_LOOP), Answer("b", SUM_LOOP + own_b)], GIVEN)
    lines_a, lines_b = pair.marked
    assert {6, 7} <= lines_a
    assert {2, 3} <= lines_b
    assert not lines_a & {2, 3}
    assert not lines_b & {7, 8}
    assert pair.lines == 4
    assert 0.5 < pair.share < 1


@pytest.mark.parametrize("begin", range(0, 40, 7))
def test_a_shared_run_longer_than_the_longest_unseen_has_a_fingerprint(begin: int) -> None:
    """The promise of winnowing, for runs of signs that occur nowhere else."""
    signs = "+-*/%<>=!&|^~?:;,.()[]{}"
    text = " ".join(signs[i * i % 23] + signs[i % 24] for i in range(60))
    run = tokens(text)[begin : begin + LONGEST_UNSEEN + 1]
    before = tokens("; ".join("a(b)" for _ in range(30)))
    after = tokens("{ if } " * 20)
    assert fingerprints(run + after).keys() & fingerprints(before + run).keys()


def test_comments_and_literals_do_not_begin_in_each_other() -> None:
    text = 'a = "// no"; // "yes\nb = "/*"; /* " */ c'
    assert [token.kind for token in tokens(text)] == [
        *("x", "=", '""', ";"),
        *("x", "=", '""', ";", "x"),
    ]
    assert [token.line for token in tokens(text)] == [1] * 4 + [2] * 5
    assert "no" in without_comments(text)


@pytest.mark.parametrize("piece", ["/*", "/*/", '"', '"\\', "'\\", "1e+", "//", "\0", "𝔞", "(" * 9])
def test_a_long_hostile_text_is_read_to_its_end(piece: str) -> None:
    """In a time that grows with its length: a quadratic one would take hours."""
    text = piece * (300_000 // len(piece))
    assert len(Answer("a", text).tokens) <= len(text)


def results_of(folder: Path, texts: dict[str, str]) -> Path:
    listed = {
        "id": EXERCISE,
        "title": "A ray and a triangle",
        "objective": "rays",
        "max_points": 2.0,
        "tests": [{"name": "one", "points": 2.0, "visibility": "shown"}],
    }
    students = [made.submission(who, [made.absent(listed, "missing")]) for who in texts]
    (folder / "results.json").write_text(json.dumps(made.document([listed], students)))
    for who, text in texts.items():
        file = folder / ".grade" / "submissions" / who / f"{EXERCISE}.cpp"
        file.parent.mkdir(parents=True)
        file.write_text(text)
    return folder


def test_the_page_shows_both_texts_and_names_the_books_solution(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    solution = (ROOT / f"solutions/{EXERCISE}/ray_triangle.cpp").read_text()
    stub = (ROOT / f"exercises/{EXERCISE}/ray_triangle.cpp").read_text()
    texts = {"ada": solution.replace("determinant", "d"), "bo": stub, "cy": SUM_WHILE + "<script>"}
    assert main([str(results_of(tmp_path, texts)), str(ROOT)]) == 0
    said = capsys.readouterr().out
    assert f"{EXERCISE}: 3 answers, 1 pair alike where few others are." in said
    assert f"ada and {SOLUTION}" in said
    page = (tmp_path / "similar.html").read_text()
    assert page.count('class="both"') > 10
    assert "<script" not in page


def test_results_that_are_not_there_are_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([str(tmp_path / "nothing"), str(ROOT)]) == 3
    assert "results.json is not there" in capsys.readouterr().err
