"""The folders of students: their names, and where they are moved when their student is gone."""

from __future__ import annotations

import hashlib
import json
import re
import shutil
from collections.abc import Collection
from datetime import UTC, datetime
from pathlib import Path

# What `contact grade` calls a folder of earlier results. The second of one second has a number.
_STAMP = re.compile(r"(\d{4}-\d\d-\d\dT\d\d-\d\d-\d\dZ)(?:-(\d+))?")


def folder_name(id_: str) -> str:
    """The name of a student's folder: the id, with what no file name may hold spelled out."""
    safe = re.sub(
        r"[^A-Za-z0-9._@+~-]",
        lambda found: "".join(f"%{byte:02X}" for byte in found[0].encode()),
        id_,
    )
    if safe.startswith("."):
        safe = f"%2E{safe[1:]}"
    if len(safe) > 120:
        safe = f"{safe[:100]}%{hashlib.sha256(safe.encode()).hexdigest()[:16]}"
    return safe


def put_away(results: Path, names: Collection[str]) -> None:
    """Moves every folder of students/ but these to earlier/DATE-TIME/students.

    students/ is meant to be passed on, so it has pages only of students in the results. Nothing is
    lost: earlier pages are moved beside the results that they were made from, if those are the last
    that were kept, and otherwise into a new folder with the current time.
    """
    students = results / "students"
    gone = [
        folder
        for folder in (sorted(students.iterdir()) if students.is_dir() else [])
        if folder.is_dir() and not folder.is_symlink() and folder.name not in names
    ]
    if not gone:
        return
    earlier = results / "earlier"
    place = _last_kept(earlier, {folder.name for folder in gone}) or _new_place(earlier)
    (place / "students").mkdir(exist_ok=True)
    for folder in gone:
        shutil.move(folder, place / "students" / folder.name)


def _last_kept(earlier: Path, gone: set[str]) -> Path | None:
    """The last results that were kept, if they have a student who is gone but not that student's
    page."""
    kept: list[tuple[str, int, Path]] = []
    for place in earlier.iterdir() if earlier.is_dir() else ():
        if stamp := _STAMP.fullmatch(place.name):
            kept.append((stamp[1], int(stamp[2] or 1), place))
    if not kept:
        return None
    place = max(kept)[2]
    try:
        before = json.loads((place / "results.json").read_text(encoding="utf-8"))
        graded = {folder_name(str(one["id"])) for one in before["submissions"]}
    except (OSError, ValueError, LookupError, TypeError):
        return None
    there = {folder.name for folder in place.glob("students/*")}
    return place if gone & graded and not gone & there else None


def _new_place(earlier: Path) -> Path:
    stamp = datetime.now(UTC).strftime("%Y-%m-%dT%H-%M-%SZ")
    earlier.mkdir(exist_ok=True)
    place = earlier / stamp
    number = 1
    while place.exists():
        number += 1
        place = earlier / f"{stamp}-{number}"
    place.mkdir()
    return place
