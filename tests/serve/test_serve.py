"""./contact serve, on a book that is built: a taken port, what is served, and Ctrl-C."""

from __future__ import annotations

import http.client
import json
import os
import re
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from queue import Empty, Queue

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import serve  # noqa: E402
from serve import Handler, Lessons, Server, Waiting, open_server  # noqa: E402


def lines_of(process: subprocess.Popen[str]) -> Queue[str]:
    lines: Queue[str] = Queue()

    def read() -> None:
        assert process.stdout is not None
        for line in process.stdout:
            lines.put(line)

    threading.Thread(target=read, daemon=True).start()
    return lines


def wait_for(pattern: str, lines: Queue[str], seconds: float) -> re.Match[str]:
    seen: list[str] = []
    try:
        while True:
            seen.append(lines.get(timeout=seconds))
            if match := re.search(pattern, seen[-1]):
                return match
    except Empty:
        raise AssertionError(f"no line with {pattern}; there were:\n{''.join(seen)}") from None


def children_of(pid: int) -> list[int]:
    """What it started, where the system says so (Linux)."""
    listed = [file.read_text() for file in Path(f"/proc/{pid}/task").glob("*/children")]
    return [int(word) for text in listed for word in text.split()]


def ebook_if_built(said: str) -> list[tuple[str, int, str]]:
    """It is made only on request; otherwise the line says how to request it."""
    built = re.match(r"build/site/(\S+\.epub);", said)
    assert built or "./contact serve --ebook" in said
    return [(f"/{built[1]}", 200, "application/epub+zip")] if built else []


def test_a_taken_port_what_is_served_and_an_interrupt() -> None:
    if not (ROOT / "build/site/index.html").exists():
        pytest.skip("the book is not built")
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        process = subprocess.Popen(
            [ROOT / "contact", "serve", "--port", str(port)],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            start_new_session=True,
        )
        try:
            lines = lines_of(process)
            wait_for(f"Port {port} is taken", lines, 240)
            served = int(wait_for(r"The book: http://127\.0\.0\.1:(\d+)/", lines, 30)[1])
            search = wait_for(rf"Search: +http://127\.0\.0\.1:{served}(/search\.html)", lines, 5)[1]
            ebook = wait_for(r"E-book: +(\S.*)", lines, 5)[1]
            wait_for(r"On paper: .*print", lines, 5)
            connection = http.client.HTTPConnection("127.0.0.1", served, timeout=10)
            wasm = next((ROOT / "build/site").rglob("*.wasm")).relative_to(ROOT / "build/site")
            for path, status, kind in (
                ("/", 200, "text/html"),
                (f"/{wasm.as_posix()}", 200, "application/wasm"),
                (search, 200, "text/html"),
                *ebook_if_built(ebook),
                ("/building.json", 200, "application/json"),
                ("/../../contact", 404, None),
            ):
                connection.request("GET", path)
                answer = connection.getresponse()
                answer.read()
                assert answer.status == status, path
                assert kind is None or answer.headers["Content-Type"] == kind
            children = children_of(process.pid)
            os.kill(process.pid, signal.SIGINT)
            wait_for("Stopped", lines, 20)
            assert process.wait(20) == 0
            alive = {child for child in children if Path(f"/proc/{child}").exists()}
            assert alive == set()
        finally:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)


def test_what_a_page_asks_for_is_built_next() -> None:
    waiting = Waiting(["a", "b", "c", "d", "e"])
    assert [waiting.take(), waiting.take()] == ["a", "b"]
    waiting.want("d")
    assert waiting.names() == ["a", "b", "d", "c", "e"]
    waiting.want("e")
    assert waiting.names() == ["a", "b", "e", "d", "c"]
    for name in ("a", "b", "nobody knows this"):
        waiting.want(name)
    assert waiting.names() == ["a", "b", "e", "d", "c"]
    assert waiting.begun() == ["a", "b"]
    waiting.drop("b")
    assert waiting.take() == "e"
    assert waiting.begun() == ["a", "e"]
    for name in ("a", "e"):
        waiting.drop(name)
    assert [waiting.take(), waiting.take(), waiting.take()] == ["d", "c", None]


def test_a_part_that_a_page_asks_for_is_built_before_the_rest() -> None:
    waiting = Waiting(["figure", "exercises 01", "exercises 02"], {"exercise 02/a": "exercises 02"})
    assert waiting.take() == "figure"
    waiting.want("exercise 02/a")
    waiting.want("exercise 02/a")
    waiting.want("exercise 03/z")
    assert waiting.names() == ["figure", "exercise 02/a", "exercises 01", "exercises 02"]
    waiting.drop("figure")
    assert waiting.take() == "exercise 02/a"
    waiting.drop("exercise 02/a")
    waiting.want("exercise 02/a")  # is built, though what it is a part of is not
    assert waiting.names() == ["exercises 01", "exercises 02"]


def test_of_exercises_one_is_built_at_a_time() -> None:
    """Two processes would write the page's one list of exercises."""
    waiting = Waiting(
        ["exercises 01", "exercises 02", "ladder 01"], {"exercise 02/a": "exercises 02"}
    )
    assert waiting.take() == "exercises 01"
    waiting.want("exercise 02/a")
    assert waiting.take() == "ladder 01"
    assert waiting.take() is None
    assert waiting.names() == ["exercises 01", "ladder 01", "exercise 02/a", "exercises 02"]
    waiting.drop("exercises 01")
    assert waiting.take() == "exercise 02/a"


def test_the_server_says_what_is_waiting(tmp_path: Path) -> None:
    waiting = Waiting(["01/a", "01/b", "01/c"])
    waiting.take()
    server = open_server(0, waiting, Lessons(tmp_path))
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        connection = http.client.HTTPConnection("127.0.0.1", server.server_address[1], timeout=10)
        for address, said in (
            ("/building.json", ["01/a", "01/b", "01/c"]),
            ("/building.json?want=01%2Fc", ["01/a", "01/c", "01/b"]),
        ):
            connection.request("GET", address)
            answer = connection.getresponse()
            assert answer.headers["Content-Type"] == "application/json"
            assert json.loads(answer.read()) == {"waiting": said, "building": ["01/a"]}
    finally:
        server.shutdown()
        server.server_close()


def serve_a_book_without_pages(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Server:
    monkeypatch.setattr(serve, "SITE", folder / "site")
    (folder / "site/chapters").mkdir(parents=True)
    (folder / "pages").mkdir()
    server = open_server(0, Waiting([]), Lessons(folder / "pages"))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server


def test_a_page_that_is_not_written_says_so_until_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    server = serve_a_book_without_pages(tmp_path, monkeypatch)
    connection = http.client.HTTPConnection("127.0.0.1", server.server_address[1], timeout=10)

    def page(path: str) -> tuple[int, str]:
        connection.request("GET", path)
        answer = connection.getresponse()
        return answer.status, answer.read().decode()

    try:
        # Half a page may lie there while it is written.
        (tmp_path / "site/chapters/02_b.html").write_text("half a p")
        for path in ("/", "/chapters/01_a.html", "/chapters/02_b.html"):
            status, text = page(path)
            assert status == 200
            assert 'http-equiv="refresh"' in text
            assert "being built" in text
        assert (tmp_path / "pages/wanted").read_text().split() == [
            "index",
            "chapters/01_a",
            "chapters/02_b",
        ]
        (tmp_path / "site/chapters/02_b.html").write_text("a whole page")
        (tmp_path / "pages/ready").write_text("chapters/02_b\n")
        assert page("/chapters/02_b.html") == (200, "a whole page")
        assert page("/chapters/nothing.css")[0] == 404
        Handler.lessons.built = True
        assert page("/chapters/01_a.html")[0] == 404
    finally:
        server.shutdown()
        server.server_close()


def test_pages_of_a_whole_book_are_served_meanwhile_and_those_of_a_begun_one_are_not(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(serve, "SITE", tmp_path)
    (tmp_path / "index.html").write_text("the home page")
    assert Lessons(tmp_path).to_come("/")
    (tmp_path / "offline.json").write_text("{}")
    assert not Lessons(tmp_path).to_come("/")
    assert Lessons(tmp_path).to_come("/chapters/a_new_one.html")


def test_whether_a_page_is_ready_is_no_request_for_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(serve, "SITE", tmp_path)
    lessons = Lessons(tmp_path)
    assert not lessons.is_ready("index")
    assert (tmp_path / "wanted").read_text() == ""


# A server whose lessons take a minute.
SLOW = """
import sys, pathlib
sys.path.insert(0, {tools!r})
import serve, steps
serve.SITE = pathlib.Path({site!r})
steps.SCRIPTS_ONLY = steps.Step("the scripts", lambda: steps.run(["true"], "serve-test"))
steps.LESSONS = steps.Step("the lessons", lambda: steps.run(["sleep", "61.25"], "serve-test"))
sys.argv = ["serve", "--port", "0"]
sys.exit(serve.main())
"""


def test_an_interrupt_ends_the_first_build(tmp_path: Path) -> None:
    process = subprocess.Popen(
        [sys.executable, "-c", SLOW.format(tools=str(ROOT / "tools"), site=str(tmp_path))],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        start_new_session=True,
    )
    try:
        lines = lines_of(process)
        wait_for("Building the lessons", lines, 60)
        children = wait_until(lambda: children_of(process.pid))
        os.kill(process.pid, signal.SIGINT)
        wait_for("Stopped", lines, 20)
        assert process.wait(20) == 0
        assert {child for child in children if Path(f"/proc/{child}").exists()} == set()
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)


def wait_until(asked: Callable[[], list[int]], seconds: float = 20) -> list[int]:
    end = time.monotonic() + seconds
    while not (found := asked()) and time.monotonic() < end:
        time.sleep(0.05)
    return found


@pytest.mark.parametrize(("link", "wrong"), [("here.html", []), ("gone.html", ["/a/gone.html"])])
def test_a_pages_links_are_relative_to_the_base_that_it_names(
    link: str, wrong: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / "here.html").write_text("")
    (tmp_path / "b").mkdir()
    page = f'<base href="../a/lesson.html"><a href="{link}">a link</a>'
    (tmp_path / "b" / "page.html").write_text(page)
    monkeypatch.setattr(serve, "SITE", tmp_path)
    handler = partial(SimpleHTTPRequestHandler, directory=str(tmp_path))
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        found = serve.fetch_all(server.server_port)
        server.shutdown()
    assert [line.split()[0] for line in found] == wrong
