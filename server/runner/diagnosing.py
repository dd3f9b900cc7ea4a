"""A diagnosis in a process of its own, which gives way to every control loop."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path

from core.errors import HeftError
from core.gap.answer import Diagnosis
from core.gap.diagnosis import examine
from core.gap.effect_fit import EffectFit
from core.gap.fit_all import Task, one_by_one
from core.gap.windows import Windows
from core.recording_folder import read_recording
from server.runner.context import CONTEXT
from server.runner.messages import Failed

NICENESS = 10


@dataclass(frozen=True)
class Fitted:
    """So many effects have been fitted, of those known so far."""

    done: int
    of: int


def diagnosed(folder: Path) -> Iterator[Fitted | Diagnosis | Failed]:
    """How far it is, then the diagnosis of a recording folder or why there is none. Closing the iterator ends the process."""
    connection, theirs = CONTEXT.Pipe(duplex=False)
    process = CONTEXT.Process(target=_diagnose, args=(folder, theirs), name="heft-diagnosis", daemon=True)
    process.start()
    theirs.close()
    try:
        while True:
            answer: Fitted | Diagnosis | Failed = connection.recv()
            yield answer
            if not isinstance(answer, Fitted):
                return
    except EOFError:
        yield Failed("DiagnosisLost", "the diagnosing process ended unexpectedly; ask for the diagnosis again.")
    finally:
        process.kill()
        process.join()
        connection.close()


def _diagnose(folder: Path, connection: Connection) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.nice(NICENESS)
    done = of = 0

    def fit_all(windows: Windows, tasks: list[Task]) -> list[EffectFit]:
        nonlocal done, of
        of += len(tasks)
        fits = []
        for task in tasks:
            fits += one_by_one(windows, [task])
            done += 1
            connection.send(Fitted(done, of))
        return fits

    with suppress(BrokenPipeError):  # nobody waits any more
        try:
            connection.send(examine(read_recording(folder), fit_all=fit_all)[0])
        except HeftError as error:
            connection.send(Failed(type(error).__name__, str(error)))
