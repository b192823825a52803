"""igl_peer.py FOLDER [RUNS]: libigl's winding numbers of the points of `mesh_peers --write FOLDER`.

Medians of several runs, and wrong answers. A call of libigl makes its tree and answers all points:
the time of a call with one point is subtracted from that with all of them. The book's program
answers the same points in turn. Run it with build/venv-benchmarks/bin/python.
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

# libigl shares its work out among threads; read before it is loaded.
os.environ["IGL_NUM_THREADS"] = "1"
igl: Any = importlib.import_module("igl")
numpy: Any = importlib.import_module("numpy")

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/release/bin/mesh_peers"
# An array of NumPy's, which is not there where types are checked.
Array = Any


def took(ask: Callable[[Array], Array], points: Array) -> float:
    """The processor's time of a call, in ns."""
    start = time.process_time_ns()
    ask(points)
    return time.process_time_ns() - start


def book_takes(folder: Path, family: str) -> float:
    """The book's time for a point, in ns."""
    done = subprocess.run(
        [PROGRAM, "--ask", folder, family], capture_output=True, text=True, check=True
    )
    return float(done.stdout)


def spread(values: list[float], digits: int) -> str:
    """Median, least and most."""
    low, high = min(values), max(values)
    median = statistics.median(values)
    return f"{median:9.{digits}f} {low:9.{digits}f} - {high:9.{digits}f}"


def compare(folder: Path, runs: int) -> None:
    vertices = numpy.fromfile(folder / "vertices.f32", "<f4").reshape(-1, 3).astype(float)
    triangles = numpy.fromfile(folder / "triangles.i32", "<i4").reshape(-1, 3).astype("int64")

    def exactly(points: Array) -> Array:
        return igl.winding_number(vertices, triangles, points)

    def roughly(points: Array) -> Array:
        return igl.fast_winding_number(vertices, triangles, points)

    methods = {"winding_number": exactly, "fast_winding_number": roughly}
    for line in (folder / "families.tsv").read_text().splitlines():
        name, title = line.split("\t")
        if not name.startswith("points"):
            continue
        points = numpy.fromfile(folder / f"{name}.f32", "<f4").reshape(-1, 3).astype(float)
        right = numpy.fromfile(folder / f"{name}.right.i32", "<i4")
        decided = right != 0
        on = len(points) - decided.sum()
        print(f"{title}, {len(points)} points, {on} on the surface, which are left out")
        print(f"  {'':28} {'ns a point':>9} {'least - most':>21} {'book / this':>9}", end="")
        print(f" {'least - most':>19} {'wrong':>9} {'ms of a tree':>12}")
        for method, ask in methods.items():
            inside = ask(points) > 0.5
            wrong = int(((inside != (right > 0)) & decided).sum())
            ns: list[float] = []
            shares: list[float] = []
            tree = statistics.median(took(ask, points[:1]) for _ in range(runs))
            for _ in range(runs):
                each = (took(ask, points) - tree) / (len(points) - 1)
                ns.append(each)
                shares.append(book_takes(folder, name) / each)
            print(f"  libigl, {method:20} {spread(ns, 1)} {spread(shares, 3)}", end="")
            print(f" {wrong:9} {tree / 1e6:12.1f}")
        print(flush=True)


def main() -> None:
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 9
    print(f"libigl {importlib.metadata.version('libigl')}, one thread\n")
    for folder in sorted(Path(sys.argv[1]).iterdir()):
        compare(folder, runs)


if __name__ == "__main__":
    main()
