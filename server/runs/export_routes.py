"""A run's result as robot controllers and simulators take it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

from fastapi import APIRouter, Path, Response
from pydantic import Field

from core.cell.cell import Cell
from core.errors import BadInput
from core.estimation.result import Result
from core.export.exports import TARGETS, payload_of, require_mount, target_of
from core.export.target import ExportTarget
from core.export.uncertainty import ExportUncertainty, uncertainty_of
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message
from server.cells.folder import CellFolder, CellsDep
from server.http import downloads
from server.http.parameters import RunPath
from server.http.schemas import Answer
from server.runs import ledger as run_ledger
from server.runs.conductor import Conductor, ConductorDep
from server.runs.file_routes import name_after

router = APIRouter(prefix="/api/runs/{run}/exports", tags=["results"])


TargetPath = Annotated[
    str,
    Path(description="Name of the target, as the list of exports has it.", json_schema_extra={"enum": [target.name for target in TARGETS]}),
]


class ExportLoss(Answer):
    """A number that a target has no place for; `times_std` is its size in multiples of its uncertainty."""

    name: str = Field(description="Name of the number that the target has no place for.", examples=["Ixy"])
    value: float = Field(description="Its value, in `unit`.", examples=[0.00012])
    std: float = Field(description="Its standard uncertainty, in `unit`.", examples=[2e-05])
    unit: str = Field(description="Unit of both.", examples=["kg m2"])
    times_std: float = Field(description="Its size in multiples of its uncertainty.", examples=[6.0])


class ExportPublic(Answer):
    """A way to write the result."""

    target: str = Field(description="Name of the target.", examples=["ur"])
    title: str = Field(description="What people call it.", examples=["Universal Robots"])
    file: str = Field(description="Name of the file.", examples=["payload.script"])
    says: Message = Field(description="Units, frame and order of what is in it.")
    refused: Message | None = Field(description="Why it cannot be written; null where it can.")
    lost: list[ExportLoss] = Field(description="What it cannot hold.")
    holds_uncertainty: bool = Field(
        description="Whether the file says how exactly the payload is known, as remarks or as a field; else only `uncertainty` does.",
        examples=[True],
    )


class ExportsPublic(Answer):
    """All targets; they get the payload in the flange's frame."""

    uncertainty: ExportUncertainty | None = Field(
        description="How exactly what is written is known; null where the cell does not say how the sensor sits on the flange."
    )
    targets: list[ExportPublic] = Field(description="All ways to write the result.")


@router.get("")
def list_exports(run: RunPath, cells: CellsDep, conductor: ConductorDep) -> ExportsPublic:
    """How the result can be written, and what each way cannot hold."""
    result, cell = _read(cells, conductor, run)
    try:
        mount = require_mount(cell)
    except BadInput as error:
        return ExportsPublic(uncertainty=None, targets=[_name_target(target, refused=error.message) for target in TARGETS])
    payload = payload_of(result, mount)
    return ExportsPublic(uncertainty=uncertainty_of(result, mount), targets=[_describe(target, payload) for target in TARGETS])


@router.get("/{target}", response_class=Response, responses=downloads.TEXT)
def download_export(run: RunPath, target: TargetPath, cells: CellsDep, conductor: ConductorDep) -> Response:
    """The result as a file that a controller or a simulator takes."""
    chosen = target_of(target)
    result, cell = _read(cells, conductor, run)
    mount = require_mount(cell)
    text = chosen.render_file(payload_of(result, mount), uncertainty_of(result, mount))
    return downloads.text(text, f"{name_after(conductor.row_of(run))}-{chosen.file}")


def _read(cells: CellFolder, conductor: Conductor, run: str) -> tuple[Result, Cell]:
    row = conductor.row_of(run)
    cell = cells.read(row.cell).cell
    return run_ledger.load_result(row), cell


def _describe(target: ExportTarget, payload: UncertainParameters) -> ExportPublic:
    try:
        target.render_file(payload)
    except BadInput as error:
        return _name_target(target, refused=error.message)
    return _name_target(target, lost=[ExportLoss.model_validate(lack) for lack in target.lacks(payload)])


def _name_target(target: ExportTarget, *, refused: Message | None = None, lost: Sequence[ExportLoss] = ()) -> ExportPublic:
    return ExportPublic(
        target=target.name,
        title=target.title,
        file=target.file,
        says=target.says,
        refused=refused,
        lost=list(lost),
        holds_uncertainty=target.holds_uncertainty,
    )
