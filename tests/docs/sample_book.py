"""A small book with one of everything, for tests to build and to spoil."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]


class Sample:
    """A copy of the sample book that a test may spoil, and the commands that build it."""

    def __init__(self, folder: Path) -> None:
        self.root = folder / "book"
        self.build = folder / "build"
        self.site = self.build / "site"
        shutil.copytree(HERE / "sample", self.root)
        shutil.copytree(self.root / "products", self.build / "docs-data")

    def edit(self, name: str, old: str, new: str) -> None:
        path = self.root / name
        text = path.read_text(encoding="utf-8")
        assert old in text, f"{name} does not say {old!r}"
        path.write_text(text.replace(old, new), encoding="utf-8")

    def make(self, *extra: str) -> subprocess.CompletedProcess[str]:
        """Runs docs/build.py on this copy."""
        return subprocess.run(
            [
                *(sys.executable, str(ROOT / "docs" / "build.py")),
                *("--root", str(self.root), "--build", str(self.build)),
                *("--web", str(self.root / "web"), *extra),
            ],
            capture_output=True,
            text=True,
            # To make the faces takes longer than the rest of the sample; they are the book's.
            env={**os.environ, "CONTACT_BOOK_FONTS": str(ROOT / "build" / "fonts")},
            check=False,
        )

    def page(self, name: str) -> str:
        return (self.site / name).read_text(encoding="utf-8")
