"""contact simulate: what it runs, what it writes, and what it refuses."""

from __future__ import annotations

import csv
import json
import math
import os
import re
import signal
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

Run = Callable[..., subprocess.CompletedProcess[str]]
Json = dict[str, Any]

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build" / "dev" / "bin" / "contact"


def of_book(name: str) -> Json:
    scene: Json = json.loads((ROOT / f"chapters/20_scenes/scenes/{name}.json").read_text())
    return scene


@pytest.fixture
def gas(tmp_path: Path) -> Path:
    """The book's gas, shorter."""
    file = tmp_path / "gas.json"
    scene = of_book("gas_in_a_box")
    scene["expect"] = []
    file.write_text(json.dumps(scene))
    return file


def test_the_books_scenes_come_out_as_expected(contact: Run) -> None:
    folder = ROOT / "chapters" / "20_scenes" / "scenes"
    # For ten thousand balls with friction and for twenty dominoes the test below runs only the
    # beginning.
    names = sorted({file.stem for file in folder.glob("*.json")} - {"ball_pit", "dominoes"})
    done = contact("simulate", *names, "--expect", "--json")
    assert done.returncode == 0, (done.stdout, done.stderr)
    results = json.loads(done.stdout)
    assert [result["scene"] for result in results] == names
    for result in results:
        assert result["format"] == "contact-simulate/1"
        assert result["end"] == "complete"
        assert result["expectations"]
        assert all(entry["met"] for entry in result["expectations"]), result


def test_what_takes_long_comes_out_as_expected_as_far_as_anything_is(contact: Run) -> None:
    for name, until in (("ball_pit", "0.2"), ("dominoes", "1.2")):
        done = contact("simulate", name, "--until", until, "--expect", "--json")
        assert done.returncode == 0, (done.stdout, done.stderr)
        result = json.loads(done.stdout)
        assert result["hits"] > 100
        assert all(entry["met"] for entry in result["expectations"]), result


def test_energy_stays_and_nothing_overlaps(contact: Run) -> None:
    result = json.loads(contact("simulate", "gas_in_a_box", "--json").stdout)
    first, last = result["energy"]["first"], result["energy"]["last"]
    assert abs(last - first) <= 1e-12 * abs(first)
    assert result["largest_overlap"] <= 1e-12
    assert result["hits"] > 0


def test_what_did_not_come_out_is_said(contact: Run, tmp_path: Path) -> None:
    scene = of_book("newtons_cradle")
    scene["expect"][0]["value"] = 7
    file = tmp_path / "wrong.json"
    file.write_text(json.dumps(scene))
    done = contact("simulate", str(file), "--expect")
    assert done.returncode == 1
    assert "not expected" in done.stdout
    assert "expected 7" in done.stdout
    # Without --expect it is not tested.
    assert contact("simulate", str(file)).returncode == 0


def test_scenes_that_call_for_steps_come_out_as_expected(contact: Run) -> None:
    for name, stage in (
        ("stack_of_ten", "contact forces"),
        ("penalty_trampoline", "springs"),
        ("sliding_then_rolling", "rotation"),
        ("bullet_and_wall", "time of impact"),
        ("three_at_once", "impacts"),
        ("tennis_racket", "rotation"),
    ):
        done = contact("simulate", name, "--expect", "--json")
        assert done.returncode == 0, (name, done.stdout, done.stderr)
        result = json.loads(done.stdout)
        assert result["end"] == "complete"
        assert not result["event_driven"]
        assert result["step"] > 0
        assert result["effects"] is None
        assert stage in {entry["name"] for entry in result["stages"]}, (name, result)
        assert all(entry["met"] for entry in result["expectations"]), (name, result)


def test_a_stage_that_is_off_is_not_there_and_not_stored(contact: Run) -> None:
    def run(*words: str) -> Json:
        result: Json = json.loads(contact("simulate", "stack_of_ten", "--json", *words).stdout)
        return result

    plain = run("--until", "0.1")
    bare = run("--until", "0.1", "--without", "sleeping", "--without", "gravity")
    turning = run("--until", "0.1", "--with", "rotation")
    names = {entry["name"] for entry in bare["stages"]}
    assert not names & {"sleep", "waking", "gravity", "rotation"}
    assert bare["bytes_per_state"] < plain["bytes_per_state"] < turning["bytes_per_state"]
    finer = run("--until", "0.1", "--step", "0.001")
    assert finer["steps"] == 100
    done = contact("simulate", "stack_of_ten", "--without", "horizon")
    assert done.returncode == 2
    assert "is a value" in done.stderr


def test_a_hull_and_a_ball_are_simulated_together(contact: Run, tmp_path: Path) -> None:
    scene = of_book("thrown_stone")
    scene["expect"] = []
    scene["duration"] = 5
    ball = {
        "name": "ball",
        "shape": {"type": "sphere", "radius": 0.1},
        "material": "rock",
        "mass": 1,
        "position": [3, 0, 1],
    }
    scene["bodies"].append(ball)
    file = tmp_path / "stones.json"
    file.write_text(json.dumps(scene))
    done = contact("simulate", str(file), "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["end"] == "complete"


def test_names_and_options_that_are_none(contact: Run) -> None:
    assert contact("simulate").returncode == 2
    assert contact("simulate", "no_such_scene").returncode == 2
    done = contact("simulate", "head_on", "--output", "out.dat")
    assert done.returncode == 2
    assert ".xyz or .csv" in done.stderr
    for option in ("--until", "--every"):
        for value in ("-3", "nan", "soon", "inf"):
            done = contact("simulate", "head_on", f"{option}={value}")
            assert done.returncode == 2, (option, value)
            words = f"{option} {value}: must be finite and not negative, in seconds"
            assert words in done.stderr, done.stderr


@pytest.mark.parametrize(
    ("scene", "words", "what"),
    [
        ("stack_of_ten", ("--until", "1e15"), "steps"),
        ("head_on", ("--until", "1e13", "--every", "0.5"), "frames"),
        ("head_on", ("--until", "1e31"), "like the duration of a scene"),
    ],
)
def test_a_run_that_could_not_end_is_refused_with_what_to_do(
    contact: Run, scene: str, words: tuple[str, ...], what: str
) -> None:
    done = contact("simulate", scene, *words)
    assert done.returncode == 2
    assert what in done.stderr
    assert "at most" in done.stderr
    assert done.stdout == ""


def test_an_extended_xyz_file_says_where_everything_is(
    contact: Run, gas: Path, tmp_path: Path
) -> None:
    out = tmp_path / "gas.xyz"
    done = contact(
        "simulate", str(gas), "--output", str(out), "--every", "0.25", "--until", "1.1", "--json"
    )
    assert done.returncode == 0, done.stderr
    lines = out.read_text().splitlines()
    count = json.loads(done.stdout)["balls"]
    times = []
    while lines:
        assert int(lines[0]) == count
        assert lines[1].startswith("Properties=species:S:1:pos:R:3:radius:R:1:id:I:1")
        times.append(float(lines[1].split("Time=")[1].split()[0]))
        for line in lines[2 : 2 + count]:
            words = line.split()
            assert words[0] == "X"
            assert all(math.isfinite(float(word)) for word in words[1:])
        lines = lines[2 + count :]
    # Those that are due, and the last.
    assert times == [0, 0.25, 0.5, 0.75, 1, 1.1]


def test_tables_of_places_and_hits(contact: Run, tmp_path: Path) -> None:
    out, hits = tmp_path / "cradle.csv", tmp_path / "hits.csv"
    done = contact(
        "simulate", "newtons_cradle", "--output", str(out), "--events", str(hits), "--json"
    )
    assert done.returncode == 0, done.stderr
    with out.open() as file:
        rows = list(csv.DictReader(file))
    assert {"time", "body", "x", "y", "z"} <= set(rows[0])
    with hits.open() as file:
        events = list(csv.DictReader(file))
    assert len(events) == json.loads(done.stdout)["hits"]
    times = [float(event["time"]) for event in events]
    assert times == sorted(times)
    assert {(event["first"], event["second"]) for event in events} >= {("ball_0", "ball_1")}


def test_a_run_that_was_kept_goes_on_to_the_same_bytes(
    contact: Run, gas: Path, tmp_path: Path
) -> None:
    def files(name: str) -> tuple[Path, Path]:
        return tmp_path / f"{name}.xyz", tmp_path / f"{name}.csv"

    def run(name: str, *words: str) -> Json:
        out, hits = files(name)
        done = contact(
            "simulate",
            *(str(gas), "--output", str(out), "--events", str(hits), "--every", "0.1", "--json"),
            *words,
        )
        result: Json = json.loads(done.stdout)
        return result

    kept = str(tmp_path / "kept.json")
    whole = run("whole", "--until", "2")
    # In pieces: to a time between two frames, until a budget of hits runs out, and to the end.
    run("pieces", "--until", "0.55", "--checkpoint", kept)
    cut = run(
        "pieces", "--resume", kept, "--checkpoint", kept, "--max-events", "50", "--until", "2"
    )
    assert cut["end"] == "out_of_events"
    # What a killed run had written after its checkpoint does not stay.
    with files("pieces")[0].open("a") as file:
        file.write("half a li")
    pieces = run("pieces", "--resume", kept, "--until", "2")
    assert pieces["end"] == whole["end"] == "complete"
    assert pieces["hits"] == whole["hits"]
    for one, other in zip(files("whole"), files("pieces"), strict=True):
        assert one.read_bytes() == other.read_bytes()
    # And again: the same bytes each time.
    run("again", "--until", "2")
    assert files("again")[0].read_bytes() == files("whole")[0].read_bytes()


def test_a_checkpoint_of_another_scene_or_of_nothing_is_refused(
    contact: Run, gas: Path, tmp_path: Path
) -> None:
    kept = tmp_path / "kept.json"
    assert contact("simulate", "head_on", "--checkpoint", str(kept)).returncode == 0
    done = contact("simulate", str(gas), "--resume", str(kept))
    assert done.returncode == 3
    assert "another scene" in done.stderr
    kept.write_text("{}")
    done = contact("simulate", str(gas), "--resume", str(kept))
    assert done.returncode == 3
    assert "not a checkpoint" in done.stderr


def test_a_budget_that_runs_out_is_said(contact: Run, gas: Path) -> None:
    done = contact("simulate", str(gas), "--max-events", "3")
    assert done.returncode == 3
    assert "the budget of 3 hits ran out" in done.stderr


@pytest.mark.parametrize("option", ["--max-events", "--event-budget"])
@pytest.mark.parametrize("number", ["-3", "0", "1.5", "many"])
def test_a_budget_is_a_whole_number(contact: Run, gas: Path, option: str, number: str) -> None:
    done = contact("simulate", str(gas), f"{option}={number}")
    assert done.returncode == 2
    assert f"{option}: {number} is not a whole number from 1" in done.stderr


def test_looking_between_steps_spends_no_budget(contact: Run, tmp_path: Path) -> None:
    # Frames fall between steps, also in the step of the first hits.
    out = tmp_path / "frames.csv"
    words = ("simulate", "bowling", "--until", "3.6", "--every", "0.01", "--output", str(out))
    done = contact(*words, "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["end"] == "complete"
    assert json.loads(done.stdout)["hits"] > 1
    done = contact(*words, "--max-events", "1", "--json")
    assert done.returncode == 3
    assert json.loads(done.stdout)["end"] == "out_of_events"


def rubbing_ball(tmp_path: Path) -> Path:
    """It falls 10 m in √2 s onto a floor with friction, so it goes step by step."""
    scene = of_book("high_drop") | {"expect": [], "duration": 2}
    scene["materials"] = [scene["materials"][0] | {"restitution": 0.5, "friction": 0.25}]
    balls = [body for body in scene["bodies"] if body["shape"].get("type") == "sphere"]
    balls[0]["velocity"] = [1, 0, 0]
    file = tmp_path / "rubbing.json"
    file.write_text(json.dumps(scene))
    return file


def test_hits_of_a_step_that_is_not_done_are_in_the_table(contact: Run, tmp_path: Path) -> None:
    hits = tmp_path / "hits.csv"
    words = ("--until", "1.475", "--step", "0.1", "--events", str(hits), "--json")
    done = contact("simulate", str(rubbing_ball(tmp_path)), *words)
    assert done.returncode == 0, done.stderr
    with hits.open() as file:
        events = list(csv.DictReader(file))
    assert json.loads(done.stdout)["hits"] == len(events) == 1
    assert abs(float(events[0]["time"]) - 2**0.5) < 1e-12


def test_who_goes_on_past_the_scenes_end_has_a_plan_for_as_long(
    contact: Run, tmp_path: Path
) -> None:
    file = rubbing_ball(tmp_path)
    scene = json.loads(file.read_text()) | {"duration": 0.5}  # nothing meets anything until then
    file.write_text(json.dumps(scene))
    assert json.loads(contact("simulate", str(file), "--json").stdout)["hits"] == 0
    done = contact("simulate", str(file), "--until", "2", "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["hits"] == 1


def test_where_hits_do_not_end_steps_take_over(contact: Run, tmp_path: Path) -> None:
    scene = of_book("high_drop")
    scene["expect"] = []
    scene["duration"] = 10
    for material in scene["materials"]:
        material["restitution"] = 0.5
    balls = [body for body in scene["bodies"] if body["shape"].get("type") == "sphere"]
    upper = json.loads(json.dumps(balls[0]))
    upper["name"] = "upper"
    upper["position"][2] += 3
    scene["bodies"].append(upper)
    file = tmp_path / "pile.json"
    file.write_text(json.dumps(scene))
    # The planner cannot prove that the impacts end, so it steps; forced event by event, the run
    # reports when they end.
    planned = json.loads(contact("simulate", str(file), "--json").stdout)
    assert not planned["event_driven"]
    assert planned["fallback"] is None
    for words in ((), ("--event-budget", "2")):
        done = contact("simulate", str(file), "--with", "event-driven", "--json", *words)
        assert done.returncode == 0, done.stdout + done.stderr
        forced = json.loads(done.stdout)
        assert forced["end"] == "complete"
        assert not forced["event_driven"]
        assert 0 < forced["fallback"]["time"] < 10
        assert ("budget of 2 hits" if words else "again and again") in forced["fallback"]["why"]
    told = contact("simulate", str(file), "--with", "event-driven")
    assert "step by step from" in told.stdout


def test_a_stepped_run_that_was_kept_goes_on_to_the_same_bytes(
    contact: Run, tmp_path: Path
) -> None:
    kept = str(tmp_path / "kept.json")

    def run(name: str, *words: str) -> subprocess.CompletedProcess[str]:
        out, hits = tmp_path / f"{name}.csv", tmp_path / f"{name}_hits.csv"
        return contact(
            "simulate",
            *("bowling", "--output", str(out), "--events", str(hits), "--every", "0.07"),
            *words,
        )

    assert run("whole", "--until", "3.6").returncode == 0
    assert run("pieces", "--until", "3.45", "--checkpoint", kept).returncode == 0
    # The end of a run is a frame that is not due: it is cut off again.
    assert run("pieces", "--resume", kept, "--until", "3.6").returncode == 0
    for name in ("", "_hits"):
        one, other = tmp_path / f"whole{name}.csv", tmp_path / f"pieces{name}.csv"
        assert one.read_bytes() == other.read_bytes()
    heading = (tmp_path / "whole.csv").read_text().splitlines()[0]
    assert heading == "time,body,x,y,z,qx,qy,qz,qw"
    done = run("pieces", "--resume", kept, "--without", "friction")
    assert done.returncode == 3
    assert "another plan" in done.stderr


def test_ctrl_c_keeps_what_is_done(
    gas: Path, tmp_path: Path, environment: dict[str, str], contact: Run
) -> None:
    scene = json.loads(gas.read_text())
    scene["duration"] = 1e6
    gas.write_text(json.dumps(scene))
    kept, hits = tmp_path / "kept.json", tmp_path / "hits.csv"
    words = [str(PROGRAM), "simulate", str(gas), "--events", str(hits), "--checkpoint", str(kept)]
    with subprocess.Popen(
        words, env={**os.environ, **environment}, stderr=subprocess.PIPE, text=True
    ) as process:
        for _ in range(600):
            if hits.exists() and hits.stat().st_size > 100000:
                break
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
    assert process.returncode == 130, errors
    assert "Stopped at" in errors
    done = contact("simulate", str(gas), "--resume", str(kept), "--max-events", "10", "--json")
    assert json.loads(done.stdout)["hits"] == len(hits.read_text().splitlines()) - 1 + 10


def without_times(result: Json) -> Json:
    return {key: value for key, value in result.items() if key != "seconds"}


def test_several_scenes_come_out_as_each_alone(contact: Run) -> None:
    names = ["gas_in_a_box", "head_on", "sliding_block", "hail"]
    together = contact("simulate", *names, "--jobs", "2", "--json")
    assert together.returncode == 0, together.stderr
    results = json.loads(together.stdout)
    assert [result["scene"] for result in results] == names
    for name, result in zip(names, results, strict=True):
        alone = json.loads(contact("simulate", name, "--json").stdout)
        assert without_times(result) == without_times(alone)


def test_on_a_terminal_long_runs_tell_how_far_they_have_come(
    on_a_terminal: Callable[..., str], gas: Path
) -> None:
    said = on_a_terminal("stderr", "simulate", str(gas), str(gas), "--jobs", "2", "--until", "600")
    lines = said.split("\r")
    name = json.loads(gas.read_text())["name"]
    progress = rf"0 of 2 done; {name} [\d.]+ of 600 s, \d+ hits"
    assert any(re.match(progress, line) for line in lines)
    assert lines[-1].strip() == ""  # the line is taken away at the end
    assert all(len(line) < 80 for line in lines)


def test_on_a_terminal_measuring_tells_of_which_effect(
    on_a_terminal: Callable[..., str], gas: Path
) -> None:
    said = on_a_terminal("stderr", "plan", str(gas), "--measure")
    assert "measuring gravity" in said
    assert "measuring event-driven" in said
    assert said.split("\r")[-1].strip() == ""


def test_several_scenes_are_told_of_in_the_order_given(contact: Run) -> None:
    done = contact("simulate", "sliding_block", "head_on", "hail")
    heads = [line.split(":")[0] for line in done.stdout.splitlines() if not line.startswith(" ")]
    assert heads == ["sliding_block", "head_on", "hail"]


def test_of_several_scenes_one_that_does_not_come_out_leaves_the_others(
    contact: Run, tmp_path: Path
) -> None:
    scene = of_book("head_on")
    scene["expect"][0]["value"] = 1000
    wrong = tmp_path / "wrong.json"
    wrong.write_text(json.dumps(scene))
    done = contact("simulate", str(wrong), "hail", "--expect")
    assert done.returncode == 1
    assert "not expected" in done.stdout
    assert "hail: all bodies fly freely" in done.stdout


@pytest.mark.parametrize("option", ["--output", "--events", "--checkpoint", "--resume"])
def test_a_file_is_for_one_scene(contact: Run, tmp_path: Path, option: str) -> None:
    file = tmp_path / "file.csv"
    done = contact("simulate", "head_on", "hail", option, str(file))
    assert done.returncode == 2
    assert f"{option} is for one scene, and 2 are given" in done.stderr
    assert not file.exists()


def test_what_flies_freely_goes_on_from_a_checkpoint(contact: Run, tmp_path: Path) -> None:
    kept, whole, parts = tmp_path / "kept.json", tmp_path / "whole.csv", tmp_path / "parts.csv"
    contact("simulate", "thrown_stone", "--output", str(whole))
    half = ["--output", str(parts), "--checkpoint", str(kept)]
    contact("simulate", "thrown_stone", "--until", "0.95", *half)
    contact("simulate", "thrown_stone", "--resume", str(kept), "--output", str(parts))
    assert parts.read_bytes() == whole.read_bytes()


@pytest.mark.parametrize("jobs", ["0", "-3", "two"])
def test_jobs_that_are_no_number_of_scenes_are_refused(contact: Run, jobs: str) -> None:
    done = contact("simulate", "hail", "head_on", "--jobs", jobs)
    assert done.returncode == 2
    assert "--jobs" in done.stderr
    assert jobs in done.stderr
    assert done.stdout == ""
