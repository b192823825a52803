"""The base of all directives of the book: the book, the current chapter, and errors."""

from __future__ import annotations

from pathlib import Path
from typing import Any, ClassVar
from weakref import WeakKeyDictionary

from docutils import nodes
from sphinx.config import Config
from sphinx.environment import BuildEnvironment
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

from contact_book.book import Book
from contact_book.errors import BookError

logger = logging.getLogger(__name__)


# The book of each run of Sphinx: its registry is read once.
_books: WeakKeyDictionary[Config, Book] = WeakKeyDictionary()


def open_book(config: Config) -> Book:
    """The book that this configuration points to, as it was when it was first asked for."""
    if config not in _books:
        _books[config] = Book(Path(config.contact_root), Path(config.contact_products))
    return _books[config]


def slug_of(docname: str) -> str | None:
    """The chapter a document belongs to, or None for pages outside chapters."""
    folder, _, name = docname.partition("/")
    return name if folder in ("chapters", "api") and name[:2].isdigit() else None


def source_of(docname: str) -> str:
    """Where the author finds this document, from the root of the project."""
    slug = slug_of(docname)
    if slug and docname.startswith("chapters/"):
        return f"chapters/{slug}/lesson.md"
    return f"docs/{docname}.md"


# Of a page: folders that it depends on, and files that were not there when it was read. If these
# were dependencies, Sphinx would read the page in every build.
_OTHER = "contact-other-dependencies"

# Names and times of what is in a folder; of a file its time; of neither nothing.
State = tuple[tuple[str, int], ...] | None


def _state(path: Path) -> State:
    if path.is_dir():
        return tuple(sorted((one.name, one.stat().st_mtime_ns) for one in path.iterdir()))
    return ((path.name, path.stat().st_mtime_ns),) if path.exists() else None


def depend(env: BuildEnvironment, path: Path) -> None:
    """The page that is read is stale when this file or folder changes, appears or disappears."""
    if path.is_file():
        env.note_dependency(str(path))
    else:
        env.metadata[env.docname].setdefault(_OTHER, {})[str(path)] = _state(path)


def other_dependencies_changed(env: BuildEnvironment, page: str) -> bool:
    """Whether such a folder or file is not as it was when the page was read."""
    noted: dict[str, State] = env.metadata[page].get(_OTHER, {})
    return any(_state(Path(path)) != state for path, state in noted.items())


class BookDirective(SphinxDirective):
    """A directive whose mistakes are reported against the author's own file."""

    required_arguments = 0
    optional_arguments = 0
    final_argument_whitespace = True
    has_content = False
    option_spec: ClassVar[dict[str, Any]] = {}

    def build(self) -> list[nodes.Node]:
        """The nodes; raises BookError when the author's words cannot be honoured."""
        raise NotImplementedError

    def run(self) -> list[nodes.Node]:
        try:
            return self.build()
        except BookError as error:
            place = f"{source_of(self.env.docname)}:{self.lineno}"
            logger.error("%s: %s", self.name, error, location=place, type="contact")
            return [nodes.error("", nodes.paragraph("", str(error)))]

    @property
    def book(self) -> Book:
        return open_book(self.config)

    @property
    def here(self) -> str | None:
        return slug_of(self.env.docname)

    @property
    def source(self) -> str:
        return source_of(self.env.docname)

    def depends(self, *paths: Path) -> None:
        """The page is stale when one of these changes, appears or disappears."""
        for path in paths:
            depend(self.env, path)

    def missing_product(self, message: str) -> None:
        """A thing the build makes is not there: an error only when the build should be complete."""
        if self.config.contact_complete:
            raise BookError(message)
        self.env.metadata[self.env.docname]["contact-incomplete"] = "yes"

    def missing_figure(self, message: str) -> None:
        """The same, for what the checks build by turns: then the page may stay as it is."""
        if not self.config.contact_some_figures:
            self.missing_product(message)

    def needs_script(self) -> None:
        """This page has components that the page's script brings to life."""
        self.env.metadata[self.env.docname]["contact-components"] = "yes"

    def markdown(self, text: str) -> list[nodes.Node]:
        """Parsed MyST, as block content."""
        return self.parse_text_to_nodes(text.strip())

    def inline_markdown(self, text: str) -> list[nodes.Node]:
        """Parsed MyST; a lone paragraph gives its inline content."""
        parsed = self.markdown(text)
        if len(parsed) != 1 or not isinstance(parsed[0], nodes.paragraph):
            return parsed
        content = list(parsed[0].children)
        # A target must stand in text: anywhere else it would name what follows it.
        named = any(isinstance(node, nodes.target) for node in content)
        return [nodes.inline("", "", *content)] if named else content
