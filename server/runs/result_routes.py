"""What a run found out: read, taken for good, set beside another run."""

from __future__ import annotations

from typing import Literal

import numpy as np
from fastapi import APIRouter

from core.cell.cell import Cell
from core.export.exports import payload_of
from core.payload.comparison import Comparison, compare_payloads
from server.cells.folder import CellFolder, CellsDep
from server.http.dependencies import NowDep, StoreDep
from server.http.errors import Conflict, StoreUnavailable
from server.http.schemas import Answer
from server.people import audit
from server.people.auth import CallerDep
from server.runs import ledger as run_ledger
from server.runs.answer import answer_run
from server.runs.conductor import ConductorDep
from server.runs.lease import ControlDep
from server.runs.payload_answer import PayloadAnswer, payload_answer
from server.runs.schemas import RunAnswer
from server.runs.tables import RunRow

router = APIRouter(prefix="/api/runs/{run}", tags=["results"])

Frame = Literal["sensor", "flange"]


class ComparisonAnswer(Answer):
    """The run `other` minus the run `run`; both in the sensor's frame, or in the flange's where they were made in two cells."""

    run: str
    other: str
    frame: Frame
    comparison: Comparison


@router.get("/result")
def read_result(run: str, conductor: ConductorDep) -> PayloadAnswer:
    """What the robot carries, with uncertainties."""
    return payload_answer(run, run_ledger.load_result(conductor.row_of(run)))


@router.post("/acceptance")
def accept_result(run: str, store: StoreDep, conductor: ConductorDep, control: ControlDep, caller: CallerDep, now: NowDep) -> RunAnswer:
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
def compare_runs(run: str, other: str, cells: CellsDep, conductor: ConductorDep) -> ComparisonAnswer:
    """What differs between two runs, and whether that is more than chance."""
    rows = conductor.row_of(run), conductor.row_of(other)
    results = [run_ledger.load_result(row) for row in rows]
    frame: Frame = "sensor" if rows[0].cell == rows[1].cell else "flange"
    mounted = [None if frame == "sensor" else _require_mount(cells, row) for row in rows]
    first, second = (payload_of(result, cell) for result, cell in zip(results, mounted, strict=True))
    offsets = [(np.array(part.offset, float), np.array(part.offset_std, float)) for part in (each.estimate for each in results) if part]
    return ComparisonAnswer(run=run, other=other, frame=frame, comparison=compare_payloads(first, second, offsets[0], offsets[1]))


def _require_mount(cells: CellFolder, row: RunRow) -> Cell:
    """The cell of a run, which says how its sensor is mounted."""
    cell = cells.read(row.cell).cell
    if cell.sensor.mount is None:
        raise Conflict("runs-no-common-frame", cell=row.cell)
    return cell
