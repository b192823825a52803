"""Checks a landing by its git history: that it raised tools/turn by one, and the subjects of its
commits. Without a history it says so and reports no fault."""

from __future__ import annotations

import os
import re
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

from sample import read_turn

# Commits after this one are called `area: imperative`.
SUBJECTS_FROM = "38ffa00"
LONGEST_SUBJECT = 72
# The branch on which changes land.
MAIN = "origin/main"
TURN = "tools/turn"

# Imperatives that end like another form of a verb.
IMPERATIVES = re.compile(
    "alias|bias|bleed|breed|bring|canvas|embed|exceed|feed|fling|heed|need|ping|proceed|ring|seed|"
    "shed|shred|sing|speed|spring|sting|string|succeed|swing|weed|wring"
)


@dataclass
class Found:
    """What was looked at, in words, and what is wrong with it. `looked` 0: there was nothing."""

    says: str
    looked: int = 0
    problems: list[str] = field(default_factory=list)


def git(root: Path, *words: str) -> str | None:
    """What git prints, or None if it fails."""
    command = ["git", "-C", str(root), *words]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError:
        return None
    return done.stdout if done.returncode == 0 else None


def commit(root: Path, name: str) -> str | None:
    """The hash of a commit that is here, or None."""
    found = git(root, "rev-parse", "--verify", "--quiet", f"{name}^{{commit}}")
    return found.strip() if found else None


def is_ancestor(root: Path, earlier: str, later: str) -> bool:
    return git(root, "merge-base", "--is-ancestor", earlier, later) is not None


def is_shallow(root: Path) -> bool:
    return (git(root, "rev-parse", "--is-shallow-repository") or "").strip() == "true"


# --- The turn -------------------------------------------------------------------------------------


def turn_at(root: Path, revision: str) -> int | None:
    text = git(root, "show", f"{revision}:{TURN}")
    return None if text is None else read_turn(text, f"{TURN} of {revision}")


def begins_at(root: Path) -> str | None:
    """Where this landing begins, if that is said: by $CONTACT_SINCE, or by origin/main."""
    head = commit(root, "HEAD")
    for name in (os.environ.get("CONTACT_SINCE", ""), MAIN):
        base = commit(root, name) if name and head else None
        if base and head and base != head and is_ancestor(root, base, head):
            return name
    return None


def previous_landing(root: Path) -> str | None:
    """The commit that raised the turn before the landing that HEAD is at, if it is known.

    Of the landing that began to count, the commit before.
    """
    listed = git(root, "log", "--first-parent", "--format=%H", "-2", "--", TURN) or ""
    raised = listed.split()
    if len(raised) == 2:
        return raised[1]
    return commit(root, f"{raised[0]}^") if raised else None


def check_turn(root: Path) -> Found:
    """The number is one more than at the landing before, as far as git knows of one."""
    try:
        return _check_turn(root)
    except (OSError, ValueError) as error:
        return Found(str(error), 1, [str(error)])


def _check_turn(root: Path) -> Found:
    now = read_turn((root / TURN).read_text(), TURN)
    if commit(root, "HEAD") is None:
        return Found(f"{TURN} was not checked: there is no git history here")
    if begin := begins_at(root):
        before = turn_at(root, begin)
        if before is None:
            return Found(f"{begin} has no {TURN} yet", 1)
        problem = (
            f"{TURN} holds {now}, and that of {begin} holds {before}: a landing raises it by"
            f" exactly one. Write {before + 1} into it."
        )
        return Found(f"against {begin}", 1, [problem] if now != before + 1 else [])
    committed = turn_at(root, "HEAD")
    if committed is not None and now not in (committed, committed + 1):
        problem = (
            f"{TURN} holds {now}, and the last commit's holds {committed}: a landing raises it by"
            f" exactly one. Write {committed + 1} into it."
        )
        return Found("against the last commit", 1, [problem])
    changed = (git(root, "log", "--first-parent", "--format=%H", "-1", "--", TURN) or "").strip()
    if not changed:
        return Found(f"{TURN} is not in a commit yet", 1)
    before, after = turn_at(root, f"{changed}^"), turn_at(root, changed)
    if before is None and is_shallow(root) and commit(root, f"{changed}^") is None:
        return Found(f"{TURN} was not checked: the clone is shallow, and the change is not in it")
    problem = (
        f"commit {changed[:9]} changed {TURN} from {before} to {after}: a landing raises it by"
        " exactly one. Raise it by one in the next landing."
    )
    wrong = before is not None and after != before + 1
    return Found("in the history of the file", 1, [problem] if wrong else [])


# --- Subjects of commits --------------------------------------------------------------------------


def subject_problem(subject: str) -> str | None:
    """What is wrong with a commit's first line, or None."""
    if len(subject) > LONGEST_SUBJECT:
        return f"it has {len(subject)} characters, and {LONGEST_SUBJECT} are the most"
    parts = re.fullmatch(r"([a-z0-9][a-z0-9 _.,/+-]*): ([a-z][a-z-]*)\b.*", subject)
    if not parts:
        return "it is not `area: imperative`, both in lower case (`docs: name the source`)"
    verb = parts[2]
    if not IMPERATIVES.fullmatch(verb) and re.search(r"(ing|ed|[^su]s)$", verb):
        return f"`{verb}` is no imperative: say what the commit is to do (`add`, not `adds`)"
    return None


def check_subjects(root: Path, since: str = SUBJECTS_FROM) -> Found:
    """The first lines of the commits after `since`, without merges."""
    if commit(root, since) is None:
        return Found(f"no subject was checked: the history back to commit {since} is not here")
    listed = git(root, "log", "--no-merges", "--format=%h %s", f"{since}..HEAD") or ""
    lines = listed.splitlines()
    problems = []
    for line in lines:
        name, _, subject = line.partition(" ")
        if problem := subject_problem(subject):
            problems.append(f"commit {name}, {subject!r}: {problem}")
    return Found(f"subjects of {len(lines)} commits", len(lines), problems)
