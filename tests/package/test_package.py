"""The reference headers in another project, found as a package and included as a folder."""

from __future__ import annotations

import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CONSUMER = Path(__file__).resolve().parent / "consumer"
# The point's distance; of gravity, that it is off where there is none and on else; two roundings.
PRINTED = "4\n0\n1\nrounded\n"


def run(*command: str | Path) -> str:
    done = subprocess.run(
        [str(word) for word in command], capture_output=True, text=True, stdin=subprocess.DEVNULL
    )
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def build_consumer(folder: Path, *options: str) -> str:
    """Configures and builds the consumers there, and returns what they print."""
    run("cmake", "-G", "Ninja", "-S", CONSUMER, "-B", folder, "-DCMAKE_BUILD_TYPE=Debug", *options)
    run("cmake", "--build", folder)
    programs = ("consumer", "consumer_plan", "consumer_rounding")
    return "".join(run(folder / program) for program in programs)


def test_found_as_a_package(tmp_path: Path) -> None:
    # A user who installs the headers wants neither tests nor program nor docs.
    off = [f"-DCONTACT_BUILD_{part}=OFF" for part in ("TESTS", "PROGRAM", "DOCS")]
    run("cmake", "-G", "Ninja", "-S", ROOT, "-B", tmp_path / "build", *off)
    run("cmake", "--install", tmp_path / "build", "--prefix", tmp_path / "prefix")
    out = build_consumer(tmp_path / "consumer", f"-DCMAKE_PREFIX_PATH={tmp_path / 'prefix'}")
    assert out == PRINTED


def test_every_header_is_installed(tmp_path: Path) -> None:
    off = [f"-DCONTACT_BUILD_{part}=OFF" for part in ("TESTS", "PROGRAM", "DOCS")]
    run("cmake", "-G", "Ninja", "-S", ROOT, "-B", tmp_path / "build", *off)
    run("cmake", "--install", tmp_path / "build", "--prefix", tmp_path / "prefix")
    folder = tmp_path / "prefix/include/ContactHours"
    # Headers that declare take in their sources.
    for pattern in ("contact/**/*.hpp", "src/*.cpp"):
        files = sorted(
            file.relative_to(chapter).as_posix()
            for chapter in (ROOT / "chapters").iterdir()
            for file in chapter.glob(pattern)
        )
        assert files
        assert sorted(file.relative_to(folder).as_posix() for file in folder.glob(pattern)) == files


def test_included_as_a_folder(tmp_path: Path) -> None:
    assert build_consumer(tmp_path / "consumer", f"-DCONTACT_HOURS={ROOT}") == PRINTED
    # Only the headers come along: no tests, program or docs of ours in the user's build.
    assert not (tmp_path / "consumer" / "contact_hours" / "tests").exists()
    assert not (tmp_path / "consumer" / "contact_hours" / "cli").exists()
