"""A certificate made of what a run has left behind."""

from __future__ import annotations

from pathlib import Path

from core.cell.cell import Cell
from core.certificate.certificate import Certificate, CertifiedSensor, RecordingFacts
from core.certificate.judgement import state_conformity
from core.certificate.values import list_values
from core.estimation.result import Result
from core.recording.folder import recording_sha256
from core.recording.manifest import FILE as MANIFEST
from core.recording.manifest import read_manifest
from core.report.record import Record
from core.words.message import Message


def issue_certificate(result: Result, record: Record, recording: Path | None, cell: Cell | None) -> Certificate:
    """The certificate of a run.

    Args:
        record: when and where it was, and who answers for it.
        recording: its folder; None, or without a recording, where that is gone.
        cell: whose thresholds the values have to meet; None where nobody knows it.

    Raises:
        BadRecording: there is one that cannot be read.
    """
    estimate = result.estimate
    return Certificate(
        run=record.run,
        cell=record.cell,
        payload=result.payload,
        order=record.order,
        ended_at=record.at,
        released_by=record.operator,
        accepted_by=record.accepted_by,
        accepted_at=record.accepted_at,
        software=record.version,
        plan_sha256=record.plan_sha256,
        recording=read_recording_facts(recording),
        verdict=result.verdict,
        values=list_values(estimate, result.verdict),
        phi=[None] * 10 if estimate is None else estimate.phi,
        covariance=[[None] * 10] * 10 if estimate is None else estimate.covariance,
        workpiece=result.workpiece,
        twin=result.twin,
        assumptions=_list_assumptions(result),
        warnings=result.warnings,
        conformity=state_conformity(result, cell),
    )


def read_recording_facts(folder: Path | None) -> RecordingFacts:
    """Nothing where there is no recording in the folder."""
    if folder is None or not (folder / MANIFEST).is_file():
        return RecordingFacts()
    manifest = read_manifest(folder)
    sensor = manifest.sensor.description
    facts = CertifiedSensor(
        name=sensor.name,
        frame=None if manifest.robot is None else manifest.robot.sensor_frame,
        range=None if sensor.range is None else sensor.range.tolist(),
        calibration=sensor.calibration,
    )
    return RecordingFacts(sha256=recording_sha256(folder), sensor=facts)


def _list_assumptions(result: Result) -> list[Message]:
    if result.estimate is None:
        return []
    budget = result.estimate.budget
    return [Message.of("certificate-no-budget")] if budget is None else budget.assumptions
