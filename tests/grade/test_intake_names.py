"""Names as students, their systems and learning systems write them: in six scripts, composed and
decomposed, in every encoding that archives have had. A name costs no mark unless it is dangerous,
and no name can manipulate a terminal or a report.
"""

from __future__ import annotations

import io
import os
import shutil
import subprocess
import sys
import tarfile
import unicodedata
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from graded_class import EXERCISE, SOLUTION, STUB, Grader
from zip_bytes import FAT, UTF8, Member, unicode_path, zip_bytes

NAME = "signed_distance.cpp"
PLACE = f"{EXERCISE}.cpp"
Form = Literal["NFC", "NFD"]

# Each has a letter that is written in two ways: as one character, or as a base and its mark.
SCRIPTS = {
    "latin": "Zoë Müller",
    "greek": "Άννα Παπαδοπούλου",
    "cyrillic": "Йоханна Ёлкина",
    "arabic": "آدم أحمد",
    "japanese": "ガブリエル 山田",
    "hangul": "김철수",
    "devanagari": "ऩमिता हिन्दी",
}
FORMS: tuple[Form, ...] = ("NFC", "NFD")

# A submission's files by their names in bytes, and what packs them: a path without its ending.
Files = Mapping[bytes, bytes]
Pack = Callable[[Path, Files], None]


def with_ending(path: Path, ending: str) -> Path:
    return path.with_name(path.name + ending)


def flagged_zip(path: Path, files: Files) -> None:
    members = [Member(name, text, UTF8) for name, text in files.items()]
    with_ending(path, ".zip").write_bytes(zip_bytes(members))


def plain_zip(path: Path, files: Files) -> None:
    """In UTF-8 without the flag that says so."""
    members = [Member(name, text) for name, text in files.items()]
    with_ending(path, ".zip").write_bytes(zip_bytes(members))


def large_zip(path: Path, files: Files) -> None:
    members = [Member(name, text, UTF8) for name, text in files.items()]
    with_ending(path, ".zip").write_bytes(zip_bytes(members, large=True))


def extra_zip(path: Path, files: Files) -> None:
    """The header has what ASCII has, an extra field the name."""
    members = []
    for name, text in files.items():
        raw = name.decode().encode("ascii", "replace")
        members.append(Member(raw, text, extra=unicode_path(raw, name)))
    with_ending(path, ".zip").write_bytes(zip_bytes(members))


def windows_zip(path: Path, files: Files) -> None:
    members = [
        Member(name.replace(b"/", b"\\"), text, UTF8, system=FAT, attributes=0)
        for name, text in files.items()
    ]
    with_ending(path, ".zip").write_bytes(zip_bytes(members))


def tar(form: int) -> Pack:
    def pack(path: Path, files: Files) -> None:
        with tarfile.open(with_ending(path, ".tar.gz"), "w:gz", format=form) as archive:
            for name, text in files.items():
                member = tarfile.TarInfo(os.fsdecode(name))
                member.size = len(text)
                archive.addfile(member, io.BytesIO(text))

    return pack


def folder(path: Path, files: Files) -> None:
    for name, text in files.items():
        file = Path(os.fsdecode(os.fsencode(path) + b"/" + name))
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(text)


def info_zip(path: Path, files: Files) -> None:
    """By the program `zip`, which writes the field 0x7075 or the flag, as its locale has it."""
    here = path.parent.parent / "to_zip" / path.name
    folder(here, files)
    subprocess.run(
        ["zip", "-qr", with_ending(path, ".zip"), "."],
        cwd=here,
        check=True,
        env={**os.environ, "LC_ALL": "C.UTF-8"},
    )


PACKS: dict[str, Pack] = {
    "flagged": flagged_zip,
    "plain": plain_zip,
    "large": large_zip,
    "extra": extra_zip,
    "windows": windows_zip,
    "pax": tar(tarfile.PAX_FORMAT),
    "gnu": tar(tarfile.GNU_FORMAT),
    "folder": folder,
    **({"zip": info_zip} if shutil.which("zip") else {}),
}


@dataclass(frozen=True)
class Handed:
    """A submission of the class, and what is to be read there."""

    id: str
    name: str
    make: Callable[[Path], None]
    ignored: tuple[str, ...] = ()
    answer: str = STUB

    @property
    def status(self) -> str:
        return "untouched" if self.answer == STUB else "graded"


def handed_in_scripts() -> Iterator[Handed]:
    for at, (script, name) in enumerate(SCRIPTS.items()):
        for form in FORMS:
            written = unicodedata.normalize(form, name)
            for by, pack in enumerate(PACKS.values()):
                id_ = f"{100 + at}{form == 'NFD':d}{by:02d}"
                # One of each kind is run too.
                answer = SOLUTION if (script, form) == ("latin", "NFD") else STUB
                files = {
                    f"{written}/{PLACE}".encode(): answer.encode(),
                    f"{written}/{written}.txt".encode(): b"x",
                }
                # Canvas gives the files of a class, Moodle folders or files.
                entry = (
                    f"{written.replace(' ', '')}_{id_}_9{id_}_{written}"
                    if by % 2 == 0 and pack != folder
                    else f"{written}_{id_}_assignsubmission_file_"
                )
                named = entry.split("_", maxsplit=1)[0]
                yield Handed(
                    id_,
                    named,
                    lambda path, pack=pack, entry=entry, files=files: pack(path / entry, files),  # type: ignore[misc]
                    (f"{written}/{written}.txt",),
                    answer,
                )


def by_bytes(entry: bytes, content: bytes | Files) -> Callable[[Path], None]:
    """An entry of the class whose own name is given in bytes."""

    def make(path: Path) -> None:
        place = Path(os.fsdecode(os.fsencode(path) + b"/" + entry))
        if isinstance(content, bytes):
            place.write_bytes(content)
        else:
            folder(place, content)

    return make


def zip_of(entry: str, *members: Member) -> Callable[[Path], None]:
    return by_bytes(entry.encode(), zip_bytes([*members, Member(PLACE.encode(), STUB.encode())]))


def many_ways(path: Path) -> None:
    """In one archive what differs only by composition: two names, and two files."""
    names = [unicodedata.normalize(form, "Müller.txt").encode() for form in FORMS]
    zip_of("two_forms.zip", *(Member(name, b"x", UTF8) for name in names))(path)


ANSWER = {PLACE.encode(): STUB.encode()}
LATIN_1 = "Müller".encode("latin-1")
CP437 = "Müller Ñandú.txt".encode("cp437")
LONG = "長" * 80  # 240 bytes

SINGLE = [
    Handed("cp437", "", zip_of("cp437.zip", Member(CP437)), ("Müller Ñandú.txt",)),
    Handed(
        "cp437_folder",
        "",
        by_bytes(
            b"cp437_folder.zip",
            zip_bytes(
                [
                    Member("Müller/".encode("cp437"), b"", system=FAT, attributes=0),
                    Member("Müller/".encode("cp437") + PLACE.encode(), STUB.encode(), system=FAT),
                ]
            ),
        ),
    ),
    Handed(
        "utf8_folder",
        "",
        zip_of("utf8_folder.zip", Member("Müller/".encode(), b"", UTF8, system=FAT, attributes=0)),
    ),
    Handed(
        "flag_lies",
        "",
        zip_of("flag_lies.zip", Member(LATIN_1 + b".txt", b"x", UTF8)),
        (r"M\xfcller.txt",),
    ),
    Handed(
        "old_extra",
        "",
        zip_of("old_extra.zip", Member(b"M?.txt", extra=unicode_path(b"?", "Mü.txt".encode()))),
        ("M?.txt",),
    ),
    Handed("two_forms", "", many_ways, ("Mu\u0308ller.txt", "M\u00fcller.txt")),
    Handed(
        "names_twice",
        "",
        zip_of("names_twice.zip", Member(b"x.txt"), Member(b"./x.txt")),
        ("x.txt", "x.txt"),
    ),
    Handed(
        "latin_1_in_folder",
        "",
        by_bytes(
            b"latin_1_in_folder",
            {LATIN_1 + b"/" + PLACE.encode(): STUB.encode(), LATIN_1 + b".txt": b""},
        ),
        (r"M\xfcller.txt",),
    ),
    Handed(
        "latin_1_in_tar",
        "",
        lambda path: tar(tarfile.GNU_FORMAT)(
            path / "latin_1_in_tar",
            {LATIN_1 + b"/" + PLACE.encode(): STUB.encode(), LATIN_1 + b".txt": b""},
        ),
        (r"M\xfcller.txt",),
    ),
    Handed("M~FCller", r"M\xfcller", by_bytes(LATIN_1, ANSWER)),
    Handed("555", r"M\xfcller", by_bytes(LATIN_1 + b"_555_assignsubmission_file_", ANSWER)),
    Handed(
        "556",
        r"m\xfcller",
        by_bytes(b"m\xfcller_556_7556_" + NAME.encode(), STUB.encode()),
    ),
    Handed(
        "557",
        "müller",
        by_bytes(f"müller_LATE_557_7557_{NAME[:-4]}-1.cpp".encode(), STUB.encode()),
    ),
    Handed(
        "558",
        "Müller Hänschen",
        by_bytes("Müller Hänschen_558_assignsubmission_file_".encode(), ANSWER),
    ),
    Handed("~1B~5B31m~0Ax", "\x1b[31m\nx", by_bytes(b"\x1b[31m\nx", ANSWER)),
    Handed(
        "controls",
        "",
        by_bytes(b"controls", {**ANSWER, b"Icon\r": b"", "a\u202eb.txt".encode(): b""}),
        ("Icon\r", "a\u202eb.txt"),
    ),
    Handed(
        "long",
        "",
        zip_of("long.zip", Member(f"{LONG}/{LONG}.txt".encode(), b"x", UTF8)),
        (f"{LONG}/{LONG}.txt",),
    ),
    Handed(
        "one_colon",
        "",
        zip_of("one_colon.zip", Member("1: Übung/x.txt".encode(), b"x", UTF8)),
        ("1: Übung/x.txt",),
    ),
    Handed(
        "mac",
        "",
        zip_of(
            "mac.zip",
            Member("__MACOSX/._Mu\u0308ller".encode(), b"\0\5\x16\7", UTF8),
            Member(b"Mu\xcc\x88/.DS_Store", b"\0"),
            Member(b".venv/lib64", b"lib", attributes=0o120777 << 16),
        ),
    ),
]

# What programs in East Asia wrote before UTF-8: it is shown wrongly, and graded. Some second bytes
# are a backslash.
OLD = {
    "shift_jis": "表ソ能",
    "gbk": "張三誠",
    "big5": "許功蓋",
    "euc_kr": "김철수",
    "cp1251": "Ёлкина",
}


def handed_in_old_encodings() -> Iterator[Handed]:
    for encoding, name in OLD.items():
        place = f"{name}/{PLACE}".encode(encoding)
        content = zip_bytes([Member(place, STUB.encode(), system=FAT, attributes=0)])
        yield Handed(encoding, "", by_bytes(f"{encoding}.zip".encode(), content))


EVERY = [*handed_in_scripts(), *SINGLE, *handed_in_old_encodings()]


# What is dangerous however it is written: the entry, what is in it, and words of why it is refused.
ANSWER_MEMBER = Member(PLACE.encode(), STUB.encode())
OUTSIDE = "would lie outside of it"
UP = b"../x.cpp"
OTHER_NAME = "has another name in it too"
REFUSED: dict[str, tuple[Member, str]] = {
    "up_utf8": (Member("../ü.cpp".encode(), b"x", UTF8), "'../ü.cpp' " + OUTSIDE),
    "up_cp437": (Member("ü/../../x".encode("cp437")), "'ü/../../x' " + OUTSIDE),
    "up_at_the_end": (Member("ü/..".encode(), b"x", UTF8), OUTSIDE),
    "up_in_extra": (Member(b"x.txt", extra=unicode_path(b"x.txt", UP)), OUTSIDE),
    "up_under_extra": (Member(UP, extra=unicode_path(UP, b"x.txt")), OUTSIDE),
    "up_in_header": (Member(UP, central_name=b"x.txt"), OUTSIDE),
    "up_in_directory": (Member(b"x.txt", central_name=UP), OUTSIDE),
    "up_in_extra_of_directory": (
        Member(b"x.txt", central_extra=unicode_path(b"x.txt", UP)),
        OUTSIDE,
    ),
    "up_by_backslash": (Member(b"..\\..\\x.cpp"), OUTSIDE),
    "up_by_both": (Member("ü/a\\..\\..\\..\\x.cpp".encode(), b"x", UTF8), OUTSIDE),
    "up_with_space": (Member(b".. /x.cpp"), OUTSIDE),
    "absolute": (Member("/ü/x.cpp".encode(), b"x", UTF8), OUTSIDE),
    "absolute_in_extra": (Member(b"x", extra=unicode_path(b"x", b"/x")), OUTSIDE),
    "share": (Member(b"\\\\host\\x.cpp"), OUTSIDE),
    "drive": (Member(b"c:x.cpp"), OUTSIDE),
    "drive_by_backslash": (Member("D:\\ü\\x.cpp".encode("cp437")), OUTSIDE),
    "zero": (Member(b"x.cpp\0.txt"), r"the name 'x.cpp\x00.txt' has a zero byte in it"),
    "zero_in_extra": (Member(b"x", extra=unicode_path(b"x", b"a\0b")), "has a zero byte in it"),
    "link": (
        Member(f"ü/{PLACE}".encode(), b"/etc/passwd", UTF8, attributes=0o120777 << 16),
        f"'ü/{PLACE}' is a link or a device",
    ),
    "answer_in_extra": (
        Member(b"x.txt", extra=unicode_path(b"x.txt", PLACE.encode())),
        f"'{PLACE}' {OTHER_NAME}, 'x.txt'",
    ),
    "answer_under_extra": (
        Member(PLACE.encode(), extra=unicode_path(PLACE.encode(), b"x.txt")),
        f"'x.txt' {OTHER_NAME}, '{PLACE}'",
    ),
    "answer_in_directory": (Member(b"x.txt", central_name=PLACE.encode()), OTHER_NAME),
    "twice": (ANSWER_MEMBER, f"'{PLACE}' is in it twice"),
    "fools": (
        Member("/\u202egpj\u2028\u200b\ufeff\u2066\U000e0041\x9b\x1b[2J".encode(), b"x", UTF8),
        r"'/\u{202e}gpj\u{2028}\u{200b}\u{feff}\u{2066}\u{e0041}\u{9b}\x1b[2J' " + OUTSIDE,
    ),
    "long_name": (Member(f"/{LONG}{LONG}".encode(), b"x", UTF8), f"'/{LONG[1:]}...' " + OUTSIDE),
}


@pytest.fixture(scope="module")
def taken(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Grader]:
    grader = Grader(tmp_path_factory.mktemp("names") / "class")
    for one in EVERY:
        one.make(grader.submissions)
    for name, (member, _) in REFUSED.items():
        content = zip_bytes([ANSWER_MEMBER, member])
        (grader.submissions / f"{name}.zip").write_bytes(content)
    by_bytes(b"n\xf6tes\x1b.txt", b"")(grader.submissions)
    done = grader.run("--json")
    assert done.returncode == 1, done.stderr
    assert r"Ignored, because they are not submissions: n\xf6tes\x1b.txt" in done.stderr
    yield grader
    grader.clean()


@pytest.mark.parametrize("handed", EVERY, ids=lambda handed: handed.id)
def test_is_graded(taken: Grader, handed: Handed) -> None:
    submission = taken.submission(handed.id)
    assert "problem" not in submission, submission["problem"]
    assert submission.get("name", "") == handed.name
    assert submission["ignored"] == list(handed.ignored)
    [unit] = submission["exercises"]
    assert unit["status"] == handed.status
    assert unit["points"] == (unit["max_points"] if handed.answer == SOLUTION else 0)
    kept = taken.results / f".grade/submissions/{handed.id}/{PLACE}"
    assert kept.read_text() == handed.answer


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_dangerous_is_refused(taken: Grader, name: str) -> None:
    submission = taken.submission(name)
    assert REFUSED[name][1] in submission["problem"]
    assert submission["exercises"] == []


def test_nothing_that_is_written_is_other_than_text(taken: Grader) -> None:
    reports = [
        file
        for file in taken.results.rglob("*")
        if file.suffix in {".json", ".csv", ".html", ".xml", ".md", ".txt"}
    ]
    assert len(reports) > len(EVERY)
    for file in reports:
        text = file.read_bytes().decode()
        assert "\x1b" not in text, file
        if file.suffix == ".html":
            assert "\u202e" not in text, file


def test_a_table_names_what_is_not_utf8_as_it_is_shown(grader: Grader) -> None:
    by_bytes(LATIN_1, ANSWER)(grader.submissions)
    by_bytes(b"\xff.zip", zip_bytes([ANSWER_MEMBER]))(grader.submissions)
    by_bytes(b"\xfe", ANSWER)(grader.submissions)
    table = grader.folder / "ids.csv"
    table.write_text("entry,id\nM\\xfcller,s1\n\\xff,s2\n")
    done = grader.run("--json", "--ids", str(table))
    assert done.returncode == 1, done.stderr
    assert "and not there" not in done.stderr
    problems: dict[str, str] = {
        submission["id"]: submission.get("problem", "")
        for submission in grader.document()["submissions"]
    }
    assert problems == {
        "s1": "",
        "s2": "",
        "~FE": r"'\xfe' is not in ids.csv: add a line for it",
    }


@pytest.mark.parametrize("form", FORMS)
def test_a_table_may_be_composed_otherwise_than_the_entries(grader: Grader, form: Form) -> None:
    """Of every character that is composed: macOS decomposes names, a list of students does not."""
    of_unicode_14 = [
        chr(code)
        for code in range(0x80, 0x110000)
        if (found := unicodedata.decomposition(chr(code)))
        and not found.startswith("<")
        and "COMPATIBILITY IDEOGRAPH" not in unicodedata.name(chr(code))
    ]
    assert len(of_unicode_14) > 1000
    composed = [*of_unicode_14, *map(chr, range(0xAC00, 0xD7A4, 97))]
    names = [*SCRIPTS.values(), "Nguyễn Thị Hường"]
    for at in range(0, len(composed), 10):
        names.append(f"{at}: " + "".join(f"x{letter}" for letter in composed[at : at + 10]))
    with (grader.folder / "ids.csv").open("w") as table:
        table.write("entry,id\n")
        for at, name in enumerate(names):
            other = unicodedata.normalize("NFD", name)
            in_table, entry = (other, name) if form == "NFC" else (name, other)
            table.write(f'"{in_table}",s{at}\n')
            (grader.submissions / entry).mkdir()
    done = grader.run("--json", "--ids", str(grader.folder / "ids.csv"))
    assert done.returncode == 0, done.stdout + done.stderr
    assert "and not there" not in done.stderr
    ids = {submission["id"] for submission in grader.document()["submissions"]}
    assert ids == {f"s{at}" for at in range(len(names))}


def test_an_id_that_cannot_be_read_has_its_name_beside_it(grader: Grader) -> None:
    by_bytes("Мария\u202e".encode(), {PLACE.encode(): b"\0"})(grader.submissions)
    done = grader.run()
    assert done.returncode == 1, done.stderr
    shown = r"~D0~9C~D0~B0~D1~80~D0~B8~D1~8F~E2~80~AE (Мария\u{202e}), 01_planes/signed_distance: "
    assert shown in done.stdout


def test_two_entries_of_a_name_that_is_not_utf8_are_named(grader: Grader) -> None:
    by_bytes(LATIN_1, ANSWER)(grader.submissions)
    by_bytes(LATIN_1 + b".zip", zip_bytes([ANSWER_MEMBER]))(grader.submissions)
    grader.hand_in("other", STUB)
    grader.grade(code=1)
    problem = grader.submission("M~FCller~~1")["problem"]
    assert r"'M\xfcller' and 'M\xfcller.zip' are of one student, 'M\xfcller'" in problem
