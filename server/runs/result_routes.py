"""What a run found out: read, taken for good, set beside another run."""

from __future__ import annotations

from typing import Literal

import numpy as np
from fastapi import APIRouter
from pydantic import Field

from core.cell.cell import Cell
from core.estimation.budget_part import find_shared_covariance
from core.export.exports import payload_of
from core.payload.comparison import Comparison, compare_payloads
from server.cells.folder import CellFolder, CellsDep
from server.http.dependencies import NowDep, StoreDep
from server.http.errors import Conflict, StoreUnavailable
from server.http.parameters import OtherRunPath, RunPath
from server.http.schemas import Answer
from server.people import audit
from server.people.auth import CallerDep
from server.runs import ledger as run_ledger
from server.runs.answer import answer_run
from server.runs.conductor import ConductorDep
from server.runs.lease import ControlDep
from server.runs.payload_answer import ResultPublic, run_answer
from server.runs.schemas import RunPublic
from server.runs.tables import RunRow

router = APIRouter(prefix="/api/runs/{run}", tags=["results"])

Frame = Literal["sensor", "flange"]


class ComparisonPublic(Answer):
    """The run `other` minus the run `run`; both in the sensor's frame, or in the flange's where they were made in two cells."""

    run: str = Field(description="Identifier of the first run.", examples=["019ab1c2d3e44f1c2a9be7"])
    other: str = Field(description="Identifier of the second run, from which the first is taken away.", examples=["019ab1c9aa210f6be35d08"])
    frame: Frame = Field(description="Frame of the comparison: the sensor's, or the flange's where the runs were made in two cells.")
    comparison: Comparison = Field(description="What differs.")


@router.get("/result")
def read_result(run: RunPath, conductor: ConductorDep) -> ResultPublic:
    """What the robot carries, with uncertainties."""
    return run_answer(run, run_ledger.load_result(conductor.row_of(run)))


@router.post("/acceptance")
def accept_result(run: RunPath, store: StoreDep, conductor: ConductorDep, control: ControlDep, caller: CallerDep, now: NowDep) -> RunPublic:
    """An operator takes the result for good; once, and by name."""
    run_ledger.load_result(conductor.row_of(run))
    if not conductor.wait_until_kept(run):
        raise StoreUnavailable("store-result-not-there", run=run)
    with store.write() as db:
        row = run_ledger.load_run(db, run)
        verdict = run_ledger.load_result(row).verdict
        if row.accepted_by is not None:
            raise Conflict("runs-accepted-already", run=run, who=row.accepted_by)
        row.accepted_by, row.accepted_at = caller.who, now
        audit.record(db, caller.who, "run.accept", {"run": run, "verdict": verdict.text}, now=now)
    return answer_run(conductor, control, now, run)


@router.get("/comparison/{other}")
def compare_runs(run: RunPath, other: OtherRunPath, cells: CellsDep, conductor: ConductorDep) -> ComparisonPublic:
    """What differs between two runs, and whether that is more than chance."""
    rows = conductor.row_of(run), conductor.row_of(other)
    results = [run_ledger.load_result(row) for row in rows]
    frame: Frame = "sensor" if rows[0].cell == rows[1].cell else "flange"
    mounts = [None if frame == "sensor" else require_cell_with_mount(cells, row).sensor.mount for row in rows]
    first, second = (payload_of(result, mount) for result, mount in zip(results, mounts, strict=True))
    parts = [each.estimate for each in results if each.estimate is not None]
    offsets = [(np.array(part.offset, float), np.array(part.offset_std, float)) for part in parts]
    budgets = [part.budget for part in parts if part.budget is not None]
    shared = find_shared_covariance(*budgets) if frame == "sensor" and len(budgets) == 2 else None
    comparison = compare_payloads(first, second, offsets[0], offsets[1], shared=shared)
    return ComparisonPublic(run=run, other=other, frame=frame, comparison=comparison)


def require_cell_with_mount(cells: CellFolder, row: RunRow) -> Cell:
    """The cell of a run, which says how its sensor is mounted."""
    cell = cells.read(row.cell).cell
    if cell.sensor.mount is None:
        raise Conflict("runs-no-common-frame", cell=row.cell)
    return cell
