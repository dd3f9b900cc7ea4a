"""A proposed experiment as a file: what `heft diagnose` asks for and `heft run` carries out."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field, ValidationError

from core.cell.cell import Cell
from core.errors import BadInput
from core.files.jail import read_inside
from core.files.schema_flaw import schema_flaw
from core.files.whole_file import write_whole
from core.gap.choice import Choice
from core.payload.shapes import Model
from core.planning.stop import Stop
from core.recording.folder import read_recording, recording_sha256
from core.recording.recording import Recording
from core.words.message import Message

FORMAT: Literal["experiment/1"] = "experiment/1"
MAX_BYTES = 1_000_000

Text = Annotated[str, Field(max_length=1000)]
NotNegative = Annotated[float, Field(ge=0.0)]


class Place(Model):
    """Where a stop was planned, for people; `heft run` plans anew."""

    axis: Text
    q_rad: list[float]
    clearance_m: float
    nearest: Text
    transfer_s: NotNegative
    movement_s: NotNegative


class ExperimentFile(Model):
    """The whole file.

    Args:
        id, motion, stops: what to do, in one word, in words, and for planning.
        splits: what it tells apart; `sigma_before`, `sigma_after`: distance of the first of them, now and as predicted.
        seconds: of the robot, as planned.
        recording, recording_sha256: what it continues.
        cell, payload: where it was planned, and with what.
        places: of the stops.
    """

    format: Literal["experiment/1"] = FORMAT
    id: Text
    motion: Message
    stops: Annotated[tuple[Stop, ...], Field(max_length=12)]
    splits: list[tuple[Text, Text]]
    sigma_before: NotNegative
    sigma_after: NotNegative
    seconds: NotNegative
    recording: Text
    recording_sha256: Annotated[str, Field(pattern="^[0-9a-f]{64}$")]
    cell: Text
    payload: Text | None
    places: list[Place]


def read_experiment(file: Path) -> ExperimentFile:
    """Reads and validates the file.

    Raises:
        BadInput: it is missing, too large, or not what `heft diagnose --experiment` writes.
    """
    file = Path(file)
    text = read_inside(file.parent, file.name, BadInput, max_bytes=MAX_BYTES, where=str(file))
    try:
        return ExperimentFile.model_validate_json(text)
    except ValidationError as error:
        raise schema_flaw(error.errors()[0]).refusal(BadInput, str(file)) from error


def experiment_file(choice: Choice, cell: Cell, recording: Recording, folder: Path) -> ExperimentFile:
    """What a choice asks for, for the recording in `folder`."""
    answer, plan = choice.proposal.answer, choice.plan
    places = [
        Place(
            axis=leg.axis,
            q_rad=leg.start.q.tolist(),
            clearance_m=leg.start.clearance_m,
            nearest=leg.start.nearest,
            transfer_s=leg.transfer.trajectory.duration,
            movement_s=leg.moving_s,
        )
        for leg in (() if plan is None else plan.legs)
    ]
    return ExperimentFile(
        id=answer.id,
        motion=answer.motion,
        stops=tuple(answer.stops),
        splits=answer.splits,
        sigma_before=answer.sigma_before,
        sigma_after=answer.sigma_after,
        seconds=answer.seconds,
        recording=str(folder.resolve()),
        recording_sha256=recording_sha256(folder),
        cell=cell.name,
        payload=recording.payload,
        places=places,
    )


def read_continued_recording(asked: ExperimentFile, folder: Path | None = None) -> Recording:
    """The recording that an experiment continues.

    Args:
        folder: where it is now; where it was where absent.

    Raises:
        BadRecording: it cannot be read.
        BadInput: it is not the one that the experiment was proposed for.
    """
    where = Path(asked.recording) if folder is None else folder
    found = recording_sha256(where)
    if found != asked.recording_sha256:
        raise BadInput(
            str(where),
            "gap-other-recording",
            found_sha256=found[:12],
            sha256=asked.recording_sha256[:12],
        )
    return read_recording(where)


def write_experiment(asked: ExperimentFile, file: Path) -> None:
    """Writes the file; it appears only when it is whole, in place of an older one."""
    write_whole(file, asked.model_dump_json(indent=2) + "\n")
