"""A run of `contact grade` over submissions that attack it: which ones, what they must not reach,
and what they could leave behind."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import secrets
import socket
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import hull_book
from hostile_archives import ANSWER, PACKED
from hostile_corpus import (
    Specimen,
    corpus,
    different_twins,
    filled,
)
from sample import sample

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "dev"
PROGRAM = BUILD / "bin" / "contact"
PLANES = "01_planes/signed_distance"
SPECIMENS = {specimen.name: specimen for specimen in corpus()}
ALL_OF_THE_BOOK = [
    name for name, specimen in SPECIMENS.items() if specimen.exercise != hull_book.EXERCISE
]
# Half of the attacks in each turn: some are ended only at their limit of time, at two levels.
BOOKS_OWN = sample(ALL_OF_THE_BOOK, 2, "attacks", kind="hostile")
OF_HULLS = [name for name in SPECIMENS if name not in ALL_OF_THE_BOOK]
HULLS = sample(OF_HULLS, 2, "attacks on hulls", kind="hostile")
TAKEN = [*BOOKS_OWN, *HULLS]
# Without its attack nearly every one is the same answer, which need not be graded for each of them;
# nor what is packed honestly in the same way.
TWINS = [specimen.name for specimen in different_twins([SPECIMENS[name] for name in TAKEN])]
PACKED_TWINS = list({packed.twin: packed for packed in PACKED}.values())
# Attacks with an honest answer right behind them, which would be harmed first.
HARMED = sample(BOOKS_OWN, 6, "attacks before honest answers", within=2)
SEED = "hostile"

# Small, so that what is ended is ended soon.
PROFILE = """\
test_cpu_seconds = 0.5
wall_factor = 2.0
wall_extra = 1.0
memory_mb = 256
output_bytes = 65536
compile_cpu_seconds = 2.0
compile_memory_mb = 768
object_mb = 32
"""

# Does nothing but say what it could do, before anything here is run that would do harm.
PROBE = """
#include "signed_distance.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>
#include <csignal>
#include <cstdio>

namespace {
const bool tried = [] {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  dprintf(1, "%s: a process\\n", child > 0 ? "GOT IT" : "held");
  dprintf(1, "%s: a signal\\n", kill(getppid(), 0) == 0 ? "GOT IT" : "held");
  dprintf(1, "%s: a file\\n", open("/etc/passwd", O_RDONLY) >= 0 ? "GOT IT" : "held");
  dprintf(1, "%s: a socket\\n", socket(AF_INET, SOCK_STREAM, 0) >= 0 ? "GOT IT" : "held");
  return true;
}();
}  // namespace

namespace exercise {
double signed_distance(const PlaneEquation&, const Eigen::Vector3d&) { return 1; }
int side(const PlaneEquation&, const Eigen::Vector3d&) { return 1; }
}  // namespace exercise
"""


@dataclass
class Outside:
    """What a submission must not reach, and what shows whether it did."""

    folder: Path
    token: str = field(default_factory=lambda: f"hostile{secrets.token_hex(8)}")

    def __post_init__(self) -> None:
        self.content = f"secret{secrets.token_hex(16)}"
        self.secret = self.folder / "secret"
        self.secret.write_text(f'static const char got[] = "{self.content}";\n')
        self.tcp = socket.create_server(("127.0.0.1", 0))
        self.udp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.udp.bind(("127.0.0.1", 0))
        self.abstract = socket.socket(socket.AF_UNIX)
        self.abstract.bind(f"\0{self.token}")
        self.abstract.listen()
        self.named = socket.socket(socket.AF_UNIX)
        self.named.bind(str(self.folder / "socket"))
        (self.folder / "socket").chmod(0o777)
        self.named.listen()
        for listener in (self.tcp, self.udp, self.abstract, self.named):
            listener.setblocking(False)

    def calls(self) -> list[str]:
        """Who called."""
        found = []
        for name in ("tcp", "abstract", "named"):
            with contextlib.suppress(BlockingIOError):
                getattr(self, name).accept()
                found.append(name)
        with contextlib.suppress(BlockingIOError):
            self.udp.recv(100)
            found.append("udp")
        return found

    def close(self) -> None:
        for listener in (self.tcp, self.udp, self.abstract, self.named):
            listener.close()


@dataclass
class Run:
    """One run of `contact grade`, and what was there before it."""

    folder: Path
    outside: Outside
    level: str
    environment: dict[str, str]
    command: tuple[str, ...] = ()
    result: subprocess.CompletedProcess[str] | None = None

    def __post_init__(self) -> None:
        self.submissions = self.folder / "submissions"
        self.results = self.folder / "results"
        self.submissions.mkdir(parents=True)
        # Where another user's boxes may go, as into the system's own.
        self.temporary = Path(tempfile.mkdtemp(prefix="tmp-", dir=self.outside.folder))
        self.temporary.chmod(0o755)
        self.profile = self.folder / "profile.toml"
        self.profile.write_text(PROFILE)

    def words(self) -> dict[str, str]:
        """The placeholders in a submission for values that exist only here."""
        return {
            "TOKEN": self.outside.token,
            "SECRET": str(self.outside.secret),
            "TCP_PORT": str(self.outside.tcp.getsockname()[1]),
            "UDP_PORT": str(self.outside.udp.getsockname()[1]),
            "UNIX_SOCKET": str(self.outside.folder / "socket"),
            "CANARY": self.outside.token.upper(),
            "ROOT": str(ROOT),
            "RESULTS": str(self.results),
            "SUBMISSIONS": str(self.submissions),
            "NEIGHBOUR": str(self.submissions / "neighbour_1" / ANSWER),
            "NEIGHBOUR_ID": "neighbour_1",
            "SOLUTION": str(solution(PLANES)),
        }

    def add(self, name: str, exercise: str, text: str) -> None:
        file = self.submissions / name / f"{exercise}.cpp"
        file.parent.mkdir(parents=True)
        file.write_text(text)

    def add_attack(self, specimen: Specimen) -> None:
        self.add(specimen.name, specimen.exercise, filled(specimen.text, self.words()))
        if specimen.name in TWINS:
            self.add(f"{specimen.name}_twin", specimen.exercise, specimen.twin)

    def add_neighbours(self, beside: Sequence[str] = ()) -> None:
        """Honest answers in between, some right after an attack: submissions are taken in the order
        of their names."""
        some = ("a_neighbour", "f_neighbour", "neighbour_1", "z_neighbour")
        for name in (*some, *(f"{attack}_neighbour" for attack in beside)):
            self.add(name, PLANES, solution(PLANES).read_text())

    def grade(self, exercises: str, *options: str, workers: int = 2, seed: str = SEED) -> None:
        self.before = remains(self.outside.token)
        self.digests = digests(self.submissions)
        words = [*self.command, str(PROGRAM), "grade", str(self.submissions)]
        words += ["-o", str(self.results), "--exercises", exercises, "--seed", seed]
        words += ["--workers", str(workers), "--profile", str(self.profile), *options]
        environment = {
            **self.environment,
            "TMPDIR": str(self.temporary),
            self.words()["CANARY"]: "from the grader's environment",
        }
        self.result = subprocess.run(
            words,
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            cwd=self.folder,
            timeout=1200,
        )
        said = self.result.stdout + self.result.stderr
        assert self.result.returncode in (0, 1), said
        self.document = json.loads((self.results / "results.json").read_text())
        self.by_id = {entry["id"]: entry for entry in self.document["submissions"]}

    def entry(self, name: str, exercise: str) -> dict[str, Any]:
        (entry,) = [e for e in self.by_id[name]["exercises"] if e["id"] == exercise]
        return dict(entry)


def solution(exercise: str) -> Path:
    return ROOT / "solutions" / exercise / f"{exercise.split('/')[1]}.cpp"


def digests(folder: Path) -> dict[str, str]:
    """What is in a folder: links by their target, files by their bytes unless they are huge."""
    found = {}
    for file in sorted(folder.rglob("*")):
        name = str(file.relative_to(folder))
        if file.is_symlink():
            found[name] = str(file.readlink())
        elif file.is_file() and file.stat().st_size < 1 << 30:
            found[name] = hashlib.sha256(file.read_bytes()).hexdigest()
        else:
            found[name] = oct(file.stat().st_mode)
    return found


def remains(token: str) -> dict[str, list[str]]:
    """What a submission could leave behind on this machine."""
    left: dict[str, list[str]] = {}
    for kind in ("shm", "msg", "sem"):
        rows = Path(f"/proc/sysvipc/{kind}").read_text().splitlines()[1:]
        left[kind] = sorted(" ".join(row.split()[:2]) for row in rows)
    left["files"] = [
        str(file)
        for folder in ("/tmp", "/var/tmp", "/dev/shm", "/run", "/box")
        for file in Path(folder).glob(f"*{token}*")
    ]
    return left


def holds(program: Path, token: str) -> bool:
    with contextlib.suppress(OSError):
        return token.encode() in program.read_bytes()
    return False


def programs_with(token: str) -> list[str]:
    """Processes whose program has the token in it, whatever they call themselves."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            program = process / "exe"
            # Ours are linked statically and small.
            if program.stat().st_size < 64 << 20 and holds(program, token):
                found.append(f"{process.name}: {program.readlink()}")
    return found


def environment_at(level: str) -> dict[str, str]:
    environment = {**os.environ, "CONTACT_ROOT": str(ROOT)}
    environment.pop("CONTACT_SEED", None)
    if level == "reduced":
        environment["CONTACT_BOX_LEVEL"] = "reduced"
    return environment


@contextlib.contextmanager
def outside(level: str) -> Iterator[Outside]:
    """Where every user may look, so that only the box hides it; at the reduced level, which has
    another user id and no more, where only we may."""
    with tempfile.TemporaryDirectory(prefix="contact-hostile-") as made:
        folder = Path(made)
        folder.chmod(0o755)
        canaries = Outside(folder)
        canaries.secret.chmod(0o600 if level == "reduced" else 0o644)
        try:
            yield canaries
        finally:
            canaries.close()


def new_run(folder: Path, canaries: Outside, level: str) -> Run:
    return Run(folder, canaries, level, environment_at(level))
