"""Which stages `./contact test` runs for a chapter and for a change, and the contents of its
table."""

from __future__ import annotations

import importlib.util
import json
import os
import re
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from slices import Slice, read_slices, slice_in_words  # noqa: E402
from stages import Tally  # noqa: E402


def load() -> ModuleType:
    # By its path: Python has a package of that name.
    spec = importlib.util.spec_from_file_location("contact_test", ROOT / "tools" / "test.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.modules["contact_test"] = module
    spec.loader.exec_module(module)
    return module


checks = load()


@pytest.fixture(autouse=True)
def environment(monkeypatch: pytest.MonkeyPatch) -> None:
    """What `chosen` sets there goes afterwards."""
    for name in ("CONTACT_CHAPTERS", "CONTACT_TOUCHED", "CONTACT_ALL", "CONTACT_TURN"):
        monkeypatch.setenv(name, "")
        monkeypatch.delenv(name)


def names(*words: str, since: str | None = None) -> list[str]:
    return [stage.name for stage in checks.chosen(words, since)]


def changed(monkeypatch: pytest.MonkeyPatch, *files: str) -> list[str]:
    monkeypatch.setattr(checks.touched, "changed_since", lambda _root, _base: list(files))
    return names(since="somewhere")


def test_a_chapter_is_all_of_it_and_nothing_else() -> None:
    assert names("02_triangles") == [
        *("native", "ctest", "dev-check", "ladder", "page", "wasm", "book", "twins", "browser")
    ]
    assert os.environ["CONTACT_CHAPTERS"] == "02_triangles"


@pytest.mark.parametrize("chapter", checks.CHAPTERS)
def test_a_chapter_is_asked_for_what_it_has(chapter: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CONTACT_CHAPTERS", chapter)
    monkeypatch.setattr(checks, "node_tests", lambda _what, files, _cwd, **_: iter(files))
    files = {file.name.split(".")[0] for file in checks.browser()}
    folder = ROOT / "chapters" / chapter
    lesson = (folder / "lesson.md").exists()
    exercises = any((ROOT / "exercises" / chapter).glob("*/exercise.toml"))
    assert ("pages" in files) == ("questions" in files) == lesson
    assert ("figures" in files) == (lesson and any(folder.glob("figures/*.cpp")))
    assert ("parity" in files) == exercises
    assert bool(list(checks.dev_check())) == exercises
    assert files <= {"pages", "figures", "questions", "ladder", "parity"}


def test_a_stage_brings_what_it_needs() -> None:
    assert names("ctest") == ["native", "ctest"]
    assert "CONTACT_CHAPTERS" not in os.environ


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["02_triangle"], 'no stage or chapter "02_triangle"'),
        (["02_triangles", "style"], '"style" is no chapter'),
        (["--since", "HEAD", "style"], "--since takes no stages"),
        (["--since", "no-such-revision"], 'does not know "no-such-revision"'),
    ],
)
def test_what_is_not_understood_is_told(words: list[str], told: str) -> None:
    command = [sys.executable, str(ROOT / "tools" / "test.py"), *words]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd="/")
    assert done.returncode == 1
    assert told in done.stderr
    assert "Traceback" not in done.stderr


def test_a_change_of_one_chapter_is_checked_there(monkeypatch: pytest.MonkeyPatch) -> None:
    stages = changed(monkeypatch, "chapters/20_scenes/contact/plan_costs.hpp")
    assert os.environ["CONTACT_CHAPTERS"] == "20_scenes,21_events,22_horizon"
    assert {"style", "ctest", "tidy", "sanitize", "browser"} <= set(stages)
    assert not {"grade", "program", "outside"} & set(stages)


def test_a_header_is_checked_wherever_it_is_built_on(monkeypatch: pytest.MonkeyPatch) -> None:
    changed(monkeypatch, "chapters/12_momentum/contact/momentum.hpp")
    asked = os.environ["CONTACT_CHAPTERS"].split(",")
    assert {"12_momentum", "13_collisions_1d", "17_rigid_impulse", "20_scenes"} <= set(asked)
    assert "01_planes" not in asked


def test_a_change_beyond_chapters_narrows_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    stages = changed(monkeypatch, "grading/sandbox/box.cpp", "chapters/01_planes/lesson.md")
    assert "CONTACT_CHAPTERS" not in os.environ
    assert json.loads(os.environ["CONTACT_TOUCHED"]) == {
        "grading": ["*"],
        "page": ["01_planes"],
        "tidy": ["grading/sandbox/box.cpp"],
    }
    assert {"style", "native", "ctest", "grade", "program", "tidy", "browser"} <= set(stages)


def test_a_change_of_nothing_built_is_a_matter_of_style(monkeypatch: pytest.MonkeyPatch) -> None:
    assert changed(monkeypatch, "README.md") == ["style"]


@pytest.mark.parametrize(
    ("file", "stage"),
    [
        ("cli/exercises/list.cpp", "program"),
        ("tests/grade/test_resume.py", "grade"),
        ("contact", "outside"),
        ("tools/setup.sh", "outside"),
        ("tests/support/oracle.cpp", "ctest"),
        ("page/web/test/order.test.mjs", "page"),
        ("page/wasm/pool.mjs", "wasm"),
        ("tests/serve/test_serve.py", "book"),
        ("tests/browser/home.test.mjs", "browser"),
        ("cmake/ContactTargets.cmake", "dev-check"),
    ],
)
def test_a_file_is_checked_by_the_stage_that_reads_it(
    monkeypatch: pytest.MonkeyPatch, file: str, stage: str
) -> None:
    assert stage in changed(monkeypatch, file)


# --- What is built in a turn ----------------------------------------------------------------------


def built_and_run(turn: int, monkeypatch: pytest.MonkeyPatch) -> tuple[set[str], str]:
    """The targets of the stages plain and ladder, and the pattern of the tests that plain runs."""
    monkeypatch.setenv("CONTACT_TURN", str(turn))
    monkeypatch.setattr(checks, "build_of", lambda _preset, *targets, **_: list(targets))
    monkeypatch.setattr(checks, "ctest", lambda _preset, *words, **_: words)
    monkeypatch.setattr(checks, "once", lambda what, *_: what)
    monkeypatch.setattr(checks, "pytest", lambda *_: iter(()))
    *built, words = checks.plain()
    built += [one for one in checks.ladder() if isinstance(one, list)]
    return {target for targets in built for target in targets}, words[1]


def test_what_runs_as_optimised_is_what_is_built(monkeypatch: pytest.MonkeyPatch) -> None:
    examples = {
        f"example_{file.parts[-3]}_{file.stem}" for file in ROOT.glob("chapters/*/examples/*.cpp")
    }
    ladders = {f"ladder_{file.parent.name}" for file in ROOT.glob("chapters/*/ladder.cpp")}
    tests = {f"{kind}_{slug}" for kind in checks.KINDS_OF_TESTS for slug in checks.with_tests()}
    of_ctest = {f"{name}: a case" for name in tests if name.startswith("reference")}
    of_ctest |= examples | {name for name in tests if name.startswith("hard")}
    seen: list[str] = []
    for turn in (41, 42, 43):
        built, run = built_and_run(turn, monkeypatch)
        of_turns = built & (examples | ladders | tests)
        assert 0 < len(of_turns) < len(examples | ladders | tests) / 2
        seen += of_turns
        for test in of_ctest:
            assert bool(re.match(run, test)) == (test.split(":")[0] in built), test
    assert sorted(seen) == sorted(examples | ladders | tests)


def test_what_runs_by_turns_is_left_out_of_what_every_run_has(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(checks, "cmake_build", lambda _preset, *targets: iter(targets))
    monkeypatch.setattr(checks, "ctest", lambda _preset, *words: words)
    assert list(checks.native()) == ["all_but_turns"]
    [words] = checks.native_tests()
    for name in (
        "reference_tests_01_planes: a case",
        "hard_cases_01_planes",
        "example_01_planes_a",
    ):
        assert re.match(words[1], name)
    for name in ("contract_linked_02_triangles_ray_triangle", "grading_tests: a case"):
        assert not re.match(words[1], name)


# --- What a failed test says ---------------------------------------------------------------------


def counted(folder: Path, *command: str) -> Tally:
    """What a stage tells of a command that writes junit.xml."""
    count = checks.count_junit(folder / "junit.xml")
    tally: Tally = checks.counted("some tests", list(command), count, cwd=folder)(60)
    return tally


def test_a_failed_program_of_ctest_ends_with_its_own_words(tmp_path: Path) -> None:
    lines = "; ".join(f"echo line {i}" for i in range(30))
    script = tmp_path / "fails.sh"
    script.write_text(f"{lines}\necho '<wrong> & odd' >&2\nexit 3\n")
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(some NONE)\nenable_testing()\n"
        f'add_test(NAME "fails: a case" COMMAND sh "{script}")\n'
        "add_test(NAME passes COMMAND sh -c :)\n"
    )
    built = tmp_path / "build"
    subprocess.run(["cmake", "-S", tmp_path, "-B", built], check=True, capture_output=True)
    ctest = ["ctest", "--test-dir", str(built), "--output-junit", str(tmp_path / "junit.xml")]
    tally = counted(tmp_path, *ctest)
    assert (tally.passed, tally.failed, tally.names) == (1, 1, ["fails: a case"])
    why = "\n".join(tally.why)
    told = why[why.index("FAILED: fails: a case") :].splitlines()
    assert told[1:21] == [
        *(f"    line {i}" for i in range(11, 30)),
        "    <wrong> & odd",
    ]
    assert "line 10" not in why
    assert any(line.startswith("all of it: build/logs/") for line in told[21:])


def test_a_failed_test_of_pytest_ends_with_its_own_words(tmp_path: Path) -> None:
    (tmp_path / "test_some.py").write_text(
        "def test_right():\n    pass\n\n\ndef test_wrong():\n    assert [1, 2] == [1, 3]\n"
    )
    python = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider"]
    tally = counted(tmp_path, *python, f"--junitxml={tmp_path / 'junit.xml'}", "test_some.py")
    assert (tally.passed, tally.failed, tally.names) == (1, 1, ["test_wrong"])
    why = "\n".join(tally.why)
    assert "FAILED: test_wrong" in why
    assert "assert [1, 2] == [1, 3]" in why


# --- The table ------------------------------------------------------------------------------------


def test_what_several_processes_say_of_one_list_is_counted_once(tmp_path: Path) -> None:
    file = tmp_path / "slices"
    said = [
        {"what": "figures", "ran": ["a"], "left": ["b", "c"]},
        {"what": "figures", "ran": ["a"], "left": ["b", "c"]},
        {"what": "wrong", "ran": ["x"], "left": []},
        # Another file of tests took another one of the same list.
        {"what": "figures", "ran": ["c"], "left": ["a", "b"]},
    ]
    file.write_text("".join(json.dumps(line) + "\n" for line in said))
    assert read_slices(file) == {
        "figures": Slice(ran=["a", "c"], left=["b"]),
        "wrong": Slice(ran=["x"]),
    }
    assert read_slices(tmp_path / "none") == {}


def test_the_table_names_what_ran_and_what_did_not() -> None:
    told = slice_in_words("figures", Slice(ran=["a", "c"], left=["b"]))
    assert told == "  figures: 2 of 3 ran: a, c; not run: b"
    assert slice_in_words("figures", Slice(left=["b"])) == "  figures: 0 of 1 ran: none; not run: b"
    assert slice_in_words("figures", Slice(ran=["a", "b"])) == "  figures: all 2 ran"
    long = slice_in_words("many", Slice(ran=[f"{i:02}_ran" for i in range(40)], left=["z"]))
    assert max(map(len, long.splitlines())) <= 120
    assert long.endswith("not run: z")


def test_what_did_not_run_is_skipped_in_the_last_line(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("CONTACT_SLICES", str(tmp_path / "slices"))
    monkeypatch.setenv("CONTACT_TURN", "7")

    def draw() -> object:
        taken = checks.sample(["a", "b", "c"], 3, "letters")
        yield lambda _: checks.Tally(passed=len(taken), skipped=1)

    row = checks.run_stage(checks.Stage("some", "", 1, draw))
    total = checks.closing_table([row], 1.0, 60.0)
    assert (total.passed, total.failed, total.skipped) == (1, 0, 3)
    lines = capsys.readouterr().out.splitlines()
    assert lines[-1] == "1 passed, 0 failed, 3 skipped"
    assert "  letters: 1 of 3 ran: c; not run: a, b" in lines
    assert any("in turn 7" in line for line in lines)


def test_a_stage_needs_only_what_comes_before_it() -> None:
    order = [stage.name for stage in checks.STAGES]
    for stage in checks.STAGES:
        assert all(order.index(need) < order.index(stage.name) for need in stage.needs)


@pytest.mark.parametrize(
    ("test", "asked"),
    [
        # CMake has the space after the colon in its command, and CTest not in its list.
        ("reference_tests_05_meshes:the tree answers as all triangles one by one", True),
        ("reference_tests_05_meshes: the tree answers as all triangles one by one", True),
        ("hard_cases_05_meshes", True),
        ("example_05_meshes_check", True),
        ("contract_proxy_05_meshes_inside_convex", True),
        ("reference_tests_04_rays:a ray against a ball", False),
        ("example_04_rays_slabs", False),
        ("support_tests:a square root", False),
    ],
)
def test_a_chapter_is_checked_by_its_own_tests(test: str, asked: bool) -> None:
    assert bool(re.search(checks.tests_of(["05_meshes"]), test)) == asked


def test_only_reports_of_this_run_are_compared_with_what_lessons_show(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    left = tmp_path / "sanitize" / "hard_cases" / "02_triangles.json"
    left.parent.mkdir(parents=True)
    left.write_text("{}")
    monkeypatch.setattr(checks, "BUILD", tmp_path)
    stage = checks.sanitize()
    for _ in range(3):  # configure, build, ctest
        next(stage)
    assert not left.exists()


@pytest.mark.parametrize("fault", ["", "missing", "different"])
def test_a_report_must_be_there_and_be_what_the_lesson_shows(tmp_path: Path, fault: str) -> None:
    slug = "02_triangles"
    report = json.loads((ROOT / "tests" / slug / "hard_cases.told.json").read_text("utf-8"))
    if fault == "different":
        report["cases"][0]["why"] += "!"
    if fault != "missing":
        (tmp_path / f"{slug}.json").write_text(json.dumps(report))
    tell = [sys.executable, str(ROOT / "docs" / "tell_hard_cases.py"), "--check"]
    done = subprocess.run(
        [*tell, "--reports", str(tmp_path), slug], capture_output=True, text=True, check=False
    )
    assert done.returncode == (1 if fault else 0)
    if fault == "missing":
        assert "hard_cases_02_triangles failed or did not run" in done.stderr
    if fault == "different":
        assert "not what the programs say" in done.stdout


@pytest.mark.parametrize("allowed", [False, True])
def test_a_stage_with_nothing_to_check_has_failed_unless_it_may_be_empty(
    allowed: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CONTACT_SLICES", str(tmp_path / "slices"))
    monkeypatch.delenv("CONTACT_CHAPTERS", raising=False)
    stage = checks.Stage("some", "", 1, lambda: iter(()), may_be_empty=allowed)
    assert checks.run_stage(stage).tally.failed == (0 if allowed else 1)


@pytest.mark.parametrize("turn", range(3))
def test_each_chapter_is_sanitized_once_in_a_run_and_first_in_one_of_three(
    turn: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CONTACT_TOUCHED", "{}")
    taken: list[list[str]] = []

    def sanitized(chapters: list[str]) -> list[str]:
        taken.append(list(chapters))
        return []

    monkeypatch.setattr(checks, "sanitized", sanitized)
    ran = set()
    for later in range(3):
        monkeypatch.setenv("CONTACT_TURN", str(turn + later))
        taken.clear()
        list(checks.sanitize())
        assert list(checks.sanitize_rest()) == []
        first, rest = taken
        assert sorted([*first, *rest]) == sorted(checks.with_tests())
        assert first
        ran |= set(first)
    assert ran == set(checks.with_tests())
