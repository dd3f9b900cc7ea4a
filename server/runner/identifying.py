"""The payload from a recording that was made of another program's log, with its report in each language."""

from __future__ import annotations

import time
from contextlib import suppress
from dataclasses import replace
from multiprocessing.connection import Connection
from pathlib import Path

from core.cell.cell import Cell
from core.errors import BadInput
from core.estimation.identification import identify_recording
from core.estimation.result import Result, SecondsPart, result_of
from core.recording.long_recording import read_condensed
from core.report.page import write_report
from core.requirement.verdict import judge_estimate
from core.robot.model import RobotModel
from core.twin.file import read_twin
from core.twin.twin import NOMINAL
from core.words.catalogue import LANGUAGES
from server.http.flaws import dump_refusal
from server.runner.log_folder import RECORDING, locate_report
from server.runner.messages import Answered
from server.runner.priority import Priority
from server.runner.work import give_way


def main(folder: Path, cell: Cell | None, empty: Path | None, connection: Connection) -> None:
    """Answers with a `Result`, or with what is wrong (`dump_refusal`); the pages stand in the folder then.

    Args:
        folder: of the import.
        cell: in which it was made: its twin counts, its thresholds judge. None where that is none of ours.
        empty: folder of the import of a log of the same arm without the payload; None where the recording stands alone.
    """
    give_way(Priority.PLANNING)
    with suppress(BrokenPipeError):  # nobody waits any more
        try:
            connection.send(Answered(identify(folder, cell, empty).model_dump_json()))
        except BadInput as error:
            connection.send(Answered(dump_refusal(error)))


def identify(folder: Path, cell: Cell | None, empty: Path | None = None) -> Result:
    """What `heft identify` says of the recording in an import's folder, with `--without` where there is one of the arm alone.

    Raises:
        BadRecording, BadRobot, BadTwin: it, or the cell's twin, cannot be used.
    """
    recording, remarks = read_condensed(folder / RECORDING)
    alone, of_alone = (None, ()) if empty is None else read_condensed(empty / RECORDING)
    began = time.perf_counter()
    found = identify_recording(recording, NOMINAL if cell is None else read_twin(cell), alone)
    found = replace(found, warnings=(*found.warnings, *remarks, *of_alone))
    seconds = SecondsPart(robot=float(recording.t[-1] - recording.t[0]), estimate=time.perf_counter() - began)
    enough = None if cell is None else judge_estimate(cell, RobotModel.of_cell(cell), found.estimate)
    for language in LANGUAGES:
        write_report(locate_report(folder, language), recording=recording, identification=found, requirement=enough, language=language)
    return result_of(found, recording, seconds=seconds, requirement=enough)
