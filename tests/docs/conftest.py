"""Builds the sample book once for all tests that look at its pages."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "docs" / "_ext"), str(ROOT / "grading" / "book")]

from sample_book import Sample  # noqa: E402


@pytest.fixture
def sample(tmp_path: Path) -> Sample:
    """A fresh copy of the sample book, not yet built."""
    return Sample(tmp_path)


@pytest.fixture(scope="session")
def built(tmp_path_factory: pytest.TempPathFactory) -> Sample:
    """The sample book, built. Tests only look at it."""
    book = Sample(tmp_path_factory.mktemp("sample"))
    made = book.make("--complete")
    assert made.returncode == 0, made.stdout + made.stderr
    return book
