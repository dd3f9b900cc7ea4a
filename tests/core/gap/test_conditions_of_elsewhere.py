"""Sound recordings of another generator's robots, as the bench of the intervals has them: no gap; and one with three faults at once."""

from __future__ import annotations

from io import StringIO

import numpy as np
import pytest
from rich.console import Console
from threadpoolctl import threadpool_limits

from core.cli.tables import diagnosis_table
from core.effects.drift_that_wanders import wanders_in_holds
from core.effects.effect import View
from core.effects.library import library
from core.effects.sensor_noise import SensorNoise
from core.gap.answering import answer
from core.gap.basis import basis_of
from core.gap.closure import gap_of
from core.gap.effect_fit import fit_nominal
from core.gap.evidence import gather
from core.gap.fit_all import one_by_one
from core.gap.instruction import find_advice
from core.gap.windows import Windows
from core.recording.recording import Recording
from tests.foreign_recordings import Condition, make

DEGREE = np.pi / 180.0


def find_gap(recording: Recording) -> float:
    windows = Windows(basis_of(recording))
    return gap_of(windows, fit_nominal(windows))


@pytest.mark.parametrize("condition", [Condition(rate_hz=250.0), Condition(rate_hz=250.0, jitter_s=1e-3), Condition(poses=True)])
def test_noise_wrong_instants_and_positions_that_nobody_logged_are_no_gap(condition: Condition) -> None:
    assert find_gap(make(condition, 2).recording) < 1.05


def test_of_attitudes_alone_rest_is_compared_and_effects_of_motion_are_said_to_be_out_of_sight() -> None:
    windows = Windows(basis_of(make(Condition(poses=True), 2).recording))
    assert windows.basis.rows.at_rest
    evidence = gather(windows, [effect for effect in library() if effect.id in ("sensor_hysteresis", "sensor_gain")], one_by_one)
    assert [limit.parameters["effect"] for limit in evidence.limits] == ["sensor_hysteresis"]
    assert not evidence.material


@pytest.mark.parametrize(("condition", "wanders"), [(Condition(walk_n=0.04), True), (Condition(tilt_rad=0.5 * DEGREE, drift_n=0.3), False)])
def test_a_walk_is_known_by_five_short_holds(condition: Condition, wanders: bool) -> None:
    for seed in (1, 2, 3):
        windows = Windows(basis_of(make(condition, seed).recording))
        nominal = fit_nominal(windows)
        scene = windows.basis.scene.with_phi(nominal.phi)
        assert wanders_in_holds(scene, windows.on_grid(nominal.residual)) == wanders


@pytest.mark.thorough
def test_a_walk_is_a_drift_though_it_follows_the_run_by_many_parameters() -> None:
    few = [effect for effect in library() if effect.id in ("sensor_drift", "sensor_offset_step", "sensor_creep")]
    evidence = gather(Windows(basis_of(make(Condition(walk_n=0.04), 0).recording)), few, one_by_one)
    best, probability = evidence.attribution.explained[0]
    assert best.name == "sensor_drift"
    assert probability > 0.7
    assert best.free < 30


def test_an_arm_that_speeds_up_at_the_end_of_a_hold_is_no_noise_of_the_sensor() -> None:
    recording = make(Condition(rate_hz=1000.0), 0).recording
    windows = Windows(basis_of(recording))
    nominal, none = fit_nominal(windows), np.zeros((0, 6))
    holds = tuple(part.rows for part in windows.basis.segments if part.is_hold)
    assert SensorNoise().observe(recording, View(holds, windows.basis.noise.std, nominal.phi, nominal.phi_std, none, none, none)) is None


@pytest.mark.thorough
def test_a_tilt_a_delay_and_a_drift_at_once_are_named_though_others_bend_further_alone() -> None:
    condition = Condition(tilt_rad=0.5 * DEGREE, delay_s=4e-3, drift_n=0.3)
    names = ("base_tilt", "time_delay", "sensor_drift", "joint_offset", "sensor_offset_step", "cable_drag")
    recording = make(condition, 3).recording
    windows = Windows(basis_of(recording))
    with threadpool_limits(1):
        evidence = gather(windows, [effect for effect in library() if effect.id in names], one_by_one)
    assert evidence.verdict == "explained"
    assert {effect.id for effect in evidence.best.effects} == {"base_tilt", "time_delay", "sensor_drift"}
    assert gap_of(windows, evidence.best) < 1.05
    assert gap_of(windows, evidence.nominal) > 2.0
    told = answer(recording, evidence)
    tilt, advice = told.pairs[0].parameters["base_tilt"], find_advice(told, told.pairs[0].ids)
    assert advice["base_tilt"].parameters["first_rad"] == tilt["about_x_rad"].value  # as it is beside the others
    shown = Console(width=200, file=StringIO())
    shown.print(diagnosis_table(told))
    assert "base_tilt + time_delay + sensor_drift" in shown.file.getvalue()
