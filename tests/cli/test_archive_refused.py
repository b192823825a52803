"""Invalid archives: each is refused as a whole, and nothing is written."""

from __future__ import annotations

import io
import random
import re
import shutil
import stat
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "grade"))

from archives import (
    COPY,
    COPY_NAME,
    MANIFEST,
    MIB,
    PLANE,
    RAY,
    STUB,
    STUB_OF_PLANE,
    Files,
    Run,
    info,
    of_page,
    progress,
    refused,
    special,
    tree,
    zipped,
)
from zip_bytes import Member, unicode_path, zip_bytes


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
    entry.filename = name  # as it is: the constructor would correct some
    pairs: list[tuple[str | zipfile.ZipInfo, str | bytes]] = [*of_page({PLANE: "int x;"}).items()]
    file = zipped(tmp_path / "a.zip", [*pairs, (entry, "" if name.endswith("/") else "int x;")])
    refused(contact, work, tmp_path, file, "has no place in it")


@pytest.mark.parametrize("place", ["extra", "directory"])
def test_an_entry_with_two_names(contact: Run, work: Path, tmp_path: Path, place: str) -> None:
    """Another program may unpack another file from it."""
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
