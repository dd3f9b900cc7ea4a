"""Recordings too long to be held row by row: read in pieces, as means that belong together."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from scipy.spatial.transform import Rotation

from core.errors import BadRecording
from core.recording import long_recording
from core.recording.folder import read_recording, write_recording
from core.recording.long_recording import condense, read_condensed
from core.recording.recording import Recording
from tests.core.recording.small_recording import recording as small

PERIOD_S = 0.001


def long(rows: int = 1003) -> Recording:
    """A small robot's recording at 1 kHz; joints and wrench are linear in time, so that their means are those of the middle."""
    t = PERIOD_S * np.arange(rows)
    wrench = np.outer(t, [1.0, 2.0, 3.0, 0.1, 0.2, 0.3])
    phase = np.where(t < 0.3335, "hold:x+", "transfer")
    return replace(small(), t=t, wrench=wrench, q=np.outer(t, [0.4, -0.2]), dq=None, q_cmd=None, tau=None, temperature=None, phase=phase)


def test_means_are_of_one_phase_and_of_what_was_measured_together() -> None:
    found = condense(long(), 4)
    assert len(found) == 334 // 4 + (1003 - 334) // 4
    np.testing.assert_allclose(found.q, np.outer(found.t, [0.4, -0.2]), atol=1e-12)
    np.testing.assert_allclose(found.wrench, np.outer(found.t, [1.0, 2.0, 3.0, 0.1, 0.2, 0.3]), atol=1e-12)
    assert found.phase is not None
    np.testing.assert_array_equal(found.phase == "transfer", found.t > 0.3335)


def test_nothing_is_averaged_across_a_gap() -> None:
    whole = long()
    t = whole.t + np.where(np.arange(len(whole)) >= 502, 10.0, 0.0)
    found = condense(replace(whole, t=t, phase=None), 4)
    assert not ((found.t > 0.502) & (found.t < 10.5)).any()


def test_angles_that_wrap_and_orientations_have_means_beside_them() -> None:
    angle = np.pi - 0.02 + 0.01 * np.arange(4)
    wrapped = np.arctan2(np.sin(angle), np.cos(angle))
    whole = replace(long(4), q=np.column_stack((wrapped, wrapped)), phase=None)
    assert whole.q is not None and np.ptp(whole.q) > 6.0
    mean = condense(whole, 4).q
    assert mean is not None
    np.testing.assert_allclose(np.cos(mean - angle.mean()), 1.0, atol=1e-12)
    turned = Rotation.from_rotvec(np.outer(angle, [0.0, 0.6, 0.8])).as_matrix()
    free = condense(replace(long(4), q=None, robot=None, orientation=turned, phase=None), 4)
    expected = Rotation.from_rotvec(angle.mean() * np.array([0.0, 0.6, 0.8])).as_matrix()
    np.testing.assert_allclose(free.orientation, expected[None], atol=1e-9)


def test_noise_of_means_is_what_they_have() -> None:
    rng = np.random.default_rng(3)
    white, slow = rng.normal(size=(20_000, 3)), np.zeros((20_000, 3))
    slow[0] = rng.normal(size=3)
    for k in range(1, len(slow)):
        slow[k] = 0.99 * slow[k - 1] + np.sqrt(1.0 - 0.99**2) * rng.normal(size=3)
    noise = np.hstack((white, slow))
    whole = replace(long(len(noise)), wrench=noise, phase=None)
    whole = replace(whole, sensor=replace(whole.sensor, noise_std=np.ones(6)))
    found = condense(whole, 5)
    assert found.wrench is not None and found.sensor.noise_std is not None
    stated, seen = found.sensor.noise_std, found.wrench.std(axis=0)
    np.testing.assert_allclose(stated[:3] / seen[:3], 1.0, atol=0.1)
    assert (stated[3:] > 0.6 * seen[3:]).all()


def test_a_long_recording_is_read_as_what_condensing_it_whole_gives(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(long_recording, "MOST_ROWS", 300)
    monkeypatch.setattr(long_recording, "BATCH_ROWS", 50)
    whole = replace(long(), phase=None)
    write_recording(whole, tmp_path / "long")
    found, remarks = read_condensed(tmp_path / "long")
    assert [remark.code for remark in remarks] == ["recording-condensed"]
    expected = condense(read_recording(tmp_path / "long"), 4)
    for name in ("t", "q", "wrench"):
        np.testing.assert_allclose(getattr(found, name), getattr(expected, name), atol=1e-12)
    assert found.robot == expected.robot


def test_row_groups_of_a_few_rows_are_put_together(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(long_recording, "MOST_ROWS", 300)
    monkeypatch.setattr(long_recording, "BATCH_ROWS", 50)
    write_recording(replace(long(), phase=None), tmp_path / "long")
    file = tmp_path / "long" / "samples.parquet"
    pq.write_table(pq.read_table(file), file, row_group_size=3)
    expected = condense(read_recording(tmp_path / "long"), 4)
    np.testing.assert_allclose(read_condensed(tmp_path / "long")[0].wrench, expected.wrench, atol=1e-12)


def test_a_short_one_is_read_as_it_is(tmp_path: Path) -> None:
    write_recording(small(), tmp_path / "short")
    found, remarks = read_condensed(tmp_path / "short")
    assert remarks == ()
    np.testing.assert_array_equal(found.t, small().t)


def test_slow_samples_are_not_averaged(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(long_recording, "MOST_ROWS", 300)
    write_recording(replace(long(), t=0.006 * np.arange(1003)), tmp_path / "slow")
    assert read_condensed(tmp_path / "slow")[1] == ()


@pytest.mark.parametrize(("row", "column", "value"), [(700, "fx", np.nan), (400, "t", 0.0), (1003, "t", np.nan)])
def test_what_is_wrong_is_named_with_the_row_of_the_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, row: int, column: str, value: float
) -> None:
    monkeypatch.setattr(long_recording, "MOST_ROWS", 300)
    monkeypatch.setattr(long_recording, "BATCH_ROWS", 57)
    write_recording(replace(long(), phase=None), tmp_path / "long")
    file = tmp_path / "long" / "samples.parquet"
    columns = {
        name: column.to_numpy().copy() for name, column in zip(pq.read_table(file).column_names, pq.read_table(file).columns, strict=True)
    }
    columns[column][row - 1] = value
    pq.write_table(pa.table(columns), file)
    with pytest.raises(BadRecording, match=f"column '{column}', row {row}"):
        read_condensed(tmp_path / "long")


def test_the_first_row_of_a_piece_is_held_against_the_last_of_the_one_before(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(long_recording, "MOST_ROWS", 300)
    monkeypatch.setattr(long_recording, "BATCH_ROWS", 100)
    write_recording(replace(long(), phase=None), tmp_path / "long")
    file = tmp_path / "long" / "samples.parquet"
    columns = {
        name: column.to_numpy().copy() for name, column in zip(pq.read_table(file).column_names, pq.read_table(file).columns, strict=True)
    }
    columns["t"][500:] -= 0.05
    pq.write_table(pa.table(columns), file)
    with pytest.raises(BadRecording, match="row 501"):
        read_condensed(tmp_path / "long")
