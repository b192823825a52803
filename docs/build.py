#!/usr/bin/env python3
"""Builds the book: measurements, Doxygen, staged pages, Sphinx. Rebuilds only what is out of date.

build/venv/bin/python docs/build.py             with whatever is built already
build/venv/bin/python docs/build.py --complete  everything a page shows must be there;
    with --some-figures, but for live figures, their pictures and the scene player
build/venv/bin/python docs/build.py --builder epub  the book as one file, beside the pages
"""

from __future__ import annotations

import argparse
import os
import shutil
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

DOCS = Path(__file__).resolve().parent
sys.path[:0] = [str(DOCS / "_ext"), str(DOCS.parent / "grading" / "book")]

from contact_book.book import Book  # noqa: E402
from contact_book.doxygen import run_doxygen  # noqa: E402
from contact_book.errors import BookError  # noqa: E402
from contact_book.products import run_programs  # noqa: E402
from contact_book.run import EBOOK, run_sphinx  # noqa: E402
from contact_book.stage import stage  # noqa: E402


class Steps:
    """Says which step is running, and how long the last one took."""

    def __init__(self) -> None:
        self.began = self.last = time.monotonic()

    def say(self, words: str) -> None:
        now = time.monotonic()
        print(f"[{now - self.began:5.1f} s] {words}", flush=True)


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description="Build the book.")
    parser.add_argument("--root", type=Path, default=DOCS.parent, help="the project's root")
    parser.add_argument(
        "--build", type=Path, help="where everything is built (default: ROOT/build)"
    )
    parser.add_argument(
        "--site", type=Path, help="where the pages go (default: BUILD/site, or BUILD/epub)"
    )
    parser.add_argument("--web", type=Path, help="the built components (default: BUILD/web)")
    parser.add_argument("--programs", type=Path, help="built programs (default: BUILD/dev/bin)")
    parser.add_argument("--complete", action="store_true", help="fail if a product is missing")
    parser.add_argument(
        "--some-figures", action="store_true", help="with --complete: not all figures must be built"
    )
    parser.add_argument(
        "--skip-api", action="store_true", help="leave Doxygen out of the API pages"
    )
    parser.add_argument("--builder", default="html", choices=["html", "epub", "linkcheck"])
    return parser.parse_args()


def api(book: Book, target: Path, strict: bool) -> str:
    return run_doxygen(book, DOCS / "Doxyfile.in", target, strict=strict)


def page_names(staged: Path) -> set[str]:
    return {path.relative_to(staged).as_posix() for path in staged.rglob("*.md")}


def build(options: argparse.Namespace) -> int:
    root: Path = options.root.resolve()
    made: Path = (options.build or root / "build").resolve()
    kind = "site" if options.builder == "html" else options.builder
    site: Path = (options.site or made / kind).resolve()
    web: Path = (options.web or made / "web").resolve()
    book = Book(root, made / "docs-data")
    steps = Steps()
    steps.say("reading what the chapters' programs say")
    programs: Path = (options.programs or made / "dev" / "bin").resolve()
    # Each has a core to itself.
    with ThreadPoolExecutor(1) as beside:
        documented = (
            None
            if options.skip_api
            else beside.submit(api, book, made / "doxygen", options.complete)
        )
        for line in run_programs(book, programs):
            steps.say(f"  {line}")
    if documented:
        steps.say("Doxygen: " + documented.result())
    before = page_names(made / "docs-src")
    written = stage(book, root / "docs", made / "docs-src", api=not options.skip_api)
    # Every page's sidebar names all pages. And if an earlier run was stopped before it wrote its
    # search index, Sphinx has read the pages but would index only those that it writes now.
    every_page = page_names(made / "docs-src") != before
    every_page |= kind == "site" and not (site / "searchindex.js").exists()
    steps.say(f"pages changed: {', '.join(written) or 'none'}")
    environment = os.environ | {
        "CONTACT_BOOK_ROOT": str(root),
        "CONTACT_BOOK_BUILD": str(made),
        "CONTACT_BOOK_WEB": str(web),
        "CONTACT_BOOK_COMPLETE": "1" if options.complete else "0",
        "CONTACT_BOOK_SOME_FIGURES": "1" if options.some_figures else "0",
        "CONTACT_BOOK_API": "0" if options.skip_api else "1",
    }
    if options.builder == "epub":
        # Whatever is in the folder becomes part of the file.
        shutil.rmtree(site, ignore_errors=True)
    steps.say("Sphinx")
    code = run_sphinx(options.builder, DOCS, made, site, environment, every_page=every_page)
    if code == 0 and options.builder == "epub":
        pages = made / "site"
        pages.mkdir(exist_ok=True)
        shutil.copyfile(site / EBOOK, pages / EBOOK)
        steps.say(f"the e-book is at {pages / EBOOK}")
    elif code == 0:
        steps.say(f"the book is at {site / 'index.html'}")
    return code


def main() -> int:
    try:
        return build(arguments())
    except BookError as error:
        print(f"docs/build.py: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
