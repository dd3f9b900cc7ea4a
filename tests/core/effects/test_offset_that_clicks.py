"""Jumps by shares of one another, against sums of plain ones and a trial that was planted by other code."""

from __future__ import annotations

import numpy as np
import pytest

from bench.calibration.stage import set_stage
from core.effects.library import library
from core.effects.offset_that_clicks import OffsetThatClicks
from core.effects.sensor_offset_step import SensorOffsetStep
from core.effects.window_search import weights
from core.gap.basis import basis_of
from core.gap.evidence import gather
from core.gap.fit_all import one_by_one
from core.gap.windows import Windows
from core.plant.faults.sensor_offset import Clicks
from tests.core.effects.synthetic_scene import scene

RUN = scene()
EFFECT = OffsetThatClicks()
SEED = 11
JUMP = np.array([1.0, -2.0, 0.5, 0.1, 0.0, -0.05])


def test_the_first_is_plain_and_the_others_are_shares_of_it() -> None:
    theta = np.concatenate((JUMP, [2.0, 0.5, 3.0, -1.0, 6.0, 0.0, 7.0]))
    added = EFFECT.wrench(RUN, RUN.nominal, theta) - RUN.nominal
    plain = sum(
        SensorOffsetStep().wrench(RUN, np.zeros_like(added), np.append(share * JUMP, at))
        for share, at in ((1.0, 2.0), (0.5, 3.0), (-1.0, 6.0))
    )
    np.testing.assert_allclose(added, plain, atol=1e-12)
    assert added[-1] == pytest.approx(0.5 * JUMP, abs=1e-9)


def test_without_the_others_it_is_the_plain_one() -> None:
    absent = np.array([p.absent for p in EFFECT.parameters(RUN)[7:]])
    plain = np.append(JUMP, 3.0)
    np.testing.assert_array_equal(
        EFFECT.wrench(RUN, RUN.nominal, np.append(plain, absent)), SensorOffsetStep().wrench(RUN, RUN.nominal, plain)
    )


def test_it_starts_from_the_largest_jump_with_the_shares_of_the_others() -> None:
    rng = np.random.default_rng(8)
    shares = 0.4 * (RUN.elapsed > 4.0) + 1.0 * (RUN.elapsed > 5.0) + 0.6 * (RUN.elapsed > 6.2)
    residual = rng.normal(size=(len(RUN), 6)) + np.outer(shares, 20.0 * JUMP * weights(RUN))
    (start,) = EFFECT.starts(RUN, residual)
    np.testing.assert_array_equal(np.sign(start[[0, 1, 2, 3, 5]]), np.sign(JUMP[[0, 1, 2, 3, 5]]))
    assert start[6] == pytest.approx(5.0, abs=0.05)
    later = dict(zip(start[8::2], start[7::2], strict=True))
    for at, share in ((4.0, 0.4), (6.2, 0.6)):
        assert later[min(later, key=lambda t: abs(t - at))] == pytest.approx(share, abs=0.1)


def test_clicks_of_a_clamp_are_jumps_and_no_drift_that_is_over_soon() -> None:
    p = set_stage(SEED)
    clean, seconds = p.wrench.copy(), p.setting.seconds
    clicks = Clicks((4.0, -3.0, 2.0, 0.2, 0.1, -0.2), tuple(seconds * np.array([0.40, 0.42, 0.47])), (0.4, 0.35, 0.25))
    p.plant(clicks)
    names = ("sensor_offset_step", "external_contact", "sensor_drift", "sensor_creep", "payload_shift")
    evidence = gather(Windows(basis_of(p.record(clean))), [effect for effect in library() if effect.id in names], one_by_one)
    assert (evidence.verdict, evidence.best.name) == ("explained", "sensor_offset_step")
    assert isinstance(evidence.best.effects[0], OffsetThatClicks)
