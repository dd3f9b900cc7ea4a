"""A lag that is the shorter the quicker a joint turns, against the wrench of point masses on joints that are that far ahead, and against a
1-euro filter that is run step by step."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.effects.kinematic_lag import KinematicLag
from core.effects.lag_that_opens import LagThatOpens
from core.effects.library import wider_shapes
from tests.core.effects.mechanical_truth import Array, T, believed, change, rms, scene, truth

EFFECT = LagThatOpens()
STARTED = slice(10, None)
"""Rows from which on derivatives are known: this run begins in motion, which no recording does."""
AT_REST_S, HALVING = 0.04, 0.6
STEP_S = 1e-4


def ahead(t: Array) -> Array:
    """(N, 7), true joints where each recorded one is late by a lag that its speed shortens."""
    dq = (believed(t + STEP_S) - believed(t - STEP_S)) / (2.0 * STEP_S)
    return np.asarray(believed(t) + AT_REST_S / (1.0 + np.abs(dq) / HALVING) * dq)


def test_it_does_to_the_wrench_what_joints_do_that_are_ahead_of_their_record() -> None:
    true = truth(ahead).wrench() - truth().wrench()
    turns = (np.diff(np.sign(np.diff(believed(T), axis=0)), axis=0) != 0).any(axis=1)  # there it has a kink that is as quick as a row
    smooth = np.convolve(np.pad(turns, 1), np.ones(9), "same") == 0
    smooth[: STARTED.start] = False
    assert smooth.mean() > 0.5
    assert rms(true[smooth]) > 5.0, "nothing was planted"
    assert rms((change(EFFECT, np.array([AT_REST_S, HALVING, 0.0])) - true)[smooth]) < 0.04 * rms(true[smooth])


def test_it_undoes_the_filter_that_is_written_step_by_step() -> None:
    t = np.arange(0.0, 8.0, 1e-3)
    true = 0.7 * np.sin(1.1 * t) + 0.3 * np.sin(2.9 * t + 1.0)
    least_hz, beta = 1.0 / (2.0 * np.pi * AT_REST_S), 1.0 / (2.0 * np.pi * AT_REST_S * HALVING)
    record, speed = np.empty_like(true), np.empty_like(true)
    y, slope = true[0], 0.0
    for k, x in enumerate(true):
        slope += (1.0 - np.exp(-1e-3 / 0.02)) * ((x - true[max(k - 1, 0)]) / 1e-3 - slope)
        y += (1.0 - np.exp(-2.0 * np.pi * (least_hz + beta * abs(slope)) * 1e-3)) * (x - y)
        record[k], speed[k] = y, abs(slope)
    back = record + AT_REST_S / (1.0 + speed / HALVING) * np.gradient(record, t)
    assert np.abs((back - true)[500:]).max() < 0.05 * np.abs((record - true)[500:]).max()


def test_one_that_hardly_opens_is_the_plain_effect() -> None:
    run = scene()
    plain = KinematicLag().wrench(run, run.nominal, np.array([0.004])) - run.nominal
    opens = EFFECT.wrench(run, run.nominal, np.array([0.004, 1e6, 0.0])) - run.nominal
    assert rms((opens - plain)[STARTED]) < 0.1 * rms(plain[STARTED])


def test_it_is_a_richer_shape_that_starts_beside_the_plain_one() -> None:
    assert LagThatOpens in [type(effect) for effect in wider_shapes()]
    assert EFFECT.starts(scene(), np.zeros((len(scene()), 6))) == []
    starts = EFFECT.starts_beside(scene(), np.zeros((len(scene()), 6)), np.array([0.02]))
    assert [start[0] for start in starts] == pytest.approx([0.03, 0.06])


def test_without_joints_there_is_none_and_the_advice_has_lag_and_speed() -> None:
    without = replace(scene(), q=None, dq=None, jacobian=None)
    assert EFFECT.explain_absence(without) is not None
    with pytest.raises(ValueError, match="joints"):
        EFFECT.wrench(without, without.nominal, np.array([0.02, 1.0, 0.0]))
    said = EFFECT.advice(scene(), np.array([AT_REST_S, HALVING, 0.05])).text
    assert "40.0 ms late at rest" in said
    assert "0.6 rad/s" in said
