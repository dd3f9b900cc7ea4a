"""Symptoms read off raw recordings into which faults were planted sample by sample."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline
from scipy.signal import lfilter

from core.effects.effect import Finding, Symptom, View
from core.effects.hold_noise import line_in
from core.effects.sample_dropout import SampleDropout, find_lost_share
from core.effects.sensor_interference import SensorInterference
from core.effects.sensor_noise import SensorNoise
from core.effects.sensor_quantization import SensorQuantization, find_hole, step_of
from core.recording.held_readings import find_held_share
from core.recording.recording import Recording, SensorDescription
from tests.core.effects.synthetic_scene import NOISE, RESOLUTION, scene
from tests.core.effects.test_library import check_names

Array = np.ndarray
RATE = 500.0
SYMPTOMS = (SensorNoise(), SensorInterference(), SensorQuantization(), SampleDropout())
SIX = np.array([1, 1, 1, 0.05, 0.05, 0.05])


def rounded(w: Array, step: Array = RESOLUTION) -> Array:
    return np.round(w / step) * step


def recording(*, seed: int = 0, added: Array | float = 0.0, noise: Array = NOISE, coloured: float = 0.0) -> Recording:
    """18 s at 500 Hz: loads of a moving payload, offsets, white or AR(1) noise, rounding."""
    run = scene(seconds=18.0)
    t = np.arange(round(RATE * run.t[-1])) / RATE
    rng = np.random.default_rng(seed)
    e = rng.standard_normal((len(t), 6))
    if coloured:
        e = lfilter([np.sqrt(1 - coloured**2)], [1, -coloured], e, axis=0)
    wrench = CubicSpline(run.t, run.nominal)(t) + [3, -2, 5, 0.1, -0.2, 0.3] + noise * e + added
    phase = run.phase[np.minimum(np.round(t * 100).astype(int), len(run) - 1)]
    return Recording(
        t=t, gravity=run.gravity, wrench=rounded(wrench), phase=phase, sensor=SensorDescription(noise_std=NOISE, resolution=RESOLUTION)
    )


def times(seconds: float = 17.99) -> Array:
    return np.arange(round(RATE * seconds)) / RATE


def view_of(record: Recording) -> View:
    """Holds by the labels, noise by plain standard deviations."""
    edges = np.flatnonzero(np.concatenate([[True], record.phase[1:] != record.phase[:-1], [True]]))
    holds = tuple(slice(int(a), int(b)) for a, b in pairwise(edges) if record.phase[a].startswith("hold"))
    std = np.median([record.wrench[hold].std(axis=0) for hold in holds], axis=0)
    return View(holds, std, np.full(10, np.nan), np.full(10, np.nan))


def seen(symptom: Symptom, record: Recording) -> Finding | None:
    return symptom.observe(record, view_of(record))


def value(symptom: Symptom, record: Recording, name: str) -> float:
    finding = seen(symptom, record)
    assert finding is not None
    names = [p.name for p in symptom.parameters(record)]
    assert finding.theta.shape == finding.std.shape == (len(names),)
    return float(finding.theta[names.index(name)])


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("symptom", SYMPTOMS, ids=lambda symptom: symptom.id)
def test_nothing_is_seen_in_a_good_recording(symptom: Symptom, seed: int) -> None:
    assert seen(symptom, recording(seed=seed)) is None


@pytest.mark.parametrize("symptom", SYMPTOMS, ids=lambda symptom: symptom.id)
def test_names_carry_units_and_bounds_hold_the_absent_value(symptom: Symptom) -> None:
    parameters = symptom.parameters(recording())
    check_names(parameters)
    assert all(p.lower <= p.absent <= p.upper and p.scale > 0 for p in parameters)


@pytest.mark.parametrize("symptom", SYMPTOMS, ids=lambda symptom: symptom.id)
def test_a_recording_without_a_wrench_or_without_holds_shows_nothing(symptom: Symptom) -> None:
    record = recording()
    nothing = View((), np.full(6, np.nan), np.full(10, np.nan), np.full(10, np.nan))
    assert symptom.observe(replace(record, wrench=None), nothing) is None
    assert symptom.observe(record, nothing) is None


# noise


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


# interference


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


# quantization


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


# dropout


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


@pytest.mark.parametrize("coloured", [0.7, 0.8, 0.85, 0.9])
def test_the_knee_of_coloured_noise_is_no_line(coloured: float) -> None:
    assert all(seen(SensorInterference(), recording(seed=seed, coloured=coloured, noise=4.0 * NOISE)) is None for seed in range(8))


@pytest.mark.parametrize("coloured", [0.6, 0.8, 0.9, 0.97])
def test_slow_noise_that_often_rests_on_a_step_is_not_held(coloured: float) -> None:
    assert all(seen(SampleDropout(), recording(seed=seed, coloured=coloured)) is None for seed in range(6))


def test_a_wrench_that_never_changes_says_nothing_of_dropout() -> None:
    assert find_held_share(np.ones((1000, 6)))[:2] == (0.0, 0)
