"""A URDF is an untrusted file: whatever no arm can be is refused before any other library reads it."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.cell.urdf import check_urdf
from core.cell.urdf_elements import MAX_BYTES
from core.errors import BadRobot
from core.recording.recording import RobotDescription
from core.robot.model import RobotModel

CELLS = Path(__file__).parents[3] / "cells"
REAL = Path(__file__).parents[4] / "shared" / "real"
GOOD = (CELLS / "lwr4_bench" / "robot.urdf").read_text()
FRAMES = ("base", "ft_sensor")


def swap(old: str, new: str, count: int = 1) -> Callable[[], str]:
    def change() -> str:
        assert old in GOOD
        return GOOD.replace(old, new, count)

    return change


def add(text: str) -> Callable[[], str]:
    return lambda: GOOD.replace("</robot>", text + "</robot>")


def element(name: str, old: str, new: str) -> Callable[[], str]:
    """Changes the link or joint of that name only."""

    def change() -> str:
        found = re.search(rf'<(link|joint) name="{name}".*?</\1>', GOOD, re.DOTALL)
        assert found is not None and old in found[0]
        return GOOD.replace(found[0], found[0].replace(old, new, 1))

    return change


JOINT = '<joint name="j" type="fixed"><parent link="{}"/><child link="{}"/></joint>'

BROKEN: dict[str, tuple[Callable[[], str], str]] = {
    "empty": (lambda: "", "does not parse"),
    "not XML": (lambda: "robot: {}", "does not parse"),
    "cut off": (lambda: GOOD[: len(GOOD) // 2], "does not parse"),
    "NUL": (swap("kuka_lwr4plus", "a\0b"), "does not parse"),
    "document type": (lambda: "<!DOCTYPE robot SYSTEM 'file:///etc/passwd'>" + GOOD[21:], "DOCTYPE"),
    "entities": (lambda: "<!DOCTYPE r [<!ENTITY a 'b'>]>" + GOOD[21:], "DOCTYPE"),
    "too large": (lambda: GOOD + " " * MAX_BYTES, "at most 5000000"),
    "another root": (lambda: "<sdf/>", "<sdf>.*<robot>"),
    "no name": (swap(' name="kuka_lwr4plus"', ""), "without a name"),
    "no effort limit": (element("joint5", ' effort="100"', ""), "no effort"),
    "effort not a number": (element("joint5", 'effort="100"', 'effort="1H0"'), "effort: found '1H0'"),
    "nested too deep": (add("<a>" * 40 + "</a>" * 40), "nested more than 32"),
    "xacro": (
        lambda: GOOD.replace("<robot ", '<robot xmlns:xacro="http://ros.org/xacro" ').replace("</robot>", "<xacro:arm/></robot>"),
        "xacro",
    ),
    "include": (add('<include filename="other.urdf"/>'), "include"),
    "no link": (lambda: "<robot name='a'/>", "no link"),
    "too many links": (add("".join(f'<link name="extra{k}"/>' + JOINT.format("base", f"extra{k}") for k in range(1000))), "at most 1000"),
    "link twice": (add('<link name="link3"/>'), "link 'link3': found 2"),
    "link without a name": (add("<link/>" + JOINT.format("base", "")), "no link|without a name"),
    "joint twice": (swap('"joint4"', '"joint3"'), "joint 'joint3': found 2"),
    "two roots": (add('<link name="island"/>'), "the roots base, island,"),
    "two parents": (add(JOINT.format("base", "link4")), "'link4': found 2 joints"),
    "a ring": (
        add('<link name="a"/><link name="b"/>' + JOINT.format("a", "b") + JOINT.format("b", "a").replace('"j"', '"k"')),
        "cycle",
    ),
    "nothing but a ring": (add(JOINT.format("ft_sensor", "base")), "cycle"),
    "no parent": (swap('<parent link="link1"/>', ""), "joint 'joint2': parent: found no link"),
    "unknown parent": (swap('<parent link="link1"/>', '<parent link="linkl"/>'), "'linkl', expected a link"),
    "unknown child": (swap('<child link="link5"/>', '<child link=""/>'), "child: found no link"),
    "unknown kind": (element("joint3", "revolute", "magic"), "'magic', expected one of"),
    "continuous": (element("joint3", "revolute", "continuous"), "without limits"),
    "prismatic": (element("joint3", "revolute", "prismatic"), "'prismatic', expected a revolute"),
    "mimic": (element("joint3", "</joint>", '<mimic joint="joint1"/></joint>'), "mimics another"),
    "no limit": (
        element("joint5", '<limit lower="-2.967060" upper="2.967060" velocity="3.560472" effort="100"/>', ""),
        "no lower",
    ),
    "no velocity limit": (element("joint5", 'velocity="3.560472"', ""), "no velocity"),
    "velocity zero": (element("joint5", 'velocity="3.560472"', 'velocity="0"'), "velocity 0"),
    "velocity NaN": (element("joint5", 'velocity="3.560472"', 'velocity="nan"'), "'nan', expected a finite number"),
    "limit infinite": (element("joint5", 'upper="2.967060"', 'upper="inf"'), "'inf', expected a finite number"),
    "limit overflows": (element("joint5", 'upper="2.967060"', 'upper="1e999"'), "'1e999'"),
    "limits crossed": (element("joint5", 'upper="2.967060"', 'upper="-3"'), "lower -2.96706, upper -3"),
    "limits in degrees": (element("joint5", 'upper="2.967060"', 'upper="170"'), "upper 170.*rad"),
    "limit in words": (element("joint5", 'upper="2.967060"', 'upper="${pi}"'), "upper: found '.{pi}'"),
    "axis zero": (element("joint2", 'xyz="0 -1 0"', 'xyz="0 0 0"'), "axis: found .*a direction"),
    "axis NaN": (element("joint2", 'xyz="0 -1 0"', 'xyz="0 nan 0"'), "axis xyz: found '0 nan 0'"),
    "axis of two": (element("joint2", 'xyz="0 -1 0"', 'xyz="0 -1"'), "3 finite numbers"),
    "origin NaN": (element("joint2", 'xyz="0 0 0.2005"', 'xyz="0 0 nan"'), "xyz: found '0 0 nan'"),
    "origin with underscores": (element("joint2", 'xyz="0 0 0.2005"', 'xyz="0 0 1_0"'), "'0 0 1_0'"),
    "origin in the next town": (element("joint2", 'xyz="0 0 0.2005"', 'xyz="0 0 2e7"'), "SI units"),
    "box of nothing": (
        element("link2", 'size="0.13 0.13 0.16"', 'size="0.13 0 0.16"'),
        "link 'link2': box size.*positive",
    ),
    "box inside out": (element("link2", 'size="0.13 0.13 0.16"', 'size="0.13 -0.1 0.16"'), "box size.*positive"),
    "cylinder without radius": (element("link2", 'radius="0.06"', ""), "cylinder radius: found no value"),
    "sphere of radius NaN": (
        element("link3", 'sphere radius="0.065"', 'sphere radius="NaN"'),
        "sphere radius: found 'NaN'",
    ),
    "unknown shape": (element("link2", '<box size="0.13 0.13 0.16"/>', "<cone/>"), "geometry: found"),
    "no shape": (element("link2", '<box size="0.13 0.13 0.16"/>', ""), "geometry: found"),
    "no mass": (element("link4", '<mass value="2.3"/>', ""), "link 'link4': inertial: found no mass"),
    "mass NaN": (element("link4", 'mass value="2.3"', 'mass value="NaN"'), "mass value: found 'NaN'"),
    "mass negative": (element("link4", 'mass value="2.3"', 'mass value="-2.3"'), "mass: found -2.3 kg"),
    "no inertia": (
        swap('<inertia ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"/>', ""),
        "'base': inertial: found no inertia",
    ),
    "inertia negative": (element("link4", 'izz="0.004"', 'izz="-0.004"'), "negative moment"),
    "inertia infinite": (element("link4", 'ixy="0"', 'ixy="inf"'), "inertia ixy: found 'inf'"),
    "inertia incomplete": (element("link4", 'iyz="0"', ""), "inertia iyz: found no value"),
}

NO_BODY: dict[str, tuple[Callable[[], str], str]] = {
    "moving link without inertial": (
        lambda: re.sub(r'(<link name="link6">)\s*<inertial>.*?</inertial>', r"\1", GOOD, flags=re.DOTALL),
        "link 'link6': found no inertial",
    ),
    "mass zero": (element("link6", 'mass value="1.5"', 'mass value="0"'), "link 'link6': mass: found 0 kg"),
    "inertia not definite": (element("link6", 'ixy="0"', 'ixy="0.005"'), "principal moment of -0.001"),
    "triangle inequality": (element("link6", 'izz="0.004"', 'izz="0.0081"'), "sum of the other two"),
}

BAD_MESHES = {
    "absolute": "/etc/passwd",
    "a package": "package://lwr/meshes/base.stl",
    "a URL": "file:///etc/passwd",
    "outside": "../../secret.stl",
    "not there": "meshes/none.stl",
    "for Windows": "..\\\\secret.stl",
    "a folder": "meshes",
}


@pytest.mark.parametrize("name", BROKEN)
def test_a_malformed_or_hostile_urdf_is_refused_in_one_sentence(name: str) -> None:
    make, words = BROKEN[name]
    with pytest.raises(BadRobot, match=words) as caught:
        check_urdf(make(), "arm.urdf").chain(*FRAMES)
    assert str(caught.value).startswith("arm.urdf")
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 400


@pytest.mark.parametrize("name", NO_BODY)
def test_a_link_that_cannot_exist_is_refused_for_a_cell_but_not_for_a_recording(name: str) -> None:
    make, words = NO_BODY[name]
    urdf = check_urdf(make(), "arm.urdf")
    assert len(urdf.chain(*FRAMES)) == 7
    with pytest.raises(BadRobot, match=words):
        urdf.check_bodies(*FRAMES)


@pytest.mark.parametrize("name", BAD_MESHES)
def test_a_mesh_outside_the_folder_is_refused(name: str, tmp_path: Path) -> None:
    (tmp_path / "arm" / "meshes").mkdir(parents=True)
    (tmp_path / "secret.stl").write_text("solid")
    box = '<box size="0.13 0.13 0.16"/>'
    urdf = check_urdf(swap(box, f'<mesh filename="{BAD_MESHES[name]}"/>')(), "arm.urdf")
    with pytest.raises(BadRobot, match="mesh: found"):
        urdf.check_meshes(tmp_path / "arm")


def test_a_mesh_that_a_link_leads_outside_is_refused(tmp_path: Path) -> None:
    (tmp_path / "arm").mkdir()
    (tmp_path / "secret.stl").write_text("solid")
    (tmp_path / "arm" / "link.stl").symlink_to(tmp_path / "secret.stl")
    urdf = check_urdf(swap('<box size="0.13 0.13 0.16"/>', '<mesh filename="link.stl"/>')(), "arm.urdf")
    with pytest.raises(BadRobot, match="leads outside"):
        urdf.check_meshes(tmp_path / "arm")


def test_a_mesh_inside_the_folder_is_taken(tmp_path: Path) -> None:
    (tmp_path / "meshes").mkdir()
    (tmp_path / "meshes" / "link.stl").write_text("solid")
    urdf = check_urdf(swap('<box size="0.13 0.13 0.16"/>', '<mesh filename="meshes/link.stl" scale="1 1 1"/>')(), "arm.urdf")
    urdf.check_meshes(tmp_path)


@pytest.mark.parametrize("cell", sorted(folder.name for folder in CELLS.iterdir() if folder.is_dir()))
def test_joints_and_limits_are_those_that_pinocchio_reads(cell: str) -> None:
    text = (CELLS / cell / "robot.urdf").read_text()
    urdf = check_urdf(text, "arm.urdf")
    model = pin.buildModelFromXML(text)
    hinges = urdf.hinges(*FRAMES)
    assert [hinge.name for hinge in hinges] == list(model.names)[1:]
    np.testing.assert_array_equal([hinge.lower for hinge in hinges], model.lowerPositionLimit)
    np.testing.assert_array_equal([hinge.upper for hinge in hinges], model.upperPositionLimit)
    np.testing.assert_array_equal([hinge.velocity for hinge in hinges], model.upperVelocityLimit)
    for body in urdf.bodies:
        joint = model.frames[model.getFrameId(body.name)].parentJoint
        if body.mass is not None and joint > 0:
            np.testing.assert_allclose(model.inertias[joint].mass, body.mass)
            np.testing.assert_allclose(model.inertias[joint].inertia, body.inertia, atol=1e-12)


def test_a_chain_may_start_behind_other_joints() -> None:
    assert check_urdf(GOOD, "arm.urdf").chain("link4", "ft_sensor") == ("joint5", "joint6", "joint7")


@pytest.mark.parametrize(
    ("base", "tip", "words"),
    [
        ("base", "tool", "'tool', expected one of the links"),
        ("ft_sensor", "base", "no chain of joints from 'ft_sensor'"),
        ("link7", "ft_sensor", "no moving joint"),
    ],
)
def test_frames_that_no_moving_chain_connects_are_refused(base: str, tip: str, words: str) -> None:
    with pytest.raises(BadRobot, match=words):
        check_urdf(GOOD, "arm.urdf").chain(base, tip)


def test_joints_beside_the_chain_may_be_of_any_kind() -> None:
    grip = JOINT.format("ft_sensor", "finger").replace("fixed", "prismatic")
    assert len(check_urdf(add('<link name="finger"/>' + grip)(), "arm.urdf").chain(*FRAMES)) == 7


def test_a_real_recordings_urdf_is_read_though_its_meshes_are_elsewhere() -> None:
    file = REAL / "kuka-lwr4-torques-1" / "robot.urdf"
    urdf = check_urdf(file.read_text(), str(file))
    assert urdf.chain("box", "lwr_7_link") == tuple(f"lwr_{k}_joint" for k in range(7))
    with pytest.raises(BadRobot, match="package://"):
        urdf.check_meshes(file.parent)


@settings(max_examples=150, deadline=None)
@given(position=st.floats(0, 1, exclude_max=True), letter=st.characters(codec="utf-8"))
def test_one_wrong_letter_is_refused_or_leaves_an_arm_of_seven_joints(position: float, letter: str) -> None:
    k = int(position * len(GOOD))
    text = GOOD[:k] + letter + GOOD[k + 1 :]
    joints = tuple(f"joint{j}" for j in range(1, 8))
    try:
        robot = RobotModel(RobotDescription(text, joints, *FRAMES), where="arm.urdf")
    except BadRobot as error:
        assert "\n" not in str(error)
    else:
        assert robot.n == 7
        assert np.isfinite(robot.sensor_pose(np.zeros(7)).position).all()
