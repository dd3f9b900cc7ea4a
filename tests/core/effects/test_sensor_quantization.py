"""Coarse steps that are planted in readings are read off them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.effects.sample_dropout import SampleDropout
from core.effects.sensor_noise import SensorNoise
from core.effects.sensor_quantization import SensorQuantization, find_hole, step_of
from core.recording.held_readings import find_held_share
from core.recording.recording import SensorDescription
from tests.core.effects.synthetic_readings import SIX, recording, rounded, seen, times, view_of
from tests.core.effects.synthetic_scene import NOISE, RESOLUTION


@pytest.mark.parametrize("step", [0.2, 0.5, 1.0])
def test_a_coarse_step_is_read_off_the_values(step: float) -> None:
    record = recording()
    coarse = replace(record, wrench=rounded(record.wrench, step * SIX))
    finding = seen(SensorQuantization(), coarse)
    assert finding.material
    np.testing.assert_allclose(finding.theta[:3], step, rtol=0.02)
    assert seen(SampleDropout(), coarse) is None or not seen(SampleDropout(), coarse).material
    assert seen(SensorNoise(), coarse) is None


def test_a_channel_rounded_twice_shows_the_coarser_step() -> None:
    x = np.random.default_rng(1).uniform(-20, 20, 20000)
    assert step_of(np.round(np.round(x / 0.2) * 0.2 / 0.0625) * 0.0625) == pytest.approx(0.2, rel=0.02)


def test_a_channel_that_rests_until_it_has_moved_far_enough_has_coarse_steps() -> None:
    record = recording()
    sent = record.wrench.copy()
    for k in range(1, len(sent)):  # a value is sent when it differs from the last one by 0.8 N, or 0.04 N m
        sent[k] = np.where(np.abs(sent[k] - sent[k - 1]) >= 0.8 * SIX, sent[k], sent[k - 1])
    finding = SensorQuantization().observe(replace(record, wrench=sent), view_of(record))
    assert finding is not None
    assert finding.material
    np.testing.assert_allclose(finding.theta, 0.8 * SIX, rtol=0.2)


@pytest.mark.parametrize("step", [0.8, 1.2])
def test_what_a_bus_sends_on_change_or_when_its_turn_comes_has_coarse_steps_and_is_not_held(step: float) -> None:
    record = recording()
    every = round(0.1 / float(np.diff(record.t[:2])[0]))
    sent = record.wrench.copy()
    for k in range(1, len(sent)):
        if k % every:
            sent[k] = np.where(np.abs(sent[k] - sent[k - 1]) >= step * SIX, sent[k], sent[k - 1])
    assert find_held_share(sent)[0] > 0.3
    bus = replace(record, wrench=sent)
    finding = seen(SensorQuantization(), bus)
    assert finding.material
    shown = finding.theta > 0.5 * step * SIX
    assert shown.sum() >= 4  # the others hardly change by so much
    np.testing.assert_allclose(finding.theta[shown], (step * SIX)[shown], rtol=0.2)
    np.testing.assert_allclose(finding.theta[~shown], RESOLUTION[~shown], rtol=0.1)
    assert SampleDropout().observe(bus, view_of(record)) is None


def test_a_number_with_few_digits_is_as_coarse_as_where_it_is_largest() -> None:
    """Nine binary digits after the first: steps of 0.125 N from 64 N on, finer below."""
    record = recording(noise=1.3 * NOISE, added=np.array([80.0, 0, 0, 0, 0, 0]) * (times() > 9.0)[:, None])
    size = 2.0 ** np.floor(np.log2(np.abs(record.wrench[:, 0]) + 1e-9))
    few = np.column_stack([np.round(record.wrench[:, 0] / size * 512) / 512 * size, *record.wrench[:, 1:].T])
    finding = SensorQuantization().observe(replace(record, wrench=few), view_of(record))
    assert finding is not None
    assert finding.theta[0] == pytest.approx(np.max(size[record.t > 9.0]) / 512, rel=0.1)


def test_a_channel_clipped_at_both_ends_does_not_rest_in_between() -> None:
    record = recording()
    middle = np.median(record.wrench[:, 1])
    clipped = record.wrench.copy()
    clipped[:, 1] = np.clip(clipped[:, 1], middle - 0.3, middle + 0.3)
    assert (np.diff(clipped[:, 1]) == 0).mean() > 0.6
    assert SensorQuantization().observe(replace(record, wrench=clipped), view_of(record)) is None


def test_a_converter_that_never_gives_every_other_code_has_steps_as_wide_as_its_holes() -> None:
    record = recording(noise=1.5 * NOISE)
    code = np.round(record.wrench / RESOLUTION).astype(int)
    stuck = np.where(code % 4 == 1, code - 1, np.where(code % 4 == 2, code + 1, code)) * RESOLUTION  # 0, 3, 4, 7, 8 ...
    assert step_of(stuck[:, 0]) == pytest.approx(RESOLUTION[0])  # what is usual does not say what is never there
    finding = SensorQuantization().observe(replace(record, wrench=stuck), view_of(record))
    assert finding is not None and finding.material
    np.testing.assert_allclose(finding.theta, 3.0 * RESOLUTION, rtol=1e-6)


def test_values_that_a_channel_only_happens_not_to_take_are_no_holes() -> None:
    rng = np.random.default_rng(1)
    swept = 5.0 * np.sin(np.linspace(0.0, 9.0, 20_000)) + 0.05 * rng.standard_normal(20_000)
    fine, middle, coarse = (find_hole(np.round(swept / step) * step) for step in (1e-4, 0.004, 0.02))
    assert len(np.unique(np.round(swept / 1e-4))) > 15_000
    assert fine <= 2e-4 and middle == pytest.approx(0.004) and coarse == pytest.approx(0.02)
    assert find_hole(swept) == 0.0


def test_a_channel_that_is_not_rounded_has_no_step() -> None:
    assert step_of(np.random.default_rng(1).standard_normal(5000)) is None


def test_coarse_steps_that_the_noise_hides_are_not_material() -> None:
    record = recording(noise=20 * NOISE)
    coarse = replace(
        record, wrench=rounded(record.wrench, 0.4 * SIX), sensor=SensorDescription(noise_std=20 * NOISE, resolution=RESOLUTION)
    )
    finding = seen(SensorQuantization(), coarse)
    assert finding is not None
    assert not finding.material
