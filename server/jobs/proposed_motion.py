"""The motion that a diagnosis proposes, as an order: for the robot that was diagnosed, with the payload that it carried then."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from pydantic import Field

from core.cell.cell import Cell
from core.cell.urdf_elements import MAX_BYTES as MAX_URDF_BYTES
from core.errors import BadRecording
from core.files.jail import read_inside
from core.gap.answer import Diagnosis
from core.planning.settings import Planner
from core.planning.stop import Stop
from core.recording.manifest import Manifest, RobotPart, read_manifest
from server.http.errors import Conflict
from server.http.schemas import Name, RequestBody
from server.jobs.kinds import DiagnosisOrder
from server.runner.messages import Pace
from server.runs.schemas import ProposedMotion, RunOrder
from server.runs.tables import JobRow, RunRow


class MotionCreate(RequestBody):
    """How the proposed motion is to be made."""

    payload: Name | None = Field(
        default=None,
        description="What the robot carries now: another one than the diagnosed one is refused; the diagnosed one where null.",
        examples=["steel_block"],
    )
    planner: Planner = Field(default="rrt_connect", description="Algorithm that looks for paths.")
    seed: int | None = Field(
        default=None,
        ge=0,
        lt=2**31,
        description="Makes planning and the simulated noise repeatable; one more than that of the continued run where null.",
        examples=[1],
    )
    pace: Pace = Field(default="real_time", description="Of the simulated robot.")


def read_proposed_motion(diagnosed: JobRow) -> ProposedMotion:
    """What the diagnosis proposes.

    Raises:
        Conflict: it is not done, or proposes no motion, or none that the cell has room for.
    """
    order = DiagnosisOrder.model_validate_json(diagnosed.order)
    return ProposedMotion(diagnosis=diagnosed.id, continues=order.run, recording=order.recording, stops=_stops(diagnosed))


def make_motion_order(motion: ProposedMotion, continued: RunRow | None, cell: Cell, body: MotionCreate) -> RunOrder:
    """What the run of a motion is told.

    Args:
        continued: the run that `motion` continues; its payload box stays in force.
        cell: in which the recording was made.

    Raises:
        Conflict: the recording is gone, the cell has another robot by now, or the payload is not the diagnosed one.
    """
    if not motion.recording.is_dir():
        raise Conflict("jobs-recording-gone", job=motion.diagnosis)
    manifest = read_manifest(motion.recording)
    _check_same_robot(motion, manifest, cell)
    payload = manifest.payload if continued is None else continued.payload
    if payload is None:
        raise Conflict("jobs-payload-unnamed", job=motion.diagnosis, cell=cell.name)
    if payload not in cell.payloads and (continued is None or continued.saved_payload is None):
        raise Conflict("jobs-payload-unknown", job=motion.diagnosis, payload=payload, cell=cell.name)
    if body.payload is not None and body.payload != payload:
        raise Conflict("jobs-payload-differs", job=motion.diagnosis, payload=payload, given_payload=body.payload)
    before = RunOrder.model_validate({"cell": cell.name}) if continued is None else RunOrder.model_validate_json(continued.order)
    seed = (before.seed + 1) % 2**31 if body.seed is None else body.seed
    return before.model_copy(update={"payload": payload, "planner": body.planner, "seed": seed, "pace": body.pace})


def _stops(diagnosed: JobRow) -> tuple[Stop, ...]:
    job = diagnosed.id
    if diagnosed.result is None:
        raise Conflict("jobs-no-motion-yet", job=job, state=diagnosed.state)
    proposed = Diagnosis.model_validate_json(diagnosed.result).next_experiment
    if proposed is None:
        raise Conflict("jobs-no-motion-proposed", job=job)
    if not proposed.stops:
        raise Conflict("jobs-no-motion-asked", job=job, motion=proposed.motion)
    refusal = proposed.refused
    if not proposed.planned and refusal is None:
        raise Conflict("jobs-motion-not-planned", job=job)
    if refusal is not None and not proposed.planned:
        raise Conflict("jobs-motion-refused", job=job, refusal=refusal)
    return tuple(proposed.stops)


def _check_same_robot(motion: ProposedMotion, manifest: Manifest, cell: Cell) -> None:
    """As `core.recording.recording.check_same_robot`, without reading the samples."""
    if manifest.robot is None or _read_robot(motion.recording, manifest.robot) != (
        cell.urdf, cell.robot.base_frame, cell.robot.sensor_frame,
    ):  # fmt: skip
        raise Conflict("jobs-robot-changed", job=motion.diagnosis, cell=cell.name)
    now = cell.gravity_in_base
    if not np.allclose(manifest.gravity, now, atol=1e-6):
        raise Conflict(
            "jobs-gravity-changed",
            job=motion.diagnosis,
            cell=cell.name,
            gravity_m_s2=np.round(now, 4).tolist(),
            recorded_m_s2=np.round(manifest.gravity, 4).tolist(),
        )


def _read_robot(recording: Path, robot: RobotPart) -> tuple[str, str, str]:
    text = read_inside(recording, robot.urdf, BadRecording, max_bytes=MAX_URDF_BYTES)
    return text, robot.base_frame, robot.sensor_frame
