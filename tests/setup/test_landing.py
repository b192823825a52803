"""What the style stage finds in git: the turn, and what commits are called."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from landing import check_subjects, check_turn, previous_landing, subject_problem  # noqa: E402


def git(folder: Path, *words: str) -> str:
    identity = ("-c", "user.name=A", "-c", "user.email=a@b.c", "-c", "commit.gpgsign=false")
    command = ["git", "-C", str(folder), *identity, *words]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


class Project:
    """A repository with a turn, in which landings are made."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        folder.mkdir()
        git(folder, "init", "-q", "-b", "main")
        self.commit("build: begin", turn=5)

    def write(self, turn: int | str) -> None:
        (self.folder / "tools").mkdir(exist_ok=True)
        (self.folder / "tools/turn").write_text(f"{turn}\n")

    def commit(self, subject: str, turn: int | None = None) -> str:
        if turn is not None:
            self.write(turn)
            git(self.folder, "add", "tools/turn")
        git(self.folder, "commit", "-q", "--allow-empty", "-m", subject)
        return git(self.folder, "rev-parse", "HEAD")

    def is_published(self) -> None:
        git(self.folder, "update-ref", "refs/remotes/origin/main", "HEAD")


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Project:
    monkeypatch.delenv("CONTACT_SINCE", raising=False)
    return Project(tmp_path / "project")


# --- The turn -------------------------------------------------------------------------------------


def test_a_landing_raises_the_turn_by_one(project: Project) -> None:
    project.is_published()
    assert check_turn(project.folder).problems == []
    project.commit("docs: name the source")
    (problem,) = check_turn(project.folder).problems
    assert "holds 5, and that of origin/main holds 5" in problem
    assert "Write 6 into it" in problem
    project.write(6)
    assert check_turn(project.folder).problems == []
    project.commit("docs: name another", turn=6)
    assert check_turn(project.folder).problems == []
    project.write(7)
    assert "holds 7, and that of origin/main holds 5" in check_turn(project.folder).problems[0]


def test_two_branches_that_raised_it_alike_are_two_landings(project: Project) -> None:
    project.is_published()
    git(project.folder, "switch", "-q", "-c", "other")
    project.commit("page: draw an arrow", turn=6)
    git(project.folder, "switch", "-q", "main")
    project.commit("docs: name the source", turn=6)
    project.is_published()
    git(project.folder, "merge", "-q", "--no-ff", "-m", "Merge branch 'other'", "other")
    assert "Write 7 into it" in check_turn(project.folder).problems[0]


def test_without_a_published_branch_the_history_of_the_file_counts(project: Project) -> None:
    assert check_turn(project.folder).problems == []
    project.commit("docs: name the source", turn=6)
    assert check_turn(project.folder).problems == []
    project.commit("docs: name another", turn=8)
    assert "from 6 to 8" in check_turn(project.folder).problems[0]
    project.commit("docs: name a third", turn=9)
    assert check_turn(project.folder).problems == []
    project.write(11)
    assert "Write 10 into it" in check_turn(project.folder).problems[0]


def test_what_was_pushed_is_a_landing(project: Project, monkeypatch: pytest.MonkeyPatch) -> None:
    before = git(project.folder, "rev-parse", "HEAD")
    project.commit("docs: name the source")
    project.is_published()
    monkeypatch.setenv("CONTACT_SINCE", before)
    assert f"that of {before} holds 5" in check_turn(project.folder).problems[0]
    # A new branch was nowhere before.
    monkeypatch.setenv("CONTACT_SINCE", "0" * 40)
    assert check_turn(project.folder).problems == []


def test_of_a_merge_the_landing_counts(project: Project) -> None:
    git(project.folder, "switch", "-q", "-c", "other")
    for number in (6, 7):
        project.commit("page: draw an arrow", turn=number)
    git(project.folder, "switch", "-q", "main")
    git(project.folder, "merge", "-q", "--no-ff", "-m", "Merge branch 'other'", "other")
    assert "from 5 to 7" in check_turn(project.folder).problems[0]


@pytest.mark.parametrize("text", ["", "six", "6 7", "-1"])
def test_what_is_no_number_is_told(project: Project, text: str) -> None:
    project.write(text)
    assert "must hold one whole number" in check_turn(project.folder).problems[0]


def test_where_the_history_is_missing_it_says_so(project: Project, tmp_path: Path) -> None:
    project.commit("docs: name the source", turn=6)
    shallow = tmp_path / "shallow"
    git(tmp_path, "clone", "-q", "--depth", "1", f"file://{project.folder}", str(shallow))
    git(shallow, "update-ref", "-d", "refs/remotes/origin/main")
    found = check_turn(shallow)
    assert (found.looked, found.problems) == (0, [])
    assert "shallow" in found.says
    packed = tmp_path / "packed"
    (packed / "tools").mkdir(parents=True)
    (packed / "tools/turn").write_text("6\n")
    found = check_turn(packed)
    assert (found.looked, found.problems) == (0, [])
    assert "no git history" in found.says


def test_the_landing_before_is_known(project: Project) -> None:
    assert previous_landing(project.folder) is None
    first = git(project.folder, "rev-parse", "HEAD")
    project.commit("docs: name the source", turn=6)
    project.commit("docs: name another")
    assert previous_landing(project.folder) == first


# --- Subjects -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "subject",
    [
        "docs: name the source",
        "20 scenes: move sliding contacts by the mean velocity",
        "grade: embed the table in the report",
        "ci: fetch CMake's own archive",
        "tests: pass seeds on",
        "cmake, tests: focus on one chapter",
        "a: " + "b" * 69,
    ],
)
def test_a_good_subject_passes(subject: str) -> None:
    assert subject_problem(subject) is None


@pytest.mark.parametrize(
    ("subject", "told"),
    [
        ("a: " + "b" * 70, "73 characters"),
        ("Who slides moves with the mean", "area: imperative"),
        ("docs name the source", "area: imperative"),
        ("Docs: name the source", "area: imperative"),
        ("docs: Name the source", "area: imperative"),
        ("docs:name the source", "area: imperative"),
        ("docs: ", "area: imperative"),
        ("docs: names the source", "`names` is no imperative"),
        ("docs: named the source", "`named` is no imperative"),
        ("docs: naming the source", "`naming` is no imperative"),
    ],
)
def test_a_bad_subject_is_told(subject: str, told: str) -> None:
    assert told in (subject_problem(subject) or "nothing")


def test_commits_after_the_rule_are_looked_at_and_merges_are_not(project: Project) -> None:
    begin = project.commit("What was called anyhow before the rule")
    git(project.folder, "switch", "-q", "-c", "other")
    project.commit("page: draw an arrow")
    git(project.folder, "switch", "-q", "main")
    project.commit("docs: name the source")
    git(project.folder, "merge", "-q", "--no-ff", "-m", "Merge branch 'other'", "other")
    found = check_subjects(project.folder, begin)
    assert (found.looked, found.problems) == (2, [])
    bad = project.commit("Another arrow")
    (problem,) = check_subjects(project.folder, begin).problems
    assert bad[:7] in problem
    assert "'Another arrow'" in problem


def test_without_the_history_no_subject_is_looked_at(project: Project, tmp_path: Path) -> None:
    found = check_subjects(project.folder, "0123456789")
    assert (found.looked, found.problems) == (0, [])
    assert "no subject was checked" in found.says
    assert "no subject was checked" in check_subjects(tmp_path).says
