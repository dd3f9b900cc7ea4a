from __future__ import annotations

from pathlib import Path

import pytest

from core.errors import BadInput, BadRecording
from core.recording.logs.mapping import Mapping
from core.recording.logs.proposal import propose_mappings
from core.recording.logs.question import OpenQuestion
from core.recording.logs.tables import open_log
from tests.core.recording.logs.torque_log import ANSWERS
from tests.torque_recordings import make

KUKA = Path(__file__).parents[4] / "docs" / "logs" / "kuka-med14"
UR = ",".join(["timestamp", *(f"actual_TCP_pose_{k}" for k in range(6)), *(f"actual_TCP_force_{k}" for k in range(6))])
ROS = ",".join(
    ["time", *(f"wrench.force.{axis}" for axis in "xyz"), *(f"wrench.torque.{axis}" for axis in "xyz")]
    + [f"pose.orientation.{axis}" for axis in "xyzw"]
    + [f"pose.position.{axis}" for axis in "xyz"]
)


def propose(folder: Path, names: list[str], **answers: str) -> list[Mapping]:
    return propose_mappings(open_log([folder / name for name in names]), answers)


def log(folder: Path, header: str, step: float = 0.002, rows: int = 501) -> list[str]:
    width = header.count(",")
    lines = [",".join([repr(k * step), *["0.5"] * width]) for k in range(rows)]
    (folder / "log.csv").write_text("\n".join([header, *lines]) + "\n")
    return ["log.csv"]


def test_the_names_of_a_kuka_with_an_ati_sensor_in_two_files() -> None:
    names = ["wrench.csv.gz", "orientations.csv.gz"]
    first = propose(KUKA, names)[0]
    assert first.wrench.file == names[0]
    assert first.wrench.torque == ("tx", "ty", "tz")
    assert first.pose is not None
    assert first.pose.file == names[1]
    assert first.pose.matrix == ("r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33")
    assert (first.wrench.time_unit, first.pose.time_unit) == ("us", "us")


def test_the_names_of_an_rtde_log_whose_force_is_in_base_axes(tmp_path: Path) -> None:
    first = propose(tmp_path, log(tmp_path, UR))[0]
    assert first.wrench.axes == "base"
    assert first.wrench.torque == ("actual_TCP_force_3", "actual_TCP_force_4", "actual_TCP_force_5")
    assert first.pose is not None
    assert first.pose.rotation_vector == ("actual_TCP_pose_3", "actual_TCP_pose_4", "actual_TCP_pose_5")
    assert first.pose.position == ("actual_TCP_pose_0", "actual_TCP_pose_1", "actual_TCP_pose_2")


def test_the_names_of_flat_ros_messages_and_both_signs_and_axes_that_no_name_tells(tmp_path: Path) -> None:
    found = propose(tmp_path, log(tmp_path, ROS))
    assert {(each.wrench.sign, each.wrench.axes) for each in found} == {(1, "sensor"), (-1, "sensor"), (1, "base"), (-1, "base")}
    assert found[0].pose is not None
    assert found[0].pose.quaternion == tuple(f"pose.orientation.{axis}" for axis in "xyzw")
    assert found[0].pose.position == tuple(f"pose.position.{axis}" for axis in "xyz")


@pytest.mark.parametrize(("step", "unit"), [(0.002, "s"), (2.0, "ms"), (2000.0, "us"), (2e6, "ns")])
def test_the_unit_of_time_is_the_one_that_gives_the_rate_of_a_log(tmp_path: Path, step: float, unit: str) -> None:
    assert propose(tmp_path, log(tmp_path, ROS, step))[0].wrench.time_unit == unit


@pytest.mark.parametrize(
    ("header", "key"),
    [
        (ROS.replace("force", "fource"), "wrench.force"),
        (ROS.replace("torque", "tork"), "wrench.torque"),
        (ROS.replace("orientation", "way"), "pose"),
        (ROS.replace("time", "when"), "time"),
    ],
)
def test_what_no_name_tells_is_asked_for_by_its_key(tmp_path: Path, header: str, key: str) -> None:
    with pytest.raises(BadRecording, match=f"look like {key}"):
        propose(tmp_path, log(tmp_path, header))


def test_of_several_logs_in_a_folder_one_is_asked_for(tmp_path: Path) -> None:
    for name in ("a.csv", "b.csv"):
        (tmp_path / name).write_text("t,fx,fy,fz,tx,ty,tz\n0,1,2,3,4,5,6\n0.01,1,2,3,4,5,6\n")
    with pytest.raises(OpenQuestion) as asked:
        propose_mappings(open_log([tmp_path]), {})
    assert asked.value.key == "wrench.file"
    assert asked.value.choices == ("a.csv", "b.csv")


def test_a_folder_without_logs_is_refused(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="no log in the folder"):
        open_log([tmp_path])


@pytest.mark.parametrize(
    ("header", "units"),
    [
        ("Time [ms],Fx [N],Fy [N],Fz [N],Tx [Nmm],Ty [Nmm],Tz [Nmm],Roll (deg),Pitch (deg),Yaw (deg),x (mm),y (mm),z (mm)",
         ("ms", "N", "N mm", "deg", "mm")),
        ("t,Force X (lbf),Force Y (lbf),Force Z (lbf),Torque X (lbf-in),Torque Y (lbf-in),Torque Z (lbf-in),roll,pitch,yaw,x,y,z",
         ("s", "lbf", "lbf in", "rad", "m")),
    ],
)  # fmt: skip
def test_units_in_the_names_are_taken(tmp_path: Path, header: str, units: tuple[str, ...]) -> None:
    first = propose(tmp_path, log(tmp_path, header, 2.0 if units[0] == "ms" else 0.002))[0]
    assert first.pose is not None
    assert first.pose.roll_pitch_yaw is not None
    assert (
        first.wrench.time_unit,
        first.wrench.force_unit,
        first.wrench.torque_unit,
        first.pose.angle_unit,
        first.pose.position_unit,
    ) == units


def test_joints_with_their_torques_need_no_wrist_sensor(tmp_path: Path) -> None:
    urdf = make(1).loaded.robot.urdf
    header = ",".join(["t", *(f"q{k}" for k in range(6)), *(f"tau{k}" for k in range(6))])
    (found,) = propose_mappings(open_log([tmp_path / name for name in log(tmp_path, header)]), ANSWERS, urdf)
    assert found.wrench is None
    assert found.joints is not None
    assert found.joints.torque == tuple(f"tau{k}" for k in range(6))
    assert (found.joints.base_frame, found.joints.sensor_frame) == ("base", "tool")


def test_joints_without_torques_do(tmp_path: Path) -> None:
    header = ",".join(["t", *(f"q{k}" for k in range(6))])
    opened = open_log([tmp_path / name for name in log(tmp_path, header)])
    with pytest.raises(BadRecording, match=r"wrench\.force"):
        propose_mappings(opened, ANSWERS, make(1).loaded.robot.urdf)
