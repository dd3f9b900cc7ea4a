"""Robots from public descriptions become cells, or are refused for a reason that holds."""

from __future__ import annotations

import sysconfig
import tomllib
from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Cell, Robot
from core.cell.folder import load_cell
from core.errors import BadRobot
from core.new_cell import home
from core.new_cell.making import make_cell
from core.new_cell.order import Behind, CellOrder

ROBOTS = Path(sysconfig.get_path("purelib")) / "cmeel.prefix/share/example-robot-data/robots"
PANDA, TIAGO = "panda_description/urdf/panda.urdf", "tiago_description/robots/tiago_no_hand.urdf"

ARMS = {
    "panda": (PANDA, {"behind": Behind.TOOL}, 7, "panda_link8", ["panda_hand", "panda_leftfinger", "panda_rightfinger"]),
    "ur5": ("ur_description/urdf/ur5_robot.urdf", {}, 6, "tool0", []),
    "ur10": ("ur_description/urdf/ur10_robot.urdf", {}, 6, "tool0", []),
    "xarm7": ("xarm_description/urdf/xarm7.urdf", {}, 7, "link_eef", []),
    "z1": ("z1_description/urdf/z1.urdf", {"behind": Behind.TOOL}, 6, "link06", ["gripperStator", "gripperMover"]),
    "kinova": ("kinova_description/robots/kinova.urdf", {}, 6, "j2s6s200_end_effector", []),
    "tiago": (TIAGO, {"base_frame": "torso_lift_link", "behind": Behind.TOOL}, 7, "wrist_ft_link", ["wrist_ft_tool_link"]),
    "talos": ("talos_data/robots/talos_left_arm.urdf", {"behind": Behind.TOOL}, 6, "wrist_left_ft_link", None),
}
"""File, what is asked for, the joints of the arm, the sensor frame and the tool that a person finds in the file."""


def loaded(folder: Path) -> Cell:
    """The cell; without the keys that this version of the format does not have."""
    content = tomllib.loads((folder / "cell.toml").read_text())
    if "tools" in Cell.model_fields and {"adjacent", "visual_shapes"} <= set(Robot.model_fields):
        return load_cell(folder)
    kept = {key: value for key, value in content["robot"].items() if key in Robot.model_fields}
    content = {key: value for key, value in content.items() if key in Cell.model_fields}
    return Cell.model_validate({**content, "robot": kept, "folder": folder})


@pytest.mark.parametrize("name", [name if name in ("panda", "ur10") else pytest.param(name, marks=pytest.mark.thorough) for name in ARMS])
def test_a_real_robot_becomes_a_cell(tmp_path, monkeypatch, name):
    monkeypatch.setattr(home, "SAMPLES", 96)
    monkeypatch.setattr(home, "STEPS", ())
    file, wanted, joints, sensor, tool = ARMS[name]
    found = make_cell(CellOrder(name, ROBOTS / file, into=tmp_path, **wanted))
    cell = loaded(found.folder)
    assert cell.robot.sensor_frame == sensor
    assert len(cell.robot.home_rad) == joints
    assert np.isfinite(cell.robot.home_rad).all()
    text = (found.folder / "robot.urdf").read_text()
    assert "package://" not in text
    assert "continuous" not in text
    tools = tomllib.loads((found.folder / "cell.toml").read_text()).get("tools", {})
    if tool is not None:
        assert tools.get("hand", {"links": []})["links"] == tool
    else:
        assert len(tools["hand"]["links"]) == 9  # wrist tool, base, motors, inner links and fingertips of the gripper


def test_a_hand_without_a_word_about_it_is_refused(tmp_path):
    with pytest.raises(BadRobot, match=r"panda_hand.*--behind-sensor tool"):
        make_cell(CellOrder("panda", ROBOTS / PANDA, into=tmp_path))


def test_a_lift_below_the_arm_is_refused_with_the_way_round_it(tmp_path):
    with pytest.raises(BadRobot, match=r"torso_lift_joint.*prismatic.*--base-frame torso_lift_link"):
        make_cell(CellOrder("tiago", ROBOTS / TIAGO, into=tmp_path, behind=Behind.TOOL))
