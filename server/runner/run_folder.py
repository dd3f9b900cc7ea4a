"""What lies in a run's folder, and whose it is at the moment."""

from __future__ import annotations

import fcntl
from pathlib import Path
from typing import TextIO

LOCK = "control.lock"
RECORDING = "recording"
SAMPLES = "samples.arrows"
REPORT = "report.html"
RESULT = "result.json"


def lock_run_folder(folder: Path) -> TextIO:
    """Waits until no other process has the run; it is ours as long as the returned file is open."""
    lock = (folder / LOCK).open("a")
    fcntl.flock(lock, fcntl.LOCK_EX)
    return lock


def is_unlocked(folder: Path) -> bool:
    """Whether no process has the run."""
    try:
        with (folder / LOCK).open("r") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except FileNotFoundError:
        return True
    except BlockingIOError:
        return False
    return True
