"""Packs for tests: made by the program, used through CONTACT_PACK as `./contact --pack` does."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
PROGRAM = ROOT / "build" / "dev" / "bin" / "contact"
CHAPTER = "50_first_steps"
EXERCISE = f"{CHAPTER}/overlap_depth"

Done = subprocess.CompletedProcess[str]


def in_pack(pack: Path | None, *words: str, cwd: Path | None = None) -> Done:
    environment = {**os.environ, "CONTACT_ROOT": str(ROOT)}
    environment.pop("CONTACT_WORK", None)
    environment.pop("CONTACT_PACK", None)
    if pack is not None:
        environment["CONTACT_PACK"] = str(pack)
    return subprocess.run(
        [str(PROGRAM), *words],
        capture_output=True,
        text=True,
        env=environment,
        cwd=cwd or (pack if pack is not None and pack.is_dir() else ROOT),
        stdin=subprocess.DEVNULL,
        timeout=1200,
    )


def new_pack(folder: Path) -> Path:
    done = in_pack(None, "new", "pack", str(folder), "--author", "A. Teacher")
    assert done.returncode == 0, done.stderr
    return folder


def change(file: Path, old: str, new: str) -> int:
    """Replaces a text that is there once. Returns the number of its line."""
    text = file.read_text()
    assert text.count(old) == 1, (file, old)
    file.write_text(text.replace(old, new))
    return text[: text.index(old)].count("\n") + 1


def tree_state() -> str:
    """What git sees of the book's folder, with each file that it ignores outside of build/."""
    words = ["git", "status", "--porcelain", "--ignored", "--untracked-files=all", "--", "."]
    words += [":!build", ":!:**/__pycache__/**", ":!page/node_modules"]
    return subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=True).stdout
