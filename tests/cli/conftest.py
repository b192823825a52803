"""Runs the program as a student does, in a folder of copies of its own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "support"))

from archives import PLANE, RAY, progress, put  # noqa: E402

ROOT = HERE.parents[1]
sys.path.append(str(ROOT / "grading" / "book"))
PROGRAM = ROOT / "build" / "dev" / "bin" / "contact"
MARKED = (ROOT / "solutions/02_triangles/ray_triangle/ray_triangle.cpp").read_text()
# As it is shown: without its marks.
SOLUTION = "".join(
    line for line in MARKED.splitlines(keepends=True) if not line.lstrip().startswith("//?")
)
BODY = "const contact::Triangle<double>& triangle) {\n"

Run = Callable[..., subprocess.CompletedProcess[str]]


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "slow: takes long, and so begins first")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    items.sort(key=lambda item: item.get_closest_marker("slow") is None)


@pytest.fixture
def work(tmp_path: Path) -> Path:
    return tmp_path / "work"


@pytest.fixture
def temporary(tmp_path: Path) -> Path:
    """TMPDIR of the program, to see what it leaves there."""
    folder = tmp_path / "tmp"
    folder.mkdir()
    return folder


@pytest.fixture
def environment(work: Path, temporary: Path) -> dict[str, str]:
    return {
        **os.environ,
        "CONTACT_ROOT": str(ROOT),
        "CONTACT_WORK": str(work),
        "TMPDIR": str(temporary),
        "CONTACT_MEMORY_MB": "512",
    }


@pytest.fixture
def contact(environment: dict[str, str], tmp_path: Path) -> Run:
    def run(*words: str, **extra: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [str(PROGRAM), *words],
            capture_output=True,
            text=True,
            env={**environment, **extra},
            cwd=tmp_path,
            stdin=subprocess.DEVNULL,
            timeout=600,
        )

    return run


@pytest.fixture
def answer(work: Path) -> Callable[[str], Path]:
    """Writes the student's copy of ray_triangle."""

    def write(text: str) -> Path:
        copy = work / "02_triangles" / "ray_triangle.cpp"
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(text)
        return copy

    return write


@pytest.fixture
def solution() -> str:
    return SOLUTION


@pytest.fixture
def marked() -> str:
    """The solution as it is kept."""
    return MARKED


@pytest.fixture
def spoiled() -> Callable[[str], str]:
    """The solution with a statement put first."""

    def write(statement: str) -> str:
        assert BODY in SOLUTION
        return SOLUTION.replace(BODY, BODY + statement + "\n")

    return write


@pytest.fixture
def clean_after(temporary: Path) -> Iterator[None]:
    """Holds afterwards that no temporary folder and no child is left."""
    yield
    assert list(temporary.iterdir()) == []
    assert running_from(temporary) == []


def running_from(folder: Path) -> list[str]:
    """Processes whose program or arguments lie under a folder."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            command = (process / "cmdline").read_bytes().decode(errors="replace")
        except OSError:
            continue
        if str(folder) + "/contact-" in command:
            found.append(command)
    return found


@pytest.fixture
def on_a_terminal(environment: dict[str, str]) -> Callable[..., str]:
    """What the program writes on its "stdout" or "stderr" if that is a terminal."""

    def run(stream: str, *words: str, **extra: str) -> str:
        mother, daughter = os.openpty()
        process = subprocess.Popen(
            [str(PROGRAM), *words],
            stdin=subprocess.DEVNULL,
            stdout=daughter if stream == "stdout" else subprocess.DEVNULL,
            stderr=daughter if stream == "stderr" else None,
            env={**environment, **extra},
        )
        os.close(daughter)
        text = b""
        while True:
            try:
                part = os.read(mother, 65536)
            except OSError:
                break
            if not part:
                break
            text += part
        os.close(mother)
        assert process.wait(timeout=60) == 0
        return text.decode()

    return run


@pytest.fixture
def worked(work: Path) -> dict[str, str]:
    files = {
        f"{RAY}.cpp": "// mine: α\n",
        f"{PLANE}.cpp": "int x;\r\n",
        "77_future/not_in_this_book.cpp": "int later;",
        "progress.json": json.dumps(
            json.loads(progress({RAY: {"attempts": 2}}, from_later={"q": 1})),
            indent=2,
            sort_keys=True,
        )
        + "\n",
    }
    put(work, files)
    return files
