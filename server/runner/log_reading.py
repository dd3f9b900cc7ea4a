"""Reads a log of another program that somebody has sent, with limits: what it was taken for, what is still to be asked, and the recording
that comes of it."""

from __future__ import annotations

import os
import resource
import tempfile
from collections.abc import Callable, Iterator
from multiprocessing.connection import Connection
from pathlib import Path

import numpy as np

from core.errors import BadInput
from core.estimation.setup.log_choice import ImportedLog, read_log
from core.files.jail import read_inside
from core.recording.bags.kernels import copy_bytes, find_alike, find_records
from core.recording.folder import write_recording
from core.recording.logs.conversion import MAX_URDF_BYTES
from core.recording.logs.mapping import write_mapping
from core.recording.logs.question import OpenQuestion
from core.recording.logs.tables import Log, open_log
from core.recording.recording import Recording
from core.robot.compiled import load_kinematics
from core.version import release_version
from server.http.flaws import dump_refusal
from server.runner.confinement import confine
from server.runner.log_answer import LogThinner, describe_log, list_changes
from server.runner.log_folder import LOGS, MAPPING, MEMORY, MOST_FILE_BYTES, MOST_OPEN_FILES, RECORDING, SECONDS, WORK, LogOrder
from server.runner.log_schemas import LogQuestion, LogReading
from server.runner.messages import Advanced, Answered
from server.runner.work import give_way

OPENED, CHECKED = 0.3, 0.7
"""Shares of the work that are done by then, as it is with a log of a minute."""
ASKED_FRAMES = "joints.sensor_frame"


def main(folder: Path, order: LogOrder, connection: Connection) -> None:
    """Answers with a `LogReading`, or with what is wrong (`dump_refusal`). Where nothing contradicts, the recording stands in the folder.

    Args:
        folder: of the import.
    """
    give_way()
    load_kinematics()
    compile_kernels()
    release_version()  # which the recording bears; read from where this program is installed
    os.chdir(folder / LOGS)  # errors name files as they were sent
    tempfile.tempdir = str(folder / WORK)
    resource.setrlimit(resource.RLIMIT_FSIZE, (MOST_FILE_BYTES, MOST_FILE_BYTES))
    confine(folder, SECONDS, MEMORY, MOST_OPEN_FILES)
    try:
        reading = read_order(order, lambda share: connection.send(Advanced(share)))
    except BadInput as error:
        connection.send(Answered(dump_refusal(error)))
    except MemoryError:
        return  # who waits hears that this process has ended
    else:
        connection.send(Answered(reading.model_dump_json()))


def compile_kernels() -> None:
    """What bags are read with, compiled before this process may no longer write down what was compiled."""
    content = np.frombuffer(bytes(64), dtype=np.uint8)  # as the bytes of a file are: not to be written
    none, all_fixed = np.zeros(1, dtype=np.int64), np.ones(1, dtype=bool)
    for data in (content, content.copy()):
        find_records(data[:0])
        copy_bytes(data, none, 0, 1)
        find_alike(data, none, none, content, all_fixed)


def read_order(order: LogOrder, tell: Callable[[float], object]) -> LogReading:
    """Reads the log in the working directory, and makes the recording beside it where nothing speaks against it.

    Args:
        tell: is told the share that is done.

    Raises:
        BadInput: it cannot be used, and why.
    """
    log = open_log([Path(name) for name in order.logs])
    tell(OPENED)
    mapping = None if order.mapping is None else Path(order.mapping)
    try:
        made = _read_with_cell(log, mapping, order)
    except OpenQuestion as asked:
        question = LogQuestion(key=asked.key, choices=list(asked.choices), likely=asked.likely, reason=asked.reason)
        return LogReading(question=question, understood=None, changes=[], contradiction=None, remarks=[], preview=None)
    tell(CHECKED)
    thinner = LogThinner(len(made.conversion))
    thinner.add(made.beginning)
    blocks = _blocks(made, thinner, tell)
    if made.check.contradiction is None:
        write_recording(made.beginning, Path("..") / RECORDING, blocks)
        (Path("..") / RECORDING / MAPPING).write_text(write_mapping(made.mapping), encoding="utf-8")
    else:
        for _ in blocks:
            pass
    return LogReading(
        question=None,
        understood=describe_log(made),
        changes=list_changes(made),
        contradiction=made.check.contradiction,
        remarks=list(made.check.remarks),
        preview=thinner.preview(),
    )


def _blocks(made: ImportedLog, thinner: LogThinner, tell: Callable[[float], object]) -> Iterator[Recording]:
    """What follows the beginning, each block looked at on its way."""
    whole, done = len(made.conversion), len(made.beginning)
    for block in made.conversion.blocks(done):
        thinner.add(block)
        done += len(block)
        tell(CHECKED + (1.0 - CHECKED) * done / whole)
        yield block


def _read_with_cell(log: Log, mapping: Path | None, order: LogOrder) -> ImportedLog:
    """The log, with a robot's description that was sent or that of the cell, which also knows where its sensor is."""
    answers = dict(order.answers)
    if order.robot is not None:
        log.urdf = read_inside(Path(), order.robot, BadInput, max_bytes=MAX_URDF_BYTES)
    elif order.cell is not None:
        log.urdf = order.cell.urdf
    try:
        return read_log(log, mapping, answers)
    except OpenQuestion as asked:
        if asked.key != ASKED_FRAMES or order.cell is None or order.robot is not None:
            raise
        frames = {"joints.base_frame": order.cell.base_frame, ASKED_FRAMES: order.cell.sensor_frame}
        return read_log(log, mapping, frames | answers)
