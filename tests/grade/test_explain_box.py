"""If messages cannot be explained within the sandbox, the compiler's own first error is reported,
and no mark changes."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from graded_class import SOLUTION, Grader

BROKEN = SOLUTION.replace("return value > 0", "return nobody_declared_this > 0")
# The replacement for contact-explain.
PROGRAMS = {
    "never ends": "for (;;) {}",
    "waits for ever": "for (;;) pause();",
    "takes all memory": "for (;;) { char* p = malloc(1 << 20); if (p) memset(p, 1, 1 << 20); }",
    "says too much": 'for (;;) puts("{}");',
    "crashes": "abort();",
    "says nothing": "return 0;",
    "says no JSON": 'puts("{\\"error\\": 7");',
    "says something else": 'puts("{\\"remarks\\": 5, \\"warnings\\": []}");',
    "says that nothing is wrong": (
        'puts("{\\"remarks\\": [], \\"warnings\\": [], \\"only_library_twice\\": false}");'
    ),
}


@pytest.mark.parametrize("does", PROGRAMS)
def test_marks_do_not_depend_on_what_explains(grader: Grader, tmp_path: Path, does: str) -> None:
    own = tmp_path / "bin"
    own.mkdir()
    for name in ("contact", "contact-grade", "contact-box"):
        shutil.copy2(grader.program.parent / name, own)
    source = tmp_path / "explain.c"
    source.write_text(
        "#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n#include <unistd.h>\n"
        f"int main(void) {{ {PROGRAMS[does]} return 0; }}\n"
    )
    program = own / "contact-explain"
    subprocess.run(["gcc", "-O1", "-static", source, "-o", program], check=True)
    grader.program = own / "contact"
    grader.hand_in("ada", SOLUTION)
    grader.hand_in("bob", BROKEN)
    grader.hand_in("cat", SOLUTION)
    grader.grade()
    assert grader.points() == {"ada": 8, "bob": 0, "cat": 8}
    verdict = grader.unit("bob")["verdict"]
    assert verdict["verdict"] == "does_not_compile"
    assert "nobody_declared_this" in verdict["compile_error"]["message"]
    assert "error: " in verdict["compile_error"]["message"]
    assert len(verdict["compile_error"]["message"]) < 320
