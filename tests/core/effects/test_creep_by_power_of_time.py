"""Creep by a power of time, against Boltzmann's superposition of steps, summed one by one."""

from __future__ import annotations

import numpy as np
import pytest

from core.effects.creep_by_power_of_time import EXPONENTS, UNIT_S, CreepByPowerOfTime
from tests.core.effects.synthetic_scene import scene

RUN = scene()
EFFECT = CreepByPowerOfTime()
SHARES = np.array([0.01, 0.02, -0.005, 0.0, 0.015, 0.01])


@pytest.mark.parametrize("exponent", [0.15, 0.3])
def test_every_step_of_load_is_followed_by_a_power_of_time(exponent: float) -> None:
    t, w = RUN.elapsed, RUN.nominal
    steps = np.diff(w, axis=0, prepend=w[:1])
    crept = np.zeros_like(w)
    for k in np.flatnonzero(np.abs(steps).max(axis=1) > 0.0):
        crept[k:] += np.multiply.outer(((t[k:] - t[k]) / UNIT_S) ** exponent, steps[k])
    theta = np.concatenate((SHARES, [10.0**exponent], np.zeros(6)))
    added = EFFECT.wrench(RUN, w, theta) - w
    added -= added[0]
    for c in np.flatnonzero(SHARES):  # what comes within a few hundredths of a second is a gain
        X = np.column_stack((SHARES[c] * crept[:, c], w[:, c] - w[0, c]))
        (size, gain), *_ = np.linalg.lstsq(X, added[:, c], rcond=None)
        assert size == pytest.approx(1.0, abs=0.1)
        assert abs(gain) < 0.6 * abs(SHARES[c])
        assert np.abs(added[:, c] - X @ [size, gain]).max() < 0.05 * np.abs(added[:, c]).max()


def test_what_crept_from_before_goes_on_and_is_its_size_after_a_minute() -> None:
    theta = np.concatenate((np.zeros(6), [10.0**0.25], SHARES))
    added = EFFECT.wrench(RUN, RUN.nominal, theta) - RUN.nominal
    t = RUN.elapsed[::20]
    for c in np.flatnonzero(SHARES):  # but for what had come within the first few hundredths of a second
        size, _ = np.polyfit((t[1:] / UNIT_S) ** 0.25, added[20::20, c], 1)
        assert size == pytest.approx(SHARES[c], rel=0.06)


def test_it_starts_as_little_creep_with_some_exponents() -> None:
    starts = EFFECT.starts(RUN, np.zeros((len(RUN), 6)))
    assert [np.log10(start[6]) for start in starts] == pytest.approx(EXPONENTS)
    assert all(len(start) == len(EFFECT.parameters(RUN)) for start in starts)
