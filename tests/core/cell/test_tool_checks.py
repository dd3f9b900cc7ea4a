"""Tools that cannot be: each is refused with the key, what was found and what is expected."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest

from core.cell.folder import load_cell
from core.cell.tool_checks import home_torques
from core.cell.tools import find_tools
from core.cell.urdf import check_urdf
from core.errors import BadInput
from core.payload.inertia import InertialParameters
from core.robot.model import RobotModel
from tests.core.handed import GRIPPER, HAND_AS_TOOL, cell_folder


def changed(old: str, new: str) -> str:
    assert old in GRIPPER
    return GRIPPER.replace(old, new, 1)


def renamed(name: str) -> str:
    return GRIPPER.replace("tools.gripper", f"tools.{name}")


INERTIA = "inertia_kg_m2 = [0.0026, 0.0, -0.0001, 0.0027, 0.0001, 0.0012]\n"
BROKEN: dict[str, tuple[str, str]] = {
    "an inertia no body has": (
        changed("0.0027, 0.0001, 0.0012]", "0.0027, 0.0001, 0.0092]"),
        "tools.gripper.inertia_kg_m2: found mass 0.8, .* rigid body can have",
    ),
    "a centre of mass outside": (
        changed("size_m = [0.12, 0.08, 0.07]", "size_m = [0.12, 0.08, 0.001]"),
        "tools.gripper.box: .* outside the box",
    ),
    "no inertia": (changed(INERTIA, ""), "tools.gripper.inertia_kg_m2: found no such key, expected mass_kg, .* or links of the URDF"),
    "a mass of nothing": (changed("mass_kg = 0.8", "mass_kg = 0.0"), "tools.gripper.mass_kg: found 0.0, expected greater than 0"),
    "a negative std": (
        changed("mass_std_kg = 0.002", "mass_std_kg = -0.002"),
        "tools.gripper.mass_std_kg: found -0.002, expected greater than or equal to 0",
    ),
    "a negative std among others": (
        changed("[0.0001, 0.0001, 0.0001]", "[0.0001, -0.0001, 0.0001]"),
        "first_moment_std_kg_m.1: found -0.0001",
    ),
    "an std that is NaN": (changed("mass_std_kg = 0.002", "mass_std_kg = nan"), "tools.gripper.mass_std_kg: found nan"),
    "a misspelt key": (changed("mass_std_kg", "mas_std_kg"), "tools.gripper.mas_std_kg: found an unknown key, expected 'mass_std_kg'"),
    "heavier than the sensor's range": (
        changed("mass_kg = 0.8", "mass_kg = 16.0"),
        "sensor.range: found 145 N for fx, expected more than the weight of tools.gripper puts on it, 157 N",
    ),
    "too heavy with a payload": (changed("mass_kg = 0.8", "mass_kg = 13.0"), "of tools.gripper, payloads.steel_block puts on it, 155 N"),
    "the name of an obstacle": (renamed("fixture"), "tools.fixture: found the name of an obstacle or a zone, expected a name of its own"),
    "the name of a zone": (renamed("operator"), "tools.operator: found the name of an obstacle or a zone"),
    "the name of a link": (renamed("link7"), "tools.link7: found the name of a link of the URDF"),
    "the payload's name": (renamed("payload"), "tools.payload: found the name of the payload's box"),
    "links and a mass": (changed("mass_kg = 0.8", 'mass_kg = 0.8\nlinks = ["link7"]'), "tools.gripper.mass_kg: found a value beside links"),
    "a link before the sensor": (
        HAND_AS_TOOL.replace('"hand"', '"link6"'),
        "tools.gripper.links: found 'link6', expected links behind the sensor frame 'ft_sensor', of which there are none",
    ),
    "no links": ('[tools.gripper]\ntitle = "none"\nlinks = []\n', "tools.gripper.links"),
    "neither": ('[tools.gripper]\ntitle = "none"\n', "tools.gripper.mass_kg: found no such key, expected mass_kg, .* or links of the URDF"),
}


@pytest.mark.parametrize("what", list(BROKEN))
def test_a_tool_that_cannot_be_is_refused_with_key_value_and_expectation(what: str, tmp_path: Path) -> None:
    toml, said = BROKEN[what]
    with pytest.raises(BadInput) as refusal:
        load_cell(cell_folder(tmp_path, toml=toml))
    told = [str(flaw) for flaw in (refusal.value, *refusal.value.others)]
    assert any(re.search(said, flaw) for flaw in told), told


WITH_HAND: dict[str, tuple[str, Callable[[str], str], str]] = {
    "a hand in no tool": ("", str, "robot.sensor_frame: found 'ft_sensor' with the links hand, finger behind it"),
    "a finger left out": (
        HAND_AS_TOOL.replace(', "finger"', ""),
        str,
        "the links finger behind it, which the sensor feels and no tool has",
    ),
    "a link twice": (HAND_AS_TOOL + '[tools.other]\ntitle = "other"\nlinks = ["hand"]\n', str, "'hand', which is in tools.gripper already"),
    "a link that is not there": (
        HAND_AS_TOOL.replace('"finger"', '"fingre"'),
        str,
        "tools.gripper.links: found 'fingre', expected links behind",
    ),
    "links without mass": (
        HAND_AS_TOOL,
        lambda urdf: re.sub('<mass value="0.0?[57]+"/>', '<mass value="0"/>', urdf),
        "tools.gripper.links: found links without mass",
    ),
    "a hand no body can be": (
        HAND_AS_TOOL,
        lambda urdf: urdf.replace('izz="0.0018"', 'izz="0.0918"'),
        "tools.gripper.links: found mass 0.75, .* rigid body can have",
    ),
    "too heavy for the drives": (
        HAND_AS_TOOL,
        lambda urdf: urdf.replace('effort="176"', 'effort="3"'),
        r"tools.gripper: found .* N m on 'joint\d' at home, .* 3 N m \(limit effort",
    ),
}


@pytest.mark.parametrize("what", list(WITH_HAND))
def test_links_behind_the_sensor_are_a_tools_or_refused(what: str, tmp_path: Path) -> None:
    toml, change, said = WITH_HAND[what]
    folder = cell_folder(tmp_path, toml=toml, hand=True)
    (folder / "robot.urdf").write_text(change((folder / "robot.urdf").read_text()))
    with pytest.raises(BadInput) as refusal:
        load_cell(folder)
    told = [str(flaw) for flaw in (refusal.value, *refusal.value.others)]
    assert any(re.search(said, flaw) for flaw in told), told


def test_a_cell_with_tools_is_taken(tmp_path: Path) -> None:
    assert [tool.name for tool in find_tools(load_cell(cell_folder(tmp_path / "a", toml=GRIPPER)))] == ["gripper"]
    assert [tool.name for tool in find_tools(load_cell(cell_folder(tmp_path / "b", toml=HAND_AS_TOOL, hand=True)))] == ["gripper"]


@pytest.mark.parametrize("name", ["lwr4_bench", "ur5e_line"])
def test_the_torques_that_hold_arm_and_tools_at_home_are_pinocchios(name: str, tmp_path: Path) -> None:
    cell = load_cell(cell_folder(tmp_path, toml=GRIPPER, name=name))
    parameters = find_tools(cell)[0].parameters
    robot = RobotModel.of_cell(cell)
    model = robot.model.copy()
    model.gravity.linear = cell.gravity
    frame = model.frames[robot.sensor_frame_id]
    body = pin.Inertia(parameters.mass, parameters.com, parameters.inertia_com)
    model.appendBodyToJoint(frame.parentJoint, body, frame.placement)
    expected = np.abs(pin.computeGeneralizedGravity(model, model.createData(), np.array(cell.robot.home_rad)))
    found = home_torques(cell, check_urdf(cell.urdf, "robot.urdf"), parameters)
    assert list(found) == list(robot.description.joints)
    np.testing.assert_allclose(list(found.values()), expected, atol=1e-9)
    assert max(found.values()) > max(home_torques(cell, check_urdf(cell.urdf, "robot.urdf"), InertialParameters(np.zeros(10))).values())
