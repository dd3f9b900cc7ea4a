"""What is bolted between sensor and payload, over HTTP: stated boxes as they stand, links as the boxes around them in the sensor frame."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from fastapi.testclient import TestClient
from scipy.spatial.transform import Rotation

from server.cells import tool_outlines
from server.people.roles import Role
from server.settings import Settings
from tests.core.handed import GRIPPER, HAND, HAND_AS_TOOL
from tests.server.made_people import As

PATH = "/api/cells/lwr4_bench/tools"
MOUNT = ((0.002, -0.003, 0.01), (0.1, -0.2, 0.7))
SLIDE = ((0.0, 0.02, 0.06), (0.0, 0.0, 0.4))
"""Of the hand in the sensor frame and of its finger in the hand, as their joints of the URDF have it: xyz (m), roll pitch yaw (rad)."""


@pytest.fixture
def viewer(signed_in: As) -> TestClient:
    return signed_in(Role.viewer)


def add(settings: Settings, file: str, text: str) -> None:
    """By hand, in the folder of the cell."""
    path = settings.cells_folder / "lwr4_bench" / file
    path.write_text(path.read_text().replace("</robot>", text + "</robot>") if file.endswith("urdf") else path.read_text() + text)


def test_a_cell_without_tools_has_none_and_one_that_is_not_there_is_told_as_that(viewer: TestClient) -> None:
    assert viewer.get(PATH).json() == []
    assert viewer.get(PATH.replace("lwr4_bench", "none")).status_code == 404


def test_a_tool_that_states_its_box_is_that_box(viewer: TestClient, settings: Settings) -> None:
    add(settings, "cell.toml", GRIPPER)
    [gripper] = viewer.get(PATH).json()
    assert (gripper["name"], gripper["title"]) == ("gripper", "Two-finger gripper")
    [box] = gripper["boxes"]
    assert (box["size_m"], box["pose"]["xyz_m"]) == ([0.12, 0.08, 0.07], [0.005, 0.0, 0.035])


def test_a_tool_of_links_is_a_box_around_each_of_them_where_the_urdf_has_it(viewer: TestClient, settings: Settings) -> None:
    add(settings, "robot.urdf", HAND.format(parent="ft_sensor"))
    add(settings, "cell.toml", HAND_AS_TOOL)
    [hand] = viewer.get(PATH).json()
    expected = [around((0.08, 0.06, 0.06), 0.03, MOUNT), around((0.02, 0.02, 0.04), 0.02, SLIDE, MOUNT)]
    assert len(hand["boxes"]) == 2
    for box, (low, high) in zip(sorted(hand["boxes"], key=lambda each: -each["size_m"][0]), expected, strict=True):
        np.testing.assert_allclose(box["size_m"], high - low, atol=1.1e-4)
        np.testing.assert_allclose(box["pose"]["xyz_m"], (low + high) / 2, atol=1.1e-4)


def around(size_m: tuple[float, ...], up_m: float, *frames: tuple[tuple[float, ...], tuple[float, ...]]) -> tuple[np.ndarray, np.ndarray]:
    """The corners that bound a box which stands so high in the first of these frames, seen from outside the last, m."""
    corners = np.array([[sign * length / 2 for sign, length in zip(signs, size_m, strict=True)] for signs in product((-1, 1), repeat=3)])
    corners += [0.0, 0.0, up_m]
    for xyz_m, rpy_rad in frames:
        corners = Rotation.from_euler("xyz", rpy_rad).apply(corners) + xyz_m
    return corners.min(axis=0), corners.max(axis=0)


def test_links_are_looked_at_once_for_each_state_of_the_cells_files(
    viewer: TestClient, settings: Settings, monkeypatch: pytest.MonkeyPatch
) -> None:
    looks, run_work = [], tool_outlines.run_work
    monkeypatch.setattr(tool_outlines, "run_work", lambda *told: looks.append(told) or run_work(*told))
    add(settings, "robot.urdf", HAND.format(parent="ft_sensor"))
    add(settings, "cell.toml", HAND_AS_TOOL)
    first = viewer.get(PATH).json()
    assert viewer.get(PATH).json() == first
    assert len(looks) == 1
    path = settings.cells_folder / "lwr4_bench" / "robot.urdf"
    path.write_text(path.read_text().replace('<box size="0.02 0.02 0.04"/>', '<box size="0.02 0.02 0.08"/>'))
    assert viewer.get(PATH).json() != first
    assert len(looks) == 2
