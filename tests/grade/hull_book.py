"""A book of one exercise, whose answer is indices: no exercise of the real book has one."""

from __future__ import annotations

import json
import shlex
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD = ROOT / "build" / "dev"
EXERCISE = "90_hulls/hull"
# Whose tests, proxy and server are compiled in the same way.
MODEL = "signed_distance"


def commands() -> dict[str, list[str]]:
    """How the model's three objects are compiled, by the end of the source's name."""
    found = {}
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        for end in ("_test.cpp", ".proxy.cpp", ".server.cpp"):
            if entry["file"].endswith(f"/{MODEL}{end}"):
                found[end] = shlex.split(entry["command"])
    return found


def compile_as(model: list[str], source: Path, output: Path, contract: Path) -> None:
    command = list(model)
    command[command.index("-c") + 1] = str(source)
    command[command.index("-o") + 1] = str(output)
    subprocess.run([*command, f"-I{contract}"], cwd=BUILD, check=True)


def make(root: Path) -> Path:
    """The book in a folder of its own, built. Gives the folder for CONTACT_ROOT."""
    shutil.copytree(HERE / "hull", root)
    (root / "chapters" / "00_vectors").symlink_to(ROOT / "chapters" / "00_vectors")
    for shared in ("grading", "page", "cmake"):
        (root / shared).symlink_to(ROOT / shared)
    out = root / "build" / "dev" / "exercises" / EXERCISE
    out.mkdir(parents=True)
    (root / "build" / "venv").symlink_to(ROOT / "build" / "venv")
    for shared in ("bin", "student", "build.ninja"):
        (root / "build" / "dev" / shared).symlink_to(BUILD / shared)

    contract = root / "exercises" / EXERCISE
    proxy, server = out / "hull.proxy.cpp", out / "hull.server.cpp"
    generator = [sys.executable, str(ROOT / "grading" / "contract" / "contract_generator.py")]
    subprocess.run(
        [*generator, str(contract / "hull.hpp"), "--proxy", str(proxy), "--server", str(server)],
        check=True,
    )
    how = commands()
    objects = {}
    for source in (root / "tests" / f"{EXERCISE}_test.cpp", proxy, server):
        end = next(end for end in how if source.name.endswith(end))
        objects[end] = out / f"{source.stem}.o"
        compile_as(how[end], source, objects[end], contract)

    described: dict[str, Any] = json.loads((BUILD / "exercises.json").read_text())
    asks = out / "asks"
    tests_and_proxy = [str(objects["_test.cpp"]), str(objects[".proxy.cpp"])]
    linked = [described["compiler"], *tests_and_proxy, *described["asks_objects"]]
    options = described["server_link_flags"]
    subprocess.run([*linked, *options, "-o", str(asks)], cwd=BUILD, check=True)
    # The server needs no sealing here: nothing of it may be replaced to any use.
    remote = BUILD / "CMakeFiles/contact_remote_server.dir/grading/contact/remote_server.cpp.o"
    whole = out / "server.o"
    subprocess.run(
        ["ld", "-r", "-o", str(whole), str(objects[".server.cpp"]), str(remote)], check=True
    )
    described["root"] = str(root)
    described["exercises"] = {
        EXERCISE: {
            "include": [str(contract)],
            "target": "hull",
            "test_object": str(objects["_test.cpp"]),
            "server_object": str(whole),
            "asks": str(asks),
            "compiled_tests": str(objects["_test.cpp"]),
            "proxy_object": str(objects[".proxy.cpp"]),
        }
    }
    (root / "build" / "dev" / "exercises.json").write_text(json.dumps(described))
    return root
