"""export, import and check of an archive: what travels, what merges, and what is refused whole."""

from __future__ import annotations

import io
import json
import os
import random
import re
import shutil
import signal
import stat
import subprocess
import sys
import tarfile
import time
import zipfile
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "grade"))

from zip_bytes import Member, unicode_path, zip_bytes

Run = Callable[..., subprocess.CompletedProcess[str]]
Files = Mapping[str, str | bytes]
ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/dev/bin/contact"
RAY = "02_triangles/ray_triangle"
PLANE = "01_planes/sphere_plane"
STUB = (ROOT / f"exercises/{RAY}/ray_triangle.cpp").read_text()
STUB_OF_PLANE = (ROOT / f"exercises/{PLANE}/sphere_plane.cpp").read_text()
MANIFEST = json.dumps(
    {"format": "contact-submission/1", "exported": "2026-02-03T04:05:06Z", "from": "page"}
)
MIB = 1 << 20


def progress(exercises: Mapping[str, object], **more: object) -> str:
    return json.dumps({"format": "contact-progress/1", "exercises": exercises, **more})


def of_page(copies: Mapping[str, str | bytes], record: str | None = None) -> dict[str, str | bytes]:
    """The files of an archive as the page lays them out."""
    files: dict[str, str | bytes] = {"contact-submission.json": MANIFEST}
    if record is not None:
        files["work/progress.json"] = record
    return files | {f"work/{name}.cpp": text for name, text in copies.items()}


def zipped(file: Path, files: Files | Iterable[tuple[str | zipfile.ZipInfo, str | bytes]]) -> Path:
    pairs = files.items() if isinstance(files, Mapping) else files
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in pairs:
            archive.writestr(name, content)
    return file


def contents(file: Path) -> dict[str, bytes]:
    """Of an archive: all but the time of its export."""
    with zipfile.ZipFile(file) as archive:
        assert archive.testzip() is None
        found = {name: archive.read(name) for name in archive.namelist()}
    manifest = json.loads(found.pop("contact-submission.json"))
    assert manifest["format"] == "contact-submission/1"
    assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", manifest["exported"])
    return found


def tree(folder: Path) -> dict[str, str]:
    """Every file below a folder, but the locks, which are empty and stay."""
    return {
        str(file.relative_to(folder)): file.read_bytes().decode(errors="surrogateescape")
        for file in sorted(folder.rglob("*"))
        if file.is_file() and not file.name.endswith(".lock")
    }


def put(work: Path, files: Mapping[str, str]) -> None:
    for name, text in files.items():
        (work / name).parent.mkdir(parents=True, exist_ok=True)
        (work / name).write_text(text)


# --- export ---------------------------------------------------------------------------------------


@pytest.fixture
def worked(work: Path) -> dict[str, str]:
    files = {
        f"{RAY}.cpp": "// mine: α\n",
        f"{PLANE}.cpp": "int x;\r\n",
        "77_future/not_in_this_book.cpp": "int later;",
        "progress.json": json.dumps(
            json.loads(progress({RAY: {"attempts": 2}}, questions={"q": 1})),
            indent=2,
            sort_keys=True,
        )
        + "\n",
    }
    put(work, files)
    return files


def test_an_export_holds_every_copy_and_the_record(
    contact: Run, work: Path, worked: dict[str, str], tmp_path: Path
) -> None:
    put(work, {"notes.txt": "x", "02_triangles/Helper.cpp": "x", ".kept/02_triangles/a.cpp": "x"})
    done = contact("export", "mine.zip")
    assert done.returncode == 0
    assert "3 copies" in done.stdout
    assert "notes.txt" in done.stderr
    assert "Helper.cpp" in done.stderr
    found = contents(tmp_path / "mine.zip")
    assert found == {f"work/{name}": text.encode() for name, text in worked.items()}


def test_an_export_looks_through_links(
    contact: Run, work: Path, worked: dict[str, str], tmp_path: Path
) -> None:
    (work / "02_triangles").rename(tmp_path / "elsewhere")
    (work / "02_triangles").symlink_to(tmp_path / "elsewhere")
    (tmp_path / "elsewhere/again").symlink_to(tmp_path / "elsewhere")
    assert contact("export", "mine.zip").returncode == 0
    assert sorted(contents(tmp_path / "mine.zip")) == sorted(f"work/{name}" for name in worked)


def test_the_name_has_the_date(contact: Run, worked: dict[str, str], tmp_path: Path) -> None:
    assert contact("export").returncode == 0
    (file,) = tmp_path.glob("*.zip")
    assert re.fullmatch(r"contact-work-\d{4}-\d\d-\d\d\.zip", file.name)


def test_an_export_never_overwrites(contact: Run, worked: dict[str, str], tmp_path: Path) -> None:
    file = tmp_path / "mine.zip"
    file.write_text("something dear")
    done = contact("export", "mine.zip")
    assert done.returncode == 3
    assert "mine.zip is there already" in done.stderr
    assert file.read_text() == "something dear"
    for number in (1, 2):
        before = file.read_bytes()
        done = contact("export", "mine.zip", "--force")
        assert done.returncode == 0
        assert f"mine.old-{number}.zip" in done.stdout
        assert (tmp_path / f"mine.old-{number}.zip").read_bytes() == before
        assert "work/progress.json" in contents(file)


def test_an_export_of_some(
    contact: Run, work: Path, worked: dict[str, str], tmp_path: Path
) -> None:
    record = {RAY: {"attempts": 2}, PLANE: {"attempts": 5}}
    (work / "progress.json").write_text(progress(record, questions={"q": 1}))
    done = contact("export", "some.zip", "ray_triangle", "02_triangles", "--json")
    assert done.returncode == 0
    document = json.loads(done.stdout)
    assert document["format"] == "contact-export/1"
    assert document["exercises"] == [RAY]
    found = contents(tmp_path / "some.zip")
    assert sorted(found) == [f"work/{RAY}.cpp", "work/progress.json"]
    assert json.loads(found["work/progress.json"]) == json.loads(progress({RAY: record[RAY]}))


@pytest.mark.parametrize(
    ("words", "code", "sentence"),
    [
        ((), 1, "nothing to export"),
        (("ray_triangle",), 1, "have not started"),
        (("a.zip", "ray_triangel"), 2, "ray_triangle"),
        (("nowhere/a.zip",), 3, "no folder"),
    ],
)
def test_an_export_that_cannot_be(
    contact: Run, tmp_path: Path, words: tuple[str, ...], code: int, sentence: str
) -> None:
    done = contact("export", *words)
    assert done.returncode == code
    assert sentence in done.stderr
    assert list(tmp_path.rglob("*.zip")) == []


@pytest.mark.parametrize(
    ("content", "sentence"),
    [(b"\xff", "UTF-8"), (b"a\0b", "zero byte"), (b"x" * (MIB + 1), "1 MiB")],
)
def test_what_no_import_takes_is_not_exported(
    contact: Run, work: Path, tmp_path: Path, content: bytes, sentence: str
) -> None:
    put(work, {f"{RAY}.cpp": ""})
    (work / f"{RAY}.cpp").write_bytes(content)
    done = contact("export", "a.zip")
    assert done.returncode == 3
    assert f"work/{RAY}.cpp" in done.stderr
    assert sentence in done.stderr
    assert not (tmp_path / "a.zip").exists()


def test_the_same_work_gives_the_same_bytes(
    contact: Run, work: Path, worked: dict[str, str], tmp_path: Path
) -> None:
    contact("export", "a.zip", TZ="America/New_York")
    for name in reversed(worked):
        (work / name).unlink()
        put(work, {name: worked[name]})
        os.utime(work / name, (1_000_000_000, 1_000_000_000))
        (work / name).chmod(0o600)
    contact("export", "b.zip", TZ="Asia/Tokyo")

    def described(file: Path) -> list[tuple[Any, ...]]:
        with zipfile.ZipFile(file) as archive:
            return [
                (i.filename, i.date_time, i.extra, i.external_attr, i.CRC, i.compress_size)
                for i in archive.infolist()
                if i.filename != "contact-submission.json"
            ]

    found = described(tmp_path / "a.zip")
    assert found == described(tmp_path / "b.zip")
    assert [entry[0] for entry in found] == sorted(f"work/{name}" for name in worked)
    assert {entry[1] for entry in found} == {(1980, 1, 1, 0, 0, 0)}


def test_out_and_in_and_out_again_is_the_same(
    contact: Run, worked: dict[str, str], tmp_path: Path
) -> None:
    other = tmp_path / "other"
    assert contact("export", "a.zip").returncode == 0
    assert contact("import", "a.zip", CONTACT_WORK=str(other)).returncode == 0
    assert tree(other) == worked
    assert contact("export", "b.zip", CONTACT_WORK=str(other)).returncode == 0
    assert contents(tmp_path / "b.zip") == contents(tmp_path / "a.zip")


# --- import ---------------------------------------------------------------------------------------


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


# --- check ----------------------------------------------------------------------------------------


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


# --- What nobody may send -------------------------------------------------------------------------


def info(name: str, **members: object) -> zipfile.ZipInfo:
    made = zipfile.ZipInfo(name)
    for member, value in members.items():
        setattr(made, member, value)
    return made


def special(name: str, kind: int) -> zipfile.ZipInfo:
    return info(name, external_attr=(kind | 0o777) << 16, create_system=3)


def refused(contact: Run, work: Path, tmp_path: Path, file: Path, *sentences: str) -> None:
    """Holds that neither import nor check takes it, that one line says why, and that nothing at
    all was written."""
    put(work, {f"{RAY}.cpp": "// mine\n"})
    before = tree(tmp_path)
    for command in ("import", "check"):
        done = contact(command, file.name)
        assert done.returncode == 3, (command, done)
        assert done.stdout == ""
        (line,) = done.stderr.splitlines()
        assert file.name in line
        assert len(line) < 600
        assert line.isprintable()
        for sentence in sentences:
            assert sentence in line
    assert tree(tmp_path) == before


COPY = f"work/{RAY}.cpp"
COPY_NAME = r"\d\d_[a-z][a-z0-9_]*/[a-z][a-z0-9_]*\.cpp"


@pytest.mark.parametrize(
    "name",
    [
        "../evil.cpp",
        "../../../../../../../../tmp/evil.cpp",
        "work/../evil.cpp",
        "work/02_triangles/../../evil.cpp",
        "work/02_triangles/../02_triangles/ray_triangle.cpp",
        "/etc/evil.cpp",
        "/work/02_triangles/ray_triangle.cpp",
        "//work/02_triangles/ray_triangle.cpp",
        "./work/02_triangles/ray_triangle.cpp",
        "work//02_triangles/ray_triangle.cpp",
        "work/./02_triangles/ray_triangle.cpp",
        "C:/work/02_triangles/ray_triangle.cpp",
        "work\\02_triangles\\ray_triangle.cpp",
        "..\\evil.cpp",
        "work/02_triangles\\ray_triangle.cpp",
        "work/02_triangles/ray_triangle.cpp/more.cpp",
        "work/02_triangles/deeper/ray_triangle.cpp",
        "work/02_triangles/Ray_triangle.cpp",
        "work/02_triangles/ray_triangle.cpp ",
        "work/02_triangles/ray_triangle.hpp",
        "work/02_triangles/.cpp",
        "work/02_triangles/.hidden.cpp",
        "work/.kept/ray_triangle.cpp",
        "work/triangles/ray_triangle.cpp",
        "work/ray_triangle.cpp",
        "work/progress.json.broken-1",
        "work/PROGRESS.JSON",
        "work/02_triangles/rä.cpp",
        "work/02_triangles/ray\ntriangle.cpp",
        "work/02_triangles/\x1b[2Jray.cpp",
        "work/02_triangles/" + "a" * 120 + ".cpp",
        "work/02_triangles/" + "a" * 60000 + ".cpp",
        "notes/",
        "work/02_triangles/deeper/",
        "__MACOSX/._work",
        "contact-submission.json/",
    ],
)
@pytest.mark.parametrize("system", [0, 3])
def test_a_path_with_no_place_in_it(
    contact: Run, work: Path, tmp_path: Path, name: str, system: int
) -> None:
    entry = info("x", create_system=system)
    entry.filename = name  # as it is: the constructor would mend some
    pairs: list[tuple[str | zipfile.ZipInfo, str | bytes]] = [*of_page({PLANE: "int x;"}).items()]
    file = zipped(tmp_path / "a.zip", [*pairs, (entry, "" if name.endswith("/") else "int x;")])
    refused(contact, work, tmp_path, file, "has no place in it")


@pytest.mark.parametrize("place", ["extra", "directory"])
def test_an_entry_with_two_names(contact: Run, work: Path, tmp_path: Path, place: str) -> None:
    """Whoever unpacks it with another program may find another file."""
    name, other = COPY.encode(), f"work/{PLANE}.cpp".encode()
    two = {"extra": unicode_path(name, other)} if place == "extra" else {"central_name": other}
    file = tmp_path / "a.zip"
    manifest = Member(b"contact-submission.json", MANIFEST.encode())
    file.write_bytes(zip_bytes([manifest, Member(name, b"int x;", **two)]))  # type: ignore[arg-type]
    refused(contact, work, tmp_path, file, "has no place in it")
    file.write_bytes(zip_bytes([manifest, Member(name, b"int x;", extra=unicode_path(name, name))]))
    assert contact("import", str(file)).returncode == 0


@pytest.mark.parametrize(
    "kind", [stat.S_IFLNK, stat.S_IFCHR, stat.S_IFBLK, stat.S_IFSOCK, stat.S_IFDIR]
)
def test_links_devices_and_the_like(contact: Run, work: Path, tmp_path: Path, kind: int) -> None:
    pairs: list[tuple[str | zipfile.ZipInfo, str | bytes]] = [
        ("contact-submission.json", MANIFEST),
        (special(COPY, kind), "/etc/passwd"),
    ]
    file = zipped(tmp_path / "a.zip", pairs)
    refused(contact, work, tmp_path, file, COPY)


@pytest.mark.filterwarnings("ignore:Duplicate name")
@pytest.mark.parametrize("name", [COPY, "contact-submission.json", "work/progress.json"])
def test_the_same_path_twice(contact: Run, work: Path, tmp_path: Path, name: str) -> None:
    files = of_page({RAY: "int x;"}, progress({}))
    file = zipped(tmp_path / "a.zip", [*files.items(), (name, files[name])])
    refused(contact, work, tmp_path, file, name, "twice")


def test_folders_are_passed_over(contact: Run, work: Path, tmp_path: Path) -> None:
    pairs = [("work/", ""), ("work/02_triangles/", ""), *of_page({RAY: "int x;"}).items()]
    zipped(tmp_path / "a.zip", pairs)
    assert contact("import", "a.zip").returncode == 0
    assert tree(work) == {f"{RAY}.cpp": "int x;"}


def many(count: int, size: int) -> dict[str, str]:
    return {f"77_many/n{number}": "x" * size for number in range(count)}


@pytest.mark.parametrize(
    ("copies", "sentences"),
    [
        ({RAY: "x" * (MIB + 1)}, (COPY, "larger than 1 MiB")),
        ({RAY: "x" * (300 * MIB)}, (COPY, "larger than 1 MiB")),
        (many(20, MIB), ("more than 20 MiB",)),
        (many(1000, 1), ("more than 1000 entries",)),
    ],
)
def test_what_is_too_large(
    contact: Run, work: Path, tmp_path: Path, copies: dict[str, str], sentences: tuple[str, ...]
) -> None:
    file = zipped(tmp_path / "a.zip", of_page(copies))
    refused(contact, work, tmp_path, file, *sentences)


@pytest.mark.parametrize("copies", [many(1, MIB), many(19, MIB), many(999, 1)])
def test_what_is_just_not_too_large(
    contact: Run, work: Path, tmp_path: Path, copies: dict[str, str]
) -> None:
    zipped(tmp_path / "a.zip", of_page(copies))
    assert contact("import", "a.zip").returncode == 0
    assert tree(work) == {f"{name}.cpp": text for name, text in copies.items()}
    assert contact("export", "b.zip").returncode == 0


def test_an_archive_that_is_itself_too_large(contact: Run, work: Path, tmp_path: Path) -> None:
    file = tmp_path / "a.zip"
    with file.open("wb") as opened:
        opened.write(b"PK\x03\x04")
        opened.truncate(24 * MIB + 1)
    done = contact("import", "a.zip")
    assert done.returncode == 3
    assert "24 MiB" in done.stderr
    assert not work.exists()


def test_a_bomb_that_lies_about_its_size(contact: Run, work: Path, tmp_path: Path) -> None:
    file = zipped(tmp_path / "a.zip", of_page({RAY: "x" * (64 * MIB)}))
    size = (64 * MIB).to_bytes(4, "little")
    bomb = file.read_bytes()
    assert bomb.count(size) == 2  # in the entry's own header and in the directory
    file.write_bytes(bomb.replace(size, (100).to_bytes(4, "little")))
    refused(contact, work, tmp_path, file, COPY)


def test_many_entries_on_the_same_bytes(contact: Run, work: Path, tmp_path: Path) -> None:
    """The directory names one entry's bytes again and again: a small file unpacks to much."""
    file = zipped(tmp_path / "a.zip", of_page(many(1, MIB)))
    bomb = file.read_bytes()
    begin = bomb.index(b"PK\x01\x02", bomb.index(b"PK\x01\x02") + 1)
    end = bomb.index(b"PK\x05\x06")
    entry = bomb[begin:end]
    entries = b"".join(
        entry.replace(b"n0.cpp", f"m{i}.cpp".encode()) for i in range(10)
    ) + b"".join(entry.replace(b"77_many/n0", f"77_man/n{i}".encode()) for i in range(10, 40))
    tail = bytearray(bomb[end:])
    tail[8:12] = (42).to_bytes(2, "little") * 2
    tail[12:16] = (end - bomb.index(b"PK\x01\x02") + len(entries)).to_bytes(4, "little")
    file.write_bytes(bomb[:end] + entries + bytes(tail))
    done = contact("import", "a.zip")
    assert done.returncode in (0, 3)
    assert sum(file.stat().st_size for file in work.rglob("*.cpp")) <= 20 * MIB


def test_encryption(contact: Run, work: Path, tmp_path: Path) -> None:
    file = zipped(tmp_path / "a.zip", of_page({RAY: "int x;"}))
    data = bytearray(file.read_bytes())
    for mark, at in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        data[data.rindex(mark) + at] |= 1
    file.write_bytes(data)
    refused(contact, work, tmp_path, file, COPY, "encrypted")


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_rare_compression(contact: Run, work: Path, tmp_path: Path, method: int) -> None:
    file = tmp_path / "a.zip"
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("contact-submission.json", MANIFEST)
        archive.writestr(COPY, "int x;" * 100, compress_type=method)
    refused(contact, work, tmp_path, file, COPY, "compressed in a way")


def test_stored_entries_are_read(contact: Run, work: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "a.zip", "w") as archive:
        for name, text in of_page({RAY: "int x;"}).items():
            archive.writestr(name, text)
    assert contact("import", "a.zip").returncode == 0
    assert tree(work) == {f"{RAY}.cpp": "int x;"}


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (b"", "empty"),
        (b"hello\n", "no zip file"),
        (b"\x89PNG\r\n\x1a\n", "no zip file"),
        (b"PK", "no zip file"),
        (b"PK\x03\x04", "missing"),
        (b"PK\x05\x06" + bytes(18), "a.zip"),
        (b"\x1f\x8b", "a.zip"),
        (b"\x1f\x8b" + bytes(100), "a.zip"),
    ],
)
def test_what_is_no_archive(
    contact: Run, work: Path, tmp_path: Path, content: bytes, sentence: str
) -> None:
    file = tmp_path / "a.zip"
    file.write_bytes(content)
    refused(contact, work, tmp_path, file, sentence)


def test_a_folder_is_no_archive(contact: Run, work: Path, tmp_path: Path) -> None:
    (tmp_path / "a.zip").mkdir()
    refused(contact, work, tmp_path, tmp_path / "a.zip", "not a file")


def test_a_truncated_archive(contact: Run, work: Path, tmp_path: Path) -> None:
    whole = zipped(tmp_path / "whole.zip", of_page({RAY: STUB, PLANE: STUB_OF_PLANE})).read_bytes()
    (tmp_path / "whole.zip").unlink()
    # Also just before the directory, where every entry is still whole.
    for length in (
        30,
        len(whole) // 2,
        whole.index(b"PK\x01\x02"),
        len(whole) - 22,
        len(whole) - 1,
    ):
        file = tmp_path / "a.zip"
        file.write_bytes(whole[:length])
        refused(contact, work, tmp_path, file)


def test_flipped_bits(contact: Run, work: Path, tmp_path: Path) -> None:
    """Whatever bytes come: either the archive is taken, or it is refused and nothing is written."""
    rng = random.Random(20261121)
    whole = zipped(tmp_path / "a.zip", of_page({RAY: STUB}, progress({RAY: {}}))).read_bytes()
    outcomes = set()
    for _ in range(150):
        data = bytearray(whole)
        for _ in range(rng.choice((1, 1, 3))):
            data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)
        (tmp_path / "a.zip").write_bytes(data)
        done = contact("import", "a.zip")
        assert done.returncode in (0, 3), done
        if done.returncode == 3:
            assert not work.exists(), done
        else:
            # No checksum covers a name, so a flipped bit may make another exercise's of it.
            for name in tree(work):
                assert name == "progress.json" or re.fullmatch(COPY_NAME, name)
            shutil.rmtree(work)
        outcomes.add(done.returncode)
    assert outcomes == {0, 3}


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (b"int x; // \xff\xfe", "UTF-8"),
        (b"\xc0\xaf", "UTF-8"),
        (b"\xed\xa0\x80", "UTF-8"),
        (b"\xf4\x90\x80\x80", "UTF-8"),
        (b"// \xe2\x82", "UTF-8"),
        ("int x;".encode("utf-16"), "UTF-8"),
        (b"int x;\0", "zero byte"),
    ],
)
def test_a_copy_that_is_no_text(
    contact: Run, work: Path, tmp_path: Path, content: bytes, sentence: str
) -> None:
    file = zipped(tmp_path / "a.zip", of_page({RAY: content}))
    refused(contact, work, tmp_path, file, COPY, sentence)


def test_any_text_in_utf8_is_taken(contact: Run, work: Path, tmp_path: Path) -> None:
    text = "\ufeff// α ü 日本 \U0001f600 \ud7ff\ue000\U0010ffff\r\n\t no newline at the end"
    zipped(tmp_path / "a.zip", of_page({RAY: text.encode()}))
    assert contact("import", "a.zip").returncode == 0
    assert (work / f"{RAY}.cpp").read_bytes() == text.encode()


@pytest.mark.parametrize(
    ("files", "sentence"),
    [
        ({COPY: "int x;"}, "has no contact-submission.json"),
        ({"contact-submission.json": "{"}, "not JSON"),
        ({"contact-submission.json": "[]"}, "does not say"),
        ({"contact-submission.json": '{"format": 1}'}, "does not say"),
        ({"contact-submission.json": '{"format": "contact-submission/2"}'}, "another format"),
        ({"contact-submission.json": "[" * 500_000}, "nested"),
        (of_page({}, "{"), "not JSON"),
        (of_page({}, "[]"), "no record of progress"),
        (of_page({}, '{"format": "contact-progress/2", "exercises": {}}'), "no record"),
        (of_page({}, progress({"\x1b[31m\nx": 1})), "no record of progress"),
        (of_page({}, progress({RAY: {"tests": []}})), "no record of progress"),
        (of_page({}, '{"a":' * 100_000), "nested"),
        (of_page({}, progress({RAY: {"x": [[[]]] * 3}}).replace("[[[", "[" * 40)), "nested"),
    ],
)
def test_an_archive_whose_own_files_are_wrong(
    contact: Run, work: Path, tmp_path: Path, files: Files, sentence: str
) -> None:
    file = zipped(tmp_path / "a.zip", files)
    refused(contact, work, tmp_path, file, sentence)


# --- tar.gz ---------------------------------------------------------------------------------------


def tarred(file: Path, files: Files, *more: tarfile.TarInfo, mode: str = "gz") -> Path:
    with tarfile.open(str(file), f"w:{mode}") as archive:  # type: ignore[call-overload]
        for name, content in files.items():
            data = content.encode() if isinstance(content, str) else content
            member = tarfile.TarInfo(name)
            member.size = len(data)
            archive.addfile(member, io.BytesIO(data))
        for member in more:
            archive.addfile(member)
    return file


def test_a_tar_with_gzip_is_read_too(
    contact: Run, solution: str, work: Path, tmp_path: Path
) -> None:
    tarred(tmp_path / "a.tar.gz", of_page({RAY: solution}, progress({RAY: {"attempts": 1}})))
    assert contact("check", "a.tar.gz").returncode == 0
    assert contact("import", "a.tar.gz").returncode == 0
    assert (work / f"{RAY}.cpp").read_text() == solution


@pytest.mark.parametrize(
    "kind",
    [tarfile.SYMTYPE, tarfile.LNKTYPE, tarfile.CHRTYPE, tarfile.BLKTYPE, tarfile.FIFOTYPE],
)
def test_links_and_devices_of_a_tar(contact: Run, work: Path, tmp_path: Path, kind: bytes) -> None:
    member = tarfile.TarInfo(COPY)
    member.type = kind
    member.linkname = "contact-submission.json" if kind == tarfile.LNKTYPE else "/etc/passwd"
    file = tarred(tmp_path / "a.tar.gz", {"contact-submission.json": MANIFEST}, member)
    refused(contact, work, tmp_path, file, COPY, "link or a device")


@pytest.mark.parametrize("name", ["/etc/evil.cpp", "../evil.cpp", "work/../../evil.cpp"])
def test_paths_of_a_tar(contact: Run, work: Path, tmp_path: Path, name: str) -> None:
    file = tarred(tmp_path / "a.tar.gz", of_page({}) | {name: "int x;"})
    refused(contact, work, tmp_path, file, "has no place in it")


def test_a_tar_that_is_cut_off_or_wrapped_otherwise(
    contact: Run, work: Path, tmp_path: Path
) -> None:
    file = tarred(tmp_path / "a.tar.gz", of_page({RAY: STUB}))
    whole = file.read_bytes()
    file.write_bytes(whole[: len(whole) // 2])
    refused(contact, work, tmp_path, file)
    subprocess.run(["gzip", "-f", file], check=True)
    (tmp_path / "a.tar.gz.gz").rename(file)
    refused(contact, work, tmp_path, file)
    refused(contact, work, tmp_path, tarred(file, of_page({RAY: STUB}), mode=""), "no zip file")
    refused(contact, work, tmp_path, tarred(file, of_page({RAY: STUB}), mode="xz"), "no zip file")


def test_a_tar_that_is_too_large(contact: Run, work: Path, tmp_path: Path) -> None:
    file = tarred(tmp_path / "a.tar.gz", of_page({RAY: bytes(300 * MIB)}))
    refused(contact, work, tmp_path, file, COPY, "larger than 1 MiB")


# --- The page's own code --------------------------------------------------------------------------

PAGE = """
import { readFileSync, writeFileSync } from "node:fs";
const { load } = await import(process.argv[2]);
const { exportWork, importWork } = await load("archive.ts");
const { WorkStore } = await load("work.ts");
const [from, to, code] = process.argv.slice(3);
const store = new WorkStore(undefined);
for (const [id, text] of Object.entries(JSON.parse(code))) store.save(id, text, "");
let imported = null;
if (from) imported = importWork(readFileSync(from), store);
if (to) writeFileSync(to, exportWork(store));
const texts = Object.fromEntries(store.ids().map((id) => [id, store.code(id).text]));
console.log(JSON.stringify({ imported, texts, progress: store.progress() }));
"""
MERGE = """
import { readFileSync } from "node:fs";
const { load } = await import(process.argv[2]);
const { mergeProgress } = await load("archive.ts");
const [ours, theirs] = process.argv.slice(3).map((file) => JSON.parse(readFileSync(file)));
console.log(JSON.stringify(mergeProgress(ours, theirs)));
"""


needs_page = pytest.mark.skipif(
    not (ROOT / "page/node_modules/esbuild").exists(),
    reason="the page's packages are not installed",
)


def in_node(folder: Path, script: str, *words: str) -> dict[str, Any]:
    (folder / "page.mjs").write_text(script)
    load = str(ROOT / "page/web/test/load.mjs")
    command = ["node", "page.mjs", load, *words]
    done = subprocess.run(command, capture_output=True, text=True, cwd=folder, check=True)
    found: dict[str, Any] = json.loads(done.stdout)
    return found


@needs_page
def test_the_page_and_the_program_take_each_others_archives(
    contact: Run, work: Path, worked: dict[str, str], tmp_path: Path
) -> None:
    def page(file: str, to: str, code: Mapping[str, str]) -> dict[str, Any]:
        return in_node(tmp_path, PAGE, file, to, json.dumps(code))

    assert contact("export", "ours.zip").returncode == 0
    there = page("ours.zip", "theirs.zip", {"01_planes/segment_plane": "// begun in the page\n"})
    assert there["imported"]["ignored"] == []
    copies = {name.removesuffix(".cpp"): t for name, t in worked.items() if name.endswith(".cpp")}
    assert there["texts"] == copies | {"01_planes/segment_plane": "// begun in the page\n"}
    assert there["progress"] == json.loads(worked["progress.json"])
    done = json.loads(contact("import", "theirs.zip", "--json").stdout)
    assert done["from"] == "page"
    assert {r["exercise"]: r["status"] for r in done["results"]} == {
        **dict.fromkeys(copies, "same"),
        "01_planes/segment_plane": "new",
    }
    assert tree(work) == worked | {"01_planes/segment_plane.cpp": "// begun in the page\n"}


def random_entry(rng: random.Random) -> dict[str, object]:
    """An entry as either may write it, with some members missing."""
    times = [f"2026-01-0{day}T00:00:00Z" for day in range(1, 5)]
    members: dict[str, object] = {
        "attempts": rng.randrange(5),
        "best_points": rng.randrange(9) / 2,
        "max_points": rng.choice((4.0, 5.0)),
        "passed": rng.choice(times),
        "last_checked": rng.choice(times),
        "hints_shown": rng.randrange(4),
        "solution_shown": rng.random() < 0.5,
        "tests": {"a": rng.choice(("passed", "failed"))},
        "unknown": rng.randrange(3),
    }
    return {name: value for name, value in members.items() if rng.random() < 0.8}


@needs_page
def test_the_page_and_the_program_merge_alike(contact: Run, work: Path, tmp_path: Path) -> None:
    rng = random.Random(20261121)
    ids = [f"77_many/n{number}" for number in range(300)]
    ours, theirs = (
        progress({name: random_entry(rng) for name in ids if rng.random() < 0.8}, both=number)
        for number in (1, 2)
    )
    put(work, {"progress.json": ours})
    put(tmp_path, {"ours.json": ours, "theirs.json": theirs})
    zipped(tmp_path / "a.zip", of_page({}, theirs))
    assert contact("import", "a.zip").returncode == 0
    merged = json.loads((work / "progress.json").read_text())
    assert merged == in_node(tmp_path, MERGE, "ours.json", "theirs.json")
