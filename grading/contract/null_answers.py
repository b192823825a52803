"""Writes a null answer to a contract: it computes nothing, so it must earn no points.

    null_answers.py CONTRACT.hpp --output FOLDER

FOLDER gets null.cpp. In it every function of the contract is defined and returns a value of its
result's type, made by grading/contract/null_answers.hpp, which also lists the kinds.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from contract_generator import NAMESPACE, Function, may_lack_input, read_contract


def body(function: Function) -> str:
    names = "".join(f", {parameter.name}" for parameter in function.parameters)
    return f"return contact::null_answer<{function.result}>(0{names});"


def answer(contract: Path) -> str:
    """The whole source file."""
    read = read_contract(contract.read_bytes(), may_lack_input=may_lack_input(contract))
    functions = "\n\n".join(
        f"{function.declared()} {{\n  {body(function)}\n}}" for function in read
    )
    return (
        f'#include "{contract.name}"\n\n#include "contract/null_answers.hpp"\n\n'
        f"namespace {NAMESPACE} {{\n\n{functions}\n\n}}  // namespace {NAMESPACE}\n"
    )


def main() -> None:
    options = argparse.ArgumentParser(description="Write an answer that knows nothing.")
    options.add_argument("contract", type=Path)
    options.add_argument("--output", type=Path, required=True, help="folder for null.cpp")
    arguments = options.parse_args()
    (arguments.output / "null.cpp").write_text(answer(arguments.contract))


if __name__ == "__main__":
    main()
