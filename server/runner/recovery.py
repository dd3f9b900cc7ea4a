"""Makes a recording of the samples of a run whose control process died with its server; in a process of its own, with the engine."""

from __future__ import annotations

from multiprocessing.connection import Connection
from pathlib import Path

from core.cell.cell import Cell
from core.errors import HeftError
from core.recording.folder import read_recording
from core.recording.order_reference import OrderReference
from core.robot.model import RobotModel
from core.sessions.sample_log import SampleLog
from core.words.message import Message
from server.runner.messages import Failed, Recovered
from server.runner.run_folder import RECORDING, lock_run_folder
from server.runner.sample_stream import recover_recording
from server.runner.work import give_way


def main(folder: Path, cell: Cell, continues: Path | None, reference: OrderReference, connection: Connection) -> None:
    """Waits until the run's control process has ended, which may still write the recording itself.

    Args:
        folder: of the run.
        cell: in which it was.
        continues: folder of the recording that the run continued.
        reference: what the plant calls its order.
    """
    give_way()
    with lock_run_folder(folder):
        if (folder / RECORDING).exists():
            connection.send(Recovered(0))
            return
        try:
            before = None if continues is None else read_recording(continues)
            log = SampleLog(cell, RobotModel.of_cell(cell), payload=None, reference=None, before=before, order=reference)
            connection.send(Recovered(recover_recording(folder, log, folder / RECORDING)))
        except HeftError as error:
            connection.send(Failed(type(error).__name__, error.message))
        except OSError as error:
            connection.send(Failed("NoRoom", Message.of("runs-folder-not-writable", reason=error.strerror or "")))
