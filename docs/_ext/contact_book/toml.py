"""Reading TOML with errors that say which file and key is wrong."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from contact_book.errors import BookError

T = TypeVar("T")


@dataclass(frozen=True)
class Table:
    """A TOML table that knows where it came from."""

    data: dict[str, Any]
    where: str

    def get(self, key: str, kind: type[T], default: T) -> T:
        """The value at `key`, or `default` if it is absent."""
        if key not in self.data:
            return default
        return self.need(key, kind)

    def need(self, key: str, kind: type[T]) -> T:
        """The value at `key`, which must be there and of this kind."""
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


def read_toml(path: Path, where: str) -> Table:
    """The file's table; a syntax error is a BookError that carries the parser's line."""
    try:
        return Table(tomllib.loads(path.read_text(encoding="utf-8")), where)
    except FileNotFoundError:
        raise BookError(f"{where} does not exist") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise BookError(f"{where}: {error}") from None
