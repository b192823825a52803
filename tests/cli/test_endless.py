"""check: answers that do not end, in one test or in all of them."""

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
Spoiled = Callable[[str], str]

pytestmark = pytest.mark.usefixtures("clean_after")


def verdicts(contact: Run) -> list[dict[str, Any]]:
    done = contact("check", "ray_triangle", "--json")
    assert done.returncode == 1, done.stderr
    (result,) = json.loads(done.stdout)["results"]
    return list(result["tests"])


def test_after_an_endless_loop_the_other_tests_have_less_time(
    contact: Run, spoiled: Spoiled, answer: Answer
) -> None:
    answer(spoiled("for (volatile int i = 0;;) i = i + 1;"))
    first, *others = verdicts(contact)
    endless = "an endless loop, or far too much work"
    assert first["failure"]["reason"] == f"no answer after 1 second: {endless}"
    stopped = [test for test in others if test["status"] == "stopped"]
    skipped = [test for test in others if test["status"] == "skipped"]
    assert [*stopped, *skipped] == others
    assert stopped
    for test in stopped:
        reason = test["failure"]["reason"]
        # On a busy machine one second passes before a quarter of it is worked.
        assert re.match(rf"no answer after (0\.25 seconds|1 second): {endless}", reason)
        assert reason.endswith("(it had less time because a test before it did not end)")
        assert test["failure"]["inputs"]
    for test in skipped:
        assert test["failure"]["reason"].startswith(f"not run, because {1 + len(stopped)} tests")


@pytest.mark.slow
def test_a_sleeper_is_waited_for_once(contact: Run, spoiled: Spoiled, answer: Answer) -> None:
    answer("#include <unistd.h>\n" + spoiled("for (;;) sleep(1);"))
    reasons = [test["failure"]["reason"] for test in verdicts(contact)]
    assert reasons[0].startswith("waited for 10 seconds in all and did nothing")
    assert reasons[1].startswith("waited for 1 second in all and did nothing")
    assert reasons[2] == reasons[1]
    not_run = "not run, because 3 tests before it did not end; mend these first"
    assert set(reasons[3:]) == {not_run}
    text = re.sub(r"\s+", " ", contact("check", "ray_triangle").stdout)
    assert text.count(f"skipped: {not_run}") == 1


def test_after_a_loop_in_one_test_the_others_pass(
    contact: Run, spoiled: Spoiled, answer: Answer
) -> None:
    answer(
        spoiled("for (volatile int i = 0; triangle.a.x() == 1 && ray.origin.x() == 2;) i = i + 1;")
    )
    statuses = [test["status"] for test in verdicts(contact)]
    assert "stopped" in statuses
    assert "passed" in statuses[statuses.index("stopped") :]
