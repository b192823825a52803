"""HTML pages: one file each, without scripts or downloads, with every text escaped by the
engine."""

from __future__ import annotations

import functools
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from reports.words import STATUS_WORDS, UNIT_WORDS, of, points_text

TEMPLATES = Path(__file__).with_name("templates")


@functools.cache
def _environment() -> Environment:
    environment = Environment(
        loader=FileSystemLoader(TEMPLATES),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters["points"] = points_text
    environment.globals["of"] = of
    environment.globals["STATUS_WORDS"] = STATUS_WORDS
    environment.globals["UNIT_WORDS"] = UNIT_WORDS
    return environment


def render(template: str, **values: object) -> str:
    """The page of this template."""
    return _environment().get_template(template).render(**values)
