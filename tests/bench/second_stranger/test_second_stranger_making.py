"""`bench.second_stranger.making`: a case is the same whenever it is made, and what is told of it is so."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pinocchio as pin
import pyarrow.parquet as pq

from bench.second_stranger.making import make_case
from bench.second_stranger.plan import Case, list_cases

FILES = ("recording.json", "robot.urdf", "samples.parquet")


def find_case(name: str) -> Case:
    return next(case for case in list_cases() if case.order.name == name)


def test_a_case_that_is_made_twice_is_the_same(tmp_path: Path) -> None:
    case = find_case("sample_dropout")
    truths = [make_case(case, tmp_path / name) for name in ("once", "again")]
    assert truths[0] == truths[1]
    for file in FILES:
        assert (tmp_path / "once" / file).read_bytes() == (tmp_path / "again" / file).read_bytes()


def test_a_case_without_a_cause_has_the_payload_that_its_file_states(tmp_path: Path) -> None:
    truth = make_case(find_case("none11"), tmp_path)
    manifest = json.loads((tmp_path / "recording.json").read_text())
    table = pq.read_table(tmp_path / "samples.parquet")
    model = pin.buildModelFromXML((tmp_path / "robot.urdf").read_text())
    assert truth["families"] == [] and truth["visible_sigma"] == 0.0
    assert truth["rows"] == table.num_rows
    assert manifest["robot"]["joints"] == list(model.names)[1:]
    wrench = manifest["sensor"]["sign"] * np.stack([table[name].to_numpy() for name in ("fx", "fy", "fz")], 1)
    g = _find_gravity(model, np.stack([table[f"q_{i + 1}"].to_numpy() for i in range(model.nq)], 1), np.array(manifest["gravity"]))
    slope = np.sum((wrench - wrench.mean(0)) * (g - g.mean(0))) / np.sum((g - g.mean(0)) ** 2)
    np.testing.assert_allclose(-slope, manifest["payload_reference"]["mass"], rtol=0.02)


def _find_gravity(model: pin.Model, q: np.ndarray, gravity: np.ndarray) -> np.ndarray:
    """(M, 3), m/s^2, sensor axes."""
    data, frame = model.createData(), model.getFrameId("ft_sensor")
    found = []
    for each in q:
        pin.framesForwardKinematics(model, data, each)
        found.append(data.oMf[frame].rotation.T @ gravity)
    return np.array(found)
