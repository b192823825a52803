"""Writes the reports for a school's systems, teachers and students from RESULTS/results.json."""

from __future__ import annotations

import argparse
import sys
from datetime import UTC, datetime
from pathlib import Path

from reports.moment import moment
from reports.results import ReportError, read_results
from reports.write import FORMATS, write_reports


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(
        prog="python -m reports",
        description="Writes gradebook.csv, class.html and students/ID/… into RESULTS.",
    )
    parser.add_argument("results", type=Path, metavar="RESULTS", help="what contact grade -o wrote")
    parser.add_argument(
        "--formats",
        type=_formats,
        default=list(FORMATS),
        metavar="LIST",
        help=f"of {','.join(FORMATS)}; all of them if not given",
    )
    parser.add_argument(
        "--due",
        type=moment,
        metavar="TIME",
        help="when work is due, as 2026-12-01T23:59+01:00; this machine's zone if none is given",
    )
    parser.add_argument(
        "--again",
        default="",
        metavar="COMMAND",
        help="what grades again what could not be graded, for the class page",
    )
    parser.add_argument("--now", type=moment, metavar="TIME", help="take this for the time now")
    given = parser.parse_args(arguments)
    now = given.now or datetime.now(UTC)
    try:
        count = write_reports(
            read_results(given.results), given.results, given.formats, given.due, now, given.again
        )
    except ReportError as error:
        print(f"reports: {error}", file=sys.stderr)
        return 3
    except OSError as error:
        print(f"reports: {error.filename or given.results}: {error.strerror}", file=sys.stderr)
        return 3
    print(f"{count} reports in {given.results}", file=sys.stderr)
    return 0


def _formats(text: str) -> list[str]:
    chosen = [name for name in text.split(",") if name]
    for name in chosen:
        if name not in FORMATS:
            raise argparse.ArgumentTypeError(
                f"there is no format {name}; there are {', '.join(FORMATS)}"
            )
    return chosen


if __name__ == "__main__":
    sys.exit(main())
