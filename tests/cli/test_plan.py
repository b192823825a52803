"""plan: what the table says of scenes, by meaning, and how it is overridden."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]

Run = Callable[..., subprocess.CompletedProcess[str]]

EFFECTS = (
    "gravity",
    "rotation",
    "gyroscopic-term",
    "friction",
    "restitution",
    "continuous-detection",
    "broad-phase",
    "several-contacts",
    "resting",
    "sleeping",
    "penalty-contact",
    "third-dimension",
    "second-dimension",
    "double-precision",
    "event-driven",
    "step-size",
    "horizon",
)


def decisions(contact: Run, *words: str) -> dict[str, dict[str, Any]]:
    done = contact("plan", *words, "--json")
    assert done.returncode == 0, done.stderr
    plan = json.loads(done.stdout)
    assert plan["format"] == "contact-plan/1"
    found = {one["effect"]: one for one in plan["decisions"]}
    assert tuple(found) == EFFECTS
    return found


@pytest.mark.parametrize(
    ("scene", "on", "off"),
    [
        (
            "bouncing_ball",  # straight down; it rests only after the scene's end
            "gravity restitution event-driven",
            "rotation friction resting third-dimension second-dimension horizon",
        ),
        (
            "billiards_break",  # flat, smooth, elastic
            "restitution event-driven horizon second-dimension",
            "gravity rotation friction resting third-dimension",
        ),
        (
            "bullet_and_wall",  # too fast for its steps, on a line
            "continuous-detection restitution step-size",
            "gravity rotation friction second-dimension event-driven",
        ),
        (
            "stack_of_ten",  # exactly on top of each other
            "gravity resting sleeping several-contacts",
            "rotation friction restitution second-dimension event-driven",
        ),
        (
            "tennis_racket",  # touches nothing, turns over
            "rotation gyroscopic-term",
            "gravity friction restitution continuous-detection resting",
        ),
        (
            "penalty_trampoline",  # gives way
            "gravity penalty-contact step-size",
            "restitution resting rotation event-driven",
        ),
    ],
)
def test_a_scene_calls_for_what_is_known_of_it(contact: Run, scene: str, on: str, off: str) -> None:
    found = decisions(contact, scene)
    assert [name for name in on.split() if not found[name]["on"]] == []
    assert [name for name in off.split() if found[name]["on"]] == []
    for one in found.values():
        assert one["why"]
        assert one["planned"] == one["on"]
        if one["proven"]:
            assert all(condition["holds"] for condition in one["because"])
    summary = contact("plan", scene).stdout
    table = contact("plan", scene, "--explain").stdout
    for text in (summary, table):
        for name, one in found.items():
            (line,) = (line for line in text.splitlines() if line.startswith(name + " "))
            if one["value"] is None:
                assert line.split()[1].strip(",") == ("on" if one["on"] else "off")
    # The long form shows both sides of the deciding inequality, in words.
    joined = " ".join(table.split())
    for one in found.values():
        for condition in one["because"]:
            if condition["relation"] != "=":
                assert condition["left_is"] in joined
                assert condition["right_is"] in joined


SCENES = sorted(file.stem for file in (ROOT / "chapters/20_scenes/scenes").glob("*.json"))


@pytest.mark.parametrize("scene", SCENES)
def test_a_summary_fits_a_terminal(contact: Run, scene: str) -> None:
    done = contact("plan", scene)
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert len(lines) <= 25
    assert max(map(len, lines)) <= 80
    assert "…" not in done.stdout  # nothing was cut
    assert [line.split()[0] for line in lines if line.split()[0] in EFFECTS] == list(EFFECTS)
    long = contact("plan", scene, "--explain").stdout
    assert max(map(len, long.splitlines())) <= 80


@pytest.mark.parametrize(
    ("scene", "effect", "says"),
    [
        # What fails, of an effect that is on; what holds, of one that is off.
        ("bouncing_ball", "gravity", "gravity is 10 m/s²"),
        ("bouncing_ball", "third-dimension", "symmetry: nothing moves along y"),
        ("billiards_break", "gravity", "there is no gravity"),
        ("bullet_and_wall", "gravity", "there is no gravity"),
        ("bullet_and_wall", "friction", "bodies that may meet are smooth: μ = 0"),
        ("stack_of_ten", "restitution", "nothing rebounds: e = 0"),
        ("sliding_block", "friction", "there is friction: μ up to"),
        ("tennis_racket", "friction", "bodies that may meet are smooth: μ = 0"),
    ],
)
def test_a_summary_says_what_decided(contact: Run, scene: str, effect: str, says: str) -> None:
    lines = contact("plan", scene).stdout.splitlines()
    (line,) = (line for line in lines if line.startswith(effect + " "))
    assert says in line


def test_one_effect_is_explained_alone(contact: Run) -> None:
    whole = contact("plan", "bouncing_ball", "--explain").stdout
    alone = contact("plan", "bouncing_ball", "--explain", "gravity").stdout
    assert alone.splitlines()[0].split()[:2] == ["gravity", "on"]
    assert "balls that lie" not in alone
    assert "1 ball does not lie on a level floor" in alone
    assert alone.strip() in whole
    assert "friction" not in [line.split()[0] for line in alone.splitlines()]
    # The scene may stand where an effect might.
    assert contact("plan", "--explain", "bouncing_ball").stdout == whole


@pytest.mark.parametrize("switch", ["--with", "--without"])
@pytest.mark.parametrize("effect", EFFECTS[:-3])
def test_what_changes_nothing_says_so_and_has_no_cost(
    contact: Run, switch: str, effect: str
) -> None:
    def run(*words: str) -> dict[str, Any]:
        done = contact("simulate", "billiards_break", "--until", "0.05", "--json", *words)
        assert done.returncode == 0, done.stderr
        report = json.loads(done.stdout)
        return {key: report[key] for key in ("stages", "effects", "bytes_per_state", "energy")}

    words = ("billiards_break", switch, effect)
    says_so = bool(decisions(contact, *words)[effect]["changes_nothing"])
    text = " ".join(contact("plan", *words, "--explain", effect).stdout.split())
    assert ("changes nothing here: " in text) == says_so
    if says_so:
        assert run() == run(switch, effect)
        assert "instructions" not in text


def test_what_was_measured_to_change_nothing_saves_nothing(contact: Run) -> None:
    text = " ".join(
        contact(
            "plan", "billiards_break", "--measure", "--explain", "third-dimension"
        ).stdout.split()
    )
    assert "Measured: the run with it has the same stages" in text
    assert "Switching it changes nothing here" in text
    assert "aves" not in text


@pytest.mark.parametrize("scene", ["hail", "billiards_break"])
def test_the_errors_together_stand_beside_the_tolerance(contact: Run, scene: str) -> None:
    plan = json.loads(contact("plan", scene, "--json").stdout)
    assert plan["error"] <= plan["tolerance"]
    assert plan["error"] == pytest.approx(sum(one["error"] for one in plan["decisions"]))
    assert (plan["error"] > 0) == (scene != "billiards_break")
    (line,) = (
        line for line in contact("plan", scene).stdout.splitlines() if line.startswith("Sum of")
    )
    numbers = [float(word) for word in line.split() if word[0].isdigit()]
    assert numbers == pytest.approx([plan["error"], plan["tolerance"]], rel=1e-3)
    # An effect that is forced off although the plan has it on makes an error without a bound.
    forced = contact("plan", "bouncing_ball", "--without", "gravity", "--json")
    assert json.loads(forced.stdout)["error"] is None


def test_where_bodies_lie_on_each_other_the_sum_has_no_bound(contact: Run) -> None:
    plan = json.loads(contact("plan", "stack_of_ten", "--json").stdout)
    endless = [one["effect"] for one in plan["decisions"] if one["error"] is None]
    assert endless == ["sleeping"]  # nothing bounces in it, so no bounce is left out
    assert plan["error"] is None
    text = contact("plan", "stack_of_ten", "--explain").stdout
    assert "Sum of the errors accepted: no bound." in text.splitlines()
    assert "Error accepted: no bound, a sleeping body may be balanced" in " ".join(text.split())


def test_a_step_shows_what_passes_through(contact: Run) -> None:
    found = decisions(contact, "bullet_and_wall", "--step", "0.0166")
    (first, *_) = found["continuous-detection"]["because"]
    assert found["continuous-detection"]["on"]
    assert not first["holds"]
    assert first["left"] == pytest.approx(900 * 0.0166)
    assert first["right"] == pytest.approx(2 * (0.005 + 0.004))
    assert not found["event-driven"]["on"]
    assert found["step-size"]["value"] == 0.0166


def test_an_override_stands_beside_what_the_plan_says(contact: Run) -> None:
    words = ("bouncing_ball", "--with", "rotation", "--without", "gravity")
    found = decisions(contact, *words)
    assert found["rotation"]["on"]
    assert not found["rotation"]["planned"]
    assert found["rotation"]["overridden"]
    assert not found["gravity"]["on"]
    assert found["gravity"]["planned"]
    table = contact("plan", *words, "--explain").stdout
    assert "forced; the plan says off" in table
    assert "forced; the plan says on" in table
    assert "Without gravity" in table


def test_without_detection_between_steps_the_bullet_tunnels(contact: Run) -> None:
    def bullet(*words: str) -> dict[str, float]:
        done = contact("simulate", "bullet_and_wall", "--expect", "--json", *words)
        report = json.loads(done.stdout)
        assert report["end"] == "complete"
        return {one["quantity"]: one["got"] for one in report["expectations"]}

    stopped = bullet()
    assert stopped["events"] == 1
    assert stopped["velocity.x"] == -225
    through = bullet("--without", "continuous-detection")
    assert through["events"] == 0
    assert through["velocity.x"] == 900
    assert through["position.x"] == pytest.approx(-9.099 + 900 * 0.02)


@pytest.mark.parametrize(
    ("words", "named"),
    [
        (("bouncing_ball", "--with", "gravitas"), "gravitas"),
        (("bouncing_ball", "--without", "horizon"), "horizon"),
        (("bouncing_ball", "--with", "gravity", "--without", "gravity"), "gravity"),
        (("bouncing_ball", "--step", "0"), "--step 0"),
        (("bouncing_ball", "--step", "-1"), "--step -1"),
        (("bouncing_bal",), "bouncing_bal"),
        (("bouncing_ball", "--explain", "gravitas"), "gravitas"),
        ((), "SCENE is required"),
    ],
)
def test_what_is_not_understood_is_named(contact: Run, words: tuple[str, ...], named: str) -> None:
    done = contact("plan", *words)
    assert done.returncode == 2
    assert named in done.stderr
    assert done.stdout == ""


@pytest.mark.parametrize(
    "words",
    [
        ("bouncing_ball", "--with", "x" * 5000),
        ("bouncing_ball", "--explain", "x" * 5000),
        ("bouncing_ball", "--step", "x" * 5000),
        ("x" * 5000,),
    ],
)
def test_of_a_long_word_an_error_shows_the_beginning(contact: Run, words: tuple[str, ...]) -> None:
    done = contact("plan", *words)
    assert done.returncode == 2
    assert "x" * 100 in done.stderr
    assert "x" * 201 not in done.stderr


def test_a_scene_with_a_fault_has_no_plan(contact: Run, tmp_path: Path) -> None:
    file = tmp_path / "broken.json"
    file.write_text('{"format": "contact-scene/1"}')
    done = contact("plan", str(file))
    assert done.returncode == 1
    assert "broken.json" in done.stderr
    assert done.stdout == ""


def test_each_effect_is_measured_the_other_way_round(contact: Run) -> None:
    found = decisions(contact, "sliding_block", "--measure")
    for effect, decision in found.items():
        assert ("measured" in decision) == (effect != "step-size")
    rotation = found["rotation"]["measured"]
    assert rotation["planned_seconds"] > 0
    assert rotation["other_seconds"] > 0
    # An orientation is four numbers, and a spin in a plane is one.
    assert rotation["planned_bytes"] - rotation["other_bytes"] == 5 * 8
    # Of place and velocity a third number, and of a spin two more.
    space = found["third-dimension"]["measured"]
    assert space["other_bytes"] - space["planned_bytes"] == 4 * 8
    assert found["double-precision"]["measured"]["same_stages"]
    assert "measured" not in decisions(contact, "sliding_block")["rotation"]


def test_a_horizon_is_measured_by_a_run_that_begins_an_ulp_away(contact: Run) -> None:
    spheres = decisions(contact, "elastic_spheres", "--measure")["horizon"]
    parted = spheres["measured"]
    assert parted["diverged"]
    assert parted["apart"] > parted["allowed"] == 0.5  # there is no tolerance: a radius
    assert spheres["value"] < parted["time"] < 5 / 3
    calm = decisions(contact, "sliding_block", "--measure")["horizon"]["measured"]
    assert not calm["diverged"]
    assert 0 < calm["apart"] <= calm["allowed"]
    assert calm["time"] == 1


def test_the_table_says_what_was_measured(contact: Run) -> None:
    done = contact("plan", "thrown_stone", "--measure")
    assert done.returncode == 0, done.stderr
    text = " ".join(done.stdout.split())
    assert "of processor time a second as planned" in text
    assert "a run that begins an ulp away" in text
