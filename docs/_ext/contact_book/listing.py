"""`{code} FILE REGION`, `{example} NAME`, `{measured} NAME`: listings taken from files that are
compiled, compared, or written by a measurement."""

from __future__ import annotations

from pathlib import Path

from docutils import nodes
from regions import region, without_inline_macro, without_markers

from contact_book.directive import BookDirective
from contact_book.errors import BookError, unknown


def listing(text: str, language: str, caption: list[nodes.Node]) -> nodes.Element:
    """Highlighted code under the name of the file it comes from."""
    code = nodes.literal_block(text, text, language=language)
    code["classes"].append("listing")
    if not caption:
        return code
    box = nodes.container("", literal_block=True, classes=["literal-block-wrapper"])
    box += nodes.caption("", "", *caption)
    box += code
    return box


def language_of(path: Path) -> str:
    known = {".py": "python", ".ts": "typescript", ".toml": "toml", ".json": "json", ".out": "text"}
    return known.get(path.suffix, "cpp")


class Code(BookDirective):
    """A named region of a file, or the whole file when no region is named.

    The file is named by its path in the chapter or, for any file of the book, from the book's root.
    """

    required_arguments = 1
    optional_arguments = 1
    final_argument_whitespace = False

    def find(self, name: str) -> Path:
        # The chapter's own file first: examples of two chapters may have one name.
        if self.here is not None:
            path = self.book.chapter(self.here, self.source).folder / name
            if path.is_file():
                return path
        if (self.book.root / name).is_file():
            return self.book.root / name
        header = self.book.header(name)
        if header is not None:
            return header
        known = [
            path.relative_to(chapter.folder).as_posix()
            for chapter in self.book.chapters.values()
            for path in chapter.headers
        ]
        raise unknown("file", name, known, "the chapters' headers or this chapter's folder")

    def build(self) -> list[nodes.Node]:
        name = self.arguments[0]
        path = self.find(name)
        self.depends(path)
        where = self.book.relative(path)
        text = path.read_text(encoding="utf-8")
        if len(self.arguments) > 1:
            text = region(text, self.arguments[1], where).text
        else:
            text = without_markers(text)
        text = without_inline_macro(text)
        own = path == self.book.root / name
        title = path.name if own else name
        return [listing(text, language_of(path), [nodes.literal(title, title)])]


class Example(BookDirective):
    """A program that the tests compile and run, with the output they compare."""

    required_arguments = 1

    def build(self) -> list[nodes.Node]:
        chapter, name = self.book.split(self.arguments[0].strip(), self.here, self.source)
        if name not in chapter.examples:
            raise unknown("example", name, chapter.examples, f"chapters/{chapter.slug}/examples")
        program = chapter.folder / "examples" / f"{name}.cpp"
        output = program.with_suffix(".out")
        self.depends(program, output)
        if not output.is_file():
            raise BookError(f"{self.book.relative(output)} is missing: an example shows its output")
        box = nodes.container(classes=["example"])
        title = f"examples/{name}.cpp"
        code = without_markers(program.read_text(encoding="utf-8"))
        box += listing(code, "cpp", [nodes.literal(title, title)])
        printed = output.read_text(encoding="utf-8")
        box += listing(printed, "text", [nodes.Text("prints")])
        return [box]


def paragraphs(text: str) -> list[str]:
    """What empty lines part."""
    return [part.strip("\n") for part in text.split("\n\n") if part.strip()]


class Measured(BookDirective):
    """A comparison with other programs, as stored in `benchmarks/results/NAME.*.txt`.

    Each line of the content is the beginning of a paragraph of the file; those are shown, under the
    file's first, which says on what machine and how.
    """

    required_arguments = 1
    has_content = True

    def build(self) -> list[nodes.Node]:
        name = self.arguments[0].strip()
        results = self.book.root / "benchmarks" / "results"
        found = sorted(results.glob(f"{name}.*.txt"))
        if not found:
            known = {path.name.partition(".")[0] for path in results.glob("*.txt")}
            raise unknown("measurement", name, sorted(known), "benchmarks/results")
        path = found[-1]
        self.depends(path)
        where = self.book.relative(path)
        head, *rest = paragraphs(path.read_text(encoding="utf-8"))
        shown = [head]
        for wanted in self.content:
            matching = [part for part in rest if part.startswith(wanted)]
            if not matching:
                firsts = [part.partition("\n")[0] for part in rest]
                raise unknown("paragraph", wanted, firsts, where)
            shown += matching
        text = "\n\n".join(shown) + "\n"
        return [listing(text, "text", [nodes.literal(where, where)])]
