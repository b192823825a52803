"""mujoco_peer.py FILE: boxes on a plane in MuJoCo, where the right answer is known.

`contact_peers --write FILE` writes the scenes. MuJoCo's contacts are soft: its default time
constant is two steps of 0.01 s at least, so boxes sink under their weight, and friction lets them
creep; `noslip_iterations` is its remedy. Its cone of friction is elliptic here; its default is a
pyramid.

It has no coefficient of restitution. The rod bounces by the stiffness and damping of its contacts
(`solref` with negative numbers): the stiffness of a time constant of two steps, and the damping
with which a linear spring bounces so. The plank, which should bounce too, does not.

Run it with build/venv-benchmarks/bin/python.
"""

from __future__ import annotations

import importlib
import math
import sys
import time
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path
from typing import Any

mujoco: Any = importlib.import_module("mujoco")

# A model of MuJoCo's, which has no types.
Model = Any

PROGRAMS = {
    "MuJoCo": '<option cone="elliptic"/>',
    "MuJoCo, pyramid": '<option cone="pyramidal"/>',
    "MuJoCo, noslip": '<option cone="elliptic" noslip_iterations="50"/>',
}


@dataclass(frozen=True)
class Box:
    """A line of the file."""

    scene: str
    gravity: float
    friction: float
    restitution: float
    step: float
    steps: int
    mass: float
    size: tuple[float, float, float]
    centre: tuple[float, float, float]
    velocity: tuple[float, float, float]


def read(name: str) -> list[Box]:
    boxes = []
    for line in Path(name).read_text("utf-8").splitlines():
        scene, *rest = line.split("\t")
        x = [float(number) for number in rest]
        lists = [(x[i], x[i + 1], x[i + 2]) for i in (6, 9, 12)]
        numbers = (x[0], x[1], x[2], x[3], int(x[4]), x[5])
        boxes.append(Box(scene, *numbers, lists[0], lists[1], lists[2]))
    return boxes


def damping_ratio(restitution: float) -> float:
    """Of a linear spring with damping that pushes until its force is 0, and does not pull."""

    def bounces(ratio: float) -> float:
        root = math.sqrt(1 - ratio * ratio)
        phase = math.pi - math.atan2(2 * ratio * root, 1 - 2 * ratio * ratio)
        return math.exp(-ratio / root * phase)

    low, high = 0.0, 0.99
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if bounces(middle) > restitution else (low, middle)
    return low if restitution < 1 else 0.0


def bouncing(box: Box) -> str:
    """Contacts with a stiffness and damping of their own, of which the impedance takes nothing."""
    frequency = 1 / (2 * box.step)
    damping = 2 * damping_ratio(box.restitution) * frequency
    return f'solref="{-(frequency**2)!r} {-damping!r}" solimp="0.9999 0.9999 0.001 0.5 2"'


def model(boxes: list[Box], option: str) -> Model:
    def text(numbers: tuple[float, ...]) -> str:
        return " ".join(repr(number) for number in numbers)

    friction = text((boxes[0].friction, 0.0, 0.0))
    contacts = bouncing(boxes[0]) if boxes[0].scene.startswith("rod") else ""
    bodies = "".join(
        f'<body pos="{text(box.centre)}"><freejoint/><geom type="box" mass="{box.mass!r}" '
        f'size="{text(tuple(length / 2 for length in box.size))}" friction="{friction}"/></body>'
        for box in boxes
    )
    return mujoco.MjModel.from_xml_string(
        f"<mujoco>{option}<default><geom {contacts}/></default>"
        f'<option timestep="{boxes[0].step!r}" '
        f'gravity="0 0 {-boxes[0].gravity!r}" tolerance="1e-14" iterations="100"/><worldbody>'
        f'<geom type="plane" size="99 99 1" friction="{friction}"/>{bodies}</worldbody></mujoco>'
    )


def main() -> int:
    if len(sys.argv) != 2:
        sys.exit(str(__doc__))
    print(f"MuJoCo {mujoco.__version__}; the time is that of calls from Python, us a step")
    for scene, group in groupby(read(sys.argv[1]), key=lambda box: box.scene):
        boxes = list(group)
        for name, option in PROGRAMS.items():
            loaded = model(boxes, option)
            data = mujoco.MjData(loaded)
            for i, box in enumerate(boxes):
                data.qvel[6 * i : 6 * i + 3] = box.velocity
            asymmetric = 0.0
            start = time.process_time()
            for _ in range(boxes[0].steps):
                mujoco.mj_step(loaded, data)
                if scene == "plank":
                    p = data.qpos
                    asymmetric = max(asymmetric, abs(p[0] + p[7]), abs(p[2] - p[9]), abs(p[14]))
            elapsed = 1e6 * (time.process_time() - start) / boxes[0].steps
            at = [[float(x) for x in data.qpos[7 * i : 7 * i + 3]] for i in range(len(boxes))]
            if scene == "plank":
                says = f"asymmetric {asymmetric:.1e} m"
            elif scene.startswith("rod"):
                off = data.qvel[2] + boxes[0].restitution * boxes[0].velocity[2]
                says = f"off {off:+.2e} m/s, {math.hypot(*data.qvel[3:6]):.1e} rad/s"
            elif scene.startswith("slides"):
                v = boxes[0].velocity
                speed = math.hypot(*v)
                along = sum(a * b for a, b in zip(at[0], v, strict=True)) / speed
                beside = (v[0] * at[0][1] - v[1] * at[0][0]) / speed
                says = f"off {along - 2.5:+.2e} m, beside {beside:+.2e} m"
            else:
                sideways = max(
                    math.hypot(p[0] - box.centre[0], p[1] - box.centre[1])
                    for p, box in zip(at, boxes, strict=True)
                )
                down = max(box.centre[2] - p[2] for p, box in zip(at, boxes, strict=True))
                says = f"sideways {sideways:.1e} m, down {down:.1e} m"
            print(f"  {scene:18} {name:18} {says:40} {elapsed:8.1f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
