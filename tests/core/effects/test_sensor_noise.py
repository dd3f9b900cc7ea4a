"""Noise that is planted in readings is read off them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.effects.sensor_noise import SensorNoise
from core.recording.recording import SensorDescription
from tests.core.effects.synthetic_readings import SIX, recording, seen, times, value
from tests.core.effects.synthetic_scene import NOISE


@pytest.mark.parametrize("factor", [1.6, 3.0, 5.0])
def test_the_factor_of_a_noisy_sensor_is_measured(factor: float) -> None:
    record = recording(noise=factor * NOISE)
    finding = seen(SensorNoise(), record)
    assert finding is not None
    assert finding.material
    assert finding.sigma > 10
    np.testing.assert_allclose(finding.theta[:6], factor, rtol=0.06)
    assert finding.times_expected == pytest.approx(factor, rel=0.08)
    assert abs(finding.theta[6]) < 0.1
    assert f"{finding.theta[:6].max():.1f} times" in SensorNoise().advice(finding).text


def test_the_correlation_of_coloured_noise_is_measured() -> None:
    record = recording(coloured=0.8)
    assert value(SensorNoise(), record, "correlation") == pytest.approx(0.8, abs=0.08)
    assert seen(SensorNoise(), record).material


def test_noise_as_large_as_stated_behind_a_sensors_own_filter_is_seen_and_is_not_material() -> None:
    finding = seen(SensorNoise(), recording(coloured=0.6))
    assert finding is not None and not finding.material
    assert finding.times_expected == pytest.approx(2.0, rel=0.1)


@pytest.mark.parametrize("factor", [1.2, 1.4])
def test_a_little_more_noise_is_seen_and_is_not_material(factor: float) -> None:
    finding = seen(SensorNoise(), recording(noise=factor * NOISE))
    assert finding is not None
    assert not finding.material


def test_without_a_stated_figure_no_noise_is_too_high() -> None:
    record = recording(noise=4 * NOISE)
    assert seen(SensorNoise(), replace(record, sensor=SensorDescription())) is None


def test_one_shaking_hold_does_not_speak_for_the_sensor() -> None:
    shake = np.where(times() < 1.0, 0.5 * np.sin(2 * np.pi * 23.0 * times()), 0.0)[:, None] * SIX
    assert seen(SensorNoise(), recording(added=shake)) is None
