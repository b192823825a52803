"""Mutants of the solutions: what is changed, and that one program with a switch does the same as
one program for each of them."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "grading/mutants")]

import campaign  # noqa: E402
import mutants as program  # noqa: E402
import trial  # noqa: E402
from mutate import Mutant, mutants_of, switched  # noqa: E402

SOURCE = """\
#include <algorithm>
#include <cmath>
#include <vector>

int sum_of(const std::vector<int>& values, int most) {
  int sum = 0;
  for (int value : values) {
    if (value < 0) continue;  // a comment
    if (value > most || value == 7) break;
    sum += 2 * value - 1;
  }
  return sum;
}

double area(double a, double b) {
  const double half = std::max(a, b) / 2;
  return std::sqrt(half) * (a <= b ? -half : std::abs(a - b));
}
"""
MAIN = """
int main() {
  std::printf("%d %d %.17g %.17g\\n", sum_of({3, -1, 4, 7, 2}, 9), sum_of({1, 3, 12, 5}, 11),
              area(3, 5), area(6, 4));
}
"""


def changes(source: str) -> set[tuple[str, str]]:
    return {mutant.key for mutant in mutants_of(source)}


def test_what_is_changed() -> None:
    found = changes(SOURCE)
    for change in (
        ("value < 0", "value <= 0"),
        ("value == 7", "value != 7"),
        ("value > most || value == 7", "value > most && value == 7"),
        ("continue;", ";"),
        ("sum += 2 * value - 1;", "sum -= 2 * value - 1;"),
        ("sum += 2 * value - 1;", ";"),
        ("2 * value - 1", "2 * value + 1"),
        ("7", "8"),
        ("7", "6"),
        ("std::max(a, b)", "std::min(a, b)"),
        ("std::max(a, b)", "std::max(b, a)"),
        ("std::sqrt(half)", "(half)"),
        ("std::abs(a - b)", "(a - b)"),
        ("-half", "(half)"),
        ("a - b", "b - a"),
        ("value < 0", "false"),
    ):
        assert change in found, change


def test_what_the_compiler_evaluates_is_left_alone() -> None:
    assert (
        changes("constexpr double kMost = 2;\nstd::array<int, 3> three;\nint four[4];\n") == set()
    )
    assert changes('#include "x.hpp"\nconst char* text = "1 + 2";\n') == set()


def test_what_can_change_no_value_is_not_tried() -> None:
    found = changes("double f(V u) { return u.norm() == 0 ? std::fma(a, b, c) : u.norm(); }\n")
    assert ("std::fma(a, b, c)", "std::fma(a, c, b)") in found
    assert ("std::fma(a, b, c)", "std::fma(b, a, c)") not in found
    lengths = "bool f(V u) { return u.norm() == 0 && 0.0 != u.squaredNorm(); }\n"
    assert (
        changes(lengths)
        & {
            ("u.norm()", "u.squaredNorm()"),
            ("u.squaredNorm()", "u.norm()"),
        }
        == set()
    )
    assert ("u.norm()", "u.squaredNorm()") in changes("bool f(V u) { return u.norm() <= 1; }\n")


def with_change(mutant: Mutant) -> str:
    data = SOURCE.encode()
    return (data[: mutant.start] + mutant.now.encode() + data[mutant.end :]).decode()


def build(text: str, program: Path) -> None:
    file = program.with_suffix(".cpp")
    file.write_text("#include <cstdio>\n" + text)
    command = ["c++", "-std=c++20", "-w", str(file), "-o", str(program)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_the_switch_does_what_each_change_does(tmp_path: Path) -> None:
    mutants = mutants_of(SOURCE)
    assert len(mutants) > 30
    build(switched(SOURCE, mutants)[0] + MAIN, tmp_path / "switched")
    whole = SOURCE.partition("\n\n")[0] + "\n"
    for number, text in enumerate([SOURCE, *map(with_change, mutants)]):
        body = text.partition("\n\n")[2]
        printing = MAIN.replace("int main()", "void run()")
        whole += f"namespace m{number} {{\n{body}\n{printing}}}\n"
    calls = "".join(f"m{number}::run();" for number in range(len(mutants) + 1))
    build(whole + f"int main() {{ {calls} }}\n", tmp_path / "each")
    wanted = subprocess.check_output([tmp_path / "each"], text=True).splitlines()
    for number, line in enumerate(wanted):
        environment = {**os.environ, "CONTACT_MUTANT": str(number)}
        got = subprocess.check_output([tmp_path / "switched"], text=True, env=environment)
        assert got.strip() == line, number
    assert len(set(wanted)) > len(wanted) // 2


def test_mutants_that_do_not_compile_are_left_out_and_the_others_stay(tmp_path: Path) -> None:
    source = "int* next(int* p, int n) {\n  int* q = p + n;\n  return q - n > p ? q : p;\n}\n"
    stub = tmp_path / "tests.cpp"
    stub.write_text("int main() {}\n")
    tests = tmp_path / "tests.o"
    subprocess.run(["c++", "-c", str(stub), "-o", str(tests)], check=True)
    bundle = trial.Bundle("c++", ("-std=c++20",), (), tests)
    _, kept, refused = campaign.compiled(bundle, source, tmp_path)
    assert ("p + n", "p - n") in {one.key for one in kept}
    assert ("q - n", "n - q") in {one.key for one in refused}
    assert {one.number for one in kept}.isdisjoint(one.number for one in refused)
    assert len(kept) + len(refused) == len(mutants_of(source))


def tried(was: str, now: str, line: str, status: str) -> campaign.Tried:
    mutant = Mutant(1, 0, 1, 1, "constant", was, now, statement=False)
    return campaign.Tried(mutant, line, trial.Trial(status, "a test", {}, 0.0))


def test_an_equivalent_mutant_needs_a_reason_and_must_exist_and_survive(tmp_path: Path) -> None:
    file = tmp_path / "equivalent.toml"
    entry = '[[mutant]]\nline = "x = 3;"\nwas = "3"\nnow = "4"\nwhy = "{}"\n'
    file.write_text(entry.format("both are odd"))
    known = campaign.Equivalents.read(file)
    assert known.problems([tried("3", "4", "x = 3;", "passed")]) == []
    (gone,) = known.problems([tried("3", "4", "y = 3;", "passed")])
    assert "there is no such mutant" in gone
    (caught,) = known.problems([tried("3", "4", "x = 3;", "failed")])
    assert "'a test' catches it" in caught
    file.write_text(entry.format(" "))
    with pytest.raises(trial.TrialError, match="each"):
        campaign.Equivalents.read(file)


def test_counts_are_kept_by_chapter_and_others_stay(tmp_path: Path) -> None:
    one = campaign.Result("03_x/first", killed=[tried("3", "4", "x = 3;", "failed")])
    two = campaign.Result("03_x/second", survivors=[tried("3", "4", "x = 3;", "passed")])
    program.keep([one], tmp_path)
    program.keep([two], tmp_path)
    kept = json.loads((tmp_path / "03_x.json").read_text())
    assert (kept["first"]["killed"], kept["first"]["no_hint"]) == (1, 1)
    assert (kept["second"]["mutants"], kept["second"]["left"]) == (1, 1)


def test_kept_counts_that_are_not_those_of_a_run_are_a_problem(tmp_path: Path) -> None:
    caught = campaign.Result("03_x/first", killed=[tried("3", "4", "x = 3;", "failed")])
    (missing,) = program.out_of_date(caught, tmp_path)
    assert "no counts are kept" in missing
    program.keep([caught], tmp_path)
    assert program.out_of_date(caught, tmp_path) == []
    left = campaign.Result("03_x/first", survivors=[tried("3", "4", "x = 3;", "passed")])
    problems = program.out_of_date(left, tmp_path)
    assert [one.split(":")[0] for one in problems] == ["killed", "left"]
    noted = trial.Trial("failed", "a test", {"observed": "twice as large"}, 0.0)
    said = campaign.Result("03_x/first", killed=[replace(caught.killed[0], trial=noted)])
    problems = program.out_of_date(said, tmp_path)
    assert [one.split(":")[0] for one in problems] == ["noted", "no_hint"]


def test_a_sample_is_drawn_by_its_seed_and_has_the_fields_of_what_is_judged() -> None:
    failure = {"inputs": [{"name": "x", "text": "3"}], "observed": "twice as large"}
    one = replace(
        tried("3", "4", "x = 3;", "failed"), trial=trial.Trial("failed", "a test", failure, 0.0)
    )
    killed = [replace(one, mutant=replace(one.mutant, number=number)) for number in range(9)]
    result = campaign.Result("03_x/first", killed=killed)
    drawn = program.sample([result], {}, 4, "a seed")
    assert drawn == program.sample([result], {}, 4, "a seed")
    rows = json.loads(drawn)["hints"]
    judged = json.loads((ROOT / "grading/mutants/judged.json").read_text())["hints"]
    assert len(rows) == 4
    assert {frozenset(row) for row in rows} == {frozenset(judged[0])}
    assert {row["verdict"] for row in rows} == {""}
