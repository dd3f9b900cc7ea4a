"""Table 2(a): the variances of the sensor's noise, found again in the motionless phases of a recording."""

from __future__ import annotations

import numpy as np

from core.estimation.noise import sensor_noise
from core.estimation.segments import motionless, segments_of_phase
from tests.synthetic import RESOLUTION, Imperfections, payload, record, run_of

VARIANCE = np.array([3.0e-3, 2.3e-3, 5.3e-3, 7.9e-6, 9.3e-6, 9.2e-6])


def test_the_motionless_phases_give_the_variances_of_table_2() -> None:
    how = Imperfections(noise_std=np.sqrt(VARIANCE))
    recording = record(run_of("lwr4_bench", 0), payload("steel_block"), np.random.default_rng(2), how)
    assert recording.wrench is not None and recording.phase is not None
    parts = segments_of_phase(recording.phase)
    noise = sensor_noise(recording.t, recording.wrench, motionless(recording.t, parts), parts)
    assert noise is not None and noise.measured
    # the resolution of 1/16 N and 1/752 N m adds a twelfth of its square
    np.testing.assert_allclose(noise.std**2, VARIANCE + RESOLUTION**2 / 12, rtol=0.06)
    np.testing.assert_array_equal(noise.long_run, 1.0)
