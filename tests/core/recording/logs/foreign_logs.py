"""The same motion with the same payload as other programs would have logged it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from tests.core.recording.bags.bag_writer import ROS1, ROS2, Messages, write_bag
from tests.core.recording.logs.payload_log import PayloadLog, angles_at, log_payload

LOG = log_payload(12.0, 100.0, noise=0.05)
AXES = "x", "y", "z"


def write_columns(file: Path, columns: dict[str, np.ndarray], separator: str = ",") -> Path:
    """A file of columns with their names."""
    np.savetxt(file, np.column_stack(list(columns.values())), delimiter=separator, header=separator.join(columns), comments="", fmt="%.12g")
    return file


def wrench_columns(log: PayloadLog, names: tuple[str, ...], sign: float = 1.0) -> dict[str, np.ndarray]:
    """The wrench under six names."""
    return dict(zip(names, sign * log.wrench.T, strict=True))


def write_csv(folder: Path) -> Path:
    """What the payload exerts on the sensor; angles in degrees, places in mm."""
    columns = {"time": LOG.t, **wrench_columns(LOG, ("Fx", "Fy", "Fz", "Mx", "My", "Mz"), -1.0)}
    columns |= dict(zip(("roll [deg]", "pitch [deg]", "yaw [deg]"), np.degrees(angles_at(LOG.t)).T, strict=True))
    return write_columns(folder / "log.csv", columns | {f"{axis} [mm]": 1e3 * LOG.position[:, k] for k, axis in enumerate(AXES)})


def write_rtde(folder: Path) -> Path:
    """As a controller of Universal Robots is logged: the wrench in the base's axes."""
    turned = np.einsum("nij,nkj->nki", LOG.orientation, LOG.wrench.reshape(-1, 2, 3)).reshape(-1, 6)
    columns = {"timestamp": LOG.t, **dict(zip((f"actual_TCP_force_{k}" for k in range(6)), turned.T, strict=True))}
    pose = np.hstack([LOG.position, Rotation.from_matrix(LOG.orientation).as_rotvec()])
    columns |= dict(zip((f"actual_TCP_pose_{k}" for k in range(6)), pose.T, strict=True))
    return write_columns(folder / "robot_data.csv", columns, " ")


def write_ati(folder: Path) -> tuple[Path, Path]:
    """As ATI's demonstration program logs, beside a file of poses."""
    counts = np.round(1e6 * LOG.wrench).astype(int)
    head = "Start Time,now\nRDT Sample Rate,100\nForce Units,N\nCounts per Unit Force,1000000\n"
    head += "Torque Units,N-m\nCounts per Unit Torque,1000000\n"
    rows = [f"0,{k},{k},{','.join(map(str, row))},now" for k, row in enumerate(counts)]
    names = "Status (hex),RDT Sequence,F/T Sequence,Fx,Fy,Fz,Tx,Ty,Tz,Time\n"
    (folder / "ati.csv").write_text(head + names + "\n".join(rows) + "\n")
    quaternions = Rotation.from_matrix(LOG.orientation).as_quat()
    columns = {"t": LOG.t, **{f"q{axis}": quaternions[:, k] for k, axis in enumerate("xyzw")}}
    poses = write_columns(folder / "poses.csv", columns | {axis: LOG.position[:, k] for k, axis in enumerate(AXES)})
    return folder / "ati.csv", poses


def write_transforms(folder: Path, storage: str) -> Path:
    """A bag with a tree of transforms, of which every second is there: MCAP or SQLite of ROS 2, or ROS 1."""
    make = Messages(ROS1 if storage == "ros1" else ROS2)
    quaternions = Rotation.from_matrix(LOG.orientation).as_quat()
    topics = {
        "/ft": [(t, make.wrench(t, w, "hand")) for t, w in zip(LOG.t, LOG.wrench, strict=True)],
        "/tf": [
            (t, make.transforms(t, {("world", "hand"): (p, q)}))
            for t, p, q in zip(LOG.t[::2], LOG.position[::2], quaternions[::2], strict=True)
        ],
    }
    return write_bag(folder / ("log.bag" if storage == "ros1" else "log"), topics, storage=storage)


def write_undecided(folder: Path) -> Path:
    """An attitude that does not change: neither axes nor sign can be told."""
    columns = {"t": LOG.t, **wrench_columns(LOG, ("fx", "fy", "fz", "tx", "ty", "tz"))}
    return write_columns(folder / "log.csv", columns | {"qx": 0.0 * LOG.t, "qy": 0.0 * LOG.t, "qz": 0.0 * LOG.t, "qw": 0.0 * LOG.t + 1.0})
