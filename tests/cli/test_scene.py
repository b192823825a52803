"""scene: the published schema and the reader agree on every file, and faults are reported well."""

from __future__ import annotations

import copy
import json
import random
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

Run = Callable[..., subprocess.CompletedProcess[str]]
Json = Any
ROOT = Path(__file__).resolve().parents[2]
CHAPTER = ROOT / "chapters" / "20_scenes"
SCENES = sorted((CHAPTER / "scenes").glob("*.json"))
SCHEMA = json.loads((CHAPTER / "scene.schema.json").read_text())
VALIDATOR = Draft202012Validator(SCHEMA)
SPECIMEN = (ROOT / "tests" / "20_scenes" / "specimen.json").read_text()
FAULTS = json.loads((ROOT / "tests" / "20_scenes" / "scene_faults.json").read_text())["faults"]

# What a schema cannot see: words of the fault's message. Everything else must be seen by both.
UNSEEN = [
    "appears twice",  # a JSON parser keeps one of two equal keys
    "must not be the name of another material too",
    "must not be the name of another body too",
    "must be the name of a material",
    "must be the name of a body",
    "must have length 1",
    "do not lie in a plane",
    "centre of mass at the body's origin",
    "must give a mass",
    "must not overlap",
    "must not make more than",
    "must not make the scene larger",
    "to the duration",
]
# Of repeated bodies also what only a copy is: its place too far out, its name too long.
UNSEEN_OF_COPIES = ["must be from -1e+30 to 1e+30", "must be 1 to 64 of the characters"]


def refuse_constant(word: str) -> float:
    raise ValueError(f"{word} is not JSON")


def schema_accepts(text: str) -> bool:
    try:
        document = json.loads(text, parse_constant=refuse_constant)
    except ValueError:
        return False
    return bool(VALIDATOR.is_valid(document))


def patched(document: Json, patch: list[dict[str, Any]]) -> Json:
    """A JSON patch of additions, replacements and removals."""
    document = copy.deepcopy(document)
    for step in patch:
        *way, last = [part for part in step["path"].split("/") if part]
        place = document
        for part in way:
            place = place[int(part)] if isinstance(place, list) else place[part]
        key: Any = int(last) if isinstance(place, list) else last
        if step["op"] == "remove":
            del place[key]
        else:
            assert isinstance(place, dict) or step["op"] == "replace"
            place[key] = step["value"]
    return document


def broken(entry: dict[str, Any]) -> str:
    if "patch" in entry:
        return json.dumps(patched(json.loads(SPECIMEN), entry["patch"]), indent=1)
    old, new = entry["text"]
    assert old in SPECIMEN
    return SPECIMEN.replace(old, new, 1)


def reader_says(contact: Run, folder: Path, texts: list[str]) -> list[dict[str, Any]]:
    files = []
    for number, text in enumerate(texts):
        file = folder / f"scene_{number}.json"
        file.write_text(text)
        files.append(str(file))
    done = contact("scene", "check", "--json", *files)
    assert done.returncode in (0, 1), done.stderr
    document = json.loads(done.stdout)
    assert document["format"] == "contact-scene-check/1"
    assert [scene["file"] for scene in document["scenes"]] == files
    assert (done.returncode == 0) == all(scene["ok"] for scene in document["scenes"])
    return list(document["scenes"])


def unseen(fault: dict[str, Any]) -> bool:
    allowed = fault["allowed"]
    return any(words in allowed for words in UNSEEN) or (
        allowed.endswith(")") and any(words in allowed for words in UNSEEN_OF_COPIES)
    )


def test_the_schema_is_one_and_says_what_everything_is() -> None:
    Draft202012Validator.check_schema(SCHEMA)

    def visit(node: Json, where: str) -> Iterator[str]:
        if node.get("type") == "object" and "properties" in node:
            assert node.get("additionalProperties") is False, f"{where} is not closed"
            for name, part in node["properties"].items():
                plain = set(part) <= {"const"} or "title" in part or "$ref" in part
                assert plain, f"{where}.{name} has no title"
        for key, value in node.items():
            if key == "if":  # a condition, and no part of the format
                continue
            for part in value if isinstance(value, list) else [value]:
                if isinstance(part, dict):
                    yield from visit(part, key)
        yield where

    assert len(list(visit(SCHEMA, "scene"))) > 50


@pytest.mark.parametrize("file", SCENES, ids=lambda file: file.stem)
def test_every_scene_of_the_book_fits_the_schema(file: Path) -> None:
    assert [error.message for error in VALIDATOR.iter_errors(json.loads(file.read_text()))] == []


def test_every_scene_of_the_book_is_read(contact: Run) -> None:
    done = contact("scene", "check", *[str(file) for file in SCENES])
    assert done.returncode == 0, done.stdout
    lines = done.stdout.splitlines()
    assert len(lines) == len(SCENES) >= 20
    assert [line.split(":")[0] for line in lines] == [file.stem for file in SCENES]
    (pit,) = [line for line in lines if line.startswith("ball_pit:")]
    assert "10005 bodies (10000 moving), 3 s, positions to 0.01 m" in pit


def test_schema_and_reader_agree_on_every_broken_scene(contact: Run, tmp_path: Path) -> None:
    texts = [SPECIMEN, *map(broken, FAULTS)]
    said = reader_says(contact, tmp_path, texts)
    assert said[0]["ok"]
    assert schema_accepts(SPECIMEN)
    assert len(FAULTS) >= 100
    for entry, text, scene in zip(FAULTS, texts[1:], said[1:], strict=True):
        assert not scene["ok"], entry
        assert any(
            fault["path"] == entry["path"] and entry["says"] in fault["allowed"]
            for fault in scene["faults"]
        ), (entry, scene["faults"])
        assert schema_accepts(text) == (not entry["schema"]), entry
        if not entry["schema"]:
            assert all(map(unseen, scene["faults"])), entry


def places(node: Json, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    children = node.items() if isinstance(node, dict) else enumerate(node)
    for key, child in children:
        yield (*path, key)
        if isinstance(child, dict | list):
            yield from places(child, (*path, key))


def changed(chance: random.Random, document: Json) -> Json:
    """The scene with one to three changes that know nothing of what a scene is."""
    document = copy.deepcopy(document)
    values: list[Json] = [
        *(-1, 0, 1, 2, 0.5, 1e-31, 1e31, -1e30, 3.0, True, False, None, "", "ball", "steel"),
        *("no such name", "speed", "events", "energy", [], {}, [0, 0, 1], [1, 2, 3], [1.5]),
        *({"type": "sphere", "radius": 1}, {"axis": [0, 0, 2], "degrees": 45}),
        {"count": [2, 1, 1], "spacing": [3, 0, 0]},
    ]
    for _ in range(chance.randint(1, 3)):
        all_places = list(places(document))
        *way, last = chance.choice(all_places)
        place = document
        for part in way:
            place = place[part]
        kind = chance.randint(0, 5)
        if kind == 0:
            del place[last]
        elif kind == 1:
            place[last] = copy.deepcopy(chance.choice(values))
        elif kind == 2:
            if isinstance(place[last], int | float) and not isinstance(place[last], bool):
                place[last] *= chance.choice([-1, 0, 0.5, 1 + 1e-9, 2, 1e20])
        elif kind == 3:
            if isinstance(place, dict):
                known = {path[-1] for path in all_places if isinstance(path[-1], str)}
                place[chance.choice([*sorted(known), "extra"])] = copy.deepcopy(
                    chance.choice(values)
                )
            else:
                place.append(copy.deepcopy(place[last]))
        elif kind == 4:
            if isinstance(place, dict):
                place[str(last)[:-1] + "_"] = place.pop(last)
        else:
            *other_way, other = chance.choice(all_places)
            source = document
            try:
                for part in other_way:
                    source = source[part]
                place[last] = copy.deepcopy(source[other])
            except (KeyError, IndexError, TypeError):
                continue
        if not document:
            break
    return document


def test_schema_and_reader_agree_on_random_changes(contact: Run, tmp_path: Path) -> None:
    chance = random.Random(20)
    originals = [json.loads(SPECIMEN)] * 20 + [
        json.loads(file.read_text()) for file in SCENES if file.stem != "ball_pit"
    ]
    texts = [json.dumps(changed(chance, chance.choice(originals))) for _ in range(1000)]
    accepted = refused = beyond = 0
    for text, scene in zip(texts, reader_says(contact, tmp_path, texts), strict=True):
        if schema_accepts(text):
            if scene["ok"]:
                accepted += 1
            else:
                assert all(map(unseen, scene["faults"])), (text, scene["faults"])
                beyond += 1
        else:
            assert not scene["ok"], (text, list(VALIDATOR.iter_errors(json.loads(text))))
            refused += 1
    assert accepted > 50
    assert refused > 300
    assert beyond > 20


def test_a_broken_scene_is_told_with_file_line_path_value_and_what_is_allowed(
    contact: Run, tmp_path: Path
) -> None:
    file = tmp_path / "broken.json"
    file.write_text(
        SPECIMEN.replace('"mass": 2,', '"mass": -2,').replace('"events"', '"evnets"', 1)
    )
    good = SCENES[0]
    done = contact("scene", "check", str(file), str(good))
    assert done.returncode == 1
    first, second, third = done.stdout.splitlines()
    line = 1 + SPECIMEN[: SPECIMEN.index('"mass": 2')].count("\n")
    assert first == (
        f"{file}:{line}: bodies[1].mass = -2: must be greater than 0, from 1e-30 to 1e+30 kg"
    )
    assert 'output.evnets = true: is an unknown key; did you mean "events"?' in second
    assert third.startswith(good.stem + ": ")


def test_a_scene_of_the_book_is_found_by_its_name(contact: Run) -> None:
    done = contact("scene", "check", "newtons_cradle", "--json")
    assert done.returncode == 0
    (scene,) = json.loads(done.stdout)["scenes"]
    assert (scene["name"], scene["bodies"], scene["moving"]) == ("newtons_cradle", 5, 5)
    assert (scene["duration"], scene["position_tolerance"], scene["event_order"]) == (
        3,
        1e-12,
        True,
    )


def test_a_name_that_is_no_scene_is_not_understood(contact: Run, tmp_path: Path) -> None:
    done = contact("scene", "check", "newton_cradle")
    assert done.returncode == 2
    assert "newtons_cradle" in done.stderr
    assert contact("scene", "check", str(tmp_path / "none.json")).returncode == 2
    assert contact("scene", "check").returncode == 2
    assert contact("scene").returncode == 2


def test_what_cannot_be_read_is_trouble(contact: Run, tmp_path: Path) -> None:
    done = contact("scene", "check", str(tmp_path))
    assert done.returncode == 3
    assert f"{tmp_path}: cannot be read" in done.stderr


def test_list_names_every_scene_and_what_it_is(contact: Run) -> None:
    done = contact("scene", "list")
    assert done.returncode == 0
    for file in SCENES:
        assert f"\n{file.stem} " in "\n" + done.stdout
    listed = contact("scene", "list", "--json")
    document = json.loads(listed.stdout)
    assert document["format"] == "contact-scene-list/1"
    assert [scene["name"] for scene in document["scenes"]] == [file.stem for file in SCENES]
    for scene, file in zip(document["scenes"], SCENES, strict=True):
        assert scene["about"] == json.loads(file.read_text())["about"]
        assert scene["expectations"] > 0
