"""Runs in an autograder for each submission: grades it with `contact grade` and writes a result.

    python -m reports.autograder_run SYSTEM SOURCE RESULT SUBMISSION

SYSTEM is gradescope or prairielearn, SOURCE the unpacked autograder, RESULT the file to write.
Before grading begins it writes a result that says that there is no mark yet, so if this program is
killed, no student reads a wrong mark. Its output is for teachers.

    python -m reports.autograder_run try SOURCE RESULT

grades the book's own stubs, to see that it can.
"""

from __future__ import annotations

import json
import os
import shutil
import stat
import subprocess
import sys
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from reports.autograder import OPTIONS, PROFILE, book_root
from reports.gradescope import gradescope, not_graded
from reports.moment import moment
from reports.prairielearn import not_graded as not_graded_prairielearn
from reports.prairielearn import prairielearn
from reports.results import ReportError, read_results
from reports.visibility import Policy, SeenSubmission, see

Json = dict[str, Any]

# A little more than the intake of submissions takes, so that it is the one that refuses.
MAX_FILES = 2_000
MAX_BYTES = 64 << 20
DEEPEST = 32

SYSTEMS: dict[str, tuple[Callable[[SeenSubmission], Json], Callable[[str], Json]]] = {
    "gradescope": (gradescope, not_graded),
    "prairielearn": (prairielearn, not_graded_prairielearn),
}
# Exit codes of `contact grade` after which there are marks.
GRADED = (0, 1)


def main(arguments: list[str]) -> int:
    system, source, result, *rest = arguments
    if system == "try":
        return _try(Path(source))
    into, not_done = SYSTEMS[system]
    file = Path(result)
    _write(file, not_done("grading began and did not end."))
    try:
        document = grade(Path(rest[0]), Path(source), into, host_waits=system == "gradescope")
    except (ReportError, OSError) as error:
        print(f"autograder: not graded: {error}")
        _write(file, not_done("the grader could not do its work; what it printed says why."))
        return 1
    _write(file, document)
    return 0


def grade(
    submission: Path, source: Path, into: Callable[[SeenSubmission], Json], host_waits: bool
) -> Json:
    """The document of this submission. @throws ReportError if it was not graded."""
    options = json.loads((source / OPTIONS).read_text(encoding="utf-8"))
    with TemporaryDirectory(prefix="contact-autograder-") as scratch:
        folder = Path(scratch)
        handed_in = folder / "submissions"
        results = folder / "results"
        handed_in.mkdir()
        _take(submission, handed_in)
        command = [*_command(handed_in, results), *_settings(options, source)]
        # Its summary names the seed, and some systems show a student what is printed.
        nothing = subprocess.DEVNULL
        code = subprocess.run(command, check=False, stdin=nothing, stdout=nothing).returncode
        if code not in GRADED:
            raise ReportError(f"contact grade ended with code {code}")
        graded = read_results(results)
    if len(graded.submissions) != 1:
        raise ReportError(f"{len(graded.submissions)} submissions came out of one")
    due = options.get("due")
    policy = Policy(
        due=moment(due) if due else None,
        now=datetime.now(UTC),
        host_waits=host_waits,
    )
    return into(see(graded.submissions[0], graded, policy))


def _command(submissions: Path, results: Path) -> list[str]:
    program = book_root() / "build" / "dev" / "bin" / "contact"
    if not program.is_file():
        raise ReportError(f"{program} is not there: setup.sh did not build it")
    return [str(program), "grade", str(submissions), "-o", str(results), "--formats", "gradescope"]


def _settings(options: Json, source: Path) -> list[str]:
    words = []
    exercises = os.environ.get("CONTACT_EXERCISES") or options.get("exercises")
    for name, value in (("exercises", exercises), ("seed", options.get("seed"))):
        if value:
            words += [f"--{name}", str(value)]
    if (source / "private").is_dir():
        words += ["--private", str(source / "private")]
    if (source / PROFILE).is_file():
        words += ["--profile", str(source / PROFILE)]
    if options.get("accept_weak"):
        words.append("--accept-weak")
    return words


def _take(submission: Path, handed_in: Path) -> None:
    """Puts what was handed in where submissions are taken from: one archive as it is, or a folder.

    Links and special files go along as they are and are never followed or opened here; what to
    think of them is the intake's own.
    """
    entries = sorted(submission.iterdir()) if submission.is_dir() else []
    if len(entries) == 1 and entries[0].name.endswith((".zip", ".tar.gz", ".tgz")):
        if entries[0].is_symlink() or not entries[0].is_file():
            raise ReportError("what was handed in is no file")
        suffix = next(end for end in (".zip", ".tar.gz", ".tgz") if entries[0].name.endswith(end))
        shutil.copyfile(entries[0], handed_in / f"submission{suffix}")
        return
    room = [MAX_FILES, MAX_BYTES]
    (handed_in / "submission").mkdir()
    if submission.is_dir():
        _copy(submission, handed_in / "submission", room)


def _copy(folder: Path, into: Path, room: list[int], depth: int = 0) -> None:
    for entry in sorted(folder.iterdir()):
        found = entry.lstat()
        room[0] -= 1
        if room[0] < 0 or room[1] < 0 or depth > DEEPEST:
            return
        target = into / entry.name
        if stat.S_ISLNK(found.st_mode):
            target.symlink_to(entry.readlink())
        elif stat.S_ISDIR(found.st_mode):
            target.mkdir()
            _copy(entry, target, room, depth + 1)
        elif stat.S_ISREG(found.st_mode):
            room[1] -= found.st_size
            if room[1] >= 0:
                shutil.copyfile(entry, target)
        elif stat.S_ISFIFO(found.st_mode):
            os.mkfifo(target)


def _try(source: Path) -> int:
    """Grades the stubs of the book; returns 0 if that works."""
    with TemporaryDirectory(prefix="contact-autograder-") as scratch:
        stubs = Path(scratch) / "submission"
        for stub in sorted((book_root() / "exercises").glob("*/*/*.cpp")):
            copy = stubs / stub.parent.parent.name / stub.name
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(stub, copy)
        try:
            document = grade(stubs, source, gradescope, host_waits=True)
        except (ReportError, OSError) as error:
            print(f"autograder: {error}", file=sys.stderr)
            return 1
    print(f"autograder: grades here; {document['output']}", file=sys.stderr)
    return 0


def _write(file: Path, document: Json) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    beside = file.with_name(f".{file.name}.{os.getpid()}")
    beside.write_text(json.dumps(document, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
    beside.replace(file)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
