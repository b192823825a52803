"""Writes answers to a contract that know nothing: what they earn, everybody earns.

    build_null_answers.py CONTRACT.hpp --output FOLDER

FOLDER gets one file a kind: zeros, nan, infinity, minus_infinity, huge, random, echo. In each,
every function of the contract is defined and returns such a value of its result's type, made by
grading/build_null_answers.hpp, or, for echo, the first argument that has that type.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from contract_generator import NAMESPACE, Function, read_contract

KINDS = ("zeros", "nan", "infinity", "minus_infinity", "huge", "random", "echo")


def body(function: Function, kind: str) -> str:
    names = "".join(f", {parameter.name}" for parameter in function.parameters)
    return f"return contact::null_answer<{function.result}, contact::Null::{kind}>(0{names});"


def answer(contract: Path, kind: str) -> str:
    """The whole source file."""
    functions = "\n\n".join(
        f"{function.declared()} {{\n  {body(function, kind)}\n}}"
        for function in read_contract(contract.read_bytes())
    )
    return (
        f'#include "{contract.name}"\n\n#include "build_null_answers.hpp"\n\n'
        f"namespace {NAMESPACE} {{\n\n{functions}\n\n}}  // namespace {NAMESPACE}\n"
    )


def main() -> None:
    options = argparse.ArgumentParser(description="Write an answer that knows nothing.")
    options.add_argument("contract", type=Path)
    options.add_argument(
        "--output", type=Path, required=True, help="folder for KIND.cpp of every kind"
    )
    arguments = options.parse_args()
    for kind in KINDS:
        (arguments.output / f"{kind}.cpp").write_text(answer(arguments.contract, kind))


if __name__ == "__main__":
    main()
