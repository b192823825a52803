"""contact simulate: until when a run kept the tolerance, and --strict."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

Run = Callable[..., subprocess.CompletedProcess[str]]
Json = dict[str, Any]

ROOT = Path(__file__).resolve().parents[2]


def of_book(name: str) -> Json:
    scene: Json = json.loads((ROOT / f"chapters/20_scenes/scenes/{name}.json").read_text())
    return scene


def sliding_ball(file: Path, **other: Json) -> str:
    """A ball that slides on a floor until it rolls, with a tolerance of 1e-6 m."""
    file.write_text(json.dumps({**of_book("sliding_then_rolling"), "expect": [], **other}))
    return str(file)


def rolling_on_a_ball(file: Path) -> str:
    """A ball that leaves the top of a fixed one: their contact normal rotates all the time."""
    scene = of_book("sliding_then_rolling")
    top = {"type": "sphere", "radius": 1}
    hill = {"name": "hill", "shape": top, "material": "cloth", "position": [0, 0, -1]}
    scene["bodies"][0] = {**hill, "moves": False}
    scene["bodies"][1]["velocity"] = [1, 0, 0]
    scene["bodies"][1]["position"] = [0, 0, 0.1]
    file.write_text(json.dumps({**scene, "expect": [], "duration": 0.5}))
    return str(file)


def test_the_last_line_says_that_the_tolerance_was_kept(contact: Run, tmp_path: Path) -> None:
    file = sliding_ball(tmp_path / "slides.json")
    done = contact("simulate", file, "--strict")
    assert done.returncode == 0, done.stderr
    last = done.stdout.splitlines()[-1].strip()
    assert last == "The tolerance of 1e-06 m: kept in the whole run, by an estimate."


def test_the_last_line_says_since_when_there_is_no_bound(contact: Run, tmp_path: Path) -> None:
    file = rolling_on_a_ball(tmp_path / "hill.json")
    last = contact("simulate", file).stdout.splitlines()[-1]
    assert "not known to be kept: a contact force varies within a step" in last


@pytest.mark.parametrize("words", [(), ("--json",)])
def test_strict_fails_if_a_part_has_no_bound(
    contact: Run, tmp_path: Path, words: tuple[str, ...]
) -> None:
    file = rolling_on_a_ball(tmp_path / "hill.json")
    assert contact("simulate", file, *words).returncode == 0
    assert contact("simulate", file, "--strict", *words).returncode == 1


def test_json_says_until_when_the_tolerance_was_kept(contact: Run, tmp_path: Path) -> None:
    def tolerance(file: str) -> Json:
        result: Json = json.loads(contact("simulate", file, "--json").stdout)["tolerance"]
        return result

    kept = tolerance(sliding_ball(tmp_path / "slides.json"))
    assert kept == {"asked": 1e-06, "kept_until": 2, "by": "estimated", "why": None}
    lost = tolerance(rolling_on_a_ball(tmp_path / "hill.json"))
    assert lost["by"] == "not known"
    assert lost["kept_until"] == 0
    assert "varies" in lost["why"]
    free = tolerance(sliding_ball(tmp_path / "order.json", tolerance={"event_order": True}))
    assert free["asked"] is None
    assert free["by"] == "not asked"


def test_what_flies_freely_keeps_the_tolerance_by_proof(contact: Run, tmp_path: Path) -> None:
    scene = of_book("sliding_then_rolling")
    del scene["bodies"][0]
    file = tmp_path / "falls.json"
    file.write_text(json.dumps({**scene, "expect": []}))
    last = contact("simulate", str(file)).stdout.splitlines()[-1].strip()
    assert last == "The tolerance of 1e-06 m: kept in the whole run, proven."


def test_a_resumed_run_knows_what_was_before(contact: Run, tmp_path: Path) -> None:
    file = rolling_on_a_ball(tmp_path / "hill.json")
    state = str(tmp_path / "state.json")
    whole = json.loads(contact("simulate", file, "--json").stdout)
    assert contact("simulate", file, "--until", "0.4", "--checkpoint", state).returncode == 0
    resumed = json.loads(contact("simulate", file, "--resume", state, "--json").stdout)
    assert resumed["tolerance"] == whole["tolerance"]
