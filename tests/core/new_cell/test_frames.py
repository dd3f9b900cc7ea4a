"""Where the arm begins and ends, and what hangs behind the sensor."""

from __future__ import annotations

from pathlib import Path

import pytest

from core.errors import BadRobot
from core.new_cell.frames import ArmFrames, choose_frames
from core.new_cell.order import Behind, CellOrder
from core.new_cell.robot_tree import RobotTree
from core.words.message import Message
from tests.core.new_cell.small_arm import arm, joint, link

HAND = (
    link("hand") + joint("grip", "flange", "hand", kind="fixed", rest="") + '<link name="tip"/>'
    + joint("tip_joint", "hand", "tip", kind="fixed", rest="")
)  # fmt: skip


def chosen(text: str, ask: object = None, **wanted: object) -> tuple[ArmFrames, list[Message]]:
    notes: list[Message] = []
    return choose_frames(RobotTree(text, "arm.urdf"), CellOrder("tried", Path("arm.urdf"), **wanted), ask, notes), notes


def test_by_default_the_arm_goes_from_its_first_joint_to_its_last_bare_link():
    frames, notes = chosen(arm('<link name="world"/>' + joint("stand", "world", "base", kind="fixed", rest="")))
    assert (frames.base, frames.sensor, len(frames.joints), frames.tool) == ("base", "flange", 6, ())
    assert Message.of("newcell-sensor-last", link="flange") in notes
    assert Message.of("newcell-base-chosen", link="base") in notes


def test_a_gripper_of_hinges_is_no_part_of_the_arm():
    gripper = link("gripper") + joint("gripper_joint", "flange", "gripper")
    frames, _ = chosen(arm(gripper), behind=Behind.TOOL)
    assert frames.sensor == "flange"
    assert frames.tool == ("gripper",)


def test_a_link_with_the_name_of_a_sensor_is_taken():
    more = link("wrist_ft_link") + joint("w", "flange", "wrist_ft_link", kind="fixed", rest="") + link("plate")
    frames, _ = chosen(arm(more + joint("p", "wrist_ft_link", "plate", kind="fixed", rest="")), behind=Behind.TOOL)
    assert frames.sensor == "wrist_ft_link"


def test_links_behind_the_sensor_are_asked_about(monkeypatch):
    monkeypatch.setenv("HEFT_LANGUAGE", "en")
    asked = []

    def answer(question: str, possible: tuple[str, ...]) -> str:
        asked.append((question, possible))
        return "robot"

    frames, _ = chosen(arm(HAND), answer)
    assert frames.sensor == "tip"
    assert frames.tool == ()
    assert asked[0][0] == "Behind the sensor frame 'flange' hang hand. Does the sensor carry them (tool), or sit behind them (robot)?"
    assert asked[0][1] == ("tool", "robot")


def test_a_german_is_asked_in_german(monkeypatch):
    monkeypatch.setenv("HEFT_LANGUAGE", "de")
    asked = []
    chosen(arm(HAND), lambda question, _possible: asked.append(question) or "tool")
    assert asked == [
        "Hinter dem Sensorkoordinatensystem „flange“ hängen hand. Trägt der Sensor sie (tool), oder sitzt er hinter ihnen (robot)?"
    ]


def test_nobody_to_ask_is_a_refusal_that_lists_them():
    with pytest.raises(BadRobot, match=r"'flange'.*hand.*--behind-sensor tool"):
        chosen(arm(HAND))


def test_what_hangs_beside_the_sensor_is_told():
    _, notes = chosen(arm(link("camera") + joint("c", "link6", "camera", kind="fixed", rest="")))
    assert Message.of("newcell-beside-sensor", links=["camera"]) in notes


def test_a_mount_adds_a_link():
    frames, _ = chosen(arm(), mount="flange", mount_xyz=(0.0, 0.0, 0.02))
    assert frames.sensor == "ft_sensor"


@pytest.mark.parametrize(
    ("text", "wanted", "words"),
    [
        (arm(), {"sensor_frame": "nose"}, "no such link"),
        (arm(), {"mount": "nose"}, "no such link"),
        (arm(), {"base_frame": "nose"}, "no such link"),
        (arm(), {"base_frame": "flange"}, "no chain of joints"),
        (arm(), {"base_frame": "link6"}, "no moving joint"),
        (arm(), {"sensor_frame": "base", "behind": Behind.TOOL}, "no moving joint"),
        (arm(joints={1: joint("lift", "base", "link1", kind="prismatic")}), {}, r"'lift'.*prismatic.*--base-frame link1"),
        ('<robot name="r"><link name="a"/></robot>', {}, "no joint that turns"),
    ],
)
def test_frames_that_are_no_arm_are_refused(text, wanted, words):
    with pytest.raises(BadRobot, match=words):
        chosen(text, **wanted)


def test_a_prismatic_joint_below_the_base_frame_is_no_matter():
    lifted = arm(joints={1: joint("lift", "base", "link1", kind="prismatic")})
    frames, _ = chosen(lifted, base_frame="link1")
    assert [each.name for each in frames.joints] == ["joint2", "joint3", "joint4", "joint5", "joint6"]
