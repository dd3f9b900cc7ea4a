"""What `heft diagnose --cell CELL --experiment FILE` and `heft run CELL --experiment FILE` do beside diagnosing and running."""

from __future__ import annotations

from pathlib import Path

from rich.console import Console

from core.cell.cell import Cell
from core.cli.terminal import find_wording
from core.errors import BadInput, Refused, slug
from core.gap.answer import Diagnosis
from core.gap.choice import choose_experiment
from core.gap.evidence import Evidence
from core.gap.experiment_file import ExperimentFile, experiment_file, read_continued_recording, read_experiment, write_experiment
from core.procedure.progress import watch
from core.recording.recording import Recording
from core.words.message import Message


def check_experiment_file(file: Path | None, cell: str | None) -> None:
    """Before anything long begins.

    Raises:
        BadInput: an experiment cannot be planned without a cell, or its file not be written.
    """
    if file is None:
        return
    if cell is None:
        raise BadInput("--experiment", "cli-experiment-without-cell")
    if not file.absolute().parent.is_dir():
        raise BadInput(str(file), "cli-folder-missing")


def plan_next(
    diagnosis: Diagnosis, evidence: Evidence | None, recording: Recording, folder: Path, cell: Cell, file: Path | None, messages: Console
) -> Diagnosis:
    """The diagnosis with its next motion planned in a cell, and that motion in a file where one is named."""
    if evidence is None or diagnosis.next_experiment is None:
        if file is not None:
            messages.print(find_wording().say("cli-nothing-to-settle", file=str(file)), highlight=False, soft_wrap=True)
        return diagnosis
    known = cell.payloads.get(recording.payload or "")
    box = cell.payload_box if known is None else known.box
    try:
        choice = watch(choose_experiment(cell, recording, evidence, box), messages)
    except Refused as reason:
        answer = diagnosis.next_experiment.model_copy(update={"refused": reason.message, "refused_kind": slug(type(reason).__name__)})
    else:
        refused = None if choice.plan is not None else Message.of("gap-no-motion-asked")
        answer = choice.proposal.answer.model_copy(update={"planned": choice.plan is not None, "refused": refused})
        if file is not None:
            write_experiment(experiment_file(choice, cell, recording, folder), file)
    return diagnosis.model_copy(update={"next_experiment": answer})


def read_request(file: Path, folder: Path | None, cell: Cell) -> tuple[ExperimentFile, Recording]:
    """An experiment and the recording that it continues, for a cell that is to carry it out.

    Raises:
        BadInput: it was planned for another cell, is no motion, or the recording is another one.
    """
    asked = read_experiment(file)
    if asked.cell != cell.name:
        raise BadInput(f"{file}: cell", "cli-experiment-of-another-cell", found=asked.cell, cell=cell.name)
    if not asked.stops:
        raise BadInput(f"{file}: stops", "cli-experiment-without-motion", motion=asked.motion)
    return asked, read_continued_recording(asked, folder)
