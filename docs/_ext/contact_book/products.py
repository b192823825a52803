"""Runs the chapters' programs to get the numbers that pages show."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from pathlib import Path

from contact_book.book import Book, Chapter
from contact_book.errors import BookError

# A quick look only; `contact ladder` makes the measurements that are kept.
_SMOKE = ["--size", "2000", "--repeats", "5"]


def _stale(target: Path, program: Path) -> bool:
    return not target.is_file() or target.stat().st_mtime_ns < program.stat().st_mtime_ns


def _run(command: list[str]) -> str:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise BookError(f"{' '.join(command)} failed: {(done.stderr or done.stdout).strip()}")
    return done.stdout


def _ladder(book: Book, chapter: Chapter, programs: Path) -> Iterator[str]:
    program = programs / f"ladder_{chapter.slug}"
    target = book.products / "ladders" / f"{chapter.slug}.json"
    kept = list((book.root / "benchmarks" / "results").glob(f"{chapter.slug}.*.json"))
    if kept or not program.is_file() or not _stale(target, program):
        return
    target.parent.mkdir(parents=True, exist_ok=True)
    _run([str(program), *_SMOKE, "--json", str(target)])
    yield f"ladder of {chapter.slug}, a quick run"


def run_programs(book: Book, programs: Path) -> Iterator[str]:
    """Runs every program whose output is older than the program, and says which."""
    for chapter in book.chapters.values():
        yield from _ladder(book, chapter, programs)
