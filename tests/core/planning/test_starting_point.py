"""Where a plan begins: as numbers, as a recording that ended there, as a file; anything else is refused in words."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.errors import BadInput
from core.planning.starting_point import starting_point
from core.recording.folder import write_recording
from core.robot.model import RobotModel
from core.sessions.sample_log import SampleLog
from core.sessions.session import RobotState

CELL = load_cell(Path(__file__).parents[3] / "cells" / "ur5e_line")
ROBOT = RobotModel.of_cell(CELL)
Q = [0.1, -1.2, 1.5, -0.4, 1.1, 0.2]


def recording_that_ends_at(q: list[float], folder: Path) -> Path:
    log = SampleLog(CELL, ROBOT, payload=None, reference=None)
    way = np.linspace(0.0, 1.0, 60)[:, None] * np.array(q)
    states = [RobotState(t=0.002 * k, q=row + 1e-4, dq=np.zeros(6), q_cmd=row, wrench=np.zeros(6)) for k, row in enumerate(way)]
    log.extend(states, "transfer")
    write_recording(log.recording(), folder)
    return folder


def test_nothing_said_is_home() -> None:
    np.testing.assert_array_equal(starting_point(None, CELL, ROBOT), CELL.robot.home_rad)


def test_numbers_are_joint_positions_in_rad() -> None:
    np.testing.assert_array_equal(starting_point("0.1, -1.2,1.5,-0.4,1.1,0.2", CELL, ROBOT), Q)


def test_a_recording_says_where_its_robot_was_commanded_last(tmp_path: Path) -> None:
    folder = recording_that_ends_at(Q, tmp_path / "recording")
    np.testing.assert_allclose(starting_point(str(folder), CELL, ROBOT), Q, atol=1e-12)


def test_a_file_says_it_among_other_things(tmp_path: Path) -> None:
    file = tmp_path / "state.json"
    file.write_text(json.dumps({"robot": "ur5e", "q_rad": Q}))
    np.testing.assert_array_equal(starting_point(str(file), CELL, ROBOT), Q)


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ("0.1,0.2", "6 finite joint positions in rad, for shoulder_pan"),
        ("0,0,0,0,0,nan", "6 finite joint positions"),
        ("inf,0,0,0,0,0", "6 finite joint positions"),
        ("no/such/file", "the folder of a recording"),
        ("", "the folder of a recording"),
    ],
)
def test_what_is_no_place_is_refused_in_words(said: str, words: str) -> None:
    with pytest.raises(BadInput, match=words):
        starting_point(said, CELL, ROBOT)


@pytest.mark.parametrize(
    "content", ["{", "[1, 2]", '{"q_rad": "home"}', '{"q_rad": [1, null]}', "[" * 50_000, " " * 200_000, '{"q_rad": [1e999]}']
)
def test_a_file_that_says_something_else_is_refused_with_its_name(tmp_path: Path, content: str) -> None:
    file = tmp_path / "state.json"
    file.write_text(content)
    with pytest.raises(BadInput, match=r"state\.json"):
        starting_point(str(file), CELL, ROBOT)


def test_the_recording_of_another_robot_is_refused(tmp_path: Path) -> None:
    other = load_cell(CELL.folder.parent / "lwr4_bench")
    folder = recording_that_ends_at(Q, tmp_path / "recording")
    with pytest.raises(BadInput, match="another robot"):
        starting_point(str(folder), other, RobotModel.of_cell(other))
