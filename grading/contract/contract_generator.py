"""Reads a contract and writes its proxy and its server.

    contract_generator.py CONTRACT.hpp --proxy OUT.cpp --server OUT.cpp

The contract is an exercise's header. Generated code names its functions and the types
of their parameters, as the header spells them; how a value crosses to another process is deduced
from its type (contact/value.hpp), so nothing about a type is generated. A construct that a contract
must not contain is refused with its line.
"""

from __future__ import annotations

import argparse
import hashlib
import re
import sys
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import tree_sitter_cpp
from tree_sitter import Language, Node, Parser

NAMESPACE = "exercise"

# Words that no type of a contract may contain, and why.
FORBIDDEN_TYPES = {
    "size_t": "its size differs between machines; use int or std::int64_t",
    "ptrdiff_t": "its size differs between machines; use int or std::int64_t",
    "long": "its size differs between machines; use int or std::int64_t",
    "short": "use int",
    "unsigned": "use int or std::int64_t",
    "float": "use double",
    "char": "use std::string or int",
    "auto": "spell the type",
    "void": "a function returns its result",
    "string_view": "it does not own its characters; use std::string",
    "span": "it does not own its elements; use std::vector",
    "function": "a callback cannot cross to another process; describe it by data",
    "unique_ptr": "a pointer cannot cross to another process",
    "shared_ptr": "a pointer cannot cross to another process",
    "map": "use a std::vector of a struct",
    "unordered_map": "its order differs between machines; use a std::vector of a struct",
    "set": "use a std::vector",
    "unordered_set": "its order differs between machines; use a std::vector",
    "pair": "use a struct, whose members have names",
    "tuple": "use a struct, whose members have names",
}


class ContractError(Exception):
    """What a contract must not hold, and where."""

    def __init__(self, node: Node, message: str) -> None:
        super().__init__(message)
        self.line = node.start_point[0] + 1


@dataclass(frozen=True)
class Parameter:
    """One parameter of a function, as the header spells it."""

    type: str
    name: str
    by_reference: bool

    def declared(self) -> str:
        return (
            f"const {self.type}& {self.name}" if self.by_reference else f"{self.type} {self.name}"
        )


@dataclass(frozen=True)
class Function:
    """One function of a contract."""

    name: str
    result: str
    parameters: tuple[Parameter, ...]

    def declared(self) -> str:
        return f"{self.result} {self.name}({', '.join(p.declared() for p in self.parameters)})"


def text(node: Node) -> str:
    """The node's source, with every run of white space as one blank."""
    raw = node.text
    assert raw is not None
    return re.sub(r"\s+", " ", raw.decode()).strip()


def field(node: Node, name: str) -> Node:
    found = node.child_by_field_name(name)
    if found is None:
        raise ContractError(node, f"cannot read `{text(node)}`")
    return found


def check_type(node: Node, spelled: str) -> None:
    for word in re.findall(r"\w+", spelled):
        if word in FORBIDDEN_TYPES:
            raise ContractError(
                node, f"`{spelled}`: no `{word}` in a contract: {FORBIDDEN_TYPES[word]}"
            )
        if re.fullmatch(r"u?int(8|16|32|_\w+)_t|uint64_t|\w+ptr_t", word):
            raise ContractError(
                node, f"`{spelled}`: no `{word}` in a contract: use int or std::int64_t"
            )
    if re.search(r"[*&]", spelled):
        raise ContractError(
            node, f"`{spelled}`: no pointer or reference inside a type of a contract"
        )


def read_parameter(node: Node) -> Parameter:
    if node.type == "optional_parameter_declaration":
        raise ContractError(node, f"`{text(node)}`: a parameter of a contract has no default")
    if node.type != "parameter_declaration":
        raise ContractError(node, f"`{text(node)}`: not a plain parameter")
    spelled = text(field(node, "type"))
    qualifiers = [text(child) for child in node.children if child.type == "type_qualifier"]
    declarator = node.child_by_field_name("declarator")
    if declarator is None:
        raise ContractError(
            node,
            f"`{text(node)}`: name the parameter, for the reader and for the report of a failure",
        )
    by_reference = declarator.type == "reference_declarator"
    if by_reference:
        if text(declarator).startswith("&&"):
            raise ContractError(node, f"`{text(node)}`: take it by value or by const reference")
        if "const" not in qualifiers:
            raise ContractError(
                node, f"`{text(node)}`: a reference must be const; results are returned"
            )
        declarator = declarator.named_children[0]
    if declarator.type != "identifier":
        raise ContractError(node, f"`{text(node)}`: no pointer, array or function as a parameter")
    check_type(node, spelled)
    return Parameter(spelled, text(declarator), by_reference)


def read_function(node: Node, may_lack_input: bool) -> Function:
    declarator = field(node, "declarator")
    if declarator.type in ("pointer_declarator", "reference_declarator"):
        raise ContractError(
            node, f"`{text(node)}`: a contract returns a value, not a pointer or a reference"
        )
    if declarator.type != "function_declarator":
        raise ContractError(
            node, f"`{text(node)}`: a contract declares functions and types, no variables"
        )
    for child in node.children:
        if child.type in ("storage_class_specifier", "attribute_declaration", "virtual"):
            raise ContractError(node, f"`{text(child)}` on a function of a contract")
    for child in declarator.children:
        if child.type in ("noexcept", "throw_specifier"):
            raise ContractError(
                node, "a function of a contract is not noexcept: todo() must get out of it"
            )
        if child.type == "trailing_return_type":
            raise ContractError(node, "write the result's type before the function's name")
    result = text(field(node, "type"))
    if any(child.type == "type_qualifier" for child in node.children):
        raise ContractError(
            node, f"`{text(node)}`: return a plain value, without const or constexpr"
        )
    check_type(node, result)
    name = field(declarator, "declarator")
    if name.type != "identifier":
        raise ContractError(node, f"`{text(name)}`: a plain name, please")
    parameters = [
        child for child in field(declarator, "parameters").named_children if child.type != "comment"
    ]
    if not parameters and not may_lack_input:
        raise ContractError(
            node, f"`{text(node)}`: a function without input has one answer; ask a question instead"
        )
    return Function(text(name), result, tuple(read_parameter(p) for p in parameters))


def check_struct(node: Node) -> None:
    """A struct is plain data. Whether its types may cross is for the compiler to decide."""
    body = node.child_by_field_name("body")
    if body is None:
        raise ContractError(node, f"`{text(node)}`: define the type, so that its values can cross")
    for member in body.named_children:
        if member.type == "comment":
            continue
        if member.type != "field_declaration":
            raise ContractError(
                member,
                f"`{text(member)}`: a struct of a contract has public members and nothing else",
            )
        for child in member.children:
            if child.type == "storage_class_specifier":
                raise ContractError(member, f"`{text(member)}`: no static member")
        declarators = member.children_by_field_name("declarator")
        for declarator in declarators:
            if declarator.type != "field_identifier":
                raise ContractError(
                    member,
                    f"`{text(member)}`: no pointer, array, reference or function as a member",
                )
        check_type(member, text(field(member, "type")))


def declarations(node: Node) -> Iterator[Node]:
    """What a contract's namespace declares; raises for what it must not."""
    for child in node.named_children:
        match child.type:
            case (
                "comment"
                | "preproc_include"
                | "preproc_call"
                | "using_declaration"
                | "alias_declaration"
            ):
                continue
            case "static_assert_declaration":
                continue
            case "declaration":
                yield child
            case "class_specifier":
                raise ContractError(child, "a struct, please: a contract's types are plain data")
            case "struct_specifier":
                check_struct(child)
            case "enum_specifier":
                if not text(child).startswith("enum class"):
                    raise ContractError(
                        child, "an enum class, please: any other may not hold what is read into it"
                    )
            case "function_definition":
                raise ContractError(
                    child, "a contract declares its functions; the student defines them"
                )
            case "template_declaration":
                raise ContractError(
                    child, "no templates: the tests are compiled once, against plain functions"
                )
            case "preproc_def" | "preproc_function_def":
                raise ContractError(child, "no macros in a contract")
            case _:
                raise ContractError(
                    child, f"`{text(child)[:60]}`: a contract holds types and functions only"
                )


def may_lack_input(contract: Path) -> bool:
    """Whether the answer is itself an input, as in an exercise that breaks code."""
    described = contract.parent / "exercise.toml"
    if not described.is_file():
        return False
    return bool(tomllib.loads(described.read_text(encoding="utf-8")).get("breaks"))


def read_contract(source: bytes, *, may_lack_input: bool = False) -> list[Function]:
    """The functions of a contract, in order."""
    root = Parser(Language(tree_sitter_cpp.language())).parse(source).root_node
    broken = next(walk_errors(root), None)
    if broken is not None:
        raise ContractError(broken, f"cannot read `{text(broken)[:60]}`")
    includes = [text(field(n, "path")) for n in root.named_children if n.type == "preproc_include"]
    if not includes or includes[0] != "<contact/prelude.hpp>":
        raise ContractError(root, "the first include of a contract is <contact/prelude.hpp>")
    namespaces = []
    for child in root.named_children:
        match child.type:
            case "comment" | "preproc_include" | "preproc_call":
                continue
            case "namespace_definition":
                namespaces.append(child)
            case _:
                raise ContractError(
                    child, f"everything in a contract is in `namespace {NAMESPACE}`"
                )
    if len(namespaces) != 1 or text(field(namespaces[0], "name")) != NAMESPACE:
        raise ContractError(root, f"a contract has one namespace, `{NAMESPACE}`")
    functions: list[Function] = []
    for node in declarations(field(namespaces[0], "body")):
        if field(node, "declarator").type == "init_declarator":
            raise ContractError(
                node, f"`{text(node)}`: a contract declares functions and types, no variables"
            )
        function = read_function(node, may_lack_input)
        if any(function.name == earlier.name for earlier in functions):
            raise ContractError(
                node, f"`{function.name}` is overloaded; give each function a name of its own"
            )
        functions.append(function)
    if not functions:
        raise ContractError(root, "a contract declares at least one function")
    return functions


def walk_errors(node: Node) -> Iterator[Node]:
    if node.type == "ERROR" or node.is_missing:
        yield node
    elif node.has_error:
        for child in node.children:
            yield from walk_errors(child)


def fingerprint(functions: list[Function]) -> str:
    declared = ";".join(f.declared() for f in functions)
    return "0x" + hashlib.sha256(declared.encode()).hexdigest()[:16]


def head(header: Path, functions: list[Function], what: str) -> str:
    checks = "\n".join(
        f"static_assert(contact::remote::crosses<decltype(&{f.name})>,\n"
        f'              "every type of {f.name} must be a contact::Value");'
        for f in functions
    )
    return f"""// The {what} of {header.name}, made by contract_generator.py: do not edit.
#include "{header.name}"

#include <contact/remote.hpp>

namespace {NAMESPACE} {{
namespace {{

constexpr contact::remote::Contract kContract{{"{header.stem}", {fingerprint(functions)}}};
{checks}

}}  // namespace
"""


def call_arguments(index: int, function: Function) -> list[str]:
    return ["kContract", str(index), *(p.name for p in function.parameters)]


def proxy(header: Path, functions: list[Function]) -> str:
    bodies = "\n".join(
        f"{f.declared()} {{\n"
        f"  return contact::remote::call<{f.result}>({', '.join(call_arguments(i, f))});\n"
        f"}}\n"
        for i, f in enumerate(functions)
    )
    return head(header, functions, "proxy") + f"\n{bodies}\n}}  // namespace {NAMESPACE}\n"


def server(header: Path, functions: list[Function]) -> str:
    handlers = "".join(f"    contact::remote::handler<&{f.name}>,\n" for f in functions)
    return (
        head(header, functions, "server")
        + f"""
int serve() {{
  static constexpr contact::remote::Handler kHandlers[] = {{
{handlers}  }};
  return contact::remote::serve(kContract, kHandlers);
}}

}}  // namespace {NAMESPACE}

int main() {{ return {NAMESPACE}::serve(); }}
"""
    )


def main() -> int:
    options = argparse.ArgumentParser(description="Write a contract's proxy and server.")
    options.add_argument("contract", type=Path)
    options.add_argument("--proxy", type=Path, help="where to write the side of the tests")
    options.add_argument(
        "--server", type=Path, help="where to write the side of the student's code"
    )
    arguments = options.parse_args()
    contract: Path = arguments.contract
    try:
        functions = read_contract(contract.read_bytes(), may_lack_input=may_lack_input(contract))
    except ContractError as error:
        print(f"{contract}:{error.line}: {error}", file=sys.stderr)
        return 1
    for path, generate in ((arguments.proxy, proxy), (arguments.server, server)):
        if path is not None:
            path.write_text(generate(contract, functions), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
