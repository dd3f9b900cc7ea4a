"""Families with several shapes: of a smaller and a richer one that predict alike, the smaller is taken; over zeros as real arms have them.

Recordings of `tests.synthetic` (point masses, Newton's law), changed here by numpy alone.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.signal import lsim
from scipy.spatial.transform import Rotation

from core.effects.library import library
from core.effects.loose_that_rubs import LooseThatRubs
from core.effects.payload_loose import PayloadLoose
from core.gap.answer import Diagnosis
from core.gap.basis import basis_of
from core.gap.closure import gap_of
from core.gap.diagnosis import examine
from core.gap.effect_fit import fit_nominal
from core.gap.fit_all import one_by_one
from core.gap.windows import Windows
from core.recording.recording import Recording
from tests.synthetic import Run, payload, record, run_of, wrench_of

Array = np.ndarray
ZEROS_DEG = 0.01
OFFSET = np.array([3.1, -2.2, 5.3, 0.11, -0.2, 0.07])
DOWN = np.array([0.0, 0.0, -9.81])
OF_GAIN = ("sensor_gain", "sensor_nonlinearity", "sensor_hysteresis")


@pytest.fixture(scope="module")
def run() -> Run:
    return run_of(repetitions=1, period=0.008)


def recorded(run: Run, seed: int, zeros_deg: float = ZEROS_DEG) -> tuple[Recording, Array]:
    """A recording over zeros of the encoders, and its true load (N, 6) without offset."""
    rng = np.random.default_rng(seed)
    recording = record(run, payload("steel_block"), rng)
    load = recording.wrench - OFFSET
    return replace(recording, q=recording.q + np.radians(zeros_deg) * rng.normal(size=run.q.shape[1])), load


PLACES = np.array([[0.0, 0.0, 0.0], [0.02, 0.0, 0.0], [0.02, 0.015, 0.005]])
"""Where a part lies before and after its slips, m."""


def slip(run: Run, at_s: float, place: Array, then: Array) -> Array:
    """(N, 6), what a point mass adds that lies at one place, sensor axes, and from a time on at another."""
    return (run.t > run.t[0] + at_s)[:, None] * (carried(run, then) - carried(run, place))


def carried(run: Run, place: Array) -> Array:
    """(N, 6), what a point mass of 0.5 kg asks of the sensor."""
    r = place + np.array([0.0, 0.01, 0.08])
    a = np.einsum("nji,nj->ni", run.rotation, run.a - [0.0, 0.0, -9.81])
    f = 0.5 * (a + np.cross(run.alpha, r) + np.cross(run.omega, np.cross(run.omega, r)))
    return np.hstack((f, np.cross(r, f)))


def explain(recording: Recording, *names: str) -> Diagnosis:
    return examine(recording, [effect for effect in library() if effect.id in names], fit_all=one_by_one)[0]


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_pure_gain_is_no_non_linearity_although_that_can_bend_to_it(run: Run, seed: int) -> None:
    recording, load = recorded(run, seed)
    share = 0.02 * np.random.default_rng(seed).choice([-1, 1], 6)
    diagnosis = explain(
        replace(recording, wrench=recording.wrench + share * load), "sensor_gain", "sensor_nonlinearity", "sensor_hysteresis"
    )
    assert (diagnosis.verdict, diagnosis.effects[0].id) == ("explained", "sensor_gain")
    assert diagnosis.effects[0].parameters["fx_asymmetry_share"].value == pytest.approx(0.0, abs=1e-6)


def test_a_bend_is_no_gain(run: Run) -> None:
    recording, load = recorded(run, 4)
    bent = 0.04 * load * np.abs(load) / np.abs(load).max(axis=0)
    diagnosis = explain(replace(recording, wrench=recording.wrench + bent), *OF_GAIN)
    assert (diagnosis.verdict, diagnosis.effects[0].id) == ("explained", "sensor_nonlinearity")


def test_several_jumps_are_one_effect_with_their_times_and_no_twin_takes_them(run: Run) -> None:
    recording, _ = recorded(run, 5)
    share = (run.t - run.t[0]) / (run.t[-1] - run.t[0])
    rng, wrench = np.random.default_rng(5), recording.wrench
    for at in (0.2, 0.45, 0.6, 0.85):
        wrench = wrench + np.outer(share > at, rng.normal(size=6) * [1.0, 1.0, 1.0, 0.04, 0.04, 0.04])
    diagnosis = explain(replace(recording, wrench=wrench), "sensor_offset_step", "sensor_drift", "base_tilt")
    best = diagnosis.effects[0]
    assert (diagnosis.verdict, best.id) == ("explained", "sensor_offset_step")
    times = sorted(value.value for name, value in best.parameters.items() if name.endswith(("step_time_s", "at_s")))
    assert times == pytest.approx(np.array([0.2, 0.45, 0.6, 0.85]) * (run.t[-1] - run.t[0]), abs=0.1)
    assert not best.addable
    assert best.why_not is not None


def test_one_jump_is_one_jump(run: Run) -> None:
    recording, _ = recorded(run, 6)
    jump = np.outer(run.t > run.t[0] + 17.0, [1.2, -0.6, 0.9, 0.03, -0.05, 0.02])
    diagnosis = explain(replace(recording, wrench=recording.wrench + jump), "sensor_offset_step", "sensor_drift")
    assert (diagnosis.verdict, diagnosis.effects[0].id) == ("explained", "sensor_offset_step")
    assert "jump_2_at_s" not in diagnosis.effects[0].parameters


def test_a_payload_that_slips_twice_has_slipped_and_the_times_are_told(run: Run) -> None:
    recording, _ = recorded(run, 9)
    wrench = recording.wrench + slip(run, 11.0, *PLACES[:2]) + slip(run, 25.0, *PLACES[1:])
    diagnosis = explain(replace(recording, wrench=wrench), "payload_shift", "payload_mass_change", "sensor_drift")
    best = diagnosis.effects[0]
    assert (diagnosis.verdict, best.id) == ("explained", "payload_shift")
    assert [best.parameters[name].value for name in ("at_s", "jump_2_at_s")] == pytest.approx([run.t[0] + 11, run.t[0] + 25], abs=0.15)
    assert best.parameters["jump_3_first_moment_x_kgm"].value == pytest.approx(0.0, abs=1e-6)
    assert not best.addable


def test_one_slip_is_one_slip(run: Run) -> None:
    recording, _ = recorded(run, 10)
    wrench = recording.wrench + slip(run, 17.0, *PLACES[:2])
    diagnosis = explain(replace(recording, wrench=wrench), "payload_shift", "payload_mass_change", "sensor_drift")
    assert (diagnosis.verdict, diagnosis.effects[0].id) == ("explained", "payload_shift")
    assert "jump_2_at_s" not in diagnosis.effects[0].parameters


def test_gains_that_warm_up_are_gains_and_no_payload_that_gets_lighter(run: Run) -> None:
    recording, load = recorded(run, 11)
    warm = 1.0 - np.exp(-(run.t - run.t[0]) / 9.0)
    diagnosis = explain(
        replace(recording, wrench=recording.wrench + 0.04 * warm[:, None] * load), "sensor_gain", "payload_mass_change", "sensor_drift"
    )
    best = diagnosis.effects[0]
    assert (diagnosis.verdict, best.id) == ("explained", "sensor_gain")
    assert best.parameters["settling_rate_per_s"].value == pytest.approx(1 / 9.0, rel=0.15)
    assert best.parameters["fz_gain_change_share"].value == pytest.approx(0.04, rel=0.1)
    assert best.parameters["fx_first_minute_n"].value == pytest.approx(0.0, abs=1e-6)
    assert not best.addable


def test_a_gauge_that_comes_off_is_a_gain_from_then_on(run: Run) -> None:
    recording, load = recorded(run, 12)
    after = (run.t > run.t[0] + 17.0)[:, None] * load * [0.0, 0.0, -0.03, -0.02, 0.0, 0.0]
    diagnosis = explain(
        replace(recording, wrench=recording.wrench + after), "sensor_gain", "payload_mass_change", "sensor_offset_step", "external_contact"
    )
    best = diagnosis.effects[0]
    assert (diagnosis.verdict, best.id) == ("explained", "sensor_gain")
    assert best.parameters["step_time_s"].value == pytest.approx(17.0, abs=0.1)
    assert best.parameters["fz_gain_change_share"].value == pytest.approx(-0.03, abs=0.002)
    assert not best.addable


def test_another_slope_from_a_load_on_is_a_non_linearity_with_its_knee(run: Run) -> None:
    recording, load = recorded(run, 13)
    knee = np.array([9.0, 9.0, 0.4, 9.0, 9.0, 9.0]) * np.abs(load).max(axis=0)
    bent = 0.05 * (load - np.clip(load, -knee, knee))
    diagnosis = explain(replace(recording, wrench=recording.wrench + bent), *OF_GAIN, "sensor_crosstalk")
    best = diagnosis.effects[0]
    assert (diagnosis.verdict, best.id) == ("explained", "sensor_nonlinearity")
    assert best.parameters["fz_slope_change_share"].value == pytest.approx(0.05, abs=0.005)
    assert best.parameters["knee_share"].value == pytest.approx(0.4, abs=0.03)


def test_a_reading_that_is_a_polynomial_of_the_load_is_a_non_linearity(run: Run) -> None:
    recording, load = recorded(run, 15)
    most = np.abs(load).max(axis=0)
    x = load / most
    bent = load * (np.array([0.01, -0.02, 0.015, 0.0, 0.02, 0.0]) * x + np.array([0.03, 0.02, 0.04, 0.0, 0.0, 0.0]) * x * x)
    diagnosis = explain(replace(recording, wrench=recording.wrench + bent), *OF_GAIN, "sensor_crosstalk")
    best = diagnosis.effects[0]
    assert (diagnosis.verdict, best.id) == ("explained", "sensor_nonlinearity")
    assert best.parameters["fz_third_degree_share"].value == pytest.approx(0.04, abs=0.006)
    assert not best.addable


def test_a_supply_that_goes_up_and_down_is_a_gain_with_its_cycle(run: Run) -> None:
    recording, load = recorded(run, 14)
    course = 1.0 + 0.6 * np.sin(2.0 * np.pi * (run.t - run.t[0]) / 22.0 + 1.0)
    seen = course[:, None] * np.array([0.0, 0.03, -0.04, 0.03, 0.0, 0.0]) * (load + OFFSET)
    diagnosis = explain(replace(recording, wrench=recording.wrench + seen), "sensor_gain", "sensor_drift", "payload_mass_change")
    best = diagnosis.effects[0]
    assert (diagnosis.verdict, best.id) == ("explained", "sensor_gain")
    assert best.parameters["cycle_s"].value == pytest.approx(22.0, rel=0.05)
    assert abs(best.parameters["swing_share"].value) == pytest.approx(0.6, abs=0.15)


def test_a_heating_that_is_switched_is_a_drift_with_its_cycle(run: Run) -> None:
    recording, _ = recorded(run, 15)
    elapsed = run.t - run.t[0]
    switched = ((elapsed - 6.0) % 24.0 < 12.0).astype(float)
    warm = lsim(([1.0], [25.0, 1.0]), switched, elapsed, interp=False)[1]
    diagnosis = explain(
        replace(recording, wrench=recording.wrench + np.outer(warm, [2.0, -1.0, 0.5, 0.05, 0.0, -0.1])),
        "sensor_drift",
        "sensor_gain",
        "base_tilt",
    )
    best = diagnosis.effects[0]
    assert (diagnosis.verdict, best.id) == ("explained", "sensor_drift")
    assert best.parameters["cycle_s"].value == pytest.approx(24.0, rel=0.05)
    assert best.parameters["time_constant_s"].value == pytest.approx(25.0, rel=0.2)
    assert best.parameters["fx_hot_n"].value == pytest.approx(2.0, rel=0.15)


def test_two_channels_that_end_at_half_of_their_load_are_clipped(run: Run) -> None:
    recording, load = recorded(run, 7)
    limit = np.abs(load).max(axis=0) * [0.45, 9, 9, 9, 0.6, 9]
    clipped = recording.wrench - load + np.clip(load, -limit, limit)
    diagnosis = explain(replace(recording, wrench=clipped), "sensor_saturation", "sensor_nonlinearity", "sensor_gain", "cable_drag")
    assert (diagnosis.verdict, diagnosis.effects[0].id) == ("explained", "sensor_saturation")


def test_zeros_as_real_arms_have_them_are_no_gap_and_larger_ones_are(run: Run) -> None:
    gaps = []
    for zeros_deg in (0.0, 0.03, 1.0):
        windows = Windows(basis_of(recorded(run, 8, zeros_deg)[0]))
        gaps.append(gap_of(windows, fit_nominal(windows)))
    assert gaps[1] == pytest.approx(gaps[0], abs=0.02)
    assert gaps[2] > gaps[0] + 0.2


@pytest.mark.parametrize(("cycle_s", "swing_s"), [(7.3, 0.012), (4.1, -0.02)])
def test_a_buffer_that_slips_shows_beside_the_delay_that_it_has_on_the_whole(run: Run, cycle_s: float, swing_s: float) -> None:
    recording, load = recorded(run, 9)
    late = 0.02 + swing_s * ((run.t - run.t[0]) / cycle_s % 1.0 - 0.5)
    come = CubicSpline(run.t, load)(np.maximum(run.t - late, run.t[0]))
    diagnosis = explain(
        replace(recording, wrench=recording.wrench + come - load), "time_delay", "sensor_lowpass", "sensor_creep", "sensor_crosstalk"
    )
    assert (diagnosis.verdict, diagnosis.effects[0].id) == ("explained", "time_delay")
    found = {name: value.value for name, value in diagnosis.effects[0].parameters.items()}
    assert found["cycle_s"] == pytest.approx(cycle_s, rel=0.01)
    assert found["growth_s_per_s"] == pytest.approx(swing_s / cycle_s, rel=0.1)
    assert found["delay_s"] == pytest.approx(0.02, abs=0.001)
    assert "every" in diagnosis.effects[0].advice.text


@pytest.mark.parametrize("late_s", [0.13, 0.4, 0.85])
def test_clocks_that_differ_by_tenths_of_a_second_are_a_delay(run: Run, late_s: float) -> None:
    recording, _ = recorded(run, 12)
    load = wrench_of(run, payload("steel_block"))
    come = CubicSpline(run.t, load)(np.maximum(run.t - late_s, run.t[0]))
    diagnosis = explain(
        replace(recording, wrench=recording.wrench + come - load), "time_delay", "sensor_lowpass", "external_contact", "sensor_drift"
    )
    assert (diagnosis.verdict, [effect.id for effect in diagnosis.effects][:1]) == ("explained", ["time_delay"])
    assert diagnosis.effects[0].parameters["delay_s"].value == pytest.approx(late_s, abs=0.001)
    assert diagnosis.gap.after < 1.05


def test_beside_a_base_that_is_not_level_the_delay_of_two_clocks_is_no_filter(run: Run) -> None:
    recording, _ = recorded(run, 5)
    level, tilted = (wrench_of(run, payload("steel_block"), Rotation.from_euler("x", deg, degrees=True).apply(DOWN)) for deg in (0.0, 1.0))
    come = CubicSpline(run.t, tilted)(np.maximum(run.t - 0.25, run.t[0]))
    diagnosis = explain(replace(recording, wrench=recording.wrench + come - level), "time_delay", "sensor_lowpass", "base_tilt")
    assert (diagnosis.verdict, diagnosis.pairs[0].ids) == ("explained", ("base_tilt", "time_delay"))
    assert diagnosis.pairs[0].parameters["time_delay"]["delay_s"].value == pytest.approx(0.25, abs=0.001)


def slide(run: Run, axis: Array, half_m: float, dry: float) -> Array:
    """(N, 6), what a point mass of 0.5 kg adds that slides against dry friction of so many m/s2 from wall to wall, where it stops dead,
    against one that stays in the middle."""
    middle, h = np.array([0.0, 0.01, 0.08]), 5e-4
    field = np.einsum("nji,nj->ni", run.rotation, run.a - [0.0, 0.0, -9.81])
    field += np.cross(run.alpha, middle) + np.cross(run.omega, np.cross(run.omega, middle))
    period, pull = float(run.t[1] - run.t[0]), -field @ axis
    u, du = half_m * float(np.sign(pull[0])), 0.0
    ways = []
    for now in pull:
        ways.append(u)
        for _ in range(round(period / h)):
            du += h * now
            du -= float(np.clip(du, -h * dry, h * dry))
            u += h * du
            if abs(u) >= half_m:
                u, du = half_m * float(np.sign(u)), 0.0
    rate = np.gradient(ways, period)
    at, drive = middle + np.outer(ways, axis), np.outer(np.gradient(rate, period), axis) + 2.0 * np.cross(run.omega, np.outer(rate, axis))
    moved = np.outer(ways, axis)
    f = 0.5 * (field + np.cross(run.alpha, moved) + np.cross(run.omega, np.cross(run.omega, moved)) + drive)
    return np.hstack((f - 0.5 * field, np.cross(at, f) - np.cross(middle, 0.5 * field)))


@pytest.mark.thorough
def test_knocks_are_sought_along_the_slide_that_was_found_without_them(run: Run) -> None:
    recording, _ = recorded(run, 5)
    axis, half_m, dry = np.array([0.6, 0.64, 0.48]), 0.004, 3.5
    changed = replace(recording, wrench=recording.wrench + slide(run, axis, half_m, dry))
    _, evidence = examine(changed, [PayloadLoose()], fit_all=one_by_one)
    assert evidence is not None
    (shape,) = evidence.best.effects
    assert isinstance(shape, LooseThatRubs)
    assert np.linalg.norm(evidence.best.theta[:3]) == pytest.approx(0.5 * half_m, rel=0.1)
    assert evidence.best.theta[6] == pytest.approx(dry, abs=0.5)
    assert gap_of(evidence.windows, evidence.best) < 1.1
