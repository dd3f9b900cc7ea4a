"""A certificate takes from recording, result and record what each of them states, and nothing else."""

from __future__ import annotations

import hashlib
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest

from core.certificate.certificate import certificate_sha256, dump_certificate
from core.certificate.issue import issue_certificate
from core.errors import BadRecording
from core.payload.calibration import SensorCalibration
from core.recording.folder import write_recording
from core.report.record import Record
from tests.core.export.cloud import cloud
from tests.core.export.known_result import answer
from tests.core.recording.small_recording import recording

RECORD = Record(at=datetime(2026, 3, 1, tzinfo=UTC), cell="lwr4_bench", version="0.1.0", run="r1", operator="account:anna")
CALIBRATION = SensorCalibration(gain_std=(0.004,) * 6, source="4711")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    small = recording()
    write_recording(replace(small, sensor=replace(small.sensor, name="Gamma", calibration=CALIBRATION)), tmp_path / "recording")
    return tmp_path / "recording"


def test_the_sensor_is_the_recordings_and_its_hash_is_over_all_its_files(folder: Path) -> None:
    found = issue_certificate(answer(cloud(0), "lwr4_bench"), RECORD, folder, None)
    digest = hashlib.sha256()
    for name in ("recording.json", "samples.parquet", "robot.urdf"):
        digest.update(f"{name}\n".encode() + (folder / name).read_bytes())
    assert found.recording.sha256 == digest.hexdigest()
    sensor = found.recording.sensor
    assert (sensor.name, sensor.frame, sensor.range, sensor.calibration) == ("Gamma", "ft", [100.0] * 6, CALIBRATION)
    assert (found.run, found.released_by, found.accepted_by, found.cell) == ("r1", "account:anna", None, "lwr4_bench")


def test_the_same_run_gives_the_same_bytes_and_their_hash(folder: Path) -> None:
    first, second = (issue_certificate(answer(cloud(0), None), RECORD, folder, None) for _ in range(2))
    assert dump_certificate(first) == dump_certificate(second)
    assert certificate_sha256(first) == hashlib.sha256(dump_certificate(first)).hexdigest()
    accepted = issue_certificate(answer(cloud(0), None), replace(RECORD, accepted_by="account:berta"), folder, None)
    assert certificate_sha256(accepted) != certificate_sha256(first)


def test_a_recording_that_is_gone_is_not_stated_and_one_that_is_broken_is_refused(folder: Path, tmp_path: Path) -> None:
    gone = issue_certificate(answer(cloud(0), None), RECORD, tmp_path / "none", None)
    assert (gone.recording.sha256, gone.recording.sensor.name) == (None, None)
    (folder / "recording.json").write_text("{")
    with pytest.raises(BadRecording):
        issue_certificate(answer(cloud(0), None), RECORD, folder, None)


def test_a_result_without_a_budget_says_that_its_uncertainty_is_the_repeatability_alone() -> None:
    found = issue_certificate(answer(cloud(0), None), RECORD, None, None)
    assert [each.code for each in found.assumptions] == ["certificate-no-budget"]
