"""Checks prose against the words of tools/words.yml.

    tools/words.py [--count] [FILE OR FOLDER ...]

Prose is text, comments, docstrings, messages and the names of tests (prose.py). Each use that is
found is printed as `file:line: word: write ...`. A deliberate use has `words: ok` in its line;
their number is printed, and more than MOST are a fault. `--count` prints how often each word occurs
instead, including deliberate uses.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import prose

ROOT = Path(__file__).resolve().parent.parent
ALLOWED = "words: ok"
# So many deliberate uses, in all, and no more.
MOST = 40
# Files that must name the words.
SKIPPED = ("tools/words.yml", "tests/setup/words.toml", "tests/setup/test_words.py")


@dataclass(frozen=True)
class Use:
    """A word that is not the book's, and where."""

    file: str
    line: int
    term: str
    found: str
    expected: str

    def __str__(self) -> str:
        return f'{self.file}:{self.line}: {self.term} ("{self.found}"): write {self.expected}'


@dataclass(frozen=True)
class Found:
    terms: list[str]
    faults: list[Use]
    allowed: list[Use]  # uses in a line that says so
    files: int


def find_words(texts: list[tuple[str, str]]) -> Found:
    """What is found in texts, each with the name of its file."""
    asked: list[dict[str, str]] = []
    where: list[tuple[str, list[str], prose.Paragraph]] = []
    for name, text in texts:
        lines = text.splitlines()
        for paragraph in prose.paragraphs(name, text):
            where.append((name, lines, paragraph))
            asked.append({"name": name, "text": paragraph.text})
    node = subprocess.run(
        ["node", ROOT / "tools" / "words.mjs"],
        input=json.dumps(asked),
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    if node.returncode:
        raise SystemExit(node.stderr)
    said = json.loads(node.stdout)
    faults: list[Use] = []
    allowed: list[Use] = []
    for one in said["found"]:
        name, lines, paragraph = where[one["index"]]
        line = paragraph.line(one["offset"])
        use = Use(name, line, one["term"], one["found"], one["expected"])
        # A use may run over the end of its line.
        its_lines = lines[line - 1 : paragraph.line(one["end"] - 1)]
        excused = any(ALLOWED in its_line for its_line in its_lines)
        (allowed if excused else faults).append(use)
    faults.sort(key=lambda use: (use.file, use.line))
    return Found(said["terms"], faults, allowed, len(texts))


def unreleased(changelog: str) -> str:
    """What the next release will say; what past ones said stays as it was."""
    head, mark, rest = changelog.partition("\n## [Unreleased]")
    return head + mark + rest.partition("\n## [")[0]


def read(root: Path, names: list[str]) -> list[tuple[str, str]]:
    texts: list[tuple[str, str]] = []
    for name in names:
        if name in SKIPPED or "third_party/" in name or name.endswith("package-lock.json"):
            continue
        try:
            text = (root / name).read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        texts.append((name, unreleased(text) if name == "CHANGELOG.md" else text))
    return texts


def tracked(root: Path, paths: list[str]) -> list[str]:
    """Files of the project: those in git, and new ones that git does not ignore."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "-z", "--", *paths]
    listed = subprocess.run(command, cwd=root, capture_output=True, text=True, check=True).stdout
    return sorted({name for name in listed.split("\0") if name and (root / name).is_file()})


def main() -> int:
    options = argparse.ArgumentParser(description="Find words that the book does not use.")
    options.add_argument("--count", action="store_true", help="print how often each occurs")
    options.add_argument("--root", type=Path, default=ROOT, help="another copy of the repository")
    options.add_argument("paths", nargs="*", help="files and folders; without any: all")
    arguments = options.parse_args()
    root = arguments.root.resolve()
    paths = [str(Path(path).resolve().relative_to(root)) for path in arguments.paths]
    found = find_words(read(root, tracked(root, paths)))
    if arguments.count:
        count = Counter(use.term for use in found.faults + found.allowed)
        for term in found.terms:
            print(f"{count[term]:6}  {term}")
        print(f"{count.total():6}  in all, in {found.files} files")
        return 0
    for use in found.faults:
        print(use)
    kept = len(found.allowed)
    print(
        f"{len(found.faults)} words to change in {found.files} files; "
        f"{kept} deliberate uses ({ALLOWED!r}) of at most {MOST}"
    )
    return int(bool(found.faults) or kept > MOST)


if __name__ == "__main__":
    sys.exit(main())
