"""`{ladder}`: the cost of each method and how often it is wrong, from the newest measurement.

The picture is made by the page's own code. The CSV of the same numbers is made here, and their
table where no script runs.
"""

from __future__ import annotations

import csv
import io
import json
import subprocess
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.writers.html5 import HTML5Translator

from contact_book.book import Book
from contact_book.directive import BookDirective, open_book
from contact_book.errors import BookError
from contact_book.html import attributes, base_path, can_run_scripts, json_script, renders, slots
from contact_book.nodes import component, make_component, make_slot
from contact_book.tables import scrolled, table

_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def newest(folder: Path, slug: str) -> Path | None:
    """The measurement with the latest date among `<slug>.<machine>.json`."""
    found = []
    for path in sorted(folder.glob(f"{slug}.*.json")):
        found.append((json.loads(path.read_text(encoding="utf-8"))["date"], path))
    return max(found)[1] if found else None


def _number(value: float | None) -> str:
    if value is None:
        return "–"
    if value != 0 and (abs(value) < 1e-3 or abs(value) >= 1e6):
        mantissa, _, exponent = f"{value:.1e}".partition("e")
        return f"{mantissa}·10{str(int(exponent)).translate(_RAISED)}"
    return f"{value:,.3g}" if abs(value) < 1000 else f"{value:,.0f}"


def _count(value: int) -> str:
    return f"{value:,}"


def columns(data: dict[str, Any]) -> tuple[list[str], list[list[str]]]:
    """Heads and rows of the table. Errors have columns only if the ladder measures errors."""
    methods = {row["id"]: row for row in data["methods"]}
    families = {row["id"]: row for row in data["families"]}
    errors = [
        (head, key)
        for head, key in (("Median error", "error_median"), ("Largest error", "error_max"))
        if any(row[key] is not None for row in data["results"])
    ]
    heads = [
        "Inputs",
        "Method",
        "Wrong answers",
        *[head for head, _ in errors],
        "Time, ns: median (quartiles)",
    ]
    rows = []
    for row in data["results"]:
        method = methods[row["method"]]
        rows.append(
            [
                families[row["family"]]["title"],
                f"{method['title']}, {method['scalar']}",
                f"{_count(row['wrong'])} of {_count(row['n'])}",
                *[_number(row[key]) for _, key in errors],
                f"{_number(row['ns_median'])} ({_number(row['ns_q1'])}–{_number(row['ns_q3'])})",
            ]
        )
    return heads, rows


def _measurement(book: Book, slug: str) -> Path:
    """The newest measurement that is kept, or the quick one of the build, which may be missing."""
    kept = newest(book.root / "benchmarks" / "results", slug)
    return kept or book.products / "ladders" / f"{slug}.json"


def _draw(drawer: Path, path: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        ["node", str(drawer), str(path)], capture_output=True, text=True, check=False
    )


_drawn_ahead: dict[Path, Future[subprocess.CompletedProcess[str]]] = {}


def draw_ahead(app: Sphinx, _env: BuildEnvironment, names: list[str]) -> None:
    """Begins the pictures of the lessons to be read, on another core than the reading."""
    _drawn_ahead.clear()
    drawer = Path(app.config.contact_plotter)
    if not drawer.is_file():
        return
    book = open_book(app.config)
    beside = ThreadPoolExecutor(1)
    for name in names:
        slug = name.removeprefix("chapters/")
        path = _measurement(book, slug)
        if (book.root / "chapters" / slug / "ladder.cpp").is_file() and path.is_file():
            _drawn_ahead[path] = beside.submit(_draw, drawer, path)
    beside.shutdown(wait=False)


class Ladder(BookDirective):
    optional_arguments = 1

    def build(self) -> list[nodes.Node]:
        slug = self.arguments[0].strip() if self.arguments else self.here
        if slug is None:
            raise BookError("ladder needs a chapter here, as in {ladder} 02_triangles")
        chapter = self.book.chapter(slug, self.source)
        if not (chapter.folder / "ladder.cpp").is_file():
            raise BookError(f"chapters/{slug}/ladder.cpp is missing")
        path = _measurement(self.book, slug)
        measured = path.is_relative_to(self.book.root / "benchmarks")
        self.depends(path)
        self.needs_script()
        if not path.is_file():
            self.missing_product(f"ladder_{slug} has not run: {path}")
            words = "The measurements of this ladder are still being built."
            return [nodes.paragraph("", words, classes=["not-built"])]
        data = json.loads(path.read_text(encoding="utf-8"))
        picture = self.picture(path)
        content = [make_slot("source", self.origin(data, measured))]
        content += [make_slot("table", [self.results(data)])]
        values = {"slug": slug, "ladder": data, "picture": picture}
        return [make_component("ladder", values, content)]

    def picture(self, path: Path) -> str:
        """The picture as HTML, made by the code that makes it in the page."""
        drawer = Path(self.config.contact_plotter)
        if not drawer.is_file():
            self.missing_product(f"the picture of {path.name} needs {drawer}")
            return ""
        self.depends(drawer, *sorted((drawer.parent / "src").glob("ladder-*.ts")))
        ahead = _drawn_ahead.pop(path, None)
        made = ahead.result() if ahead else _draw(drawer, path)
        if made.returncode != 0:
            raise BookError(f"drawing {path.name} failed: {made.stderr.strip()[-800:]}")
        return made.stdout

    def origin(self, data: dict[str, Any], measured: bool) -> list[nodes.Node]:
        machine = data["machine"]
        # CMake calls it by the project's name.
        compiler = data["compiler"].replace("GNU ", "GCC ")
        words = (
            f"Measured on {machine['cpu']} ({machine['cores']} cores, {machine['os']}) with "
            f"{compiler}, {data['date'][:10]}, on {_sizes(data)} inputs a family."
        )
        if not measured:
            words += (
                " This is the quick run of the build, on few inputs: read its times as rough, "
                "and make your own with "
            )
            command = f"./contact ladder {data['ladder']}"
            return [
                nodes.paragraph(
                    "", "", nodes.Text(words), nodes.literal("", command), nodes.Text(".")
                )
            ]
        return [nodes.paragraph("", words)]

    def results(self, data: dict[str, Any]) -> nodes.Element:
        heads, rows = columns(data)
        cells = [[nodes.Text(text) for text in row] for row in rows]
        return scrolled(table(heads, cells, data["question"], ["ladder"]), "Table of measurements")


def _sizes(data: dict[str, Any]) -> str:
    """How many inputs the families have: some questions take too long for as many as others."""
    sizes = sorted({family.get("n", data["size"]) for family in data["families"]})
    return " to ".join(_count(size) for size in dict.fromkeys((sizes[0], sizes[-1])))


_COLUMNS = ("n", "wrong", "undecided", "error_median", "error_max")
_TIMES = ("ns_median", "ns_q1", "ns_q3", "repeats")


def as_csv(data: dict[str, Any]) -> str:
    """All numbers of a measurement, one row for each method on each family."""
    methods = {row["id"]: row for row in data["methods"]}
    families = {row["id"]: row for row in data["families"]}
    text = io.StringIO()
    write = csv.writer(text, lineterminator="\r\n").writerow
    write(["inputs", "method", "scalar", *_COLUMNS, *_TIMES])
    for row in data["results"]:
        method = methods[row["method"]]
        about = [families[row["family"]]["title"], method["title"], method["scalar"]]
        write([*about, *(row.get(key) for key in (*_COLUMNS, *_TIMES))])
    return text.getvalue()


def apart(data: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """The measurement without its failing inputs, and these by `family method`. A row that has one
    says `fails`. Numbers have four digits, which is more than the page shows.
    """
    rows, failing = [], {}
    for row in data["results"]:
        kept = {
            key: float(f"{value:.4g}") if isinstance(value, float) else value
            for key, value in row.items()
            if key != "failure"
        }
        if "failure" in row:
            failing[f"{row['family']} {row['method']}"] = row["failure"]
            kept["fails"] = True
        rows.append(kept)
    return {**data, "results": rows}, failing


def alone(html: str) -> str:
    """The picture where no script runs and HTML is XML."""
    return html.replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" ')


@renders("ladder")
def ladder_html(translator: HTML5Translator, node: component) -> str:
    data = node["data"]
    parts = slots(translator, node)
    picture = f'<div class="picture">{data["picture"]}</div>'
    measured = f'<div class="measured">{parts["source"][0]}</div>'
    if not can_run_scripts(translator):
        return f'<div class="ladder">{alone(picture)}{measured}{parts["table"][0]}</div>'
    folder = Path(translator.builder.outdir) / "ladders"
    folder.mkdir(exist_ok=True)
    up = "../" * translator.builder.current_docname.count("/") + "ladders/"
    # With all digits, for other programs.
    name = f"{data['slug']}.csv"
    (folder / name).write_text(as_csv(data["ladder"]), encoding="utf-8", newline="")
    file = attributes(download=name, href=f"{up}{name}")
    # The page makes their table when it is opened.
    folded = f"<details><summary>The numbers</summary><p><a{file}>{name}</a></p></details>"
    # Most of a measurement is inputs on which a method fails, and a reader asks for a few of them.
    shown, failing = apart(data["ladder"])
    inputs = f"{data['slug']}.failures.json"
    (folder / inputs).write_text(json.dumps(failing, separators=(",", ":")), encoding="utf-8")
    where = attributes(base=base_path(translator), name=data["slug"], failures=f"{up}{inputs}")
    script = json_script(shown)
    return f"<contact-ladder{where}>{script}{picture}{measured}{folded}</contact-ladder>\n"
