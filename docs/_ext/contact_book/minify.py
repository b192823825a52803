"""Styles and scripts of the site without comments and spaces, by esbuild: 6 kB less for each page.

`page/web/build.mjs` does the same for the page's own scripts. The theme writes its colours of code
last, so this comes after it.
"""

from __future__ import annotations

import subprocess
from pathlib import Path

from sphinx.application import Sphinx

_FILES = (
    "book.css",
    "book.js",
    "copybutton.css",
    "copybutton.js",
    "doctools.js",
    "pygments.css",
    "sphinx_highlight.js",
)


def minify(app: Sphinx, error: Exception | None) -> None:
    """Rewrites the files in the static folder; without the npm packages they stay as they are."""
    esbuild = Path(app.config.contact_node) / "node_modules" / ".bin" / "esbuild"
    if error or app.builder.format != "html" or app.builder.name == "epub" or not esbuild.is_file():
        return
    static = Path(app.outdir) / "_static"
    files = [str(static / name) for name in _FILES if (static / name).is_file()]
    command = [str(esbuild), "--minify", "--allow-overwrite", f"--outdir={static}"]
    subprocess.run([*command, "--log-level=error", *files], check=True)
