"""Inputs that grow without bound, as an attacker would make them: each as long as asked."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
EXERCISE = "02_triangles/ray_triangle"
FILE = f"{EXERCISE}.cpp"


def field(text: str | bytes) -> bytes:
    data = text if isinstance(text, bytes) else text.encode()
    return b"%d\n%b" % (len(data), data)


def question(source: str, log: str, step: str = "compile") -> bytes:
    """What contact-explain is asked, as grading/diagnosis/explain_request.cpp writes it."""
    headers = (
        f"exercises/{EXERCISE}/ray_triangle.hpp",
        "chapters/00_vectors/contact/shapes.hpp",
    )
    fields = [step, "failed", "displayed", FILE, source, log, ""]
    for header in headers:
        fields += [header, (ROOT / header).read_text()]
    return b"".join(map(field, fields))


def error(line: int, column: int, message: str, kind: str = "error") -> str:
    return f"{FILE}:{line}:{column}: {kind}: {message}\n"


STRAY = "stray '@' in program"
NESTED = "a function-definition is not allowed here before '{' token"
UNKNOWN = "'x' was not declared in this scope"
NO_MATCH = "no matching function for call to 'f(int)'"


def _forged_steps(n: int) -> tuple[str, str]:
    step = f"{FILE}:400000000:400000000:   required from here\n"
    return "int x;\n", step * (n // len(step)) + error(1, 400000000, UNKNOWN)


# Each gives a source and a log that together are about n bytes long.
SHAPES: dict[str, Callable[[int], tuple[str, str]]] = {
    "blanks before a stray sign": lambda n: (" " * n + "@", error(1, 1, STRAY)),
    "blanks before braces": lambda n: (
        " " * (n // 2) + "{" * (n // 2),
        error(1, n // 2 + 1, "expected '}' at end of input"),
    ),
    "a function within a function": lambda n: (
        "void f() {\n" + "\n" * n + "void g() {\n",
        error(n + 2, 10, NESTED),
    ),
    "a renumbered function within a function": lambda n: (
        "void f() {\n#line 2147483647\n" + "\n" * n + "void g() {\n",
        error(2147483647, 10, NESTED) + error(-2147483648 % 2**31, 10, NESTED),
    ),
    "#line after #line": lambda n: (
        '#line 2147483640 "x"\n' * (n // 21),
        error(2147483641, 1, UNKNOWN) * 50,
    ),
    "nested braces": lambda n: ("{" * n, error(1, 1, NESTED)),
    "closing braces in lines": lambda n: (
        "{\n" * (n // 4) + "}\n" * (n // 4),
        error(n // 2, 1, "expected '}' at end of input"),
    ),
    "a long namespace with many functions": lambda n: (
        f"namespace {'a' * (n // 2)} {{\n" + "void f() {}\n" * (n // 24) + "}",
        error(2, 1, UNKNOWN),
    ),
    "nested namespaces with functions": lambda n: (
        "namespace a {" * (n // 26) + "void f() {}" * (n // 22),
        error(1, 3, UNKNOWN),
    ),
    "one long name": lambda n: (
        "int " + "a" * n + ";",
        error(1, 5, f"'{'a' * 3000}' was not declared in this scope"),
    ),
    "a head without an end": lambda n: ("void f(" + "int a, " * (n // 7), error(1, 9, UNKNOWN)),
    "comments that open and do not close": lambda n: (
        "void f(/*" + "/*" * (n // 2) + ") {",
        error(1, 3, UNKNOWN),
    ),
    "commented parameters": lambda n: (
        "void f(" + "/* x\n" * (n // 5) + "*/) { x; }",
        error(n // 5, 1, UNKNOWN),
    ),
    "quotes": lambda n: (
        "\"'" * (n // 2),
        error(1, 1, 'missing terminating " character', "warning"),
    ),
    "empty lines": lambda n: ("\n" * n, error(n, 1, "expected ';' before '}' token") * 50),
    "backslashes": lambda n: ("#\\\n" * (n // 3), error(n // 3, 1, UNKNOWN)),
    "letters that are no ASCII": lambda n: ("é" * (n // 2), error(1, n // 2, STRAY)),
    "messages without an end": lambda n: (
        "int x;\n" * (n // 14),
        error(2, 5, UNKNOWN) * (n // 120),
    ),
    "notes without an end": lambda n: (
        "int x;\n" * 10,
        error(2, 5, NO_MATCH) + error(2, 5, "candidate: 'f'", "note") * (n // 60),
    ),
    "a message of brackets": lambda n: (
        "int x;\n",
        error(1, 5, "cannot convert '" + "Matrix<" * (n // 7) + "' to 'int'"),
    ),
    "a message of quotes": lambda n: (
        "int x;\n",
        error(1, 5, "no match for 'operator" + "' (operand types are '" * (n // 22)),
    ),
    "a message that is hardly a rule's": lambda n: (
        "int x;\n",
        error(1, 5, NO_MATCH)
        + error(1, 5, "candidate expects " * (n // 40) + " argument" * (n // 20), "note"),
    ),
    "forged steps": _forged_steps,
    "carets without an end": lambda n: (
        "int x;\n",
        error(1, 5, UNKNOWN) + "    | " + " " * n + "^\n",
    ),
}

LINK_SHAPES: dict[str, Callable[[int], tuple[str, str]]] = {
    "symbols without an end": lambda n: (
        "void f() {}\n" * (n // 24),
        "".join(f"mold: error: undefined symbol: exercise::f{i}(int)\n" for i in range(n // 90)),
    ),
    "a symbol of brackets": lambda n: (
        "void f() {}\n",
        "mold: error: undefined symbol: f" + "(" * n + ")" * n + "\n",
    ),
    "a symbol of colons": lambda n: (
        "void f() {}\n",
        "mold: error: duplicate symbol: " + ": " * n + "\n",
    ),
}


def questions(n: int) -> dict[str, bytes]:
    made = {name: question(*shape(n)) for name, shape in SHAPES.items()}
    return made | {name: question(*shape(n), "link") for name, shape in LINK_SHAPES.items()}
