"""Reads TOML, with errors that name the file and the key."""

from __future__ import annotations

from pathlib import Path

from book_json import BookError, Table, parsed

__all__ = ["Table", "read_toml"]


def read_toml(path: Path, where: str) -> Table:
    """The file's table; a syntax error is a BookError that carries the parser's line."""
    try:
        return parsed(path.read_bytes(), where)
    except FileNotFoundError:
        raise BookError(f"{where} does not exist") from None
