"""build/book.json: what chapter.toml, exercise.toml and misconceptions.toml say, read once.

    book_json.py [--root ROOT]   brings ROOT/build/book.json up to date and prints where it is

The book's extension of Sphinx, the page's scripts and the tools read this file, and ask for it
here: it is written again when a file that it was made from has changed, appeared or disappeared,
and otherwise left unchanged. It needs only Python.

A file with a mistake has no entry; `problems` describes the mistake under the file's name, and the
other files can still be read. CONTRIBUTING.md lists the programs that read the files themselves.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import sys
import tempfile
import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, TypeVar

ROOT = Path(__file__).resolve().parents[2]
FORMAT = "contact-registry/1"
PARTS = 4
TIME_LIMIT = 5.0  # seconds that one test may take, as grading's book.hpp has it
SOLUTION_SECONDS = 0.05  # that a solution needs at most in a test that does not say, as there
STATUSES = ("lesson", "reference")
MISCONCEPTIONS = "chapters/misconceptions.toml"

T = TypeVar("T")
Json = dict[str, Any]


class BookError(Exception):
    """A mistake in the book's sources, described for its author."""


class Table:
    """A table of TOML that knows where it came from, and which of its keys are asked for."""

    def __init__(self, data: Mapping[str, Any], where: str) -> None:
        self.data = data
        self.where = where
        self._asked: set[str] = set()

    def get(self, key: str, kind: type[T], default: T) -> T:
        """The value at `key`, or `default` if it is absent."""
        self._asked.add(key)
        return self.need(key, kind) if key in self.data else default

    def need(self, key: str, kind: type[T]) -> T:
        """The value at `key`, which must be there and of this kind."""
        self._asked.add(key)
        if key not in self.data:
            raise BookError(f"{self.where}: '{key}' is missing")
        value = self.data[key]
        if kind is float and isinstance(value, int) and not isinstance(value, bool):
            value = float(value)
        if not isinstance(value, kind) or (kind is int and isinstance(value, bool)):
            raise BookError(
                f"{self.where}: '{key}' should be {kind.__name__}, not {type(value).__name__}"
            )
        return value

    def strings(self, key: str) -> list[str]:
        """A list of strings, empty if absent."""
        values: list[Any] = self.get(key, list, [])
        for value in values:
            if not isinstance(value, str):
                raise BookError(f"{self.where}: '{key}' should hold strings, not {value!r}")
        return list(values)

    def tables(self, key: str) -> list[Table]:
        """A list of tables, empty if absent."""
        rows: list[Any] = self.get(key, list, [])
        for row in rows:
            if not isinstance(row, dict):
                raise BookError(f"{self.where}: '{key}' should hold tables, not {row!r}")
        return [Table(row, f"{self.where}: {key} {n}") for n, row in enumerate(rows, start=1)]

    def done(self) -> None:
        """A key that was not asked for is a mistake."""
        for key in self.data:
            if key not in self._asked:
                known = ", ".join(sorted(self._asked))
                raise BookError(f"{self.where}: unknown key '{key}'; there is: {known}")


def _chapter(table: Table) -> Json:
    status = table.need("status", str)
    if status not in STATUSES:
        raise BookError(f"{table.where}: status is 'lesson' or 'reference', not '{status}'")
    part = table.need("part", int)
    if not 0 <= part < PARTS:
        raise BookError(f"{table.where}: part is 0 to {PARTS - 1}, not {part}")
    read = {
        "title": table.need("title", str),
        "part": part,
        "status": status,
        "tooltip": table.get("tooltip", str, ""),
        "builds_on": table.strings("builds_on"),
        "in_lesson": table.strings("in_lesson"),
        "recall": table.strings("recall"),
        "exercises": table.strings("exercises"),
        "objectives": _rows(table, "objectives", ("id", "text")),
        "sources": _rows(table, "sources", ("lecture", "topic")),
    }
    table.done()
    return read


def _rows(table: Table, key: str, columns: Sequence[str]) -> list[Json]:
    read = []
    for row in table.tables(key):
        read.append({column: row.need(column, str) for column in columns})
        row.done()
    return read


def _inputs(table: Table) -> list[Json]:
    """What the page's fields begin with: for each function of a contract that breaks code."""
    read = []
    for row in table.tables("inputs"):
        start, taken = row.data.get("start"), row.data.get("from", [])
        for key, value in (("start", start), ("from", taken)):
            if not isinstance(value, list | dict):
                raise BookError(f"{row.where}: '{key}' should be a list or a table")
            row.get(key, type(value), value)
        read.append(
            {
                "function": row.need("function", str),
                "says": row.need("says", str),
                "start": start,
                "figure": row.get("figure", str, ""),
                "from": taken,
            }
        )
        row.done()
    return read


def _exercise(table: Table) -> Json:
    tests = []
    for row in table.tables("tests"):
        test: Json = {"name": row.need("name", str), "points": row.need("points", float)}
        test["requires"] = row.strings("requires")
        test["visibility"] = row.get("visibility", str, "shown")
        test["solution_seconds"] = row.get("solution_seconds", float, SOLUTION_SECONDS)
        row.done()
        tests.append(test)
    if not tests:
        raise BookError(f"{table.where}: an exercise needs at least one test")
    read = {
        "title": table.need("title", str),
        "objective": table.need("objective", str),
        "kind": table.need("kind", str),
        "minutes": table.get("minutes", int, 0),
        "brief": table.need("brief", str),
        "hints": table.strings("hints"),
        "misconceptions": table.strings("misconceptions"),
        "breaks": table.get("breaks", str, ""),
        "inputs": _inputs(table),
        "time_limit": table.get("time_limit", float, TIME_LIMIT),
        "tests": tests,
    }
    table.done()
    return read


def _misconceptions(table: Table) -> Json:
    read = {}
    for name in table.data:
        entry = Table(table.need(name, dict), f"{table.where}: {name}")
        read[name] = {"summary": entry.get("summary", str, ""), "hint": entry.need("hint", str)}
        entry.done()
    return read


def _files(root: Path) -> list[Path]:
    files = [*root.glob("chapters/*/chapter.toml"), *root.glob("exercises/*/*/exercise.toml")]
    return sorted(file for file in [*files, root / MISCONCEPTIONS] if file.is_file())


def parsed(content: bytes, where: str) -> Table:
    """A file's table; a syntax error is a BookError that carries the parser's line."""
    try:
        return Table(tomllib.loads(content.decode()), where)
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise BookError(f"{where}: {error}") from None


def _read(contents: Mapping[str, bytes]) -> Json:
    document: Json = {"chapters": {}, "exercises": {}, "misconceptions": {}, "problems": {}}
    for name, content in contents.items():
        try:
            table = parsed(content, name)
            if name == MISCONCEPTIONS:
                document["misconceptions"] = _misconceptions(table)
            elif name.startswith("chapters/"):
                document["chapters"][name.split("/")[1]] = _chapter(table)
            else:
                _, chapter, exercise, _ = name.split("/")
                document["exercises"][f"{chapter}/{exercise}"] = _exercise(table)
        except BookError as mistake:
            document["problems"][name] = str(mistake)
    return document


def book_json(root: Path = ROOT) -> Json:
    """What the file holds, after it was brought up to date."""
    contents = {file.relative_to(root).as_posix(): file.read_bytes() for file in _files(root)}
    made_from = {name: hashlib.sha256(content).hexdigest() for name, content in contents.items()}
    made_from["this program"] = hashlib.sha256(Path(__file__).read_bytes()).hexdigest()
    output = root / "build" / "book.json"
    try:
        there: Json = json.loads(output.read_text(encoding="utf-8"))
        if there["made_from"] == made_from:
            return there
    except (OSError, ValueError, KeyError, TypeError):
        pass  # It is missing, or no file of this kind.
    document = {"format": FORMAT, "made_from": made_from, **_read(contents)}
    output.parent.mkdir(parents=True, exist_ok=True)
    # Whole or not at all: others read it meanwhile.
    with tempfile.NamedTemporaryFile(
        "w", encoding="utf-8", dir=output.parent, prefix=".book.json.", delete=False
    ) as part:
        json.dump(document, part, ensure_ascii=False, indent=1)
    Path(part.name).chmod(0o644)
    Path(part.name).replace(output)
    return document


def main(words: Sequence[str] | None = None) -> int:
    about, _, _ = (__doc__ or "").partition("\n")
    parser = argparse.ArgumentParser(description=about)
    parser.add_argument("--root", type=Path, default=ROOT)
    root = parser.parse_args(words).root.absolute()
    problems = book_json(root)["problems"]
    print(root / "build" / "book.json")
    for problem in problems.values():
        print(problem, file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
