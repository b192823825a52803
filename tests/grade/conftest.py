"""A class to grade, of which nothing may be left behind; which tests stay together."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "tools")]

from graded_class import Grader  # noqa: E402

# What takes longest begins first, so that the last to end ends soon.
FIRST = ("test_hostile full", "test_hostile reduced", "test_slurm")
# Of these no two tests share anything, so each goes to whoever is free, at the end.
EACH_ALONE = ("test_grade", "test_protocol", "test_seeds")


def group_of(item: pytest.Item) -> str:
    """Tests that share what they look at: those of a file, and of one level of its boxes where each
    has a class of its own."""
    name = item.path.stem
    level = re.search(r"\[(full|reduced)\b", item.name) if name == "test_hostile" else None
    return f"{name} {level[1]}" if level else name


# Before xdist reads the groups.
@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    def place(item: pytest.Item) -> int:
        group = group_of(item)
        if group in FIRST:
            return FIRST.index(group)
        return len(FIRST) + (group in EACH_ALONE)

    ours = [item for item in items if item.path.parent == HERE]
    for item in ours:
        if group_of(item) not in EACH_ALONE:
            item.add_marker(pytest.mark.xdist_group(group_of(item)))
    items[:] = sorted(ours, key=place) + [item for item in items if item.path.parent != HERE]


@pytest.fixture
def grader(tmp_path: Path) -> Iterator[Grader]:
    one = Grader(tmp_path / "class")
    yield one
    one.clean()
