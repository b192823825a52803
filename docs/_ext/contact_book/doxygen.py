"""Runs Doxygen over the chapters' headers when one of them has changed."""

from __future__ import annotations

import hashlib
import shutil
import subprocess
import sys
from pathlib import Path

from contact_book.book import Book
from contact_book.errors import BookError
from contact_book.scoping import restore_scopes


def _fingerprint(files: list[Path]) -> str:
    digest = hashlib.sha256()
    for path in files:
        digest.update(str(path).encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()


def _worth_saying(log: str) -> str:
    """Doxygen's warnings; an operator says by itself what it does."""
    lines = dict.fromkeys(line for line in log.splitlines() if "Member operator" not in line)
    return "\n".join(lines)


def _install(made: Path, target: Path) -> int:
    """Moves XML that differs, so that Breathe sees only real changes; how many files did."""
    target.mkdir(parents=True, exist_ok=True)
    names = {path.name for path in made.iterdir()}
    changed = 0
    for path in made.iterdir():
        old = target / path.name
        if not old.is_file() or old.read_bytes() != path.read_bytes():
            shutil.copyfile(path, old)
            changed += 1
    for path in target.iterdir():
        if path.name not in names:
            path.unlink()
    return changed


def run_doxygen(book: Book, template: Path, target: Path, *, strict: bool) -> str:
    """Writes target/xml and says what it did; strictly, anything undocumented is an error."""
    chapters = [chapter for chapter in book.chapters.values() if chapter.headers]
    headers = [header for chapter in chapters for header in chapter.headers]
    if not headers:
        return "no headers"
    mark = target / "fingerprint"
    grouping = template.with_name("group_filter.py")
    now = _fingerprint([template, grouping, *headers])
    if mark.is_file() and mark.read_text(encoding="utf-8") == now:
        return "nothing changed"
    fresh = target / "fresh"
    shutil.rmtree(fresh, ignore_errors=True)
    fresh.mkdir(parents=True)
    log = target / "warnings.txt"
    values = {
        "INPUT": " ".join(f'"{chapter.folder / "contact"}"' for chapter in chapters),
        "FILTER": f'"{sys.executable} {grouping}"',
        "STRIP": f'"{book.root}"',
        "OUTPUT": f'"{fresh}"',
        "LOG": f'"{log}"',
    }
    text = template.read_text(encoding="utf-8")
    for key, value in values.items():
        text = text.replace(f"@{key}@", value)
    try:
        done = subprocess.run(
            ["doxygen", "-"], input=text, text=True, capture_output=True, check=False
        )
    except FileNotFoundError:
        raise BookError("doxygen is not installed: run ./contact setup") from None
    warnings = _worth_saying(log.read_text(encoding="utf-8")) if log.is_file() else ""
    if done.returncode != 0 or warnings:
        shown = warnings.replace(f"{book.root}/", "") or done.stderr.strip()
        words = f"the headers are not documented as they must be:\n{shown}"
        if strict or done.returncode != 0:
            raise BookError(words)
    restore_scopes(fresh / "xml")
    changed = _install(fresh / "xml", target / "xml")
    said = f"{len(headers)} headers, {changed} XML files changed"
    if warnings:
        return f"{said}; {words}"
    mark.write_text(now, encoding="utf-8")
    return said
