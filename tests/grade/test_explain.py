"""What a compiler says of a submission is explained within bounds, whatever was handed in.

Messages are explained by contact-explain, in a box. Here it is asked directly: what grows without
bound costs no more than in proportion, and random questions get answers that are true of the file.
"""

from __future__ import annotations

import json
import re
import resource
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(ROOT / "tests" / "grading" / "diagnosis"), str(ROOT / "tools")]

import nasty_shapes  # noqa: E402
from sample import sample  # noqa: E402

BIN = ROOT / "build" / "dev" / "bin"
EXPLAIN = BIN / "contact-explain"
FUZZ = BIN / "explain_fuzz"
CASES = sorted((ROOT / "tests/grading/diagnosis/cases").glob("*.case"))
# The box's limits, as grading/grade/explain_box.hpp has them.
CPU_SECONDS = 2
MEMORY = 256 << 20
TOLD = 256 << 10
# Together a million questions.
SLICES = range(3)
QUESTIONS = 333_334

small = nasty_shapes.questions(10_000)
double = nasty_shapes.questions(20_000)
largest = nasty_shapes.questions((1 << 20) - 100)


def explained(question: bytes) -> dict[str, Any]:
    def limits() -> None:
        resource.setrlimit(resource.RLIMIT_CPU, (CPU_SECONDS, CPU_SECONDS))
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))

    done = subprocess.run([EXPLAIN], input=question, capture_output=True, preexec_fn=limits)
    assert done.returncode == 0, done.stderr
    assert len(done.stdout) <= TOLD
    told: dict[str, Any] = json.loads(done.stdout)
    return told


def instructions(question: bytes) -> int:
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", str(EXPLAIN)]
    done = subprocess.run(command, input=question, capture_output=True, check=True)
    counted = re.search(rb"Collected : (\d+)", done.stderr)
    assert counted, done.stderr
    return int(counted[1])


@pytest.mark.skipif(shutil.which("valgrind") is None, reason="valgrind counts the instructions")
@pytest.mark.parametrize("shape", small)
def test_twice_as_much_costs_about_twice_as_much(shape: str) -> None:
    assert instructions(double[shape]) < 2.5 * instructions(small[shape])


def test_the_largest_submission_is_explained_within_the_limits() -> None:
    for shape, question in largest.items():
        told = explained(question)
        assert told["error"]["message"], shape


@pytest.mark.parametrize(
    ("source", "line"),
    [
        ("int a;\nint b = c;\n", 2),
        ("int a;\n#line 90\nint b = c;\n", 3),
        ("int a;\n#line 2147483600\n\n\nint b = c;\n", 5),
        ('int a;\n#line 90 "other.cpp"\nint b = c;\n', 3),
        ("int a;\n# 90\nint b = c;\n", 3),
        ("int a;\n/* */ %:line 90\nint b = c;\n", 3),
        ("int a;\n#line 90\n#line 90\nint b = c;\n", 4),
        # Two lines have this number, or it is unknown which has it: none is reported.
        ("#line 90\nint b = c;\n#line 90\nint b = c;\n", 0),
        ("#define N 90\n#line N\nint b = c;\n", 0),
    ],
)
def test_a_line_is_the_one_of_the_file(source: str, line: int, tmp_path: Path) -> None:
    file = tmp_path / nasty_shapes.FILE
    file.parent.mkdir(parents=True)
    file.write_text(source)
    compiled = subprocess.run(
        ["g++", "-std=c++20", "-fsyntax-only", nasty_shapes.FILE],
        cwd=tmp_path,
        env={"PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8"},
        capture_output=True,
        text=True,
    )
    told = explained(nasty_shapes.question(source, compiled.stderr))
    (remark,) = told["remarks"]
    assert remark["line"] == line, compiled.stderr
    assert remark["column"] == (9 if line else 0)
    assert told["error"]["line"] == line


@pytest.mark.parametrize(
    "claim",
    ["2147483647:9", "400000000:1", "0:0", "3:1", "1:400000000", "9223372036854775807:1", "-1:2"],
)
def test_a_place_that_is_not_there_is_not_told(claim: str) -> None:
    log = f"{nasty_shapes.FILE}:{claim}: error: 'x' was not declared in this scope\n"
    told = explained(nasty_shapes.question("int b;\n", log))
    for place in (told["error"], *told["remarks"]):
        assert place["line"] in (0, 1)
        assert 0 <= place["column"] <= len("int b;") + 1
    assert len(told["error"]["excerpt"]) < 100


def test_what_other_files_say_is_only_counted() -> None:
    log = "/etc/secret.hpp:3:1: error: 'x' was not declared\n    3 | the secret\n      | ^\n" * 3
    told = explained(nasty_shapes.question('#include "ray_triangle.hpp"\n', log))
    assert told["remarks"] == []
    assert "3 errors lie outside of your file" in told["error"]["explanation"]
    assert "secret" not in json.dumps(told)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.stem)
def test_what_was_found_once_stays_found(case: Path, tmp_path: Path) -> None:
    fuzz("--case", case, failures=tmp_path)


@pytest.mark.parametrize("piece", sample(SLICES, len(SLICES), "random messages", kind="explain"))
def test_random_questions_get_true_answers(piece: int, tmp_path: Path) -> None:
    fuzz("--from", piece * QUESTIONS, "--runs", QUESTIONS, failures=tmp_path)


def fuzz(*words: object, failures: Path) -> None:
    command = [FUZZ, "--failures", failures, *words]
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
