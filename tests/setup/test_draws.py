"""A ladder, or an exercise's test, asks the same questions natively and in the page: its random
draws have one order.

Arguments of a call and operands of an operator are evaluated in any order, and clang's is not
gcc's. In braces it is the order in which they stand.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
import tree_sitter_cpp
from tree_sitter import Language, Node, Parser

ROOT = Path(__file__).resolve().parents[2]
EXERCISES = {folder.name for folder in ROOT.glob("exercises/*/*")}
ASKERS = sorted(
    [
        *ROOT.glob("chapters/*/ladder.cpp"),
        *ROOT.glob("tests/*/families.hpp"),
        *(
            file
            for file in ROOT.glob("tests/[0-9]*/*_test.cpp")
            if file.name.removesuffix("_test.cpp") in EXERCISES
        ),
    ]
)
IN_ORDER = {b"&&", b"||", b",", b"<<", b">>"}
PARSER = Parser(Language(tree_sitter_cpp.language()))


def below(node: Node) -> Iterator[Node]:
    yield node
    for child in node.children:
        yield from below(child)


def draws(node: Node, drawers: set[bytes]) -> bool:
    """Whether evaluating it draws a random number. What a lambda does is done when it is called."""
    if node.type == "lambda_expression":
        return False
    if node.type == "call_expression":
        called = node.child_by_field_name("function")
        if called is not None and called.text in drawers:
            return True
        names = (each for each in below(node) if each.type == "identifier")
        if any(each.text == b"random" for each in names):
            return True
    return any(draws(child, drawers) for child in node.children)


def drawers_of(root: Node) -> set[bytes]:
    """The names of the lambdas that draw."""
    found: set[bytes] = set()
    for each in below(root):
        value = each.child_by_field_name("value") if each.type == "init_declarator" else None
        name = each.child_by_field_name("declarator") if value is not None else None
        body = value.child_by_field_name("body") if value is not None else None
        if value is None or value.type != "lambda_expression" or name is None or body is None:
            continue
        if draws(body, found):
            found.add(name.text or b"")
    return found


def operands(node: Node) -> list[Node]:
    """What is evaluated in any order in this node."""
    if node.type == "argument_list":
        return node.named_children
    if node.type != "binary_expression":
        return []
    operator = node.child_by_field_name("operator")
    return [] if operator is None or operator.text in IN_ORDER else node.named_children


def in_any_order(source: bytes) -> list[str]:
    """The nodes of which more than one operand draws."""
    root = PARSER.parse(source).root_node
    drawers = drawers_of(root)
    return [
        f"line {each.start_point.row + 1}: {(each.text or b'').decode()}"
        for each in below(root)
        if sum(draws(operand, drawers) for operand in operands(each)) > 1
    ]


@pytest.mark.parametrize("file", ASKERS, ids=[f"{file.parent.name}/{file.name}" for file in ASKERS])
def test_random_draws_have_one_order(file: Path) -> None:
    assert in_any_order(file.read_bytes()) == []


@pytest.mark.parametrize(
    "wrong",
    [
        "const Point p(random.uniform(0, 1), random.integer(2, 3));",
        "f(g(random), h(random));",
        "const double x = random.uniform(0, 1) + 2 * random.uniform(0, 1);",
        "const auto v = [&](double s) { return random.uniform(0, s); }; f(a + v(1), v(2));",
        "const auto v = [&](double s) { return random.uniform(0, s); }; x = v(1) - v(2);",
    ],
)
def test_it_sees_what_has_no_order(wrong: str) -> None:
    assert in_any_order(wrong.encode())


@pytest.mark.parametrize(
    "right",
    [
        "const Point p{random.uniform(0, 1), random.integer(2, 3)};",
        "f(random, g(random));",
        "const bool b = random.chance(0.5) && random.chance(0.5);",
        "const auto v = [&] { return random.uniform(0, 1); }; const P a = v(), b = v();",
    ],
)
def test_it_lets_pass_what_has_an_order(right: str) -> None:
    assert in_any_order(right.encode()) == []
