"""A complete autograder: one zip file with this book, the exercises to grade, and a script to start
it.

For Gradescope it is uploaded as it is. Unpacked, its Dockerfile makes an image for PrairieLearn.
"""

from __future__ import annotations

import argparse
import json
import os
import secrets
import subprocess
import sys
import zipfile
from collections.abc import Iterator, Set
from pathlib import Path

from reports.moment import moment
from reports.results import ReportError

FILES = Path(__file__).with_name("autograder_files")
FORMAT = "contact-autograder/1"
# The files of the book. Submissions or results may be in the same folder and must not be packed.
BOOK = (
    *("contact", "CMakeLists.txt", "CMakePresets.json", "pyproject.toml", "biome.json"),
    *(
        "LICENSE",
        "LICENSE-prose.md",
        "README.md",
        "NOTICES.md",
        "CHANGELOG.md",
        "CONTRIBUTING.md",
        ".gitignore",
    ),
    *("benchmarks", "chapters", "cli", "cmake", "docs", "exercises", "grading", "page"),
    *("solutions", "tests", "tools"),
)
# What is made lies between it. In the book, what is built lies at the root only: grading/build/ is
# a room of sources.
MADE = {".git", "node_modules", "__pycache__"}
MADE_BY_AN_INSTRUCTOR = {*MADE, "build", "work"}
SETTINGS = ("exercises", "seed", "accept_weak")
OPTIONS = "options.json"
PROFILE = "profile.toml"


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(
        prog="python -m reports.autograder",
        description="Packs this book into an autograder for Gradescope or PrairieLearn.",
    )
    parser.add_argument("file", type=Path, metavar="FILE.zip")
    parser.add_argument("--exercises", metavar="LIST", help="as contact grade takes them")
    parser.add_argument("--private", type=Path, metavar="DIR", help="private tests to pack with it")
    parser.add_argument("--profile", type=Path, metavar="FILE", help="limits to grade with")
    parser.add_argument("--seed", metavar="TEXT", help="of the random cases; drawn if not given")
    parser.add_argument("--due", type=moment, metavar="TIME", help="when work is due")
    parser.add_argument("--accept-weak", action="store_true", help="grade where little is enforced")
    given = parser.parse_args(arguments)
    try:
        count = build(given.file, book_root(), given)
    except ReportError as error:
        print(f"autograder: {error}", file=sys.stderr)
        return 3
    except OSError as error:
        print(f"autograder: {error.filename}: {error.strerror}", file=sys.stderr)
        return 3
    print(
        f"{given.file}: {count} files. On Gradescope, upload it under Configure Autograder,"
        " with Ubuntu 24.04 as the base image.",
        file=sys.stderr,
    )
    return 0


def build(file: Path, root: Path, settings: argparse.Namespace) -> int:
    """Writes the archive; returns how many files it holds."""
    if file.exists():
        raise ReportError(f"{file} is there already; give another name or remove it.")
    if file.suffix != ".zip":
        raise ReportError(f"{file} should end with .zip: Gradescope takes nothing else.")
    entries = dict(_entries(root, settings))
    beside = file.with_name(f".{file.name}.{os.getpid()}")
    try:
        with zipfile.ZipFile(beside, "w", zipfile.ZIP_DEFLATED) as archive:
            for name in sorted(entries):
                data, runs = entries[name]
                entry = zipfile.ZipInfo(name, date_time=(1980, 1, 1, 0, 0, 0))
                entry.external_attr = (0o100755 if runs else 0o100644) << 16
                entry.compress_type = zipfile.ZIP_DEFLATED
                archive.writestr(entry, data)
        beside.replace(file)
    finally:
        beside.unlink(missing_ok=True)
    return len(entries)


def book_root() -> Path:
    """The book's folder."""
    return Path(os.environ.get("CONTACT_ROOT") or Path(__file__).resolve().parents[2])


def _entries(root: Path, settings: argparse.Namespace) -> Iterator[tuple[str, tuple[bytes, bool]]]:
    options = {name: value for name in SETTINGS if (value := getattr(settings, name))}
    # One seed for all students graded with this archive; only those who have the archive know it.
    options.setdefault("seed", secrets.token_hex(16))
    if settings.due:
        options["due"] = settings.due.isoformat()
    yield OPTIONS, (json.dumps({"format": FORMAT, **options}, indent=1).encode() + b"\n", False)
    for file in sorted(FILES.iterdir()):
        yield file.name, (file.read_bytes(), file.suffix == ".sh" or file.name.startswith("run_"))
    if settings.profile:
        yield PROFILE, (settings.profile.read_bytes(), False)
    if settings.private:
        if not settings.private.is_dir():
            raise ReportError(f"{settings.private} is no folder of private tests.")
        for file in _walk(settings.private, MADE_BY_AN_INSTRUCTOR):
            name = file.relative_to(settings.private).as_posix()
            yield f"private/{name}", (file.read_bytes(), False)
    for file in book_files(root):
        name = file.relative_to(root).as_posix()
        yield f"contact/{name}", (file.read_bytes(), os.access(file, os.X_OK))


def book_files(root: Path) -> list[Path]:
    """The files of the book and of added chapters, and no other files in the folder."""
    command = ["git", "-C", str(root), "ls-files", "-z", "--cached", "--others"]
    listed = subprocess.run(
        [*command, "--exclude-standard", "--", *BOOK], capture_output=True, check=False
    )
    if listed.returncode == 0 and listed.stdout:
        names = [name for name in listed.stdout.decode().split("\0") if name]
        files = [root / name for name in names]
        return [file for file in files if file.is_file() and not file.is_symlink()]
    files = []
    for name in BOOK:
        place = root / name
        if place.is_dir():
            files += _walk(place, MADE)
        elif place.is_file():
            files.append(place)
    return files


def _walk(folder: Path, made: Set[str]) -> Iterator[Path]:
    for entry in sorted(folder.iterdir()):
        if entry.is_symlink() or entry.name in made:
            continue
        if entry.is_dir():
            yield from _walk(entry, made)
        elif entry.is_file():
            yield entry


if __name__ == "__main__":
    sys.exit(main())
