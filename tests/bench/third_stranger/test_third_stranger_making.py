"""`bench.third_stranger.making`: a case is the same whenever it is made, and what is told of it is so."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pinocchio as pin
import pyarrow.parquet as pq
import pytest

from bench.third_stranger.making import make_case
from bench.third_stranger.plan import Case, list_cases


def find_case(name: str) -> Case:
    return next(case for case in list_cases() if case.order.name == name)


def test_a_case_that_is_made_twice_is_the_same(tmp_path: Path) -> None:
    case = find_case("tilt_shim+drift_settling")
    truths = [make_case(case, tmp_path / name) for name in ("once", "again")]
    assert truths[0] == truths[1]
    for file in ("recording.json", "samples.parquet"):
        assert (tmp_path / "once" / file).read_bytes() == (tmp_path / "again" / file).read_bytes()


@pytest.mark.parametrize(("name", "averaged_of"), [("none0", 1), ("none3", 20)])
def test_the_weight_in_a_file_is_that_of_its_payload(name: str, averaged_of: int, tmp_path: Path) -> None:
    truth = make_case(find_case(name), tmp_path)
    manifest = json.loads((tmp_path / "recording.json").read_text())
    table = pq.read_table(tmp_path / "samples.parquet")
    model = pin.buildModelFromXML((tmp_path / "robot.urdf").read_text())
    assert truth["rows"] == table.num_rows
    assert manifest.get("count", 1) == averaged_of
    assert manifest["robot"]["joints"] == list(model.names)[1:]
    wrench = manifest["sensor"]["sign"] * np.stack([table[column].to_numpy() for column in ("fx", "fy", "fz")], 1)
    g = _find_gravity(model, np.stack([table[f"q_{i + 1}"].to_numpy() for i in range(model.nq)], 1), np.array(manifest["gravity"]))
    slope = np.sum((wrench - wrench.mean(0)) * (g - g.mean(0))) / np.sum((g - g.mean(0)) ** 2)
    np.testing.assert_allclose(-slope, truth["mass"], rtol=0.02)


def test_a_recording_of_orientations_alone_has_neither_joints_nor_places(tmp_path: Path) -> None:
    make_case(find_case("none7"), tmp_path)
    names = set(pq.read_table(tmp_path / "samples.parquet").schema.names)
    assert {"qx", "qy", "qz", "qw"} < names
    assert not names.intersection({"q_1", "px", "py", "pz"})
    assert not (tmp_path / "robot.urdf").exists()
    assert "robot" not in json.loads((tmp_path / "recording.json").read_text())


def _find_gravity(model: pin.Model, q: np.ndarray, gravity: np.ndarray) -> np.ndarray:
    """(M, 3), m/s^2, sensor axes."""
    data, frame = model.createData(), model.getFrameId("ft_sensor")
    found = []
    for each in q:
        pin.framesForwardKinematics(model, data, each)
        found.append(data.oMf[frame].rotation.T @ gravity)
    return np.array(found)
