"""Extracts the prose of a file, in paragraphs: text, comments, docstrings, messages, tests' names.

`paragraphs(name, text)` gives each paragraph as one line of plain text, with the line numbers of
its words in the file. Markup is removed; code and formulas are replaced by a placeholder.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import PurePath

import tree_sitter_cpp
import tree_sitter_typescript
from tree_sitter import Language, Node, Parser, Query, QueryCursor

# What stands for code and formulas in a paragraph: a noun, as far as a pattern is concerned.
CODE = "`x`"


@dataclass(frozen=True)
class Paragraph:
    text: str
    starts: tuple[tuple[int, int], ...]  # where a line of the file begins in `text`, and its number

    def line(self, offset: int) -> int:
        """The line of the file on which a character of the paragraph stands."""
        return max((start, line) for start, line in self.starts if start <= offset)[1]


# A line of prose and its number in the file.
Line = tuple[int, str]

_ROLE = re.compile(r"\{[a-z:-]+\}`([^`<]*?)(?:\s*<[^`>]*>)?`")
_WORDS_ROLE = re.compile(r"\{(?:term|index|doc|ref|errata)\}`([^`<]+?)(?:\s*<[^`>]*>)?`")
_CODE = re.compile(r"(`+)(?:[^`]|(?!\1)`)+\1|\$\$?[^$]+\$\$?|\\\([^)]*\\\)")
_LINK = re.compile(r"!?\[([^\]]*)\](?:\([^)]*\)|\[[^\]]*\])")
_ADDRESS = re.compile(r"<?https?://\S+|<!--.*?-->|</?[a-z][^>]*>")
_EMPHASIS = re.compile(r"(?<![A-Za-z0-9])[*_]{1,3}(?=\S)|(?<=\S)[*_]{1,3}(?![A-Za-z0-9])")
_SPACES = re.compile(r"\s+")
_MARKS = re.compile("[\ue000-\uf8ff]")


def plain(text: str) -> str:
    """The text without markup, code and formulas."""
    text = _ADDRESS.sub(" ", text)
    text = _WORDS_ROLE.sub(r"\1", text)
    text = _ROLE.sub(CODE, text)
    text = _CODE.sub(CODE, text)
    text = _LINK.sub(r"\1", text)
    return _EMPHASIS.sub("", text)


def paragraph(lines: list[Line]) -> Paragraph | None:
    """Lines that belong together as one. Markup may begin on one of them and end on another."""
    # A mark of one character before each line survives the markup's removal, unless code holds it.
    marked = " ".join(chr(0xE000 + index % 0x1000) + line for index, (_, line) in enumerate(lines))
    # A formula that takes a line break with it takes the mark too: the next line's then says less.
    text = _SPACES.sub(" ", plain(marked)).strip()
    pieces: list[str] = []
    starts: list[tuple[int, int]] = []
    length = 0
    for piece in re.split("(?=[\ue000-\uf8ff])", text):
        if piece and _MARKS.match(piece):
            starts.append((length, lines[ord(piece[0]) - 0xE000][0]))
            piece = piece[1:].lstrip() if not length else piece[1:]
        pieces.append(piece)
        length += len(piece)
    whole = "".join(pieces)
    if not re.search(r"[A-Za-z]{2}", whole):
        return None
    if not starts or starts[0][0] > 0:
        starts.insert(0, (0, lines[0][0]))
    return Paragraph(whole, tuple(starts))


def grouped(lines: list[Line]) -> Iterator[Paragraph]:
    """Paragraphs end at an empty line, and where a list's item, a heading or a row begins."""
    group: list[Line] = []

    def flush() -> Iterator[Paragraph]:
        if group and (made := paragraph(group)):
            yield made
        group.clear()

    for number, line in lines:
        stripped = line.strip()
        if not stripped:
            yield from flush()
            continue
        if re.match(r"[-*+|#>] |\|", stripped) or re.match(
            r"\d+\. |[@\\](param|return|tparam)", stripped
        ):
            yield from flush()
        # A parameter's name is code.
        said = re.sub(r"^([@\\]t?param) \w+(, \w+)*", r"\1", stripped)
        group.append((number, re.sub(r"^([-*+>] |\d+\. |#+ )", "", said)))
        if stripped.startswith(("#", "|")):
            yield from flush()
    yield from flush()


# --- Markdown -------------------------------------------------------------------------------------

_FENCE = re.compile(r"^(\s*)(`{3,}|~{3,})\s*(\{[a-z-]+\})?")
_COLONS = re.compile(r"^\s*:{3,}\s*(?:\{([a-z-]+)\}\s*(.*))?$")
# Directives whose argument is prose.
_TITLED = {"deeper", "note", "warning", "admonition", "tip"}
_OPTION = re.compile(r"^\s*:([a-z-]+):\s*(.*)$")


def markdown(text: str) -> Iterator[Paragraph]:
    kept: list[Line] = []
    fence = ""
    for number, line in enumerate(text.splitlines(), 1):
        if found := _FENCE.match(line):
            if not fence:
                fence = found[2]
            elif line.strip().startswith(fence) and not line.strip().strip(fence[0]):
                fence = ""
            kept.append((number, ""))
        elif fence:
            kept.append((number, ""))
        elif colons := _COLONS.match(line):
            kept += [
                (number, ""),
                (number, colons[2] if colons[1] in _TITLED else ""),
                (number, ""),
            ]
        elif option := _OPTION.match(line):
            words = option[2] if option[1] in ("alt", "caption") else ""
            kept += [(number, ""), (number, words), (number, "")]
        elif re.match(r"^\(?[\w-]+\)=$|^\|[ :|-]+\|$", line.strip()):
            kept.append((number, ""))
        elif line.strip().startswith("|"):
            for cell in line.strip().strip("|").split(" | "):
                kept += [(number, ""), (number, cell)]
        else:
            kept.append((number, line))
    # A displayed formula is no prose.
    inside = False
    result: list[Line] = []
    for number, line in kept:
        marks = line.count("$$")
        result.append((number, "" if inside or line.strip().startswith("$$") else line))
        inside ^= marks % 2 == 1
    yield from grouped(result)


# --- TOML and JSON --------------------------------------------------------------------------------

_TOML = re.compile(
    r'"""(?P<long>.*?)"""'
    r"|'''(?P<raw>.*?)'''"
    r'|"(?P<short>(?:[^"\\\n]|\\.)*)"'
    r"|'(?P<quoted>[^'\n]*)'"
    r"|(?P<comment>\#[^\n]*)",
    re.DOTALL,
)


def unescaped(text: str) -> str:
    return re.sub(r"\\(.)", lambda found: " " if found[1] in "nt" else found[1], text)


def toml(text: str) -> Iterator[Paragraph]:
    comments: list[Line] = []
    at, number = 0, 1
    for found in _TOML.finditer(text):
        number += text.count("\n", at, found.start())
        at = found.start()
        kind = str(found.lastgroup)
        if kind == "comment":
            if comments and comments[-1][0] != number - 1:
                yield from grouped(comments)
                comments = []
            comments.append((number, found[0].lstrip("#")))
        elif kind in ("long", "raw"):
            yield from markdown_at(found[kind], number)
        elif " " in found[kind]:
            said = unescaped(found[kind]) if kind == "short" else found[kind]
            yield from grouped([(number, said)])
    yield from grouped(comments)


def markdown_at(text: str, number: int) -> Iterator[Paragraph]:
    for one in markdown(text):
        yield Paragraph(one.text, tuple((start, line + number - 1) for start, line in one.starts))


# Members of a JSON document that are prose.
_JSON = re.compile(r'"(?:about|why|meaning|description|title|text)": "((?:[^"\\\n]|\\.)*)"')


def json(text: str) -> Iterator[Paragraph]:
    for number, line in enumerate(text.splitlines(), 1):
        for found in _JSON.finditer(line):
            yield from grouped([(number, unescaped(found[1]))])


# --- Code -----------------------------------------------------------------------------------------

_CPP = Language(tree_sitter_cpp.language())
_TS = Language(tree_sitter_typescript.language_typescript())


# Directives to tools, markers of regions, keys of wrong answers, and names of parameters.
_FOR_TOOLS = re.compile(
    r"/\*\w+\*/|//\s*(NOLINT|clang-format|\[/?[\w-]+\]|biome-ignore|@ts-"
    r"|caught by:|misconception:|seen:)"
)


def reads_as_prose(text: str) -> bool:
    """A message or a test's name, not a key, a path, a format or a piece of code."""
    return len(re.findall(r"(?<![\w:/.-])[A-Za-z][a-z]*(?![\w/({=])", text)) >= 3


def comment_lines(text: str, number: int) -> list[Line]:
    """Without what makes it a comment."""
    if text.startswith("//"):
        return [(number, re.sub(r"^//[/!]?<?", "", text))]
    inner = re.sub(r"^/\*+!?|\*+/$", "", text)
    return [
        (number + index, re.sub(r"^\s*\*+(?: |$)", "", line))
        for index, line in enumerate(inner.splitlines())
    ]


def syntax_tree(language: Language, query: str) -> Callable[[str], Iterator[Paragraph]]:
    """Reads comments and strings of a language that tree-sitter knows."""
    parser = Parser(language)
    asked = Query(language, query)

    def read(text: str) -> Iterator[Paragraph]:
        data = text.encode()
        found: dict[str, list[Node]] = QueryCursor(asked).captures(parser.parse(data).root_node)
        comments: list[Line] = []
        last = -2
        lines = text.split("\n")
        for node in sorted(found.get("comment", []), key=lambda one: one.start_byte):
            row = node.start_point[0]
            alone = not lines[row].encode()[: node.start_point[1]].strip()
            if not (row == last + 1 and alone):
                yield from grouped(comments)
                comments = []
            said = (node.text or b"").decode()
            if not _FOR_TOOLS.match(said):
                comments += comment_lines(said, row + 1)
            last = node.end_point[0]
        yield from grouped(comments)
        strings: list[Line] = []
        end: Node | None = None
        for node in sorted(found.get("string", []), key=lambda one: one.start_byte):
            said = unescaped((node.text or b"").decode()).strip("`")
            # Pieces of one literal, one to a line, or with expressions between.
            joined = end is not None and not data[end.end_byte : node.start_byte].strip(
                b'" \n\tRu+'
            )
            if not joined:
                yield from messages(strings)
                strings = []
            for index, line in enumerate(said.split("\n")):
                strings.append((node.start_point[0] + 1 + index, line))
            end = node
        yield from messages(strings)

    return read


def messages(strings: list[Line]) -> Iterator[Paragraph]:
    if strings and reads_as_prose(" ".join(line for _, line in strings)):
        yield from grouped(strings)


def python(text: str) -> Iterator[Paragraph]:
    comments: list[Line] = []
    lines = text.splitlines()
    tree = ast.parse(text)
    inside: set[int] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.end_lineno:
            inside.update(range(node.lineno + 1, node.end_lineno + 1))
            if not reads_as_prose(node.value):
                continue
            said = node.value.splitlines() or [""]
            last = node.end_lineno
            # A string with line breaks in it, or one that is put together of several.
            if len(said) == last - node.lineno + 1:
                yield from grouped([(node.lineno + index, line) for index, line in enumerate(said)])
            elif len(said) == 1 and last > node.lineno:
                yield from grouped(
                    [
                        (number, "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', lines[number - 1])))
                        for number in range(node.lineno, last + 1)
                    ]
                )
            else:
                yield from grouped(
                    [(min(node.lineno + index, last), line) for index, line in enumerate(said)]
                )
    for number, line in enumerate(lines, 1):
        found = re.search(r"(?:^\s*|  )#(?!!)(.*)$", line)
        if not found or number in inside or re.match(r"\s*(type: ignore|noqa|---)", found[1]):
            continue
        if comments and (comments[-1][0] != number - 1 or line[: found.start() + 1].strip(" #")):
            yield from grouped(comments)
            comments = []
        comments.append((number, found[1]))
    yield from grouped(comments)


def hash_comments(text: str) -> Iterator[Paragraph]:
    """Of shell, CMake and YAML: comments that have a line to themselves."""
    yield from grouped(
        [
            (number, found[1] if (found := re.match(r"\s*#(?!!)(.*)$", line)) else "")
            for number, line in enumerate(text.splitlines(), 1)
        ]
    )


def css(text: str) -> Iterator[Paragraph]:
    for found in re.finditer(r"/\*.*?\*/", text, re.DOTALL):
        yield from grouped(comment_lines(found[0], text.count("\n", 0, found.start()) + 1))


def patch(text: str) -> Iterator[Paragraph]:
    """The comments among the lines that a patch adds."""
    yield from grouped(
        [
            (number, found[1] if (found := re.match(r"\+.*?//(.*)$", line)) else "")
            for number, line in enumerate(text.splitlines(), 1)
        ]
    )


_READERS: dict[str, Callable[[str], Iterator[Paragraph]]] = {
    ".md": markdown,
    ".toml": toml,
    ".json": json,
    ".py": python,
    ".css": css,
    ".patch": patch,
    ".sh": hash_comments,
    ".cmake": hash_comments,
    ".txt": hash_comments,
    ".yml": hash_comments,
}
_READERS |= dict.fromkeys(
    (".cpp", ".hpp"),
    syntax_tree(_CPP, "(comment) @comment (string_content) @string (raw_string_content) @string"),
)
_READERS |= dict.fromkeys(
    (".ts", ".mts", ".mjs", ".js"), syntax_tree(_TS, "(comment) @comment (string_fragment) @string")
)


def paragraphs(name: str, text: str) -> Iterator[Paragraph]:
    """Of a file of a kind that has prose in it; of any other none."""
    path = PurePath(name.removesuffix(".in"))
    if reader := _READERS.get(path.suffix, hash_comments if path.name == "contact" else None):
        yield from reader(text)
