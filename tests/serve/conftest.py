"""A run that ends stops these tests; what they have started ends with them then."""

from __future__ import annotations

import signal

# As Ctrl-C does: what stands behind `finally` is done.
signal.signal(signal.SIGTERM, signal.default_int_handler)
