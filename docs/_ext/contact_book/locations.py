"""Makes warnings name the file that the author edits, not the copy that Sphinx reads."""

from __future__ import annotations

import logging
import re
from pathlib import Path

from sphinx.application import Sphinx

from contact_book.errata import MARKER

_LECTURE = re.compile(r"lectures/\w+\.md:(?P<line>\d+)")
_STAGED = re.compile(r"chapters/(\d\d_[a-z0-9_]+)\.md")


class AuthorsFile(logging.Filter):
    """Rewrites the location of every record that points into the staged sources."""

    def __init__(self, staged: Path) -> None:
        super().__init__()
        self.staged = f"{staged}/"

    def author_name(self, text: str) -> str:
        if not text.startswith(self.staged):
            return text
        inside = text[len(self.staged) :]
        name, count = _STAGED.subn(r"chapters/\1/lesson.md", inside, count=1)
        if count:
            return name
        lecture = _LECTURE.match(inside)
        if lecture:
            return self.in_chapter(inside, int(lecture["line"]))
        return inside if inside.startswith("api/") else f"docs/{inside}"

    def in_chapter(self, inside: str, line: int) -> str:
        """A line of a lecture's page, in the chapter's file that it was taken from."""
        page = Path(self.staged, inside.partition(":")[0]).read_text(encoding="utf-8")
        for before, text in enumerate(reversed(page.splitlines()[:line])):
            if text.startswith(MARKER):
                return f"{text.removeprefix(MARKER)}:{before}"
        return inside

    def filter(self, record: logging.LogRecord) -> bool:
        location = getattr(record, "location", None)
        if isinstance(location, str):
            record.location = self.author_name(location)
        return True


def name_authors_files(app: Sphinx) -> None:
    """Runs after Sphinx's own filters have turned locations into text."""
    for handler in logging.getLogger("sphinx").handlers:
        handler.addFilter(AuthorsFile(Path(app.srcdir)))
