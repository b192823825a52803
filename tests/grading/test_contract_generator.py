"""What a contract may hold, and that whatever else is refused with its line."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[2]


def load() -> ModuleType:
    spec = importlib.util.spec_from_file_location(
        "contract_generator", ROOT / "grading" / "contract" / "contract_generator.py"
    )
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["contract_generator"] = module
    spec.loader.exec_module(module)
    return module


generator = load()

HEAD = "#pragma once\n#include <contact/prelude.hpp>\n\nnamespace exercise {\n"


def contract(body: str) -> bytes:
    return f"{HEAD}{body}\n}}  // namespace exercise\n".encode()


def test_reads_functions_as_they_are_spelled() -> None:
    functions = generator.read_contract(
        contract(
            """
/// A comment.
enum class Side { back, front };
struct Pair { double a = 0; std::vector<int> b; };
std::optional<Pair> one(const Pair& pair, int count);
Side two(double x);  // another
"""
        )
    )
    assert [f.declared() for f in functions] == [
        "std::optional<Pair> one(const Pair& pair, int count)",
        "Side two(double x)",
    ]


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ("template <class T> T f(T x);", "no templates"),
        ("double f(double* x);", "no pointer"),
        ("double f(double& x);", "must be const"),
        ("double f(double&& x);", "by value or by const reference"),
        ("double f(double x);\ndouble f(int x);", "overloaded"),
        ("double f(std::size_t n);", "no `size_t`"),
        ("double f(long n);", "no `long`"),
        ("double f(unsigned n);", "no `unsigned`"),
        ("double f(float x);", "no `float`"),
        ("double f(std::uint32_t n);", "no `uint32_t`"),
        ("double f(double x = 1);", "no default"),
        ("double f(double);", "name the parameter"),
        ("double f(std::vector<const double*> x);", "no pointer"),
        ("double f(std::string_view s);", "no `string_view`"),
        ("double f(std::function<double(double)> g);", "callback"),
        ("double f(double x[3]);", "no pointer, array"),
        ("double* f(double x);", "not a pointer"),
        ("const double& f(double x);", "not a pointer or a reference"),
        ("void f(double x);", "no `void`"),
        ("auto f(double x) -> double;", "before the function's name"),
        ("double f(double x) noexcept;", "noexcept"),
        ("double f();", "without input"),
        ("inline double f(double x) { return x; }", "the student defines"),
        ("extern int counter;", "no variables"),
        ("int counter = 0;", "no variables"),
        ("class C { int x; };\ndouble f(C c);", "a struct, please"),
        ("struct S { S(); int x; };\ndouble f(S s);", "public members and nothing else"),
        ("struct S { int x; private: int y; };\ndouble f(S s);", "public members"),
        ("struct S { int* x; };\ndouble f(S s);", "no pointer"),
        ("struct S { float x; };\ndouble f(S s);", "no `float`"),
        ("enum Side { back };\ndouble f(Side s);", "enum class"),
        ("#define N 3\ndouble f(double x);", "no macros"),
        ("struct S { int x; };", "at least one function"),
        ("double f(double x;", "cannot read"),
    ],
)
def test_refuses(body: str, words: str) -> None:
    with pytest.raises(generator.ContractError, match=words.replace("(", r"\(")) as error:
        generator.read_contract(contract(body))
    assert error.value.line >= 1


def test_a_contract_begins_with_the_prelude() -> None:
    with pytest.raises(generator.ContractError, match="first include"):
        generator.read_contract(b"namespace exercise { double f(double x); }")


def test_everything_is_in_one_namespace() -> None:
    source = contract("double f(double x);") + b"double g(double x);\n"
    with pytest.raises(generator.ContractError, match="namespace exercise"):
        generator.read_contract(source)


def test_the_fingerprint_follows_the_declarations() -> None:
    def of(body: str) -> str:
        result: str = generator.fingerprint(generator.read_contract(contract(body)))
        return result

    assert of("double f(double x);") == of("/// Text.\ndouble f( double  x );")
    assert of("double f(double x);") != of("double f(int x);")


CONTRACTS = sorted(
    toml.parent / f"{toml.parent.name}.hpp" for toml in ROOT.glob("exercises/*/*/exercise.toml")
)


@pytest.mark.parametrize("header", CONTRACTS, ids=lambda p: p.stem)
def test_every_contract_of_the_book_is_read(header: Path) -> None:
    assert generator.read_contract(
        header.read_bytes(), may_lack_input=generator.may_lack_input(header)
    )


def test_only_an_exercise_that_breaks_code_asks_for_an_input(tmp_path: Path) -> None:
    source = contract("std::vector<double> row();")
    with pytest.raises(generator.ContractError, match="one answer"):
        generator.read_contract(source)
    (function,) = generator.read_contract(source, may_lack_input=True)
    assert function.declared() == "std::vector<double> row()"
    header = tmp_path / "row.hpp"
    header.write_bytes(source)
    assert not generator.may_lack_input(header)
    (tmp_path / "exercise.toml").write_text('kind = "blank"\n')
    assert not generator.may_lack_input(header)
    (tmp_path / "exercise.toml").write_text('kind = "break"\nbreaks = "given.hpp"\n')
    assert generator.may_lack_input(header)
