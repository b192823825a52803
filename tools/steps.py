"""What serve.py and test.py share: where things are, how commands are run, what is built."""

from __future__ import annotations

import fcntl
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"
DEV = BUILD / "dev"
LOGS = BUILD / "logs"
SITE = BUILD / "site"
# As docs/build.py names it.
EBOOK = SITE / "contact-hours.epub"
PROGRAM = DEV / "bin" / "contact"
# Seconds after which a step hangs rather than works, on any machine.
STEP_LIMIT = 3600.0
# How a fetching script ends where what it fetches cannot be had.
CANNOT_BE_HAD = 3

# Colour codes and the like, which some tools print even to a file.
_ESCAPES = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]")


@dataclass(frozen=True)
class Done:
    """A command that has ended. `code` is None if it was stopped at its time limit."""

    code: int | None
    output: str
    seconds: float
    log: Path

    @property
    def ok(self) -> bool:
        return self.code == 0

    def tail(self, lines: int = 40) -> str:
        kept = self.output.rstrip().splitlines()[-lines:]
        return "\n".join(kept)


def environment(extra: Mapping[str, str] | None = None) -> dict[str, str]:
    """The environment of every command: plain output, and the venv's programs first."""
    result = dict(os.environ)
    result["PATH"] = f"{BUILD / 'venv' / 'bin'}{os.pathsep}{result.get('PATH', '')}"
    result["CONTACT_ROOT"] = str(ROOT)
    result["NO_COLOR"] = "1"
    result["PYTHONDONTWRITEBYTECODE"] = "1"
    result.update(extra or {})
    return result


class Children:
    """The commands that are running, so that Ctrl-C can end them with all that they started."""

    def __init__(self) -> None:
        self._running: set[subprocess.Popen[bytes]] = set()
        self.stopping = False

    def start(self, process: subprocess.Popen[bytes]) -> None:
        self._running.add(process)

    def end(self, process: subprocess.Popen[bytes]) -> None:
        self._running.discard(process)

    def stop_all(self) -> None:
        self.stopping = True
        for process in list(self._running):
            stop(process)


CHILDREN = Children()


def stop(process: subprocess.Popen[bytes]) -> None:
    """Ends a command and everything in its process group, politely first."""
    for signal_number, patience in ((signal.SIGTERM, 5.0), (signal.SIGKILL, 5.0)):
        try:
            os.killpg(process.pid, signal_number)
        except ProcessLookupError:
            return
        try:
            process.wait(patience)
        except subprocess.TimeoutExpired:
            continue
        return


def seconds_of_run() -> float:
    """How long this stage may still run: $CONTACT_UNTIL, if the run gave it a moment to end at."""
    until = os.environ.get("CONTACT_UNTIL")
    return float(until) - time.monotonic() if until else float("inf")


def run_is_over() -> bool:
    return seconds_of_run() <= 0


def lower_priority(process: subprocess.Popen[bytes]) -> None:
    """Lowers the priority of this command, if $CONTACT_LOW_PRIORITY is set.

    The command is a session of its own, and Linux shares processors among sessions.
    """
    if not os.environ.get("CONTACT_LOW_PRIORITY"):
        return
    with suppress(OSError):
        os.setpriority(os.PRIO_PGRP, process.pid, 10)
        Path(f"/proc/{process.pid}/autogroup").write_text("10")


def run(
    command: Sequence[str | Path],
    log: str,
    *,
    cwd: Path = ROOT,
    limit: float | None = None,
    extra: Mapping[str, str] | None = None,
) -> Done:
    """Runs a command, its output in build/logs/LOG.log; ends it when `limit` seconds are over.

    It ends too when the time of the run is over (seconds_of_run()).
    """
    left = seconds_of_run()
    if limit is None or left < limit:
        limit = None if left == float("inf") else max(0.1, left)
    LOGS.mkdir(parents=True, exist_ok=True)
    path = LOGS / f"{log}.log"
    began = time.monotonic()
    code: int | None
    with path.open("wb") as output:
        try:
            process = subprocess.Popen(
                [str(word) for word in command],
                cwd=cwd,
                env=environment(extra),
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=subprocess.STDOUT,
                start_new_session=True,
            )
        except OSError as error:
            output.write(f"{command[0]}: {error.strerror}\n".encode())
            output.flush()
            return Done(127, path.read_text(), time.monotonic() - began, path)
        CHILDREN.start(process)
        lower_priority(process)
        try:
            code = process.wait(limit)
        except subprocess.TimeoutExpired:
            stop(process)
            code = None
            output.write(f"\nStopped at its limit of {limit:.0f} s.\n".encode())
        except BaseException:
            stop(process)
            raise
        finally:
            CHILDREN.end(process)
    text = _ESCAPES.sub("", path.read_text(encoding="utf-8", errors="replace"))
    return Done(code, text, time.monotonic() - began, path)


@contextmanager
def build_lock(preset: str = "dev") -> Iterator[None]:
    """One build in a folder at a time: two Ninjas in one spoil each other's work.

    ./contact takes the lock of build/dev too.
    """
    BUILD.mkdir(exist_ok=True)
    with (BUILD / ("lock" if preset == "dev" else f"lock-{preset}")).open("w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def native_targets(prefixes: Sequence[str]) -> list[str]:
    """The targets of build/dev whose names begin so; chapters are found, not listed."""
    done = run(["cmake", "--build", DEV, "--target", "help"], "targets")
    if not done.ok and run_is_over():
        return []
    if not done.ok:
        sys.exit(f"{done.tail()}\ncontact: the build is not configured; try ./contact setup")
    names = re.findall(r"^([A-Za-z0-9_]+): phony$", done.output, re.MULTILINE)
    return sorted({name for name in names if name.startswith(tuple(prefixes))})


def build_native(targets: Sequence[str], log: str) -> Done:
    """Builds these targets of build/dev."""
    wanted = [word for target in targets for word in ("--target", target)]
    if not wanted:
        return Done(0, "", 0.0, LOGS / f"{log}.log")
    with build_lock():
        return run(["cmake", "--build", DEV, *wanted], log, limit=STEP_LIMIT)


# --- How the book is built ------------------------------------------------------------------------


@dataclass(frozen=True)
class Step:
    """One step towards the book; what has not changed is not done again."""

    what: str
    run: Callable[[], Done]


def _page_programs() -> Done:
    """The programs whose output the pages show: ladders without a kept result."""
    kept = {file.name.split(".")[0] for file in (ROOT / "benchmarks" / "results").glob("*.json")}
    ladders = {file.parent.name for file in ROOT.glob("chapters/*/ladder.cpp")} - kept
    wanted = sorted(f"ladder_{slug}" for slug in ladders)
    return build_native(wanted, "book-native")


def node(log: str, *words: str) -> Callable[[], Done]:
    """A program of page/, to be run."""
    return lambda: run(["node", *words], log, cwd=ROOT / "page", limit=STEP_LIMIT)


def page_exercises(*only: str) -> Done:
    """The compiler that the page loads and the exercises' tests, as WebAssembly.

    `only`: exercises, or chapters; none of them are all. What is built already is kept.

    Catch2's source comes from the package archive; where there is none, the book goes without.
    """
    fetched = run([ROOT / "tools" / "fetch_catch2_source.sh"], "book-catch2", limit=STEP_LIMIT)
    if fetched.code == CANNOT_BE_HAD:
        print(f"{fetched.tail()}\nThe pages go without checking exercises.", flush=True)
        return Done(0, fetched.output, fetched.seconds, fetched.log)
    if not fetched.ok:
        return fetched
    narrowed = [word for name in only for word in ("--only", name)]
    return node("book-exercises", "wasm/build.mjs", "toolchain", *narrowed)()


def build_book(*, figures: bool = True, ebook: bool | None = None) -> Done:
    """Doxygen and Sphinx; any warning fails.

    `figures`: all of them must be built; `ebook`: whether the pages link to it, if that is not said
    in the environment.
    """
    extra = {} if ebook is None else {"CONTACT_BOOK_EBOOK": "1" if ebook else "0"}
    return run(_complete_book(figures), "book-pages", limit=STEP_LIMIT, extra=extra)


def build_ebook(*, figures: bool = True) -> Done:
    """The pages once more, as one file; any warning fails."""
    return run([*_complete_book(figures), "--builder", "epub"], "book-ebook", limit=STEP_LIMIT)


def _complete_book(figures: bool) -> list[str | Path]:
    command: list[str | Path] = [sys.executable, ROOT / "docs" / "build.py", "--complete"]
    return command if figures else [*command, "--some-figures"]


def build_lessons() -> Done:
    """The pages with whatever is built already; the API's only if they were built before."""
    command: list[str | Path] = [sys.executable, ROOT / "docs" / "build.py"]
    if not (BUILD / "doxygen").is_dir():
        command.append("--skip-api")
    return run(command, "book-lessons", limit=STEP_LIMIT)


def configure() -> Done:
    """Says what is to be built natively, unless that is said already."""
    if (DEV / "build.ninja").is_file():
        return Done(0, "", 0.0, LOGS / "configure.log")
    with build_lock():
        return run(["cmake", "-S", ROOT, "--preset", "dev"], "configure", limit=STEP_LIMIT)


def waiting_parts() -> tuple[list[str], dict[str, str]]:
    """What the page runs and is not built: figures and players, exercises, ladders; in this order.

    Figures have the names of page/wasm/build.mjs; the others are called "exercises 02_triangles"
    and "ladder 02_triangles". Second, what can be built by itself, with what it is a part of:
    "exercise 02_triangles/ray_triangle". What is built may be out of date: it works, and is brought
    up to date with all the others.
    """
    exercises = _waiting_exercises()
    chapters = list(dict.fromkeys(name.split("/")[0] for name in exercises))
    ladders = [
        file.parent.name
        for file in sorted(ROOT.glob("chapters/*/ladder.cpp"))
        if not (BUILD / "web" / "ladders" / f"{file.parent.name}.wasm").is_file()
    ]
    names = [
        *_waiting_figures(),
        *(f"exercises {slug}" for slug in chapters),
        *(f"ladder {slug}" for slug in ladders),
    ]
    return names, {f"exercise {name}": f"exercises {name.split('/')[0]}" for name in exercises}


def _waiting_exercises() -> list[str]:
    try:
        built = json.loads((BUILD / "web" / "cpp" / "manifest.json").read_text())["exercises"]
    except (OSError, ValueError, KeyError):
        built = {}
    found = [
        f"{file.parts[-3]}/{file.parts[-2]}"
        for file in sorted(ROOT.glob("exercises/*/*/exercise.toml"))
    ]
    return [name for name in found if name not in built]


# The scene player, and the scene that its page opens with: one name takes both.
_PLAYER = ("scenes/player.wasm", "scenes/opening.wasm")
# The book's answers on the page "Ask the engines".
_ENGINES = "engines/queries"


def _waiting_figures() -> list[str]:
    made = BUILD / "web"
    found = []
    for source in sorted(ROOT.glob("chapters/*/figures/*.cpp")):
        slug, name = source.parts[-3], source.stem
        if not (made / "figures" / slug / f"{name}.wasm").is_file():
            found.append(f"{slug}/{name}")
    for scenes in ROOT.glob("chapters/*/scenes"):
        if not all((made / product).is_file() for product in _PLAYER):
            found.append(f"{scenes.parent.name}/scene_player")
    if not (made / f"{_ENGINES}.wasm").is_file():
        found.append(_ENGINES)
    return found


def part_of_page(name: str) -> Step:
    """One of waiting_parts()."""
    kind, _, which = name.rpartition(" ")
    if not kind:
        return Step(f"the figure {which}", lambda: _build_figure(which))
    if kind == "ladder":
        return Step(f"the ladder of {which}", lambda: _build_ladder(which))
    return Step(f"the {kind} {which}", lambda: _build_exercises(which))


def _one_product(kind: str, name: str) -> Done:
    """With one process, for two of them are made at a time; each has a log of its own."""
    words = ("wasm/build.mjs", kind, "--only", name, "--workers", "1", "--quiet")
    return node(f"book-{kind}-{name.replace('/', '-')}", *words)()


def _products_of(name: str) -> tuple[str, ...]:
    if name.endswith("/scene_player"):
        return _PLAYER
    return (f"{name}.wasm",) if name == _ENGINES else (f"figures/{name}.wasm",)


def _build_figure(name: str) -> Done:
    done = _one_product("figures", name)
    if done.ok:
        for product in _products_of(name):
            _beside_the_pages(product)
    return done


def _build_ladder(slug: str) -> Done:
    done = _one_product("ladders", slug)
    if done.ok:
        _beside_the_pages(f"ladders/{slug}.wasm")
    return done


def _build_exercises(which: str) -> Done:
    """The tests of one exercise, or of a chapter's, and with the first the compiler."""
    done = page_exercises(which)
    folder = BUILD / "web" / "cpp"
    if done.ok and (folder / "manifest.json").is_file():
        for file in sorted(folder.rglob("*")):
            name = file.relative_to(BUILD / "web").as_posix()
            # The list names the others, so it comes last.
            if file.is_file() and file.name != "manifest.json" and not _is_beside(name):
                _beside_the_pages(name)
        _beside_the_pages("cpp/manifest.json")
    return done


def _is_beside(name: str) -> bool:
    return (SITE / "_static" / "contact" / name).is_file()


def _beside_the_pages(name: str) -> None:
    """Copies what is built for the page to where it is served."""
    target = SITE / "_static" / "contact" / name
    target.parent.mkdir(parents=True, exist_ok=True)
    beside = target.with_name(f".{target.name}")
    shutil.copy2(BUILD / "web" / name, beside)
    beside.replace(target)


SCRIPTS_ONLY = Step("the page's scripts", node("book-web", "web/build.mjs", "--scripts-only"))
SCRIPTS = Step("the page's scripts and pictures", node("book-web", "web/build.mjs"))
FIGURES = Step("the figures' C++ for the page", node("book-figures", "wasm/build.mjs", "figures"))
LADDERS = Step("the ladders' C++ for the page", node("book-ladders", "wasm/build.mjs", "ladders"))
COMPILER = Step("the compiler and the exercises for the page", page_exercises)
PAGE_PROGRAMS = Step("the programs whose results the pages show", _page_programs)
PAGES = Step("the pages with all that", build_book)
EBOOK_STEP = Step("the e-book", build_ebook)

# What a reader needs to begin, after SCRIPTS_ONLY: nothing of it is compiled.
LESSONS = Step("the lessons", build_lessons)
# What can come while they read, after the figures. The pages are built again, to take it all in.
BEHIND = (
    FIGURES,
    LADDERS,
    COMPILER,
    SCRIPTS,
    Step("the configuration of the programs", configure),
    PAGE_PROGRAMS,
    PAGES,
)
# Last, and for who asks: the e-book takes a minute.
PROGRAM_STEP = Step(
    "the program, for the exercises", lambda: build_native(["contact"], "book-program")
)
# Where nobody waits to read, both at once, so that neither core rests.
FIGURES_AND_LADDERS = Step(
    "the figures' and the ladders' C++ for the page",
    node("book-figures", "wasm/build.mjs", "figures", "ladders"),
)
