"""The page's own code: it and the program take each other's archives, and merge alike."""

from __future__ import annotations

import json
import random
import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
from archives import (
    ROOT,
    Run,
    of_page,
    progress,
    put,
    tree,
    zipped,
)

PAGE = """
import { readFileSync, writeFileSync } from "node:fs";
const { load } = await import(process.argv[2]);
const { exportWork, importWork } = await load("archive.ts");
const { WorkStore } = await load("work.ts");
const [from, to, code] = process.argv.slice(3);
const store = new WorkStore(undefined);
for (const [id, text] of Object.entries(JSON.parse(code))) store.save(id, text, "");
let imported = null;
if (from) imported = importWork(readFileSync(from), store);
if (to) writeFileSync(to, exportWork(store));
const texts = Object.fromEntries(store.ids().map((id) => [id, store.code(id).text]));
console.log(JSON.stringify({ imported, texts, progress: store.progress() }));
"""
MERGE = """
import { readFileSync } from "node:fs";
const { load } = await import(process.argv[2]);
const { mergeProgress } = await load("archive.ts");
const [ours, theirs] = process.argv.slice(3).map((file) => JSON.parse(readFileSync(file)));
console.log(JSON.stringify(mergeProgress(ours, theirs)));
"""


needs_page = pytest.mark.skipif(
    not (ROOT / "page/node_modules/esbuild").exists(),
    reason="the page's packages are not installed",
)


def in_node(folder: Path, script: str, *words: str) -> dict[str, Any]:
    (folder / "page.mjs").write_text(script)
    load = str(ROOT / "page/web/test/load.mjs")
    command = ["node", "page.mjs", load, *words]
    done = subprocess.run(command, capture_output=True, text=True, cwd=folder, check=True)
    found: dict[str, Any] = json.loads(done.stdout)
    return found


@needs_page
def test_the_page_and_the_program_take_each_others_archives(
    contact: Run, work: Path, worked: dict[str, str], tmp_path: Path
) -> None:
    def page(file: str, to: str, code: Mapping[str, str]) -> dict[str, Any]:
        return in_node(tmp_path, PAGE, file, to, json.dumps(code))

    assert contact("export", "ours.zip").returncode == 0
    there = page("ours.zip", "theirs.zip", {"01_planes/segment_plane": "// begun in the page\n"})
    assert there["imported"]["ignored"] == []
    copies = {name.removesuffix(".cpp"): t for name, t in worked.items() if name.endswith(".cpp")}
    assert there["texts"] == copies | {"01_planes/segment_plane": "// begun in the page\n"}
    assert there["progress"] == json.loads(worked["progress.json"])
    done = json.loads(contact("import", "theirs.zip", "--json").stdout)
    assert done["from"] == "page"
    assert {r["exercise"]: r["status"] for r in done["results"]} == {
        **dict.fromkeys(copies, "same"),
        "01_planes/segment_plane": "new",
    }
    assert tree(work) == worked | {"01_planes/segment_plane.cpp": "// begun in the page\n"}


def random_entry(rng: random.Random) -> dict[str, object]:
    """An entry as either may write it, with some members missing."""
    times = [f"2026-01-0{day}T00:00:00Z" for day in range(1, 5)]
    members: dict[str, object] = {
        "attempts": rng.randrange(5),
        "best_points": rng.randrange(9) / 2,
        "max_points": rng.choice((4.0, 5.0)),
        "passed": rng.choice(times),
        "last_checked": rng.choice(times),
        "hints_shown": rng.randrange(4),
        "solution_shown": rng.random() < 0.5,
        "tests": {"a": rng.choice(("passed", "failed"))},
        "unknown": rng.randrange(3),
    }
    return {name: value for name, value in members.items() if rng.random() < 0.8}


@needs_page
def test_the_page_and_the_program_merge_alike(contact: Run, work: Path, tmp_path: Path) -> None:
    rng = random.Random(20261121)
    ids = [f"77_many/n{number}" for number in range(300)]
    ours, theirs = (
        progress({name: random_entry(rng) for name in ids if rng.random() < 0.8}, both=number)
        for number in (1, 2)
    )
    put(work, {"progress.json": ours})
    put(tmp_path, {"ours.json": ours, "theirs.json": theirs})
    zipped(tmp_path / "a.zip", of_page({}, theirs))
    assert contact("import", "a.zip").returncode == 0
    merged = json.loads((work / "progress.json").read_text())
    assert merged == in_node(tmp_path, MERGE, "ours.json", "theirs.json")
