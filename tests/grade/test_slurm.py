"""Grading on a real cluster: two nodes of Slurm on this machine, which the test starts and ends.

Skipped where Slurm is not installed, but not in CI."""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, cast

import pytest

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from slurm_cluster import CPUS_A_NODE, NODES, PATH, Cluster, missing  # noqa: E402
from wrong_answers import wrong_answers  # noqa: E402

ROOT = HERE.parents[1]
PROGRAM = ROOT / "build" / "dev" / "bin" / "contact"
WORKER = str(PROGRAM.with_name("contact-grade"))
EXERCISE = "02_triangles/point_in_triangle"
SOLUTIONS = ROOT / "solutions" / EXERCISE
SOLUTION = (SOLUTIONS / "point_in_triangle.cpp").read_text()
# A shell and Slurm's patterns for files would each read something else here.
AWKWARD = 'it\'s "100%j" $HOME `x`\\n é'
# Right and wrong answers, and one that does not compile.
ANSWERS = [
    SOLUTION,
    *(wrong.read_text() for wrong in wrong_answers(EXERCISE)[:3]),
    SOLUTION + "\n",
    "int main( {",
]
SEED = "of the test"
LIMIT = 300


@pytest.fixture(scope="module")
def cluster() -> Iterator[Cluster]:
    lacking = missing()
    if lacking and not os.environ.get("CI"):
        pytest.skip(f"Slurm is not installed here: {', '.join(lacking)} not found")
    with Cluster() as one:
        yield one


@pytest.fixture(autouse=True)
def _whole_cluster(request: pytest.FixtureRequest) -> Iterator[None]:
    """Each test leaves the queue empty, whatever happened in it."""
    yield
    if "cluster" in request.fixturenames:
        one: Cluster = request.getfixturevalue("cluster")
        assert one.queue() == []


class Grading:
    """`contact grade` of these submissions into one folder of results."""

    def __init__(
        self, folder: Path, environment: dict[str, str], answers: Sequence[str] = ANSWERS
    ) -> None:
        self.handed_in = folder / f"handed in, {AWKWARD}"
        for number, answer in enumerate(answers):
            copy = self.handed_in / f"student_{number}" / f"{EXERCISE}.cpp"
            copy.parent.mkdir(parents=True)
            copy.write_text(answer)
        self.results = folder / f"results, {AWKWARD}"
        self.temporary = folder / "tmp"
        self.temporary.mkdir()
        self.environment = {
            **environment,
            "CONTACT_ROOT": str(ROOT),
            "TMPDIR": str(self.temporary),
            "NO_COLOR": "1",
        }

    def start(self, *words: str, seed: str = SEED) -> subprocess.Popen[str]:
        command = [PROGRAM, "grade", self.handed_in, "-o", self.results, "--exercises", EXERCISE]
        return subprocess.Popen(
            [*map(str, command), "--seed", seed, *words],
            env=self.environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def on_slurm(self, *words: str, seed: str = SEED) -> subprocess.Popen[str]:
        """Two tasks at a time, of two units."""
        slurm = ("--engine", "slurm", "--workers", "2", "--units-a-task", "2")
        return self.start(*slurm, *words, seed=seed)

    def log(self, what: str) -> list[str]:
        """The submissions that a worker began ("start") or was done with ("finish"), in turn."""
        file = self.results / ".grade" / "log"
        lines = file.read_text().splitlines() if file.exists() else []
        entries = [line.split("\t") for line in lines]
        return [entry[1] for entry in entries if entry[0] == what and "alone" not in entry]

    def marks(self) -> dict[str, Any]:
        """results.json without what may differ from run to run."""
        text = (self.results / "results.json").read_text()
        return cast("dict[str, Any]", without_times(json.loads(text)))

    def assert_clean(self) -> None:
        assert list(self.temporary.iterdir()) == []
        kept = {path.name for path in (self.results / ".grade").iterdir()}
        assert not kept & {"slices", "slurm.json"}


def without_times(value: object) -> object:
    if isinstance(value, dict):
        return {
            name: without_times(of_name)
            for name, of_name in value.items()
            if name not in ("seconds", "times")
        }
    if isinstance(value, list):
        return [without_times(one) for one in value]
    return value


def ended(grading: subprocess.Popen[str]) -> tuple[int, str]:
    """How it ended and what it said on standard error."""
    output, errors = grading.communicate(timeout=LIMIT)
    assert output is not None
    return grading.returncode, errors


def wait_until(condition: Callable[[], bool], grading: subprocess.Popen[str]) -> None:
    end = time.monotonic() + LIMIT
    while not condition():
        if grading.poll() is not None:
            pytest.fail(f"grading ended before that: {ended(grading)}")
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.02)


@pytest.fixture(scope="module")
def local(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """What everything here must come out as: graded on this machine alone."""
    grading = Grading(tmp_path_factory.mktemp("local"), dict(os.environ))
    code, errors = ended(grading.start("--workers", "2"))
    assert code == 0, errors
    marks = grading.marks()
    points = {entry["points"] for entry in marks["submissions"]}
    assert len(points) > 2, "the answers are to differ in their marks"
    return marks


@pytest.fixture
def grading(cluster: Cluster, tmp_path: Path) -> Grading:
    return Grading(tmp_path, cluster.environment)


def workers(cluster: Cluster, node: str) -> list[int]:
    """The workers of `contact grade` on a node, by their process id."""
    found = []
    for pid in cluster.processes(node):
        try:
            words = Path(f"/proc/{pid}/cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if words[0] == WORKER.encode() and b"grade-worker" in words:
            found.append(pid)
    return found


def all_workers(cluster: Cluster) -> list[int]:
    return [pid for node in NODES for pid in workers(cluster, node)]


def test_results_are_those_of_one_machine(grading: Grading, local: dict[str, Any]) -> None:
    code, errors = ended(grading.on_slurm())
    assert code == 0, errors
    assert grading.marks() == local
    assert set(Counter(grading.log("finish")).values()) == {1}
    record = json.loads((grading.results / "run.json").read_text())
    assert record["engine"] == "slurm"
    grading.assert_clean()


def test_a_killed_task_costs_no_mark(
    cluster: Cluster, grading: Grading, local: dict[str, Any]
) -> None:
    run = grading.on_slurm()
    wait_until(lambda: len(grading.log("finish")) >= 1 and all_workers(cluster) != [], run)
    os.kill(all_workers(cluster)[0], signal.SIGKILL)
    code, errors = ended(run)
    assert code == 0, errors
    assert "submitted again" in errors
    assert grading.marks() == local
    # Only what the worker had under way is begun twice, and what is done is done once.
    assert len(grading.log("start")) <= len(ANSWERS) + 1
    assert set(Counter(grading.log("finish")).values()) == {1}
    grading.assert_clean()


def test_a_killed_node_costs_no_mark(
    cluster: Cluster, grading: Grading, local: dict[str, Any]
) -> None:
    run = grading.on_slurm()
    busy: list[str] = []

    def some_node_is_busy() -> bool:
        busy[:] = [node for node in NODES if workers(cluster, node)]
        return len(grading.log("finish")) >= 1 and busy != []

    wait_until(some_node_is_busy, run)
    lost = busy[0]
    cluster.end_node(lost)
    try:
        code, errors = ended(run)
    finally:
        cluster.start_node(lost)
    assert code == 0, errors
    assert "submitted again" in errors
    assert grading.marks() == local
    assert len(grading.log("start")) <= len(ANSWERS) + CPUS_A_NODE
    assert set(Counter(grading.log("finish")).values()) == {1}


def test_a_killed_coordinator_is_taken_over_from(
    cluster: Cluster, grading: Grading, local: dict[str, Any]
) -> None:
    run = grading.on_slurm()
    wait_until(lambda: len(grading.log("finish")) >= 1, run)
    run.kill()
    ended(run)
    assert cluster.queue() != []
    code, errors = ended(grading.on_slurm())
    assert code == 0, errors
    assert "taken over" in errors
    assert grading.marks() == local
    # No double work: nothing was even begun twice.
    assert Counter(grading.log("start")) == Counter(grading.log("finish"))
    assert set(Counter(grading.log("start")).values()) == {1}
    grading.assert_clean()


def test_a_run_that_asks_for_something_else_does_not_take_over(
    cluster: Cluster, grading: Grading, local: dict[str, Any]
) -> None:
    run = grading.on_slurm(seed="of another test")
    wait_until(lambda: len(grading.log("finish")) >= 1, run)
    run.kill()
    ended(run)
    assert cluster.queue() != []
    code, errors = ended(grading.on_slurm())
    assert code == 0, errors
    assert "cancelled first" in errors
    assert grading.marks() == local
    grading.assert_clean()


def test_a_unit_near_its_limit_has_a_node_to_itself(cluster: Cluster, tmp_path: Path) -> None:
    endless = SOLUTION.replace(") {\n", ") {\n  for (volatile bool on = true; on;) continue;\n")
    profile = tmp_path / "profile.toml"
    # Far more than ten times what the solution takes, so that both runs have the same limit.
    profile.write_text("test_cpu_seconds = 0.5\n")
    marks = []
    for engine in ("slurm", "local"):
        folder = tmp_path / engine
        folder.mkdir()
        one = Grading(folder, cluster.environment, [SOLUTION, endless])
        code, errors = ended(one.start("--engine", engine, "--profile", str(profile)))
        assert code == 0, errors
        assert ("a node to itself" in errors) == (engine == "slurm")
        marks.append(one.marks())
    assert marks[0] == marks[1]
    assert [entry["points"] for entry in marks[0]["submissions"]] == [7, 0]


def test_ctrl_c_leaves_nothing_in_the_queue(
    cluster: Cluster, grading: Grading, local: dict[str, Any]
) -> None:
    run = grading.on_slurm()
    wait_until(lambda: len(grading.log("finish")) >= 1, run)
    run.send_signal(signal.SIGINT)
    code, errors = ended(run)
    assert code == 130, errors
    assert cluster.queue() == []
    assert all_workers(cluster) == []
    grading.assert_clean()
    done = grading.log("finish")
    code, errors = ended(grading.on_slurm())
    assert code == 0, errors
    assert grading.marks() == local
    finished = grading.log("finish")
    assert finished[: len(done)] == done
    assert set(Counter(finished).values()) == {1}


def test_a_controller_that_restarts_is_waited_for(
    cluster: Cluster, grading: Grading, local: dict[str, Any]
) -> None:
    run = grading.on_slurm()
    wait_until(lambda: len(grading.log("finish")) >= 1, run)
    cluster.end_controller()
    said = ""
    assert run.stderr is not None
    while "asked again" not in said:
        line = run.stderr.readline()
        assert line, said
        said += line
    cluster.start_controller()
    code, errors = ended(run)
    assert code == 0, errors
    assert grading.marks() == local
    assert set(Counter(grading.log("start")).values()) == {1}
    grading.assert_clean()


def test_what_is_cancelled_from_outside_is_not_submitted_again(
    cluster: Cluster, grading: Grading, local: dict[str, Any]
) -> None:
    run = grading.on_slurm()
    wait_until(lambda: len(grading.log("finish")) >= 1, run)
    for job in {line.partition("_")[0] for line in cluster.queue()}:
        cluster.run("scancel", job)
    code, errors = ended(run)
    assert code == 3, errors
    assert "cancelled from outside" in errors
    # What was done counts, and what was not is no zero.
    points = {entry["id"]: entry["points"] for entry in grading.marks()["submissions"]}
    known = {entry["id"]: entry["points"] for entry in local["submissions"]}
    assert None in points.values()
    assert {id_: known[id_] for id_ in grading.log("finish")}.items() <= points.items()
    assert all(mark is None or mark == known[id_] for id_, mark in points.items())
    code, errors = ended(grading.on_slurm())
    assert code == 0, errors
    assert grading.marks() == local


class Struck:
    """Each worker that begins this student's unit is struck as soon as it has."""

    def __init__(self, grading: Grading, student: str, number: int) -> None:
        self.grading, self.student, self.number = grading, student, number
        self.over = threading.Event()
        self.thread = threading.Thread(target=self.hunt)

    def hunt(self) -> None:
        file = self.grading.results / ".grade" / "log"
        struck: set[int] = set()
        while not self.over.wait(0.002):
            for line in file.read_text().splitlines() if file.exists() else []:
                words = line.split("\t")
                pid = int(words[-1].rpartition(":")[2])
                if words[:2] == ["start", self.student] and pid not in struck:
                    struck.add(pid)
                    with contextlib.suppress(ProcessLookupError):
                        os.kill(pid, self.number)

    def __enter__(self) -> None:
        self.thread.start()

    def __exit__(self, *_: object) -> None:
        self.over.set()
        self.thread.join()


@pytest.mark.parametrize(
    ("number", "starts", "reason"),
    [
        (signal.SIGKILL, 3, "of Slurm ended as"),
        (signal.SIGSTOP, 2, "grading it took longer than the 15 seconds"),
    ],
)
def test_a_unit_that_no_task_survives_costs_no_other_mark(
    grading: Grading,
    local: dict[str, Any],
    tmp_path: Path,
    number: signal.Signals,
    starts: int,
    reason: str,
) -> None:
    student = "student_1"
    profile = tmp_path / "profile.toml"
    profile.write_text("unit_seconds = 15\n")
    with Struck(grading, student, number):
        code, errors = ended(grading.on_slurm("--profile", str(profile)))
    assert code == 3, errors
    assert f"{student}, {EXERCISE} could not be graded: " in errors
    assert reason in errors
    assert Counter(grading.log("start"))[student] == starts
    before = {entry["id"]: entry for entry in local["submissions"]}
    for entry in grading.marks()["submissions"]:
        if entry["id"] == student:
            assert entry["points"] is None
        else:
            assert entry == before[entry["id"]]
    code, errors = ended(grading.on_slurm("--profile", str(profile)))
    assert code == 0, errors
    assert grading.marks()["submissions"] == local["submissions"]
    grading.assert_clean()


def test_two_units_that_no_task_survives_stop_no_grading(
    grading: Grading, local: dict[str, Any]
) -> None:
    """They are all that is left in the end, so nothing gets done any more."""
    with (
        Struck(grading, "student_2", signal.SIGKILL),
        Struck(grading, "student_3", signal.SIGKILL),
    ):
        code, errors = ended(grading.on_slurm())
    assert code == 3, errors
    known = {entry["id"]: entry["points"] for entry in local["submissions"]}
    points = {entry["id"]: entry["points"] for entry in grading.marks()["submissions"]}
    assert points == known | {"student_2": None, "student_3": None}
    code, errors = ended(grading.on_slurm())
    assert code == 0, errors
    assert grading.marks() == local
    grading.assert_clean()


def test_slurm_says_what_is_wrong_with_a_job(grading: Grading) -> None:
    code, errors = ended(grading.on_slurm("--partition", "nowhere"))
    assert code == 3, errors
    assert "sbatch" in errors
    assert "nowhere" in errors
    grading.assert_clean()


def test_options_for_sbatch_are_passed_on(grading: Grading) -> None:
    words = "--comment='two words' --nodelist=nonesuch"
    code, errors = ended(grading.on_slurm("--slurm-options", words))
    assert code == 3, errors
    assert "sbatch" in errors
    assert "node name" in errors


def test_without_slurm_a_sentence_says_so(tmp_path: Path) -> None:
    # The programs that grading itself needs, but none of Slurm's.
    folder = tmp_path / "bin"
    folder.mkdir()
    for place in PATH.split(":"):
        for program in Path(place).glob("*") if Path(place).is_dir() else ():
            link = folder / program.name
            if program.name not in ("sbatch", "squeue", "scancel") and not link.is_symlink():
                link.symlink_to(program)
    grading = Grading(tmp_path, {**os.environ, "PATH": str(folder)})
    code, errors = ended(grading.on_slurm())
    assert code == 3
    assert "sbatch" in errors
    assert "--engine local" in errors
    assert not (grading.results / "results.json").exists()


def test_a_cluster_that_does_not_answer_is_said(cluster: Cluster, tmp_path: Path) -> None:
    elsewhere = tmp_path / "slurm.conf"
    text = cluster.configuration.read_text()
    # Nothing listens on port 1.
    elsewhere.write_text(
        "\n".join(
            "SlurmctldPort=1" if line.startswith("SlurmctldPort=") else line
            for line in text.splitlines()
        )
        + "\nSlurmctldTimeout=2\nMessageTimeout=2\n"
    )
    environment = {**cluster.environment, "SLURM_CONF": str(elsewhere)}
    code, errors = ended(Grading(tmp_path, environment).on_slurm())
    assert code == 3
    assert "squeue" in errors


def test_the_cluster_leaves_nothing() -> None:
    if missing() and not os.environ.get("CI"):
        pytest.skip("Slurm is not installed here")
    one = Cluster()
    processes = [pid for node in NODES for pid in one.processes(node)]
    assert processes
    one.run("sbatch", "--wrap", "sleep 600")
    one.close()
    assert not one.folder.exists()
    assert not [pid for pid in processes if Path(f"/proc/{pid}").exists()]
    assert shutil.which("sbatch", path=PATH) is not None
