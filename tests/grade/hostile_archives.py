"""Submissions whose attack is in how they are packed. Each is written beside a twin without it."""

from __future__ import annotations

import io
import os
import struct
import tarfile
import zipfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

ANSWER = "01_planes/signed_distance.cpp"


@dataclass(frozen=True)
class Packed:
    name: str
    tries: str
    #: Words of the sentence with which it is refused; empty if there is nothing that could be.
    says: str
    #: Makes the entry in a folder of submissions: the attack, or its twin.
    make: Callable[[Path, str, str, Mapping[str, str]], None]
    twin: Callable[[Path, str, str], None]


def folder_twin(folder: Path, name: str, answer: str) -> None:
    file = folder / name / ANSWER
    file.parent.mkdir(parents=True)
    file.write_text(answer)


def zip_twin(folder: Path, name: str, answer: str) -> None:
    with zipfile.ZipFile(folder / f"{name}.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(ANSWER, answer)


def tar_twin(folder: Path, name: str, answer: str) -> None:
    with tarfile.open(folder / f"{name}.tar.gz", "w:gz") as archive:
        add(archive, ANSWER, answer)


def add(archive: tarfile.TarFile, name: str, text: str) -> None:
    member = tarfile.TarInfo(name)
    member.size = len(text.encode())
    archive.addfile(member, io.BytesIO(text.encode()))


def linked(archive: tarfile.TarFile, name: str, target: str, kind: bytes) -> None:
    member = tarfile.TarInfo(name)
    member.type = kind
    member.linkname = target
    archive.addfile(member)


def zip_symlink(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    with zipfile.ZipFile(folder / f"{name}.zip", "w") as archive:
        link = zipfile.ZipInfo(ANSWER)
        link.create_system = 3
        link.external_attr = 0o120777 << 16
        archive.writestr(link, words["SOLUTION"])


def tar_symlink(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    with tarfile.open(folder / f"{name}.tar.gz", "w:gz") as archive:
        linked(archive, ANSWER, words["SOLUTION"], tarfile.SYMTYPE)


def tar_linked_folder(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    with tarfile.open(folder / f"{name}.tar.gz", "w:gz") as archive:
        linked(archive, "01_planes", str(Path(words["SOLUTION"]).parent), tarfile.SYMTYPE)
        add(archive, "01_planes/notes.txt", "written through the link")


def tar_hardlink(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    with tarfile.open(folder / f"{name}.tar.gz", "w:gz") as archive:
        linked(archive, ANSWER, words["SOLUTION"], tarfile.LNKTYPE)


def tar_device(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    with tarfile.open(folder / f"{name}.tar.gz", "w:gz") as archive:
        member = tarfile.TarInfo(ANSWER)
        member.type = tarfile.CHRTYPE
        member.devmajor, member.devminor = 1, 5
        archive.addfile(member)


def tar_fifo(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    with tarfile.open(folder / f"{name}.tar.gz", "w:gz") as archive:
        member = tarfile.TarInfo(ANSWER)
        member.type = tarfile.FIFOTYPE
        archive.addfile(member)


def zip_outside(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    with zipfile.ZipFile(folder / f"{name}.zip", "w") as archive:
        archive.writestr(ANSWER, answer)
        for up in range(1, 6):
            archive.writestr("../" * up + f"{words['NEIGHBOUR_ID']}/{ANSWER}", "spoiled")
            archive.writestr(
                "../" * up + f"submissions/{words['NEIGHBOUR_ID']}/{ANSWER}", "spoiled"
            )


def zip_backslashes(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    with zipfile.ZipFile(folder / f"{name}.zip", "w") as archive:
        archive.writestr(ANSWER, answer)
        archive.writestr(f"..\\..\\{words['TOKEN']}-outside", "spoiled")


def tar_absolute(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    with tarfile.open(folder / f"{name}.tar.gz", "w:gz") as archive:
        add(archive, ANSWER, answer)
        add(archive, f"/tmp/{words['TOKEN']}-absolute", "spoiled")
        add(archive, words["SECRET"], "spoiled")


def zip_bomb(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    zeros = bytes(1 << 20)
    with (
        zipfile.ZipFile(
            folder / f"{name}.zip", "w", zipfile.ZIP_DEFLATED, compresslevel=1
        ) as archive,
        archive.open(ANSWER, "w") as member,
    ):
        for _ in range(400):
            member.write(zeros)


def tar_bomb(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    class Zeros(io.RawIOBase):
        def read(self, size: int = -1) -> bytes:
            return bytes(size)

    with tarfile.open(folder / f"{name}.tar.gz", "w:gz", compresslevel=1) as archive:
        member = tarfile.TarInfo("padding")
        member.size = 400 << 20
        archive.addfile(member, Zeros())
        add(archive, ANSWER, answer)


def zip_crowd(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    with zipfile.ZipFile(folder / f"{name}.zip", "w") as archive:
        archive.writestr(ANSWER, answer)
        for i in range(100_000):
            archive.writestr(f"01_planes/{i}.cpp", "")


def zip_liar(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    """Says everywhere that its 200 MB are 100 bytes."""
    file = folder / f"{name}.zip"
    size = 200 << 20
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        archive.writestr(ANSWER, b"/" * size)
    file.write_bytes(file.read_bytes().replace(struct.pack("<I", size), struct.pack("<I", 100)))


def zip_cut(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    zip_twin(folder, name, answer)
    file = folder / f"{name}.zip"
    file.write_bytes(file.read_bytes()[:200])


def tar_long_name(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    with tarfile.open(folder / f"{name}.tar.gz", "w:gz") as archive:
        add(archive, "a/" * 3000 + ANSWER, answer)
        add(archive, "n" * 100_000 + ".cpp", answer)


def folder_symlink(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    file = folder / name / ANSWER
    file.parent.mkdir(parents=True)
    file.symlink_to(words["SOLUTION"])


def folder_linked_folder(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    (folder / name).mkdir()
    (folder / name / "01_planes").symlink_to(f"../{words['NEIGHBOUR_ID']}/01_planes")


def folder_fifo(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    file = folder / name / ANSWER
    file.parent.mkdir(parents=True)
    os.mkfifo(file)


def folder_huge_file(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    file = folder / name / ANSWER
    file.parent.mkdir(parents=True)
    with file.open("wb") as opened:
        opened.truncate(8 << 30)


def folder_instead_of_file(folder: Path, name: str, answer: str, words: Mapping[str, str]) -> None:
    (folder / name / ANSWER / "inside").mkdir(parents=True)


NOT_A_FILE = "a link or a device, not a plain file"
OUTSIDE = "would lie outside of it"
TOO_MUCH = "unpacks to more than"
TOO_LARGE = "is larger than"

PACKED = [
    Packed(
        "zip_symlink",
        "an answer that is a link to the solution, in a zip",
        NOT_A_FILE,
        zip_symlink,
        zip_twin,
    ),
    Packed("tar_symlink", "the same in a tar", NOT_A_FILE, tar_symlink, tar_twin),
    Packed(
        "tar_linked_folder",
        "a folder that is a link to the solution's",
        NOT_A_FILE,
        tar_linked_folder,
        tar_twin,
    ),
    Packed(
        "tar_hardlink",
        "an answer that is the solution itself by another name",
        NOT_A_FILE,
        tar_hardlink,
        tar_twin,
    ),
    Packed(
        "tar_device", "an answer that is the device /dev/zero", NOT_A_FILE, tar_device, tar_twin
    ),
    Packed(
        "tar_fifo",
        "an answer that is a pipe: reading it never ends",
        NOT_A_FILE,
        tar_fifo,
        tar_twin,
    ),
    Packed(
        "zip_outside",
        "writes over another submission by a path with ..",
        OUTSIDE,
        zip_outside,
        zip_twin,
    ),
    Packed("zip_backslashes", "the same with the other slash", OUTSIDE, zip_backslashes, zip_twin),
    Packed("tar_absolute", "writes to absolute paths", OUTSIDE, tar_absolute, tar_twin),
    Packed("zip_bomb", "400 MB of zeros in 2 MB", TOO_MUCH, zip_bomb, zip_twin),
    Packed("tar_bomb", "the same before the answer in a tar", TOO_MUCH, tar_bomb, tar_twin),
    Packed("zip_crowd", "100,000 files", "entries", zip_crowd, zip_twin),
    Packed("zip_liar", "200 MB that are called 100 bytes", TOO_LARGE, zip_liar, zip_twin),
    Packed("zip_cut", "an archive that is cut off", "broken", zip_cut, zip_twin),
    Packed(
        "tar_long_name",
        "names of a hundred thousand letters and 3000 folders deep",
        "deep",
        tar_long_name,
        tar_twin,
    ),
    Packed(
        "folder_symlink",
        "a link to the solution in a plain folder",
        NOT_A_FILE,
        folder_symlink,
        folder_twin,
    ),
    Packed(
        "folder_linked_folder",
        "a link to another's submission",
        NOT_A_FILE,
        folder_linked_folder,
        folder_twin,
    ),
    Packed("folder_fifo", "a pipe in a plain folder", NOT_A_FILE, folder_fifo, folder_twin),
    Packed(
        "folder_huge_file",
        "8 GB of nothing in a plain folder",
        TOO_LARGE,
        folder_huge_file,
        folder_twin,
    ),
    Packed(
        "folder_instead_of_file",
        "a folder that is called as the answer",
        "",
        folder_instead_of_file,
        folder_twin,
    ),
]
