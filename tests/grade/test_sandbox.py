"""What a box keeps a program from, tried at both levels, and that what is honest works."""

from __future__ import annotations

import json
import os
import platform
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from sandboxed import (
    PROGRAM,
    ROOT,
    SOURCE,
    Box,
    command,
    managed,
    processes_with,
    refused,
    run_box,
    wait_until_gone,
)

# --- Attempts that must fail, the same at both levels.


@pytest.mark.parametrize(
    "attempt",
    [
        ["fork"],
        ["vfork"],
        ["clone3"],
        ["thread"],
        ["membarrier"],
        ["interval-timer"],
        ["exec"],
        ["socket"],
        ["unix-socket"],
        ["netlink"],
        ["open", "/etc/passwd"],
        ["open", "/proc/self/cmdline"],
        ["open", "/proc/1/environ"],
        ["open", "/dev/zero"],
        ["open", str(SOURCE)],
        ["list", str(ROOT)],
        ["list", "/home"],
        ["create", "/file"],
        ["kill-parent"],
        ["kill-all"],
        ["setsid"],
        ["signal-by-pipe"],
        ["raise-limit"],
        ["mount"],
        ["chroot"],
        ["unshare"],
        ["io-uring"],
        ["bpf"],
        ["keyctl"],
        ["userfaultfd"],
        ["perf"],
        ["memory-file"],
        ["new-privileges"],
        ["become-root"],
    ],
    ids=" ".join,
)
def test_is_refused(box: Box, attempt: list[str]) -> None:
    assert refused(box(*attempt))


@pytest.fixture
def bystander() -> Iterator[subprocess.Popen[bytes]]:
    """A process of the user who runs the grader."""
    with subprocess.Popen(["sleep", "100"]) as process:
        yield process
        alive = process.poll() is None
        process.kill()
        assert alive, "the bystander was ended from inside a box"


@pytest.mark.parametrize(
    "attempt", ["kill", "tgkill", "signal-by-pipe", "ptrace", "read-process", "limit-other"]
)
def test_another_process_is_out_of_reach(
    box: Box, bystander: subprocess.Popen[bytes], attempt: str
) -> None:
    assert refused(box(attempt, bystander.pid))


def test_the_network_is_out_of_reach(box: Box) -> None:
    with socket.create_server(("127.0.0.1", 0)) as listener:
        assert refused(box("connect", listener.getsockname()[1]))


def test_it_is_never_root(box: Box) -> None:
    real, effective = box("who")["output"].split()[1:3]
    assert real == effective != "0"


def test_the_environment_is_empty(box: Box) -> None:
    variables = [line for line in box("environment")["output"].splitlines() if "variable" in line]
    assert variables in ([], ["variable PWD=/"])


def test_descriptors_that_lie_open_are_not_passed_on(box: Box) -> None:
    with SOURCE.open() as leaked:
        end = box("descriptors", pass_fds=(leaked.fileno(),))
    lines = end["output"].splitlines()
    assert lines == ["descriptor 0", "descriptor 1", "descriptor 2", "managed"]


@pytest.mark.skipif(platform.machine() != "x86_64", reason="calls of another architecture")
@pytest.mark.parametrize("attempt", ["32-bit", "x32"])
def test_calls_of_another_architecture_end_it(box: Box, attempt: str) -> None:
    assert box(attempt)["signal"] == signal.SIGSYS


# --- Limits: what goes beyond is stopped, what stays below is not.


def test_memory(box: Box) -> None:
    assert refused(box("memory", 200, limits=("--memory", 128)))
    assert managed(box("memory", 64, limits=("--memory", 128)))


def test_processor_time(box: Box) -> None:
    end = box("spin", limits=("--cpu", 0.2))
    assert end["ended"] == "time"
    assert end["cpu_seconds"] >= 0.2
    assert box("arithmetic", limits=("--cpu", 0.2))["ended"] == "by_itself"


def test_waiting(box: Box) -> None:
    end = box("sleep", limits=("--wall", 0.5))
    assert end["ended"] == "time"
    assert end["cpu_seconds"] < 0.4
    assert managed(box("nap", limits=("--wall", 5)))


@pytest.mark.parametrize(
    "attempt", [["sleep"], ["stop"], ["nap-and-work", 5000], ["nap-and-work", 1]], ids=str
)
def test_doing_nothing(box: Box, attempt: list[str | int]) -> None:
    end = box(*attempt, limits=("--idle", 0.5, "--wall", 60))
    assert end["ended"] == "idle"
    assert end["seconds"] < 20
    assert managed(box("nap", limits=("--idle", 0.5)))


def test_working_is_not_doing_nothing(box: Box) -> None:
    assert box("spin", limits=("--idle", 0.3, "--cpu", 0.8))["ended"] == "time"
    threads = ("--processes", 4, "--idle", 0.3)
    assert managed(box("work-beside", limits=threads))
    assert box("sleep-beside", limits=(*threads, "--wall", 60))["ended"] == "idle"
    assert box("flood", limits=("--idle", 0.3, "--output", 100_000))["ended"] == "output"


def test_who_waits_for_a_core_is_not_idle(box: Box) -> None:
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(cores)})
    try:
        loop = ["sh", "-c", "while :; do :; done"]
        others = [subprocess.Popen(loop, start_new_session=True) for _ in range(6)]
        try:
            # A seventh of the time is its own: it waits for the rest.
            end = box("spin", limits=("--idle", 0.3, "--cpu", 0.5, "--wall", 90))
            assert end["ended"] == "time"
            assert end["seconds"] > 1
            assert box("sleep", limits=("--idle", 0.3, "--wall", 90))["ended"] == "idle"
        finally:
            for other in others:
                other.kill()
                other.wait()
    finally:
        os.sched_setaffinity(0, cores)


@pytest.mark.parametrize("attempt", ["flood", "flood-errors"])
def test_output(box: Box, attempt: str) -> None:
    end = box(attempt, limits=("--output", 100_000))
    assert end["ended"] == "output"
    assert 0 < len(end["output"] + end["errors"]) <= 100_000


def test_files_fill_no_disk(box: Box, level: str) -> None:
    assert refused(box("write-file", 3, limits=("--file-size", 2)))
    assert refused(box("make-files", 20, limits=("--files", 16)))
    # Without a view of files of its own it has none at all.
    holds = managed if level == "full" else refused
    assert holds(box("write-file", 1, limits=("--file-size", 2)))
    assert holds(box("make-files", 10, limits=("--files", 16)))


def test_processes_where_some_are_allowed(box: Box) -> None:
    allowed = ("--processes", 4)
    assert managed(box("fork", limits=allowed))
    assert managed(box("thread", limits=allowed))
    # A process that waits for a child in this way looks like one that waits for a disk.
    assert refused(box("vfork", limits=allowed))
    assert managed(box("fork-many", 2, limits=allowed))
    assert not managed(box("fork-many", 100, limits=allowed))


# --- How it ends.


@pytest.mark.parametrize(
    ("attempt", "number"),
    [("abort", signal.SIGABRT), ("segfault", signal.SIGSEGV), ("overflow", signal.SIGSEGV)],
)
def test_a_signal_is_told(box: Box, attempt: str, number: int) -> None:
    assert box(attempt)["signal"] == number


def test_an_exit_code_is_told(box: Box) -> None:
    end = box("exit", 3)
    assert (end["exit_code"], end["signal"]) == (3, 0)


def test_an_honest_program_works(box: Box) -> None:
    assert box("arithmetic")["output"] == "sum 1\nmanaged\n"


def test_nothing_is_left_behind(box: Box, level: str) -> None:
    mark = f"mark-of-{level}-{os.getpid()}"
    end = box("leave-behind", mark, limits=("--processes", 4, "--wall", 20))
    assert managed(end)
    assert processes_with(mark) == []


@pytest.mark.parametrize("attempt", ["sleep", "spin"])
def test_it_ends_with_whoever_started_it(level: str, probe: Path, attempt: str) -> None:
    mark = f"mark-of-{attempt}-{level}-{os.getpid()}"
    started = subprocess.Popen(
        command(
            "--cpu", 60, "--wall", 60, "--show", f"{probe}=/program", "/program", attempt, mark
        ),
        env={**os.environ, "CONTACT_ROOT": str(ROOT), "CONTACT_BOX_LEVEL": level},
        stdout=subprocess.DEVNULL,
    )
    with started:
        end = time.monotonic() + 20
        # The program in the box, and not those that start it.
        while not any(runs(process, attempt) for process in processes_with(mark)):
            assert time.monotonic() < end
            time.sleep(0.01)
        started.kill()
    wait_until_gone(mark)


def runs(process: int, attempt: str) -> bool:
    try:
        words = Path(f"/proc/{process}/cmdline").read_bytes().split(b"\0")
    except OSError:
        return False
    return attempt.encode() in words[:2]


def test_ctrl_c_ends_the_box(level: str, probe: Path) -> None:
    mark = f"mark-of-interrupt-{level}-{os.getpid()}"
    started = subprocess.Popen(
        command("--wall", 60, "--show", f"{probe}=/program", "/program", "sleep", mark),
        env={**os.environ, "CONTACT_ROOT": str(ROOT), "CONTACT_BOX_LEVEL": level},
        stdout=subprocess.DEVNULL,
    )
    with started:
        end = time.monotonic() + 20
        while not any(runs(process, "sleep") for process in processes_with(mark)):
            assert time.monotonic() < end
            time.sleep(0.01)
        started.send_signal(signal.SIGINT)
        assert started.wait(20) == 130
    assert processes_with(mark) == []


# --- What the machine says of itself.


def doctor(level: str) -> dict[str, Any]:
    done = subprocess.run(
        [str(PROGRAM), "doctor", "--json"],
        capture_output=True,
        text=True,
        env={**os.environ, "CONTACT_ROOT": str(ROOT), "CONTACT_BOX_LEVEL": level},
        timeout=120,
    )
    grading: dict[str, Any] = json.loads(done.stdout)["grading"]
    return grading


def held(report: dict[str, Any]) -> set[str]:
    return {measure["what"] for measure in report["measures"] if measure["enforced"]}


def test_doctor_says_what_holds(level: str) -> None:
    report = doctor(level)
    assert report["level"] == level
    assert all(measure["how"] for measure in report["measures"])
    assert {
        "a submission is not root",
        "a submission gains no rights",
        "a submission has no network",
        "a submission sees no other process",
        "a submission reads no file of the machine",
        "a submission starts no process",
        "a submission gets no environment",
        "memory of a process is limited",
        "processor time is limited",
    } <= held(report)


def test_doctor_says_what_does_not_hold() -> None:
    report = doctor("none")
    assert report["level"] == "none"
    assert not held(report) & {
        "namespaces of its own",
        "a submission gains no rights",
        "a submission has no network",
        "a submission reads no file of the machine",
        "a submission starts no process",
    }


def test_a_level_that_is_none_is_named() -> None:
    done = subprocess.run(
        command("/program"),
        capture_output=True,
        text=True,
        env={**os.environ, "CONTACT_ROOT": str(ROOT), "CONTACT_BOX_LEVEL": "total"},
    )
    assert done.returncode == 3
    assert "full, reduced or none" in done.stderr


@pytest.mark.parametrize("loader", ["/nowhere/ld.so", "/dev/null", "/"])
def test_a_program_that_no_kernel_starts_has_ended(level: str, loader: str, tmp_path: Path) -> None:
    source = tmp_path / "empty.c"
    source.write_text("int main(void) { return 0; }\n")
    program = tmp_path / "needs_what_is_not_there"
    wanting = f"-Wl,--dynamic-linker={loader}"
    subprocess.run(["gcc", source, wanting, "-o", program], check=True)
    end = run_box(level, "--show", f"{program}=/program", "/program")
    assert end["exit_code"] == 127
    assert end["errors"] == ""
