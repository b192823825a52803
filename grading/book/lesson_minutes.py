"""How long a lesson takes: the page's head, the cards and `contact dev check` ask here.

    lesson_minutes.py [--root ROOT] [--json] [CHAPTER...]

What is on the page counts: words at 200 a minute (a formula's pieces between spaces are words),
lines of shown code and output at 12 a minute, a question 1 minute, a figure 2. Together these are
at most 45 minutes. A Deeper box is counted separately, and so are exercises, at the minutes that
each says. Outside these boxes a listing has at most 25 lines. It needs nothing but Python.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from book_json import BookError, Json, book_json
from regions import region, without_markers

ROOT = Path(__file__).resolve().parents[2]
MAX_MINUTES = 45
MAX_LINES = 25  # of one listing
WORDS_A_MINUTE = 200
LINES_A_MINUTE = 12
MINUTES_A_QUESTION = 1
MINUTES_A_FIGURE = 2

_FIGURES = {"live-figure", "scene-player", "ladder"}
# Their content is data, and not read as words.
_NO_WORDS = {"measured", "toctree", "objectives", "hard-cases", "raw", "math", "exercise"}
_FENCE = re.compile(r"^\s*(?P<mark>:{3,}|`{3,})\s*(?P<said>.*?)\s*$")
_DIRECTIVE = re.compile(r"^\{(?P<name>[a-z-]+)\}\s*(?P<argument>.*)$")
_OPTION = re.compile(r"^\s*:[a-z-]+:")
_NOT_TEXT = re.compile(r"^(?:\([\w-]+\)=|%.*|\{[.#][^}]*\}|[|:\s-]*-{3}[|:\s-]*|<!--.*-->)$")
_LAYOUT = re.compile(
    r"\\(?:begin|end)\{[a-z*]+\}(?:\{[a-z|]*\})?|\\\\(?:\[[^\]]*\])?|\\q?quad\b|\\[,;:! ]|&"
)
_ROLE = re.compile(r"\{[a-z:-]+\}`(?P<text>[^`]*)`")
_LINK = re.compile(r"!?\[(?P<text>[^\]]*)\]\([^)]*\)")


@dataclass
class Listing:
    """Code that the page shows."""

    name: str
    lines: int


@dataclass
class Tally:
    """What a stretch of a lesson holds."""

    words: int = 0
    questions: int = 0
    figures: int = 0
    listings: list[Listing] = field(default_factory=list)

    @property
    def lines(self) -> int:
        return sum(listing.lines for listing in self.listings)

    @property
    def minutes(self) -> float:
        return (
            self.words / WORDS_A_MINUTE
            + self.lines / LINES_A_MINUTE
            + self.questions * MINUTES_A_QUESTION
            + self.figures * MINUTES_A_FIGURE
        )


@dataclass
class Lesson:
    """The text that everyone reads, and what stands in its Deeper boxes."""

    slug: str
    main: Tally
    deeper: Tally

    @property
    def problems(self) -> list[str]:
        found = [
            f"{listing.name} shows {listing.lines} lines, and a listing may have {MAX_LINES}: "
            "narrow its region, or fold it into a Deeper box"
            for listing in self.main.listings
            if listing.lines > MAX_LINES
        ]
        if self.main.minutes > MAX_MINUTES:
            found.append(
                f"it takes {self.main.minutes:.1f} minutes, and may take {MAX_MINUTES}: "
                + counted(self.main)
            )
        return found


def counted(tally: Tally) -> str:
    return (
        f"{tally.words:,} words, {tally.lines} lines of code, "
        f"{tally.questions} questions, {tally.figures} figures"
    )


def words_of(line: str) -> int:
    """How many words a line of a lesson's source says."""
    if _NOT_TEXT.match(line.strip()):
        return 0
    said = _ROLE.sub(r"\g<text>", _LINK.sub(r"\g<text>", line))
    said = _LAYOUT.sub(" ", said.replace("|", " "))
    return sum(1 for word in said.split() if re.search(r"[^\W_]|[=<>+]|\\[a-z]", word))


class _Shown:
    """Finds the files that a lesson shows, as the book's directives do."""

    def __init__(self, root: Path, slug: str) -> None:
        self.root = root
        self.folder = root / "chapters" / slug

    def _text(self, path: Path) -> str:
        try:
            return path.read_text(encoding="utf-8")
        except FileNotFoundError:
            raise BookError(f"{path.relative_to(self.root)} does not exist") from None

    def code(self, argument: str) -> Listing:
        name, _, wanted = argument.partition(" ")
        # The chapter's own file first: examples of two chapters may have one name.
        # A pack's lesson also shows the book's code.
        roots = dict.fromkeys((self.root, ROOT))
        folders = [self.folder]
        for root in roots:
            folders += [root, *sorted((root / "chapters").iterdir())]
        known = [folder / name for folder in folders]
        path = next((file for file in known if file.is_file()), self.folder / name)
        text = self._text(path)
        where = os.path.relpath(path, self.root)
        shown = region(text, wanted.strip(), where).text if wanted else without_markers(text)
        return Listing(f"code {argument}", shown.count("\n"))

    def example(self, argument: str) -> list[Listing]:
        slug, slash, name = argument.rpartition("/")
        folder = self.root / "chapters" / slug if slash else self.folder
        program = folder / "examples" / f"{name}.cpp"
        shown = without_markers(self._text(program))
        printed = self._text(program.with_suffix(".out"))
        return [
            Listing(f"example {argument}", shown.count("\n")),
            Listing(f"output of {argument}", printed.rstrip("\n").count("\n") + 1),
        ]

    def measured(self, argument: str, wanted: list[str]) -> Listing:
        found = sorted((self.root / "benchmarks" / "results").glob(f"{argument}.*.txt"))
        if not found:
            raise BookError(f"benchmarks/results/{argument}.*.txt does not exist")
        head, *rest = [
            part.strip("\n") for part in self._text(found[-1]).split("\n\n") if part.strip()
        ]
        shown = [head] + [part for start in wanted for part in rest if part.startswith(start)]
        return Listing(f"measured {argument}", sum(part.count("\n") + 1 for part in shown))


class _Reader:
    """Walks a lesson's lines once, with the stack of the directives that are open."""

    def __init__(self, shown: _Shown, recalled: int) -> None:
        self.shown = shown
        self.recalled = recalled
        self.main = Tally()
        self.deeper = Tally()
        self.open: list[tuple[str, str, str]] = []  # fence, directive's name, argument
        self.content: list[str] = []
        self.options = False

    @property
    def tally(self) -> Tally:
        return self.deeper if any(name == "deeper" for _, name, _ in self.open) else self.main

    def read(self, text: str) -> None:
        for line in text.splitlines():
            if not self.is_fence(line):
                self.is_content(line)

    def is_fence(self, line: str) -> bool:
        fence = _FENCE.match(line)
        if fence is None or (self.in_code and not self.closes(fence)):
            return False
        if self.closes(fence):
            self.close()
        else:
            said = _DIRECTIVE.match(fence["said"])
            name, argument = (
                (said["name"], said["argument"]) if said else ("listing", fence["said"])
            )
            self.start(fence["mark"], name, argument)
        return True

    @property
    def in_code(self) -> bool:
        return bool(self.open) and self.open[-1][1] == "listing"

    def closes(self, fence: re.Match[str]) -> bool:
        if not self.open or fence["said"]:
            return False
        mark = self.open[-1][0]
        return bool(fence["mark"].startswith(mark))

    def start(self, mark: str, name: str, argument: str) -> None:
        self.open.append((mark, name, argument))
        self.content = []
        self.options = True
        if name in _FIGURES:
            self.tally.figures += 1
        elif name == "question":
            self.tally.questions += 1
        elif name == "recall":
            self.tally.questions += self.recalled
        elif name == "code":
            self.tally.listings.append(self.shown.code(argument))
        elif name == "example":
            self.tally.listings += self.shown.example(argument)
        elif name == "deeper":
            self.deeper.words += words_of(argument)

    def close(self) -> None:
        _, name, argument = self.open[-1]
        if name == "listing" and self.content:
            self.tally.listings.append(
                Listing(f"the listing '{self.content[0].strip()}'", len(self.content))
            )
        elif name == "measured":
            self.tally.listings.append(
                self.shown.measured(argument, [line for line in self.content if line.strip()])
            )
        self.open.pop()
        self.content = []

    def is_content(self, line: str) -> None:
        if self.open:
            if self.options and _OPTION.match(line):
                return
            self.options = False
            self.content.append(line)
            if self.in_code or self.open[-1][1] in _NO_WORDS:
                return
        self.tally.words += words_of(line)


def lesson_of(root: Path, slug: str, said: Mapping[str, Any]) -> Lesson:
    """Counts the lesson of this chapter, of which book.json says what is given."""
    reader = _Reader(_Shown(root, slug), len(said["recall"]))
    reader.read((root / "chapters" / slug / "lesson.md").read_text(encoding="utf-8"))
    return Lesson(slug, reader.main, reader.deeper)


def told(lesson: Lesson) -> str:
    line = f"{lesson.slug}: {lesson.main.minutes:.1f} minutes ({counted(lesson.main)})"
    if lesson.deeper.minutes:
        line += f", and {lesson.deeper.minutes:.1f} in Deeper boxes"
    return line


def judged(root: Path, slug: str, said: Mapping[str, Any]) -> Json:
    """What is to be told of one lesson, and what is wrong with it."""
    try:
        lesson = lesson_of(root, slug, said)
    except (BookError, OSError) as error:
        return {"chapter": slug, "said": f"{slug}: not counted", "problems": [str(error)]}
    return {
        "chapter": slug,
        "minutes": round(lesson.main.minutes, 1),
        "deeper": round(lesson.deeper.minutes, 1),
        "said": told(lesson),
        "problems": lesson.problems,
    }


def main(words: Sequence[str] | None = None) -> int:
    about, _, _ = (__doc__ or "").partition("\n")
    parser = argparse.ArgumentParser(description=about)
    parser.add_argument("--root", type=Path, default=ROOT)
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.add_argument("chapters", nargs="*", help="only these (default: all with a lesson)")
    options = parser.parse_args(words)
    root = options.root.absolute()
    found = [
        judged(root, slug, said)
        for slug, said in sorted(book_json(root)["chapters"].items())
        if said["status"] == "lesson" and slug.startswith(tuple(options.chapters) or "")
    ]
    if options.json:
        print(json.dumps(found, ensure_ascii=False, indent=1))
    else:
        for row in found:
            print("\n  ".join([row["said"], *row["problems"]]))
    return 1 if any(row["problems"] for row in found) else 0


if __name__ == "__main__":
    sys.exit(main())
