"""check: the commonest mistakes are recognised and told in words.

The page's compiler gets the same files in page/web/test/cpp/judge.test.mjs. That nothing is said of
what compiles is for `contact dev check` to prove, of every solution and wrong answer.
"""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

Run = Callable[..., subprocess.CompletedProcess[str]]
Answer = Callable[[str], Path]
ROOT = Path(__file__).resolve().parents[2]
MISTAKES = sorted((ROOT / "tests/grading/mistakes").glob("*/*/*.cpp"))


def checked(contact: Run, *files: Path) -> dict[Path, dict[str, Any]]:
    done = contact("check", "--json", *map(str, files))
    assert done.returncode in (0, 1), done.stderr
    return {Path(result["file"]): result for result in json.loads(done.stdout)["results"]}


@pytest.mark.slow
def test_every_mistake_is_recognised(contact: Run) -> None:
    assert len({path.name for path in MISTAKES}) >= 60
    verdicts = checked(contact, *MISTAKES)
    problems = []
    for path in MISTAKES:
        text = path.read_text()
        named = re.search(r"^// mistake: (\S+)$", text, re.MULTILINE)
        assert named, path
        remarks = verdicts[path]["diagnostics"]
        first = next((said for said in remarks if said["severity"] == "error"), *remarks[:1])
        marked = [i for i, line in enumerate(text.splitlines(), 1) if line.endswith("// here")]
        says = re.findall(r"^// says: (.*)$", text, re.MULTILINE)
        if (
            first.get("mistake") != named[1]
            or (marked and first["line"] not in marked)
            or not all(part in first["words"] for part in says)
            or (re.search(r"^// alone$", text, re.MULTILINE) and len(remarks) != 1)
        ):
            problems.append(f"{path.name}: {json.dumps(remarks, indent=1, ensure_ascii=False)}")
    assert not problems, "\n".join(problems)


def test_a_place_is_counted_in_characters(contact: Run, answer: Answer, solution: str) -> None:
    body = "\tconst double α = 1.0; /* → */ const double β = α + gamme;\n"
    at = "const contact::Triangle<double>& triangle) {\n"
    path = answer(solution.replace(at, at + body))
    (remark,) = checked(contact, path)[path]["diagnostics"]
    line = path.read_text().splitlines()[remark["line"] - 1]
    assert line[remark["column"] - 1 : remark["end_column"] - 1] == "gamme"


def test_the_words_are_printed_and_the_original_on_request(
    contact: Run, answer: Answer, solution: str
) -> None:
    at = "const contact::Triangle<double>& triangle) {\n"
    broken = "const double first = ray.orign.x();\nconst double second = triangle.d.x();\n"
    answer(solution.replace(at, at + broken))
    told = contact("check", "ray_triangle").stdout
    assert "is it origin, misspelt?" in told
    assert re.search(r"^ +line \d+: .*has no d\b", told, re.MULTILINE)
    assert "In function" not in told
    whole = contact("check", "ray_triangle", "--full").stdout
    assert "In function" in whole
    assert "misspelt" not in whole


def test_a_warning_is_told_beside_what_fails(
    contact: Run, answer: Answer, spoiled: Callable[[str], str]
) -> None:
    answer(spoiled("double x = 1.0; if (x = 0.0) return std::nullopt; return std::nullopt;"))
    told = contact("check", "ray_triangle").stdout
    assert re.search(r"the compiler warns: line \d+: One = assigns", told)
