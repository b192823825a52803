"""What tries a box: a probe that does one thing in it, at each level that this machine has."""

from __future__ import annotations

import json
import os
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build" / "dev" / "bin" / "contact"
SOURCE = ROOT / "tests" / "grade" / "sandbox" / "probe.cpp"
LEVELS = ["full", "reduced"]

End = dict[str, Any]
Box = Callable[..., End]


@pytest.fixture(scope="session")
def probe(tmp_path_factory: pytest.TempPathFactory) -> Path:
    program = tmp_path_factory.mktemp("probe") / "probe"
    subprocess.run(["g++", "-std=c++20", "-O1", "-static", SOURCE, "-o", program], check=True)
    return program


@pytest.fixture(scope="session")
def best(probe: Path) -> str:
    """The level that this machine has."""
    end = run_box("full", "--show", f"{probe}=/program", "/program", "nap")
    return str(end["level"])


def command(*words: str | float | Path) -> list[str]:
    return [str(PROGRAM), "dev", "box", *map(str, words)]


def run_box(level: str, *words: str | Path, pass_fds: tuple[int, ...] = ()) -> End:
    done = subprocess.run(
        command(*words),
        capture_output=True,
        text=True,
        stdin=subprocess.DEVNULL,
        env={**os.environ, "CONTACT_ROOT": str(ROOT), "CONTACT_BOX_LEVEL": level, "SECRET": "told"},
        timeout=120,
        pass_fds=pass_fds,
    )
    assert done.returncode in (0, 1), done.stderr
    result: End = json.loads(done.stdout)
    return result


@pytest.fixture(params=LEVELS)
def level(request: pytest.FixtureRequest, best: str) -> str:
    wanted = str(request.param)
    if best not in LEVELS or LEVELS.index(wanted) < LEVELS.index(best):
        pytest.skip(f"this machine has level {best} only")
    return wanted


@pytest.fixture
def box(level: str, probe: Path) -> Box:
    """Runs an attempt of the probe in a box of that level."""

    def run(
        *attempt: str | int,
        limits: tuple[str | float, ...] = (),
        pass_fds: tuple[int, ...] = (),
    ) -> End:
        words = [*map(str, limits), "--show", f"{probe}=/program", "/program", *map(str, attempt)]
        end = run_box(level, *words, pass_fds=pass_fds)
        assert end["level"] == level
        return end

    return run


def refused(end: End) -> bool:
    """The attempt came back with an error."""
    return bool(end["output"].startswith("refused") and end["exit_code"] == 0)


def managed(end: End) -> bool:
    return bool(end["output"].endswith("managed\n") and end["exit_code"] == 0)


def processes_with(text: str) -> list[int]:
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            words = (process / "cmdline").read_bytes().decode(errors="replace")
            state = (process / "stat").read_text().rpartition(")")[2].split()[0]
        except OSError:
            continue
        if text in words and state != "Z" and int(process.name) != os.getpid():
            found.append(int(process.name))
    return found


def wait_until_gone(text: str) -> None:
    end = time.monotonic() + 20
    while processes_with(text) and time.monotonic() < end:
        time.sleep(0.02)
    assert processes_with(text) == []
