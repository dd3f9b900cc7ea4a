"""A diagnosis: what parts simulation and recording, as JSON, with its report beside it."""

from __future__ import annotations

from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path

from core.diagnosis_overlay import overlay_of
from core.errors import HeftError
from core.gap.diagnosis import examine
from core.gap.effect_fit import EffectFit
from core.gap.fit_all import FitAll, Task, one_by_one
from core.gap.windows import Windows
from core.recording_folder import read_recording
from core.report.diagnosis_page import write_diagnosis
from server.runner.messages import Advanced, Answered, Failed
from server.runner.work import give_way


def main(recording: Path, report: Path, connection: Connection) -> None:
    """Diagnoses the recording in a folder, which is only read, and writes the page `report`."""
    give_way()
    with suppress(BrokenPipeError):  # nobody waits any more
        try:
            diagnosis, evidence = examine(read_recording(recording), fit_all=told_as_it_goes(connection))
            overlay = None if evidence is None else overlay_of(evidence)
            write_diagnosis(report, diagnosis=diagnosis, overlay=overlay)
            connection.send(Answered(diagnosis.model_dump_json()))
        except HeftError as error:
            connection.send(Failed(type(error).__name__, str(error)))


def told_as_it_goes(connection: Connection) -> FitAll:
    """Fits one effect after the other and says how far it is; more to fit may turn up on the way."""
    done = of = 0

    def fit_all(windows: Windows, tasks: list[Task]) -> list[EffectFit]:
        nonlocal done, of
        of += len(tasks)
        fits = []
        for task in tasks:
            fits += one_by_one(windows, [task])
            done += 1
            connection.send(Advanced(done / (of + 1)))
        return fits

    return fit_all
