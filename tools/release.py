"""Makes what a release attaches: the book as one zip to read offline, the e-book, and the notes.

`build/venv/bin/python tools/release.py v0.1.0`, after `./contact serve --once`, writes them to
build/published/. A tag that is not the version of CMakeLists.txt, a version of which the changelog
says nothing, and a book that is not whole are refused.
"""

from __future__ import annotations

import re
import shutil
import sys
import zipfile
from dataclasses import dataclass
from pathlib import Path

import steps

EBOOK = steps.EBOOK.name
# Zip knows no earlier time. The same book then gives the same bytes.
TIME = (1980, 1, 1, 0, 0, 0)

READ_ME = """\
Contact Hours {version}, to read without a network.

A browser runs the figures and the exercises only from a server. Any that serves files will do:

    python3 -m http.server --bind 127.0.0.1 --directory book 8000

Then open http://127.0.0.1:8000/ in a browser.
"""


class ReleaseError(Exception):
    """Why there is none, and what to do."""


@dataclass(frozen=True)
class Release:
    book: Path
    ebook: Path
    notes: Path


def version_of(root: Path) -> str:
    text = (root / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.search(r"^project\(ContactHours VERSION (\S+)", text, re.MULTILINE)
    if not found:
        raise ReleaseError(
            "CMakeLists.txt gives no version: project(ContactHours VERSION X.Y.Z ...)"
        )
    return found[1]


def notes_of(root: Path, version: str) -> str:
    """What the changelog says of a version, without its heading."""
    text = (root / "CHANGELOG.md").read_text(encoding="utf-8")
    heading = rf"^## \[{re.escape(version)}\][^\n]*\n"
    found = re.search(rf"{heading}(.*?)(?=^## \[|^\[|\Z)", text, re.MULTILINE | re.DOTALL)
    if not found or not found[1].strip():
        raise ReleaseError(
            f"CHANGELOG.md says nothing of {version}: put what [Unreleased] says under a heading "
            f"## [{version}] with the date"
        )
    return found[1].strip() + "\n"


def zip_of(site: Path, to: Path, version: str) -> None:
    folder = f"contact-hours-{version}"
    files = {f"book/{file.relative_to(site).as_posix()}": file for file in site.rglob("*")}
    with zipfile.ZipFile(to, "w") as made:

        def add(name: str, data: bytes) -> None:
            entry = zipfile.ZipInfo(f"{folder}/{name}", TIME)
            entry.external_attr = 0o644 << 16  # readable by everyone
            made.writestr(entry, data, zipfile.ZIP_DEFLATED)

        add("README.txt", READ_ME.format(version=version).encode())
        for name, file in sorted(files.items()):
            if file.is_file():
                add(name, file.read_bytes())


def make(root: Path, tag: str) -> Release:
    version = version_of(root)
    if tag != f"v{version}":
        raise ReleaseError(
            f"the tag is {tag[:40]!r}, and the version in CMakeLists.txt is {version}: tag "
            f"v{version}, or raise the version first"
        )
    notes = notes_of(root, version)
    site = root / "build" / "site"
    for name in ("index.html", "searchindex.js", EBOOK):
        if not (site / name).is_file():
            raise ReleaseError(f"build/site/{name} is not there: run ./contact serve --once first")
    made = root / "build" / "published"
    shutil.rmtree(made, ignore_errors=True)
    made.mkdir(parents=True)
    release = Release(
        book=made / f"contact-hours-{version}.zip",
        ebook=made / f"contact-hours-{version}.epub",
        notes=made / "notes.md",
    )
    zip_of(site, release.book, version)
    shutil.copyfile(site / EBOOK, release.ebook)
    release.notes.write_text(notes, encoding="utf-8")
    return release


def main(arguments: list[str]) -> int:
    if len(arguments) != 1:
        print("usage: tools/release.py vX.Y.Z", file=sys.stderr)
        return 2
    try:
        release = make(steps.ROOT, arguments[0])
    except ReleaseError as why:
        print(f"tools/release.py: {why}", file=sys.stderr)
        return 1
    for file in (release.book, release.ebook, release.notes):
        print(f"{file.relative_to(steps.ROOT)}  {file.stat().st_size} bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
