"""./contact test: every check there is, stage by stage, and what each took.

A stage is a list of checks; it goes on after one that fails, and so do the stages after it unless
they need what the failed one was to build. Two stages run at a time (lanes.py). The last line is
`N passed, N failed, N skipped`, which adds up what the test programs themselves report: test cases
of ctest, pytest and node:test, cases of `contact dev check`, and one for each linter, build and
program that can only succeed or fail.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import textwrap
import time
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import landing
import lanes
import lengths
import page_parts
import steps
import touched
from sample import chapters_asked_for, sample, turn, wanted
from stages import LATE, Check, Lane, Stage, Tally, closing_table, run_stage
from steps import BUILD, DEV, PROGRAM, ROOT, Done
from wrong_answers import write_whole  # where touched finds the registry's writer

# --- Checks ---------------------------------------------------------------------------------------


def explain(what: str, done: Done) -> str:
    ended = "was stopped at its time limit" if done.code is None else f"ended with {done.code}"
    return f"{what} {ended}; all of it: {done.log.relative_to(ROOT)}\n{done.tail()}"


def log_name(what: str) -> str:
    return "test-" + re.sub(r"[^a-z0-9]+", "-", what.lower()).strip("-")


# What a build and tests print of a failure before they have ended: ninja, ctest, node, pytest -q.
FAILED_SO_FAR = re.compile(
    r"^FAILED: |\*\*\*(?:Failed|Timeout|Exception)|^ *not ok \d|^[.sxX]*[FE][.sxXFE]* +\[ *\d+%\]$",
    re.MULTILINE,
)
# No command takes so long, even on a slow machine: one that does hangs.
HANGS_AFTER = 2400.0


def cut_off(what: str, done: Done) -> Tally | None:
    """What says that the end of the run stopped it; nothing, if it failed or hung before."""
    if done.code is not None or not steps.run_is_over():
        return None
    if done.seconds > HANGS_AFTER or FAILED_SO_FAR.search(done.output):
        return None
    return Tally(skipped=1, why=[f"not run to its end: {what}: {LATE}"], explained=True)


def one_test(what: str, done: Done) -> Tally:
    if done.ok:
        return Tally(passed=1)
    if cut := cut_off(what, done):
        return cut
    return Tally(failed=1, why=[explain(what, done)], names=[what])


def once(what: str, command: Sequence[str | Path], cwd: Path = ROOT) -> Check:
    """A command that can only succeed or fail: one test."""

    def check(seconds: float) -> Tally:
        return one_test(what, steps.run(command, log_name(what), cwd=cwd, limit=seconds))

    return check


def counted(
    what: str,
    command: Sequence[str | Path],
    count: Callable[[Done], Tally | None],
    cwd: Path = ROOT,
) -> Check:
    """A command that runs tests. To end badly, or to count nothing, is itself a failure."""

    def check(seconds: float) -> Tally:
        done = steps.run(command, log_name(what), cwd=cwd, limit=seconds)
        if cut := cut_off(what, done):
            return cut
        tally = count(done)
        if tally is None:
            why = explain(f"{what} reported no counts and", done)
            return Tally(failed=1, why=[why], names=[what])
        if tally.failed:
            if not tally.explained:
                tally.why.append(explain(what, done))
        elif not done.ok:
            tally.failed += 1
            tally.names.append(what)
            tally.why.append(explain(what, done))
        elif tally.passed + tally.skipped == 0:
            tally.failed += 1
            tally.names.append(what)
            tally.why.append(f"{what} ran no test at all; its words: {done.log.relative_to(ROOT)}")
        return tally

    return check


def count_junit(file: Path) -> Callable[[Done], Tally | None]:
    """The counts in a JUnit file of ctest or pytest. What was disabled or not run is skipped.

    Of each test that failed it tells the last lines that this test itself printed.
    """
    file.unlink(missing_ok=True)

    def count(done: Done) -> Tally | None:
        if not file.exists():
            return None
        tally = Tally()
        for case in ElementTree.parse(file).getroot().iter("testcase"):
            name = case.get("name", "?")
            if case.find("failure") is not None or case.find("error") is not None:
                tally.failed += 1
                tally.names.append(name)
                tally.why.append("\n".join([f"FAILED: {name}", *last_words(case)]))
            elif (skip := case.find("skipped")) is not None or case.get("status") in (
                "notrun",
                "disabled",
            ):
                tally.skipped += 1
                reason = skip.get("message") if skip is not None else None
                tally.why.append(f"not run: {name}" + (f" ({reason})" if reason else ""))
            else:
                tally.passed += 1
        if tally.failed:
            tally.why.append(f"all of it: {done.log.relative_to(ROOT)}")
            tally.explained = True
        return tally

    return count


def last_words(case: ElementTree.Element) -> list[str]:
    """The end of what a failed test printed: ctest keeps its output, pytest what failed in it."""
    said = [case.findtext(kind, "") for kind in ("system-out", "failure", "error")]
    lines = next((text for text in said if text.strip()), "").rstrip().splitlines()
    problem = case.find("failure") if case.find("failure") is not None else case.find("error")
    told = problem.get("message", "") if problem is not None else ""
    return [f"    {line}" for line in lines[-20:] or told.splitlines()[:1]]


def count_tap(done: Done) -> Tally | None:
    """The totals that node --test prints at the end."""
    totals = {
        word: int(number)
        for word, number in re.findall(
            r"^# (pass|fail|cancelled|skipped|todo) (\d+)$", done.output, re.M
        )
    }
    if "pass" not in totals:
        return None
    tally = Tally(
        passed=totals["pass"],
        failed=totals.get("fail", 0) + totals.get("cancelled", 0),
        skipped=totals.get("skipped", 0) + totals.get("todo", 0),
    )
    if tally.skipped:
        tally.why += [
            f"not run: {name} ({reason or 'no reason given'})"
            for name, reason in re.findall(
                r"^\s*ok \d+ - (.*?) # (?:SKIP|TODO) ?(.*)$", done.output, re.M
            )
        ]
    if tally.failed:
        failures = failures_in_tap(done.output)
        tally.why += [explain(done.log.stem, done), *failures]
        tally.names += [failure.splitlines()[0].removeprefix("FAILED: ") for failure in failures]
        tally.explained = True
    return tally


def failures_in_tap(output: str) -> list[str]:
    """What each failed test says, without the suites that failed because a test in them did.

    The last lines of the output are seldom those of the test that failed.
    """
    blocks = re.findall(r"^( *)not ok \d+ - (.*)\n\1  ---\n((?:.*\n)*?)\1  \.\.\.$", output, re.M)
    return [
        "\n".join(["FAILED: " + name, *textwrap.dedent(says).splitlines()[:25]])
        for _, name, says in blocks
        if "failureType: 'subtestsFailed'" not in says
    ]


def pytest(*folders: str, beside: Sequence[str] = ()) -> Iterator[Check]:
    for folder in folders:
        if any((ROOT / folder).glob("**/test_*.py")):
            file = BUILD / "logs" / f"{log_name(folder)}.junit.xml"
            python = [sys.executable, "-m", "pytest", "-q", f"--junitxml={file}", *beside, folder]
            yield counted(f"pytest {folder}", python, count_junit(file))


# Files of pytest two at a time.
TWO = ("-n", "2", "--dist", "loadfile")
# Files of pytest three at a time on two cores: much of what they do waits. They begin in the order
# in which their conftest.py puts them.
THREE = ("-n", "3", "--dist", "loadfile", "--no-loadscope-reorder")


def side_by_side(checks: Sequence[Check]) -> Check:
    """Checks that use one core each, two at a time."""

    def check(seconds: float) -> Tally:
        until = time.monotonic() + seconds
        total = Tally()

        def run_one(one: Check) -> Tally:
            if steps.run_is_over():
                return Tally(skipped=1, why=[f"not run: {LATE}"])
            return one(max(1.0, until - time.monotonic()))

        with ThreadPoolExecutor(2) as pool:
            try:
                for tally in pool.map(run_one, checks):
                    total.add(tally)
            except BaseException:
                pool.shutdown(wait=False, cancel_futures=True)
                steps.CHILDREN.stop_all()
                raise
        return total

    return check


def node_tests(
    what: str, files: Sequence[Path], cwd: Path, *, first: Sequence[str] = (), flags: str = ""
) -> Iterator[Check]:
    """Each file by itself, those with most in them first, so that the last to end ends soon.

    `first`: those that take long for their size.
    """

    def name(file: Path) -> str:
        return file.name.removesuffix(".test.mjs")

    def one(file: Path) -> Check:
        command: list[str | Path] = ["node", *flags.split(), "--test", "--test-reporter=tap", file]
        return counted(f"{what} {name(file)}", command, count_tap, cwd)

    if files:
        longest = sorted(files, key=lambda file: (name(file) not in first, -file.stat().st_size))
        yield side_by_side([one(file) for file in longest])


def ctest(preset: str, *more: str, name: str = "") -> Check:
    """`name`: of these tests, where the preset has others too."""
    what = f"ctest {preset} {name}".strip()
    file = BUILD / "logs" / f"{log_name(what)}.junit.xml"
    jobs = str(os.cpu_count() or 2)
    command = [
        "ctest",
        "--preset",
        preset,
        "--no-tests=error",
        "-j",
        jobs,
        "--output-junit",
        str(file),
        *more,
    ]
    return counted(what, command, count_junit(file))


def cmake_build(preset: str, *targets: str) -> Iterator[Check]:
    """Configures and builds; everything, unless targets are named."""
    yield once(f"configure {preset}", ["cmake", "--preset", preset])
    yield build_of(preset, *targets)


def build_of(preset: str, *targets: str, name: str = "") -> Check:
    """`name`: of these targets, where others of the preset are built too."""
    what = f"{preset} {name}".strip()

    def build(seconds: float) -> Tally:
        with steps.build_lock(preset):
            done = steps.run(
                ["cmake", "--build", BUILD / preset, "--", "-k", "0", *targets],
                log_name(f"build {what}"),
                limit=seconds,
            )
        tally = one_test(f"building {what}", done)
        if not tally.failed:
            return tally
        errors = [line for line in done.output.splitlines() if re.search(r"error:|FAILED:", line)]
        tally.why = ["\n".join([*errors[:12], why]) for why in tally.why]
        return tally

    return build


# --- What each stage checks -----------------------------------------------------------------------


def tracked(*patterns: str) -> list[str]:
    """Files of the project: those in git, and new ones that git does not ignore."""
    command = [
        "git",
        "ls-files",
        "--cached",
        "--others",
        "--exclude-standard",
        "-z",
        "--",
        *patterns,
    ]
    listed = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    return sorted({name for name in listed.split("\0") if name and (ROOT / name).is_file()})


# What a chapter may have.
LESSON, LADDER = "chapters/{}/lesson.md", "chapters/{}/ladder.cpp"
FIGURE, EXERCISE = "chapters/{}/figures/*.cpp", "exercises/{}/*/exercise.toml"


def having(*patterns: str) -> list[str]:
    """Of the chapters that are asked for, those that have one of these."""
    return [
        slug
        for slug in chapters_asked_for()
        if any(any(ROOT.glob(pattern.format(slug))) for pattern in patterns)
    ]


def style() -> Iterator[Check]:
    cpp = [name for name in tracked("*.cpp", "*.hpp") if "third_party/" not in name]
    # Of those that are patches, what they stand for; that one does not apply, dev check says.
    patches = tracked("solutions/*.patch")
    for exercise in sorted({"/".join(patch.split("/")[1:3]) for patch in patches}):
        cpp += [str(file) for file in write_whole(exercise, BUILD / "wrong")[0]]
    venv = BUILD / "venv" / "bin"
    bin_ = ROOT / "page" / "node_modules" / ".bin"
    web = tracked("*.ts", "*.mts", "*.mjs", "*.js", "*.css", "page/*.json")
    web = [name for name in web if "third_party/" not in name]
    scripts = [name for name in tracked() if is_shell(ROOT / name)]
    yield side_by_side(
        [
            once("clang-format", [venv / "clang-format", "--dry-run", "-Werror", *cpp]),
            once("mypy", [venv / "mypy", *python_sources()]),
            once("mypy of the book", [venv / "mypy", "--config-file", "docs/pyproject.toml"]),
            once("ruff check", [venv / "ruff", "check", "."]),
            once("ruff format", [venv / "ruff", "format", "--check", "."]),
            once("biome", [bin_ / "biome", "ci", *web]),
            *(
                once(f"tsc {project}", [bin_ / "tsc", "--noEmit", "-p", ROOT / project])
                for project in tracked("page/tsconfig.json", "page/*/tsconfig.json")
            ),
            once("shellcheck", ["shellcheck", *scripts]),
            once("words", [venv / "python", ROOT / "tools" / "words.py"]),
        ]
    )
    yield looked_at("the turn", landing.check_turn)
    yield looked_at("subjects of commits", landing.check_subjects)
    yield looked_at("lengths of files", lengths.check_lengths)


def looked_at(what: str, look: Callable[[Path], landing.Found]) -> Check:
    """What git knows of the change and the tree; skipped where it knows too little."""

    def check(_: float) -> Tally:
        found = look(ROOT)
        if found.problems:
            return Tally(failed=1, why=found.problems, names=[what])
        if not found.looked:
            return Tally(skipped=1, why=[f"not run: {found.says}"])
        return Tally(passed=1)

    return check


def python_sources() -> list[str]:
    """Ours; docs/ says itself how it is checked."""
    return [name for name in tracked("*.py") if not name.startswith(("docs/", "tests/docs/"))]


def is_shell(file: Path) -> bool:
    if file.suffix == ".sh":
        return True
    with file.open("rb") as opened:
        return re.match(rb"#!.*\b(ba|da)?sh\b", opened.readline(80)) is not None


# The programs of a chapter's tests, as cmake/ContactTargets.cmake names them.
KINDS_OF_TESTS = ("reference_tests", "hard_cases")


def with_tests() -> list[str]:
    return sorted(file.parent.name for file in ROOT.glob("tests/[0-9]*/hard_cases.cpp"))


def native() -> Iterator[Check]:
    """What every run needs; of one chapter alone, all that is made of it."""
    if asked := chapters_asked_for():
        yield once("configure dev", ["cmake", "--preset", "dev"])
        kinds = (*KINDS_OF_TESTS, "example", "figure", "ladder", "headers_alone")
        names = steps.native_targets([f"{kind}_{slug}" for kind in kinds for slug in asked])
        for slug in asked:
            exercises = sorted((ROOT / "exercises" / slug).glob("*/exercise.toml"))
            names += [f"exercise_{slug}_{toml.parent.name}" for toml in exercises]
        yield build_of("dev", "contact", "contact-authors", *names)
        return
    yield from cmake_build("dev", "all_but_turns")


def plain() -> Iterator[Check]:
    """Of headers that must compile alone, examples and tests as optimised, a third a turn.

    All tests of references are built and run under sanitizers. Chapter by chapter: who grades waits
    while something is built.
    """
    chapters = sorted(folder.parent.name for folder in ROOT.glob("chapters/*/contact"))
    alone = [
        f"headers_alone_{slug}" for slug in sample(chapters, 3, "headers alone", kind="headers")
    ]
    tests, examples = plain_tests("tests without sanitizers"), with_examples("examples")
    for slug in sorted({*tests, *examples}):
        names = [f"{kind}_{slug}" for kind in KINDS_OF_TESTS if slug in tests]
        names += examples_of(slug) if slug in examples else []
        yield build_of("dev", *names, name=slug)
    for target in alone:
        yield build_of("dev", target, name=target)
    yield ctest("dev", "--tests-regex", tests_as_optimised(tests, examples), name="plain")
    yield from pytest("tests/built")


def plain_tests(what: str) -> list[str]:
    """The chapters whose tests run without sanitizers too, as quickly as their users have them."""
    return sample(with_tests(), 3, what, kind="tests")


def with_examples(what: str) -> list[str]:
    """The chapters whose examples this run compiles, and compares with what the lessons show."""
    chapters = sorted({file.parts[-3] for file in ROOT.glob("chapters/*/examples/*.cpp")})
    return sample(chapters, 3, what, kind="tests")


def examples_of(slug: str) -> list[str]:
    return [f"example_{slug}_{file.stem}" for file in ROOT.glob(f"chapters/{slug}/examples/*.cpp")]


def tests_as_optimised(tests: Sequence[str], examples: Sequence[str]) -> str:
    """A pattern of the names that CTest gives to them."""
    return (
        rf"^(reference_tests_({'|'.join(tests)}):|hard_cases_({'|'.join(tests)})$"
        rf"|example_({'|'.join(examples)})_)"
    )


def tests_of(chapters: Sequence[str]) -> str:
    """A pattern of the names that CTest gives to all tests of these chapters."""
    slugs = "|".join(chapters)
    names = rf"reference_tests_({slugs}):|hard_cases_({slugs})$|example_({slugs})_"
    return rf"^({names}|contract_(linked|proxy)_({slugs})_)"


def native_tests() -> Iterator[Check]:
    if asked := chapters_asked_for():
        without_reports("dev")
        yield ctest("dev", "--tests-regex", tests_of(asked))
        yield from what_pages_tell("dev", asked)
        return
    # Those are tests of the stage plain.
    yield ctest("dev", "--exclude-regex", rf"^({'|'.join(KINDS_OF_TESTS)}|example)_")


def without_reports(preset: str) -> None:
    """Removes the hard cases' reports, so that only those of the tests that now run are read."""
    for report in (BUILD / preset / "hard_cases").glob("*.json"):
        report.unlink()


def what_pages_tell(preset: str, chapters: Sequence[str]) -> Iterator[Check]:
    """The tables of hard cases that lessons show, against what CTest's tests have reported."""
    told = [slug for slug in chapters if (ROOT / f"tests/{slug}/hard_cases.told.json").exists()]
    if told:
        tell: list[str | Path] = [sys.executable, ROOT / "docs" / "tell_hard_cases.py", "--check"]
        tell += ["--reports", BUILD / preset / "hard_cases", *told]
        yield once("what pages show of hard cases", tell)


def sanitize() -> Iterator[Check]:
    """Those of the turn, and what the change touches; sanitize_rest() takes the others."""
    yield once("configure sanitize", ["cmake", "--preset", "sanitize", with_scopes()])
    without_reports("sanitize")
    yield build_of("sanitize", "support_tests", name="support")
    yield ctest("sanitize", "--exclude-regex", r"^(reference_tests|hard_cases)_")
    yield from sanitized(first_under_sanitizers())


def sanitize_rest() -> Iterator[Check]:
    """The other chapters, after the page and the book.

    Where a run ends before, they come in the next two runs, and the page has been checked.
    """
    first = first_under_sanitizers()
    yield from sanitized([slug for slug in with_tests() if slug not in first])


def with_scopes() -> str:
    """The chapters whose tests also find uses after the end of a scope: those of the turn.

    The other checks of the sanitizers are made of all chapters, in every run.
    """
    return "-DCONTACT_SCOPES=" + ";".join(sample(with_tests(), 3, "uses after scope", kind="tests"))


def first_under_sanitizers() -> list[str]:
    return sample(with_tests(), 3, "", kind="tests")


def sanitized(chapters: Sequence[str]) -> Iterator[Check]:
    """A chapter after the other."""
    for slug in chapters:
        yield build_of("sanitize", *(f"{kind}_{slug}" for kind in KINDS_OF_TESTS), name=slug)
        yield ctest("sanitize", "--tests-regex", tests_of([slug]), name=slug)
        yield from what_pages_tell("sanitize", [slug])


def tidy() -> Iterator[Check]:
    """clang-tidy over all reference headers through one file, and over the library that judges.

    Of the library a third goes in a turn, and what the change touches. The commands in cli/ are
    thin, and what they include takes clang-tidy minutes.
    """
    folder = BUILD / "tidy"
    folder.mkdir(parents=True, exist_ok=True)
    chapters = sorted(path.parent for path in ROOT.glob("chapters/*/contact"))
    everything = folder / "headers.cpp"
    names = [
        file.relative_to(chapter).as_posix()
        for chapter in chapters
        for file in sorted(chapter.glob("contact/**/*.hpp"))
    ]
    everything.write_text("".join(f"#include <{name}>\n" for name in names))
    commands = json.loads((DEV / "compile_commands.json").read_text())
    command = ["c++", "-std=c++20", "-ffp-contract=off", "-DEIGEN_DONT_VECTORIZE"]
    command += [word for chapter in chapters for word in ("-I", str(chapter))]
    command += ["-isystem", "/usr/include/eigen3", "-c", str(everything)]
    judging = {
        name: entry
        for entry in file_by_file(commands)
        if (name := os.path.relpath(entry["file"], ROOT)).startswith("grading/")
    }
    taken = sample(sorted(judging), 3, "clang-tidy of the library that judges", kind="tidy")
    own = [judging[name] for name in taken]
    # clang would take g++'s precompiled header for one of its own.
    for entry in own:
        flags = r"-Winvalid-pch|-include \S+/cmake_pch\.hxx"
        entry["command"] = re.sub(flags, "", entry["command"])
    own.append({"directory": str(folder), "arguments": command, "file": str(everything)})
    (folder / "compile_commands.json").write_text(json.dumps(own))
    workers = str(os.cpu_count() or 2)
    files = sorted({entry["file"] for entry in own})
    listed = write_list(folder / "files", files)
    command = ["xargs", "-a", str(listed), "-n", "1", "-P", workers]
    yield once("clang-tidy", [*command, "clang-tidy", "--quiet", "-p", str(folder)])


def file_by_file(commands: Sequence[dict[str, Any]]) -> Iterator[dict[str, Any]]:
    """The commands of a build as if it compiled no files together."""
    for entry in commands:
        together = Path(entry["file"])
        if together.parent.name != "Unity":
            yield entry
            continue
        for name in re.findall(r'^#include "(.+\.cpp)"$', together.read_text(), re.MULTILINE):
            command = entry["command"].replace(str(together), name)
            yield {**entry, "command": command, "file": name}


def write_list(file: Path, names: Sequence[str]) -> Path:
    file.write_text("".join(f"{name}\n" for name in names))
    return file


def dev_check() -> Iterator[Check]:
    def count(done: Done) -> Tally | None:
        try:
            report = json.loads(done.output[done.output.index("{") :])
            tally = Tally(report["passed"], report["failed"], explained=True)
            for result in report["results"]:
                if not result["passed"]:
                    tally.names.append(f"{result['kind']} {result['name']}")
                    tally.why.append(
                        "\n".join([f"{result['kind']} {result['name']}:", *result["problems"]])
                    )
            counts = {kind: sum(of.values()) for kind, of in report["counts"].items()}
        except (ValueError, KeyError, TypeError):
            return None
        print("    " + ", ".join(f"{number} {kind}" for kind, number in counts.items()))
        return tally

    asked = having(EXERCISE)
    if asked or not chapters_asked_for():
        yield counted("contact dev check", [PROGRAM, "dev", "check", "--json", *asked], count)
    if taken := mutated_exercises():
        command: list[str | Path] = [PROGRAM, "dev", "mutants", "--json", *taken]
        # What a change touches can be all of them, and the nightly run tries them all.
        if "CONTACT_ALL" not in os.environ:
            command += ["--limit", str(MUTANT_SECONDS)]
        yield counted("contact dev mutants", command, count_mutants)


# A tenth of the exercises in each run, a fifth of those of a chapter that is checked alone, and the
# seconds of processor time after which none begins.
MUTANTS_EACH, MUTANTS_EACH_ALONE, MUTANT_SECONDS = 10, 5, 120


def mutated_exercises() -> list[str]:
    there = [file.parent for file in sorted(ROOT.glob("exercises/*/*/exercise.toml"))]
    names = [f"{folder.parent.name}/{folder.name}" for folder in there]
    what = "exercises whose solutions are mutated"
    if chapters_asked_for():
        return sample([name for name in names if wanted(name)], MUTANTS_EACH_ALONE, what)
    return sample(names, MUTANTS_EACH, what, kind="exercises")


def count_mutants(done: Done) -> Tally | None:
    """Each mutant is a test that passes if it is caught, or known to be equivalent."""
    try:
        report = json.loads(done.output[done.output.index("{") :])
        tally = Tally(explained=True)
        for one in report["exercises"]:
            left = [
                f"{one['exercise']}, line {mutant['line']}: no test catches"
                f" {mutant['was']} -> {mutant['now']}"
                for mutant in one["survivors"]
            ]
            wrong = [f"{one['exercise']}: {problem}" for problem in one["problems"]]
            tally.passed += one["mutants"] - len(left)
            if one["settled"]:
                wrong += left
            else:
                tally.skipped += len(left)  # not yet known whether they are equivalent
            tally.failed += len(wrong)
            tally.names += wrong
            tally.why += wrong
        tally.skipped += len(report["not_tried"])
    except (ValueError, KeyError, TypeError):
        return None
    return tally


def outside() -> Iterator[Check]:
    yield side_by_side(list(pytest("tests/setup", "tests/package")))


def program() -> Iterator[Check]:
    yield from pytest("tests/cli", beside=THREE)


# Files of tests/grade that test what lies around a verdict, of which a third goes in a turn, with
# long ones apart. Boxes, hostile submissions and the verdicts themselves are tested in every run.
AROUND_GRADING = (
    "test_slurm",
    "test_private",
    "test_not_graded",
    "test_outputs_class",
    "test_regrade",
    "test_resume",
    "test_outputs_not_graded",
    "test_explain_box",
    "test_idle",
    "test_outputs_leaks",
    "test_outputs_autograder",
    "test_outputs_full_disk",
    "test_outputs_gone",
    "test_outputs_formats",
    "test_outputs_visibility",
)
# The same of tests/docs: what the builder of the book does, on books made for the tests.
AROUND_THE_BOOK = (
    "test_mistakes",
    "test_building_again",
    "test_fonts",
    "test_terms",
    "test_ebook",
    "test_deeper",
    "test_errata",
)


def without(folder: str, files: Sequence[str], taken: Sequence[str]) -> list[str]:
    """Options of pytest that leave out those of the files that are not taken."""
    missing = [name for name in files if not (ROOT / folder / f"{name}.py").is_file()]
    if missing:
        raise OSError(f"tools/test.py names {folder}/{missing[0]}.py, which is not there")
    return [f"--ignore={folder}/{name}.py" for name in files if name not in taken]


def grade() -> Iterator[Check]:
    """Grading needs what Linux alone has; elsewhere the program says so, and that is all."""
    if sys.platform != "linux":
        yield lambda _: Tally(skipped=1, why=["not run: grading needs Linux"])
        return
    around = sample(AROUND_GRADING, 3, "files of tests around grading", kind="grading")
    yield from pytest(
        "tests/grade", beside=(*THREE, *without("tests/grade", AROUND_GRADING, around))
    )


def step_checks(book_steps: Sequence[steps.Step]) -> Iterator[Check]:
    for step in book_steps:

        def check(_: float, step: steps.Step = step) -> Tally:
            return one_test(step.what, step.run())

        yield check


def page() -> Iterator[Check]:
    """What the book is made of, as ./contact serve makes it, and the tests of the scripts."""
    here = ROOT / "page"
    compiled = [*page_parts.figures_and_ladders(), page_parts.native_figures()]
    yield from step_checks([*compiled, page_parts.scripts()])
    if not chapters_asked_for():
        tests = sorted(here.glob("web/test/*.test.mjs"))
        yield from node_tests("test of page/web:", without_player(tests), here)


def without_player(tests: Iterable[Path]) -> list[Path]:
    """Where the scene player is not built in this turn, its tests wait too."""
    tested = page_parts.player_is_tested()
    of_player = ("scenes.test.mjs", "opening.test.mjs", "engines.test.mjs")
    return [file for file in tests if tested or file.name not in of_player]


def wasm() -> Iterator[Check]:
    here = ROOT / "page"
    source = BUILD / "catch2" / "extras" / "catch_amalgamated.cpp"
    if not shutil.which("apt-get") and not source.exists():
        why = f"the tests in WebAssembly: without apt, copy Catch2's amalgamated source to {source}"
        yield lambda _: Tally(skipped=1, why=[f"not run: {why}"])
        return
    if shutil.which("apt-get"):
        yield once("Catch2's source", [ROOT / "tools" / "fetch_catch2_source.sh"])
    yield from step_checks(page_parts.compiler_and_exercises())
    # The exercises of a chapter alone are checked in a browser: parity.test.mjs.
    if not chapters_asked_for():
        compiled = [*here.glob("wasm/*.test.mjs"), *here.glob("web/test/cpp/*.test.mjs")]
        tests = sorted(file for file in compiled if file.name != "loader.test.mjs")
        # As page/wasm/pool.mjs starts the compiler.
        engine = "--single-threaded-gc --liftoff-only"
        yield from node_tests("test of page/wasm:", tests, here, flags=engine)


def twins() -> Iterator[Check]:
    here = ROOT / "page"
    yield from node_tests("test of page/wasm:", [here / "wasm" / "loader.test.mjs"], here)


def book() -> Iterator[Check]:
    if chapters_asked_for():
        yield from step_checks([steps.PAGE_PROGRAMS, page_parts.pages()])
        return
    yield from step_checks([steps.PAGE_PROGRAMS, page_parts.pages(), *page_parts.ebook()])
    around = sample(AROUND_THE_BOOK, 3, "files of tests of the book's builder", kind="builder")
    yield from pytest("tests/docs", beside=(*TWO, *without("tests/docs", AROUND_THE_BOOK, around)))
    yield from pytest("tests/serve")


# Chapters whose methods that are never wrong by design are asked a million inputs of each family:
# in ten of their turns, or at once if everything is taken.
NEVER_WRONG = ("03_polygons", "04_rays", "05_meshes", "06_triangle_pairs", "07_bounding_volumes")
BLOCKS = 10  # of 10,000 inputs, in a turn


def never_wrong(chapter: str) -> Check:
    """Another part of the million in each turn that takes the chapter."""
    everything = "CONTACT_ALL" in os.environ
    blocks = 10 * BLOCKS if everything else BLOCKS
    first = 0 if everything else turn() // 3 % 10 * BLOCKS
    asked = ["--never-wrong", str(10_000 * blocks), "--from", str(first)]
    return once(f"never wrong {chapter}", [DEV / "bin" / f"ladder_{chapter}", *asked])


def ladder() -> Iterator[Check]:
    """The ladders of the turn at a small size: that they run, not what they measure."""
    taken = page_parts.chapters_of("ladder", "chapters whose ladder runs natively")
    if targets := page_parts.ladder_targets():
        yield build_of("dev", *targets, name="ladders")
    folder = BUILD / "logs" / "ladder"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for file in sorted(ROOT.glob("chapters/*/ladder.cpp")):
        chapter = file.parent.name
        if chapter not in taken:
            continue
        out = folder / f"{chapter}.json"
        ladder = DEV / "bin" / f"ladder_{chapter}"
        sized = ["--size", "200", "--repeats", "2", "--json", str(out)]
        yield once(f"ladder {chapter}", [ladder, *sized])
        if chapter in NEVER_WRONG:
            yield never_wrong(chapter)


def browser() -> Iterator[Check]:
    files = without_player(sorted((ROOT / "tests" / "browser").glob("*.test.mjs")))
    if chapters_asked_for():
        of_lessons = ("pages", "questions", "ladder") if having(LESSON) else ()
        of_figures = ("figures",) if set(having(LESSON)) & set(having(FIGURE)) else ()
        of_exercises = ("parity",) if having(EXERCISE) else ()
        names = {*of_lessons, *of_figures, *of_exercises}
        files = [file for file in files if file.name.split(".")[0] in names]
    first = ("exercises", "pages", "figures", "parity")
    yield from node_tests("test in a browser:", files, ROOT / "page", first=first)


# --- The stages, in order -------------------------------------------------------------------------

# What all of them together are meant to stay under, on two cores.
WHOLE_MINUTES = 40

CHAPTERS = sorted(file.parent.name for file in ROOT.glob("chapters/*/chapter.toml"))
# The stages of `./contact test CHAPTER`. Each takes of its lists what is in CONTACT_CHAPTERS.
OF_ONE_CHAPTER = (
    *("native", "ctest", "dev-check", "ladder", "page", "wasm", "book", "twins", "browser"),
)
# Beside what chapters are touched: files that a stage reads. Such a stage is run with all that it
# needs.
READS = {
    name: re.compile(pattern)
    for name, pattern in {
        "native": r"(cli|grading|cmake|benchmarks)/|CMake|tests/(support|CMakeLists)",
        "ctest": r"(grading|cmake)/|CMake|tests/(support|grading|CMakeLists)",
        "plain": r"cmake/|CMake|tests/(support|CMakeLists)",
        "dev-check": r"(grading|cli|cmake)/|tests/support/",
        "program": r"(cli|grading|cmake)/|tests/cli/",
        "grade": r"(cli|grading|cmake)/|tests/(grade|grading)/",
        "outside": r"(contact|CMake.*|CONTRIBUTING\.md)$"
        r"|(tools|cmake|grading/book|tests/(setup|package))/|page/package|docs/req",
        "tidy": r"(grading|chapters/[^/]+/contact)/|\.clang-tidy$",
        "page": r"page/(web|figure|player)/|page/[^/]+$",
        "wasm": r"page/(wasm|judge)/|page/web/(src|test)/cpp|page/[^/]+$|grading/",
        "twins": r"page/(wasm|figure)/",
        "book": r"(docs|page)/|tests/(docs|serve)/|tools/(serve|steps)\.py$|grading/book/.*\.py$",
        "browser": r"tests/browser/|page/web/|docs/(_ext|_static)/",
    }.items()
}
# Stages that check more than chapters: where one of them is called for, nothing is narrowed.
BEYOND_CHAPTERS = tuple(name for name in READS if name != "tidy")

# The minutes are where a stage is stopped on a busy machine; all of them together take far less.
# Those of one lane run in this order, beside those of the other. First those that every run has,
# then those that may wait for another run where $CONTACT_MINUTES, the time of a run, is over.
STAGES = (
    Stage(
        "style",
        "format, linters and types of C++, Python, TypeScript and shell",
        10,
        style,
        lane=Lane.WAITS,
    ),
    Stage("native", "configure and build what every run needs", 80, native),
    Stage(
        "ctest",
        "contracts, the grading library, support of tests",
        20,
        native_tests,
        ("native",),
        Lane.WAITS,
    ),
    Stage(
        "dev-check",
        "stubs, solutions, wrong answers and null answers",
        50,
        dev_check,
        ("native",),
        Lane.WAITS,
    ),
    Stage(
        "grade",
        "submissions that nobody trusts: boxes, marks, reports",
        70,
        grade,
        ("native",),
        Lane.WAITS,
    ),
    Stage(
        "outside", "set-up; the headers in another project", 24, outside, ("native",), Lane.WAITS
    ),
    Stage(
        "program", "the contact program from outside", 30, program, ("native",), Lane.WAITS, True
    ),
    Stage(
        "sanitize",
        "references against the oracle, hard cases, questions",
        80,
        sanitize,
        may_wait=True,
        low_priority=True,
    ),
    Stage(
        "plain",
        "tests and examples as users have them; headers alone",
        80,
        plain,
        ("native",),
        may_wait=True,
    ),
    Stage("ladder", "ladders at a small size", 30, ladder, ("native",), Lane.WAITS, True),
    Stage(
        "page",
        "the page's scripts, figures and ladders in WebAssembly",
        60,
        page,
        ("native",),
        may_wait=True,
    ),
    Stage(
        "wasm",
        "the compiler in the page, and the exercises for it",
        70,
        wasm,
        ("native",),
        may_wait=True,
    ),
    Stage(
        "book", "the book without a warning, and served", 50, book, ("page", "wasm"), may_wait=True
    ),
    Stage(
        "twins",
        "figures and ladders in WebAssembly against their native programs",
        30,
        twins,
        ("page",),
        may_wait=True,
    ),
    Stage("browser", "the book in a real browser", 80, browser, ("book",), Lane.WAITS, True),
    Stage(
        "sanitize-rest",
        "the same as sanitize, of the chapters of other turns",
        80,
        sanitize_rest,
        ("sanitize",),
        may_wait=True,
        low_priority=True,
        may_be_empty=True,
    ),
    Stage(
        "tidy",
        "clang-tidy over the reference headers and the library that judges",
        50,
        tidy,
        ("native",),
        may_wait=True,
    ),
)


def chosen(names: Sequence[str], since: str | None) -> list[Stage]:
    """The stages to run, in order; the environment then says what they take of their lists."""
    if since is not None:
        if names:
            sys.exit("contact: --since takes no stages and no chapters")
        return since_revision(since)
    chapters = [name for name in names if name in CHAPTERS]
    if chapters:
        if other := [name for name in names if name not in CHAPTERS]:
            sys.exit(f'contact: "{other[0]}" is no chapter; name stages or chapters, not both')
        os.environ["CONTACT_CHAPTERS"] = ",".join(chapters)
        return [stage for stage in STAGES if stage.name in OF_ONE_CHAPTER]
    known = {stage.name: stage for stage in STAGES}
    for name in names:
        if name not in known:
            sys.exit(f'contact: no stage or chapter "{name}"; ./contact test --list shows them')
    tell_what_is_touched()
    return with_needs(names or list(known))


def with_needs(names: Iterable[str]) -> list[Stage]:
    """These stages and what they need, in order."""
    known = {stage.name: stage for stage in STAGES}
    wanted = list(names)
    for name in wanted:
        wanted += [need for need in known[name].needs if need not in wanted]
    return [stage for stage in STAGES if stage.name in wanted]


def since_revision(revision: str) -> list[Stage]:
    """What the change since a revision can touch."""
    files = touched.changed_since(ROOT, revision)
    if files is None:
        sys.exit(
            f'contact: git does not know "{revision}", or what it has in common with this commit; '
            "a shallow clone must fetch the history first (git fetch --unshallow)"
        )
    found = touched.touched_by(files, touched.this_book())
    chapters = touched.chapters_of(found, touched.this_book())
    names = {"style", *(name for name, reads in READS.items() if any(map(reads.match, files)))}
    os.environ["CONTACT_TOUCHED"] = touched.as_json(found)
    print(f"{len(files)} files have changed since {revision}. They touch:")
    for line in touched.in_words(found):
        print(f"    {line}")
    if not names & set(BEYOND_CHAPTERS) and set(chapters) != set(CHAPTERS):
        # Only the chapters' own checks, and only of these.
        if chapters:
            os.environ["CONTACT_CHAPTERS"] = ",".join(chapters)
            names |= set(OF_ONE_CHAPTER)
            if "tests" in found:
                names |= {"sanitize"}
        return [stage for stage in STAGES if stage.name in names]
    if chapters:
        names |= {*OF_ONE_CHAPTER, "sanitize"}
    return with_needs(names)


def tell_what_is_touched() -> None:
    """Puts what the change touches where tools/sample.py looks for it; one who has set it knows."""
    if "CONTACT_TOUCHED" in os.environ or "CONTACT_ALL" in os.environ:
        return
    base = touched.base_of_landing(ROOT)
    files = touched.changed_since(ROOT, base) if base else None
    if files is None:
        print("git does not tell what this landing changed: the turn alone says what is taken")
        return
    book = touched.this_book()
    taken, by_turn = touched.narrowed(touched.touched_by(files, book), book)
    os.environ["CONTACT_TOUCHED"] = touched.as_json(taken)
    print(f"Always taken is what {len(files)} files touch that have changed since {base}:")
    for line in touched.in_words(taken):
        print(f"    {line}")
    if by_turn:
        print(
            f"    They touch more than half of the chapters in {', '.join(by_turn)}: all of that "
            "does not fit into a run, so the turn selects; CONTACT_ALL=1 takes all"
        )


def end_of_run(began: float) -> float | None:
    """The moment at which what may wait ends."""
    given = os.environ.get("CONTACT_MINUTES")
    if not given:
        return None
    try:
        minutes = float(given)
    except ValueError:
        minutes = -1.0
    if not minutes > 0:
        sys.exit(f"contact: CONTACT_MINUTES must be a number of minutes, and is {given[:40]!r}")
    return began + 60 * minutes


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="./contact test", description="Runs every check there is."
    )
    parser.add_argument(
        "names", nargs="*", metavar="STAGE|CHAPTER", help="only these stages, or these chapters"
    )
    parser.add_argument("--since", metavar="REV", help="what the change since REV can touch")
    parser.add_argument("--list", action="store_true", help="show the stages and stop")
    # How lanes.py runs one of them: what it found goes into --row as JSON.
    parser.add_argument("--alone", metavar="STAGE", help=argparse.SUPPRESS)
    parser.add_argument("--row", type=Path, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    sys.stdout.reconfigure(line_buffering=True)  # type: ignore[union-attr]
    if arguments.list:
        for stage in STAGES:
            print(f"{stage.name:10} at most {stage.minutes:4g} min  {stage.what}")
        print("A chapter's name checks all of that chapter alone:")
        print(textwrap.fill(", ".join(CHAPTERS), 100, initial_indent="  ", subsequent_indent="  "))
        return 0
    if arguments.alone:
        stage = next(stage for stage in STAGES if stage.name == arguments.alone)
        arguments.row.write_text(run_stage(stage).as_json(), encoding="utf-8")
        return 0

    steps.LOGS.mkdir(parents=True, exist_ok=True)
    stages = chosen(arguments.names, arguments.since)
    began = time.monotonic()
    rows = lanes.run_all(stages, until=end_of_run(began))
    total = closing_table(rows, time.monotonic() - began, WHOLE_MINUTES * 60)
    return 1 if total.failed else 0


if __name__ == "__main__":
    # A plain kill ends what was started as cleanly as Ctrl-C does.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        steps.CHILDREN.stop_all()
        print("\nStopped.", file=sys.stderr)
        sys.exit(130)
