"""What a diagnosis proposes to measure next, made as a run."""

from __future__ import annotations

from fastapi import APIRouter, Response
from starlette.status import HTTP_202_ACCEPTED

from server.cells.folder import CellsDep
from server.http.dependencies import NowDep, StoreDep
from server.http.errors import Conflict
from server.http.parameters import DiagnosisPath
from server.jobs import jobs
from server.jobs.kinds import DIAGNOSIS, DiagnosisOrder
from server.jobs.proposed_motion import MotionCreate, make_motion_order, read_proposed_motion
from server.people.auth import CallerDep
from server.runs import ledger as run_ledger
from server.runs.conductor import ConductorDep
from server.runs.queue import IdempotencyKeyHeader, RunRequest, queue_once
from server.runs.schemas import RunPublic

router = APIRouter(prefix="/api/diagnoses", tags=["diagnoses"])


@router.post("/{diagnosis}/motion", status_code=HTTP_202_ACCEPTED)
def queue_motion(
    diagnosis: DiagnosisPath,
    body: MotionCreate,
    response: Response,
    store: StoreDep,
    cells: CellsDep,
    conductor: ConductorDep,
    caller: CallerDep,
    now: NowDep,
    idempotency_key: IdempotencyKeyHeader = None,
) -> RunPublic:
    """Queues the motion that a diagnosis proposes as a run, to be released like any other; its recording continues the diagnosed one."""
    with store.read() as db:
        diagnosed = jobs.load_job(db, DIAGNOSIS, diagnosis)
        motion = read_proposed_motion(diagnosed)
        continued = None if motion.continues is None else run_ledger.load_run(db, motion.continues)
    cell = DiagnosisOrder.model_validate_json(diagnosed.order).cell
    if cell is None:
        raise Conflict("jobs-no-cell", job=diagnosis)
    order = make_motion_order(motion, continued, cells.read(cell).cell, body)
    carried = None if continued is None else run_ledger.read_carried(continued)
    same = f"{diagnosis} {body.model_dump_json()}".encode()
    return queue_once(store, conductor, response, RunRequest(caller.who, now, idempotency_key, same), order, motion, carried)
