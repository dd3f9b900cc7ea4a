"""Makes a recording of the samples of a run whose control process died with its server; in a process of its own, with the engine."""

from __future__ import annotations

from multiprocessing.connection import Connection
from pathlib import Path

from core.cell import Cell
from core.errors import HeftError
from core.robot import RobotModel
from core.sample_log import SampleLog
from server.runner.messages import Failed, Recovered
from server.runner.run_folder import RECORDING, locked
from server.runner.sample_stream import recover
from server.runner.work import give_way


def main(folder: Path, cell: Cell, connection: Connection) -> None:
    """Waits until the run's control process has ended, which may still write the recording itself.

    Args:
        folder: of the run.
        cell: in which it was.
    """
    give_way()
    with locked(folder):
        if (folder / RECORDING).exists():
            connection.send(Recovered(0))
            return
        try:
            log = SampleLog(cell, RobotModel.of_cell(cell), payload=None, reference=None)
            connection.send(Recovered(recover(folder, log, folder / RECORDING)))
        except (HeftError, OSError) as error:
            connection.send(Failed(type(error).__name__, str(error)))
