"""Submissions that attack the grader: none gets a mark that it did not earn, none harms another's
mark, none outlives its run, and the honest twin of each passes.

One run grades them all, between honest neighbours; hostile_corpus.py says what each must get.
"""

from __future__ import annotations

import json
import os
import re
import secrets
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import hull_book  # noqa: E402
import recorded_answers  # noqa: E402
from hostile_archives import PACKED, Packed  # noqa: E402
from hostile_corpus import (  # noqa: E402
    NO_COMPILE,
    loot,
    misses,
)
from hostile_run import (  # noqa: E402
    ALL_OF_THE_BOOK,
    BOOKS_OWN,
    BUILD,
    HARMED,
    HULLS,
    PACKED_TWINS,
    PLANES,
    PROBE,
    ROOT,
    SEED,
    SPECIMENS,
    TAKEN,
    TWINS,
    Outside,
    Run,
    digests,
    new_run,
    outside,
    programs_with,
    remains,
    solution,
)
from reach import PYTHON, skip_if_closed  # noqa: E402

# Of what is kept from them in another way where no user id can be changed.
FOR_PLAIN_USERS = (
    "disk_fill",
    "endless_loop",
    "file_reader",
    "fork_bomb",
    "forged_events",
    "forged_report",
    "include_secret",
    "keeps_state",
    "kill_others",
    "leftover_process",
    "network_tcp",
    "proc_reader",
    "ptrace_parent",
    "syscall_instruction",
)


@pytest.fixture(scope="session", params=["full", "reduced"])
def level(request: pytest.FixtureRequest) -> str:
    if request.param == "reduced":
        skip_if_closed()
    return str(request.param)


@pytest.fixture(scope="session")
def canaries(level: str) -> Iterator[Outside]:
    with outside(level) as made:
        yield made


@pytest.fixture(scope="session")
def quiet(level: str, canaries: Outside, tmp_path_factory: pytest.TempPathFactory) -> Run:
    """One honest answer alone, and a probe that must find every door shut before anything is run
    that would do harm behind it."""
    run = new_run(tmp_path_factory.mktemp(f"quiet-{level}"), canaries, level)
    run.add("neighbour_1", PLANES, solution(PLANES).read_text())
    run.add("probe", PLANES, PROBE)
    run.grade(PLANES, workers=1)
    if run.document["machine"]["level"] != level:
        pytest.skip(f"this machine grades at the level {run.document['machine']['level']}")
    probe = run.entry("probe", PLANES)
    assert loot(probe) == []
    assert probe["verdict"]["output"].count("held: ") >= 4, probe
    return run


@pytest.fixture(scope="session")
def run(quiet: Run, canaries: Outside, level: str, tmp_path_factory: pytest.TempPathFactory) -> Run:
    """Everybody together."""
    run = new_run(tmp_path_factory.mktemp(f"hostile-{level}"), canaries, level)
    run.add_neighbours(beside=HARMED)
    for name in BOOKS_OWN:
        run.add_attack(SPECIMENS[name])
    answer = solution(PLANES).read_text()
    for packed in PACKED:
        packed.make(run.submissions, packed.name, answer, run.words())
    for packed in PACKED_TWINS:
        packed.twin(run.submissions, f"{packed.name}_twin", answer)
    run.grade(",".join(sorted({PLANES, *(SPECIMENS[name].exercise for name in BOOKS_OWN)})))
    return run


@pytest.fixture(scope="session")
def hulls(
    quiet: Run, canaries: Outside, level: str, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Run]:
    """Those whose answers are indices, in a book of their own."""
    run = new_run(tmp_path_factory.mktemp(f"hulls-{level}"), canaries, level)
    # Beside the book itself, where boxes of other users see it too.
    with tempfile.TemporaryDirectory(prefix="hulls-", dir=ROOT / "build") as made:
        Path(made).chmod(0o755)
        run.environment["CONTACT_ROOT"] = str(hull_book.make(Path(made) / "book"))
        for name in HULLS:
            run.add_attack(SPECIMENS[name])
        run.grade(hull_book.EXERCISE)
        yield run


@pytest.fixture(scope="session")
def recorded(
    quiet: Run, canaries: Outside, level: str, tmp_path_factory: pytest.TempPathFactory
) -> Mapping[str, dict[str, Any]]:
    """The same recorded answers, graded under the seed they were recorded under and another."""
    text = ""
    entries = {}
    for seed in ("recorded", SEED):
        folder = tmp_path_factory.mktemp(f"{seed}-{level}")
        run = new_run(folder, canaries, level)
        build = json.loads((BUILD / "exercises.json").read_text())
        text = text or recorded_answers.submission(build, folder, seed)
        run.add("recorded", PLANES, text)
        run.grade(PLANES, workers=1, seed=seed)
        entries[seed] = run.entry("recorded", PLANES)
    return entries


@pytest.fixture(scope="session")
def plain(quiet: Run, canaries: Outside, level: str) -> Iterator[Run]:
    """Some of them, graded by a user without any rights."""
    if os.geteuid() != 0 or shutil.which("setpriv") is None:
        pytest.skip("the other runs are by a plain user already")
    skip_if_closed(PYTHON)
    user = 60000 + secrets.randbelow(3000)
    with tempfile.TemporaryDirectory(prefix="contact-plain-") as made:
        folder = Path(made)
        run = new_run(folder, canaries, level)
        run.command = ("setpriv", f"--reuid={user}", f"--regid={user}", "--clear-groups")
        run.add_neighbours(beside=FOR_PLAIN_USERS[::7])
        for name in FOR_PLAIN_USERS:
            run.add_attack(SPECIMENS[name])
        for file in (folder, run.temporary, *folder.rglob("*")):
            os.chown(file, user, user)
        run.environment["HOME"] = made
        run.grade(PLANES)
        reached = run.document["machine"]["level"]
        if reached != level:
            pytest.skip(f"a plain user has the level {reached} here")
        yield run


def same_for_all(entry: Mapping[str, Any]) -> str:
    """An honest answer's verdict without its times."""
    kept = {key: value for key, value in entry["verdict"].items() if key != "times"}
    return json.dumps(kept, sort_keys=True)


def run_of(name: str, request: pytest.FixtureRequest) -> Run:
    run: Run = request.getfixturevalue("hulls" if name in HULLS else "run")
    return run


@pytest.mark.parametrize("name", TAKEN)
def test_the_attack_gets_what_it_earned(
    name: str, request: pytest.FixtureRequest, level: str
) -> None:
    specimen = SPECIMENS[name]
    entry = run_of(name, request).entry(name, specimen.exercise)
    if level == "reduced" and specimen.reduced:
        assert entry["points"] <= specimen.points
        return
    assert misses(specimen, entry) == []
    assert loot(entry) == []


@pytest.mark.parametrize("name", [name for name in TAKEN if SPECIMENS[name].seconds is not None])
def test_who_only_waits_holds_nobody_up(
    name: str, request: pytest.FixtureRequest, level: str
) -> None:
    specimen = SPECIMENS[name]
    folder = run_of(name, request).results / ".grade/units" / name
    (file,) = folder.glob("*.json")
    unit = json.loads(file.read_text())
    # Compiling it waits for the machine, too, and is believed only when it was tried alone.
    compiles = specimen.tests != NO_COMPILE
    assert specimen.seconds is not None
    assert unit["seconds"] * (1 if compiles else 2) < specimen.seconds
    assert not (compiles and unit["near_limit"])


@pytest.mark.parametrize("name", TWINS)
def test_its_honest_twin_passes(name: str, request: pytest.FixtureRequest, level: str) -> None:
    specimen = SPECIMENS[name]
    assert "attack" not in specimen.twin
    entry = run_of(name, request).entry(f"{name}_twin", specimen.exercise)
    assert entry["status"] == "graded", entry.get("problem")
    assert entry["points"] == entry["max_points"] == specimen.max_points


@pytest.mark.parametrize("packed", PACKED, ids=lambda packed: packed.name)
def test_what_is_packed_in_bad_faith_gets_nothing(packed: Packed, run: Run) -> None:
    whole = run.by_id[packed.name]
    entry = run.entry(packed.name, PLANES) if whole["exercises"] else {}
    assert whole["points"] == 0
    assert "verdict" not in entry
    assert packed.says or entry["status"] == "missing"
    problem = whole.get("problem") or entry.get("problem") or ""
    assert packed.says in problem


@pytest.mark.parametrize("packed", PACKED_TWINS, ids=lambda packed: packed.name)
def test_the_same_packed_honestly_passes(packed: Packed, run: Run) -> None:
    entry = run.entry(f"{packed.name}_twin", PLANES)
    assert entry["points"] == entry["max_points"]


def test_everybody_honest_gets_the_verdict_that_they_get_alone(run: Run, quiet: Run) -> None:
    alone = same_for_all(quiet.entry("neighbour_1", PLANES))
    honest = [name for name in run.by_id if "neighbour" in name]
    assert len(honest) == 4 + len(HARMED)
    honest += [f"{packed.name}_twin" for packed in PACKED_TWINS]
    for name in honest:
        assert same_for_all(run.entry(name, PLANES)) == alone, name


@pytest.mark.parametrize("name", FOR_PLAIN_USERS)
def test_who_has_no_rights_grades_as_well(name: str, plain: Run) -> None:
    specimen = SPECIMENS[name]
    entry = plain.entry(name, PLANES)
    assert misses(specimen, entry) == []
    assert loot(entry) == []
    assert programs_with(plain.outside.token) == []


def test_who_has_no_rights_gives_the_honest_their_points(plain: Run) -> None:
    honest = [plain.entry(name, PLANES) for name in plain.by_id if "neighbour" in name]
    assert [entry["points"] for entry in honest] == [entry["max_points"] for entry in honest]
    assert len(honest) == 6


def test_recorded_answers_are_worth_what_has_not_changed(
    recorded: Mapping[str, dict[str, Any]],
) -> None:
    known, unknown = recorded["recorded"], recorded[SEED]
    assert known["points"] == known["max_points"], "the record is good, so that it is the seed"
    assert [test["status"] for test in unknown["verdict"]["tests"]] == ["passed"] * 5 + ["failed"]


def test_no_process_outlives_the_run(run: Run) -> None:
    patience = time.monotonic() + 60
    while (left := programs_with(run.outside.token)) and time.monotonic() < patience:
        time.sleep(0.5)
    assert left == []


def test_a_process_that_is_left_would_be_seen(tmp_path: Path) -> None:
    token = f"hostile{secrets.token_hex(8)}"
    program = tmp_path / "left"
    shutil.copy("/bin/sleep", program)
    with program.open("ab") as opened:
        opened.write(token.encode())
    with subprocess.Popen([program, "60"]) as process:
        assert [entry.split(":")[0] for entry in programs_with(token)] == [str(process.pid)]
        process.kill()


def test_nothing_is_left_on_the_machine(run: Run) -> None:
    now = remains(run.outside.token)
    assert now["files"] == []
    for kind in ("shm", "msg", "sem"):
        assert set(now[kind]) <= set(run.before[kind])
    assert list(run.temporary.iterdir()) == []


def test_nobody_called(run: Run, hulls: Run) -> None:
    assert run.outside.calls() == []


def test_a_call_would_be_seen() -> None:
    with outside("full") as canaries:
        with socket.create_connection(canaries.tcp.getsockname()):
            pass
        with socket.socket(socket.AF_UNIX) as caller:
            caller.connect(f"\0{canaries.token}")
        canaries.udp.sendto(b"x", canaries.udp.getsockname())
        assert canaries.calls() == ["tcp", "abstract", "udp"]


def test_submissions_are_as_they_were(run: Run) -> None:
    assert digests(run.submissions) == run.digests


def test_results_hold_what_the_grader_wrote(run: Run) -> None:
    ids = "|".join(re.escape(name) for name in run.by_id)
    expected = re.compile(
        r"results\.json|run\.json|gradebook\.csv|class\.html|changes\.json"
        rf"|students/({ids})/[a-z0-9_]+\.(html|json|xml)"
        rf"|\.grade/(RUN\.json|log|lock|machine\.json|machines/[^/]+\.json)"
        rf"|\.grade/(submissions|units)/({ids})/[a-z0-9_./]+"
    )
    for file in run.results.rglob("*"):
        assert not file.is_symlink(), file
        name = str(file.relative_to(run.results))
        assert file.is_dir() or expected.fullmatch(name), name
        if file.is_file():
            assert file.stat().st_mode & 0o111 == 0, file


def test_no_secret_is_in_the_results(run: Run) -> None:
    submitted = run.results / ".grade" / "submissions"
    seen = ["root:x:0:0"] if run.level == "full" else []
    for file in run.results.rglob("*"):
        if file.is_file() and submitted not in file.parents:
            text = file.read_bytes()
            for words in (run.outside.content, *seen):
                assert words.encode() not in text, file


def test_every_attack_says_what_it_must_get() -> None:
    assert len(SPECIMENS) + len(PACKED) >= 30
    for specimen in SPECIMENS.values():
        assert specimen.tries
        assert specimen.twin != specimen.text
        assert "attack" not in specimen.twin


@pytest.mark.parametrize("name", [name for name in ALL_OF_THE_BOOK if SPECIMENS[name].ordinary])
def test_the_attack_works_where_tests_and_answer_are_one_program(name: str, tmp_path: Path) -> None:
    """What its header claims for ordinary grading: the report, or the status, of the student's file
    linked with the tests."""
    specimen = SPECIMENS[name]
    build = json.loads((BUILD / "exercises.json").read_text())
    bundle = build["exercises"][specimen.exercise]
    source, program, report = tmp_path / "answer.cpp", tmp_path / "answer", tmp_path / "report"
    source.write_text(specimen.text)
    folders = [f"-I{folder}" for folder in [*build["include"], *bundle["include"]]]
    options = [*build["compile_flags"], "-include", build["pch"], *folders, *build["link_flags"]]
    subprocess.run(
        [build["compiler"], *options, str(source), bundle["test_object"], "-o", str(program)],
        check=True,
    )
    ran = subprocess.run(
        [str(program), "-r", f"contact::out={report}"],
        cwd=tmp_path,
        capture_output=True,
        timeout=60,
    )
    assert ran.returncode == 0
    if specimen.ordinary == "full marks":
        events = [json.loads(line) for line in report.read_text().splitlines()]
        ended = [event["status"] for event in events if event["event"] == "end"]
        assert ended == ["passed"] * 6
        assert events[-1] == {"event": "done"}
    else:
        assert specimen.ordinary == "exit status 0"
