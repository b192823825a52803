"""Determines what a change touches: the changed files and, for each kind of check, the chapters.

A reference header, or its source, touches every chapter that builds on its chapter. A header of
tests touches the chapters whose sources include it. What all chapters share (tests/support,
grading/contact, cmake) touches all of them, and so does for the page what its scripts are made of
(page/web, page/wasm). A file of tests that is no chapter's own touches none: its lists go by turns.

  python3 tools/touched.py [REV]   what the change since REV touches, or that of this landing
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from landing import begins_at, git, previous_landing

ROOT = Path(__file__).resolve().parent.parent
sys.path.append(str(ROOT / "grading" / "book"))

from book_json import book_json  # noqa: E402

EVERYTHING = "*"

# Kinds of checks that go by turns, as tools/sample.py and tests/browser/sample.mjs call them.
HEADERS, TESTS, FIGURES, LADDER, EXERCISES, PAGE = KINDS = (
    "headers",  # each compiled alone
    "tests",  # of references, hard cases, examples: optimised; all run under sanitizers
    "figures",  # in WebAssembly and in a browser
    "ladder",
    "exercises",  # checked natively, graded, and in the page
    "page",  # how the lesson looks and is read
)
HOSTILE = "hostile"  # submissions that attack the grader
EXPLAIN = "explain"  # a compiler's messages, explained
AUTHORS = "authors"  # what `new` writes, built
TIDY = "tidy"  # sources of the library that judges, by their names
GRADING = "grading"  # what grading does around its verdicts
BUILDER = "builder"  # what the builder of the book does, on books made for the tests
CODE = (HEADERS, TESTS, FIGURES, LADDER, EXERCISES)

# Of so many kinds a run cannot take all chapters and end in time.
TOO_WIDE = 3

Touched = dict[str, set[str]]  # of each kind, names of chapters; "*" is all of them

# Where a chapter's files are, and what such a file touches of its chapter. The first that fits.
OF_A_CHAPTER: Sequence[tuple[str, Sequence[str]]] = (
    (r"chapters/([^/]+)/(?:contact|src)/", CODE),
    (r"chapters/([^/]+)/chapter\.toml$", KINDS),
    (r"chapters/([^/]+)/figures/", (TESTS, FIGURES, PAGE)),
    (r"chapters/([^/]+)/ladder\.cpp$", (LADDER, PAGE)),
    (r"chapters/([^/]+)/(?:examples|scenes)/", (TESTS, PAGE)),
    (r"chapters/([^/]+)/questions\.toml$", (TESTS, PAGE)),
    (r"chapters/([^/]+)/", (PAGE,)),
    (r"exercises/([^/]+)/", (EXERCISES, PAGE)),
    (r"solutions/([^/]+)/", (EXERCISES, PAGE)),
    (r"tests/(\d\d_[^/]+)/", (TESTS, EXERCISES, PAGE)),
    (r"benchmarks/results/(\d\d_[^.]+)\.", (PAGE,)),
    (r"tests/browser/endings/([^/]+)/", (EXERCISES,)),
)

# What is no chapter's own, and of which kinds it touches everything. All that fit.
SHARED: Sequence[tuple[str, Sequence[str]]] = (
    (r"(cmake/|CMakeLists\.txt$|CMakePresets\.json$|tests/CMakeLists\.txt$)", CODE),
    (r"(cli/authors/(new|templates)|cmake/|CMakeLists\.txt$|CMakePresets\.json$)", (AUTHORS,)),
    (r"tests/support/(?!ladder|exercise|runner)", (TESTS, EXERCISES)),
    (r"tests/support/(exercise|runner)", (EXERCISES,)),
    (r"tests/support/ladder", (LADDER,)),
    (r"grading/(contact|contract)/", (TESTS, EXERCISES)),
    (r"grading/book/book_json\.py$", (PAGE,)),
    (r"grading/book/wrong_answers\.py$", (EXERCISES,)),
    (r"grading/diagnosis/|tests/grading/(diagnosis|mistakes)/", (EXPLAIN,)),
    (
        r"(grading/(?!.*\.py$|contact/|contract/|diagnosis/)|cli/grade/|tests/grade/(?!hostile/))",
        (GRADING,),
    ),
    (r"(docs/(_ext/|[^/]+\.(py|in|txt)$)|tests/docs/)", (BUILDER,)),
    (r"page/figure/", (TESTS, FIGURES)),
    (r"page/(wasm/(?!.*\.test\.mjs$)|player/|web/src/)", (FIGURES, LADDER, EXERCISES, PAGE)),
    (r"page/web/[^/]+$|page/package(-lock)?\.json$", (FIGURES, LADDER, EXERCISES, PAGE)),
    (r"docs/(_ext|_static)/|docs/[^/]+\.(py|in|txt)$", (PAGE,)),
)


# --- Which files a change changed -----------------------------------------------------------------


def changed_since(root: Path, base: str) -> list[str] | None:
    """Files that differ from where HEAD left `base`; what is not committed counts, and new files.

    None, if git does not know of it.
    """
    begin = (git(root, "merge-base", base, "HEAD") or "").strip()
    if not begin:
        return None
    differ = git(root, "diff", "--name-only", "--no-renames", "-z", begin)
    new = git(root, "ls-files", "--others", "--exclude-standard", "-z")
    if differ is None or new is None:
        return None
    return sorted({name for name in f"{differ}\0{new}".split("\0") if name})


def base_of_landing(root: Path) -> str | None:
    """Where this landing begins: $CONTACT_SINCE, or at origin/main, or at the turn before."""
    return begins_at(root) or previous_landing(root)


# --- What they touch ------------------------------------------------------------------------------


@dataclass(frozen=True)
class Book:
    """The chapters of a tree, what they build on, and what its sources include."""

    builds_on: Mapping[str, frozenset[str]]  # of each chapter, those that it names
    included_by: Mapping[str, frozenset[str]]  # of each file, those that include it

    def above(self, chapter: str) -> set[str]:
        """The chapter, and all that build on it."""
        found = {chapter}
        while more := {c for c, below in self.builds_on.items() if below & found} - found:
            found |= more
        return found

    def includers(self, file: str) -> set[str]:
        """The files that include this one, by themselves or through others."""
        found: set[str] = set()
        waiting = [file]
        while waiting:
            for one in self.included_by.get(waiting.pop(), frozenset()) - found:
                found.add(one)
                waiting.append(one)
        return found


def read_book(root: Path) -> Book:
    registry = book_json(root)
    builds_on = {slug: frozenset(said["builds_on"]) for slug, said in registry["chapters"].items()}
    # A chapter whose file has a mistake in it is a chapter all the same.
    for toml in root.glob("chapters/*/chapter.toml"):
        builds_on.setdefault(toml.parent.name, frozenset())
    return Book(builds_on, _included_by(root))


def _included_by(root: Path) -> dict[str, frozenset[str]]:
    sources = [
        file
        for folder in ("chapters", "exercises", "solutions", "tests", "page/figure")
        for file in (root / folder).rglob("*")
        if file.suffix in (".cpp", ".hpp")
    ]
    # Folders in which a name is looked up, apart from that of the including file.
    folders = [root / "tests", root / "grading", root / "page/figure", *root.glob("chapters/*")]
    known = {file: file.relative_to(root).as_posix() for file in sources}
    found: dict[str, set[str]] = {}
    for file, name in known.items():
        for words in re.findall(r'^#include [<"]([^>"]+)[>"]', file.read_text(), re.M):
            for folder in (file.parent, *folders):
                if (target := folder / words) in known:
                    found.setdefault(known[target], set()).add(name)
                    break
    return {name: frozenset(by) for name, by in found.items()}


def _own(file: str) -> tuple[str, Sequence[str]] | None:
    """The chapter that a file belongs to, and what it touches of it."""
    for pattern, kinds in OF_A_CHAPTER:
        if fits := re.match(pattern, file):
            return fits[1], kinds
    return None


def touched_by(files: Iterable[str], book: Book) -> Touched:
    """Of each kind, the chapters that a change of these files touches."""
    touched: Touched = {}

    def add(kinds: Sequence[str], names: Iterable[str]) -> None:
        for kind in kinds:
            touched.setdefault(kind, set()).update(names)

    for file in files:
        for pattern, kinds in SHARED:
            if re.match(pattern, file):
                add(kinds, [EVERYTHING])
        if re.match(r"grading/.*\.cpp$", file):
            add((TIDY,), [file])
        if re.match(r"grading/.*\.hpp$|\.clang-tidy$", file):
            add((TIDY,), [EVERYTHING])
        if specimen := re.match(r"tests/grade/hostile/(\w+)\.cpp$", file):
            add((HOSTILE,), [specimen[1]])
        if own := _own(file):
            chapter, kinds = own
            add(kinds, [chapter])
            if re.match(r"chapters/[^/]+/(contact/|src/|chapter\.toml$)", file):
                add(CODE, book.above(chapter))
        for includer in book.includers(file):
            if own := _own(includer):
                # What includes it is looked at as code; how its page looks does not change.
                add([kind for kind in own[1] if kind != PAGE], [own[0]])
    return touched


def chapters_of(touched: Touched, book: Book) -> list[str]:
    """All chapters of which something is touched."""
    names = {name for kind in KINDS for name in touched.get(kind, ())}
    return sorted(book.builds_on if EVERYTHING in names else names & book.builds_on.keys())


def narrowed(touched: Touched, book: Book) -> tuple[Touched, list[str]]:
    """What a run takes of it, and the kinds of which the turn alone selects.

    Wide is a kind of which the change touches more than half of the chapters. All of one or two
    such kinds fit into a run. All of more take longer than a run may: then the turn selects their
    chapters, and the two landings that follow take the others.
    """
    wide = [
        kind
        for kind in KINDS
        if len(chapters_of({kind: touched.get(kind, set())}, book)) * 2 > len(book.builds_on)
    ]
    if len(wide) < TOO_WIDE:
        return touched, []
    return {kind: names for kind, names in touched.items() if kind not in wide}, wide


def as_json(touched: Touched) -> str:
    """As CONTACT_TOUCHED holds it."""
    return json.dumps({kind: sorted(names) for kind, names in sorted(touched.items())})


def in_words(touched: Touched) -> list[str]:
    """A line of each kind."""
    return [
        f"{kind}: {'all' if EVERYTHING in names else ', '.join(sorted(names))}"
        for kind, names in sorted(touched.items())
    ] or ["nothing that goes by turns"]


@cache
def this_book() -> Book:
    return read_book(ROOT)


def main() -> int:
    base = sys.argv[1] if len(sys.argv) > 1 else base_of_landing(ROOT)
    files = changed_since(ROOT, base) if base else None
    if files is None:
        since = base or "the landing before"
        print(f"git does not know what has changed since {since}", file=sys.stderr)
        return 2
    for file in files:
        print(file)
    print("\n".join(in_words(touched_by(files, this_book()))))
    return 0


if __name__ == "__main__":
    sys.exit(main())
