"""What a box keeps a compiler from, tried at both levels, and that what is honest compiles."""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from sandboxed import ROOT, End, managed, run_box


@pytest.fixture
def compile_folder() -> Iterator[Path]:
    """A folder that another user can traverse: without namespaces the compiler runs as another
    user."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder).chmod(0o711)
        for name in ("source", "made"):
            (Path(folder) / name).mkdir()
        yield Path(folder)


@pytest.fixture
def compile_text(level: str, compile_folder: Path) -> Callable[..., End]:
    def run(text: str, *flags: str, cpu: int = 30, shown: Path | None = None) -> End:
        source, made = compile_folder / "source", compile_folder / "made"
        (source / "answer.cpp").write_text(text)
        limits = ["--memory", 1024, "--processes", 32, "--cpu", cpu, "--file-size", 64]
        mounts = ["--show", f"{source}=/source", "--writable", f"{made}=/made"]
        if shown is not None:
            mounts += ["--show", f"{shown}={shown}"]
        compiler = ["/usr/bin/g++", "-std=c++20", "-pipe", "-c", "/source/answer.cpp"]
        return run_box(
            level,
            "--kind",
            "compile",
            *map(str, limits),
            *mounts,
            "--",
            *compiler,
            *flags,
            "-o",
            "/made/answer.o",
        )

    return run


def test_the_standard_library_compiles(
    compile_text: Callable[..., End], compile_folder: Path
) -> None:
    headers = ["vector", "iostream", "thread", "cmath", "regex", "filesystem", "sys/socket.h"]
    text = "".join(f"#include <{header}>\n" for header in headers)
    end = compile_text(
        text + "#include <Eigen/Dense>\nEigen::Vector3d v;\n", "-I/usr/include/eigen3"
    )
    assert (end["exit_code"], end["errors"]) == (0, "")
    assert (compile_folder / "made" / "answer.o").stat().st_size > 0


@pytest.mark.parametrize(
    "header",
    [
        '"/etc/passwd"',
        f'"{ROOT}/tests/02_triangles/ray_triangle_test.cpp"',
        '"/proc/self/environ"',
        "</dev/zero>",
    ],
)
def test_a_compiler_includes_nothing_else(compile_text: Callable[..., End], header: str) -> None:
    end = compile_text(f"#include {header}\n")
    assert end["exit_code"] == 1
    assert "No such file" in end["errors"] or "Permission denied" in end["errors"]
    assert "root:" not in end["errors"]


HEADERS = (Path("/usr/include"), Path("/usr/local/include"))


def installed_headers() -> list[Path]:
    """Headers installed on the search path of the compiler and readable by all users."""
    found = []
    visited = set()
    for top in HEADERS:
        for folder, folders, files in os.walk(top, followlinks=True):
            if os.path.realpath(folder) in visited:
                folders.clear()
                continue
            visited.add(os.path.realpath(folder))
            found += [Path(folder) / file for file in files]
    return [file for file in found if file.exists() and file.stat().st_mode & 0o004]


def test_a_header_that_is_seen_can_be_read(level: str, probe: Path) -> None:
    headers = installed_headers()
    assert len(headers) > 500
    with tempfile.TemporaryDirectory() as folder:
        Path(folder).chmod(0o755)
        names = Path(folder) / "names"
        names.write_text("".join(f"{header}\n" for header in headers))
        program = shutil.copy(probe, folder)
        shown = ("--kind", "compile", "--show", names, "--show", program)
        end = run_box(level, *shown, program, "open-all", names)
    assert "closed" not in end["output"]
    assert managed(end)
    seen = int(end["output"].split("seen ")[1].split()[0])
    # At level full some are hidden; where nothing can be, all are open.
    assert seen == len(headers) if level == "reduced" else 500 < seen <= len(headers)


@pytest.fixture
def installed() -> Iterator[Path]:
    """A folder of installed headers."""
    top = Path("/usr/local/include")
    if not os.access(top, os.W_OK):
        pytest.skip("only root installs headers")
    with tempfile.TemporaryDirectory(prefix="contact-test-", dir=top) as made:
        Path(made).chmod(0o755)
        yield Path(made)


def test_what_happens_to_be_installed_changes_nothing(
    compile_text: Callable[..., End], installed: Path, level: str
) -> None:
    (installed / "other.h").write_text("enum { of_the_other };\n")
    (installed / "library.h").write_text(
        "#include <other.h>\nenum { found };\n".replace("other.h", f"{installed.name}/other.h")
    )
    header = f"<{installed.name}/library.h>"
    # As the standard library does with TBB.
    text = f"#if __has_include({header})\n#include {header}\nint seen = found;\n#endif\n"
    end = compile_text(text)
    assert (end["exit_code"], end["errors"]) == (0, "")
    named = compile_text(f"#include {header}\n")
    assert named["exit_code"] == (0 if level == "reduced" else 1), named["errors"]


def test_a_link_among_headers_opens_what_is_installed_and_nothing_else(
    compile_text: Callable[..., End], installed: Path, level: str
) -> None:
    with (
        tempfile.TemporaryDirectory(prefix="contact-test-", dir="/usr/local/share") as library,
        tempfile.TemporaryDirectory(prefix="contact-test-", dir="/var/tmp") as somebodys,
    ):
        for name, folder in (("library", library), ("own", somebodys)):
            Path(folder).chmod(0o755)
            (Path(folder) / "header.h").write_text("enum { found };\n")
            (installed / name).symlink_to(folder)
        linked = compile_text(f"#include <{installed.name}/library/header.h>\n")
        assert linked["exit_code"] == (0 if level == "reduced" else 1), linked["errors"]
        own = compile_text(f"#include <{installed.name}/own/header.h>\n")
        assert own["exit_code"] == 1
        assert "No such file" in own["errors"] or "Permission denied" in own["errors"]


@pytest.mark.parametrize("header", ["<nlohmann/json.hpp>", "<catch2/catch_all.hpp>"])
def test_namespaces_hide_what_a_submission_does_not_need(
    compile_text: Callable[..., End], level: str, header: str
) -> None:
    errors = compile_text(f"#include {header}\n")["errors"]
    # Without them no file can be hidden, so that all are open.
    assert ("No such file" in errors) == (level == "full"), errors
    assert "Permission denied" not in errors


def test_an_assembler_includes_nothing_else(compile_text: Callable[..., End]) -> None:
    end = compile_text('__asm__(".incbin \\"/etc/passwd\\"");\n')
    assert end["exit_code"] == 1


def test_messages_name_files_as_the_box_sees_them(compile_text: Callable[..., End]) -> None:
    end = compile_text("int f() { return x; }\n")
    assert end["exit_code"] == 1
    assert end["errors"].startswith("/source/answer.cpp:")


def test_a_book_may_lie_below_tmp(compile_text: Callable[..., End]) -> None:
    with tempfile.TemporaryDirectory(dir="/tmp") as name:
        folder = Path(name)
        folder.chmod(0o711)
        contract = folder / "contract.hpp"
        contract.write_text("int f();\n")
        end = compile_text("#include <contract.hpp>\n", f"-I{folder}", shown=contract)
    assert (end["exit_code"], end["errors"]) == (0, "")


ENDLESS = """
constexpr long sum() {
  long result = 0;
  for (long i = 0; i < 1000000000000; ++i) result += i % 2;
  return result;
}
constexpr long all = sum();
"""


def test_a_compiler_is_limited_too(compile_text: Callable[..., End]) -> None:
    limits = ["-fconstexpr-ops-limit=1000000000000000", "-fconstexpr-loop-limit=2147483647"]
    # Whichever it reaches first, time or memory.
    end = compile_text(ENDLESS, *limits, cpu=1)
    assert end["ended"] == "time" or end["exit_code"] != 0
    assert end["cpu_seconds"] < 5
    assert compile_text(ENDLESS.replace("1000000000000", "100"), *limits)["exit_code"] == 0
