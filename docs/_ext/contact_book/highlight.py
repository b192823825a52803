"""Listings without markup on text in the default colour: names, punctuation and blanks.

They are two thirds of a listing's markup. Keywords, types, functions, literals and comments keep
their colours.
"""

from __future__ import annotations

from pygments.formatters import HtmlFormatter
from pygments.token import Name, Punctuation, Text, Whitespace, _TokenType
from sphinx.highlighting import PygmentsBridge

_PLAIN = {Name, Punctuation, Text, Whitespace}


class PlainInk(HtmlFormatter):  # type: ignore[misc]
    def _get_css_classes(self, ttype: _TokenType) -> str:
        classes: str = super()._get_css_classes(ttype)
        return "" if ttype in _PLAIN else classes


def mark_less() -> None:
    """For every listing that Sphinx writes as HTML."""
    PygmentsBridge.html_formatter = PlainInk
