"""A run's target watched in a process of its own, from the samples on disk: asking costs the control loop a byte, an answer a look."""

from __future__ import annotations

import logging
import signal
from contextlib import suppress
from multiprocessing import get_context
from multiprocessing.connection import Connection

from core.errors import HeftError
from core.procedure.target_watch import TargetAnswer, TargetWatch, answer_target
from core.recording.folder import read_recording
from core.requirement.target import CellRequirement, Target, TargetCheck
from core.robot.model import RobotModel
from core.sessions.sample_log import SampleLog
from core.twin.file import read_twin
from server.runner.messages import Order
from server.runner.priority import Priority, take
from server.runner.sample_stream import read_samples

logger = logging.getLogger("heft.target")

FORK = get_context("fork")


class WatchElsewhere(TargetWatch):
    """Answers when another process has estimated; ends with this object or with its maker.

    It is a plain fork of a maker that has the engine and no threads yet, as the planning process is. Where it dies the run goes on to its
    end, as one without a target does.

    Args:
        unshared: ends of pipes that the process is not to keep open.
    """

    def __init__(self, order: Order, target: Target, *unshared: Connection) -> None:
        super().__init__(TargetCheck(target, CellRequirement(order.cell, RobotModel.of_cell(order.cell))))
        self.connection, theirs = FORK.Pipe()
        """Our end of the pipe to the process."""
        self._newest: TargetAnswer | None = None
        self._process = FORK.Process(
            target=_serve, args=(order, self.check, theirs, self.connection, *unshared), name="heft-target", daemon=True
        )
        self._process.start()
        theirs.close()

    def ask(self, log: SampleLog) -> None:
        """Returns at once; the samples are on disk already."""
        del log
        with suppress(OSError):
            self.connection.send_bytes(b"?")

    def newest(self) -> TargetAnswer | None:
        """The newest answer that has come."""
        with suppress(EOFError, OSError):
            while self.connection.poll():
                self._newest = self.connection.recv()
        return self._newest

    def close(self) -> None:
        """Ends the process, whatever it estimates."""
        self._process.kill()
        self._process.join()
        self.connection.close()


def _serve(order: Order, check: TargetCheck, connection: Connection, *unshared: Connection) -> None:
    """The process: until the other end is gone. Of questions that came while it estimated, the last one counts."""
    for end in unshared:
        end.close()  # who waits for its maker's end would wait for ours too
    take(Priority.PLANNING)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the server, which ends us in order
    robot, twin = RobotModel.of_cell(order.cell), read_twin(order.cell)
    before = None if order.continues is None else read_recording(order.continues.recording)
    while True:
        try:
            connection.recv_bytes()
            while connection.poll():
                connection.recv_bytes()
            log = SampleLog(order.cell, robot, payload=order.payload, reference=order.known, before=before, order=order.reference)
            read_samples(order.folder, log)
            if len(log):
                connection.send(answer_target(log, check, twin))
        except HeftError as error:
            logger.warning("the samples so far cannot be held against the target: %s", error)
        except (EOFError, BrokenPipeError):
            return
