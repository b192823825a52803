"""What the stages of a simulation cost, in instructions: as a scene's plan composes them, and with
effects forced on that the plan leaves out.

    cmake --build --preset release --target scene_stages
    build/venv/bin/python benchmarks/scene_stages.py

Instructions are those of the run alone, counted by valgrind: the same in every run. A stage that is
off is never called. What is left beside the stages is the bookkeeping of a step.
"""

from __future__ import annotations

import argparse
import json
import re
import shutil
import subprocess
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build" / "release" / "bin" / "scene_stages"
SCENES = ROOT / "chapters" / "20_scenes" / "scenes"

# The functions of chapters/20_scenes/contact/stage_*.hpp by the names that a run gives its stages.
FUNCTIONS = {
    "broad phase": "sort_into_cells",
    "pairs": "compare_all_pairs",
    "contacts": "find_touching_pairs",
    "waking": "wake_bodies",
    "impacts": "solve_impacts",
    "springs": "push_springs",
    "gravity": "add_gravity",
    "contact forces": "solve_forces",
    "impacts left over": "solve_forces",
    "time of impact": "find_first_impact",
    "motion": "move_bodies",
    "rotation": "turn_bodies",
    "bounces": "solve_bounces",
    "leaving": "leave_bounced",
    "pushing out": "push_out",
    "sleep": "put_to_sleep",
}
GYROSCOPIC = "turn_with_gyroscopic_term"


class Case(NamedTuple):
    """A scene, for how long, and what its plan leaves out."""

    scene: str
    seconds: float
    more: tuple[str, ...]


CASES = (
    Case("thrown_stone", 1, ("-event-driven", "+gyroscopic-term")),
    Case("sliding_block", 1, ("+gyroscopic-term",)),
    Case("stack_of_ten", 0.5, ("-sleeping", "+rotation", "+friction", "+continuous-detection")),
    Case("truck_and_car", 1, ("+restitution", "+resting", "+sleeping", "+penalty-contact")),
    Case("bullet_and_wall", 0.1, ("+gravity", "+several-contacts", "+broad-phase")),
    Case("penalty_trampoline", 0.5, ("+restitution", "+friction", "+rotation")),
    Case("billiards_break", 1, ("everything",)),
    Case("gas_in_a_box", 0.1, ("everything",)),
)


class Counted(NamedTuple):
    run: dict[str, Any]
    instructions: int
    of_function: Counter[str]  # with what it calls


def counted(case: Case, more: tuple[str, ...]) -> Counted:
    """One run."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder, "callgrind")
        done = subprocess.run(
            [
                "valgrind",
                "--tool=callgrind",
                f"--callgrind-out-file={out}",
                "--collect-atstart=no",
                "--toggle-collect=run_scene",
                PROGRAM,
                SCENES / f"{case.scene}.json",
                str(case.seconds),
                *more,
            ],
            capture_output=True,
            text=True,
        )
        if done.returncode != 0:
            raise SystemExit(done.stderr)
        total = re.search(r"Collected : (\d+)", done.stderr)
        if not total:
            raise SystemExit(f"valgrind counted nothing:\n{done.stderr}")
        return Counted(json.loads(done.stdout), int(total.group(1)), calls(out.read_text()))


def calls(text: str) -> Counter[str]:
    """Instructions of each stage's function, by its calls in a profile of callgrind."""
    names: dict[str, str] = {}
    costs: Counter[str] = Counter()
    called = ""
    lines = iter(text.splitlines())
    for line in lines:
        if named := re.match(r"c?fn=\((\d+)\)(?: (.*))?$", line):
            number, name = named.groups()
            if name:
                names[number] = name
            if line.startswith("cfn="):
                called = names[number]
        elif line.startswith("calls="):
            function = re.match(r"contact::(\w+)\(", called)
            if function:
                costs[function.group(1)] += int(next(lines).split()[1])
    return costs


def function_of(stage: str, gyroscopic: bool) -> str:
    return GYROSCOPIC if stage == "rotation" and gyroscopic else FUNCTIONS[stage]


def show(case: Case) -> None:
    planned = counted(case, ())
    more = counted(case, case.more)
    columns = [planned, more]
    units = ["hits" if one.run["event_driven"] else "steps" for one in columns]
    print(f"\n{case.scene} for {case.seconds:g} s")
    print(f"{'instructions':24}{'as planned':>16}  {' '.join(case.more)}")
    print(f"{'events or steps':24}{planned.run[units[0]]:>16}{more.run[units[1]]:>16}")
    print(
        f"{'bytes of a body':24}{planned.run['bytes_per_body']:>16}{more.run['bytes_per_body']:>16}"
    )
    rest = [one.instructions for one in columns]
    if not any(one.run["event_driven"] for one in columns):
        stages = list(dict.fromkeys([*planned.run["stages"], *more.run["stages"]]))
        for stage in stages:
            cells = []
            for i, one in enumerate(columns):
                on = stage in one.run["stages"]
                turns = one.of_function[GYROSCOPIC] > 0
                function = function_of(stage, turns)
                if not on and function in (function_of(s, turns) for s in one.run["stages"]):
                    cells.append("-")  # it is on by its other name
                    continue
                cost = one.of_function[function]
                if not on and cost:
                    raise SystemExit(f"{case.scene}: {stage} is off and took {cost} instructions")
                rest[i] -= cost
                cells.append(f"{cost:,}" if on else "-")
            print(f"  {stage:22}{cells[0]:>16}{cells[1]:>16}")
        print(f"  {'the rest of a step':22}{rest[0]:>16,}{rest[1]:>16,}")
    print(f"{'all':24}{planned.instructions:>16,}{more.instructions:>16,}", end="")
    print(f"  {more.instructions / planned.instructions:.2f} times")


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n\n", 1)[0])
    parser.add_argument("scenes", nargs="*", help="only these")
    wanted = parser.parse_args().scenes
    if not PROGRAM.exists():
        raise SystemExit(
            f"{PROGRAM} is missing: cmake --build --preset release --target scene_stages"
        )
    if shutil.which("valgrind") is None:
        raise SystemExit("valgrind is missing: it counts the instructions")
    for case in CASES:
        if not wanted or case.scene in wanted:
            show(case)


if __name__ == "__main__":
    main()
