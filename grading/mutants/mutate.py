"""Mutants of a solution: small changes at the syntax tree, all in one file, one of them in force.

`mutants_of` finds the changes, `switched` writes the file. In it, a changed expression `a < b`
reads `contact_pick(17, MUTANT, ORIGINAL)`, which evaluates one of the two, by the number in the
environment variable CONTACT_MUTANT. So one compilation serves all mutants, and with number 0 the
program is the solution itself.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import tree_sitter_cpp
from tree_sitter import Language, Node, Parser

# What an operator is changed into. `<` against `<=` is the common mistake; `<` against `>` makes
# nearly every program wrong at once, and tells nothing about its tests.
OPERATORS = {
    "+": ("-",),
    "-": ("+",),
    "*": ("/",),
    "/": ("*",),
    "%": ("/",),
    "<": ("<=",),
    "<=": ("<",),
    ">": (">=",),
    ">=": (">",),
    "==": ("!=",),
    "!=": ("==",),
    "&&": ("||",),
    "||": ("&&",),
}
ASSIGNMENTS = {"+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="}
# The ends of the names of functions, and the function that is easily taken instead.
FUNCTIONS = {
    "min": "max",
    "max": "min",
    "sin": "cos",
    "cos": "sin",
    "floor": "ceil",
    "ceil": "floor",
    "any_of": "all_of",
    "all_of": "any_of",
    "none_of": "all_of",
    "min_element": "max_element",
    "max_element": "min_element",
    "norm": "squaredNorm",
    "squaredNorm": "norm",
    "front": "back",
    "back": "front",
}
# Functions of one argument that are easily forgotten: what stays is the argument.
FORGOTTEN = {"abs", "sqrt", "fabs"}
# Functions that give the same if their first arguments, so many, are exchanged.
COMMUTING = {"fma": 2, "hypot": 2}
# Methods whose object and argument are easily exchanged.
EXCHANGED = {"cross"}

# Nodes whose expressions the compiler evaluates, or that are no expressions.
_FIXED = {
    "template_argument_list",
    "array_declarator",
    "case_statement_label",
    "enumerator",
    "static_assert_declaration",
    "preproc_include",
    "preproc_def",
    "comment",
    "string_literal",
    "requires_clause",
    "decltype",
    "type_descriptor",
    "optional_parameter_declaration",
    "concatenated_string",
    "bitfield_clause",
}


@dataclass(frozen=True)
class Mutant:
    """One change: `was`, at a position of the source, becomes `now`."""

    number: int
    start: int
    end: int
    line: int
    what: str
    was: str
    now: str
    statement: bool  # a whole statement is changed, and not an expression

    @property
    def key(self) -> tuple[str, str]:
        return (self.was, self.now)


def flat(text: str) -> str:
    """In one line."""
    return " ".join(text.split())


class _Finder:
    def __init__(self, source: bytes) -> None:
        self.source = source
        self.found: list[Mutant] = []

    def text(self, node: Node) -> str:
        return self.source[node.start_byte : node.end_byte].decode()

    def between(self, start: int, end: int) -> str:
        return self.source[start:end].decode()

    def add(self, node: Node, what: str, now: str, *, statement: bool = False) -> None:
        was = flat(self.text(node))
        if flat(now) == was:
            return
        self.found.append(
            Mutant(
                len(self.found) + 1,
                node.start_byte,
                node.end_byte,
                node.start_point[0] + 1,
                what,
                was,
                flat(now),
                statement,
            )
        )

    def visit(self, node: Node) -> None:
        if node.type in _FIXED or _is_constant(node):
            return
        statement = _is_statement(node)
        if statement:
            self.add(node, "dropped statement", ";", statement=True)
            for child in node.named_children:
                for what, now in self.changes(child):
                    self.add(node, what, f"{now};", statement=True)
        elif not (node.parent and _is_statement(node.parent)):
            for what, now in self.changes(node):
                self.add(node, what, now)
        for child in node.named_children:
            self.visit(child)

    def changes(self, node: Node) -> Iterator[tuple[str, str]]:
        """What the expression could be instead."""
        if node.type == "binary_expression":
            yield from self._operators(node)
        elif node.type == "assignment_expression":
            yield from self._assignment(node)
        elif node.type == "update_expression" and _is_statement(node.parent):
            text = self.text(node)
            yield "sign", text.replace("++", "--") if "++" in text else text.replace("--", "++")
        elif node.type == "unary_expression":
            operator, argument = node.children[0], node.children[-1]
            if self.text(operator) == "-":
                yield "sign", f"({self.text(argument)})"
            elif self.text(operator) == "!":
                yield "condition", f"static_cast<bool>({self.text(argument)})"
        elif node.type == "number_literal":
            yield from self._numbers(self.text(node))
        elif node.type in ("true", "false"):
            yield "constant", "false" if node.type == "true" else "true"
        elif node.type == "call_expression":
            yield from self._call(node)
        elif node.type == "conditional_expression":
            test, yes, no = node.named_children
            yield "swapped branches", f"{self.text(test)} ? {self.text(no)} : {self.text(yes)}"
        elif node.type == "condition_clause" and _drops_a_statement(node):
            pass

    def _operators(self, node: Node) -> Iterator[tuple[str, str]]:
        left, operator, right = node.children
        name = self.text(operator)
        for other in OPERATORS.get(name, ()):
            what = "boundary" if name in ("<", "<=", ">", ">=") else "operator"
            yield (
                what,
                self.between(left.start_byte, operator.start_byte)
                + other
                + self.between(operator.end_byte, right.end_byte),
            )
        if name == "-":
            yield "swapped arguments", f"{_group(self.text(right))} - {_group(self.text(left))}"

    def _assignment(self, node: Node) -> Iterator[tuple[str, str]]:
        left, operator, right = node.children
        other = ASSIGNMENTS.get(self.text(operator))
        if other:
            yield "operator", f"{self.text(left)} {other} {self.text(right)}"

    def _numbers(self, text: str) -> Iterator[tuple[str, str]]:
        try:
            if text.isdecimal():
                number = int(text)
                yield "constant", str(number + 1)
                if number > 0:
                    yield "constant", str(number - 1)
            else:
                value = float(text)
                yield "constant", "1.0" if value == 0 else f"(2 * {text})"
        except ValueError:
            return

    def _call(self, node: Node) -> Iterator[tuple[str, str]]:
        function = node.child_by_field_name("function")
        arguments = node.child_by_field_name("arguments")
        if function is None or arguments is None:
            return
        given = [self.text(one) for one in arguments.named_children if one.type != "comment"]
        called = self.text(function)
        head, tail = called[: -len(called.rpartition("::")[2].rpartition(".")[2])], ""
        tail = called[len(head) :]
        if tail in FUNCTIONS and not (tail in ("norm", "squaredNorm") and _is_against_zero(node)):
            yield "function", f"{head}{FUNCTIONS[tail]}({', '.join(given)})"
        if tail in FORGOTTEN and len(given) == 1:
            yield "function", f"({given[0]})"
        for i in range(len(given) - 1):
            if tail in COMMUTING and i + 1 < COMMUTING[tail]:
                continue
            swapped = [*given[:i], given[i + 1], given[i], *given[i + 2 :]]
            yield "swapped arguments", f"{called}({', '.join(swapped)})"
        if tail in EXCHANGED and len(given) == 1 and head.endswith("."):
            yield "swapped arguments", f"({given[0]}).{tail}({head[:-1]})"


def _group(text: str) -> str:
    return f"({text})" if any(one in text for one in "+-*/?<>= ") else text


def _is_against_zero(node: Node) -> bool:
    """The length of a vector is 0 if and only if its square is, also as both are rounded."""
    parent = node.parent
    if parent is None or parent.type != "binary_expression":
        return False
    left, operator, right = parent.children
    return operator.text in (b"==", b"!=") and any(
        side.text in (b"0", b"0.0") for side in (left, right)
    )


def _is_constant(node: Node) -> bool:
    """Declarations that the compiler evaluates."""
    return node.type == "declaration" and any(
        child.text == b"constexpr" for child in node.children if child.text
    )


def _is_statement(node: Node | None) -> bool:
    return node is not None and node.type in (
        "expression_statement",
        "break_statement",
        "continue_statement",
    )


def _drops_a_statement(node: Node) -> bool:
    parent = node.parent
    return (
        parent is not None
        and parent.type == "if_statement"
        and parent.child_by_field_name("alternative") is None
    )


class _Conditions(_Finder):
    def changes(self, node: Node) -> Iterator[tuple[str, str]]:
        yield from super().changes(node)
        parent = node.parent
        if (
            parent is not None
            and parent.type == "condition_clause"
            and parent.child_by_field_name("value") == node
            and _drops_a_statement(parent)
            and node.type != "declaration"
        ):
            yield "dropped statement", "false"


def tree_of(source: str) -> Node:
    return Parser(Language(tree_sitter_cpp.language())).parse(source.encode()).root_node


def mutants_of(source: str) -> list[Mutant]:
    """All mutants of a solution, numbered from 1 in the order of its text."""
    finder = _Conditions(source.encode())
    finder.visit(tree_of(source))
    return finder.found


PRELUDE = """\
#include <cstdlib>
#include <type_traits>
namespace contact_mutants {
inline const int chosen = [] {
  const char* text = std::getenv("CONTACT_MUTANT");
  return text != nullptr ? std::atoi(text) : 0;
}();
inline bool in_force(int number) { return chosen == number; }
template <class T>
struct Plain {
  using type = T;
};
template <class T>
requires requires { typename T::PlainObject; }
struct Plain<T> {
  using type = typename T::PlainObject;
};
// An expression of Eigen refers to temporaries that end with the lambda.
template <class T>
typename Plain<std::decay_t<T>>::type plain(T&& value) {
  return static_cast<typename Plain<std::decay_t<T>>::type>(static_cast<T&&>(value));
}
template <class Mutated, class Original>
auto pick(int number, Mutated mutated, Original original) -> decltype(original()) {
  using Result = decltype(original());
  if (in_force(number)) return static_cast<Result>(mutated());
  return original();
}
}  // namespace contact_mutants
#define contact_plain(...) contact_mutants::plain(__VA_ARGS__)
"""


def switched(source: str, mutants: list[Mutant]) -> tuple[str, dict[int, set[int]]]:
    """The file with all of the mutants, and which of them are on each of its lines."""
    data = source.encode()
    functions = [(n.start_byte, n.end_byte) for n in _walk(tree_of(source)) if _is_body(n)]
    at: dict[tuple[int, int], list[Mutant]] = {}
    for mutant in mutants:
        at.setdefault((mutant.start, mutant.end), []).append(mutant)
    spans = sorted(at, key=lambda span: (span[0], -span[1]))

    def written(start: int, end: int, inside: list[tuple[int, int]]) -> str:
        text, position = "", start
        while inside:
            span = inside.pop(0)
            nested = []
            while inside and inside[0][1] <= span[1]:
                nested.append(inside.pop(0))
            text += data[position : span[0]].decode()
            text += changed(span, nested)
            position = span[1]
        return text + data[position:end].decode()

    def changed(span: tuple[int, int], nested: list[tuple[int, int]]) -> str:
        original = written(span[0], span[1], nested)
        # Mutants of a statement of which the statement is all: both spans are the same.
        statements = [one for one in at[span] if one.statement]
        text = original
        capture = "[&]" if any(a <= span[0] and span[1] <= b for a, b in functions) else "[]"
        for one in at[span]:
            if one.statement:
                continue
            text = (
                f"contact_mutants::pick({one.number}, {capture} {{ return contact_plain(\n"
                f"/*{one.number}*/ {one.now}\n); }}, {capture} {{ return contact_plain({text}); }})"
            )
        for one in statements:
            text = (
                f"{{ if (contact_mutants::in_force({one.number})) {{\n"
                f"/*{one.number}*/ {one.now}\n}} else {{ {text} }} }}"
            )
        return text

    body = written(0, len(data), spans)
    text = PRELUDE + body
    lines: dict[int, set[int]] = {}
    numbers = {mutant.number for mutant in mutants}
    for line_number, line in enumerate(text.split("\n"), start=1):
        if line.startswith("/*") and line[2 : line.index("*/")].isdecimal():
            number = int(line[2 : line.index("*/")])
            if number in numbers:
                lines.setdefault(line_number, set()).add(number)
    return text, lines


def _walk(node: Node) -> Iterator[Node]:
    yield node
    for child in node.named_children:
        yield from _walk(child)


def _is_body(node: Node) -> bool:
    return node.type == "compound_statement"
