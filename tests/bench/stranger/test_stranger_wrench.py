"""`bench.stranger.rigid_body` and `sensing`: the sign of the wrench, and the payload behind a recording without causes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

import bench.stranger.rig
from bench.stranger.kinematics import Felt
from bench.stranger.rig import Background, draw_rig
from bench.stranger.rigid_body import SYMMETRIC, find_regressor, find_wrench, read_push
from bench.stranger.sensing import sense

MASS = 2.0


def test_at_rest_with_x_along_gravity_fx_is_minus_the_weight() -> None:
    g = np.array([[9.81, 0.0, 0.0]])
    still = Felt(omega=np.zeros((1, 3)), alpha=np.zeros((1, 3)), u=-g, g=g)
    com = np.array([0.0, 0.0, 0.1])
    wrench = find_wrench(still, MASS, MASS * com, np.zeros((3, 3)))
    np.testing.assert_allclose(wrench, [[-MASS * 9.81, 0, 0, 0, -MASS * 9.81 * 0.1, 0]], atol=1e-12)
    np.testing.assert_allclose(read_push(MASS * g, com), wrench, atol=1e-12)


@pytest.mark.parametrize("seed", [900, 903])
def test_least_squares_find_the_payload_within_the_noise_where_nothing_is_planted(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bench.stranger.rig, "gaussian_filter1d", lambda x, *_, **__: x)  # takes seconds, of a drift that is left out
    rig = draw_rig(seed, kind="exc", rate=100, elastic=False)
    nothing = Background(np.zeros(rig.joint_count), np.zeros(3), np.zeros(6), np.zeros((rig.steps, 6)), None)
    rig = replace(rig, background=nothing)
    noise_std, body = rig.sensor.noise_std, rig.body
    A = (find_regressor(rig.feel(rig.nominal)) / noise_std[None, :, None]).reshape(-1, 16)
    y = (sense(rig, []) / noise_std + rig.white).ravel()
    found = np.linalg.lstsq(A, y)[0]
    truth = np.r_[body.mass, body.first_moment, [body.inertia[place] for place in SYMMETRIC], rig.sensor.offset]
    error = A @ (found - truth)
    assert chi2.cdf(error @ error, 16) == pytest.approx(0.5, abs=0.499)
    left = y - A @ found
    assert np.sqrt(np.mean(left**2)) == pytest.approx(1.0, abs=0.02)
