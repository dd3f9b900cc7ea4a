"""A description can be changed without changing what it says of the rest."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest

from core.errors import BadRobot
from core.new_cell.robot_tree import RobotTree
from tests.core.new_cell.small_arm import LIMIT, arm, joint, link


def tree(extra: str = "", **changed: dict[int, str]) -> RobotTree:
    return RobotTree(arm(extra, **changed), "arm.urdf")


def place_of(text: str, frame: str, moved: str | None = None, value: float = 0.0) -> np.ndarray:
    """(4, 4) of a frame, by Pinocchio, one joint moved."""
    model = pin.buildModelFromXML(text)
    q = pin.neutral(model)
    if moved is not None:
        q[model.joints[model.getJointId(moved)].idx_q] = value
    data = model.createData()
    pin.framesForwardKinematics(model, data, q)
    return np.asarray(data.oMf[model.getFrameId(frame)].homogeneous)


@pytest.mark.parametrize(("kind", "value"), [("revolute", 0.7), ("prismatic", 0.03), ("revolute", 0.0)])
def test_a_fixed_joint_stands_where_the_moving_one_stood(kind, value):
    origin = '<origin xyz="0.1 0.2 0.3" rpy="0.4 -0.5 0.6"/><axis xyz="0.6 0 0.8"/><limit lower="-1" upper="1" velocity="1" effort="1"/>'
    finger = f'{link("finger")}<joint name="slide" type="{kind}"><parent link="flange"/><child link="finger"/>{origin}</joint>'
    changed = tree(finger)
    expected = place_of(changed.text, "finger", "slide", value)
    changed.fix(next(each for each in changed.checked.joints if each.name == "slide"), value)
    assert pin.buildModelFromXML(changed.text).nq == 6
    assert np.allclose(place_of(changed.text, "finger"), expected, atol=1e-9)


def test_what_is_no_link_and_no_joint_is_left_out():
    text = tree('<gazebo reference="base"><x/></gazebo><transmission name="t"/><material name="m"/>').text
    assert not {"gazebo", "transmission", "material"} & {word.strip("<") for word in text.split()}
    assert text.count("<joint ") == 7


def test_a_new_link_needs_a_name_of_its_own():
    changed = tree()
    changed.add_link("ft_sensor", "flange", np.array([0.0, 0.0, 0.03]), np.zeros(3))
    assert np.allclose(place_of(changed.text, "ft_sensor")[:3, 3] - place_of(changed.text, "flange")[:3, 3], [0, 0, 0.03])
    assert [each.name for each in changed.path("ft_sensor")][-1] == "ft_sensor_joint"
    with pytest.raises(BadRobot, match="already in the description"):
        changed.add_link("ft_sensor", "flange", np.zeros(3), np.zeros(3))


def test_a_tree_knows_what_hangs_behind_a_link():
    changed = tree(link("hand") + joint("grip", "flange", "hand", kind="fixed", rest=""))
    assert changed.behind("flange") == ["hand"]
    assert changed.is_body("hand")
    assert not changed.is_body("flange")


def test_a_name_that_cannot_be_printed_is_refused():
    with pytest.raises(BadRobot, match="can be printed"):
        tree(f"{link('a&#x85;b')}{joint('j', 'flange', 'a&#x85;b', kind='fixed', rest='')}")


def test_a_joint_with_the_name_of_a_link_gets_one_of_its_own():
    changed = tree(
        link("grip") + joint("grip", "flange", "grip") + link("x") + joint("x_joint", "grip", "x", rest=LIMIT + '<mimic joint="grip"/>')
    )
    assert {"grip_joint", "x_joint"} < {each.name for each in changed.checked.joints}
    assert changed.joint("x_joint").find("mimic").get("joint") == "grip_joint"
    assert place_of(changed.text, "grip").shape == (4, 4)
