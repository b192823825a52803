"""tools/words.py finds the words that the book does not use, where they stand, and only those."""

from __future__ import annotations

import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from words import Found, find_words  # noqa: E402

SENTENCES = tomllib.loads(Path(__file__).with_name("words.toml").read_text(encoding="utf-8"))
LESSON = "chapters/20_scenes/lesson.md"


def found_with(text: str, name: str = LESSON) -> Found:
    return find_words([(name, text)])


def numbered(number: int, name: str) -> str:
    """Another file of the same kind, so that many texts are searched in one run."""
    path = Path(name)
    return str(path.parent / f"{number}" / path.name)


def as_prose(number: int, sentence: dict[str, Any]) -> tuple[str, str]:
    """A sentence as a file of its own, of the kind that it is said to be in."""
    path = Path(sentence.get("in", LESSON))
    name = numbered(number, str(path))
    text = sentence["text"]
    if path.suffix in (".hpp", ".cpp"):
        return name, f"// {text}\nint x;\n"
    if path.suffix == ".json":
        return name, f'{{"why": "{text}"}}\n'
    return name, text + "\n"


def found_in(kind: str) -> dict[str, set[str]]:
    """What is found in each sentence of a kind, all in one run."""
    texts = [as_prose(number, sentence) for number, sentence in enumerate(SENTENCES[kind])]
    terms: dict[str, set[str]] = {name: set() for name, _ in texts}
    for use in find_words(texts).faults:
        terms[use.file].add(use.term)
    return {one["text"]: terms[name] for one, (name, _) in zip(SENTENCES[kind], texts, strict=True)}


def test_there_are_thirty_of_each_kind() -> None:
    assert [len(SENTENCES[kind]) for kind in ("flagged", "ordinary")] == [30, 30]


def said(sentence: dict[str, Any]) -> set[str]:
    says = sentence["says"]
    return {says} if isinstance(says, str) else set(says)


def test_house_words_are_found() -> None:
    found = found_in("flagged")
    missed = {one["text"]: said(one) - found[one["text"]] for one in SENTENCES["flagged"]}
    assert {text: words for text, words in missed.items() if words} == {}


def test_ordinary_uses_pass() -> None:
    assert {text: terms for text, terms in found_in("ordinary").items() if terms} == {}


def test_every_word_has_a_sentence() -> None:
    assert set[str]().union(*map(said, SENTENCES["flagged"])) == set(found_with("").terms)


# A file, its text, and the line on which the one word of the list is.
LINES = [
    ("chapters/20_scenes/lesson.md", "One.\n\nOf the\nplace of a ball.\n", 4),
    ("chapters/20_scenes/lesson.md", "It is the place of\n_the ball_.\n", 1),
    (
        "chapters/20_scenes/contact/a.hpp",
        "int x;\n/// The place of\n/// a ball, m\nint y;\n",
        2,
    ),
    ("chapters/20_scenes/contact/a.hpp", "int x;  ///< it rubs\n", 1),
    ("chapters/20_scenes/contact/a.hpp", "/*\n * It\n * rubs.\n */\n", 3),
    ("tests/20_scenes/a_test.cpp", 'TEST_CASE("a ball that hops\\n") {}\n', 1),
    ("tests/20_scenes/a_test.cpp", 'auto s =\n    "a ball "\n    "that hops";\n', 3),
    ("solutions/20_scenes/a/wrong/a.patch", "--- a\n+++ b\n+int x;  // it rubs\n", 3),
    ("chapters/20_scenes/questions.toml", 'id = "rub"\ntext = "Where it rubs."\n', 2),
    ("chapters/20_scenes/questions.toml", 'text = """\nWhere\nit rubs.\n"""\n', 3),
    ("chapters/20_scenes/questions.toml", "x = 1\n# It rubs.\n", 2),
    ("chapters/20_scenes/scenes/a.json", '{\n "about": "It rubs."\n}\n', 2),
    ("tools/a.py", '"""One.\n\nIt rubs.\n"""\n', 3),
    ("tools/a.py", "x = 1  # it rubs\n", 1),
    ("tools/a.py", 'x = f"it {x} rubs and turns"\n', 1),
    ("page/web/src/a.ts", "const x = 1;\n// It\n// rubs.\n", 3),
    ("page/web/src/a.ts", "const x = `what it\nrubs and turns`;\n", 2),
    ("page/web/src/a.css", "a {\n  /* it rubs */\n}\n", 2),
    ("cmake/a.cmake", "# It rubs.\n", 1),
]
CODE = [
    (
        "chapters/20_scenes/lesson.md",
        "The name `rub` and\n\n```\nit rubs\n```\n\n$$\nrub\n$$\n",
    ),
    ("chapters/20_scenes/contact/a.hpp", 'int rub = hop(slant, "rub");\n'),
    ("chapters/20_scenes/questions.toml", 'id = "rub"\n'),
    ("tools/a.py", 'rub = hops("rub")\n'),
    ("page/web/src/a.ts", 'const rub = hops("rub");\n'),
]
DELIBERATE = [
    ("chapters/20_scenes/lesson.md", "A ball that hops. <!-- words: ok -->\n"),
    ("chapters/20_scenes/contact/a.hpp", "int x;  // it hops, words: ok\n"),
    ("chapters/20_scenes/questions.toml", 'text = "It hops."  # words: ok\n'),
]


def test_a_word_is_found_on_its_line() -> None:
    texts = [(numbered(i, name), text) for i, (name, text, _) in enumerate(LINES)]
    faults = find_words(texts).faults
    assert {use.file: use.line for use in faults} == {
        name: line for (name, _), (_, _, line) in zip(texts, LINES, strict=True)
    }
    assert len(faults) == len(LINES)
    for use in faults:
        assert str(use).startswith(f'{use.file}:{use.line}: {use.term} ("')
        assert ": write " in str(use)


def test_code_is_no_prose() -> None:
    texts = [(numbered(i, name), text) for i, (name, text) in enumerate(CODE)]
    assert find_words(texts).faults == []


def test_a_deliberate_use_is_allowed_and_counted() -> None:
    found = find_words([(numbered(i, name), text) for i, (name, text) in enumerate(DELIBERATE)])
    assert found.faults == []
    assert len(found.allowed) == len(DELIBERATE)


def test_it_is_allowed_in_its_own_line_only() -> None:
    found = found_with("A ball that hops. <!-- words: ok -->\nIt hops.\n")
    assert [use.line for use in found.faults] == [2]


def run(*arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(ROOT / "tools" / "words.py"), *arguments]
    return subprocess.run(command, capture_output=True, encoding="utf-8", check=False)


def a_project(folder: Path, text: str) -> Path:
    subprocess.run(["git", "init", "-q", str(folder)], check=True)
    (folder / "README.md").write_text(text)
    return folder


def test_the_command_fails_with_what_it_found(tmp_path: Path) -> None:
    done = run("--root", str(a_project(tmp_path, "It rubs.\n")))
    assert done.returncode == 1
    assert done.stdout.splitlines() == [
        'README.md:1: rub ("rubs"): write slide with friction; friction acts',
        "1 words to change in 1 files; 0 deliberate uses ('words: ok') of at most 40",
    ]


def test_more_deliberate_uses_than_that_are_a_fault(tmp_path: Path) -> None:
    line = "It rubs. <!-- words: ok -->\n\n"
    assert run("--root", str(a_project(tmp_path, 40 * line))).returncode == 0
    assert run("--root", str(a_project(tmp_path, 41 * line))).returncode == 1


def test_the_command_counts(tmp_path: Path) -> None:
    done = run("--root", str(a_project(tmp_path, "It rubs, and rubs.\n")), "--count")
    assert done.returncode == 0
    assert "     2  rub\n" in done.stdout
