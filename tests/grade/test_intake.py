"""Submissions as learning systems, students and attackers pack them: the student, the exercise of
each file, and the message of each refusal.

Most files are as the book gives them: that they were found shows as "untouched", and costs nothing.
"""

from __future__ import annotations

import io
import json
import os
import shutil
import stat
import sys
import tarfile
import zipfile
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from graded_class import EXERCISE, ROOT, STUB, Document, Grader

NAME = "signed_distance.cpp"
PLACE = f"{EXERCISE}.cpp"
SPHERE = "01_planes/sphere_plane"
SPHERE_STUB = (ROOT / f"exercises/{SPHERE}/sphere_plane.cpp").read_text()
MIB = 1 << 20


def zipped(file: Path, files: Mapping[str, str | bytes]) -> None:
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(name, text)


def tarred(file: Path, files: Mapping[str, str | bytes], *more: tarfile.TarInfo) -> None:
    with tarfile.open(file, "w:gz") as archive:
        for name, text in files.items():
            content = text.encode() if isinstance(text, str) else text
            member = tarfile.TarInfo(name)
            member.size = len(content)
            archive.addfile(member, io.BytesIO(content))
        for member in more:
            archive.addfile(member)


def link(name: str, target: str, kind: bytes) -> tarfile.TarInfo:
    member = tarfile.TarInfo(name)
    member.type = kind
    member.linkname = target
    return member


def written(folder: Path, files: Mapping[str, str | bytes]) -> None:
    for name, text in files.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(text.encode() if isinstance(text, str) else text)


# Found: the entry's name, what makes it, and the id and the name that its student gets.
Make = Callable[[Path], None]


def as_zip(files: Mapping[str, str | bytes]) -> Make:
    return lambda path: zipped(path, files)


def as_tar(files: Mapping[str, str | bytes]) -> Make:
    return lambda path: tarred(path, files)


def as_folder(files: Mapping[str, str | bytes]) -> Make:
    return lambda path: written(path, files)


def as_file(path: Path) -> None:
    path.write_text(STUB)


def whole_book(path: Path) -> None:
    """The repository itself, in which the student works as the book says."""
    for name in (f"exercises/{EXERCISE}", f"solutions/{EXERCISE}"):
        shutil.copytree(ROOT / name, path / name)
    written(path, {f"work/{PLACE}": STUB, "README.md": "x", ".git/config": "x"})


EXPORTED = {
    "contact-submission.json": json.dumps(
        {"format": "contact-submission/1", "exported": "2026-02-03T04:05:06Z", "from": "page"}
    ),
    "work/progress.json": json.dumps({"format": "contact-progress/1", "exercises": {}}),
    f"work/{PLACE}": STUB,
}

FOUND: dict[str, tuple[Make, str, str]] = {
    "plain": (as_folder({PLACE: STUB}), "plain", ""),
    "deep": (as_folder({f"a/b c/ü/{PLACE}": STUB}), "deep", ""),
    "by_name": (as_folder({f"homework 3/{NAME}": STUB}), "by_name", ""),
    "zip.zip": (as_zip({PLACE: STUB}), "zip", ""),
    "nested.zip": (
        as_zip(
            {
                "nested/": "",
                f"nested/{PLACE}": STUB,
                f"__MACOSX/nested/01_planes/._{NAME}": b"\0\5\x16\7",
                "nested/.DS_Store": b"\0",
            }
        ),
        "nested",
        "",
    ),
    "Upper.ZIP": (as_zip({NAME: STUB}), "Upper", ""),
    "tar.tar.gz": (as_tar({f"./{PLACE}": STUB}), "tar", ""),
    "tgz.tgz": (as_tar({f"top/{PLACE}": STUB}), "tgz", ""),
    "exported.zip": (as_zip(EXPORTED), "exported", ""),
    "whole_book": (whole_book, "whole_book", ""),
    "Zoë Łukasz": (as_folder({PLACE: STUB}), "Zo~C3~AB~20~C5~81ukasz", "Zoë Łukasz"),
    "-1+cmd": (as_folder({PLACE: STUB}), "~2D1+cmd", "-1+cmd"),
    "Ada Lovelace_12345_assignsubmission_file_": (as_folder({NAME: STUB}), "12345", "Ada Lovelace"),
    "Ada Lovelace_12346_assignsubmission_file": (as_folder({NAME: STUB}), "12346", "Ada Lovelace"),
    f"Bo Li_12347_assignsubmission_file_{NAME}": (as_file, "12347", "Bo Li"),
    # The name of a file cannot assign it to another student.
    "Mal_666_assignsubmission_file_x_12345_assignsubmission_file.zip": (
        as_zip({NAME: STUB}),
        "666",
        "Mal",
    ),
    f"hopper_2001_30001_{NAME}": (as_file, "2001", "hopper"),
    f"turing_LATE_2002_30002_{NAME}": (as_file, "2002", "turing"),
    "noether_2003_30003_signed_distance-2.cpp": (as_file, "2003", "noether"),
    "gauss_2004_30004_my work.zip": (as_zip({PLACE: STUB}), "2004", "gauss"),
    "kepler_signed_distance.cpp": (as_file, "kepler", ""),
    "de-la-cruz-signed_distance.cpp": (as_file, "de-la-cruz", ""),
    # No learning system's: two numbers, but in the name of a folder.
    "lab_101_102_ada": (as_folder({NAME: STUB}), "lab_101_102_ada", ""),
}

TWO = "two files answer to it, "

# The entry's name, what makes it, and words of the sentence with which the exercise is refused.
FILES_REFUSED: dict[str, tuple[Make, str]] = {
    "two_places": (
        as_folder({f"a/{PLACE}": STUB, f"b/{PLACE}": STUB}),
        TWO + "'a/",
    ),
    "two_ways.zip": (as_zip({NAME: STUB, PLACE: STUB}), TWO),
    "latin": (as_folder({NAME: "// für\n".encode("latin-1")}), "is not text in UTF-8"),
    "zero.zip": (as_zip({NAME: b"int x;\0"}), "it has a zero byte"),
    "large": (as_folder({NAME: b"/" * (MIB + 1)}), "is larger than 1 MiB"),
    "large_in_tar.tgz": (as_tar({NAME: b"/" * (MIB + 1)}), "is larger than 1 MiB"),
}


def link_in_folder(path: Path) -> None:
    path.mkdir()
    (path / NAME).symlink_to("/etc/passwd")


def linked_folder(path: Path) -> None:
    path.mkdir()
    (path / "01_planes").symlink_to(ROOT / "solutions/01_planes/signed_distance")


def hard_link(path: Path) -> None:
    path.mkdir()
    (path.parent.parent / "somewhere").write_text(STUB)
    os.link(path.parent.parent / "somewhere", path / NAME)


def pipe(path: Path) -> None:
    path.mkdir()
    os.mkfifo(path / NAME)


def link_to_all(path: Path) -> None:
    path.symlink_to(ROOT / "solutions")


def link_in_zip(path: Path) -> None:
    entry = zipfile.ZipInfo(NAME)
    entry.create_system = 3
    entry.external_attr = (stat.S_IFLNK | 0o777) << 16
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr(entry, "/etc/passwd")


def many(path: Path) -> None:
    written(path, {f"{i}.txt": "" for i in range(1001)})


def bytes_of(content: bytes) -> Make:
    def make(path: Path) -> None:
        path.write_bytes(content)

    return make


BOMB: dict[str, str | bytes] = {NAME: STUB, "zeros": bytes(21 * MIB)}
REFUSED: dict[str, tuple[Make, str]] = {
    "link_in_folder": (link_in_folder, f"'{NAME}' is a link or a device"),
    "linked_folder": (linked_folder, "'01_planes' is a link or a device"),
    "hard_link": (hard_link, f"'{NAME}' is a hard link"),
    "pipe": (pipe, f"'{NAME}' is a link or a device"),
    "link_to_all": (link_to_all, "'link_to_all' is a link"),
    "link_in_zip.zip": (link_in_zip, f"'{NAME}' is a link or a device"),
    "link_in_tar.tgz": (
        lambda path: tarred(path, {}, link(NAME, "/etc/passwd", tarfile.SYMTYPE)),
        "is a link or a device",
    ),
    "hard_link_in_tar.tgz": (
        lambda path: tarred(path, {"x": ""}, link(NAME, "x", tarfile.LNKTYPE)),
        "is a link or a device",
    ),
    "device_in_tar.tgz": (
        lambda path: tarred(path, {}, link(NAME, "", tarfile.CHRTYPE)),
        "is a link or a device",
    ),
    "outside.zip": (as_zip({f"../{PLACE}": STUB}), f"'../{PLACE}' would lie outside"),
    "inside_out.tgz": (as_tar({f"a/../../{PLACE}": STUB}), "would lie outside"),
    "absolute.tgz": (as_tar({f"/{PLACE}": STUB}), "would lie outside"),
    "drive.zip": (as_zip({f"C:/{PLACE}": STUB}), "would lie outside"),
    "twice.tgz": (
        lambda path: tarred(path, {NAME: STUB, f"./{NAME}": STUB}),
        f"'{NAME}' is in it twice",
    ),
    "bomb.zip": (as_zip({NAME: STUB, "zeros": bytes(21 * MIB)}), "unpacks to more than 20 MiB"),
    "bomb_in_tar.tgz": (
        as_tar({NAME: STUB, "zeros": bytes(21 * MIB)}),
        "unpacks to more than 20 MiB",
    ),
    "many": (many, "more than 1000 entries"),
    "many_in_zip.zip": (as_zip({f"{i}.txt": "" for i in range(1001)}), "more than 1000 entries"),
    "deep_down": (as_folder({"d/" * 40 + NAME: STUB}), "more than 32 deep"),
    "broken.zip": (bytes_of(b"PK\3\4" + bytes(100)), "cannot be used"),
    "empty.zip": (bytes_of(b""), "it is empty"),
    "no_zip.zip": (bytes_of(b"Rar!" + bytes(100)), "it is no zip file"),
    "work.rar": (bytes_of(b"Rar!"), "'work.rar' is nothing that is read here"),
    "answer.c": (bytes_of(b"int x;"), "is nothing that is read here"),
    "again.zip": (as_zip({"inner.zip": b"PK"}), "'inner.zip', which is not opened: unpack it"),
    "which.cpp": (bytes_of(b"int x;"), "does not say for which exercise it is"),
    NAME: (as_file, "does not say whose it is"),
    "Same": (as_folder({NAME: STUB}), "'Same' and 'same.zip' are of one student"),
    "same.zip": (as_zip({NAME: STUB}), "'Same' and 'same.zip' are of one student"),
}


@pytest.fixture(scope="module")
def taken(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Grader]:
    grader = Grader(tmp_path_factory.mktemp("intake") / "class")
    for name, (make, _, _) in FOUND.items():
        make(grader.submissions / name)
    for entries in (FILES_REFUSED, REFUSED):
        for name, (make, _) in entries.items():
            make(grader.submissions / name)
    # Two files of one student, each exported by itself.
    for name, text in ((NAME, STUB), ("sphere_plane.cpp", SPHERE_STUB)):
        (grader.submissions / f"curie_2005_3000{len(name)}_{name}").write_text(text)
        (grader.submissions / f"M Curie_777_assignsubmission_file_{name}").write_text(text)
        (grader.submissions / f"marie_{name}").write_text(text)
    written(grader.submissions / "extra", {NAME: STUB, "notes.txt": "x", "src/helper.cpp": "x"})
    (grader.submissions / os.fsdecode(b"\xff\xfe")).mkdir()
    # What systems add.
    written(grader.submissions, {".DS_Store": "x", "__MACOSX/x": "", "submission_metadata.yml": ""})
    done = grader.run("--json", exercises="signed_distance,sphere_plane")
    assert done.returncode == 1, done.stderr
    assert "Ignored, because they are not submissions: submission_metadata.yml" in done.stderr
    yield grader
    grader.clean()


def entry(grader: Grader, name: str) -> Document:
    entries: list[Document] = grader.document()["submissions"]
    found = [submission for submission in entries if submission["entry"] == name]
    assert len(found) == 1, name
    return found[0]


def statuses(submission: Document) -> dict[str, str]:
    return {unit["id"]: unit["status"] for unit in submission["exercises"]}


@pytest.mark.parametrize("name", FOUND)
def test_found(taken: Grader, name: str) -> None:
    submission = entry(taken, name)
    assert "problem" not in submission, submission["problem"]
    assert submission["id"] == FOUND[name][1]
    assert submission.get("name", "") == FOUND[name][2]
    assert statuses(submission) == {EXERCISE: "untouched", SPHERE: "missing"}
    kept = taken.results / f".grade/submissions/{submission['id']}/{PLACE}"
    assert kept.read_text() == STUB


@pytest.mark.parametrize("name", FILES_REFUSED)
def test_a_file_is_refused(taken: Grader, name: str) -> None:
    submission = entry(taken, name)
    assert "problem" not in submission
    assert statuses(submission) == {EXERCISE: "refused", SPHERE: "missing"}
    assert FILES_REFUSED[name][1] in submission["exercises"][0]["problem"]
    assert submission["points"] == 0


@pytest.mark.parametrize("name", REFUSED)
def test_a_submission_is_refused_whole(taken: Grader, name: str) -> None:
    submission = entry(taken, name)
    assert REFUSED[name][1] in submission["problem"]
    assert submission["exercises"] == []
    assert not (taken.results / f".grade/submissions/{submission['id']}").exists()


def test_files_that_were_exported_one_by_one_are_one_submission(taken: Grader) -> None:
    for id_, name in (("2005", "curie"), ("777", "M Curie"), ("marie", "")):
        submission = taken.submission(id_)
        assert "problem" not in submission
        assert submission.get("name", "") == name
        assert statuses(submission) == {EXERCISE: "untouched", SPHERE: "untouched"}
        assert submission["entry"].count(", ") == 1


def test_what_answers_to_no_exercise_is_named(taken: Grader) -> None:
    assert taken.submission("extra")["ignored"] == ["notes.txt", "src/helper.cpp"]
    for name in ("exported.zip", "nested.zip", "whole_book"):
        ignored = entry(taken, name)["ignored"]
        assert not [
            path for path in ignored if "MACOSX" in path or "progress" in path or ".git" in path
        ]


def test_a_name_that_is_no_text_is_shown_escaped(taken: Grader) -> None:
    submission = entry(taken, r"\xff\xfe")
    assert submission["id"] == "~FF~FE"
    assert "problem" not in submission
    assert statuses(submission) == {EXERCISE: "missing", SPHERE: "missing"}


def test_ids_are_unique_whatever_the_case_of_letters(taken: Grader) -> None:
    ids = [submission["id"].lower() for submission in taken.document()["submissions"]]
    assert len(ids) == len(set(ids))
    assert {"same~~1", "same~~2"} <= set(ids)


def test_one_exercise_alone_takes_a_file_by_any_name(grader: Grader) -> None:
    (grader.submissions / "ada.cpp").write_text(STUB)
    (grader.submissions / "hopper_2001_30001_final version.cpp").write_text(STUB)
    grader.grade()
    assert statuses(grader.submission("ada")) == {EXERCISE: "untouched"}
    assert statuses(grader.submission("2001")) == {EXERCISE: "untouched"}


# --- Tables of ids --------------------------------------------------------------------------------


def test_a_table_says_who_is_who(grader: Grader) -> None:
    for name in ("group 1", "group 2", "nobody"):
        written(grader.submissions / name, {NAME: STUB})
    zipped(grader.submissions / "late.zip", {NAME: STUB})
    (grader.submissions / NAME).write_text(STUB)
    table = grader.folder / "ids.csv"
    table.write_bytes(
        b"\xef\xbb\xbf"
        + "Name,ID,Entry,e-mail\r\n"
        '"Lovelace, ""Ada""",s1,group 1,a@b\r\n'
        "\r\n"
        '"two\nlines",s2,"group 2",\r\n'
        ",s3,late,\r\n"
        f"Kay,s4,{NAME},\r\n"
        "Ghost,s5,gone,".encode()
    )
    done = grader.run("--ids", str(table))
    assert done.returncode == 1
    assert "Named in " in done.stderr
    assert "ids.csv and not there: gone" in done.stderr
    names = {e["id"]: e.get("name") for e in grader.document()["submissions"]}
    assert names == {
        "s1": 'Lovelace, "Ada"',
        "s2": "two\nlines",
        "s3": None,
        "s4": "Kay",
        "nobody": None,
    }
    assert "'nobody' is not in ids.csv: add a line for it" in grader.submission("nobody")["problem"]
    for id_ in ("s1", "s2", "s3", "s4"):
        assert statuses(grader.submission(id_)) == {EXERCISE: "untouched"}


def test_two_entries_of_one_student_in_a_table_are_refused_both(grader: Grader) -> None:
    for name in ("one", "two", "three"):
        written(grader.submissions / name, {NAME: STUB})
    table = grader.folder / "ids.csv"
    table.write_text("entry,id\none,s1\ntwo,S1\nthree,s3\n")
    done = grader.run("--ids", str(table))
    assert done.returncode == 1
    problems = {e["entry"]: e.get("problem", "") for e in grader.document()["submissions"]}
    assert "'one' and 'two' are of one student" in problems["one"]
    assert "'one' and 'two' are of one student" in problems["two"]
    assert problems["three"] == ""


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "is empty: its first line must be entry,id,name"),
        ("entry;id\na;b\n", "columns are separated by commas, not by semicolons"),
        ("who,id\na,b\n", "ids.csv:1: the first line must name the columns entry and id"),
        ("entry,id,ID\na,b,c\n", "ids.csv:1: the column id is there twice"),
        ("entry,id\na\n", "ids.csv, record 2: it has 1 fields and the first line has 2"),
        ("entry,id\na,b,c\n", "ids.csv, record 2: it has 3 fields"),
        ("entry,id\na,b\na,c\n", "ids.csv, record 3: the entry 'a' is there twice"),
        ("entry,id\na,\n", "ids.csv, record 2: the id of 'a' is empty"),
        ("entry,id\n,b\n", "ids.csv, record 2: the entry is empty"),
        ('entry,id\na,"b\n', "ids.csv:2: a quoted field has no end"),
        ('entry,id\na,b"c\n', "ids.csv:2: a quotation mark stands inside a field"),
        ('entry,id\na,"b"c\n', "ids.csv:2: there is text after a quoted field"),
        ("entry,id\na,b\rc,d\n", "ids.csv:2: a line ends with a carriage return alone"),
        ("entry,id\nä,b\n", "is not text in UTF-8"),
    ],
)
def test_bad_tables(grader: Grader, text: str, says: str) -> None:
    grader.hand_in("a", STUB)
    table = grader.folder / "ids.csv"
    table.write_bytes(text.encode("latin-1"))
    done = grader.run("--ids", str(table))
    assert done.returncode == 3
    assert says in done.stderr
    assert not grader.results.exists()
