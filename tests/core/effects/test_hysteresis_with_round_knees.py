"""Loops that bend and loops that began elsewhere, against their differential equation and plays that are written down here."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from core.effects.hysteresis_with_round_knees import HysteresisWithRoundKnees
from core.effects.memory import Memory
from core.effects.sensor_hysteresis import SensorHysteresis
from tests.core.effects.synthetic_scene import NOISE, RANGE, scene

Array = np.ndarray
RUN = scene()
EFFECT = HysteresisWithRoundKnees()
HEIGHTS = np.array([0.003, -0.002, 0.001, 0.004, 0.002, 0.003])
TURNING = np.array([0.02, 0.03, 0.01, 0.05, 0.04, 0.02])


def planted(start: float, roundness: float) -> Array:
    """(15,), loops of one turning load in each channel."""
    return np.concatenate((HEIGHTS, np.log(TURNING), [0.0, start, roundness]))


def sweep_from(share: float) -> Array:
    """(N + 1, 6), loads: straight from that share of the first, then those of the run."""
    return np.vstack((share * RUN.nominal[:1], RUN.nominal))


def bouc_wen(loads: Array) -> Array:
    """(N, 6), between -1 and 1, `dy = (dw - |dw| y) / R` in 50 steps of the midpoint rule from row to row."""
    y, out = np.zeros(6), []
    for here, there in pairwise(loads):
        for _ in range(50):
            dw = (there - here) / 50 / (TURNING * RANGE)
            y = y + dw - np.abs(dw) * (y + 0.5 * (dw - np.abs(dw) * y))
        out.append(y)
    return np.array(out)


def stops(loads: Array) -> Array:
    """(N, 6), between -1 and 1, of what slides at R and is a spring before."""
    held, out = np.zeros(6), []
    for here, there in pairwise(loads):
        held = np.clip(held + there - here, -TURNING * RANGE, TURNING * RANGE)
        out.append(held / (TURNING * RANGE))
    return np.array(out)


@pytest.mark.parametrize("start", [0.0, 0.6, 1.0])
def test_round_loops_bend_as_bouc_wen_has_it_from_the_load_where_they_start(start: float) -> None:
    expected = RUN.nominal - HEIGHTS * RANGE * bouc_wen(sweep_from(start))
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, planted(start, 1.0)), expected, atol=0.01 * (np.abs(HEIGHTS) * RANGE).min())


@pytest.mark.parametrize("start", [0.0, 0.6, 1.0])
def test_sharp_loops_hold_back_what_springs_do_that_slide_from_the_load_where_they_start(start: float) -> None:
    expected = RUN.nominal - HEIGHTS * RANGE * stops(sweep_from(start))
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, planted(start, 0.0)), expected, atol=1e-9)


def test_sharp_loops_that_start_at_the_first_load_are_the_plain_ones() -> None:
    theta = np.concatenate((HEIGHTS, np.log(TURNING), [0.5, 1.0, 0.0]))
    plain = SensorHysteresis().wrench(RUN, RUN.nominal, theta[:13])
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, theta), plain, atol=1e-9)
    absent = [p.absent for p in EFFECT.parameters(RUN)]
    assert absent[13:] == [1.0, 0.0]


def test_rows_in_blocks_give_the_loops_of_the_whole() -> None:
    theta, memory = planted(0.3, 0.4), Memory()
    edges = (0, 1, 700, 701, len(RUN))
    blocks = [EFFECT.wrench(replace(RUN[a:b], memory=memory), RUN.nominal[a:b], theta) for a, b in pairwise(edges)]
    np.testing.assert_allclose(np.concatenate(blocks), EFFECT.wrench(RUN, RUN.nominal, theta), atol=1e-9)


def test_loops_are_sought_where_the_reading_stays_while_the_load_rests_and_not_where_it_creeps() -> None:
    noise = np.random.default_rng(5).normal(size=RUN.nominal.shape) * 0.2
    loop = -30.0 * np.sign(HEIGHTS) * stops(sweep_from(0.0))
    crept = np.empty_like(loop)
    y = RUN.nominal[0]
    for k, w in enumerate(RUN.nominal):  # follows within two seconds
        y = y + 0.005 * (w - y)
        crept[k] = y - w
    starts = EFFECT.starts(RUN, loop + noise)
    assert {tuple(theta[13:]) for theta in starts} == {(0.0, 0.0), (1.0, 0.5)}
    assert EFFECT.starts(RUN, 0.05 * crept / NOISE + noise) == []


def test_where_the_loops_began_is_of_one_run() -> None:
    assert EFFECT.explain_tie_to_run(RUN) is not None
    assert EFFECT.parameters(RUN)[EFFECT.smaller_shape(RUN)].name == "loop_roundness_share"
