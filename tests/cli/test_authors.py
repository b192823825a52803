"""new, dev check, ladder and doctor: what authors use. The slow one builds a copy of the book."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

sys.path.append(str(Path(__file__).resolve().parents[2] / "tools"))

from sample import sample

Run = Callable[..., subprocess.CompletedProcess[str]]
ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build" / "dev" / "bin" / "contact"
SOURCES = (
    "benchmarks",
    "chapters",
    "exercises",
    "solutions",
    "tests",
    "grading",
    "cmake",
    "cli",
    "page/figure",
)
NULL_KINDS = ("zeros", "nan", "infinity", "minus_infinity", "huge", "random", "echo")


@pytest.fixture
def clone(tmp_path: Path) -> Path:
    """The sources, without what is built."""
    folder = tmp_path / "clone"
    folder.mkdir()
    ignored = shutil.ignore_patterns("__pycache__", "node_modules")
    for name in SOURCES:
        shutil.copytree(ROOT / name, folder / name, ignore=ignored)
    for name in ("CMakeLists.txt", "CMakePresets.json"):
        shutil.copy2(ROOT / name, folder / name)
    (folder / "build").mkdir()
    if (ROOT / "build/venv").exists():
        (folder / "build/venv").symlink_to(ROOT / "build/venv")
    return folder


def contact(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "CONTACT_ROOT": str(folder), "CONTACT_WORK": str(folder / "work")}
    return subprocess.run(
        [str(PROGRAM), *words],
        capture_output=True,
        text=True,
        env=environment,
        cwd=folder,
        timeout=1800,
    )


def cmake(folder: Path, *words: str) -> None:
    done = subprocess.run(
        ["cmake", *words], capture_output=True, text=True, cwd=folder, timeout=1800
    )
    assert done.returncode == 0, done.stdout[-4000:] + done.stderr[-4000:]


def problems(folder: Path, name: str) -> dict[str, list[str]]:
    """What `dev check` finds, by kind, of everything whose name begins so."""
    done = contact(folder, "dev", "check", "--json", *([name] if "/" in name else []))
    document = json.loads(done.stdout)
    assert document["format"] == "contact-dev-check/1"
    assert done.returncode == (1 if document["failed"] else 0)
    found: dict[str, list[str]] = {}
    for result in document["results"]:
        if result["name"].startswith(name):
            found.setdefault(result["kind"], []).extend(result["problems"])
    return found


def test_new_refuses_what_is_there(clone: Path) -> None:
    assert contact(clone, "new", "chapter", "02_circles").returncode == 3
    assert contact(clone, "new", "exercise", "02_triangles/ray_triangle").returncode == 3
    assert contact(clone, "new", "exercise", "77_nowhere/anything").returncode == 2


def test_new_overwrites_nothing(clone: Path) -> None:
    mine = clone / "tests/31_trial/reference_test.cpp"
    mine.parent.mkdir()
    mine.write_text("// mine\n")
    assert contact(clone, "new", "chapter", "31_trial").returncode == 3
    assert mine.read_text() == "// mine\n"
    assert not (clone / "chapters/31_trial").exists()


# What a new chapter and its first exercise become. To compile it takes longer than everything else
# in this folder together, so a run builds a third.
BECOMES = {
    "figure and example": ["figure_31_trial_trial", "example_31_trial_trial"],
    "tests": ["reference_tests_31_trial", "hard_cases_31_trial"],
    "ladder": ["ladder_31_trial"],
    "exercise": ["exercise_31_trial_first_trial"],
}


@pytest.mark.slow
def test_a_new_chapter_and_exercise_build_and_lack_content_only(clone: Path) -> None:
    built = sample(list(BECOMES), 3, "what a new chapter becomes", kind="authors")
    assert contact(clone, "new", "chapter", "31_trial").returncode == 0
    made = contact(clone, "new", "exercise", "31_trial/first_trial")
    assert made.returncode == 0, made.stderr
    assert 'exercises = ["first_trial"]' in (clone / "chapters/31_trial/chapter.toml").read_text()
    for chapter in clone.glob("chapters/[0-9]*"):
        if chapter.name not in ("00_vectors", "01_planes", "31_trial"):
            for tree in ("chapters", "exercises", "solutions", "tests"):
                shutil.rmtree(clone / tree / chapter.name, ignore_errors=True)
    cmake(clone, "--preset", "dev", "-DCONTACT_BUILD_DOCS=OFF")
    targets = [target for part in built for target in BECOMES[part]]
    cmake(clone, "--build", "build/dev", "--target", *targets)
    programs = clone / "build/dev/bin"
    if "tests" in built:
        subprocess.run([str(programs / "reference_tests_31_trial")], check=True, cwd=clone)
        subprocess.run([str(programs / "hard_cases_31_trial")], check=True, cwd=clone)
    if "figure and example" in built:
        printed = subprocess.run(
            [str(programs / "example_31_trial_trial")], check=True, capture_output=True, text=True
        ).stdout
        assert printed == (clone / "chapters/31_trial/examples/trial.out").read_text()
    if "exercise" in built:
        lacks_content_only(clone)


def lacks_content_only(clone: Path) -> None:
    found = problems(clone, "31_trial/first_trial")
    assert found["stub"] == []
    assert found["null answer"] == []
    assert any("not attempted" in text for text in found["solution"])
    assert any("TO WRITE" in text or "recognises nothing" in text for text in found["wrong answer"])
    assert any("still to write" in text for text in found["exercise"])


def test_dev_check_sees_what_is_wrong_in_the_files(clone: Path) -> None:
    folder = clone / "exercises/02_triangles/ray_triangle"
    (folder / "notes.txt").write_text("stray")
    (clone / "chapters/20_scenes/scenes/no_scene.txt").write_text("stray")
    (clone / "tests/20_scenes/scenes/no_scene.txt").write_text("stray")
    (folder / "ray_triangle.cpp").write_text('#include "ray_triangle.hpp"\n')
    toml = folder / "exercise.toml"
    toml.write_text(
        toml.read_text()
        .replace('"beta-sign",', '"beta-sign", "never-heard-of",')
        .replace("points = 3", 'points = 3\nrequires = ["no such test"]')
    )
    chapter = clone / "chapters/01_planes/chapter.toml"
    chapter.write_text(
        chapter.read_text().replace('builds_on = ["00_vectors"]', 'builds_on = ["02_triangles"]')
    )
    shutil.copy2(
        clone / "chapters/01_planes/contact/plane.hpp",
        clone / "chapters/02_triangles/contact/plane.hpp",
    )
    lesson = clone / "chapters/01_planes/lesson.md"
    lesson.write_text(lesson.read_text() + "\n" + "word " * 9001)
    # Nothing is built in this copy, so the answers are not checked: the files are.
    environment = {**os.environ, "CONTACT_ROOT": str(clone)}
    text = subprocess.run(
        [str(PROGRAM), "dev", "check", "--files"], capture_output=True, text=True, env=environment
    ).stdout
    for part in (
        "notes.txt",
        "no_scene.txt",
        "does not say contact::todo()",
        "no hint for never-heard-of",
        "requires one that does not exist: 'no such test'",
        "builds on itself",
        "and may take 45: ",
        "plane.hpp is in 01_planes and in 02_triangles",
    ):
        assert part in " ".join(text.split()), part


def test_dev_check_says_which_patch_does_not_apply_and_why(clone: Path) -> None:
    exercise = "12_momentum/force_curve"
    solution = clone / f"solutions/{exercise}/force_curve.cpp"
    solution.write_text(solution.read_text().replace("impulse += width", "impulse += 1.0 * width"))
    wrong = solution.parent / "wrong"
    kept = (wrong / "equal_steps.patch", wrong / "rectangles.patch")
    assert all(file.is_file() for file in kept)
    kept[0].write_text(kept[0].read_text().replace("--- ", "of nobody\n--- ", 1))
    done = contact(clone, "dev", "check", "--files", exercise, "--json")
    assert done.returncode == 1
    failed = {
        result["name"]: result["problems"]
        for result in json.loads(done.stdout)["results"]
        if result["kind"] == "wrong answer"
    }
    assert any(
        "solutions/12_momentum/force_curve/wrong/rectangles.patch: @@ -6,7 +6,7 @@ does not apply:"
        " what it changes is nowhere in the solution" in problem
        for problem in failed[f"{exercise}/rectangles"]
    )
    assert any("it must go on with `--- ...`" in text for text in failed[f"{exercise}/equal_steps"])


@pytest.mark.parametrize(
    ("seen", "problem"),
    [
        ("", "it must begin with `// seen: ...`, but the line is `"),
        ("// seen: \n", "it must begin with `// seen: ...`"),
        ("// seen: somewhere\n", "`// seen: somewhere` names no place: an address, a lecture"),
        ("// seen: https://\n", "`// seen: https://` names no place"),
    ],
)
def test_dev_check_wants_to_know_where_a_wrong_answer_was_seen(
    clone: Path, seen: str, problem: str
) -> None:
    exercise = "12_momentum/force_curve"
    wrong = clone / f"solutions/{exercise}/wrong/peak_force.cpp"
    text = re.sub(r"// seen: .*\n", "// seen: not found\n", wrong.read_text(), count=1)
    wrong.write_text(text.replace("// seen: not found\n", seen))
    done = contact(clone, "dev", "check", "--files", exercise, "--json")
    assert done.returncode == 1
    problems = [p for r in json.loads(done.stdout)["results"] for p in r["problems"]]
    assert any("wrong/peak_force.cpp: " + problem in p for p in problems), problems


def test_dev_check_wants_a_wrong_answer_not_to_have_an_exercises_name(clone: Path) -> None:
    exercise = "12_momentum/force_curve"
    wrong = clone / f"solutions/{exercise}/wrong/peak_force.cpp"
    wrong.rename(wrong.with_name("sum_of_impulses.cpp"))
    done = contact(clone, "dev", "check", "--files", exercise, "--json")
    assert done.returncode == 1
    problems = [p for r in json.loads(done.stdout)["results"] for p in r["problems"]]
    assert any(
        "wrong/sum_of_impulses.cpp: 12_momentum/sum_of_impulses has this name" in p
        for p in problems
    ), problems


def test_dev_check_proves_one_exercise_whatever_is_in_work(contact: Run, work: Path) -> None:
    copy = work / "02_triangles/ray_triangle.cpp"
    copy.parent.mkdir(parents=True)
    copy.write_text("#error mine\n")
    done = contact("dev", "check", "02_triangles/ray_triangle", "--json")
    document: dict[str, Any] = json.loads(done.stdout)
    assert done.returncode == 0, [r for r in document["results"] if not r["passed"]]
    assert document["failed"] == 0
    wrong = list((ROOT / "solutions/02_triangles/ray_triangle/wrong").iterdir())
    assert document["counts"]["wrong answers"]["passed"] == len(wrong)
    assert document["counts"]["null answers"]["passed"] == len(NULL_KINDS)


def test_dev_check_reports_answers_that_get_what_they_must_not(
    contact: Run, solution: str, tmp_path: Path
) -> None:
    """Each in its own way, and all in one run: a wrong answer that no test catches, one that causes
    a remark, and null answers that earn points."""
    root = tmp_path / "root"
    root.mkdir()
    for name in ("chapters", "exercises", "tests", "build"):
        (root / name).symlink_to(ROOT / name)
    for name in ("solutions", "grading"):
        shutil.copytree(ROOT / name, root / name)
    wrong = root / "solutions/02_triangles/ray_triangle/wrong"
    uncaught, remarked = wrong / "beta_sign.cpp", wrong / "one_sided.cpp"
    uncaught.write_text("".join(uncaught.read_text().splitlines(keepends=True)[:3]) + solution)
    begin, body, rest = remarked.read_text().partition("& triangle) {\n")
    remarked.write_text(begin + body + "double x = 1.0; if (x = 0.0) return std::nullopt;\n" + rest)
    # In place of the answer that knows nothing: one that knows all.
    (root / "grading/contract/null_answers.py").write_text(
        f"import pathlib, sys\npathlib.Path(sys.argv[-1], 'null.cpp').write_text({solution!r})\n"
    )
    done = contact("dev", "check", "ray_triangle", "--json", CONTACT_ROOT=str(root))
    assert done.returncode == 1
    results = json.loads(done.stdout)["results"]
    failed = {
        (result["kind"], result["name"].rpartition("/")[2]): result["problems"][0]
        for result in results
        if not result["passed"]
    }
    says = {
        ("wrong answer", "beta_sign"): "should fail where it does not",
        ("wrong answer", "one_sided"): "would be remarked upon: One = assigns",
        **{("null answer", kind): "it earns 3" for kind in NULL_KINDS},
    }
    assert failed.keys() == says.keys()
    for which, words in says.items():
        assert words in failed[which]


def test_dev_check_takes_a_chapter_for_its_exercises(contact: Run) -> None:
    done = contact("dev", "check", "02_triangles", "--files", "--json")
    exercises = {folder.name for folder in (ROOT / "exercises/02_triangles").iterdir()}
    checked = {result["name"] for result in json.loads(done.stdout)["results"]}
    assert checked == {f"02_triangles/{name}" for name in exercises}


def test_ladder_of_an_unknown_chapter_says_where_to_look(contact: Run) -> None:
    done = contact("ladder", "09_nothing")
    assert done.returncode == 2
    assert "09_nothing" in done.stderr
    assert "contact list" in done.stderr


def test_ladder_measures_and_keeps_the_result(contact: Run, tmp_path: Path) -> None:
    kept = tmp_path / "ladder.json"
    done = contact("ladder", "02", "--size", "50", "--repeats", "2", "--output", str(kept))
    assert done.returncode == 0, done.stderr
    ladder = json.loads(kept.read_text())
    assert ladder["ladder"] == "02_triangles"
    assert ladder["machine"]["cpu"]
    assert len(ladder["results"]) == len(ladder["families"]) * len(ladder["methods"])
    for family in ladder["families"]:
        assert family["title"] in done.stdout


def test_doctor_says_what_is_there(contact: Run) -> None:
    done = contact("doctor", "--json")
    findings = json.loads(done.stdout)["findings"]
    missing = [finding for finding in findings if finding["standing"] == "missing"]
    assert done.returncode == (3 if missing else 0)
    assert all(finding["remedy"] for finding in missing)
    assert any(finding["what"].startswith("C++ compiler") for finding in findings)


def test_doctor_says_what_is_missing(contact: Run, tmp_path: Path) -> None:
    empty = tmp_path / "empty"
    empty.mkdir()
    done = contact("doctor", PATH=str(empty))
    assert done.returncode == 3
    assert "missing" in done.stdout
    assert "./contact setup" in done.stdout
