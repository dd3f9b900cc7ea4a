"""An energy chain along one direction, against the work that friction and a spring do."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.effects.cable_on_rail import CableOnRail
from tests.core.effects.synthetic_scene import scene

RUN = scene()
EFFECT = CableOnRail()
ALONG = np.array([0.6, -0.8, 0.0])
FRICTION_N, STIFFNESS, PULL_N = 1.5, 8.0, 0.7
THETA = np.array([*FRICTION_N * ALONG, STIFFNESS, PULL_N, 0.0, 0.0, 0.0, 0.003])


def test_it_acts_along_its_direction_and_takes_the_work_of_a_spring_and_of_friction() -> None:
    assert RUN.position is not None
    change = EFFECT.wrench(RUN, RUN.nominal, THETA) - RUN.nominal
    force = -np.einsum("nij,nj->ni", RUN.rotation, change[:, :3])
    np.testing.assert_allclose(np.cross(force, ALONG), 0.0, atol=1e-9)
    way = (RUN.position - RUN.position[0]) @ ALONG
    work = -np.cumsum(0.5 * (force[1:] + force[:-1]) @ ALONG * np.diff(way))
    expected = FRICTION_N * np.cumsum(np.abs(np.diff(way))) + 0.5 * STIFFNESS * way[1:] ** 2 + PULL_N * way[1:]
    assert np.abs(work - expected).max() < 0.02 * np.abs(expected).max()


def test_a_start_is_along_the_direction_that_was_planted_with_about_its_sizes() -> None:
    noise = np.array([0.05, 0.05, 0.07, 0.003, 0.003, 0.003])
    seen = replace(RUN, noise=noise)
    residual = (EFFECT.wrench(seen, seen.nominal, THETA) - seen.nominal) / noise
    start = EFFECT.starts(seen, residual)[0]
    friction = float(np.linalg.norm(start[:3]))
    assert abs(start[:3] @ ALONG) / friction > np.cos(np.radians(20.0))
    assert friction == pytest.approx(FRICTION_N, rel=0.3)
    assert start[3] == pytest.approx(STIFFNESS, rel=0.3)


def test_it_needs_places_and_advises_freeing_the_hose() -> None:
    without = replace(RUN, position=None)
    assert EFFECT.explain_absence(without) is not None
    assert EFFECT.starts(without, np.zeros((len(RUN), 6))) == []
    with pytest.raises(ValueError, match="positions"):
        EFFECT.wrench(without, RUN.nominal, THETA)
    assert EFFECT.advice(RUN, THETA).parameters["friction_n"] == pytest.approx(FRICTION_N)
