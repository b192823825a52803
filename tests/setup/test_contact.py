"""The script ./contact, before anything is built and on machines that lack things."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import time
import tomllib
from collections.abc import Mapping
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SHELLS = [shell for shell in ("dash", "bash", "busybox") if shutil.which(shell)]
# Nothing listens there, so a connection is refused at once.
NOWHERE = "http://127.0.0.1:9"


@pytest.fixture
def clone(tmp_path: Path) -> Path:
    """The script and what it reads, as in a fresh clone in which nothing has been built."""
    folder = tmp_path / "clone"
    for name in (
        "contact",
        "tools/setup.sh",
        "page/package.json",
        "page/package-lock.json",
        "docs/requirements.txt",
        "page/requirements.txt",
        "benchmarks/package.json",
        "benchmarks/package-lock.json",
        "benchmarks/requirements.txt",
        "CMakeLists.txt",
        "CMakePresets.json",
    ):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / name, folder / name)
    return folder


def contact(
    folder: Path, *words: str, extra: Mapping[str, str] | None = None, shell: str = "sh"
) -> subprocess.CompletedProcess[str]:
    command = [*shell.split(), str(folder / "contact"), *words]
    return subprocess.run(
        command,
        capture_output=True,
        text=True,
        stdin=subprocess.DEVNULL,
        env={**os.environ, **(extra or {})},
        timeout=300,
    )


def commands_without(folder: Path, *absent: str) -> Path:
    """A folder that offers every command of this machine but these: a PATH of its own."""
    offered = folder / "bin"
    offered.mkdir()
    for place in reversed(os.environ["PATH"].split(os.pathsep)):
        if not Path(place).is_dir():
            continue
        for file in Path(place).iterdir():
            if file.name not in absent and os.access(file, os.X_OK) and not file.is_dir():
                link = offered / file.name
                link.unlink(missing_ok=True)
                link.symlink_to(file)
    return offered


def set_up(folder: Path, what: str) -> None:
    """Makes the script believe that the Python or npm packages are there already."""
    if what == "python":
        for pins, venv in (("docs", "build/venv"), ("page", "build/venv-page")):
            (folder / venv / "bin").mkdir(parents=True)
            (folder / venv / "bin/python").symlink_to(sys.executable)
            stamp = folder / venv / "contact-requirements.txt"
            shutil.copy2(folder / pins / "requirements.txt", stamp)


@pytest.mark.parametrize("shell", SHELLS)
@pytest.mark.parametrize("words", [(), ("--help",), ("-h",), ("help",)])
def test_help_needs_no_build(clone: Path, shell: str, words: tuple[str, ...]) -> None:
    done = contact(clone, *words, shell="busybox sh" if shell == "busybox" else shell)
    assert done.returncode == 0
    assert "./contact COMMAND" in done.stdout
    assert not (clone / "build").exists()


@pytest.mark.parametrize("command", ["setup", "serve", "test"])
def test_help_of_a_command_needs_no_build(clone: Path, command: str) -> None:
    done = contact(clone, command, "--help")
    assert done.returncode == 0
    assert done.stdout.startswith(f"Usage: ./contact {command}")
    assert not (clone / "build").exists()


@pytest.mark.parametrize(
    ("words", "named"),
    [
        (("serv",), '"serv"'),
        (("--colour",), '"--colour"'),
        (("setup", "--for", "everybody"), '"everybody"'),
        (("setup", "now"), '"now"'),
    ],
)
def test_what_is_not_understood_is_named(clone: Path, words: tuple[str, ...], named: str) -> None:
    done = contact(clone, *words)
    assert done.returncode == 2
    assert named in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1
    assert not (clone / "build").exists()


def test_an_unknown_command_is_named_where_the_program_is_built(clone: Path) -> None:
    program = clone / "build/dev/bin/contact"
    program.parent.mkdir(parents=True)
    program.write_text("#!/bin/sh\nexit 7\n")
    program.chmod(0o755)
    done = contact(clone, "frobnicate")
    assert done.returncode == 2
    assert 'no command "frobnicate"' in done.stderr


def test_help_lists_what_the_program_offers(clone: Path) -> None:
    program = ROOT / "build/dev/bin/contact"
    if not program.exists():
        pytest.skip("the program is not built")
    lines = subprocess.run([program, "--help"], capture_output=True, text=True).stdout.splitlines()
    begin = next(i for i, line in enumerate(lines) if line.lower().startswith("subcommands"))
    offered = set()
    for line in lines[begin + 1 :]:
        if not line.strip():
            break
        if line.startswith("  ") and line[2] != " ":
            offered.add(line.split()[0])
    text = (clone / "contact").read_text()
    listed = text.split("program_commands='")[1].split("'")[0].split()
    assert offered == set(listed)
    shown = contact(clone, "--help").stdout
    assert [name for name in listed if f"\n  {name} " not in shown] == []


def test_the_script_builds_the_program_that_has_the_command(clone: Path) -> None:
    table = (ROOT / "cli/elsewhere.hpp").read_text()
    elsewhere = dict(re.findall(r'_command\{\s*"([a-z]+)",.*?"(contact-[a-z]+)"\};', table, re.S))
    text = (clone / "contact").read_text()
    listed = text.split("program_commands='")[1].split("'")[0].split()
    function = text[text.index("program_of() {") : text.index("# True when a program is there")]
    for command in listed:
        asked = ["sh", "-c", f'{function}\nprogram_of "$1"', "sh", command]
        said = subprocess.run(asked, capture_output=True, text=True, check=True).stdout.strip()
        assert said == elsewhere.get(command, "contact")
    assert {"plan", "grade", "dev"} <= elsewhere.keys() <= set(listed)


def test_a_change_of_scenes_is_nothing_to_who_checks_exercises(clone: Path, tmp_path: Path) -> None:
    # Both programs exist and are up to date, except for one source of the scenes.
    for name in ("contact", "contact-scenes"):
        program = clone / "build/dev/bin" / name
        program.parent.mkdir(parents=True, exist_ok=True)
        program.write_text('#!/bin/sh\necho "ran $1"\n')
        program.chmod(0o755)
        (clone / f"build/dev/{name}.fresh").touch()
    source = clone / "chapters/20_scenes/src/scene.cpp"
    source.parent.mkdir(parents=True)
    source.touch()
    later = time.time() + 60
    os.utime(source, (later, later))
    path = commands_without(tmp_path, "apt-get", "apt", "dpkg", "cmake", "brew")
    assert contact(clone, "list", extra={"PATH": str(path)}).stdout == "ran list\n"
    done = contact(clone, "plan", "x", extra={"PATH": str(path)})
    assert done.returncode == 3
    assert "  CMake 3.25 or newer" in done.stderr


def test_without_apt_the_tools_are_listed(clone: Path, tmp_path: Path) -> None:
    absent = ("apt-get", "apt", "dpkg", "doxygen", "cmake", "brew")
    path = commands_without(tmp_path, *absent)
    done = contact(clone, "setup", extra={"PATH": str(path)})
    assert done.returncode == 3
    assert "no apt" in done.stderr
    assert "  CMake 3.25 or newer" in done.stderr
    assert "  Doxygen" in done.stderr
    assert "Ninja" not in done.stderr  # is there, so need not be installed


def test_the_level_says_what_is_wanted(clone: Path, tmp_path: Path) -> None:
    path = commands_without(tmp_path, "apt-get", "apt", "dpkg", "doxygen", "cmake", "shellcheck")
    done = contact(clone, "setup", "--for", "program", extra={"PATH": str(path)})
    assert done.returncode == 3
    assert "CMake" in done.stderr
    assert "Doxygen" not in done.stderr
    assert "ShellCheck" not in done.stderr


def test_a_new_version_says_what_it_needs(clone: Path, tmp_path: Path) -> None:
    # The program is there from before, and its sources are newer.
    program = clone / "build/dev/bin/contact"
    program.parent.mkdir(parents=True)
    program.write_text("#!/bin/sh\nexit 0\n")
    program.chmod(0o755)
    path = commands_without(tmp_path, "apt-get", "apt", "dpkg", "cmake", "brew")
    done = contact(clone, "list", extra={"PATH": str(path)})
    assert done.returncode == 3
    assert "  CMake 3.25 or newer" in done.stderr
    assert "up to date" not in done.stderr


@pytest.mark.skipif(not shutil.which("apt-get"), reason="this system has no apt")
def test_debian_packages_out_of_reach(clone: Path, tmp_path: Path) -> None:
    # An apt with no lists and a proxy that refuses: as on a new machine without a network.
    state = tmp_path / "apt"
    for folder in ("lists/partial", "cache/archives/partial"):
        (state / folder).mkdir(parents=True)
    config = state / "apt.conf"
    # With an empty list of what is installed, and no dpkg, nothing could be installed by mistake.
    (state / "status").touch()
    config.write_text(
        f'Dir::State::status "{state}/status";\nDir::Bin::dpkg "/bin/false";\n'
        f'Dir::State::lists "{state}/lists";\nDir::Cache "{state}/cache";\n'
        f'Acquire::http::Proxy "{NOWHERE}";\nAcquire::https::Proxy "{NOWHERE}";\n'
        'Acquire::Retries "0";\n'
    )
    path = commands_without(tmp_path, "doxygen", "sudo")
    if os.geteuid() != 0:
        (path / "sudo").write_text('#!/bin/sh\n[ "$1" = -n ] && shift\nexec "$@"\n')
        (path / "sudo").chmod(0o755)
    extra = {"PATH": str(path), "APT_CONFIG": str(config)}
    done = contact(clone, "setup", "--for", "book", extra=extra)
    assert done.returncode == 3
    last = done.stderr.strip().splitlines()[-1]
    assert "Debian packages are out of reach" in last
    assert "./contact setup again" in last


NO_PACKAGE_INDEX = {
    "PIP_INDEX_URL": f"{NOWHERE}/simple",
    "PIP_NO_CACHE_DIR": "1",
    "PIP_RETRIES": "0",
    "PIP_FIND_LINKS": "",
    "http_proxy": "",
    "https_proxy": "",
}


@pytest.mark.skipif(os.geteuid() != 0, reason="only root's own Python is closed to others")
def test_root_takes_a_python_that_everybody_reaches(clone: Path, tmp_path: Path) -> None:
    own = tmp_path / "own"
    own.mkdir()
    python = own / "python3"
    own_prefix = f'case "$2" in *base_prefix*) echo "{own}/python"; exit ;; venv) exit 1 ;; esac'
    python.write_text(f'#!/bin/sh\n{own_prefix}\nexec {sys.executable} "$@"\n')
    python.chmod(0o755)
    extra = {"HOME": str(own), "PATH": f"{own}{os.pathsep}{os.environ['PATH']}"}
    contact(clone, "setup", "--for", "book", extra={**NO_PACKAGE_INDEX, **extra})
    settings = (clone / "build/venv/pyvenv.cfg").read_text()
    assert "home = /usr/bin\n" in settings


def test_python_packages_out_of_reach(clone: Path) -> None:
    done = contact(clone, "setup", "--for", "book", extra=NO_PACKAGE_INDEX)
    assert done.returncode == 3, done.stderr
    last = done.stderr.strip().splitlines()[-1]
    assert "Python packages are out of reach" in last
    assert "PIP_INDEX_URL" in last
    # What was going to be installed was said first.
    assert "Sphinx==" in done.stderr.split("out of reach")[0]


def test_npm_packages_out_of_reach(clone: Path) -> None:
    set_up(clone, "python")
    extra = {
        "npm_config_registry": NOWHERE,
        "npm_config_cache": str(clone / "npm-cache"),
        "npm_config_fetch_retries": "0",
    }
    done = contact(clone, "setup", "--for", "book", extra=extra)
    assert done.returncode == 3, done.stderr
    last = done.stderr.strip().splitlines()[-1]
    assert "npm packages are out of reach" in last
    assert "./contact setup again" in last


def test_a_second_setup_installs_nothing() -> None:
    if not (ROOT / "build/venv/contact-requirements.txt").exists():
        pytest.skip("this tree was not set up by ./contact setup")
    first = contact(ROOT, "setup", "--for", "book")
    assert first.returncode == 0, first.stderr
    venv = (ROOT / "build/venv/contact-requirements.txt").stat().st_mtime_ns
    second = contact(ROOT, "setup", "--for", "book")
    assert second.returncode == 0, second.stderr
    assert "Installing" not in second.stderr
    assert (ROOT / "build/venv/contact-requirements.txt").stat().st_mtime_ns == venv


def test_the_npm_lock_serves_every_system() -> None:
    # A lock made where a registry lacks some system's build leaves it out, and then `npm ci`
    # fails everywhere else.
    packages = json.loads((ROOT / "page/package-lock.json").read_text())["packages"]
    missing = [
        wanted
        for name, package in packages.items()
        for wanted in package.get("optionalDependencies", {})
        if f"node_modules/{wanted}" not in packages
        and f"{name}/node_modules/{wanted}" not in packages
    ]
    assert missing == []


def test_it_works_through_a_link_and_from_elsewhere(clone: Path, tmp_path: Path) -> None:
    link = tmp_path / "elsewhere" / "contact"
    link.parent.mkdir()
    link.symlink_to("../clone/contact")
    done = subprocess.run([str(link), "serv"], capture_output=True, text=True, cwd="/")
    assert done.returncode == 2
    assert 'no command "serv"' in done.stderr


def wanted(level: str) -> set[str]:
    """The packages that a level installs where there is nothing yet."""
    script = 'root=.; . tools/setup.sh; setup_there() { return 1; }; setup_missing "$0"'
    done = subprocess.run(
        ["sh", "-c", script, level], cwd=ROOT, capture_output=True, text=True, check=True
    )
    return {line.split("|")[0] for line in done.stdout.splitlines()}


def test_the_peers_of_the_benchmarks_are_installed_where_they_are_asked_for() -> None:
    program, book, test, benchmarks = map(wanted, ("program", "book", "test", "benchmarks"))
    assert program < book < test
    assert book < benchmarks
    assert {"libcgal-dev", "libembree-dev", "libfcl-dev"} <= benchmarks - test
    assert "valgrind" in test - benchmarks


PIN = re.compile(r"""[A-Za-z0-9._-]+==[0-9][A-Za-z0-9.]*(; python_version < "3[.]1[0-9]")?""")


def test_the_peers_of_the_benchmarks_are_pinned() -> None:
    def pins(name: str) -> list[str]:
        lines = (ROOT / "benchmarks" / name).read_text().splitlines()
        return [line for line in lines if not line.startswith("#")]

    asked = pins("requirements.in")
    assert {"coacd", "ipctk", "libcoal", "libigl", "miniballcpp", "mujoco", "vhacdx"} == {
        line.split("==")[0] for line in asked
    }
    # With all that they need, each in one version.
    assert set(asked) < set(pins("requirements.txt"))
    assert [line for line in pins("requirements.txt") if not PIN.fullmatch(line)] == []

    wanted = json.loads((ROOT / "benchmarks/package.json").read_text())["dependencies"]
    locked = json.loads((ROOT / "benchmarks/package-lock.json").read_text())["packages"]
    assert {"fast-triangle-triangle-intersection", "three-mesh-bvh"} <= set(wanted)
    for name, version in wanted.items():
        assert locked[f"node_modules/{name}"]["version"] == version
        assert locked[f"node_modules/{name}"]["integrity"].startswith("sha512-")
    # The comparison and the page have the same three.js.
    page = json.loads((ROOT / "page/package.json").read_text())["dependencies"]
    assert wanted["three"] == page["three"]

    for folder, peer in (("crates", "box3d-sys"), ("crates/box2d", "boxdd-sys")):
        place = ROOT / "benchmarks" / folder
        crates = tomllib.loads((place / "Cargo.toml").read_text())["dependencies"]
        lock = tomllib.loads((place / "Cargo.lock").read_text())["package"]
        assert peer in crates
        for name, version in crates.items():
            (package,) = [package for package in lock if package["name"] == name]
            assert version == f"={package['version']}"
            assert re.fullmatch("[0-9a-f]{64}", package["checksum"])


@pytest.mark.parametrize(
    ("version", "read"), [("cargo 0.66.0", False), ("cargo 1.84.1", False), ("cargo 1.85.0", True)]
)
def test_packages_that_an_old_cargo_cannot_read_are_left_out(version: str, read: bool) -> None:
    script = """root=.; . tools/setup.sh
cargo() { echo "$version"; }
setup_cargo_reads benchmarks/crates && setup_cargo_reads benchmarks/crates/box2d
"""
    done = subprocess.run(
        ["sh", "-c", script], cwd=ROOT, env={**os.environ, "version": version}, check=False
    )
    assert (done.returncode == 0) == read


@pytest.mark.parametrize(
    ("level", "expected"),
    [
        ("program", ["venv docs venv"]),
        ("book", ["venv docs venv", "venv page venv-page", "npm page"]),
        ("test", ["venv docs venv", "venv page venv-page", "npm page"]),
        (
            "benchmarks",
            [
                "venv docs venv",
                "venv page venv-page",
                "npm page",
                "venv benchmarks venv-benchmarks",
                "npm benchmarks",
                "crates benchmarks/crates",
                "crates benchmarks/crates/box2d",
            ],
        ),
    ],
)
def test_what_a_level_installs_besides_system_packages(level: str, expected: list[str]) -> None:
    script = """root=.; . tools/setup.sh
setup_missing() { :; }
setup_browser() { :; }
setup_venv() { echo "venv $*"; }
setup_npm() { echo "npm $*"; }
setup_crates() { echo "crates $*"; }
setup "$0"
"""
    done = subprocess.run(
        ["sh", "-c", script, level], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert done.stdout.splitlines() == expected


def test_peers_of_the_benchmarks_out_of_reach(clone: Path) -> None:
    script = """root=.; . tools/setup.sh
say() { echo "$*" >&2; }
fail() { code=$1; shift; say "$*"; exit "$code"; }
setup_venv benchmarks venv-benchmarks
"""
    done = subprocess.run(
        ["sh", "-c", script],
        cwd=clone,
        capture_output=True,
        text=True,
        env={**os.environ, **NO_PACKAGE_INDEX},
    )
    assert done.returncode == 3, done.stderr
    assert "libigl==" in done.stderr.split("out of reach")[0]
    assert "Python packages are out of reach" in done.stderr
    # The book's own packages are left as they are.
    assert not (clone / "build/venv").exists()
    assert not (clone / "build/venv-benchmarks/contact-requirements.txt").exists()


def test_setup_names_its_levels_when_it_does_not_know_one() -> None:
    done = subprocess.run(
        [str(ROOT / "contact"), "setup", "--for", "benchmark"], capture_output=True, text=True
    )
    assert done.returncode == 2
    assert 'takes program, book, test or benchmarks, not "benchmark"' in done.stderr
