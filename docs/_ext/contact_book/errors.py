"""The error for mistakes of an author in the sources of the book."""

from __future__ import annotations

from collections.abc import Iterable

from book_json import BookError

__all__ = ["BookError", "unknown"]


def unknown(what: str, name: str, known: Iterable[str], where: str) -> BookError:
    """An error for a name that does not exist, listing the names that do."""
    names = sorted(known)
    listing = ", ".join(names) if names else "none"
    return BookError(f"unknown {what} '{name}' in {where}; there is: {listing}")
