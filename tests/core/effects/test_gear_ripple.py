"""Ripple of gears."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.effects.gear_ripple import GearRipple
from tests.core.effects.mechanical_truth import SIGMA, Array, T, change, rms, scene


@pytest.mark.parametrize(
    ("amplitude", "shown"),
    [
        # at one size, a joint near the tool moves the payload too little: its ripple drowns in the highest of some 200 peaks of noise
        (np.full(7, 1e-4), 6),
        (np.array([1.0, 1.0, 1.0, 1.0, 3.0, 3.0, 6.0]) * 1e-4, 7),
    ],
    ids=["alike", "larger near the tool"],
)
def test_the_gear_ratio_of_every_joint_whose_ripple_stands_out_is_in_the_start_of_the_fit(amplitude: Array, shown: int) -> None:
    slow = replace(scene(), dq=0.15 * scene().dq, t=T / 0.15)
    ratios = np.array([81.0, 81.0, 50.5, 100.0, 60.0, 50.5, 81.0])
    theta = np.column_stack([ratios, amplitude, -amplitude])
    planted = change(GearRipple(), theta.ravel(), slow)
    alone = [change(GearRipple(), np.where(np.arange(7)[:, None] == j, theta, 0.0).ravel(), slow) for j in range(7)]
    stands_out = np.array([rms(x) for x in alone]) * np.sqrt(planted.size) > 4.0  # standard deviations, which of 200 peaks none reaches
    assert stands_out.sum() == shown
    (start,) = GearRipple().starts(slow, planted / SIGMA + np.random.default_rng(4).normal(size=planted.shape))
    half_width = 0.5 * np.pi / np.ptp(slow.q, axis=0)  # of a peak over the angle that a joint sweeps
    off = np.abs(start[::3] - ratios)
    assert (off < half_width)[stands_out].all(), off
    assert off[np.argsort([-rms(x) for x in alone])[:4]].max() < 0.5
