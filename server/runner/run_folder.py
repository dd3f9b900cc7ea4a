"""What lies in a run's folder, and whose it is at the moment."""

from __future__ import annotations

import fcntl
from pathlib import Path
from typing import TextIO

from core.words.catalogue import Language

LOCK = "control.lock"
RECORDING = "recording"
SAMPLES = "samples.arrows"
RESULT = "result.json"


def name_report(language: Language) -> str:
    """The file of a run's report in a language."""
    return "report.html" if language == "en" else f"report.{language}.html"


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
