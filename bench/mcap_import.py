"""An hour of MCAP at 1 kHz through `heft import`: own processor time and memory: `python -m bench.mcap_import`.

The file is written by `rosbags`, which shares no code with the import; wrench and joints of a seven-axis arm with positions, velocities and
efforts, and its description. Time and memory are those of the process that imports, by the kernel's count.
"""

from __future__ import annotations

import argparse
import resource
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from core.array import Array
from core.cell.folder import find_cell, load_cell
from core.robot.model import RobotModel

RATE_HZ = 1000
STORE = get_typestore(Stores.ROS2_HUMBLE)
MASS_KG, LEVER_M = 1.2, np.array([0.01, -0.02, 0.08])


def main() -> None:
    """Prints seconds of processor time, and the largest memory."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=60.0)
    minutes = parser.parse_args().minutes
    with tempfile.TemporaryDirectory() as folder:
        file = _write_bag(Path(folder) / "bag", round(60.0 * RATE_HZ * minutes))
        out = Path(folder) / "recording"
        subprocess.run([sys.executable, "-m", "core.cli", "import", str(file), "--out", str(out)], check=True)
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        size = file.stat().st_size / 1e6
    print(f"{minutes:g} min at {RATE_HZ} Hz, {size:.0f} MB: {used.ru_utime + used.ru_stime:.1f} s of processor time (an hour: wanted 60 s)")
    print(f"memory: {used.ru_maxrss / 1e6:.2f} GB at most, wanted 1 GB")


def _write_bag(folder: Path, rows: int) -> Path:
    """Slow turns of all joints with a mass at a point: what the sensor exerts on it, and noise."""
    cell = load_cell(find_cell("lwr4_bench"))
    robot = RobotModel.of_cell(cell)
    with Writer(folder, version=9, storage_plugin=StoragePlugin.MCAP) as bag:
        kinds = "geometry_msgs/msg/WrenchStamped", "sensor_msgs/msg/JointState", "std_msgs/msg/String"
        topics = "/wrench", "/joint_states", "/robot_description"
        ft, joints, text = (bag.add_connection(topic, kind, typestore=STORE) for topic, kind in zip(topics, kinds, strict=True))
        description = STORE.types[kinds[2]](robot.description.urdf)
        bag.write(text, 0, STORE.serialize_cdr(description, kinds[2]))
        for ns, wrench, state in _messages(robot, rows):
            bag.write(ft, ns, STORE.serialize_cdr(wrench, kinds[0]))
            bag.write(joints, ns, STORE.serialize_cdr(state, kinds[1]))
    return next(folder.glob("*.mcap"))


def _messages(robot: RobotModel, rows: int, block: int = 50_000) -> Iterator[tuple[int, Any, Any]]:
    rng = np.random.default_rng(1)
    names = list(robot.description.joints)
    phase, pace = rng.uniform(0.0, 6.0, len(names)), rng.uniform(0.2, 0.5, len(names))
    types = STORE.types
    time, header, vector = (
        types[f"{name}"] for name in ("builtin_interfaces/msg/Time", "std_msgs/msg/Header", "geometry_msgs/msg/Vector3")
    )
    both, stamped, state = (
        types[name] for name in ("geometry_msgs/msg/Wrench", "geometry_msgs/msg/WrenchStamped", "sensor_msgs/msg/JointState")
    )
    for first in range(0, rows, block):
        t = np.arange(first, min(first + block, rows)) / RATE_HZ
        q = 0.8 * np.sin(t[:, None] * pace + phase)
        dq = 0.8 * pace * np.cos(t[:, None] * pace + phase)
        wide = np.arange(first - 2, first + len(t) + 2) / RATE_HZ
        wrench = _push(robot, 0.8 * np.sin(wide[:, None] * pace + phase)) + rng.normal(scale=[0.1] * 3 + [0.005] * 3, size=(len(t), 6))
        for k, at in enumerate(t):
            ns = 1_700_000_000 * 10**9 + round(1e9 * float(at))
            stamp = time(ns // 10**9, ns % 10**9)
            parts = vector(*map(float, wrench[k, :3])), vector(*map(float, wrench[k, 3:]))
            yield (
                ns,
                stamped(header(stamp, robot.description.sensor_frame), both(*parts)),
                state(header(stamp, ""), names, q[k], dq[k], dq[k]),
            )


def _push(robot: RobotModel, q: Array) -> Array:
    """(N, 6), of rows q (N + 4, n) at the rate: mass times acceleration by differences, and weight."""
    poses = robot.sensor_poses(q)
    where = poses.position + poses.rotation @ LEVER_M
    acceleration = np.diff(where, 2, axis=0)[1:-1] * RATE_HZ**2
    force = MASS_KG * np.einsum("nji,nj->ni", poses.rotation[2:-2], acceleration + np.array([0.0, 0.0, 9.81]))
    return np.hstack([force, np.cross(LEVER_M, force)])


if __name__ == "__main__":
    main()
