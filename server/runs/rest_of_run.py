"""The rest of a run that ended before it was through, for a run that goes on with it."""

from __future__ import annotations

from pathlib import Path

from server.http.errors import Conflict
from server.runner.run_folder import RECORDING
from server.runs import ledger as run_ledger
from server.runs.packml import State
from server.runs.schemas import RestOfRun
from server.runs.tables import RunRow


def rest_of(ended: RunRow, folder: Path) -> RestOfRun:
    """What is left to do of an ended run.

    Args:
        folder: of that run.

    Raises:
        Conflict: it is not over, came through, or finished no step.
    """
    if not run_ledger.may_continue(ended):
        raise Conflict(
            f"run {ended.id}: there is nothing to go on with; it is in {ended.state} and has finished {ended.finished_steps} steps. "
            "Begin a new run",
            run_ledger.list_offered_commands(State(ended.state)),
        )
    recording = folder / RECORDING
    if not recording.is_dir():
        raise Conflict(f"run {ended.id}: its recording is not there (yet); ask again in some seconds, or begin a new run")
    motion = run_ledger.motion_of(ended)
    return RestOfRun(
        continues=ended.id,
        recording=recording,
        done=ended.finished_steps,
        diagnosis=None if motion is None else motion.diagnosis,
        stops=None if motion is None else motion.stops,
    )
