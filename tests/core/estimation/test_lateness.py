"""A wrench that is late or early by up to a second: found as such, with the payload, and never where the motion repeats itself."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.estimation.identification import identify_recording
from core.estimation.kinematics import poses_of, smooth_motion
from core.estimation.lateness import advance_wrench, find_lateness
from core.payload.inertia import Motion, regressor
from core.recording.recording import Recording
from tests.foreign_recordings import Condition, make


@pytest.mark.parametrize("late_s", [0.54, -0.313, 0.97])
def test_a_wrench_that_is_late_or_early_is_found_by_how_much_with_its_uncertainty(late_s: float) -> None:
    made = make(Condition(delay_s=late_s, rate_hz=250.0), 3)
    found = identify_recording(made.recording)
    estimate = found.estimate
    assert estimate is not None and estimate.delay_s is not None and estimate.delay_std is not None
    assert estimate.delay_s == pytest.approx(late_s, abs=4.0 * estimate.delay_std)
    assert estimate.delay_std < 2e-4
    z = (estimate.phi - made.phi) / estimate.std
    assert np.abs(z).max() < 4.0
    said = " ".join(warning.text for warning in found.warnings)
    assert f"{1000 * abs(late_s):.1f} ms {'late' if late_s > 0 else 'early'} (±0." in said


@pytest.mark.parametrize("late_s", [0.06, 0.1])
def test_rows_that_a_recorder_lost_hide_no_lateness(late_s: float) -> None:
    """Between some tens of milliseconds, which least squares find, and what is plain however rough the motion looks."""
    made = make(Condition(delay_s=late_s, lost=0.05), 1)
    estimate = identify_recording(made.recording).estimate
    assert estimate is not None and estimate.converged and estimate.delay_s is not None and estimate.delay_std is not None
    assert estimate.delay_s == pytest.approx(late_s, abs=5.0 * estimate.delay_std)
    assert np.abs((estimate.phi - made.phi) / estimate.std).max() < 4.0


@pytest.mark.parametrize("late_s", [0.07, -0.08])
def test_instants_that_jitter_hide_no_lateness(late_s: float) -> None:
    """What is left of a rough motion is too much for the search beforehand; a delay that ends at its bound is sought on from there."""
    made = make(Condition(delay_s=late_s, rate_hz=250.0, jitter_s=1e-3), 2)
    assert made.recording.wrench is not None
    assert find_lateness(made.recording.t, seen_by(made.recording), made.recording.wrench) == 0.0
    estimate = identify_recording(made.recording).estimate
    assert estimate is not None and estimate.converged and estimate.delay_s is not None and estimate.delay_std is not None
    assert estimate.delay_s == pytest.approx(late_s, abs=5.0 * estimate.delay_std)
    assert np.abs((estimate.phi - made.phi) / estimate.std).max() < 4.0


def seen_by(recording: Recording) -> Motion:
    poses = poses_of(recording)
    assert poses is not None
    return smooth_motion(poses, window_s=0.05)[0]


@pytest.mark.parametrize("seed", range(6))
def test_where_it_is_in_time_or_nearly_so_no_shift_is_found(seed: int) -> None:
    recording = make(Condition(rate_hz=250.0, delay_s=0.004 * (seed % 3), walk_n=0.04 * (seed % 2), one_axis=seed > 3), seed).recording
    assert recording.wrench is not None
    assert find_lateness(recording.t, seen_by(recording), recording.wrench) == 0.0


@pytest.mark.parametrize("period_s", [0.8, 1.9, 4.0])
@pytest.mark.parametrize("late_s", [0.0, 0.3, -0.3])
def test_a_rotation_that_repeats_itself_has_no_false_shift(period_s: float, late_s: float) -> None:
    """Gravity turns to and fro in the sensor's axes, with an offset ten times as large as the weight's change."""
    t, rng = 0.004 * np.arange(5000), np.random.default_rng(0)
    phi = np.array([2.0, 0.1, -0.05, 0.2, 0.02, 0.0, 0.0, 0.03, 0.0, 0.01])

    def motion(at: np.ndarray) -> Motion:
        w = 2.0 * np.pi / period_s
        angle, rate, change = 0.9 * np.sin(w * at), 0.9 * w * np.cos(w * at), -0.9 * w**2 * np.sin(w * at)
        zero = np.zeros_like(at)
        g = -9.81 * np.column_stack((zero, np.sin(angle), np.cos(angle)))
        return Motion(g, np.zeros_like(g), np.column_stack((rate, zero, zero)), np.column_stack((change, zero, zero)))

    wrench = regressor(motion(t - late_s)) @ phi + 50.0 + 0.05 * rng.normal(size=(len(t), 6))
    found = find_lateness(t, motion(t), wrench)
    assert (found - late_s + 0.5 * period_s) % period_s == pytest.approx(0.5 * period_s, abs=0.03)
    assert abs(found) <= 0.5 * period_s + 0.02


def test_rows_get_the_wrench_of_later_and_those_that_have_none_are_left_out() -> None:
    t = np.delete(0.01 * np.arange(100), [10, 11, 40])
    recording = Recording(t, np.zeros(3), wrench=np.tile(t[:, None], 6), q=t[:, None])
    moved, shift = advance_wrench(recording, 0.203)
    assert shift == pytest.approx(0.2)
    assert moved.wrench is not None and moved.q is not None
    np.testing.assert_allclose(moved.wrench[:, 0] - moved.t, 0.2)
    np.testing.assert_array_equal(moved.q[:, 0], moved.t)
    assert len(moved.t) == 77 - 1
    back, _ = advance_wrench(recording, -0.2)
    assert back.wrench is not None
    np.testing.assert_allclose(back.wrench[:, 0] - back.t, -0.2)


def test_a_recording_of_two_seconds_has_no_room_for_a_shift() -> None:
    recording = make(Condition(rate_hz=250.0, delay_s=0.54), 3).recording
    assert recording.wrench is not None and recording.q is not None
    short = replace(recording, t=recording.t[:500], wrench=recording.wrench[:500], q=recording.q[:500])
    assert short.wrench is not None
    assert find_lateness(short.t, seen_by(short), short.wrench) == 0.0
