"""A diagnosis: what parts simulation and recording, as JSON, with its report beside it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path

from rich.console import Console

from core.cell.cell import Cell
from core.cli.experiments import plan_next
from core.errors import HeftError
from core.files.whole_file import write_whole
from core.gap.diagnosis import examine
from core.gap.effect_fit import fit_nominal
from core.gap.fit_all import FitAll, Found, Job
from core.gap.residual import Residual
from core.gap.twin_addition import addable_to
from core.gap.windows import Windows
from core.recording.folder import read_recording
from core.recording.stated_friction import with_cell_friction
from core.report.diagnosis_page import write_diagnosis
from core.report.overlay import overlay_of
from core.twin.file import read_twin
from core.twin.twin import NOMINAL
from core.words.catalogue import Language
from server.runner.messages import Advanced, Answered, Failed
from server.runner.shown_overlay import thin_overlay
from server.runner.work import give_way


def main(folder: Path, cell: Cell | None, reports: Mapping[Language, Path], overlay: Path, connection: Connection) -> None:
    """Diagnoses the recording in a folder, which is only read.

    Args:
        cell: it was made in: its twin is where the diagnosis starts, and the next motion is planned there.
        reports, overlay: files to write, a page in each language and JSON.
    """
    give_way()
    with suppress(BrokenPipeError):  # nobody waits any more
        try:
            recording = read_recording(folder) if cell is None else with_cell_friction(read_recording(folder), cell)
            twin = NOMINAL if cell is None else read_twin(cell)
            diagnosis, evidence = examine(recording, twin=twin, folder=folder, fit_all=fit_with_progress(connection))
            if cell is not None:
                diagnosis = addable_to(diagnosis, cell)
                diagnosis = plan_next(diagnosis, evidence, recording, folder, cell, None, Console(quiet=True))
            compared = None if evidence is None else overlay_of(evidence)
            for language, report in reports.items():
                write_diagnosis(report, diagnosis=diagnosis, overlay=compared, language=language)
            if compared is not None:
                write_whole(overlay, thin_overlay(compared).model_dump_json())
            connection.send(Answered(diagnosis.model_dump_json()))
        except HeftError as error:
            connection.send(Failed(type(error).__name__, error.message))


def fit_with_progress(connection: Connection) -> FitAll:
    """Says where the gap is largest, then fits one effect after the other and says how far it is; more to fit may turn up on the way."""
    done = of = 0

    def fit_all(windows: Windows, jobs: Sequence[Job[Found]], /) -> list[Found]:
        nonlocal done, of
        if jobs and of == 0:
            connection.send(Advanced(0.0, Residual(windows, fit_nominal(windows)).describe().model_dump_json()))
        of += len(jobs)
        found = []
        for job in jobs:
            found.append(job.run(windows))
            done += 1
            connection.send(Advanced(done / (of + 1)))
        return found

    return fit_all
