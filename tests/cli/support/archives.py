"""Archives of a reader's work, as tests make them and look into them."""

from __future__ import annotations

import json
import re
import subprocess
import zipfile
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

Run = Callable[..., subprocess.CompletedProcess[str]]
Files = Mapping[str, str | bytes]
ROOT = Path(__file__).resolve().parents[3]
PROGRAM = ROOT / "build/dev/bin/contact"
RAY = "02_triangles/ray_triangle"
PLANE = "01_planes/sphere_plane"
STUB = (ROOT / f"exercises/{RAY}/ray_triangle.cpp").read_text()
STUB_OF_PLANE = (ROOT / f"exercises/{PLANE}/sphere_plane.cpp").read_text()
MANIFEST = json.dumps(
    {"format": "contact-submission/1", "exported": "2026-02-03T04:05:06Z", "from": "page"}
)
MIB = 1 << 20
COPY = f"work/{RAY}.cpp"
COPY_NAME = r"\d\d_[a-z][a-z0-9_]*/[a-z][a-z0-9_]*\.cpp"


def progress(exercises: Mapping[str, object], **more: object) -> str:
    return json.dumps({"format": "contact-progress/1", "exercises": exercises, **more})


def of_page(copies: Mapping[str, str | bytes], record: str | None = None) -> dict[str, str | bytes]:
    """The files of an archive as the page lays them out."""
    files: dict[str, str | bytes] = {"contact-submission.json": MANIFEST}
    if record is not None:
        files["work/progress.json"] = record
    return files | {f"work/{name}.cpp": text for name, text in copies.items()}


def zipped(file: Path, files: Files | Iterable[tuple[str | zipfile.ZipInfo, str | bytes]]) -> Path:
    pairs = files.items() if isinstance(files, Mapping) else files
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in pairs:
            archive.writestr(name, content)
    return file


def contents(file: Path) -> dict[str, bytes]:
    """Of an archive: all but the time of its export."""
    with zipfile.ZipFile(file) as archive:
        assert archive.testzip() is None
        found = {name: archive.read(name) for name in archive.namelist()}
    manifest = json.loads(found.pop("contact-submission.json"))
    assert manifest["format"] == "contact-submission/1"
    assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", manifest["exported"])
    return found


def tree(folder: Path) -> dict[str, str]:
    """Every file below a folder, but the locks, which are empty and stay."""
    return {
        str(file.relative_to(folder)): file.read_bytes().decode(errors="surrogateescape")
        for file in sorted(folder.rglob("*"))
        if file.is_file() and not file.name.endswith(".lock")
    }


def put(work: Path, files: Mapping[str, str]) -> None:
    for name, text in files.items():
        (work / name).parent.mkdir(parents=True, exist_ok=True)
        (work / name).write_text(text)


def info(name: str, **members: object) -> zipfile.ZipInfo:
    made = zipfile.ZipInfo(name)
    for member, value in members.items():
        setattr(made, member, value)
    return made


def special(name: str, kind: int) -> zipfile.ZipInfo:
    return info(name, external_attr=(kind | 0o777) << 16, create_system=3)


def refused(contact: Run, work: Path, tmp_path: Path, file: Path, *sentences: str) -> None:
    """Holds that neither import nor check takes it, that one line says why, and that nothing at
    all was written."""
    put(work, {f"{RAY}.cpp": "// mine\n"})
    before = tree(tmp_path)
    for command in ("import", "check"):
        done = contact(command, file.name)
        assert done.returncode == 3, (command, done)
        assert done.stdout == ""
        (line,) = done.stderr.splitlines()
        assert file.name in line
        assert len(line) < 600
        assert line.isprintable()
        for sentence in sentences:
            assert sentence in line
    assert tree(tmp_path) == before
