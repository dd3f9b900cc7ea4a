"""A run's result as robot controllers and simulators take it."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Path, Response

from core.cell.cell import Cell
from core.errors import BadPayload
from core.export.exports import TARGETS, frame_of, payload_of, target_of
from core.export.target import Target
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message
from server.cells.folder import CellFolder, CellsDep
from server.http import downloads
from server.http.schemas import Answer
from server.runs import ledger as run_ledger
from server.runs.conductor import Conductor, ConductorDep

router = APIRouter(prefix="/api/runs/{run}/exports", tags=["results"])


TargetPath = Annotated[str, Path(json_schema_extra={"enum": [target.name for target in TARGETS]})]


class Lost(Answer):
    """A number that a target has no place for; `times_std` is its size in multiples of its uncertainty."""

    name: str
    value: float
    std: float
    unit: str
    times_std: float


class ExportListed(Answer):
    """A way to write the result.

    Args:
        file: its name; `says` tells units, frame and order of what is in it.
        refused: why it cannot be written; null where it can.
        lost: what it cannot hold.
    """

    target: str
    title: str
    file: str
    says: Message
    refused: Message | None
    lost: list[Lost]


class ExportsAnswer(Answer):
    """All targets; `frame` says in which frame they get the payload."""

    frame: Message
    targets: list[ExportListed]


@router.get("")
def list_exports(run: str, cells: CellsDep, conductor: ConductorDep) -> ExportsAnswer:
    """How the result can be written, and what each way cannot hold."""
    payload, cell = _payload(cells, conductor, run)
    return ExportsAnswer(frame=frame_of(cell), targets=[_describe(target, payload) for target in TARGETS])


@router.get("/{target}", response_class=Response, responses=downloads.TEXT)
def download_export(run: str, target: TargetPath, cells: CellsDep, conductor: ConductorDep) -> Response:
    """The result as a file that a controller or a simulator takes."""
    chosen = target_of(target)
    payload, _ = _payload(cells, conductor, run)
    return downloads.text(chosen.render_file(payload), chosen.file)


def _payload(cells: CellFolder, conductor: Conductor, run: str) -> tuple[UncertainParameters, Cell]:
    row = conductor.row_of(run)
    cell = cells.read(row.cell).cell
    return payload_of(run_ledger.load_result(row), cell), cell


def _describe(target: Target, payload: UncertainParameters) -> ExportListed:
    refused: Message | None = None
    try:
        target.render_file(payload)
    except BadPayload as error:
        refused = error.message
    lost = [] if refused else [Lost.model_validate(lack) for lack in target.lacks(payload)]
    return ExportListed(target=target.name, title=target.title, file=target.file, says=target.says, refused=refused, lost=lost)
