"""docs/tell_hard_cases.py [CHAPTER...]: writes what the lessons show of hard cases.

Runs each chapter's program hard_cases_CHAPTER, which must be built (in build/dev/bin, unless
--programs names another folder), and writes tests/CHAPTER/hard_cases.told.json. With
--check it writes nothing, and fails if a file differs from the output of the program.
With --reports it runs no program: it reads the reports that the tests of CTest have just written
into that folder, CHAPTER.json.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "docs" / "_ext"), str(ROOT / "grading" / "book")]

from contact_book.hard_cases import told, told_file  # noqa: E402


def chapters() -> list[str]:
    """Those whose lesson shows a table of hard cases."""
    lessons = sorted(ROOT.glob("chapters/*/lesson.md"))
    return [file.parent.name for file in lessons if "{hard-cases}" in file.read_text("utf-8")]


def reported(slug: str, reports: Path) -> str:
    file = reports / f"{slug}.json"
    if not file.is_file():
        sys.exit(f"{file} is missing: the test hard_cases_{slug} failed or did not run")
    return told(file.read_text("utf-8"))


def says(slug: str, programs: Path) -> str:
    program = programs / f"hard_cases_{slug}"
    if not program.is_file():
        build = programs.parent
        sys.exit(f"{program} is not built: cmake --build {build} --target {program.name}")
    done = subprocess.run([program, "--json"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{program.name} failed: {(done.stderr or done.stdout).strip()}")
    return told(done.stdout)


def main() -> int:
    parser = argparse.ArgumentParser(description="Writes what the lessons show of hard cases.")
    parser.add_argument("chapters", nargs="*", metavar="CHAPTER")
    parser.add_argument("--check", action="store_true", help="write nothing; fail where it differs")
    parser.add_argument("--programs", type=Path, default=ROOT / "build" / "dev" / "bin")
    parser.add_argument("--reports", type=Path, help="reports of CTest's tests, not programs")
    arguments = parser.parse_args()
    for name in arguments.chapters:
        if name not in chapters():
            parser.error(f'no lesson "{name}" shows hard cases')
    wrong = []
    for slug in arguments.chapters or chapters():
        file = told_file(ROOT, slug)
        if arguments.reports:
            text = reported(slug, arguments.reports)
        else:
            text = says(slug, arguments.programs)
        if file.is_file() and file.read_text("utf-8") == text:
            continue
        wrong.append(slug)
        if not arguments.check:
            file.write_text(text, "utf-8")
            print(f"wrote {file.relative_to(ROOT)}")
    if arguments.check and wrong:
        print(f"not what the programs say: run docs/tell_hard_cases.py {' '.join(wrong)}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
