"""Several runs of what may be one payload: whether they agree, how they scatter, what they say together."""

from __future__ import annotations

from typing import Annotated, Literal

from fastapi import APIRouter, Query
from pydantic import Field

from core.cell.cell import Cell
from core.estimation.result import Result
from core.estimation.series import measure_result, prior_of
from core.payload.random_effects import Measured
from core.payload.series import Series, compare_series
from core.payload.uncertain_parameters import UncertainParameters
from server.cells.folder import CellsDep
from server.http.schemas import Answer
from server.runs import ledger as run_ledger
from server.runs.conductor import ConductorDep
from server.runs.result_routes import require_cell_with_mount

router = APIRouter(prefix="/api/series", tags=["results"])

RunsQuery = Annotated[
    list[str],
    Query(alias="run", min_length=1, max_length=50, description="Identifiers of the runs.", examples=[["019ab1c2d3e44f1c2a9be7"]]),
]
ConditionsQuery = Annotated[
    list[str] | None,
    Query(
        alias="condition",
        max_length=50,
        description="Under which condition each run was made (day, plan, robot), in their order; one for all where absent.",
        examples=[["monday", "tuesday"]],
    ),
]
PriorQuery = Annotated[
    float | None,
    Query(
        ge=0.01,
        le=100.0,
        description="How well the runs' reference (CAD) is known beforehand, percent (1 sigma); it has no share where absent.",
        examples=[2.0],
    ),
]


class SeriesPublic(Answer):
    """Several runs together; in the sensor's frame, or in the flange's where they were made in several cells."""

    frame: Literal["sensor", "flange"] = Field(description="Frame of all numbers: the sensor's, or the flange's with several cells.")
    series: Series = Field(description="What the runs say, apart and together.")


@router.get("")
def read_series(
    runs: RunsQuery, cells: CellsDep, conductor: ConductorDep, conditions: ConditionsQuery = None, prior_percent: PriorQuery = None
) -> SeriesPublic:
    """Whether several runs found the same payload, how they scatter, and what they say together."""
    rows = [conductor.row_of(run) for run in runs]
    results = [run_ledger.load_result(row) for row in rows]
    several = len({row.cell for row in rows}) > 1
    mounts = [require_cell_with_mount(cells, row) if several else None for row in rows]
    prior, source = (None, None) if prior_percent is None else prior_of(results, prior_percent / 100.0)
    found = compare_series(
        runs,
        [_read_measured(result, cell) for result, cell in zip(results, mounts, strict=True)],
        conditions=conditions,
        prior=prior if prior is None else _in_frame(prior, mounts[0]),
        prior_source=source,
    )
    return SeriesPublic(frame="flange" if several else "sensor", series=found)


def _read_measured(result: Result, cell: Cell | None) -> Measured:
    """Runs of several cells have nothing in common: their sensors and robots are others."""
    measured = measure_result(result)
    return Measured(_in_frame(measured.own, cell), measured.shared if cell is None else {})


def _in_frame(found: UncertainParameters, cell: Cell | None) -> UncertainParameters:
    """In the flange's frame of a cell; as it is without one."""
    mount = None if cell is None else cell.sensor.mount
    return found if mount is None else found.in_frame(mount.rotation, mount.translation)
