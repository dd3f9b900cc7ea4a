"""Lines that are planted in readings are read off them."""

from __future__ import annotations

import numpy as np
import pytest

from core.effects.hold_noise import line_in
from core.effects.sensor_interference import SensorInterference
from core.effects.sensor_noise import SensorNoise
from tests.core.effects.synthetic_readings import RATE, SIX, recording, seen, times
from tests.core.effects.synthetic_scene import NOISE


@pytest.mark.parametrize(("frequency", "amplitude"), [(50.0, 0.2), (60.0, 0.3), (100.0, 1.0), (17.3, 0.3)])
def test_a_line_is_found_with_its_frequency_and_amplitude(frequency: float, amplitude: float) -> None:
    wave = amplitude * np.sin(2 * np.pi * frequency * times() + 0.7)[:, None] * [1, 0.5, 0, 0, 0.05, 0]
    record = recording(added=wave)
    finding = seen(SensorInterference(), record)
    assert finding is not None
    assert finding.material
    assert finding.theta[0] == pytest.approx(frequency, abs=max(0.03, 5 * finding.std[0]))
    np.testing.assert_allclose(finding.theta[1:] / SIX, np.array([1, 0.5, 0, 0, 1, 0]) * amplitude, atol=0.02)
    assert ("mains" in finding.message.text) == (frequency != 17.3)
    assert seen(SensorNoise(), record) is None  # what the line adds is no noise


def test_a_line_above_half_the_sample_rate_is_named_by_its_source() -> None:
    record = recording(added=0.5 * np.sin(2 * np.pi * 300.0 * times() + 0.3)[:, None] * SIX)
    finding = seen(SensorInterference(), record)
    assert finding.theta[0] == pytest.approx(200.0, abs=0.1)
    assert "300 Hz" in finding.message.text
    assert "alias" in finding.message.text


@pytest.mark.parametrize("frequency", [244.5, 245.3])
def test_a_line_just_below_half_the_sample_rate_is_found(frequency: float) -> None:
    finding = seen(SensorInterference(), recording(added=4.0 * np.sin(2 * np.pi * frequency * times())[:, None] * NOISE))
    assert finding.theta[0] == pytest.approx(frequency, abs=0.1)
    assert finding.times_expected == pytest.approx(4.0, rel=0.15)


@pytest.mark.parametrize("amplitude", [0.5, 2.5, 4.0])
def test_a_line_matters_from_three_times_the_stated_noise(amplitude: float) -> None:
    finding = seen(SensorInterference(), recording(added=amplitude * np.sin(2 * np.pi * 50 * times())[:, None] * NOISE))
    assert finding is not None
    assert finding.times_expected == pytest.approx(amplitude, rel=0.15)
    assert finding.material is (amplitude > 3.0)


def test_harmonics_count_with_their_line() -> None:
    phase = 2 * np.pi * 60.0 * times()
    wave = 2.85 * (np.sin(phase) + 0.45 * np.sin(3 * phase))[:, None] * NOISE
    finding = seen(SensorInterference(), recording(added=wave))
    assert finding.material
    assert finding.times_expected == pytest.approx(2.85 * np.hypot(1, 0.45), rel=0.05)


def test_a_line_that_is_switched_on_and_off_counts_by_its_power() -> None:
    on = np.mod(times(), 1.6) < 1.2
    finding = seen(SensorInterference(), recording(added=np.where(on, 3.7 * np.sin(2 * np.pi * 100.0 * times()), 0.0)[:, None] * NOISE))
    assert finding.times_expected == pytest.approx(3.7 * np.sqrt(0.75), rel=0.08)


@pytest.mark.parametrize(("on_s", "amplitude"), [((3.0, 6.0), 4.0), ((0.0, 9.0), 3.6), ((12.0, 15.0), 2.0)])
def test_a_line_that_is_off_in_most_holds_counts_as_it_does_where_it_is_on(on_s: tuple[float, float], amplitude: float) -> None:
    on = (times() > on_s[0]) & (times() < on_s[1])
    finding = seen(
        SensorInterference(), recording(added=np.where(on, amplitude * np.sin(2 * np.pi * 60.0 * times()), 0.0)[:, None] * NOISE)
    )
    assert finding.times_expected == pytest.approx(amplitude, rel=0.1)
    assert finding.material is (amplitude > 3.0)


def test_ringing_after_each_stop_is_no_interference() -> None:
    since = np.mod(times(), 3.0)
    ring = np.where(since < 1.0, 1.5 * np.exp(-since / 0.2) * np.sin(2 * np.pi * 25 * since), 0.0)[:, None] * SIX
    assert seen(SensorInterference(), recording(added=ring)) is None


def test_white_noise_shows_a_line_as_rarely_as_its_significance_says() -> None:
    rng = np.random.default_rng(3)
    sigma = [line_in([rng.standard_normal((375, 6)) for _ in range(6)], RATE).sigma for _ in range(60)]
    assert np.mean(np.array(sigma) > 2.0) < 0.1
    assert max(sigma) < 4.5


def test_holds_too_short_for_a_spectrum_have_no_line() -> None:
    assert line_in([np.zeros((20, 6))], RATE) is None
    assert line_in([], RATE) is None


@pytest.mark.parametrize("coloured", [0.7, 0.8, 0.85, 0.9])
def test_the_knee_of_coloured_noise_is_no_line(coloured: float) -> None:
    assert all(seen(SensorInterference(), recording(seed=seed, coloured=coloured, noise=4.0 * NOISE)) is None for seed in range(8))
