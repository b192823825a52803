"""Files for the service worker: its script at the site's root, and the list of the site's files.

offline.json names each file with the start of its SHA-256 and its sizes; the page's side of it is
page/web/src/offline. The compiler's files are not in it, because they have a manifest of their own,
nor are the e-book and the pages to embed, which repeat the lessons.
"""

from __future__ import annotations

import gzip
import hashlib
import json
import shutil
from collections.abc import Iterator
from pathlib import Path

from sphinx.application import Sphinx

from contact_book.run import EBOOK

WORKER = "sw.js"
LIST = "offline.json"
_COMPILER = "_static/contact/cpp/"
# What a reader who saves or embeds a part loads, and the pages do not.
_NOT_READ = ("_sources/", "embed/", "_static/contact/alone/")
_HASH_LENGTH = 16
# What a server does not compress again.
_COMPRESSED = {".woff2", ".png", ".gz"}


def kept_files(site: Path) -> Iterator[tuple[str, Path]]:
    """The files that a reader may need, by their path in the site."""
    for file in sorted(site.rglob("*")):
        path = file.relative_to(site).as_posix()
        hidden = any(part.startswith(".") for part in file.relative_to(site).parts)
        if not file.is_file() or hidden or path.startswith((_COMPILER, *_NOT_READ)):
            continue
        if path not in (WORKER, LIST, EBOOK, "objects.inv") and not path.endswith("/" + WORKER):
            yield path, file


def entry(file: Path) -> dict[str, str | int]:
    content = file.read_bytes()
    small = content if file.suffix in _COMPRESSED else gzip.compress(content, 6, mtime=0)
    digest = hashlib.sha256(content).hexdigest()[:_HASH_LENGTH]
    return {"hash": digest, "bytes": len(content), "transfer": len(small)}


def offline_list(site: Path) -> str:
    """The list as JSON: the same for the same files, whenever they were written."""
    files = {path: entry(file) for path, file in kept_files(site)}
    rows = json.dumps(files, separators=(",", ":"))
    version = hashlib.sha256(rows.encode()).hexdigest()[:_HASH_LENGTH]
    return f'{{"format":"contact-offline/1","version":"{version}","files":{rows}}}\n'


def write_offline(app: Sphinx, error: Exception | None) -> None:
    """The last step of a build: after it nothing in the site changes."""
    if error is not None or app.builder.name != "html":
        return
    site = Path(app.outdir)
    worker = Path(app.config.contact_web) / WORKER
    if worker.is_file():
        shutil.copyfile(worker, site / WORKER)
    (site / LIST).write_text(offline_list(site), encoding="utf-8")
