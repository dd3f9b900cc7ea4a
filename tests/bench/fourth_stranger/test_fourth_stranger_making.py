"""`bench.fourth_stranger.making`: a case is the same whenever it is made, what is told of it is so, and its cause is to be seen."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin
import pyarrow.parquet as pq
import pytest

from bench.fourth_stranger.making import make_case
from bench.fourth_stranger.plan import Case, list_cases


def find_case(name: str) -> Case:
    return next(case for case in list_cases() if case.order.name == name)


def test_a_case_that_is_made_twice_is_the_same(tmp_path: Path) -> None:
    case = find_case("shift_pull")
    truths = [make_case(case, tmp_path / name) for name in ("once", "again")]
    assert truths[0] == truths[1]
    for file in ("recording.json", "samples.parquet", "robot.urdf"):
        assert (tmp_path / "once" / file).read_bytes() == (tmp_path / "again" / file).read_bytes()


@pytest.mark.parametrize("name", ["step_connector", "shift_pull", "u_freewheel", "u_turret", "cable_chain+gain_span"])
def test_each_cause_leaves_as_much_as_is_wanted(name: str, tmp_path: Path) -> None:
    case = find_case(name)
    truth: dict[str, Any] = make_case(case, tmp_path)
    np.testing.assert_allclose(truth["rms_each"], case.order.wanted, rtol=0.15)
    assert all(rms > 2 for rms in truth["rms_beside_the_other"])
    assert truth["background_rms_excess"] < 1
    table = pq.read_table(tmp_path / "samples.parquet")
    t = table["t"].to_numpy()
    assert np.all(np.diff(t) > 0)
    assert all(np.all(np.isfinite(table[column].to_numpy())) for column in table.schema.names if column != "phase")


@pytest.mark.parametrize("name", ["none0", "none1", "none4"])
def test_the_weight_in_a_file_is_that_of_its_payload(name: str, tmp_path: Path) -> None:
    truth: dict[str, Any] = make_case(find_case(name), tmp_path)
    manifest = json.loads((tmp_path / "recording.json").read_text())
    table = pq.read_table(tmp_path / "samples.parquet")
    model = pin.buildModelFromXML((tmp_path / "robot.urdf").read_text())
    assert truth["rows"] == table.num_rows
    assert manifest["robot"]["joints"] == list(model.names)[1:]
    wrench = manifest["sensor"]["sign"] * np.stack([table[column].to_numpy() for column in ("fx", "fy", "fz")], 1)
    g = _find_gravity(model, np.stack([table[f"q_{i + 1}"].to_numpy() for i in range(model.nq)], 1), np.array(manifest["gravity"]))
    slope = np.sum((wrench - wrench.mean(0)) * (g - g.mean(0))) / np.sum((g - g.mean(0)) ** 2)
    np.testing.assert_allclose(-slope, truth["mass"], rtol=0.05)


def test_a_recording_of_poses_has_no_joints_and_does_not_jump_to_the_other_sign(tmp_path: Path) -> None:
    make_case(find_case("none5"), tmp_path)
    table = pq.read_table(tmp_path / "samples.parquet")
    assert {"qx", "qy", "qz", "qw", "px"} < set(table.schema.names)
    assert "q_1" not in table.schema.names
    assert not (tmp_path / "robot.urdf").exists()
    quaternions = np.stack([table[f"q{axis}"].to_numpy() for axis in "xyzw"], 1)
    assert np.abs(np.diff(quaternions, axis=0)).max() < 0.1


def test_gravity_may_be_a_direction_with_a_site(tmp_path: Path) -> None:
    truth: dict[str, Any] = make_case(find_case("tilt_rocking"), tmp_path)
    manifest = json.loads((tmp_path / "recording.json").read_text())
    assert np.linalg.norm(manifest["gravity"]) == pytest.approx(1, abs=1e-6)
    assert np.linalg.norm(truth["gravity"]) == pytest.approx(9.81, abs=0.04)
    assert set(manifest["site"]) == {"latitude_deg", "elevation_m"}


def _find_gravity(model: pin.Model, q: np.ndarray, gravity: np.ndarray) -> np.ndarray:
    """(M, 3), m/s^2, sensor axes."""
    data, frame = model.createData(), model.getFrameId("ft_sensor")
    found = []
    for each in q:
        pin.framesForwardKinematics(model, data, each)
        found.append(data.oMf[frame].rotation.T @ gravity)
    return np.array(found)
