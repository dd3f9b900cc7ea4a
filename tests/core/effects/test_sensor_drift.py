"""The limits of slow drift, written down by hand."""

from __future__ import annotations

import numpy as np

from core.effects.sensor_drift import SensorDrift
from tests.core.effects.synthetic_scene import scene

RUN = scene(seconds=18.0)
W = RUN.nominal
DRIFT = np.array([1.0, -0.5, 0.8, 0.03, 0.0, -0.05])


def test_a_ramp_is_the_limit_of_slow_drift() -> None:
    theta = np.append(DRIFT, np.zeros(7))
    expected = W + np.outer(RUN.t / 60.0, DRIFT)
    np.testing.assert_allclose(SensorDrift().wrench(RUN, W, theta), expected, atol=1e-12)
    theta[6] = 1e-6
    np.testing.assert_allclose(SensorDrift().wrench(RUN, W, theta), expected, atol=1e-4)


def test_drift_follows_the_temperature_where_it_is_recorded() -> None:
    theta = np.append(np.zeros(7), [0.2, 0, 0, 0, 0, 0.01])
    W_ = SensorDrift().wrench(RUN, W, theta)
    rise = RUN.temperature - RUN.temperature[0]
    np.testing.assert_allclose(W_[:, 0], W[:, 0] + 0.2 * rise)
    np.testing.assert_allclose(W_[:, 5], W[:, 5] + 0.01 * rise)
