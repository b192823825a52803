"""A ladder asks the same questions natively and in the page: its random draws have one order.

Arguments of a call are evaluated in any order, and clang's is not gcc's. In braces it is the order
in which they stand.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
import tree_sitter_cpp
from tree_sitter import Language, Node, Parser

ROOT = Path(__file__).resolve().parents[2]
LADDERS = sorted([*ROOT.glob("chapters/*/ladder.cpp"), *ROOT.glob("tests/*/families.hpp")])
PARSER = Parser(Language(tree_sitter_cpp.language()))


def below(node: Node) -> Iterator[Node]:
    yield node
    for child in node.children:
        yield from below(child)


def draws(node: Node) -> bool:
    """Whether evaluating it draws a random number: a call in it has `random`."""
    calls = (each for each in below(node) if each.type == "call_expression")
    return any(
        each.type == "identifier" and each.text == b"random"
        for call in calls
        for each in below(call)
    )


def in_any_order(source: bytes) -> list[str]:
    """The lists of arguments of which more than one draws."""
    lists = (each for each in below(PARSER.parse(source).root_node) if each.type == "argument_list")
    return [
        f"line {each.start_point.row + 1}: {(each.text or b'').decode()}"
        for each in lists
        if sum(map(draws, each.named_children)) > 1
    ]


@pytest.mark.parametrize("file", LADDERS, ids=[f"{file.parent.name}" for file in LADDERS])
def test_a_ladder_draws_in_one_order(file: Path) -> None:
    assert in_any_order(file.read_bytes()) == []


def test_it_sees_what_has_no_order_and_nothing_else() -> None:
    wrong = b"const Point p(random.uniform(0, 1), random.integer(2, 3)); f(g(random), h(random));"
    assert len(in_any_order(wrong)) == 2
    right = b"const Point p{random.uniform(0, 1), random.integer(2, 3)}; f(random, g(random));"
    assert in_any_order(right) == []
