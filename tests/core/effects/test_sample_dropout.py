"""Readings that are held or lost are counted."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.effects.sample_dropout import SampleDropout, find_lost_share
from core.effects.sensor_noise import SensorNoise
from core.recording.held_readings import find_held_share
from tests.core.effects.synthetic_readings import Array, recording, seen, times, value


def held(w: Array, share: float, rng: np.random.Generator) -> Array:
    """Each row is, with the given probability, the one before it once more."""
    out = w.copy()
    for k in range(1, len(out)):
        if rng.random() < share:
            out[k] = out[k - 1]
    return out


@pytest.mark.parametrize("share", [0.03, 0.1, 0.3, 0.6])
def test_the_share_of_held_samples_is_counted(share: float) -> None:
    record = recording()
    bad = replace(record, wrench=held(record.wrench, share, np.random.default_rng(5)))
    finding = seen(SampleDropout(), bad)
    assert finding.material
    assert finding.theta[0] == pytest.approx(share, abs=max(0.02, 4 * finding.std[0]))
    assert finding.theta[1] == 0
    assert seen(SensorNoise(), bad) is None  # repeated samples are no coloured noise


def test_a_wrench_at_a_quarter_of_the_rate_is_held_three_times_in_four() -> None:
    record = recording()
    slow = replace(record, wrench=record.wrench[4 * (np.arange(len(record)) // 4)])
    assert value(SampleDropout(), slow, "held_share") == pytest.approx(0.75, abs=0.01)


def test_lost_samples_are_counted_by_the_clock() -> None:
    record = recording()
    kept = np.random.default_rng(6).random(len(record)) > 0.2
    gappy = replace(record, t=record.t[kept], wrench=record.wrench[kept], phase=record.phase[kept])
    assert value(SampleDropout(), gappy, "lost_share") == pytest.approx(0.2, abs=0.02)
    assert seen(SampleDropout(), gappy).material


@pytest.mark.parametrize(("share", "matters"), [(0.006, False), (0.02, True)])
def test_lost_samples_matter_from_one_in_a_hundred(share: float, matters: bool) -> None:
    record = recording()
    kept = np.ones(len(record), dtype=bool)
    kept[5 :: round(1 / share)] = False
    finding = seen(SampleDropout(), replace(record, t=record.t[kept], wrench=record.wrench[kept], phase=record.phase[kept]))
    assert finding is not None
    assert finding.material is matters
    assert finding.times_expected == pytest.approx(100 * share, rel=0.1)


def test_a_pause_of_the_recorder_loses_nothing() -> None:
    record = recording()
    late = np.where(record.t > 9.0, 40.0, 0.0)
    assert seen(SampleDropout(), replace(record, t=record.t + late)) is None


@pytest.mark.parametrize("lost", [0.0, 0.1])
def test_a_recorder_that_goes_on_at_half_its_rate_loses_no_more_than_before(lost: float) -> None:
    t = times()
    slower = np.concatenate((t[: len(t) // 2], t[len(t) // 2 :: 2]))
    kept = slower[np.random.default_rng(8).random(len(slower)) >= lost]
    assert find_lost_share(kept) == pytest.approx(lost, abs=0.02)


def test_jitter_of_the_clock_loses_nothing() -> None:
    t = times() + 0.0004 * np.random.default_rng(7).uniform(-1, 1, len(times()))
    assert find_lost_share(t) == 0


@pytest.mark.parametrize("lost", [0.0, 0.1])
def test_a_clock_that_nobody_keeps_even_loses_only_what_is_lost(lost: float) -> None:
    rng = np.random.default_rng(9)
    steps = 0.01 * rng.gamma(1.0 / 0.25**2, 0.25**2, 8000)
    steps[rng.random(8000) < lost / 5] += 0.05  # five rows each: of one or two nobody knows
    assert find_lost_share(np.cumsum(steps)) == pytest.approx(lost, abs=0.02)


def test_a_frozen_sensor_is_held() -> None:
    record = recording()
    frozen = record.wrench.copy()
    frozen[3000:4500] = frozen[3000]
    assert value(SampleDropout(), replace(record, wrench=frozen), "held_share") == pytest.approx(1499 / len(record), abs=0.02)


@given(st.floats(0.0, 0.9), st.integers(0, 100))
def test_chance_repeats_of_rounded_noise_are_not_counted_as_held(share: float, seed: int) -> None:
    rng = np.random.default_rng(seed)
    w = np.round(rng.standard_normal((4000, 6)) * 0.6)  # a channel repeats about every other time
    w = w[np.maximum.accumulate(np.where(rng.random(4000) >= share, np.arange(4000), 0))]
    found, rows, _ = find_held_share(w)
    assert rows == 0 or found == pytest.approx(share, abs=0.08)


@pytest.mark.parametrize("coloured", [0.6, 0.8, 0.9, 0.97])
def test_slow_noise_that_often_rests_on_a_step_is_not_held(coloured: float) -> None:
    assert all(seen(SampleDropout(), recording(seed=seed, coloured=coloured)) is None for seed in range(6))


def test_a_wrench_that_never_changes_says_nothing_of_dropout() -> None:
    assert find_held_share(np.ones((1000, 6)))[:2] == (0.0, 0)
