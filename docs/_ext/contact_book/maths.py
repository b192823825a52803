"""Mathematics, rendered when the book is built, by one KaTeX process per builder process."""

from __future__ import annotations

import atexit
import json
import os
import subprocess
from functools import lru_cache
from pathlib import Path

from docutils import nodes
from sphinx.util import logging
from sphinx.util.math import get_node_equation_number
from sphinx.writers.html5 import HTML5Translator

from contact_book.ebook import mathml
from contact_book.errors import BookError
from contact_book.html import can_run_scripts

logger = logging.getLogger(__name__)


class Katex:
    """A running KaTeX."""

    def __init__(self, package: Path) -> None:
        if not (package / "node_modules" / "katex").is_dir():
            raise BookError(f"KaTeX is not installed in {package}: run ./contact setup")
        script = Path(__file__).with_name("katex.mjs")
        self.process = subprocess.Popen(
            ["node", str(script), str(package)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            encoding="utf-8",
        )
        self.package = package
        atexit.register(self.close)

    def close(self) -> None:
        if self.process.stdin:
            self.process.stdin.close()
        self.process.wait(timeout=10)

    def render(self, tex: str, display: bool) -> str:
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.process.stdin.write(json.dumps({"tex": tex, "display": display}) + "\n")
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        if "error" in answer:
            raise BookError(answer["error"])
        html: str = answer["html"]
        return html


@lru_cache(maxsize=1)
def katex(package: Path, process: int) -> Katex:
    """The KaTeX of this process; a forked builder process starts its own."""
    return Katex(package)


def _rendered(translator: HTML5Translator, node: nodes.Element, display: bool) -> str:
    tex = node.astext().strip()
    if display and "\\\\" in tex and "\\begin" not in tex:
        tex = f"\\begin{{gathered}}{tex}\\end{{gathered}}"
    try:
        engine = katex(Path(translator.config.contact_node), os.getpid())
        html = engine.render(tex, display)
        return html if can_run_scripts(translator) else mathml(html)
    except BookError as error:
        logger.error("mathematics: %s in %s", error, tex, location=node, type="contact")
        return f"<code>{translator.encode(tex)}</code>"


# Of TeX: a shorter formula in a line of text is not divided at the line's end.
_LONGEST_WHOLE = 30


def visit_inline(translator: HTML5Translator, node: nodes.math) -> None:
    whole = " whole" if len(node.astext().strip()) <= _LONGEST_WHOLE else ""
    translator.body.append(f'<span class="math{whole}">{_rendered(translator, node, False)}</span>')
    raise nodes.SkipNode


def visit_block(translator: HTML5Translator, node: nodes.math_block) -> None:
    translator.body.append(translator.starttag(node, "div", CLASS="math"))
    if node.get("number"):
        number = get_node_equation_number(translator, node)
        translator.body.append(f'<span class="eqno">({number})')
        translator.add_permalink_ref(node, "Link to this equation")
        translator.body.append("</span>")
    translator.body.append(f"{_rendered(translator, node, True)}</div>\n")
    raise nodes.SkipNode
