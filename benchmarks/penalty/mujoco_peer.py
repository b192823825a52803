"""mujoco_peer.py FOLDER [HEIGHTS]: MuJoCo's soft contacts against the closed form.

`penalty_peers --write FOLDER` writes the scenes and the right answers. The ball slides on a
vertical axis; the contact has no friction. `solref="-k/m -c/m"` are stiffness and damping as an
acceleration; MuJoCo multiplies the load by 1 - d with d the impedance. So an impedance of 1e-4 is
a spring and a damper under nearly the whole weight, and its default of 0.9 to 0.95 leaves a tenth
of the weight and less. A time constant of 2 m/c with the damping ratio means the same spring and
damper, but MuJoCo makes it at least two steps. The times are those of a loop over calls from
Python. Run it with build/venv-benchmarks/bin/python.
"""

from __future__ import annotations

import importlib
import importlib.metadata
import math
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path
from typing import Any

mujoco: Any = importlib.import_module("mujoco")

# A model of MuJoCo's, which has no types.
Model = Any

SOFT = "0.0001 0.0001 1 0.5 1"
DEFAULT = "0.9 0.95 0.001 0.5 2"
GROWS = 1e6


@dataclass(frozen=True)
class Settings:
    """How a spring and a damper are written for MuJoCo."""

    name: str
    impedance: str
    by_time_constant: bool = False

    def solref(self, stiffness: float, damping: float, inverse_mass: float) -> str:
        """Of a contact that sees the sum of the bodies' inverse masses."""
        if not self.by_time_constant:
            return f"{-stiffness * inverse_mass!r} {-damping * inverse_mass!r}"
        constant = 2 / (damping * inverse_mass)
        ratio = 1 / (constant * math.sqrt(stiffness * inverse_mass))
        return f"{constant!r} {ratio!r}"


PROGRAMS = [
    Settings("MuJoCo, impedance 1e-4", SOFT),
    Settings("MuJoCo, its default impedance", DEFAULT),
    Settings("MuJoCo, by time constant", SOFT, by_time_constant=True),
]


@dataclass(frozen=True)
class Scene:
    """A contact, the balls on it and a step, as in peers.hpp."""

    stiffness: float
    damping: float
    mass: float
    radius: float
    gravity: float
    step: float


def model(scene: Scene, settings: Settings, height: float, balls: int) -> Model:
    bodies, pairs = [], []
    for i in range(balls):
        z = height + (2 * i + 1) * scene.radius
        bodies.append(
            f'<body pos="0 0 {z!r}"><joint type="slide" axis="0 0 1"/><geom name="g{i}" '
            f'type="sphere" size="{scene.radius!r}" mass="{scene.mass!r}"/></body>'
        )
        below = f"g{i - 1}" if i else "ground"
        solref = settings.solref(scene.stiffness, scene.damping, (2 if i else 1) / scene.mass)
        pairs.append(
            f'<pair geom1="{below}" geom2="g{i}" condim="1" solref="{solref}" '
            f'solimp="{settings.impedance}"/>'
        )
    return mujoco.MjModel.from_xml_string(
        f'<mujoco><option timestep="{scene.step!r}" gravity="0 0 {-scene.gravity!r}" '
        f'solver="Newton" tolerance="1e-14" iterations="100"/>'
        f'<default><geom contype="0" conaffinity="0"/></default>'
        f'<worldbody><geom name="ground" type="plane" size="9 9 1"/>{"".join(bodies)}</worldbody>'
        f"<contact>{''.join(pairs)}</contact></mujoco>"
    )


def heights_of(scene: Scene, settings: Settings, height: float, steps: int) -> list[float]:
    """Heights of the lowest point at the start and after each step."""
    loaded = model(scene, settings, height, 1)
    data = mujoco.MjData(loaded)
    position, seen = data.qpos, [height]
    for _ in range(steps):
        mujoco.mj_step(loaded, data)
        seen.append(height + float(position[0]))
    return seen


def sunk(scene: Scene, settings: Settings, balls: int, steps: int) -> list[float]:
    loaded = model(scene, settings, 0.0, balls)
    data = mujoco.MjData(loaded)
    for _ in range(steps):
        mujoco.mj_step(loaded, data)
    return [-float(x) for x in data.qpos]


def bounce(heights: list[float], step: float) -> tuple[float, float, float]:
    """Height, duration and depth, as closed_form::seen() reads them."""

    def crossing(i: int) -> float:
        return i - 1 + heights[i - 1] / (heights[i - 1] - heights[i])

    count = len(heights)
    i = 1
    while i < count and heights[i] > 0:
        i += 1
    if i == count:
        return 0, 0, 0
    touch, depth = crossing(i), 0.0
    while i < count and heights[i] <= 0:
        depth = max(depth, -heights[i])
        i += 1
    if i == count:
        return 0, 0, depth
    duration, top = (crossing(i) - touch) * step, 0.0
    while i < count and heights[i] > 0:
        top = max(top, heights[i])
        i += 1
    return top, duration, depth


def error(got: float, right: float) -> float:
    return got / right - 1 if math.isfinite(got) else 1e300


def text(worst: float | None) -> str:
    if worst is None:
        return f" {'-':>10}"
    return f" {'grows':>10}" if abs(worst) > GROWS else f" {worst:+10.1e}"


def worst_of(errors: Iterator[float]) -> float:
    return max(errors, key=abs)


def compare_drops(folder: Path, count: int) -> None:
    rows = [line.split("\t") for line in (folder / "drops.tsv").read_text().splitlines()]
    for (ground, pace), group in groupby(rows, key=lambda row: (row[0], row[1])):
        drops = [[float(x) for x in row[2:]] for row in group][:count]
        scene = Scene(*drops[0][:6])
        steps, rest_steps = int(drops[0][6]), int(drops[0][7])
        print(
            f"{ground}, steps of {pace}: k = {scene.stiffness:g} N/m, {len(drops)} heights, "
            f"relative errors\n  {'':34} {'ns a step':>10} {'bounce':>10} {'duration':>10} "
            f"{'depth':>10} {'rest':>10}"
        )
        for settings in PROGRAMS:
            if settings.by_time_constant and scene.damping == 0:
                continue
            start = time.process_time_ns()
            seen = [heights_of(scene, settings, drop[8], steps) for drop in drops]
            took = (time.process_time_ns() - start) / steps / len(drops)
            got = [bounce(heights, scene.step) for heights in seen]
            line = f"  {settings.name:34} {took:10.0f}"
            for k in range(3):
                pairs = zip(got, drops, strict=True)
                line += text(worst_of(error(g[k], drop[9 + k]) for g, drop in pairs))
            rest = None
            if rest_steps:
                at_rest = -heights_of(scene, settings, 0.0, rest_steps)[-1]
                rest = error(at_rest, scene.mass * scene.gravity / scene.stiffness)
            print(line + text(rest))
        print(flush=True)


def compare_stacks(folder: Path) -> None:
    rows = [line.split("\t") for line in (folder / "stacks.tsv").read_text().splitlines()]
    print("ten balls on each other, sag of the top, relative errors")
    print(f"  {'':34}" + "".join(f" {row[0]:>10}" for row in rows))
    for settings in PROGRAMS:
        line = f"  {settings.name:34}"
        for row in rows:
            numbers = [float(x) for x in row[1:]]
            scene, steps, balls = Scene(*numbers[:6]), int(numbers[6]), int(numbers[7])
            sag = scene.mass * scene.gravity / scene.stiffness * balls * (balls + 1) / 2
            line += text(error(sunk(scene, settings, balls, steps)[-1], sag))
        print(line, flush=True)


def stays(scene: Scene, settings: Settings) -> bool:
    """Whether a ball a thousandth below where it rests is not farther from it in the end."""
    steps, last = 6000, 100
    loaded = model(scene, settings, 0.0, 1)
    data = mujoco.MjData(loaded)
    sag = scene.mass * scene.gravity / scene.stiffness * (1 - float(settings.impedance.split()[0]))
    data.qpos[0] = -sag * 1.001
    farthest = 0.0
    for i in range(steps):
        mujoco.mj_step(loaded, data)
        if i >= steps - last:
            farthest = max(farthest, abs(float(data.qpos[0]) + sag))
    return farthest < 0.001 * sag


def compare_limits(folder: Path) -> None:
    print("\nlongest step of a ball at rest that does not grow, ms, by bisection, and the book's")
    print(f"  {'':34} {'MuJoCo':>10} {'book':>10} {'2/omega':>10}")
    for line in (folder / "limits.tsv").read_text().splitlines():
        name, *rest = line.split("\t")
        stiffness, damping, mass, radius, gravity, limit = map(float, rest)
        low, high = 0.0, 2 * limit
        for _ in range(12):
            middle = (low + high) / 2
            if stays(Scene(stiffness, damping, mass, radius, gravity, middle), PROGRAMS[0]):
                low = middle
            else:
                high = middle
        undamped = 2 * math.sqrt(mass / stiffness)
        steps = f"{1000 * low:10.4f} {1000 * limit:10.4f} {1000 * undamped:10.4f}"
        print(f"  {name:34} {steps}", flush=True)


def main() -> None:
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 4
    print(f"mujoco {importlib.metadata.version('mujoco')}, called from Python\n")
    compare_drops(folder, count)
    compare_stacks(folder)
    compare_limits(folder)


if __name__ == "__main__":
    main()
