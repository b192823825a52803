"""miniball_peer.py FOLDER [RUNS]: what miniball says of the sets of points in a folder.

`volume_peers --write FOLDER` keeps them there. MiniballCpp calls Gärtner's Miniball, which computes
in double; its own clock times it, without the conversion of the points. The book's program answers
in turn. Run it with build/venv-benchmarks/bin/python (MiniballCpp has a wheel for Python 3.11).
"""

from __future__ import annotations

import importlib
import importlib.metadata
import math
import statistics
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

miniball: Any = importlib.import_module("miniball")
numpy: Any = importlib.import_module("numpy")

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/release/bin/volume_peers"
# An array of NumPy's, which is not there where types are checked.
Array = Any


def outside(points: Array, centre: list[float], radius: float) -> bool:
    """Whether a point is outside: by fractions where doubles leave a doubt."""
    squares = ((points - numpy.array(centre)) ** 2).sum(axis=1)
    limit = radius * radius
    if bool((squares > limit * (1 + 1e-12)).any()):
        return True
    about = points[squares > limit * (1 - 1e-12)]
    c, r = [Fraction(x) for x in centre], Fraction(radius)
    return any(
        sum((Fraction(float(x)) - y) ** 2 for x, y in zip(p, c, strict=True)) > r * r for p in about
    )


def book_takes(folder: Path, name: str) -> float:
    """The book's time for a set, in ns."""
    done = subprocess.run(
        [PROGRAM, "--ask", folder, name], capture_output=True, text=True, check=True
    )
    return float(done.stdout)


def spread(values: list[float], digits: int) -> str:
    """Median, least and most."""
    low, high = min(values), max(values)
    median = statistics.median(values)
    return f"{median:9.{digits}f} {low:9.{digits}f} - {high:9.{digits}f}"


def compare(folder: Path, name: str, title: str, runs: int) -> None:
    points = numpy.fromfile(folder / f"{name}.f64", "<f8").reshape(-1, 3)
    counts = numpy.fromfile(folder / f"{name}.counts.i32", "<i4")
    right = numpy.fromfile(folder / f"{name}.right.f64", "<f8").reshape(-1, 2)
    sets = numpy.split(points, numpy.cumsum(counts)[:-1])
    times: list[float] = []
    shares: list[float] = []
    missed = wrong = 0
    for run in range(runs):
        balls = [miniball.Miniball(points) for points in sets]
        times.append(sum(ball.get_time() for ball in balls) * 1e6 / len(balls))
        shares.append(book_takes(folder, name) / 1e3 / times[-1] if times[-1] > 0 else math.nan)
        if run > 0:
            continue
        for points, ball, (radius, room) in zip(sets, balls, right, strict=True):
            centre, got = ball.center(), math.sqrt(max(ball.squared_radius(), 0))
            missed += outside(points, centre, got)
            wrong += abs(got - radius) > room or outside(points, centre, got + room)
    print(f"{title}: the smallest sphere")
    print(f"  {'':28} {'us a set':>9} {'least - most':>21} {'book / this':>9}", end="")
    print(f" {'least - most':>19} {'outside':>9} {'wrong':>9}")
    print(f"  miniball, {'Miniball':18} {spread(times, 1)} {spread(shares, 3)}", end="")
    print(f" {missed:9} {wrong:9}\n", flush=True)


def main() -> None:
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 9
    print(f"MiniballCpp {importlib.metadata.version('MiniballCpp')}\n")
    folder = Path(sys.argv[1]) / "spheres"
    for line in (folder / "scenes.tsv").read_text().splitlines():
        name, title = line.split("\t")
        compare(folder, name, title, runs)


if __name__ == "__main__":
    main()
