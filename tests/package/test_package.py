"""The reference headers in somebody else's project, found as a package and included as a folder."""

from __future__ import annotations

import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CONSUMER = Path(__file__).resolve().parent / "consumer"


def run(*command: str | Path) -> str:
    done = subprocess.run(
        [str(word) for word in command], capture_output=True, text=True, stdin=subprocess.DEVNULL
    )
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def build_consumer(folder: Path, *options: str) -> str:
    """Configures and builds the consumer there, and returns what it prints."""
    run("cmake", "-G", "Ninja", "-S", CONSUMER, "-B", folder, "-DCMAKE_BUILD_TYPE=Debug", *options)
    run("cmake", "--build", folder)
    return run(folder / "consumer")


def test_found_as_a_package(tmp_path: Path) -> None:
    # A user who installs the headers wants neither tests nor program nor docs.
    off = [f"-DCONTACT_BUILD_{part}=OFF" for part in ("TESTS", "PROGRAM", "DOCS")]
    run("cmake", "-G", "Ninja", "-S", ROOT, "-B", tmp_path / "build", *off)
    run("cmake", "--install", tmp_path / "build", "--prefix", tmp_path / "prefix")
    out = build_consumer(tmp_path / "consumer", f"-DCMAKE_PREFIX_PATH={tmp_path / 'prefix'}")
    assert out == "4\n"


def test_every_header_is_installed(tmp_path: Path) -> None:
    off = [f"-DCONTACT_BUILD_{part}=OFF" for part in ("TESTS", "PROGRAM", "DOCS")]
    run("cmake", "-G", "Ninja", "-S", ROOT, "-B", tmp_path / "build", *off)
    run("cmake", "--install", tmp_path / "build", "--prefix", tmp_path / "prefix")
    headers = sorted(file.name for file in ROOT.glob("chapters/*/contact/*.hpp"))
    installed = sorted(file.name for file in (tmp_path / "prefix/include/contact").glob("*.hpp"))
    assert headers
    assert installed == headers


def test_included_as_a_folder(tmp_path: Path) -> None:
    assert build_consumer(tmp_path / "consumer", f"-DCONTACT_HOURS={ROOT}") == "4\n"
    # Only the headers come along: no tests, program or docs of ours in the user's build.
    assert not (tmp_path / "consumer" / "contact_hours" / "tests").exists()
    assert not (tmp_path / "consumer" / "contact_hours" / "cli").exists()
