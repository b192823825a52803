"""export: what is packed, despite obstacles."""

from __future__ import annotations

import json
import os
import re
import zipfile
from pathlib import Path
from typing import Any

import pytest
from archives import (
    MIB,
    PLANE,
    RAY,
    Run,
    contents,
    progress,
    put,
    tree,
)


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
    assert "mine.zip already exists" in done.stderr
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
    (work / "progress.json").write_text(progress(record, from_later={"q": 1}))
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
