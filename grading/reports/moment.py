"""Times on the command line."""

from __future__ import annotations

import argparse
from datetime import UTC, datetime


def moment(text: str) -> datetime:
    """A time as people write it; of this machine's zone if it names none."""
    try:
        time = datetime.fromisoformat(text)
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"{text} is no time: write it as 2026-12-01T23:59 or 2026-12-01T23:59+01:00"
        ) from None
    return time.astimezone(UTC)
