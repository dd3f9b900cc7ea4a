"""A base that is not level, against physics that is written down here."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.effects.base_tilt import BaseTilt
from tests.core.effects.mechanical_truth import rms, scene, truth


@pytest.mark.parametrize("along", [[0, 0, -1], [0, 1, 0], [-1, 0, 0], [0.8, 0, -0.6]])
def test_a_base_on_the_wall_tilts_about_the_axes_that_turn_gravity(along: list[float]) -> None:
    gravity = 9.81 * np.array(along)
    rigid = truth()
    wall = replace(scene(), gravity=gravity, motion=replace(scene().motion, g=rigid.R.transpose(0, 2, 1) @ gravity))
    parameters = BaseTilt().parameters(wall)
    vector = np.zeros(3)
    theta = np.array([0.01, -0.02])
    for parameter, value in zip(parameters, theta, strict=True):
        vector["xyz".index(parameter.name[len("about_")])] = value
    true = rigid.wrench(g=Rotation.from_rotvec(vector).apply(gravity)) - rigid.wrench(g=gravity)
    np.testing.assert_allclose(BaseTilt().wrench(wall, wall.nominal, theta) - wall.nominal, true, atol=1e-6)
    moved = [rms(BaseTilt().wrench(wall, wall.nominal, unit) - wall.nominal) for unit in 0.01 * np.eye(2)]
    assert min(moved) > 0.5
