"""ipctk_peer.py FOLDER [RUNS]: what the IPC Toolkit says of the moving points in a folder.

`toi_peers --write FOLDER` keeps them there. Asked is Tight-Inclusion with its default tolerance of
1e-6 and its default number of iterations; after LIMIT seconds a family is left, and the number of
queries that were asked is printed. The times are those of a loop over calls from Python: the call
is in the time, and the row `a call alone` gives what a call of the toolkit with the same eight
points takes that only compares bounding boxes. The book's program answers in turn, without Python.
Run it with build/venv-benchmarks/bin/python.
"""

from __future__ import annotations

import importlib
import importlib.metadata
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

ipctk: Any = importlib.import_module("ipctk")
numpy: Any = importlib.import_module("numpy")

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/release/bin/toi_peers"
LIMIT = 2.0  # s of processor time
# An array of NumPy's, which is not there where types are checked.
Array = Any
Answer = tuple[bool, float]


def methods(edges: bool) -> dict[str, Callable[[list[Array]], Answer]]:
    tight: Any = ipctk.tight_inclusion
    inclusion = tight.edge_edge_ccd if edges else tight.point_triangle_ccd
    bounds = ipctk.edge_edge_aabb_ccd if edges else ipctk.point_triangle_aabb_ccd

    def tight_inclusion(p: list[Array]) -> Answer:
        found = inclusion(*p)
        return bool(found[0]), float(found[1])

    def call_alone(p: list[Array]) -> Answer:
        return bool(bounds(*p, 0.0)), 0.0

    return {
        "Tight-Inclusion, tolerance 1e-6": tight_inclusion,
        "a call alone": call_alone,
    }


def book_takes(folder: Path, name: str) -> float:
    """The book's time for a query, in ns."""
    done = subprocess.run(
        [PROGRAM, "--ask", folder, name], capture_output=True, text=True, check=True
    )
    return float(done.stdout.split()[0])


def compare(folder: Path, name: str, title: str, runs: int, totals: dict[str, list[int]]) -> None:
    points = numpy.fromfile(folder / f"{name}.f64", "<f8").reshape(-1, 8, 3)
    right = numpy.fromfile(folder / f"{name}.right.f64", "<f8")
    queries = [list(query) for query in points]
    print(f"{title}, {len(queries)} queries, {(right >= 0).sum()} touch")
    print(f"  {'':34} {'ns a query':>10} {'book / this':>11}", end="")
    print(f" {'asked':>7} {'missed':>7} {'false':>7} {'past':>7}")
    ask = methods(name.startswith("ee"))
    times: dict[str, list[float]] = {method: [] for method in ask}
    shares: dict[str, list[float]] = {method: [] for method in ask}
    found: dict[str, list[Answer]] = {method: [] for method in ask}
    for _ in range(runs):
        book = book_takes(folder, name)
        for method, answer in ask.items():
            start = time.process_time_ns()
            found[method] = []
            for query in queries:
                found[method].append(answer(query))
                if time.process_time_ns() - start > LIMIT * 1e9:
                    break
            times[method].append((time.process_time_ns() - start) / len(found[method]))
            shares[method].append(book / times[method][-1])
    print(f"  {'Contact Hours':34} {book_takes(folder, name):10.0f}")
    for method, answers in found.items():
        line = f"  {method:34} {statistics.median(times[method]):10.0f}"
        line += f" {statistics.median(shares[method]):11.3f} {len(answers):7}"
        if method != "a call alone":
            hit = numpy.array([got[0] for got in answers])
            t = numpy.array([got[1] for got in answers])
            wanted = right[: len(answers)]
            touch = wanted >= 0
            counts = [(touch & ~hit).sum(), (~touch & hit).sum()]
            counts.append((touch & hit & (t > wanted)).sum())
            line += "".join(f" {count:7}" for count in counts)
            totals[method][0] += len(answers)
            for k, count in enumerate(counts):
                totals[method][k + 1] += int(count)
        print(line)
    print(flush=True)


def main() -> None:
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    ipctk.set_logger_level(ipctk.LoggerLevel.off)
    folder = Path(sys.argv[1])
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 3
    print(f"ipctk {importlib.metadata.version('ipctk')}, called from Python\n")
    totals = {method: [0, 0, 0, 0] for method in methods(edges=False)}
    for line in (folder / "families.tsv").read_text().splitlines():
        name, title = line.split("\t")
        compare(folder, name, title, runs, totals)
    print(f"all moving points\n  {'':34} {'asked':>7} {'missed':>7} {'false':>7} {'past':>7}")
    for method, counts in totals.items():
        if method != "a call alone":
            print(f"  {method:34}" + "".join(f" {count:7}" for count in counts))


if __name__ == "__main__":
    main()
