"""From a log in five formats to a recording without a question, and the questions that a log raises."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.estimation.setup.log_choice import ImportedLog, import_log
from core.recording.logs.proposal import propose_mappings
from core.recording.logs.question import OpenQuestion
from core.recording.logs.tables import open_log
from tests.core.recording.bags.bag_writer import ROS1, ROS2, Messages, write_bag
from tests.core.recording.logs.payload_log import MASS_KG, PayloadLog, angles_at, log_payload

LOG = log_payload(12.0, 100.0, noise=0.05)
AXES = "x", "y", "z"


def imported(*paths: Path, **answers: str) -> ImportedLog:
    log = open_log(paths)
    given = {key.replace("__", "."): value for key, value in answers.items()}
    return import_log(log, propose_mappings(log, given), Path())


def write(file: Path, columns: dict[str, np.ndarray], separator: str = ",") -> Path:
    np.savetxt(file, np.column_stack(list(columns.values())), delimiter=separator, header=separator.join(columns), comments="", fmt="%.12g")
    return file


def wrench_columns(log: PayloadLog, names: tuple[str, ...], sign: float = 1.0) -> dict[str, np.ndarray]:
    return dict(zip(names, sign * log.wrench.T, strict=True))


def test_a_csv_of_the_other_sign(tmp_path: Path) -> None:
    columns = {"time": LOG.t, **wrench_columns(LOG, ("Fx", "Fy", "Fz", "Mx", "My", "Mz"), -1.0)}
    columns |= dict(zip(("roll [deg]", "pitch [deg]", "yaw [deg]"), np.degrees(angles_at(LOG.t)).T, strict=True))
    columns |= {f"{axis} [mm]": 1e3 * LOG.position[:, k] for k, axis in enumerate(AXES)}
    check(imported(write(tmp_path / "log.csv", columns)), sign=-1, axes="sensor")


def test_an_rtde_log_in_base_axes(tmp_path: Path) -> None:
    turned = np.einsum("nij,nkj->nki", LOG.orientation, LOG.wrench.reshape(-1, 2, 3)).reshape(-1, 6)
    columns = {"timestamp": LOG.t, **dict(zip((f"actual_TCP_force_{k}" for k in range(6)), turned.T, strict=True))}
    pose = np.hstack([LOG.position, Rotation.from_matrix(LOG.orientation).as_rotvec()])
    columns |= dict(zip((f"actual_TCP_pose_{k}" for k in range(6)), pose.T, strict=True))
    check(imported(write(tmp_path / "robot_data.csv", columns, " ")), sign=1, axes="base")


def test_an_ati_file_beside_a_file_of_poses(tmp_path: Path) -> None:
    counts = np.round(1e6 * LOG.wrench).astype(int)
    head = "Start Time,now\nRDT Sample Rate,100\nForce Units,N\nCounts per Unit Force,1000000\n"
    head += "Torque Units,N-m\nCounts per Unit Torque,1000000\n"
    rows = [f"0,{k},{k},{','.join(map(str, row))},now" for k, row in enumerate(counts)]
    names = "Status (hex),RDT Sequence,F/T Sequence,Fx,Fy,Fz,Tx,Ty,Tz,Time\n"
    (tmp_path / "ati.csv").write_text(head + names + "\n".join(rows) + "\n")
    quaternions = Rotation.from_matrix(LOG.orientation).as_quat()
    columns = {"t": LOG.t, **{f"q{axis}": quaternions[:, k] for k, axis in enumerate("xyzw")}}
    poses = write(tmp_path / "poses.csv", columns | {axis: LOG.position[:, k] for k, axis in enumerate(AXES)})
    check(imported(tmp_path / "ati.csv", poses), sign=1, axes="sensor")


@pytest.mark.parametrize("storage", ["mcap", "sqlite", "ros1"])
def test_a_bag_with_a_tree_of_transforms(tmp_path: Path, storage: str) -> None:
    make = Messages(ROS1 if storage == "ros1" else ROS2)
    quaternions = Rotation.from_matrix(LOG.orientation).as_quat()
    topics = {
        "/ft": [(t, make.wrench(t, w, "hand")) for t, w in zip(LOG.t, LOG.wrench, strict=True)],
        "/tf": [
            (t, make.transforms(t, {("world", "hand"): (p, q)}))
            for t, p, q in zip(LOG.t[::2], LOG.position[::2], quaternions[::2], strict=True)
        ],
    }
    path = write_bag(tmp_path / ("log.bag" if storage == "ros1" else "log"), topics, storage=storage)
    made = imported(path)
    check(made, sign=1, axes="sensor")
    assert made.mapping.pose is not None
    assert made.mapping.pose.file == "tf world>hand"
    again = import_log(open_log([path]), [made.mapping], Path())
    assert np.array_equal(again.beginning.wrench, made.beginning.wrench)


def check(made: ImportedLog, *, sign: int, axes: str) -> None:
    assert made.check.contradiction is None
    assert made.check.weighed is not None
    assert made.check.weighed.mass == pytest.approx(MASS_KG, rel=0.01)
    assert (made.mapping.wrench.sign, made.mapping.wrench.axes) == (sign, axes)
    rows = slice(0, len(made.beginning))
    assert np.abs(made.beginning.wrench - LOG.wrench[rows]).max() < 1e-5
    assert np.abs(made.beginning.orientation - LOG.orientation[rows]).max() < 1e-4


def test_an_attitude_that_does_not_change_leaves_the_axes_to_a_person(tmp_path: Path) -> None:
    columns = {"t": LOG.t, **wrench_columns(LOG, ("fx", "fy", "fz", "tx", "ty", "tz"))}
    columns |= {"qx": 0.0 * LOG.t, "qy": 0.0 * LOG.t, "qz": 0.0 * LOG.t, "qw": 0.0 * LOG.t + 1.0}
    file = write(tmp_path / "log.csv", columns)
    with pytest.raises(OpenQuestion) as asked:
        imported(file)
    assert asked.value.key == "wrench.axes"
    with pytest.raises(OpenQuestion) as then:
        imported(file, wrench__axes="sensor")
    assert then.value.key == "wrench.sign"
    assert imported(file, wrench__axes="sensor", wrench__sign="-1").mapping.wrench.sign == -1
