"""A made-up class: real verdicts of solutions, stubs, wrong answers and broken files, dealt out to
people who do not exist, as `contact grade` writes them down.

`outputs_class.py FOLDER` writes such a RESULTS folder, to look at what is made of it.
"""

from __future__ import annotations

import copy
import functools
import json
import os
import random
import subprocess
import sys
import tomllib
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "grading" / "book"))

from wrong_answers import wrong_answers  # noqa: E402

PROGRAM = ROOT / "build" / "dev" / "bin" / "contact"
FEW = ("01_planes/signed_distance", "02_triangles/point_in_triangle", "02_triangles/ray_triangle")

Json = dict[str, Any]

# What spoils a file that compiles, each in its own way.
SPOILERS: tuple[tuple[str, Callable[[str], str]], ...] = (
    ("semicolon", lambda text: text.replace(";\n", "\n", 1)),
    ("unknown", lambda text: text.replace("return ", "return nmae_of_nobody + ", 1)),
    ("brace", lambda text: text.rstrip().rstrip("}") + "\n"),
    ("include", lambda text: "#include <no_such_thing.hpp>\n" + text),
)


def exercises(ids: tuple[str, ...] = FEW) -> list[Json]:
    """These exercises as results.json lists them, every test shown."""
    listed = []
    for id_ in ids:
        table = tomllib.loads((ROOT / "exercises" / id_ / "exercise.toml").read_text())
        tests = [
            {
                "name": test["name"],
                "points": float(test.get("points", 1)),
                "visibility": "shown",
                "private": False,
            }
            for test in table["tests"]
        ]
        listed.append(
            {
                "id": id_,
                "title": table["title"],
                "max_points": sum(test["points"] for test in tests),
                "objective": table.get("objective", ""),
                "tests": tests,
            }
        )
    return listed


@functools.cache
def verdicts(ids: tuple[str, ...] = FEW, max_wrong: int = 3) -> dict[str, dict[str, Json]]:
    """By exercise and kind of answer, what `contact check --json` says."""
    with TemporaryDirectory() as folder:
        files: dict[str, tuple[str, str]] = {}
        for id_ in ids:
            name = id_.split("/")[1]
            solution = (ROOT / "solutions" / id_ / f"{name}.cpp").read_text()
            texts = {
                "solution": solution,
                "stub": (ROOT / "exercises" / id_ / f"{name}.cpp").read_text(),
            }
            wrong = wrong_answers(id_)
            texts |= {f"wrong {file.stem}": file.read_text() for file in wrong[:max_wrong]}
            texts |= {f"broken {kind}": spoil(solution) for kind, spoil in SPOILERS}
            for kind, text in texts.items():
                file = Path(folder) / kind.replace(" ", "-") / id_.split("/")[0] / f"{name}.cpp"
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text)
                files[str(file)] = (id_, kind)
        done = subprocess.run(
            [str(PROGRAM), "check", "--json", *files],
            capture_output=True,
            text=True,
            env={**os.environ, "CONTACT_ROOT": str(ROOT), "CONTACT_WORK": f"{folder}/work"},
            check=False,
        )
        found: dict[str, dict[str, Json]] = {id_: {} for id_ in ids}
        for verdict in json.loads(done.stdout)["results"]:
            id_, kind = files[verdict["file"]]
            found[id_][kind] = verdict
        return found


def unit(id_: str, verdict: Json) -> Json:
    """One exercise of a submission, graded so."""
    return {
        "id": id_,
        "status": "graded",
        "gradable": verdict["verdict"] != "does_not_compile",
        "points": verdict["points"],
        "max_points": verdict["max_points"],
        "verdict": verdict,
    }


def absent(listed: Json, status: str, problem: str = "") -> Json:
    """One exercise of a submission that was not graded."""
    entry = {
        "id": listed["id"],
        "status": status,
        "gradable": False,
        "points": 0.0,
        "max_points": listed["max_points"],
    }
    return entry | ({"problem": problem} if problem else {})


def not_graded(listed: Json, why: str) -> Json:
    """One exercise of a submission that could not be graded, through no fault of the student's."""
    return absent(listed, "not_graded", why) | {"points": None}


def submission(id_: str, units: list[Json], **more: object) -> Json:
    """One submission; points are those of its exercises, if all of them have some."""
    points = [one["points"] for one in units]
    return {
        "id": id_,
        "entry": f"{id_}.zip",
        "ignored": [],
        "points": None if None in points else sum(points),
        "max_points": sum(one["max_points"] for one in units),
        "exercises": units,
        **more,
    }


def document(listed: list[Json], submissions: list[Json], level: str = "full") -> Json:
    """A whole results.json."""
    measures = [
        {"what": "no network", "enforced": True, "how": "a namespace without one"},
        {
            "what": "a limit on memory for all processes together",
            "enforced": level == "full",
            "how": "control groups v2",
        },
    ]
    return {
        "format": "contact-grade/2",
        "version": "0.4.0",
        "seed": "autumn-lilac-4711",
        "limits": {},
        "machine": {"level": level, "measures": measures},
        "exercises": listed,
        "submissions": submissions,
    }


FIRST = "Aino Bela Chidi Dagny Efua Farid Grainne Hana Ines Jarek Kaito Leila"
LAST = "Moana Nkemelu Oyelaran Przybylski Quisquater Rautavaara Szymborska Thorvaldsen"


def made_up_class(
    listed: list[Json], answers: dict[str, dict[str, Json]], students: int = 60, seed: int = 7
) -> Json:
    """A class as teachers meet it: some solve all, many believe something wrong, a few are lost."""
    chance = random.Random(seed)
    first, last = FIRST.split(), LAST.split()
    submissions = []
    for number in range(students):
        skill = chance.betavariate(2.2, 1.5)
        units = []
        for entry in listed:
            kinds = answers[entry["id"]]
            wrong = sorted(kind for kind in kinds if kind.startswith("wrong"))
            broken = sorted(kind for kind in kinds if kind.startswith("broken"))
            throw = chance.random()
            if throw < 0.08 * (1.4 - skill):
                units.append(absent(entry, "missing"))
            elif throw < 0.14 * (1.4 - skill):
                units.append(absent(entry, "untouched"))
            elif throw < 0.3 * (1.3 - skill):
                weights = [3.0 + place for place in range(len(broken), 0, -1)]
                units.append(unit(entry["id"], kinds[chance.choices(broken, weights)[0]]))
            elif chance.random() < skill:
                units.append(unit(entry["id"], kinds["solution"]))
            else:
                weights = [1.0 / place for place in range(1, len(wrong) + 1)]
                units.append(unit(entry["id"], kinds[chance.choices(wrong, weights)[0]]))
        name = f"{first[number % len(first)]} {last[(number * 5) % len(last)]}"
        submissions.append(submission(f"zq{number:03d}kx", copy.deepcopy(units), name=name))
    return document(listed, submissions)


def main() -> int:
    folder = Path(sys.argv[1])
    ids = tuple(
        sorted(
            str(file.parent.relative_to(ROOT / "exercises"))
            for file in (ROOT / "exercises").glob("*/*/exercise.toml")
        )
    )
    listed = exercises(ids)
    folder.mkdir(parents=True, exist_ok=True)
    whole = made_up_class(listed, verdicts(ids, max_wrong=20))
    (folder / "results.json").write_text(json.dumps(whole, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
