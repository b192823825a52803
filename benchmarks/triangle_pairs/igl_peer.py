"""igl_peer.py FOLDER [RUNS]: what libigl says of the pairs of triangles and of meshes in a folder.

`pair_peers --write FOLDER` and `mesh_pair_peers --write FOLDER` keep them there. Of pairs of
triangles it prints wrong answers only, for a call from Python takes longer than the test. Of meshes
it prints times, too: a call of find_intersections builds its tree and finds all pairs; the book's
program builds its trees and answers in turn. Run it with build/venv-benchmarks/bin/python.
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
predicates: Any = importlib.import_module("igl.predicates")
numpy: Any = importlib.import_module("numpy")

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/release/bin/mesh_pair_peers"
# An array of NumPy's, which is not there where types are checked.
Array = Any


def rounded(p: Array) -> bool:
    """Guigue and Devillers' test in double."""
    return bool(igl.tri_tri_overlap_test_3d(*(p[i : i + 1] for i in range(6))))


def exact(p: Array) -> bool:
    """The test with exact predicates."""
    return bool(predicates.triangle_triangle_intersect(*p)[0])


METHODS: dict[str, Callable[[Array], bool]] = {
    "tri_tri_overlap_test_3d": rounded,
    "triangle_triangle_intersect": exact,
}


def compare_pairs(folder: Path) -> None:
    for line in (folder / "families.tsv").read_text().splitlines():
        name, title = line.split("\t")
        pairs = numpy.fromfile(folder / f"{name}.f64", "<f8").reshape(-1, 6, 3)
        right = numpy.fromfile(folder / f"{name}.right.i8", "i1") == 1
        print(f"{title}, {len(pairs)} pairs, {right.sum()} meet")
        print(f"  {'':36} {'missed':>9} {'invented':>9}")
        for method, meet in METHODS.items():
            got = numpy.array([meet(pair) for pair in pairs])
            missed, invented = (right & ~got).sum(), (got & ~right).sum()
            print(f"  libigl, {method:28} {missed:9} {invented:9}")
        print(flush=True)


def book_takes(folder: Path, what: str) -> float:
    """The book's time for two meshes, in ms."""
    done = subprocess.run(
        [PROGRAM, "--ask", folder, what], capture_output=True, text=True, check=True
    )
    return float(done.stdout)


def spread(values: list[float], digits: int) -> str:
    """Median, least and most."""
    low, high = min(values), max(values)
    median = statistics.median(values)
    return f"{median:9.{digits}f} {low:9.{digits}f} - {high:9.{digits}f}"


def compare_meshes(folder: Path, runs: int) -> None:
    def mesh(name: str) -> tuple[Array, Array]:
        vertices = numpy.fromfile(folder / f"{name}.f64", "<f8").reshape(-1, 3)
        triangles = numpy.fromfile(folder / f"{name}.i32", "<i4").reshape(-1, 3)
        return vertices, triangles.astype("int64")

    both = (*mesh("first"), *mesh("second"))
    pairs = numpy.fromfile(folder / "right.i32", "<i4").reshape(-1, 2)
    right = {(int(i), int(j)) for i, j in pairs}
    title = (folder / "title.txt").read_text().strip()
    print(f"{title}, {len(right)} pairs meet: building and all pairs")
    print(f"  {'':28} {'ms':>9} {'least - most':>21} {'book / this':>9}", end="")
    print(f" {'least - most':>19} {'missed':>9} {'invented':>9}")
    times: list[float] = []
    shares: list[float] = []
    found: set[tuple[int, int]] = set()
    for _ in range(runs):
        start = time.process_time_ns()
        pairs = predicates.find_intersections(*both)[1]
        times.append((time.process_time_ns() - start) / 1e6)
        shares.append((book_takes(folder, "build") + book_takes(folder, "all")) / times[-1])
        found = {(int(i), int(j)) for i, j in pairs}
    print(f"  libigl, {'find_intersections':20} {spread(times, 1)} {spread(shares, 3)}", end="")
    print(f" {len(right - found):9} {len(found - right):9}\n", flush=True)


def main() -> None:
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 9
    print(f"libigl {importlib.metadata.version('libigl')}, one thread\n")
    folder = Path(sys.argv[1])
    if (folder / "pairs").is_dir():
        compare_pairs(folder / "pairs")
    if (folder / "meshes").is_dir():
        for scene in sorted((folder / "meshes").iterdir()):
            compare_meshes(scene, runs)


if __name__ == "__main__":
    main()
