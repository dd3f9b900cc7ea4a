"""A jump that comes back in part, against a first-order creep that SciPy simulates."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import lsim

from bench.calibration.planting import plant_trial
from core.effects.library import library
from core.effects.offset_step_that_recovers import OffsetStepThatRecovers
from core.effects.sensor_offset_step import SensorOffsetStep
from core.gap.basis import basis_of
from core.gap.evidence import gather
from core.gap.fit_all import one_by_one
from core.gap.windows import Windows
from tests.core.effects.synthetic_scene import scene

RUN = scene()
EFFECT = OffsetStepThatRecovers()
JUMP = np.array([1.0, -2.0, 0.5, 0.1, 0.0, -0.05])
KNOCK = 372
"""A trial whose sensor is knocked, and recovers in part."""


@pytest.mark.parametrize(("kept", "recovery"), [(0.7, 1.5), (0.2, 4.0), (1.2, 0.8)])
def test_the_share_that_does_not_stay_creeps_back(kept: float, recovery: float) -> None:
    t = RUN.elapsed
    row = len(t) // 3
    jumped = (np.arange(len(t)) >= row).astype(float)
    crept = lsim(([1.0 - kept], [recovery, 1.0]), jumped, t, interp=False)[1]
    theta = np.concatenate((JUMP, [t[row] - RUN.period], [kept, recovery]))
    added = EFFECT.wrench(RUN, RUN.nominal, theta) - RUN.nominal
    late = 2.0 * RUN.period / recovery  # the jump takes a sample
    np.testing.assert_allclose(added, np.outer(jumped - crept, JUMP), atol=late * np.abs(JUMP).max())


def test_a_jump_that_stays_is_the_plain_one() -> None:
    plain = np.append(JUMP, 0.4 * RUN.elapsed[-1])
    np.testing.assert_allclose(
        EFFECT.wrench(RUN, RUN.nominal, np.append(plain, [1.0, 3.0])), SensorOffsetStep().wrench(RUN, RUN.nominal, plain), atol=1e-12
    )


def test_it_starts_at_the_jump_that_shows_most() -> None:
    residual = np.random.default_rng(2).normal(size=(len(RUN), 6)) + 20.0 * np.outer(RUN.elapsed > 3.0, np.sign(JUMP))
    for start in EFFECT.starts(RUN, residual):
        assert start[6] == pytest.approx(3.0, abs=2.0 * RUN.period)


def test_beside_the_plain_jump_it_begins_larger_and_ends_as_large() -> None:
    plain = np.append(JUMP, 3.0)
    for start in EFFECT.starts_beside(RUN, np.zeros((len(RUN), 6)), plain):
        np.testing.assert_allclose(start[:6] * start[7], JUMP)
        assert start[6] == plain[6]


def test_a_knock_is_a_jump_and_no_contact_beside_one() -> None:
    names = ("sensor_offset_step", "external_contact", "sensor_drift", "sensor_creep", "time_delay")
    effects = [effect for effect in library() if effect.id in names]
    evidence = gather(Windows(basis_of(plant_trial(KNOCK).recording)), effects, one_by_one)
    assert (evidence.verdict, evidence.best.name) == ("explained", "sensor_offset_step")
    assert isinstance(evidence.best.effects[0], OffsetStepThatRecovers)
