"""An effect that explains all but a few motions is named, with where it does not; a gap that is made of moments is not explained by it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.effects.library import library
from core.gap.diagnosis import diagnose
from core.gap.moments import find_moments
from core.recording.recording import Recording
from tests.synthetic import Run, payload, record, run_of

EFFECTS = [effect for effect in library() if effect.id in ("sensor_gain", "time_delay", "sensor_offset_step")]
BEGINS = 0.55
"""Of the run."""


@pytest.fixture(scope="module")
def run() -> Run:
    return run_of(repetitions=2)


def shaken(run: Run, *, gain: float, torque_nm: float) -> Recording:
    """A gain that is off, and a torque without a force that goes to and fro for a second."""
    sound = record(run, payload("steel_block"), np.random.default_rng(3))
    t = run.t - run.t[0] - BEGINS * np.ptp(run.t)
    burst = torque_nm * np.sin(2.0 * np.pi * 3.1 * t) * np.exp(-(((t - 0.5) / 0.3) ** 2))
    return replace(sound, wrench=sound.wrench * [1.0, 1.0, 1.0 + gain, 1.0, 1.0, 1.0] + np.outer(burst, [0.0, 0.0, 0.0, 1.0, -0.7, 0.4]))


def test_what_explains_all_but_a_moment_is_named_with_where_it_does_not(run: Run) -> None:
    told = diagnose(shaken(run, gain=0.06, torque_nm=0.12), EFFECTS)
    assert (told.verdict, told.effects[0].id) == ("explained", "sensor_gain")
    assert told.effects[0].closure < 0.97
    (left,) = [limit for limit in told.limits if limit.code == "gap-moments-left"]
    assert left.parameters["at_s"] == pytest.approx(run.t[0] + BEGINS * np.ptp(run.t) + 0.5, abs=1.0)


@pytest.mark.thorough
def test_a_gap_that_is_made_of_moments_stays_unknown(run: Run) -> None:
    told = diagnose(shaken(run, gain=0.0, torque_nm=0.5), EFFECTS)
    assert told.verdict == "unknown"
    assert all(limit.code != "gap-moments-left" for limit in told.limits)


def test_few_motions_are_taken_whole_and_those_with_most_first() -> None:
    group = np.repeat([0, 1, 2, 3], [50, 5, 40, 5])
    left = np.ones(100)
    left[group == 1] = 30.0
    left[group == 3] = 20.0
    np.testing.assert_array_equal(find_moments(left, group), (group == 1) | (group == 3))
    assert not find_moments(np.where(group == 0, 9.0, 0.0), group).any()
