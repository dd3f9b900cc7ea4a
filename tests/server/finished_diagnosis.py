"""A diagnosis in the store as its job leaves it behind, without the job."""

from __future__ import annotations

import json
from datetime import datetime
from pathlib import Path
from typing import Any

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.recording.folder import write_recording
from core.robot.model import RobotModel
from core.sessions.sample_log import SampleLog
from core.sessions.simulated import SimulatedSession
from server.jobs import jobs
from server.jobs.jobs import JobStatus
from server.jobs.kinds import DIAGNOSIS, DiagnosisOrder
from server.service import utc_now
from server.store.store import Store
from tests.server.real_service import Console, RealService

NOTHING_FOUND: dict[str, Any] = {
    "verdict": "explained", "summary": "", "effects": [], "none_probability": 0.0, "unknown_probability": 0.1, "pairs": [],
    "minor": [], "indistinguishable": [], "where": None, "gap": None, "payload": None, "consequence": "", "next_experiment": None,
    "limits": [], "seconds": 1.0,
}  # fmt: skip
SWINGS: dict[str, Any] = {
    "id": "swings_about_horizontal_x", "motion": "rotation about the sensor's x axis", "splits": [["time_delay", "sensor_lowpass"]],
    "stops": [{"down": [0.0, 1.0, 0.0], "swings": {"about": "x", "repetitions": 2}}],
    "sigma_before": 2.0, "sigma_after": 9.0, "seconds": 12.0, "planned": True, "refused": "",
}  # fmt: skip
"""A short motion that a diagnosis may propose."""


def explanation(effect: str, probability: float) -> dict[str, Any]:
    """An effect as an answer names it."""
    return {
        "id": effect, "title": effect, "stage": "timing", "probability": probability, "gap_after": 1.0, "closure": 0.9,
        "closure_interval": [0.8, 1.0], "parameters": {}, "advice": "Measure again.", "addable": True,
    }  # fmt: skip


def finished_diagnosis(store: Store, now: datetime, order: DiagnosisOrder, **found: Any) -> str:
    """Of a diagnosis that is done; `found` stands in its answer."""
    with store.write() as db:
        row = jobs.add_job(db, DIAGNOSIS, order, order.run, "account:anna", now)
        row.state, row.result = JobStatus.done, json.dumps(NOTHING_FOUND | found)
        return row.id


def diagnosed_run(service: RealService, run: str, **found: Any) -> str:
    """Of a run of a service, as its job would leave it, were this found."""
    store = Store(service.store_url)
    recording = (service.data / "recordings" / run / "recording").absolute()
    diagnosis = finished_diagnosis(store, utc_now(), DiagnosisOrder(recording=recording, run=run, cell="lwr4_bench"), **found)
    store.close()
    return diagnosis


def stopped_in_its_first_hold(console: Console) -> str:
    """A short run."""
    run = console.queue(seed=11)
    console.wait(run, "Idle")
    assert console.release(run).status_code == 200
    console.wait_moving(run)
    assert console.http.post(f"/api/runs/{run}/commands", json={"command": "stop"}).status_code == 200
    console.wait(run, "Stopped")
    return run


def standing_recording(folder: Path, cell: Cell | None = None, payload: str | None = None) -> Path:
    """A recording of a robot that only stands: too little to tell anything."""
    cell = cell or load_cell(Path(__file__).parents[2] / "cells" / "lwr4_bench")
    log = SampleLog(cell, RobotModel.of_cell(cell), payload=payload, reference=None)
    with SimulatedSession(cell, cell.payloads["steel_block"].parameters) as robot:
        log.extend([robot.state() for _ in range(400)], "hold:free")
    write_recording(log.recording(), folder)
    return folder
