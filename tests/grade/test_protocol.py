"""What is answered from a box gets the verdict that it gets where tests and answer are one program.

Whatever a submission does in its own process, all that it can do is answer: badly, too early, or
not at all.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import textwrap
from pathlib import Path
from typing import Any

import pytest
from sample import sample
from wrong_answers import wrong_answers

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build" / "dev" / "bin" / "contact"
EXERCISES = sorted(
    f"{toml.parent.parent.name}/{toml.parent.name}"
    for toml in ROOT.glob("exercises/*/*/exercise.toml")
)
NAME = "01_planes/signed_distance"
# One exercise of so many is taken in a turn.
EACH = 3
SOLUTION = (ROOT / "solutions" / NAME / "signed_distance.cpp").read_text()
DISTANCE = "return (normal.dot(point) + plane.d) / normal.norm();"

Result = dict[str, Any]


def run(*words: str | Path) -> list[Result]:
    done = subprocess.run(
        [str(PROGRAM), *map(str, words)],
        capture_output=True,
        text=True,
        env={**os.environ, "CONTACT_ROOT": str(ROOT)},
        stdin=subprocess.DEVNULL,
        timeout=600,
    )
    assert done.returncode in (0, 1), done.stderr
    results: list[Result] = json.loads(done.stdout)["results"]
    return results


def check(*files: Path) -> list[Result]:
    return run("check", "--json", *files)


def grade(*files: Path, seconds: float = 0, compile_seconds: float = 0) -> list[Result]:
    limits = ("--seconds", str(seconds), "--compile-seconds", str(compile_seconds))
    return run("dev", "grade-unit", "--as-built", "--json", *limits, *files)


def without_times(result: Result) -> Result:
    """What must be the same: all but times, and where the file lies."""
    kept = {
        key: value
        for key, value in result.items()
        if key not in ("code", "file", "seconds", "near_limit", "slowest_test", "diagnostics")
    }
    kept["tests"] = [
        {key: value for key, value in test.items() if key != "seconds"} for test in kept["tests"]
    ]
    # A check of one's own stops an endless loop sooner than a grading does.
    for test in kept["tests"]:
        if "reason" in test.get("failure", {}):
            reason = re.sub(r"after [\d.]+ seconds?", "after a time", test["failure"]["reason"])
            test["failure"] = {**test["failure"], "reason": reason}
    kept["diagnostics"] = [{**remark, "file": ""} for remark in result["diagnostics"]]
    return kept


def answer(folder: Path, text: str) -> Path:
    file = folder / "01_planes" / "signed_distance.cpp"
    file.parent.mkdir(exist_ok=True)
    file.write_text(text)
    return file


def with_distance(body: str) -> str:
    assert DISTANCE in SOLUTION
    return SOLUTION.replace(DISTANCE, body)


def statuses(result: Result) -> list[str]:
    return [test["status"] for test in result["tests"]]


def reasons(result: Result) -> set[str]:
    return {test["failure"]["reason"] for test in result["tests"] if test["status"] == "stopped"}


@pytest.mark.parametrize(
    "exercise", sample(EXERCISES, EACH, "exercises graded as checked", kind="exercises")
)
def test_answers_of_the_book_get_the_verdict_of_a_check(exercise: str) -> None:
    name = exercise.split("/")[1]
    solutions = ROOT / "solutions" / exercise
    wrong = wrong_answers(exercise)
    files = [
        solutions / f"{name}.cpp",
        ROOT / "exercises" / exercise / f"{name}.cpp",
        *sample(wrong, 2, "", within=EACH),
    ]
    checked, graded = check(*files), grade(*files)
    assert len(checked) == len(graded) == len(files) > 2
    for file, one, other in zip(files, checked, graded, strict=True):
        assert without_times(other) == without_times(one), file
        # An answer that is stopped has reached the limit.
        assert "stopped" in statuses(other) or not other["near_limit"], file
    assert [result["verdict"] for result in graded[:2]] == ["passed", "not_attempted"]


SAME = {
    "not a number": with_distance('return std::nan("");'),
    "minus zero": with_distance("return 0.0 * -1.0;"),
    "infinite": with_distance("return std::numeric_limits<double>::infinity();"),
    "invalid argument": with_distance('throw std::invalid_argument("no \\xff such plane");'),
    "runtime error": with_distance('throw std::runtime_error("thrown on purpose");'),
    "out of memory": with_distance("throw std::bad_alloc();"),
    "no exception": with_distance("throw 42;"),
    "of its own": with_distance("struct Odd : std::exception {}; throw Odd();"),
    "todo": with_distance("contact::todo();"),
    "todo in one function": SOLUTION.replace(
        "return value > 0", "contact::todo(); return value > 0"
    ),
    "index": with_distance("std::vector<double> none; return none[3];"),
    "null": with_distance("volatile double* nowhere = nullptr; return *nowhere;"),
    "no end of calls": SOLUTION.replace(
        "namespace exercise {",
        "namespace exercise {\nint deep(volatile int n) { volatile int more[64] = {n}; "
        "return n == -1 ? 0 : deep(n + 1) + more[0]; }",
        1,
    ).replace(DISTANCE, "return deep(0);"),
    "abort": "#include <cstdlib>\n" + with_distance("std::abort();"),
    "trap": with_distance("__builtin_trap();"),
    "divided by zero": with_distance("volatile int none = 0; return 1 / none;"),
    "exit": "#include <cstdlib>\n" + with_distance("std::exit(0);"),
    "prints": "#include <iostream>\n" + with_distance(f'std::cout << "hello\\n"; {DISTANCE}'),
    "a second main": SOLUTION + "\nint main() { return 0; }\n",
    "a second todo": SOLUTION + "\nvoid contact::todo() { throw 1; }\n",
    "a function missing": SOLUTION.replace("int side(", "int other_side("),
    "a name that is defined nowhere": "double elsewhere(double);\n"
    + with_distance("return elsewhere(plane.d);"),
    "a syntax error": with_distance("return (normal.dot(point) + plane.d / normal.norm();"),
    "a warning": with_distance(f"int unused = 3; {DISTANCE}"),
    "not of this type": with_distance('return "far";'),
    "no contract": SOLUTION.replace('#include "signed_distance.hpp"', ""),
    "another contract's name": SOLUTION.replace(
        "double signed_distance(const PlaneEquation& plane",
        "double signed_distance(PlaneEquation& plane",
    ),
    # What the far side is made of, defined by the student too.
    "its own serve": SOLUTION
    + "\nnamespace contact::remote { int serve() { return 7; } }"
    + "\nnamespace contact::remote { int limit_resources() { return 7; } }\n",
    "its own operator new": "#include <cstdlib>\n#include <new>\n"
    + SOLUTION
    + "\nvoid* operator new(std::size_t n) { return std::malloc(n + 64); }"
    + "\nvoid operator delete(void* p) noexcept { std::free(p); }"
    + "\nvoid operator delete(void* p, std::size_t) noexcept { std::free(p); }\n",
    "its own malloc": SOLUTION
    + """
namespace { char arena[1 << 24]; std::size_t used = 0; }
extern "C" void* malloc(std::size_t n) {
  used = (used + 31) / 16 * 16;
  void* place = arena + used;
  used += n;
  return place;
}
extern "C" void free(void*) {}
extern "C" void* calloc(std::size_t n, std::size_t size) { return malloc(n * size); }
""",
}


@pytest.mark.parametrize("how", SAME)
def test_what_goes_wrong_is_told_in_the_same_words(how: str, tmp_path: Path) -> None:
    file = answer(tmp_path, SAME[how])
    (checked,), (graded,) = check(file), grade(file)
    one, other = without_times(checked), without_times(graded)
    for result in (one, other):
        # The linker and the compiler name what they were given.
        if "compile_error" in result:
            result["compile_error"] = {
                key: value
                for key, value in result["compile_error"].items()
                if key in ("line", "column", "message", "excerpt", "explanation")
            }
    assert other == one


def test_of_a_program_that_is_gone_at_once_the_question_is_known_too(tmp_path: Path) -> None:
    file = answer(tmp_path, "#include <unistd.h>\n" + with_distance("_exit(3);"))
    (checked,), (graded,) = check(file), grade(file)
    assert statuses(graded) == statuses(checked)
    assert reasons(graded) == reasons(checked) != set()
    assert all(test["failure"]["asked"] for test in graded["tests"] if test["status"] == "stopped")


def test_what_a_student_reads_names_no_path_of_this_machine(tmp_path: Path) -> None:
    for text in (SAME["a syntax error"], SAME["a second main"], SAME["another contract's name"]):
        (result,) = grade(answer(tmp_path, text))
        assert result["verdict"] == "does_not_compile"
        assert result["compile_error"]["file"] == "01_planes/signed_distance.cpp"
        assert str(ROOT) not in json.dumps(result)
        assert str(tmp_path) not in json.dumps(result)
        assert "/tmp/" not in json.dumps(result)


def test_an_endless_loop_costs_its_tests_and_is_not_believed_at_once(tmp_path: Path) -> None:
    loops = with_distance(f"volatile bool on = true; while (on) {{ }} {DISTANCE}")
    (result,) = grade(answer(tmp_path, loops), seconds=0.5)
    assert set(statuses(result)) == {"stopped", "passed"}
    assert {"no answer after 0.5 seconds: an endless loop, or far too much work"} == reasons(result)
    assert result["near_limit"]
    assert result["slowest_test"] >= 0.5


def test_a_test_near_its_limit_is_not_believed_at_once(tmp_path: Path) -> None:
    busy = """
      timespec now;
      do clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now); while (now.tv_sec < 1);
    """
    text = "#include <time.h>\n" + with_distance(busy + DISTANCE)
    (result,) = grade(answer(tmp_path, text), seconds=1.5)
    assert result["verdict"] == "passed"
    assert result["near_limit"]
    (result,) = grade(answer(tmp_path, text), seconds=8)
    assert result["verdict"] == "passed"
    assert not result["near_limit"]
    assert result["slowest_test"] >= 1


def test_what_else_is_installed_does_not_matter(tmp_path: Path) -> None:
    # The standard library would ask whether tbb/tbb.h is there.
    text = """
      #include <algorithm>
      #include <string_view>
      #define TEXT_OF(x) #x
      #define TEXT(x) TEXT_OF(x)
      static_assert(std::string_view(TEXT(_GLIBCXX_USE_TBB_PAR_BACKEND)) == "0");
    """
    file = answer(tmp_path, textwrap.dedent(text) + SOLUTION)
    for (result,) in (check(file), grade(file)):
        assert result["verdict"] == "passed", result.get("compile_error")


def test_memory_is_limited(tmp_path: Path) -> None:
    text = with_distance(f"std::vector<char> all(std::size_t{{2}} << 30, 'x'); {DISTANCE}")
    (result,) = grade(answer(tmp_path, text))
    assert set(statuses(result)) == {"stopped", "passed"}
    assert all(reason.startswith("ran out of memory") for reason in reasons(result))
    assert result["near_limit"]


def test_what_a_submission_prints_is_kept_and_cut(tmp_path: Path) -> None:
    prints = with_distance(f'std::fprintf(stderr, "printed\\n"); {DISTANCE}')
    (result,) = grade(answer(tmp_path, "#include <cstdio>\n" + prints))
    assert result["verdict"] == "passed"
    assert result["output"].startswith("printed\n")
    floods = with_distance(f'while (true) std::fputs("printed", stderr); {DISTANCE}')
    (result,) = grade(answer(tmp_path, "#include <cstdio>\n" + floods))
    assert reasons(result) == {"it printed without end and was stopped"}
    assert 0 < len(result["output"]) <= 64 << 10


def test_too_much_output_is_too_much_however_soon_anybody_looks(tmp_path: Path) -> None:
    # A little more than the limit, written in one piece: the answer is there at once after it.
    flood = "std::fputs(std::string(65537, 'x').c_str(), stderr)"
    prints = f"static const bool once = ({flood}, true);"
    text = "#include <cstdio>\n" + with_distance(f"{prints} (void)once; {DISTANCE}")
    first, *others = [grade(answer(tmp_path, text))[0] for _ in range(5)]
    assert reasons(first) == {"it printed without end and was stopped"}
    for other in others:
        assert (statuses(other), other["output"]) == (statuses(first), first["output"])


def test_each_test_meets_a_submission_that_remembers_nothing(tmp_path: Path) -> None:
    text = with_distance(f"static int calls = 0; if (++calls > 1000) std::abort(); {DISTANCE}")
    (result,) = grade(answer(tmp_path, "#include <cstdlib>\n" + text))
    assert statuses(result)[:5] == ["passed"] * 5


def test_a_file_that_compiles_into_too_much_is_told_so(tmp_path: Path) -> None:
    text = SOLUTION + "\nchar large[200u << 20] = {1};\n"
    (result,) = grade(answer(tmp_path, text))
    assert result["verdict"] == "does_not_compile"
    assert result["compile_error"]["message"] == "the compiled file would be larger than 64 MB"
    assert result["near_limit"]


def test_words_about_limits_in_a_broken_line_are_only_words(tmp_path: Path) -> None:
    text = with_distance('return "out of memory, CPU time limit exceeded, File too large";')
    (result,) = grade(answer(tmp_path, text))
    assert result["verdict"] == "does_not_compile"
    assert result["compile_error"]["line"] == SOLUTION[: SOLUTION.index(DISTANCE)].count("\n") + 1
    assert "cannot convert" in result["compile_error"]["message"]
    assert not result["near_limit"]


def test_a_compiler_that_finds_no_end_is_told_so(tmp_path: Path) -> None:
    bomb = (
        "constexpr long count(long n) {\n  long sum = 0;\n"
        "  for (long i = 0; i < n; ++i) sum += i % 7;\n  return sum;\n}\n"
        "#define ROW(n) count(250000 + n), count(250001 + n), count(250002 + n)\n"
        "#define BLOCK(n) ROW(n), ROW(n + 3), ROW(n + 6), ROW(n + 9), ROW(n + 12), ROW(n + 15)\n"
        "constexpr long sums[] = {" + ", ".join(f"BLOCK({18 * i})" for i in range(100)) + "};\n"
    )
    (result,) = grade(answer(tmp_path, SOLUTION + bomb), compile_seconds=2)
    assert result["verdict"] == "does_not_compile"
    message = "the compiler did not finish within 2 s of processor time"
    assert result["compile_error"]["message"] == message
    assert result["near_limit"]
