"""Mutants of the solutions: are the tests good enough, and do their hints speak the truth?

    mutants.py [--root ROOT] [--build BUILD] [--jobs N] [--json] [--limit SECONDS] [--keep]
               [--hints FILE] [--sample N --seed TEXT --write FILE] [EXERCISE...]

Each mutant is a small change of a solution (mutate.py). Of each exercise this counts those that the
tests catch, those that are known to be equivalent (solutions/NN/NAME/equivalent.toml), those that
survive, and how many of the caught ones are recognised as one mistake or as several. `--sample`
draws caught mutants whose hint is shown, and writes them with the hint, for a reader to judge
whether it is true; judged.json is such a sample with its verdicts. `--hints` writes all of them,
one JSON object a line. `--keep` stores the counts in kept/CHAPTER.json; a run whose counts are
others is a fault. `contact dev mutants` builds what is not current and calls this.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import sys
import tomllib
from collections.abc import Sequence
from pathlib import Path

from campaign import Result, Tried, try_exercise
from trial import Bundle, Json, TrialError, processor_seconds

ROOT = Path(__file__).resolve().parents[2]
WANTED_KILLED = 0.95
WANTED_HINTED = 0.60
MAX_EQUIVALENT = 0.10


def share(part: int, whole: int) -> str:
    return f"{100 * part / whole:.0f} %" if whole else "-"


def table(results: Sequence[Result]) -> str:
    said = ("mistake", "several", "noted", "none")
    head = ("exercise", "mutants", "killed", "equivalent", "also right", "left", *said)
    rows: list[tuple[str, ...]] = [head]
    sums = [0] * 9
    for one in results:
        numbers = [
            one.mutants,
            len(one.killed),
            len(one.equivalent),
            len(one.also_right),
            len(one.survivors),
            len(one.hinted),
            len(one.asked),
            len(one.noted),
            len(one.silent),
        ]
        sums = [a + b for a, b in zip(sums, numbers, strict=True)]
        rows.append((one.exercise, *_cells(numbers)))
    rows.append(("all", *_cells(sums)))
    widths = [max(len(row[i]) for row in rows) for i in range(len(head))]
    text = "\n".join(
        "  ".join(
            cell.ljust(width) if i == 0 else cell.rjust(width)
            for i, (cell, width) in enumerate(zip(row, widths, strict=True))
        )
        for row in rows
    )
    return text + (
        "\n\nkilled: of those that are mistakes. also right: an input that breaks the given code"
        " too.\nThe last four: of those that gave a wrong answer, for how many one mistake is"
        " named, several are\nasked about, something true is noted, or nothing is said."
    )


def _cells(numbers: Sequence[int]) -> tuple[str, ...]:
    whole, killed, equivalent, also_right, left, *said = numbers
    answered = sum(said)
    return (
        str(whole),
        f"{killed} ({share(killed, killed + left)})",
        str(equivalent),
        str(also_right),
        str(left),
        *(f"{one} ({share(one, answered)})" for one in said),
    )


def told(one: Tried) -> str:
    change = f"line {one.mutant.line}: {one.source_line}\n      - {one.mutant.was}\n"
    return f"    {change}      + {one.mutant.now}\n"


def survivors(results: Sequence[Result]) -> str:
    text = ""
    for result in results:
        if result.survivors:
            text += f"\n{result.exercise}: no test catches\n"
            text += "".join(told(one) for one in result.survivors)
        for problem in result.problems:
            text += f"\n{result.exercise}: {problem}\n"
    return text


def quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False)


def shown_hints(results: Sequence[Result]) -> list[tuple[str, Tried]]:
    """The caught mutants of which something is said, in a fixed order."""
    shown = [
        (result.exercise, one)
        for result in results
        for one in (*result.hinted, *result.asked, *result.noted)
    ]
    return sorted(shown, key=lambda pair: (pair[0], pair[1].mutant.number))


def shown_hint(exercise: str, one: Tried, hints: Json) -> dict[str, str]:
    """The mutant, what the tests asked and were answered, and what they say of it."""
    failure = one.trial.failure
    ids = one.trial.misconceptions
    return {
        "exercise": exercise,
        "line": f"{one.mutant.line}: {one.source_line}",
        "was": one.mutant.was,
        "now": one.mutant.now,
        "test": one.trial.test,
        "asked": failure.get("asked", ""),
        "inputs": "; ".join(f"{each['name']} = {each['text']}" for each in failure["inputs"]),
        "got": failure.get("got", ""),
        "right": failure.get("right", ""),
        "misconception": " or ".join(ids),
        "hint": " / ".join(hints[id_]["hint"] for id_ in ids) if ids else failure["observed"],
    }


VERDICTS = "true, question (a guess, put as one), misleading (true, but leads away) or false"


def sample(results: Sequence[Result], hints: Json, count: int, seed: str) -> str:
    """Mutants whose hint is shown, drawn by the seed, as JSON with verdicts to be filled in: what
    is kept of it is judged.json."""
    shown = shown_hints(results)
    drawn = random.Random(seed).sample(shown, min(count, len(shown)))
    head = {"seed": seed, "of": len(shown), "verdicts": VERDICTS}
    lines = [f" {quoted(key)}: {json.dumps(value)}" for key, value in head.items()]
    rows = []
    for exercise, one in sorted(drawn, key=lambda pair: (pair[0], pair[1].mutant.number)):
        row = {**shown_hint(exercise, one, hints), "verdict": "", "reason": ""}
        del row["asked"]
        rows.append("  " + json.dumps(row, ensure_ascii=False))
    return "{\n" + ",\n".join([*lines, ' "hints": [\n' + ",\n".join(rows) + "\n ]"]) + "\n}\n"


ENDED = ("mutants", "killed", "equivalent", "also_right", "left")
ANSWERED = "killed_by_an_answer"
SAID = ("one_hint", "several", "noted", "no_hint")


def counts_of(result: Result) -> dict[str, int]:
    said = result.as_json() | {"left": len(result.survivors), "no_hint": len(result.silent)}
    return {each: said[each] for each in (*ENDED, ANSWERED, *SAID)}


def kept_counts(file: Path) -> dict[str, dict[str, int]]:
    """The counts of a chapter's exercises, by name."""
    return json.loads(file.read_text()) if file.exists() else {}


def keep(results: Sequence[Result], folder: Path) -> None:
    """Stores the counts of these exercises; those of the others stay as they are."""
    folder.mkdir(exist_ok=True)
    for result in results:
        chapter, name = result.exercise.split("/")
        file = folder / f"{chapter}.json"
        kept = kept_counts(file) | {name: counts_of(result)}
        lines = [f" {quoted(key)}: {json.dumps(kept[key])}" for key in sorted(kept)]
        file.write_text("{\n" + ",\n".join(lines) + "\n}\n")


def out_of_date(result: Result, folder: Path) -> list[str]:
    """Where the kept counts are not those of this run. A mutant near the limit of time may end with
    or without an answer; what is said of the answers is compared if there are equally many."""
    chapter, name = result.exercise.split("/")
    again = f"run ./contact dev mutants --keep {result.exercise}"
    kept = kept_counts(folder / f"{chapter}.json").get(name)
    if kept is None:
        return [f"no counts are kept: {again}"]
    now = counts_of(result)
    compared = (*ENDED, *SAID) if kept[ANSWERED] == now[ANSWERED] else ENDED
    return [
        f"{each}: {now[each]}, and {kept[each]} are kept: {again}"
        for each in compared
        if now[each] != kept[each]
    ]


def exercises_named(root: Path, names: Sequence[str]) -> list[str]:
    there = sorted(
        f"{file.parts[-3]}/{file.parts[-2]}" for file in root.glob("exercises/*/*/exercise.toml")
    )
    if not names:
        return there
    chosen = [
        one
        for one in there
        if any(name in (one, *one.split("/"), one.split("/")[0][:2]) for name in names)
    ]
    if not chosen:
        raise TrialError(f"no exercise is called {', '.join(names)}")
    return chosen


def breaks_code(root: Path, exercise: str) -> bool:
    declared = tomllib.loads((root / "exercises" / exercise / "exercise.toml").read_text())
    return bool(declared["kind"] == "break")


def main(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(description="tries mutants of the solutions")
    parser.add_argument("--root", type=Path, default=ROOT)
    parser.add_argument("--build", type=Path, help="with exercises.json; build/dev")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--limit", type=float, help="seconds of processor time, then no more")
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--keep", action="store_true", help="store the counts")
    parser.add_argument("--hints", type=Path, help="where all hints go, one JSON object a line")
    parser.add_argument("--sample", type=int, help="so many hints to be judged")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--write", type=Path, help="where the sample goes; stdout")
    parser.add_argument("exercises", nargs="*")
    given = parser.parse_args(arguments)
    build = json.loads(((given.build or given.root / "build/dev") / "exercises.json").read_text())
    names = exercises_named(given.root, given.exercises)
    results: list[Result] = []
    left: list[str] = []
    for name in names:
        if given.limit is not None and processor_seconds() > given.limit:
            left.append(name)
            continue
        solution = given.root / "solutions" / name
        file = solution / f"{name.split('/')[1]}.cpp"
        print(f"{name} ...", file=sys.stderr, flush=True)
        try:
            bundle = Bundle.of(build, name)
            results.append(
                try_exercise(
                    bundle,
                    name,
                    file,
                    solution / "equivalent.toml",
                    given.jobs,
                    breaks_code=breaks_code(given.root, name),
                )
            )
        except TrialError as error:
            results.append(Result(name, problems=[str(error)]))
    hints = tomllib.loads((given.root / "chapters/misconceptions.toml").read_text())
    if given.hints:
        lines = [
            json.dumps(shown_hint(*one, hints), ensure_ascii=False) + "\n"
            for one in shown_hints(results)
        ]
        given.hints.write_text("".join(lines))
    tried = [one for one in results if one.mutants]
    kept = given.root / "grading/mutants/kept"
    if given.keep:
        keep(tried, kept)
    for result in tried:
        result.problems += out_of_date(result, kept)
    if given.sample is not None:
        text = sample(results, hints, given.sample, given.seed)
        if given.write:
            given.write.write_text(text)
        else:
            print(text, end="")
    if given.json:
        document = {
            "format": "contact-mutants/1",
            "exercises": [result.as_json() for result in results],
            "not_tried": left,
        }
        print(json.dumps(document, ensure_ascii=False, indent=1))
    elif given.sample is None or given.write:
        print(table(results))
        print(survivors(results), end="")
        if left:
            print(f"\nThe time was up before: {', '.join(left)}")
    bad = any(result.problems or (result.settled and result.survivors) for result in results)
    return 1 if bad else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except TrialError as error:
        sys.exit(str(error))
