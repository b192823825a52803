"""watch: sees a save however an editor makes it, checks that file only, and ends cleanly."""

from __future__ import annotations

import queue
import signal
import subprocess
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from wrong_answers import wrong_answer

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build" / "dev" / "bin" / "contact"
WRONG = wrong_answer("02_triangles/ray_triangle", "one_sided").read_text()

pytestmark = pytest.mark.usefixtures("clean_after")


class Watch:
    """A running watch, whose lines are read as they come."""

    def __init__(self, words: list[str], environment: dict[str, str], folder: Path) -> None:
        self.process = subprocess.Popen(
            [str(PROGRAM), "watch", *words],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env=environment,
            cwd=folder,
        )
        self.seen: list[str] = []
        self._lines: queue.Queue[str | None] = queue.Queue()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self._lines.put(line.rstrip("\n"))
        self._lines.put(None)

    def until(self, text: str, seconds: float = 120) -> list[str]:
        """The lines up to the next one that holds the text."""
        end = time.monotonic() + seconds
        lines: list[str] = []
        while (left := end - time.monotonic()) > 0:
            try:
                line = self._lines.get(timeout=left)
            except queue.Empty:
                break
            if line is None:
                break
            lines.append(line)
            self.seen.append(line)
            if text in line:
                return lines
        raise AssertionError(f"no line with {text!r} in {lines}")

    def quiet(self, seconds: float) -> bool:
        """Whether nothing is said for a while."""
        try:
            line = self._lines.get(timeout=seconds)
        except queue.Empty:
            return True
        raise AssertionError(f"unexpected: {line!r}")

    def interrupt(self, number: int = signal.SIGINT) -> int:
        self.process.send_signal(number)
        return self.process.wait(timeout=20)


Start = Callable[..., Watch]


@pytest.fixture
def watch(
    environment: dict[str, str], tmp_path: Path, clean_after: None
) -> Iterator[Callable[..., Watch]]:
    started: list[Watch] = []

    def start(*words: str) -> Watch:
        started.append(Watch(list(words), environment, tmp_path))
        return started[-1]

    yield start
    for each in started:
        if each.process.poll() is None:
            each.interrupt()


def save_by_rename(copy: Path, text: str) -> None:
    """As most editors do: a new file beside the old one, renamed over it."""
    beside = copy.with_name(copy.name + ".new")
    beside.write_text(text)
    beside.rename(copy)


def save_with_backup(copy: Path, text: str) -> None:
    """As vim does: the old file is renamed away, a new one is made and filled."""
    copy.rename(copy.with_name(copy.name + "~"))
    copy.write_text(text)


def save_in_place(copy: Path, text: str) -> None:
    copy.write_text(text)


SAVES = [save_by_rename, save_with_backup, save_in_place]


def test_it_makes_the_copy_and_says_where(watch: Start, work: Path) -> None:
    running = watch("ray_triangle")
    lines = running.until("Watching")
    assert (work / "02_triangles/ray_triangle.cpp").exists()
    assert any("Made in" in line and "ray_triangle.cpp" in line for line in lines)
    assert any("not attempted" in line for line in lines)
    assert running.interrupt() == 130


@pytest.mark.parametrize("save", SAVES)
def test_it_sees_every_way_of_saving(
    watch: Start, work: Path, solution: str, save: Callable[[Path, str], None]
) -> None:
    copy = work / "02_triangles/ray_triangle.cpp"
    running = watch("ray_triangle")
    running.until("Watching")
    save(copy, WRONG)
    lines = running.until("ray_triangle: failed")
    assert any(line.strip().startswith("hint") for line in lines)
    save(copy, solution)
    running.until("ray_triangle: passed")


def test_polling_sees_saves_too(watch: Start, work: Path, solution: str) -> None:
    running = watch("ray_triangle", "--poll")
    lines = running.until("Watching")
    assert any("no events" in line for line in lines)
    save_by_rename(work / "02_triangles/ray_triangle.cpp", solution)
    running.until("ray_triangle: passed")


def test_only_the_saved_file_is_checked(watch: Start, work: Path, solution: str) -> None:
    running = watch()
    running.until("Watching")
    assert len(list(work.glob("*/*.cpp"))) > 1
    save_by_rename(work / "02_triangles/ray_triangle.cpp", solution)
    running.until("ray_triangle: passed")
    assert running.quiet(1.5)


def test_other_files_of_the_folder_are_ignored(watch: Start, work: Path) -> None:
    running = watch("ray_triangle")
    running.until("Watching")
    (work / "02_triangles/.ray_triangle.cpp.swp").write_text("x")
    (work / "02_triangles/notes.txt").write_text("x")
    assert running.quiet(1.0)


def test_a_save_while_checking_begins_anew(
    watch: Start, work: Path, solution: str, spoiled: Callable[[str], str]
) -> None:
    copy = work / "02_triangles/ray_triangle.cpp"
    running = watch("ray_triangle")
    running.until("Watching")
    save_by_rename(copy, spoiled("for (volatile int i = 0;;) i = i + 1;"))
    time.sleep(1.5)
    start = time.monotonic()
    save_by_rename(copy, solution)
    lines = running.until("ray_triangle: passed")
    assert not any("endless loop" in line for line in lines)
    # The loop alone would have taken five seconds for each of its tests.
    assert time.monotonic() - start < 20


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_an_interrupt_while_checking_leaves_nothing(
    watch: Start,
    work: Path,
    spoiled: Callable[[str], str],
    number: int,
    temporary: Path,
) -> None:
    running = watch("ray_triangle")
    running.until("Watching")
    copy = work / "02_triangles/ray_triangle.cpp"
    save_by_rename(copy, spoiled("for (volatile int i = 0;;) i = i + 1;"))
    end = time.monotonic() + 60
    while not list(temporary.glob("contact-*/ray_triangle")) and time.monotonic() < end:
        time.sleep(0.05)
    time.sleep(0.3)
    assert running.interrupt(number) == 130


def test_check_can_be_interrupted(
    environment: dict[str, str], work: Path, spoiled: Callable[[str], str], temporary: Path
) -> None:
    copy = work / "02_triangles/ray_triangle.cpp"
    copy.parent.mkdir(parents=True)
    copy.write_text(spoiled("for (volatile int i = 0;;) i = i + 1;"))
    process = subprocess.Popen([str(PROGRAM), "check", "ray_triangle"], env=environment)
    end = time.monotonic() + 60
    while not list(temporary.glob("contact-*/ray_triangle")) and time.monotonic() < end:
        time.sleep(0.05)
    time.sleep(0.3)
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=20) == 130


def test_a_terminal_shows_colour_unless_told_not_to(
    on_a_terminal: Callable[..., str],
    environment: dict[str, str],
    work: Path,
    solution: str,
) -> None:
    copy = work / "02_triangles/ray_triangle.cpp"
    copy.parent.mkdir(parents=True)
    copy.write_text(solution)
    check = ("stdout", "check", "ray_triangle")
    environment.pop("NO_COLOR", None)
    assert "\x1b[" in on_a_terminal(*check, TERM="xterm")
    assert "\x1b[" not in on_a_terminal(*check, TERM="xterm", NO_COLOR="1")
