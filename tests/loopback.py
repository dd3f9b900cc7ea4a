"""An address that servers of tests listen at."""

from __future__ import annotations

import os

HOST = f"127.{30 + os.getpid() % 200}.{os.getpid() // 200 % 250}.{2 + os.getpid() // 50_000 % 250}"
"""Of this process alone: tests run in several at once, and controllers have fixed ports."""
