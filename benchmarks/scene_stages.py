"""Counts the instructions of the stages of a simulation, as a scene's plan composes them and with
effects forced on that the plan leaves out. Then compares the plan's estimate for each effect with
the difference of two counts, and fails if an estimate is off by more than a factor of 4.

    cmake --build --preset release --target scene_stages
    build/venv/bin/python benchmarks/scene_stages.py

Instructions are those of the run only, counted by valgrind: the same in every run. A stage that is
off is never called. The instructions outside the stages are the overhead of a step.

An effect below 1/500 of a run, both by its estimate and by its count, is not compared.
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

FACTOR = 4.0  # that an estimate may be off
SMALL = 0.002  # of a run: too little to compare

# The functions of chapters/20_scenes/contact/stepped/stage_*.hpp by the names that a run gives its
# stages.
FUNCTIONS = {
    "broad phase": "sort_into_cells",
    "pairs": "compare_all_pairs",
    "contacts": "find_touching_pairs",
    "waking": "wake_bodies",
    "impacts": "solve_impacts",
    "springs": "apply_spring_forces",
    "gravity": "add_gravity",
    "contact forces": "solve_forces",
    "impacts left over": "solve_forces",
    "time of impact": "find_first_impact",
    "motion": "move_bodies",
    "rotation": "rotate_bodies",
    "bounces": "solve_bounces",
    "leaving": "apply_bounces",
    "pushing out": "correct_positions",
    "sleep": "put_to_sleep",
}
GYROSCOPIC = "rotate_with_gyroscopic_term"


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


class Estimate(NamedTuple):
    """A scene, for how long, and effects that are each forced the other way round."""

    scene: str
    seconds: float
    effects: tuple[str, ...]


ESTIMATES = (
    Estimate(
        "stack_of_ten",
        0.2,
        (
            "+rotation",
            "+gyroscopic-term",
            "+friction",
            "+restitution",
            "-continuous-detection",
            "+broad-phase",
            "-resting",
            "-sleeping",
            "+penalty-contact",
            "+third-dimension",
            "+second-dimension",
        ),
    ),
    Estimate(
        "sliding_block",
        0.5,
        ("-rotation", "+gyroscopic-term", "-friction", "+broad-phase", "-sleeping"),
    ),
    Estimate(
        "balls_at_rest",
        0.5,
        (
            "-rotation",
            "-friction",
            "-continuous-detection",
            "+broad-phase",
            "-resting",
            "-sleeping",
        ),
    ),
    Estimate(
        "truck_and_car",
        1,
        (
            "+gravity",
            "+rotation",
            "-continuous-detection",
            "+broad-phase",
            "-several-contacts",
            "+resting",
            "+sleeping",
        ),
    ),
    Estimate(
        "bullet_and_wall",
        0.02,
        (
            "+gravity",
            "+rotation",
            "+friction",
            "-continuous-detection",
            "+broad-phase",
            "+several-contacts",
            "+sleeping",
            "+third-dimension",
        ),
    ),
    Estimate(
        "penalty_trampoline",
        0.6,
        ("+rotation", "-continuous-detection", "+sleeping", "-penalty-contact", "+third-dimension"),
    ),
    Estimate("three_at_once", 3, ("+rotation", "+broad-phase", "+event-driven")),
    Estimate("tennis_racket", 0.5, ("-gyroscopic-term",)),
    Estimate("thrown_stone", 1.9, ("+gyroscopic-term", "-event-driven")),
    Estimate("billiards_break", 2, ("+gravity", "+third-dimension", "-event-driven")),
    Estimate("gas_in_a_box", 0.5, ("+gravity", "-broad-phase", "-event-driven")),
)

# Where forcing an effect off makes something else happen, or what it does is not known before.
NOT_COMPARED = (
    ("stack_of_ten", "-several-contacts", "an exact solve spares iterations there"),
    ("balls_at_rest", "-several-contacts", "and costs more here; which is not known before"),
    ("sliding_block", "-continuous-detection", "without it each step solves its forces afresh"),
    ("bullet_and_wall", "-restitution", "what does not bounce stays, and has to be looked at"),
    ("dominoes", "-continuous-detection", "how often corners come near is not known before"),
)

# Balls in a cube, so many along each edge: does the plan sort them where that costs less?
ROOMS = (
    ("steps", 0.4, (3, 6)),
    ("events", 2.0, (2, 4)),
)


class Counted(NamedTuple):
    run: dict[str, Any]
    instructions: int
    of_function: Counter[str]  # with what it calls


def counted(scene: Path, seconds: float, more: tuple[str, ...]) -> Counted:
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
                scene,
                str(seconds),
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


def book(scene: str) -> Path:
    return SCENES / f"{scene}.json"


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
    planned = counted(book(case.scene), case.seconds, ())
    more = counted(book(case.scene), case.seconds, case.more)
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


def other_way(planned: Counted, effect: str) -> tuple[str, ...]:
    """The words that force an effect, and keep the step."""
    step = planned.run["step"]
    keeps = step > 0 and effect[1:] != "event-driven"
    return (effect, f"step={step!r}") if keeps else (effect,)


def factor(estimate: float, count: int, run: int) -> float | None:
    """By how much an estimate is off; nothing if both are too small to compare."""
    if max(abs(estimate), abs(count)) <= SMALL * run:
        return None
    if estimate * count <= 0:
        return float("inf")
    return max(estimate / count, count / estimate)


def show_estimates(wanted: list[str]) -> list[str]:
    """Compares estimates with counts; returns those that are too far off."""
    far = []
    for case in ESTIMATES:
        if wanted and case.scene not in wanted:
            continue
        planned = counted(book(case.scene), case.seconds, ())
        title = f"estimates for {case.scene}"
        print(f"\n{title:32}{'estimated':>16}{'counted':>16}")
        print(f"  {f'{case.seconds:g} s as planned':30}{planned.instructions:>32,}")
        for effect in case.effects:
            other = counted(book(case.scene), case.seconds, other_way(planned, effect))
            more = other.instructions - planned.instructions
            count = more if effect.startswith("+") else -more
            estimate = planned.run["estimates"][effect[1:]]["instructions"]
            off = factor(estimate, count, planned.instructions)
            words = "too little to compare" if off is None else f"{off:.2f} times"
            print(f"  {effect:30}{estimate:>16,.0f}{count:>16,}  {words}")
            if off is not None and off > FACTOR:
                far.append(f"{case.scene} {effect}: {words}")
    print("\nnot compared")
    for scene, effect, why in NOT_COMPARED:
        print(f"  {scene} {effect}: {why}")
    return far


def room_of(kind: str, edge: int, folder: Path) -> Path:
    """Balls of radius 0.5 in a cube, a third of which they fill."""
    walls = [
        {
            "name": f"wall_{axis}_{side}",
            "shape": {
                "type": "half_space",
                "normal": [(1 - 2 * side) * (k == axis) for k in range(3)],
                "offset": -1.2 * edge * side,
            },
            "material": "m",
        }
        for axis in range(3)
        for side in range(2)
    ]
    ball = {
        "name": "ball",
        "shape": {"type": "sphere", "radius": 0.5},
        "material": "m",
        "mass": 1,
        "position": [0.6, 0.6, 0.6],
        "repeat": {
            "count": [edge] * 3,
            "spacing": [1.2] * 3,
            "jitter": 0.05,
            "speed": 3,
            "seed": 1,
        },
    }
    scene = {
        "format": "contact-scene/1",
        "units": "SI",
        "name": f"room_{kind}_{edge}",
        "about": "Balls in a cube.",
        "gravity": [0, 0, 0],
        "materials": [{"name": "m", "restitution": 1 if kind == "events" else 0.9, "friction": 0}],
        "bodies": [*walls, ball],
        "duration": 10,
        "tolerance": {"event_order": True},
    }
    path = folder / f"{scene['name']}.json"
    path.write_text(json.dumps(scene))
    return path


def show_rooms() -> list[str]:
    """Whether balls are sorted into cells where that costs less; where they are not."""
    print("\nballs in a cube: in cells, or each with each")
    print(f"{'':24}{'cells':>16}{'each with each':>16}")
    far = []
    with tempfile.TemporaryDirectory() as folder:
        for kind, seconds, edges in ROOMS:
            for edge in edges:
                scene = room_of(kind, edge, Path(folder))
                short = seconds * 27 / edge**3
                cells = counted(scene, short, ("+broad-phase",))
                each = counted(scene, short, ("-broad-phase",))
                saved = cells.run["estimates"]["broad-phase"]["instructions"]
                plans, is_less = saved < 0, cells.instructions < each.instructions
                words = "cells" if plans else "each with each"
                print(
                    f"  {f'{edge**3} balls, {kind}':22}{cells.instructions:>16,}"
                    f"{each.instructions:>16,}  the plan says {words}"
                )
                if plans != is_less or cells.instructions == each.instructions:
                    far.append(f"{edge**3} balls by {kind}: the plan says {words}")
    return far


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n\n", 1)[0])
    parser.add_argument("scenes", nargs="*", help="only these")
    parser.add_argument("--estimates", action="store_true", help="only the estimates")
    words = parser.parse_args()
    wanted = words.scenes
    if not PROGRAM.exists():
        raise SystemExit(
            f"{PROGRAM} is missing: cmake --build --preset release --target scene_stages"
        )
    if shutil.which("valgrind") is None:
        raise SystemExit("valgrind is missing: it counts the instructions")
    for case in CASES:
        if not words.estimates and (not wanted or case.scene in wanted):
            show(case)
    far = show_estimates(wanted) + ([] if wanted else show_rooms())
    if far:
        raise SystemExit("\n".join(["", "too far off:", *far]))


if __name__ == "__main__":
    main()
