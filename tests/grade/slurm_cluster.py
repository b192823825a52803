"""A Slurm cluster of two nodes on this machine, for tests and for trying out.

munged, slurmctld and two slurmd run on loopback, with a key, sockets, ports, state and logs of
their own in a temporary folder, beside any Slurm that the machine has. Each of them, with the steps
of its jobs, is looked after by a keeper: a process that its orphans fall to, so that a node can be
ended with all that ran on it, and nothing is left whatever happens.

    python tests/grade/slurm_cluster.py --exec 'sinfo; contact grade ... --engine slurm'
"""

from __future__ import annotations

import argparse
import contextlib
import ctypes
import os
import pwd
import re
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

NODES = ("one", "two")
CPUS_A_NODE = 2
# Daemons live in sbin, which not every user has in the path.
PATH = os.environ.get("PATH", os.defpath) + ":/usr/local/sbin:/usr/sbin:/sbin"
DAEMONS = ("munged", "slurmctld", "slurmd")
COMMANDS = ("sbatch", "squeue", "scancel", "scontrol", "sinfo", "munge")

CONFIGURATION = """\
ClusterName=contact
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SwitchType=switch/none
MpiDefault=none
# A node that died comes back when its slurmd does, and is missed soon.
ReturnToService=2
SlurmdTimeout=10
MessageTimeout=5
KillWait=2
# A queue that moves at once: jobs here take seconds.
SchedulerParameters=batch_sched_delay=0,sched_interval=2,bf_interval=2
{nodes}
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


class ClusterError(RuntimeError):
    """Slurm is missing here or does not start; the text says what it said."""


def missing() -> list[str]:
    """Programs of Slurm and munge that this machine lacks."""
    return [name for name in (*DAEMONS, *COMMANDS) if shutil.which(name, path=PATH) is None]


def free_ports(count: int) -> list[int]:
    """Ports that nothing listens on, all different."""
    with contextlib.ExitStack() as stack:
        sockets = [stack.enter_context(socket.socket()) for _ in range(count)]
        for one in sockets:
            one.bind(("127.0.0.1", 0))
        return [one.getsockname()[1] for one in sockets]


def descendants(pid: int) -> list[int]:
    """Every process under this one, parents first."""
    children: dict[int, list[int]] = {}
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            # A process that ends meanwhile has no children that matter.
            with contextlib.suppress(OSError):
                parent = int((entry / "stat").read_text().rpartition(")")[2].split()[1])
                children.setdefault(parent, []).append(int(entry.name))
    found = [pid]
    for one in found:
        found += children.get(one, [])
    return found[1:]


def keep(command: Sequence[str]) -> int:
    """Runs a daemon as the parent of all that it leaves; on SIGTERM, or when the process that
    started this one is gone, ends it and all under it."""
    prctl = ctypes.CDLL(None, use_errno=True).prctl
    set_pdeathsig, set_child_subreaper = 1, 36
    prctl(set_child_subreaper, 1, 0, 0, 0)
    signal.pthread_sigmask(signal.SIG_BLOCK, (signal.SIGTERM, signal.SIGCHLD))
    parent = os.getppid()
    prctl(set_pdeathsig, signal.SIGTERM, 0, 0, 0)
    if os.getppid() != parent:
        return 1
    daemon = subprocess.Popen(
        command,
        preexec_fn=lambda: signal.pthread_sigmask(signal.SIG_UNBLOCK, (signal.SIGTERM,)),
    )
    while signal.sigwait((signal.SIGTERM, signal.SIGCHLD)) != signal.SIGTERM:
        with contextlib.suppress(ChildProcessError):
            while (ended := os.waitpid(-1, os.WNOHANG)[0]) != 0:
                if ended == daemon.pid:
                    # The daemon gave up; its steps go on, as they would on a real node.
                    print(f"{command[0]} has ended", file=sys.stderr, flush=True)
    while left := descendants(os.getpid()):
        for pid in left:
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        with contextlib.suppress(ChildProcessError):
            while os.waitpid(-1, os.WNOHANG)[0] != 0:
                pass
        time.sleep(0.01)
    return 0


class Cluster:
    """Started by the constructor, ended by close(). `environment` is what a command needs to find
    it."""

    def __init__(self) -> None:
        lacking = missing()
        if lacking:
            raise ClusterError(
                f"{', '.join(lacking)} not found: install Slurm and munge "
                "(Debian: apt-get install slurm-wlm munge)."
            )
        # Slurm's and munge's sockets must fit in 107 bytes, which a test's own folder may exceed.
        self.folder = Path(tempfile.mkdtemp(prefix="contact-slurm-", dir="/tmp"))
        self.configuration = self.folder / "slurm.conf"
        self.environment: dict[str, str] = {
            **{name: value for name, value in os.environ.items() if not name.startswith("SLURM_")},
            "PATH": PATH,
            "SLURM_CONF": str(self.configuration),
        }
        self._keepers: dict[str, subprocess.Popen[bytes]] = {}
        try:
            self._configure()
            self._start_munge()
            self.start_controller()
            for node in NODES:
                self.start_node(node)
            self._wait("the nodes to be idle", lambda: self.node_states() == {"idle"})
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        for name in list(self._keepers):
            self._end(name)
        shutil.rmtree(self.folder, ignore_errors=True)

    def __enter__(self) -> Cluster:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def run(self, *command: str) -> str:
        """What a Slurm command says on standard output."""
        done = subprocess.run(
            command, env=self.environment, capture_output=True, text=True, timeout=60
        )
        if done.returncode != 0:
            raise ClusterError(f"{' '.join(command)}: {done.stderr.strip()}")
        return done.stdout

    def queue(self) -> list[str]:
        """What waits, runs or is about to end, a line each: id, state, name."""
        return self.run("squeue", "--noheader", "--array", "--format=%i %T %j").splitlines()

    def node_states(self) -> set[str]:
        """Each state that some node is in: idle, mixed, down, ..."""
        return set(self.run("sinfo", "--noheader", "--Node", "--format=%T").split())

    def start_controller(self) -> None:
        """Also after end_controller(): it reads where it was."""
        self._start("slurmctld", ["slurmctld", "-D", "-f", str(self.configuration)])

    def end_controller(self) -> None:
        """As for an update: it writes down where it is. sbatch and squeue get no answer from then
        on; the nodes continue."""
        daemon = descendants(self._keepers["slurmctld"].pid)[0]
        os.kill(daemon, signal.SIGTERM)
        self._wait("slurmctld to end", lambda: not Path(f"/proc/{daemon}").exists())
        self._end("slurmctld")

    def start_node(self, node: str) -> None:
        """Also after end_node()."""
        command = ["slurmd", "-D", "-N", node, "-f", str(self.configuration)]
        self._start(node, command)

    def end_node(self, node: str) -> None:
        """As if its plug were pulled: slurmd, the steps of its jobs and what they run are gone at
        once. Returns at once; the controller misses the node after some seconds."""
        self._end(node)

    def processes(self, node: str) -> list[int]:
        """slurmd and every process of a job on this node."""
        return descendants(self._keepers[node].pid)

    def _configure(self) -> None:
        user = pwd.getpwuid(os.geteuid()).pw_name
        controller, *ports = free_ports(1 + len(NODES))
        memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") >> 20
        nodes = "\n".join(
            f"NodeName={node} NodeHostname=localhost NodeAddr=127.0.0.1 Port={port} "
            f"CPUs={CPUS_A_NODE} RealMemory={memory} State=UNKNOWN"
            for node, port in zip(NODES, ports, strict=True)
        )
        self.configuration.write_text(
            CONFIGURATION.format(
                host=socket.gethostname().partition(".")[0],
                port=controller,
                user=user,
                folder=self.folder,
                nodes=nodes,
            )
        )
        # slurmd starts a plugin for control groups even where nothing uses it. Newer versions can
        # do without; in older ones the first asks nothing of the machine.
        said = self.run("slurmctld", "-V")
        version = re.search(r"(\d+)\.(\d+)", said)
        if version is None:
            raise ClusterError(f"slurmctld -V said {said.strip()!r}, which names no version")
        modern = (int(version[1]), int(version[2])) >= (23, 2)
        plugin = "disabled" if modern else "cgroup/v1"
        (self.folder / "cgroup.conf").write_text(f"CgroupPlugin={plugin}\n")
        for name in ("state", *NODES):
            (self.folder / name).mkdir()

    def _start_munge(self) -> None:
        folder = self.folder / "munge"
        folder.mkdir()
        key = folder / "key"
        key.touch(0o400)
        key.chmod(0o600)
        key.write_bytes(secrets.token_bytes(128))
        # Jobs of any user must reach the socket, and munge insists on it.
        self.folder.chmod(0o711)
        folder.chmod(0o711)
        command = ["munged", "--foreground", "--num-threads=2"]
        for what in ("key-file", "pid-file", "seed-file", "socket"):
            name = folder / what.removesuffix("-file")
            command.append(f"--{what}={name}")
        self._start("munged", command)
        self._wait("munged", (folder / "socket").exists)

    def _start(self, name: str, command: list[str]) -> None:
        with (self.folder / f"{name}.err").open("ab") as log:
            self._keepers[name] = subprocess.Popen(
                [sys.executable, __file__, "--keep", *command],
                env=self.environment,
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=log,
                start_new_session=True,
            )

    def _end(self, name: str) -> None:
        keeper = self._keepers.pop(name)
        keeper.terminate()
        keeper.wait(timeout=30)

    def _wait(self, what: str, ready: Callable[[], bool]) -> None:
        end = time.monotonic() + 30
        while time.monotonic() < end:
            with contextlib.suppress(ClusterError):
                if ready():
                    return
            time.sleep(0.1)
        raise ClusterError(f"waited in vain for {what}.\n{self._last_words()}")

    def _last_words(self) -> str:
        lines = []
        for log in sorted([*self.folder.glob("*.err"), *self.folder.glob("*.log")]):
            said = log.read_text(errors="replace").splitlines()[-8:]
            lines += [f"{log.name}: {line}" for line in said]
        return "\n".join(lines)


def shell(command: str, environment: Mapping[str, str]) -> int:
    return subprocess.run(["bash", "-c", command], env=dict(environment)).returncode


def main(arguments: Sequence[str]) -> int:
    if arguments[:1] == ["--keep"]:
        return keep(arguments[1:])
    parser = argparse.ArgumentParser(description="Starts a Slurm cluster on this machine.")
    parser.add_argument(
        "--exec", metavar="COMMAND", default="bash", help="what to run in it; a shell if left out"
    )
    command = parser.parse_args(arguments).exec
    try:
        with Cluster() as one:
            return shell(command, one.environment)
    except ClusterError as error:
        print(f"slurm_cluster: {error}", file=sys.stderr)
        return 3


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
