"""Tries all mutants of an exercise's solution, and counts what its tests say of them."""

from __future__ import annotations

import tempfile
import tomllib
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from mutate import Mutant, mutants_of, switched
from trial import Bundle, Json, Trial, TrialError, run

# A mutant may take so many times the solution's processor time, and at least so many seconds.
TIMES_THE_SOLUTION = 20
MIN_SECONDS = 1.0
MAX_ROUNDS = 12
# `if (pick(...))` and the like are what was mutated; the book's own compilation of the solution
# finds what deserves a warning. A chosen constant in braces is no constant expression any more.
FLAGS = ("-w", "-Wno-narrowing", "-Wno-error", "-fmax-errors=0")


@dataclass(frozen=True)
class Tried:
    """A mutant, and how the tests ended on it."""

    mutant: Mutant
    source_line: str
    trial: Trial

    def as_json(self) -> Json:
        return {
            "number": self.mutant.number,
            "line": self.mutant.line,
            "what": self.mutant.what,
            "was": self.mutant.was,
            "now": self.mutant.now,
            "status": self.trial.status,
            "test": self.trial.test,
            "failure": self.trial.failure,
        }


@dataclass
class Result:
    """All mutants of one exercise."""

    exercise: str
    not_compiled: list[Mutant] = field(default_factory=list)
    killed: list[Tried] = field(default_factory=list)
    equivalent: list[Tried] = field(default_factory=list)
    # Where the answer is an input that breaks code: other inputs that break it too.
    also_right: list[Tried] = field(default_factory=list)
    survivors: list[Tried] = field(default_factory=list)
    problems: list[str] = field(default_factory=list)
    # There is an equivalent.toml, so somebody has looked at every survivor: a new one is a fault.
    settled: bool = False

    @property
    def mutants(self) -> int:
        tried = (self.killed, self.equivalent, self.also_right, self.survivors)
        return sum(len(one) for one in tried)

    @property
    def answered(self) -> list[Tried]:
        """Those killed by a wrong answer: only an answer can be recognised."""
        return [one for one in self.killed if one.trial.status == "failed"]

    @property
    def hinted(self) -> list[Tried]:
        return [one for one in self.answered if len(one.trial.misconceptions) == 1]

    @property
    def asked(self) -> list[Tried]:
        return [one for one in self.answered if len(one.trial.misconceptions) > 1]

    @property
    def noted(self) -> list[Tried]:
        """Those of which something true is said, but no mistake is named."""
        return [
            one
            for one in self.answered
            if not one.trial.misconceptions and one.trial.failure.get("observed")
        ]

    @property
    def silent(self) -> list[Tried]:
        told = (*self.hinted, *self.asked, *self.noted)
        return [one for one in self.answered if one not in told]

    def as_json(self) -> Json:
        return {
            "exercise": self.exercise,
            "settled": self.settled,
            "mutants": self.mutants,
            "not_compiled": len(self.not_compiled),
            "killed": len(self.killed),
            "killed_by_an_answer": len(self.answered),
            "equivalent": len(self.equivalent),
            "also_right": len(self.also_right),
            "survivors": [one.as_json() for one in self.survivors],
            "one_hint": len(self.hinted),
            "several": len(self.asked),
            "noted": len(self.noted),
            "no_hint": [one.as_json() for one in self.silent],
            "problems": self.problems,
        }


@dataclass
class Equivalents:
    """solutions/NN/NAME/equivalent.toml: mutants that are no mistakes, each with a reason."""

    file: Path
    entries: list[dict[str, str]]

    @staticmethod
    def read(file: Path) -> Equivalents:
        if not file.exists():
            return Equivalents(file, [])
        entries = tomllib.loads(file.read_text()).get("mutant", [])
        for entry in entries:
            if set(entry) != {"line", "was", "now", "why"} or not entry["why"].strip():
                raise TrialError(f"{file}: each [[mutant]] has line, was, now and why")
        return Equivalents(file, entries)

    def knows(self, mutant: Mutant, line: str) -> bool:
        return any(self._is(entry, mutant, line) for entry in self.entries)

    @staticmethod
    def _is(entry: dict[str, str], mutant: Mutant, line: str) -> bool:
        return (entry["line"], entry["was"], entry["now"]) == (line, mutant.was, mutant.now)

    def problems(self, tried: Sequence[Tried]) -> list[str]:
        """Entries that stand for nothing, or for a mutant that a test catches."""
        found = []
        for entry in self.entries:
            of = [one for one in tried if self._is(entry, one.mutant, one.source_line)]
            name = f"{self.file.name}: {entry['was']} -> {entry['now']}"
            if not of:
                found.append(f"{name}: there is no such mutant")
            elif all(one.trial.status != "passed" for one in of):
                found.append(f"{name}: it is not equivalent, since '{of[0].trial.test}' catches it")
        return found


def compiled(bundle: Bundle, source: str, folder: Path) -> tuple[Path, list[Mutant], list[Mutant]]:
    """A program with all mutants that compile; these, and the others."""
    mutants = mutants_of(source)
    refused: list[Mutant] = []
    file, thing, program = folder / "mutants.cpp", folder / "mutants.o", folder / "mutants"
    for _ in range(MAX_ROUNDS):
        text, lines = switched(source, mutants)
        file.write_text(text)
        said = bundle.compile(file, folder / "none", *FLAGS, "-fsyntax-only")
        if not said:
            said = bundle.compile(file, thing, *FLAGS)
            if not said:
                bundle.link(thing, program)
                return program, mutants, refused
        bad = _named(said, file.name, lines, text)
        if not bad:
            raise TrialError("the file of mutants does not compile:\n" + said[:3000])
        refused += [one for one in mutants if one.number in bad]
        mutants = [one for one in mutants if one.number not in bad]
    raise TrialError("too many mutants do not compile")


def _named(said: str, name: str, lines: dict[int, set[int]], text: str) -> set[int]:
    """The mutants on whose lines the compiler found errors, or those around them."""
    exact: set[int] = set()
    near: set[int] = set()
    count = text.count("\n") + 1
    for line in said.splitlines():
        _, found, rest = line.partition(f"{name}:")
        if not found or not rest.partition(":")[0].isdecimal():
            continue
        number = int(rest.partition(":")[0])
        if number in lines:
            exact |= lines[number]
        elif "error" in rest or "required from here" in rest:
            # The original's line is the one after a mutant's, or before it.
            for around in (number - 1, number + 1):
                if 0 < around <= count:
                    near |= lines.get(around, set())
    return exact or near


def try_exercise(
    bundle: Bundle,
    exercise: str,
    solution: Path,
    equivalents: Path,
    jobs: int,
    *,
    breaks_code: bool = False,
) -> Result:
    """`breaks_code`: the answer is an input, which the tests judge by their own oracle. What they
    accept is another right answer."""
    source = solution.read_text()
    lines = source.split("\n")
    result = Result(exercise, settled=equivalents.exists())
    known = Equivalents.read(equivalents)
    with tempfile.TemporaryDirectory() as folder:
        program, mutants, result.not_compiled = compiled(bundle, source, Path(folder))
        solved = run(program, {"CONTACT_MUTANT": "0"}, 60.0)
        if solved.status != "passed":
            raise TrialError(f"{exercise}: the solution itself fails '{solved.test}'")
        limit = max(MIN_SECONDS, TIMES_THE_SOLUTION * solved.seconds)

        def tried(mutant: Mutant) -> Tried:
            trial = run(program, {"CONTACT_MUTANT": str(mutant.number)}, limit)
            return Tried(mutant, lines[mutant.line - 1].strip(), trial)

        with ThreadPoolExecutor(jobs) as pool:
            everything = list(pool.map(tried, mutants))
    for one in everything:
        if one.trial.status != "passed":
            result.killed.append(one)
        elif breaks_code:
            result.also_right.append(one)
        elif known.knows(one.mutant, one.source_line):
            result.equivalent.append(one)
        else:
            result.survivors.append(one)
    result.problems = known.problems(everything)
    return result
