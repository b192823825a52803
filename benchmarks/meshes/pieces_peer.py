"""pieces_peer.py FOLDER [RUNS]: the book's exact convex pieces beside those of V-HACD and CoACD.

First mesh_pieces writes the bodies into the folder. Both peers approximate: of each is printed the
number of pieces, by how much the sum of their volumes differs from the volume of the body, and how
many of 100,000 random points are in the body but in no piece, or the other way round, as a share of
those in the body. Times are those of the processor. Run it with build/venv-benchmarks/bin/python.
"""

from __future__ import annotations

import importlib
import importlib.metadata
import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

os.environ["IGL_NUM_THREADS"] = os.environ["OMP_NUM_THREADS"] = "1"
coacd: Any = importlib.import_module("coacd")
igl: Any = importlib.import_module("igl")
numpy: Any = importlib.import_module("numpy")
spatial: Any = importlib.import_module("scipy.spatial")
vhacdx: Any = importlib.import_module("vhacdx")

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/release/bin/mesh_pieces"
POINTS = 100_000
# An array of NumPy's, which is not there where types are checked.
Array = Any


def by_vhacd(vertices: Array, triangles: Array) -> list[Array]:
    """Its pieces' vertices, at its own settings."""
    # Each face begins with the number of its vertices.
    faces = numpy.insert(triangles, 0, 3, axis=1).astype("uint32").ravel()
    pieces = vhacdx.compute_vhacd(vertices, faces, asyncACD=False)
    return [points for points, _ in pieces]


def by_coacd(vertices: Array, triangles: Array) -> list[Array]:
    mesh = coacd.Mesh(vertices, triangles)
    return [points for points, _ in coacd.run_coacd(mesh, seed=1)]


def in_some(pieces: list[Array], points: Array) -> tuple[Array, float]:
    """Which points are in a piece; and the sum of the pieces' volumes."""
    inside = numpy.zeros(len(points), bool)
    volume = 0.0
    for piece in pieces:
        hull = spatial.ConvexHull(piece)
        volume += hull.volume
        inside |= (points @ hull.equations[:, :3].T + hull.equations[:, 3] <= 0).all(axis=1)
    return inside, volume


def compare(
    name: str,
    split: Callable[[Array, Array], list[Array]],
    runs: int,
    body: tuple[Array, Array, float],
) -> None:
    vertices, triangles, volume = body
    times: list[float] = []
    pieces: list[Array] = []
    for _ in range(runs):
        start = time.process_time()
        pieces = split(vertices, triangles)
        times.append((time.process_time() - start) * 1000)
    random = numpy.random.default_rng(1)
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    points = low + random.random((POINTS, 3)) * (high - low)
    inside = igl.winding_number(vertices, triangles.astype("int64"), points) > 0.5
    covered, sum_of_volumes = in_some(pieces, points)
    error = (sum_of_volumes - volume) / volume
    wrong = (covered != inside).sum() / inside.sum()
    row(name, len(pieces), times, f"{error:+10.2%} {wrong:13.2%}")


def row(name: str, pieces: int, times: list[float], rest: str) -> None:
    middle, low, high = statistics.median(times), min(times), max(times)
    print(f"  {name:22} {pieces:7} {middle:9.1f} {low:9.1f} - {high:9.1f} {rest}", flush=True)


def main() -> None:
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 3
    coacd.set_log_level("error")
    subprocess.run([PROGRAM, folder, str(runs)], check=True)
    versions = [f"{name} {importlib.metadata.version(name)}" for name in ("vhacdx", "coacd")]
    print(", ".join(versions) + "\n")
    for line in (folder / "bodies.tsv").read_text().splitlines():
        name, faces, notches, pieces, middle, low, high, exact, volume = line.split("\t")
        print(f"{name}, {faces} triangles, {notches} notches")
        print(
            f"  {'':22} {'pieces':>7} {'ms':>9} {'least - most':>21} {'volume':>10} {'points':>13}"
        )
        times = [float(low), float(middle), float(high)]
        row("Contact Hours", int(pieces), times, f"{exact:>10} {'':13}")
        vertices = numpy.fromfile(folder / f"{name}.vertices.f64").reshape(-1, 3)
        triangles = numpy.fromfile(folder / f"{name}.triangles.i32", "<i4").reshape(-1, 3)
        body = vertices, triangles, float(volume)
        compare("V-HACD", by_vhacd, runs, body)
        compare("CoACD", by_coacd, runs, body)
        print(flush=True)


if __name__ == "__main__":
    main()
