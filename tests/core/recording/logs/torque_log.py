"""A log of joints and their torques as a controller without a wrist sensor would have written it."""

from __future__ import annotations

from pathlib import Path

from core.recording.recording import Recording
from tests.core.recording.logs.foreign_logs import write_columns

ANSWERS = {"joints.sensor_frame": "tool"}
"""What neither names nor values tell: where the payload begins."""


def write_torque_log(folder: Path, name: str, recording: Recording) -> tuple[Path, Path]:
    """A CSV of that name, and the robot's description."""
    assert recording.q is not None
    assert recording.tau is not None
    assert recording.robot is not None
    columns = {"time": recording.t} | {f"q{k}": column for k, column in enumerate(recording.q.T)}
    file = write_columns(folder / f"{name}.csv", columns | {f"tau{k}": column for k, column in enumerate(recording.tau.T)})
    (folder / "arm.urdf").write_text(recording.robot.urdf)
    return file, folder / "arm.urdf"
