"""import and check of an archive: what merges, and what is checked."""

from __future__ import annotations

import json
import shutil
import signal
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from archives import (
    PLANE,
    PROGRAM,
    RAY,
    STUB,
    STUB_OF_PLANE,
    Run,
    of_page,
    progress,
    put,
    tree,
    zipped,
)


@pytest.mark.parametrize(
    ("mine", "theirs", "status", "after", "kept"),
    [
        (None, "// theirs\n", "new", "// theirs\n", None),
        (None, STUB, "new", STUB, None),
        ("// mine\n", "// mine\n", "same", "// mine\n", None),
        ("// mine\n", STUB, "yours_stays", "// mine\n", None),
        (STUB, "// theirs\n", "replaced", "// theirs\n", None),
        ("// mine\n", "// theirs\n", "replaced", "// theirs\n", "// mine\n"),
        ("", "// theirs\n", "replaced", "// theirs\n", None),
        ("// mine\n", "", "replaced", "", "// mine\n"),
    ],
)
def test_what_an_import_does_with_a_copy(
    contact: Run,
    work: Path,
    tmp_path: Path,
    mine: str | None,
    theirs: str,
    status: str,
    after: str,
    kept: str | None,
) -> None:
    if mine is not None:
        put(work, {f"{RAY}.cpp": mine})
    zipped(tmp_path / "a.zip", of_page({RAY: theirs}))
    done = contact("import", "a.zip", "--json")
    assert done.returncode == 0
    document = json.loads(done.stdout)
    assert document["format"] == "contact-import/1"
    assert document["from"] == "page"
    (result,) = document["results"]
    assert (result["exercise"], result["status"], result["known"]) == (RAY, status, True)
    found = tree(work)
    assert found.pop(f"{RAY}.cpp") == after
    assert list(found.values()) == ([] if kept is None else [kept])
    if kept is not None:
        assert Path(result["kept"]).read_text() == kept
    again = json.loads(contact("import", "a.zip", "--json").stdout)["results"][0]["status"]
    assert again == ("yours_stays" if status == "yours_stays" else "same")


def test_an_import_says_what_it_did(contact: Run, work: Path, tmp_path: Path) -> None:
    put(work, {f"{RAY}.cpp": "// mine\n"})
    copies = {RAY: "// theirs\n", "77_future/thing": "int x;\n"}
    zipped(tmp_path / "a.zip", of_page(copies, progress({PLANE: {"attempts": 1}})))
    done = contact("import", "a.zip")
    assert done.returncode == 0
    first, *lines = done.stdout.splitlines()
    assert "from the page" in first
    assert ".kept/02_triangles/ray_triangle." in lines[0]
    assert "does not have" in lines[1]
    assert PLANE in lines[2]
    assert (work / "77_future/thing.cpp").read_text() == "int x;\n"


def test_an_import_through_a_link_keeps_what_it_points_to(
    contact: Run, work: Path, tmp_path: Path
) -> None:
    mine = tmp_path / "elsewhere.cpp"
    mine.write_text("// mine\n")
    (work / "02_triangles").mkdir(parents=True)
    (work / f"{RAY}.cpp").symlink_to(mine)
    zipped(tmp_path / "a.zip", of_page({RAY: "// theirs\n"}))
    assert contact("import", "a.zip").returncode == 0
    assert (work / f"{RAY}.cpp").read_text() == "// theirs\n"
    assert mine.read_text() == "// mine\n"


EARLY, LATE = "2026-01-01T00:00:00Z", "2026-01-02T00:00:00.5Z"


@pytest.mark.parametrize("swapped", [False, True])
def test_progress_takes_the_best_of_both(
    contact: Run, work: Path, tmp_path: Path, swapped: bool
) -> None:
    earlier = {
        "attempts": 3,
        "best_points": 12.0,
        "max_points": 12.0,
        "passed": EARLY,
        "last_checked": EARLY,
        "hints_shown": 1,
        "solution_shown": True,
        "tests": {"a": "passed"},
        "mood": "bright",
        "only": "earlier",
    }
    later = {
        "attempts": 2,
        "best_points": 4.5,
        "max_points": 13.0,
        "passed": LATE,
        "last_checked": LATE,
        "hints_shown": 2,
        "solution_shown": False,
        "tests": {"a": "failed"},
        "mood": "dark",
        "also": "later",
    }
    best = later | {
        "attempts": 3,
        "best_points": 12.0,
        "passed": EARLY,
        "solution_shown": True,
        "only": "earlier",
    }
    mine, theirs = (later, earlier) if swapped else (earlier, later)
    put(work, {"progress.json": progress({RAY: mine, PLANE: {"attempts": 1}}, here=1, both="h")})
    more = {"there": 2, "both": "t"}
    zipped(tmp_path / "a.zip", of_page({}, progress({RAY: theirs, "77_f/g": later}, **more)))
    for changed in ([RAY, "77_f/g"], []):
        done = contact("import", "a.zip", "--json")
        assert json.loads(done.stdout)["progress"] == changed
        record = json.loads((work / "progress.json").read_text())
        assert record["exercises"] == {RAY: best, PLANE: {"attempts": 1}, "77_f/g": later}
        assert (record["here"], record["there"], record["both"]) == (1, 2, "h")
    report = json.loads(contact("progress", "--json").stdout)["exercises"][RAY]
    assert (report["attempts"], report["hints_shown"], report["passed"]) == (3, 2, EARLY)
    assert report["tests"] == {"a": "failed"}


def test_a_record_of_nonsense_changes_nothing(contact: Run, work: Path, tmp_path: Path) -> None:
    mine = {"attempts": 3, "best_points": 2.0, "passed": EARLY, "last_checked": EARLY}
    put(work, {"progress.json": progress({RAY: mine})})
    nonsense = {
        "attempts": "many",
        "best_points": -1e300,
        "max_points": None,
        "passed": "0000",
        "last_checked": "9999-99-99",
        "hints_shown": [],
        "solution_shown": 1,
    }
    record = progress({RAY: nonsense, "../../etc": {"attempts": 1}, "\u001b[2J/x": {}})
    zipped(tmp_path / "a.zip", of_page({}, record))
    assert contact("import", "a.zip").returncode == 0
    found = json.loads((work / "progress.json").read_text())["exercises"]
    assert list(found) == [RAY]
    assert {name: found[RAY][name] for name in mine} == mine


def test_a_number_that_no_count_reaches_is_cut(contact: Run, work: Path, tmp_path: Path) -> None:
    huge = {"attempts": 1e300, "hints_shown": 2**63, "best_points": 1e300}
    zipped(tmp_path / "a.zip", of_page({}, progress({RAY: huge})))
    assert contact("import", "a.zip").returncode == 0
    report = json.loads(contact("progress", "--json").stdout)
    assert report["exercises"][RAY]["attempts"] == 1_000_000
    assert report["total"]["points"] <= report["total"]["max_points"]


def test_what_the_page_wrote_into_the_record_stays(
    contact: Run, solution: str, answer: Callable[[str], Path], work: Path, tmp_path: Path
) -> None:
    record = progress({RAY: {"attempts": 1, "seconds_open": 90}}, settings={"font": 3})
    zipped(tmp_path / "a.zip", of_page({}, record))
    contact("import", "a.zip")
    answer(solution)
    assert contact("check", "ray_triangle").returncode == 0
    found = json.loads((work / "progress.json").read_text())
    assert found["settings"] == {"font": 3}
    assert found["exercises"][RAY]["seconds_open"] == 90
    assert found["exercises"][RAY]["attempts"] == 2


def test_a_broken_record_here_is_kept_aside(contact: Run, work: Path, tmp_path: Path) -> None:
    put(work, {"progress.json": "{"})
    zipped(tmp_path / "a.zip", of_page({}, progress({RAY: {"attempts": 4}})))
    done = contact("import", "a.zip")
    assert done.returncode == 0
    assert "kept as" in done.stderr
    (aside,) = work.glob("progress.json.broken-*")
    assert aside.read_text() == "{"
    assert json.loads((work / "progress.json").read_text())["exercises"][RAY]["attempts"] == 4


def test_a_copy_that_cannot_be_written_stops_all(contact: Run, work: Path, tmp_path: Path) -> None:
    put(work, {f"{PLANE}.cpp": "// mine\n", "02_triangles": "a file where a folder must be"})
    before = tree(work)
    zipped(tmp_path / "a.zip", of_page({PLANE: "// theirs\n", RAY: "// theirs\n"}))
    done = contact("import", "a.zip")
    assert done.returncode == 3
    assert tree(work) == before


def test_a_killed_import_leaves_old_or_new(
    environment: dict[str, str], work: Path, tmp_path: Path
) -> None:
    names = [f"77_many/n{number}" for number in range(900)]
    old = {name: f"// old {name}\n" * 50 for name in names}
    new = {name: f"// new {name}\n" * 50 for name in names}
    zipped(tmp_path / "a.zip", of_page(new, progress({RAY: {"attempts": 7}})))
    middle = 0
    for wait in (0, 0, 0, 100, 300, 600):
        shutil.rmtree(work, ignore_errors=True)
        put(work, {f"{name}.cpp": text for name, text in old.items()})
        started = subprocess.Popen([PROGRAM, "import", tmp_path / "a.zip"], env=environment)
        # Kill it while it keeps the old versions, and while it puts the new ones in place.
        sign = work / f"{names[wait]}.cpp" if wait else work / ".kept"
        before = sign.stat().st_ino if wait else 0
        while started.poll() is None:
            if (sign.exists() and not wait) or (wait and sign.stat().st_ino != before):
                started.kill()
                break
            time.sleep(0)
        middle += started.wait() == -signal.SIGKILL
        kept = {file.read_text() for file in (work / ".kept").rglob("*.cpp")}
        for name in names:
            text = (work / f"{name}.cpp").read_text()
            assert text in (old[name], new[name])
            assert text == old[name] or old[name] in kept
        done = subprocess.run([PROGRAM, "import", tmp_path / "a.zip"], env=environment)
        assert done.returncode == 0
        assert {name: (work / f"{name}.cpp").read_text() for name in names} == new
        assert json.loads((work / "progress.json").read_text())["exercises"][RAY]["attempts"] == 7
        assert not (work / ".import").exists()
    assert middle > 0


@pytest.mark.usefixtures("clean_after")
def test_a_check_of_an_archive_is_a_check_of_its_copies(
    contact: Run, solution: str, spoiled: Callable[[str], str], work: Path, tmp_path: Path
) -> None:
    wrong = spoiled("return std::nullopt;")
    zipped(tmp_path / "good.zip", of_page({RAY: solution, PLANE: STUB_OF_PLANE}))
    zipped(tmp_path / "bad.zip", of_page({RAY: wrong}))
    good = contact("check", "good.zip", "--json")
    bad = contact("check", "bad.zip", "--json")
    assert not work.exists()
    assert good.returncode == 0
    assert bad.returncode == 1
    document = json.loads(good.stdout)
    assert document["untouched"] == [PLANE]
    assert (document["archive"], document["unknown"]) == ("good.zip", [])
    assert document["results"][0]["file"] == f"good.zip:work/{RAY}.cpp"
    put(work, {f"{RAY}.cpp": wrong})
    own = json.loads(contact("check", "ray_triangle", "--json").stdout)

    def verdict(document: dict[str, Any]) -> tuple[object, ...]:
        (result,) = document["results"]
        tests = [{k: v for k, v in test.items() if k != "seconds"} for test in result["tests"]]
        return result["verdict"], result["points"], tests

    assert verdict(json.loads(bad.stdout)) == verdict(own)


@pytest.mark.usefixtures("clean_after")
def test_an_archive_is_checked_in_words_too(contact: Run, tmp_path: Path) -> None:
    zipped(tmp_path / "a.zip", of_page({RAY: STUB + "int unused() { return nonsense; }\n"}))
    done = contact("check", "a.zip", "--full")
    assert done.returncode == 1
    assert f"a.zip:work/{RAY}.cpp" in done.stdout
    assert "/contact-" not in done.stdout
    # Every part of the document speaks of the archive, and none of a folder that is gone.
    text = contact("check", "a.zip", "--json").stdout
    error = json.loads(text)["results"][0]["compile_error"]
    assert error["file"] == f"a.zip:work/{RAY}.cpp"
    assert "/contact-" not in text


def test_an_exercise_that_the_book_does_not_know_is_named(
    contact: Run, solution: str, tmp_path: Path
) -> None:
    zipped(tmp_path / "a.zip", of_page({RAY: solution, "77_future/thing": "int x;"}))
    done = contact("check", "a.zip", "--json")
    assert done.returncode == 1
    document = json.loads(done.stdout)
    assert document["results"][0]["verdict"] == "passed"
    assert document["unknown"] == ["work/77_future/thing.cpp"]
    assert "work/77_future/thing.cpp" in contact("check", "a.zip").stderr


def test_an_archive_without_copies_is_no_success(contact: Run, tmp_path: Path) -> None:
    zipped(tmp_path / "a.zip", of_page({}, progress({})))
    done = contact("check", "a.zip", "--json")
    assert done.returncode == 1
    assert json.loads(done.stdout)["results"] == []
    assert "nothing to check" in done.stderr


@pytest.mark.parametrize("command", ["check", "import"])
def test_a_name_without_a_file_is_a_usage_error(contact: Run, command: str) -> None:
    done = contact(command, "nowhere.zip")
    assert done.returncode == 2
    assert "nowhere.zip" in done.stderr


def test_an_archive_is_checked_alone(contact: Run, tmp_path: Path) -> None:
    zipped(tmp_path / "a.zip", of_page({}))
    assert contact("check", "a.zip", "ray_triangle").returncode == 2
