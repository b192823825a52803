"""A class to grade, of which nothing may be left behind."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "tools")]

from graded_class import Grader


@pytest.fixture
def grader(tmp_path: Path) -> Iterator[Grader]:
    one = Grader(tmp_path / "class")
    yield one
    one.clean()
