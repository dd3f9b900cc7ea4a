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
            "runs-nothing-left",
            allowed=run_ledger.list_offered_commands(State(ended.state)),
            run=ended.id,
            state=ended.state,
            finished_steps=ended.finished_steps,
        )
    recording = folder / RECORDING
    if not recording.is_dir():
        raise Conflict("runs-recording-not-there", run=ended.id)
    motion = run_ledger.motion_of(ended)
    return RestOfRun(
        continues=ended.id,
        recording=recording,
        done=ended.finished_steps,
        diagnosis=None if motion is None else motion.diagnosis,
        stops=None if motion is None else motion.stops,
    )
