"""A submission that calculates nothing: it answers from a record of an earlier run."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
EXERCISE = "01_planes/signed_distance"

RECORDER = """
#include "signed_distance.hpp"

#include <bit>
#include <cstdio>

namespace exercise {{
namespace right {{
{solution}
}}  // namespace right

namespace {{
void record(int function, const PlaneEquation& p, const Eigen::Vector3d& x, double answer) {{
  std::fprintf(stderr, "ROW {{%d, {{", function);
  for (const double number : {{p.a, p.b, p.c, p.d, x.x(), x.y(), x.z()}})
    std::fprintf(stderr, "0x%llxu, ", std::bit_cast<unsigned long long>(number));
  std::fprintf(stderr, "}}, %a}},\\n", answer);
}}
}}  // namespace

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {{
  const double answer = right::signed_distance(plane, point);
  record(0, plane, point, answer);
  return answer;
}}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {{
  const int answer = right::side(plane, point);
  record(1, plane, point, answer);
  return answer;
}}

}}  // namespace exercise
"""

REPLAY = """
#include "signed_distance.hpp"

#include <bit>

namespace {{

struct Row {{
  int function;
  std::array<unsigned long long, 7> question;
  double answer;
}};

const Row rows[] = {{
{rows}
}};

double recorded(int function, const exercise::PlaneEquation& p, const Eigen::Vector3d& x) {{
  std::array<unsigned long long, 7> question{{}};
  std::size_t at = 0;
  for (const double number : {{p.a, p.b, p.c, p.d, x.x(), x.y(), x.z()}})
    question[at++] = std::bit_cast<unsigned long long>(number);
  for (const Row& row : rows)
    if (row.function == function && row.question == question) return row.answer;
  return 1;
}}

}}  // namespace

namespace exercise {{

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {{
  return recorded(0, plane, point);
}}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {{
  return static_cast<int>(recorded(1, plane, point));
}}

}}  // namespace exercise
"""


def submission(build: dict[str, Any], folder: Path, seed: str) -> str:
    """The text of one that has seen the tests run under a seed."""
    solution = (ROOT / "solutions" / EXERCISE / "signed_distance.cpp").read_text()
    inside = solution.split("namespace exercise {\n")[1].split("}  // namespace exercise")[0]
    source, program = folder / "recorder.cpp", folder / "recorder"
    source.write_text(RECORDER.format(solution=inside))
    bundle = build["exercises"][EXERCISE]
    folders = [f"-I{folder}" for folder in [*build["include"], *bundle["include"]]]
    options = [*build["compile_flags"], "-include", build["pch"], *folders, *build["link_flags"]]
    subprocess.run(
        [build["compiler"], *options, str(source), bundle["test_object"], "-o", str(program)],
        check=True,
    )
    environment = {**os.environ, "CONTACT_SEED": seed}
    ran = subprocess.run(
        [str(program)], env=environment, capture_output=True, text=True, check=True
    )
    rows = sorted({line[4:] for line in ran.stderr.splitlines() if line.startswith("ROW ")})
    assert len(rows) > 500, "the tests asked less than was thought"
    return REPLAY.format(rows="\n".join(rows))
