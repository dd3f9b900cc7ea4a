"""A made-up gripper, and cells that have it: stated in cell.toml, or as links of the URDF behind the sensor."""

from __future__ import annotations

import shutil
from pathlib import Path

CELLS = Path(__file__).parents[2] / "cells"

GRIPPER = """
[tools.gripper]
title = "Two-finger gripper"
mass_kg = 0.8
first_moment_kg_m = [0.004, -0.002, 0.032]
inertia_kg_m2 = [0.0026, 0.0, -0.0001, 0.0027, 0.0001, 0.0012]
mass_std_kg = 0.002
first_moment_std_kg_m = [0.0001, 0.0001, 0.0001]
inertia_std_kg_m2 = [0.00005, 0.00002, 0.00002, 0.00005, 0.00002, 0.00005]
box = { size_m = [0.12, 0.08, 0.07], pose.xyz_m = [0.005, 0.0, 0.035] }
"""

HAND = """
  <link name="hand"><inertial><origin xyz="0.01 0 0.03" rpy="0.2 0 0.1"/><mass value="0.7"/>
    <inertia ixx="0.0012" ixy="0.0001" ixz="0" iyy="0.0025" iyz="-0.0001" izz="0.0018"/></inertial>
    <collision><origin xyz="0 0 0.03"/><geometry><box size="0.08 0.06 0.06"/></geometry></collision></link>
  <link name="finger"><inertial><origin xyz="0 0.005 0.02"/><mass value="0.05"/>
    <inertia ixx="0.000025" ixy="0" ixz="0" iyy="0.00002" iyz="0" izz="0.00001"/></inertial>
    <collision><origin xyz="0 0 0.02"/><geometry><box size="0.02 0.02 0.04"/></geometry></collision></link>
  <link name="grasp"/>
  <joint name="hand_mount" type="fixed"><parent link="{parent}"/><child link="hand"/>
    <origin xyz="0.002 -0.003 0.01" rpy="0.1 -0.2 0.7"/></joint>
  <joint name="slide" type="prismatic"><parent link="hand"/><child link="finger"/>
    <origin xyz="0 0.02 0.06" rpy="0 0 0.4"/><axis xyz="0 1 0"/><limit lower="0" upper="0.04" velocity="0.1" effort="20"/></joint>
  <joint name="grasp_point" type="fixed"><parent link="hand"/><child link="grasp"/><origin xyz="0 0 0.1"/></joint>
"""
"""Links in a row with a joint that slides; `grasp` is a bare frame."""

HAND_AS_TOOL = """
[tools.gripper]
title = "Hand of the URDF"
links = ["hand", "finger"]
"""


def cell_folder(folder: Path, *, toml: str = "", hand: bool = False, name: str = "lwr4_bench") -> Path:
    """A copy of a shipped cell with more in cell.toml, and with the hand behind its sensor frame."""
    copied = Path(shutil.copytree(CELLS / name, folder / name))
    file = copied / "cell.toml"
    file.write_text(file.read_text() + toml)
    if hand:
        urdf = copied / "robot.urdf"
        urdf.write_text(urdf.read_text().replace("</robot>", HAND.format(parent="ft_sensor") + "</robot>"))
    return copied
