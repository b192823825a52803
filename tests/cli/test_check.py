"""check: verdicts on right, wrong and hostile answers to ray_triangle."""

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
ROOT = Path(__file__).resolve().parents[2]

pytestmark = pytest.mark.usefixtures("clean_after")

# Holds in exactly one test, the one about rays without a direction.
NO_DIRECTION = "ray.direction.norm() == 0"
PARALLEL = "a parallel ray, a direction of length zero and a triangle without area give no hit"


def verdict(contact: Run, *words: str, **extra: str) -> dict[str, Any]:
    done = contact("check", "ray_triangle", "--json", *words, **extra)
    assert done.returncode in (0, 1), done.stderr
    document = json.loads(done.stdout)
    assert document["format"] == "contact-check/2"
    (result,) = document["results"]
    assert (done.returncode == 0) == (result["verdict"] == "passed")
    return dict(result)


def only_failure(result: dict[str, Any], status: str) -> dict[str, Any]:
    """The one test that did not pass; every other one must have run and passed."""
    (failed,) = [test for test in result["tests"] if test["status"] != "passed"]
    assert failed["name"] == PARALLEL
    assert failed["status"] == status
    assert failed["points"] == 0
    return dict(failed["failure"])


def test_the_solution_passes(contact: Run, solution: str, answer: Answer) -> None:
    answer(solution)
    result = verdict(contact)
    assert result["verdict"] == "passed"
    assert result["points"] == result["max_points"] > 0
    assert result["seconds"]["compile"] > 0


def test_a_stub_is_not_attempted(contact: Run) -> None:
    contact("start", "ray_triangle")
    result = verdict(contact)
    assert result["verdict"] == "not_attempted"
    assert {test["status"] for test in result["tests"]} == {"not_attempted"}


def test_a_wrong_answer_is_told_whole(contact: Run, answer: Answer) -> None:
    wrong = wrong_answer("02_triangles/ray_triangle", "touching_rejected")
    answer(wrong.read_text())
    done = contact("check", "ray_triangle")
    assert done.returncode == 1
    labels = ["asked ", "input ", "got ", "right ", "hint "]
    places = [re.search(rf"^ +{label}", done.stdout, re.MULTILINE) for label in labels]
    assert all(places)
    assert [place.start() for place in places if place] == sorted(
        place.start() for place in places if place
    )
    (failed,) = [test for test in verdict(contact)["tests"] if test["status"] == "failed"]
    assert failed["failure"]["misconceptions"] == ["touching-rejected"]
    assert failed["failure"]["hint"]


def test_a_crash_costs_its_own_test_only(
    contact: Run, spoiled: Callable[[str], str], answer: Answer
) -> None:
    answer(spoiled(f"if ({NO_DIRECTION}) *static_cast<volatile int*>(nullptr) = 1;"))
    failure = only_failure(verdict(contact), "stopped")
    assert "segmentation fault" in failure["reason"]
    assert failure["asked"]
    assert [given["name"] for given in failure["inputs"]] == ["ray", "triangle"]


def test_an_assertion_is_quoted(
    contact: Run, spoiled: Callable[[str], str], answer: Answer
) -> None:
    answer(spoiled(f"std::vector<double> v(3); if ({NO_DIRECTION}) return {{{{v[7], {{}}}}}};"))
    reason = only_failure(verdict(contact), "stopped")["reason"]
    assert reason.startswith("aborted")
    assert "size()" in reason


def test_an_endless_loop_is_stopped(
    contact: Run, spoiled: Callable[[str], str], answer: Answer
) -> None:
    answer(spoiled(f"for (volatile int i = 0; {NO_DIRECTION};) i = i + 1;"))
    failure = only_failure(verdict(contact), "stopped")
    assert "endless loop" in failure["reason"]
    assert [given["name"] for given in failure["inputs"]] == ["ray", "triangle"]


def test_a_memory_bomb_is_stopped(
    contact: Run, spoiled: Callable[[str], str], answer: Answer
) -> None:
    answer(spoiled(f"std::vector<double> v; while ({NO_DIRECTION}) v.resize(2 * v.size() + 1);"))
    failed = verdict(contact)
    (test,) = [test for test in failed["tests"] if test["status"] != "passed"]
    assert test["name"] == PARALLEL
    assert "memory" in json.dumps(test["failure"])


def test_runaway_output_is_stopped(
    contact: Run, spoiled: Callable[[str], str], answer: Answer
) -> None:
    answer(spoiled(f'while ({NO_DIRECTION}) std::puts("again");'))
    result = verdict(contact)
    failure = only_failure(result, "stopped")
    assert "printed" in failure["reason"]
    assert [given["name"] for given in failure["inputs"]] == ["ray", "triangle"]
    assert len(result["output"]) < 3_000_000


def test_exit_earns_nothing(contact: Run, spoiled: Callable[[str], str], answer: Answer) -> None:
    answer(spoiled(f"if ({NO_DIRECTION}) std::exit(0);"))
    failure = only_failure(verdict(contact), "stopped")
    assert "exit" in failure["reason"]
    assert [given["name"] for given in failure["inputs"]] == ["ray", "triangle"]


def test_exit_before_main_earns_nothing(contact: Run, solution: str, answer: Answer) -> None:
    answer(solution + "\nstruct Early { Early() { std::_Exit(0); } } early;\n")
    result = verdict(contact)
    assert result["points"] == 0
    assert {test["status"] for test in result["tests"]} == {"stopped"}


def test_an_exception_is_told(contact: Run, spoiled: Callable[[str], str], answer: Answer) -> None:
    answer(spoiled(f'if ({NO_DIRECTION}) throw std::runtime_error("lost my way");'))
    failure = only_failure(verdict(contact), "stopped")
    assert "lost my way" in failure["reason"]
    assert failure["asked"]
    assert failure["inputs"]


def test_a_child_of_the_answer_does_not_outlive_it(
    contact: Run, solution: str, answer: Answer, tmp_path: Path
) -> None:
    left = tmp_path / "left"
    answer(
        "#include <fstream>\n#include <unistd.h>\n"
        + solution
        + f'\nstatic const int child = [] {{ if (fork() == 0) {{ sleep(3); std::ofstream("{left}");'
        " _exit(0); } return 0; }();\n"
    )
    verdict(contact)
    subprocess.run(["sleep", "4"], check=True)
    assert not left.exists()


def test_what_the_answer_prints_is_shown(
    contact: Run, spoiled: Callable[[str], str], answer: Answer
) -> None:
    answer(spoiled('static int once = std::puts("here I am"); (void)once;'))
    assert "here I am" in contact("check", "ray_triangle").stdout


def compile_error(contact: Run) -> dict[str, Any]:
    result = verdict(contact)
    assert result["verdict"] == "does_not_compile"
    assert result["points"] == 0
    return dict(result["compile_error"])


def test_a_syntax_error_names_its_line(
    contact: Run, spoiled: Callable[[str], str], answer: Answer
) -> None:
    copy = answer(spoiled("double x = 1"))
    error = compile_error(contact)
    assert Path(error["file"]) == copy
    lines = copy.read_text().splitlines()
    assert lines[error["line"] - 1].strip() == "double x = 1"
    assert "^" in error["excerpt"]
    text = contact("check", "ray_triangle").stdout
    assert len(text.splitlines()) < 15


def test_an_error_inside_eigen_is_told_at_the_students_line(
    contact: Run, spoiled: Callable[[str], str], answer: Answer
) -> None:
    statement = "const Eigen::Vector2d flat = ray.origin; (void)flat;"
    copy = answer(spoiled(statement))
    error = compile_error(contact)
    assert Path(error["file"]) == copy
    assert copy.read_text().splitlines()[error["line"] - 1] == statement
    assert "sizes" in error["explanation"]
    assert len(contact("check", "ray_triangle").stdout.splitlines()) < 15
    full = contact("check", "ray_triangle", "--full").stdout
    assert "Eigen/src" in full


def test_a_missing_function_shows_the_contract(contact: Run, solution: str, answer: Answer) -> None:
    answer(solution.replace(" ray_triangle(", " ray_triangel("))
    error = compile_error(contact)
    assert "ray_triangle is declared in the contract but not defined" in error["message"]
    assert "ray_triangel" in error["explanation"]
    (line,) = error["contract"]
    declared = Path(line["file"]).read_text().splitlines()[line["line"] - 1]
    assert declared in line["text"]
    assert "ray_triangle(" in line["text"]


def test_a_wrong_parameter_shows_both(contact: Run, solution: str, answer: Answer) -> None:
    answer(
        solution.replace(
            "const contact::Triangle<double>& triangle", "contact::Triangle<double> triangle"
        )
    )
    error = compile_error(contact)
    assert "parameters are not the contract's" in error["explanation"]
    assert error["contract"]


def test_a_wrong_result_shows_the_contract(contact: Run, answer: Answer) -> None:
    answer(
        '#include "ray_triangle.hpp"\nnamespace exercise {\n'
        "bool ray_triangle(const contact::Ray<double>&, const contact::Triangle<double>&) "
        "{ return false; }\n}\n"
    )
    error = compile_error(contact)
    assert "return type" in error["explanation"]
    assert "ray_triangle(" in error["contract"][0]["text"]


def test_a_definition_outside_the_namespace_is_told(
    contact: Run, solution: str, answer: Answer
) -> None:
    answer(solution.replace("namespace exercise", "namespace excercise"))
    assert "not in namespace exercise" in compile_error(contact)["explanation"]


def test_a_main_of_ones_own_is_told(contact: Run, solution: str, answer: Answer) -> None:
    answer(solution + "\nint main() {}\n")
    assert "main" in compile_error(contact)["message"]


def test_a_file_of_any_place_can_be_checked(contact: Run, solution: str, tmp_path: Path) -> None:
    elsewhere = tmp_path / "ray_triangle.cpp"
    elsewhere.write_text(solution)
    assert contact("check", str(elsewhere)).returncode == 0
    assert contact("check", str(tmp_path / "absent" / "ray_triangle.cpp")).returncode == 2


def test_without_a_name_all_that_was_changed_is_checked(
    contact: Run, solution: str, answer: Answer
) -> None:
    assert contact("check").returncode == 1
    contact("start", "02_triangles")
    answer(solution)
    done = contact("check", "--json")
    assert done.returncode == 0
    document = json.loads(done.stdout)
    assert [result["exercise"] for result in document["results"]] == ["02_triangles/ray_triangle"]
    assert "02_triangles/ray_triangle" not in document["untouched"]
    assert document["untouched"]


def test_no_colour_in_a_pipe(contact: Run, solution: str, answer: Answer) -> None:
    answer(solution)
    assert "\x1b[" not in contact("check", "ray_triangle").stdout


def test_a_memory_limit_that_is_no_number_is_trouble(
    contact: Run, solution: str, answer: Answer
) -> None:
    answer(solution)
    assert contact("check", "ray_triangle", CONTACT_MEMORY_MB="lots").returncode == 3
