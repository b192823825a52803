"""./contact serve: builds the book and serves it on this machine.

The lessons are built first, because nothing has to be compiled for them, and of these the one that
is opened. Everything else is built in the background, in the order in which pages request it.
Ctrl-C stops the server and every build.
"""

from __future__ import annotations

import argparse
import functools
import http.client
import http.server
import json
import os
import re
import signal
import socket
import sys
import tempfile
import threading
import time
from collections.abc import Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from html.parser import HTMLParser
from http import HTTPStatus
from pathlib import Path
from typing import ClassVar
from urllib.parse import parse_qs, quote, unquote, urldefrag, urljoin, urlsplit

import steps
from steps import SITE

DEFAULT_PORT = 8000
# Parts of the page that are built at a time: a figure keeps one core busy.
AT_ONCE = 2


class Waiting:
    """What is waiting to be built, in order; what an open page asks for goes first.

    `parts` are things that can be built by themselves, each with the name of what it is a part of.
    Several things are built at a time, but of exercises one: all of them are told in one list.
    """

    def __init__(self, names: list[str], parts: Mapping[str, str] | None = None) -> None:
        self._names = names  # those that are being built come first
        self._parts = parts or {}
        self._begun: list[str] = []
        self._built: set[str] = set()
        self._lock = threading.Lock()

    def want(self, name: str) -> None:
        with self._lock:
            if name in self._begun or name in self._built:
                return
            if name in self._names:
                self._names.remove(name)
            elif self._parts.get(name) not in self._names:
                return
            self._names.insert(len(self._begun), name)

    def take(self) -> str | None:
        """The next that can be built now; from here on it is being built, until it is dropped."""
        with self._lock:
            busy = any(is_of_exercises(name) for name in self._begun)
            for name in self._names[len(self._begun) :]:
                if not (busy and is_of_exercises(name)):
                    self._names.remove(name)
                    self._names.insert(len(self._begun), name)
                    self._begun.append(name)
                    return name
            return None

    def drop(self, name: str) -> None:
        with self._lock:
            self._names.remove(name)
            self._begun.remove(name)
            self._built.add(name)

    def names(self) -> list[str]:
        with self._lock:
            return list(self._names)

    def begun(self) -> list[str]:
        with self._lock:
            return list(self._begun)


def is_of_exercises(name: str) -> bool:
    """Whether this is built as steps.part_of_page() builds exercises."""
    return name.startswith(("exercise ", "exercises "))


class Lessons:
    """Which pages can be read while the lessons are built.

    Sphinx writes next the page that was asked for last, and tells in a folder which are written
    (docs/_ext/contact_book/page_order.py). Where all were written before, they are served
    meanwhile.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._lock = threading.Lock()
        # What is written last of a site.
        self._whole = (SITE / "offline.json").exists()
        self.built = False
        for name in ("wanted", "ready"):
            (folder / name).write_text("")

    def is_ready(self, name: str) -> bool:
        """Whether this page can be read, as far as is known before all are built."""
        if self.built or (self._whole and (SITE / f"{name}.html").exists()):
            return True
        return name in (self._folder / "ready").read_text("utf-8").split()

    def to_come(self, path: str) -> bool:
        """Whether this is a page that cannot be read yet; asking for it makes it the next."""
        page = f"{path}index.html" if path.endswith("/") else path
        name = page.removeprefix("/").removesuffix(".html")
        if not page.endswith(".html") or not re.fullmatch(r"[\w/-]+", name) or self.is_ready(name):
            return False
        with self._lock, (self._folder / "wanted").open("a", encoding="utf-8") as wanted:
            wanted.write(f"{name}\n")
        return True


TO_COME = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<meta name="color-scheme" content="light dark"><meta http-equiv="refresh" content="1">
<title>This page is being built</title></head>
<body><p role="status">This page is being built and will appear by itself.</p></body></html>
"""


class Handler(http.server.SimpleHTTPRequestHandler):
    """Static files, of the types that browsers insist on, never stale."""

    extensions_map = {  # noqa: RUF012 (the base class declares it so)
        **http.server.SimpleHTTPRequestHandler.extensions_map,
        ".js": "text/javascript",
        ".mjs": "text/javascript",
        ".wasm": "application/wasm",
        ".json": "application/json",
        ".svg": "image/svg+xml",
        ".woff2": "font/woff2",
        ".gz": "application/gzip",
        ".epub": "application/epub+zip",
    }

    waiting: ClassVar[Waiting]
    lessons: ClassVar[Lessons]

    def do_GET(self) -> None:
        """Files, and what is being built (page/web/src/pending.ts asks)."""
        address = urlsplit(self.path)
        if self.lessons.to_come(address.path):
            self._answer("text/html; charset=utf-8", TO_COME)
            return
        if address.path != "/building.json":
            super().do_GET()
            return
        for name in parse_qs(address.query).get("want", [])[:1]:
            self.waiting.want(name)
        said = {"waiting": self.waiting.names(), "building": self.waiting.begun()}
        self._answer("application/json", json.dumps(said))

    def _answer(self, kind: str, text: str) -> None:
        content = text.encode()
        self.send_response(HTTPStatus.OK)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)

    def end_headers(self) -> None:
        # What is rebuilt behind must be seen at the next load.
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()

    def log_message(self, format: str, *args: object) -> None:
        """Says nothing: the terminal is for what the reader has to know."""

    def log_error(self, format: str, *args: object) -> None:
        if args and args[0] != HTTPStatus.NOT_FOUND:
            print(format % args, file=sys.stderr)


class Server(http.server.ThreadingHTTPServer):
    daemon_threads = True
    # Another server's port must not be shared silently.
    allow_reuse_port = False

    def handle_error(self, request: object, client_address: object) -> None:
        """A browser that goes away in the middle of a file is no event."""
        if not isinstance(sys.exc_info()[1], ConnectionError):
            super().handle_error(request, client_address)  # type: ignore[arg-type]


def open_server(port: int, waiting: Waiting, lessons: Lessons) -> Server:
    Handler.waiting = waiting
    Handler.lessons = lessons
    handler = functools.partial(Handler, directory=str(SITE))
    if is_taken(port):
        print(f"Port {port} is taken; using a free one.")
        port = 0
    return Server(("127.0.0.1", port), handler)


def is_taken(port: int) -> bool:
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind(("127.0.0.1", port))
        except OSError:
            return True
    return False


# --- Building -------------------------------------------------------------------------------------


def build(step: steps.Step) -> bool:
    """Runs a step, with a line. False if it fails, after its own words and what to do."""
    if steps.CHILDREN.stopping:
        return False
    print(f"Building {step.what} ...", flush=True)
    done = step.run()
    if steps.CHILDREN.stopping:
        return False
    if not done.ok:
        print(f"{done.tail()}\n", file=sys.stderr)
        log = done.log.relative_to(steps.ROOT)
        again = "Put it right and start ./contact serve again: what is built is kept."
        print(
            f"contact: building {step.what} failed; all of it: {log}. {again}",
            file=sys.stderr,
            flush=True,
        )
        return False
    print(f"Built {step.what} in {done.seconds:.0f} s.", flush=True)
    return True


def build_beside(step: steps.Step) -> Future[bool]:
    """Builds in a thread that an interrupt need not wait for."""
    built: Future[bool] = Future()

    def run() -> None:
        try:
            built.set_result(build(step))
        except BaseException as error:
            built.set_exception(error)

    threading.Thread(target=run, daemon=True).start()
    return built


class Behind(threading.Thread):
    """Builds what the reader can begin without. One step that fails stops no other."""

    def __init__(self, waiting: Waiting, *, ebook: bool) -> None:
        super().__init__(daemon=True)
        self._waiting = waiting
        self._ebook = ebook
        self.ok = False

    def run(self) -> None:
        began = time.monotonic()
        if first := self._what_pages_ask_for():
            took = time.monotonic() - began
            print(f"Built figures, ladders and exercises ({took:.0f} s).", flush=True)
        rest = [*steps.BEHIND, *([steps.EBOOK_STEP] if self._ebook else []), steps.PROGRAM_STEP]
        self.ok = all([first, *(build(step) for step in rest)])
        if self.ok:
            took = time.monotonic() - began
            print(f"Everything is built ({took:.0f} s). Reload a page to see it.", flush=True)
        elif not steps.CHILDREN.stopping:
            print("The book is served without what failed.", flush=True)

    def _what_pages_ask_for(self) -> bool:
        with ThreadPoolExecutor(AT_ONCE) as pool:
            return all(list(pool.map(lambda _: self._one_after_another(), range(AT_ONCE))))

    def _one_after_another(self) -> bool:
        ok = True
        while (name := self._waiting.take()) is not None and not steps.CHILDREN.stopping:
            ok = build(steps.part_of_page(name)) and ok
            self._waiting.drop(name)
        return ok


# --- --once ---------------------------------------------------------------------------------------


class Links(HTMLParser):
    """The addresses that a page itself loads or leads to."""

    def __init__(self) -> None:
        super().__init__()
        self.found: set[str] = set()
        # What the page names as the address that its own are relative to.
        self.base = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag == "base":
            self.base = dict(attrs).get("href") or ""
        for name, value in attrs:
            if value and (name == "src" or (name == "href" and tag in {"a", "link"})):
                self.found.add(value)


def fetch_all(port: int) -> list[str]:
    """Fetches every page, and everything of ours that a page names. Returns what was wrong."""
    pages = [file for file in sorted(SITE.rglob("*.html")) if "_static" not in file.parts]
    origin = f"http://127.0.0.1:{port}"
    wanted: dict[str, str] = {}
    for page in pages:
        path = "/" + quote(page.relative_to(SITE).as_posix())
        wanted.setdefault(path, "the site")
        links = Links()
        links.feed(page.read_text(encoding="utf-8"))
        for link in links.found:
            target = urlsplit(urljoin(urljoin(origin + path, links.base), urldefrag(link).url))
            if f"{target.scheme}://{target.netloc}" == origin and target.path:
                wanted.setdefault(target.path, path)
    wrong = []
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=30)
    for path, named_by in sorted(wanted.items()):
        connection.request("GET", path)
        answer = connection.getresponse()
        answer.read()
        if answer.status != HTTPStatus.OK:
            wrong.append(f"{unquote(path)} ({named_by} names it): {answer.status} {answer.reason}")
    connection.close()
    print(f"Fetched {len(pages)} pages and {len(wanted) - len(pages)} other files.")
    return wrong if pages else ["there is no page at all"]


# --- Where things lie -----------------------------------------------------------------------------


def where_things_lie(address: str, *, ebook: bool) -> str:
    name = steps.EBOOK.relative_to(steps.ROOT)
    if steps.EBOOK.exists():
        where = f"{name}; {address}{steps.EBOOK.name}"
    else:
        where = f"{name}, as soon as it is built" if ebook else "./contact serve --ebook makes it"
    lines = (
        f"The book: {address}",
        f"Search:   {address}search.html, or press / on any page",
        f"E-book:   {where}",
        "Dark:     as your system has it; the button at the top right of every page changes it",
        "Phone:    the same pages, which fold to a narrow window; only this machine is answered",
        "On paper: print a page from the browser (Ctrl-P); its controls stay behind",
    )
    return "\n" + "".join(f"  {line}\n" for line in lines)


# --- Together -------------------------------------------------------------------------------------


def serve(port: int, *, once: bool, ebook: bool) -> int:
    # The home page leads to the e-book only where there is one, or will be.
    os.environ["CONTACT_BOOK_EBOOK"] = "1" if once or ebook or steps.EBOOK.exists() else "0"
    if not build(steps.SCRIPTS_ONLY):
        return 1
    with tempfile.TemporaryDirectory(prefix="pages-", dir=steps.BUILD) as folder:
        return serve_from(Lessons(Path(folder)), folder, port, once=once, ebook=ebook)


def serve_from(lessons: Lessons, folder: str, port: int, *, once: bool, ebook: bool) -> int:
    """Builds and serves; Sphinx tells in the folder which pages are written."""
    waiting = Waiting(*steps.waiting_parts())
    server = open_server(port, waiting, lessons)
    port = server.server_address[1]
    behind = Behind(waiting, ebook=once or ebook)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    try:
        thread.start()
        os.environ["CONTACT_BOOK_PAGES"] = folder
        built = build_beside(steps.LESSONS)
        while not built.done() and not lessons.is_ready("index"):
            time.sleep(0.2)
        if not built.done() or built.result():
            address = f"http://127.0.0.1:{port}/"
            print(where_things_lie(address, ebook=once or ebook), flush=True)
        if not built.result():
            return 1
        del os.environ["CONTACT_BOOK_PAGES"]
        lessons.built = True
        behind.start()
        if once:
            behind.join()
            wrong = fetch_all(port)
            print("\n".join(wrong) if wrong else "All of them are there.")
            return 0 if behind.ok and not wrong else 1
        print("Ctrl-C stops it.", flush=True)
        thread.join()
        return 0
    finally:
        steps.CHILDREN.stop_all()
        server.shutdown()
        server.server_close()


def port_number(text: str) -> int:
    if not text.isdigit() or int(text) > 65535:
        raise argparse.ArgumentTypeError(f'a port is a number from 0 to 65535, not "{text}"')
    return int(text)


def main() -> int:
    parser = argparse.ArgumentParser(prog="./contact serve", description=__doc__)
    parser.add_argument("--port", type=port_number, default=DEFAULT_PORT)
    parser.add_argument("--once", action="store_true")
    parser.add_argument("--ebook", action="store_true")
    arguments = parser.parse_args()
    # Also when started in the background, where a shell has interrupts ignored; and a plain kill is
    # as clean as Ctrl-C.
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.default_int_handler)
    try:
        return serve(arguments.port, once=arguments.once, ebook=arguments.ebook)
    except KeyboardInterrupt:
        steps.CHILDREN.stop_all()
        print("\nStopped.", flush=True)
        return 0


if __name__ == "__main__":
    sys.exit(main())
