"""The book together with a pack, to be served: `./contact --pack FOLDER serve`.

    pack_book.py PACK    brings PACK/build/book up to date and prints its path

It holds a copy of the book's sources, and among them the pack's chapters and exercises. The pages
are built from it as from the book itself, so neither the book's folder nor the pack's own files
change. A file is copied only if it differs, and keeps its time, so that nothing is built twice.
"""

from __future__ import annotations

import argparse
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BOOK = (
    "contact",
    "CHANGELOG.md",
    "CMakeLists.txt",
    "CMakePresets.json",
    "LICENSE",
    "LICENSE-prose.md",
    "NOTICES.md",
    "README.md",
    "benchmarks",
    "biome.json",
    "chapters",
    "cli",
    "cmake",
    "docs",
    "exercises",
    "grading",
    "page",
    "solutions",
    "tests",
    "tools",
)
PACK = ("chapters", "exercises", "solutions", "tests")
# What is installed is not copied; the copy uses the same.
INSTALLED = ("build/venv", "page/node_modules")
LEFT_OUT = {"node_modules", "__pycache__", ".mypy_cache", ".ruff_cache", ".pytest_cache"}
MISCONCEPTIONS = Path("chapters/misconceptions.toml")


def files_of(folder: Path, names: tuple[str, ...]) -> Iterator[Path]:
    """The files with one of these names in a folder, or below it there, relative to the folder."""
    for name in names:
        if (folder / name).is_file():
            yield Path(name)
            continue
        for file in sorted((folder / name).rglob("*")):
            inside = file.relative_to(folder)
            if file.is_file() and not LEFT_OUT.intersection(inside.parts):
                yield inside


def copy(source: Path, target: Path) -> None:
    there, now = target.stat() if target.exists() else None, source.stat()
    if there and (there.st_mtime_ns, there.st_size) == (now.st_mtime_ns, now.st_size):
        return
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy2(source, target)


def write_misconceptions(pack: Path, folder: Path) -> None:
    """Those of the book and of the pack in one file; no name is in both."""
    sources = [root / MISCONCEPTIONS for root in (ROOT, pack) if (root / MISCONCEPTIONS).exists()]
    text = "\n".join(source.read_text(encoding="utf-8") for source in sources)
    target = folder / MISCONCEPTIONS
    if not target.exists() or target.read_text(encoding="utf-8") != text:
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")


def remove_others(folder: Path, wanted: set[Path]) -> None:
    """Removes from the copy what neither the book nor the pack has any more."""
    for file in list(files_of(folder, BOOK)):
        if file not in wanted:
            (folder / file).unlink()
    for top in PACK:
        for below in sorted((folder / top).rglob("*"), reverse=True):
            if below.is_dir() and not any(below.iterdir()):
                below.rmdir()


def link_installed(folder: Path) -> None:
    for name in INSTALLED:
        link = folder / name
        if not (ROOT / name).exists() or (link.is_symlink() and link.readlink() == ROOT / name):
            continue
        link.parent.mkdir(parents=True, exist_ok=True)
        link.unlink(missing_ok=True)
        link.symlink_to(ROOT / name)


def pack_book(pack: Path) -> Path:
    folder = pack / "build" / "book"
    wanted = {MISCONCEPTIONS}
    for root, names in ((ROOT, BOOK), (pack, PACK)):
        for file in files_of(root, names):
            wanted.add(file)
            if file != MISCONCEPTIONS:
                copy(root / file, folder / file)
    write_misconceptions(pack, folder)
    remove_others(folder, wanted)
    link_installed(folder)
    return folder


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n\n")[0])
    parser.add_argument("pack", type=Path)
    print(pack_book(parser.parse_args().pack.absolute()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
