"""The container in which exercises can be done: its files agree with each other and the program."""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / ".devcontainer"
SETTINGS = json.loads((FOLDER / "devcontainer.json").read_text())
INSTALL = (FOLDER / "install.sh").read_text()
DOCKERFILE = (FOLDER / "Dockerfile").read_text()


def test_the_files_that_it_names_are_there() -> None:
    build = SETTINGS["build"]
    assert (FOLDER / build["dockerfile"]).is_file()
    assert (FOLDER / build["context"]).resolve() == ROOT
    installer = re.search(r"^RUN /opt/contact-hours/(\S+)", DOCKERFILE, re.M)
    assert installer is not None
    script = ROOT / installer[1]
    assert script.stat().st_mode & 0o111


def test_the_user_is_the_one_that_the_image_makes() -> None:
    assert re.search(rf"useradd .* {SETTINGS['remoteUser']}$", INSTALL, re.M)
    assert f"USER {SETTINGS['remoteUser']}" in DOCKERFILE


@pytest.mark.parametrize("when", ["onCreateCommand", "postAttachCommand"])
def test_its_commands_are_the_programs(when: str) -> None:
    program, command, *words = SETTINGS[when].split()
    assert program == "./contact"
    listed = subprocess.run(
        [ROOT / "contact", "--help"], capture_output=True, text=True, check=True
    ).stdout
    assert re.search(rf"^  {command} ", listed, re.M)
    for exercise in words:
        assert (ROOT / "exercises" / exercise / "exercise.toml").is_file()


def test_its_debian_is_one_on_which_the_set_up_can_be_tested() -> None:
    base = re.search(r"^FROM debian:(\d+)$", DOCKERFILE, re.M)
    assert base is not None
    assert f"\n  {base[1]}) codename=" in (ROOT / "tools/bare_debian.sh").read_text()
    # What the script reads of the settings is there as it expects it.
    assert re.search(
        r'^ *"onCreateCommand": "\./contact .*",$', (FOLDER / "devcontainer.json").read_text(), re.M
    )
