"""The on-line estimation finds what the paper's does off line, up to the filter's lag."""

from __future__ import annotations

import numpy as np

from core.estimation.online import OnlineEstimator
from tests.synthetic import GRAVITY, NOISE_STD, payload, record, run_of


def test_on_line_estimates_appear_as_the_motion_allows_them() -> None:
    run, body = run_of("lwr4_bench", 0), payload("steel_block")
    recording = record(run, body, np.random.default_rng(0))
    assert recording.q is not None and recording.wrench is not None
    estimator = OnlineEstimator(run.robot, GRAVITY, period=1e-3, noise_std=NOISE_STD, encoder_std=2e-6)
    half_way = early = None
    for k in range(len(recording)):
        estimator.update(recording.q[k], recording.wrench[k])
        if k == len(recording) // 2:
            half_way, early = estimator.estimate, estimator.so_far
    assert half_way is not None
    assert early is not None
    # before the z axis was seen both ways there is no offset for it, and no mass
    assert np.isnan(half_way.phi[0])
    assert not np.isnan(half_way.phi[4])
    # but the poses that were held determine it, with the other offsets
    assert abs(early.phi[0] - body.mass) < 4.0 * early.std[0] < 0.01 * body.mass
    assert (np.abs(early.phi[1:4] - body.first_moment) < 4.0 * early.std[1:4]).all()
    np.testing.assert_array_equal(early.phi[4:], half_way.phi[4:])
    final = estimator.estimate
    np.testing.assert_array_equal(estimator.so_far.phi, final.phi)
    np.testing.assert_allclose(final.phi[0], body.mass, rtol=1e-3)
    np.testing.assert_allclose(final.phi[1:4], body.first_moment, atol=2e-4)
    np.testing.assert_allclose(final.phi[[4, 7, 9]], body.phi[[4, 7, 9]], rtol=0.08)
    assert np.isnan(final.phi[[5, 6, 8]]).all()
    np.testing.assert_allclose(final.offset[:3], [3.1, -2.2, 5.3], atol=0.01)
    assert np.abs(estimator.motion.omega).max() < 0.01
