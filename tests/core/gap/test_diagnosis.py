"""The diagnosis of runs on the virtual robot, and of what is too little to say anything."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.effects.library import find_effect, library
from core.estimation.setup.check import SetUp
from core.gap.attribution import attribute
from core.gap.basis import basis_of
from core.gap.closure import gap_of
from core.gap.diagnosis import diagnose
from core.gap.effect_fit import EffectFit, fit_effects, fit_nominal
from core.gap.residual import Residual
from core.gap.tie import distance_sigma
from core.gap.weighing import find_left_share
from core.gap.windows import Windows
from core.recording.folder import read_recording
from core.recording.recording import Recording
from core.words.message import Message
from tests.core.gap.recorded_run import recorded
from tests.independent_logs import slipped_log

REAL = Path(__file__).parents[4] / "shared" / "real"
FEW = tuple(effect for effect in library() if effect.id in ("base_tilt", "time_delay", "sensor_gain", "sensor_lowpass"))


def fitted(recording: Recording) -> tuple[Windows, EffectFit, list[EffectFit]]:
    """The nominal twin and a few effects, one by one."""
    windows = Windows(basis_of(recording))
    nominal = fit_nominal(windows)
    scene = windows.basis.scene.with_phi(nominal.phi)
    still = np.zeros((len(scene), 6))
    return windows, nominal, [fit_effects(windows, (effect,), nominal, effect.starts(scene, still)) for effect in FEW]


@pytest.mark.thorough
def test_a_run_without_faults_has_a_gap_of_noise_alone():
    windows, nominal, _ = fitted(recorded())
    assert nominal.held_out.mean() == pytest.approx(1.0, abs=0.05)
    assert gap_of(windows, nominal) == pytest.approx(1.0, abs=0.01)


def test_a_tilted_base_is_named_sized_and_closed_on_motions_that_the_fit_did_not_see():
    windows, nominal, fits = fitted(recorded(tilt_rad=0.01))
    attribution = attribute(windows, nominal, fits)
    best, probability = attribution.explained[0]
    assert best.name == "base_tilt"
    assert probability > 0.9
    assert best.theta[0] == pytest.approx(0.01, abs=1e-3)  # 0.02 deg of tilt may hide in what every cell has
    assert find_left_share(nominal, best) < 0.01
    assert sum(p for _, p in attribution.explained) + attribution.none + attribution.unknown == pytest.approx(1.0)


@pytest.mark.thorough
def test_a_late_wrench_is_told_from_a_filtered_one():
    windows, nominal, fits = fitted(recorded(delay_s=0.02))
    by_name = {fit.name: fit for fit in fits}
    assert attribute(windows, nominal, fits).explained[0][0].name == "time_delay"
    assert by_name["time_delay"].theta[0] == pytest.approx(0.02, abs=5e-4)
    assert distance_sigma(windows, by_name["time_delay"], by_name["sensor_lowpass"]) > 3.0


def test_shares_of_the_gap_sum_to_one_and_its_place_is_said():
    windows, nominal, _ = fitted(recorded(delay_s=0.02))
    residual = Residual(windows, nominal)
    assert sum(patch.share for patch in residual.patches) == pytest.approx(1.0)
    assert residual.patches[0].channel in residual.describe().text
    assert sum(residual.by_time()) == pytest.approx(1.0)


def test_the_whole_diagnosis_of_a_delay_names_it_and_leaves_the_recording_alone():
    recording = recorded(delay_s=0.02)
    before = recording.wrench.copy()
    diagnosis = diagnose(recording, effects=FEW)
    assert (diagnosis.verdict, diagnosis.effects[0].id) == ("explained", "time_delay")
    assert diagnosis.effects[0].closure > 0.95
    assert diagnosis.gap.after < 1.05 < diagnosis.gap.before
    assert "20" in diagnosis.effects[0].advice.text
    np.testing.assert_array_equal(recording.wrench, before)


def test_a_slip_that_an_effect_of_the_library_does_too_is_refused_only_where_no_other_explains_more(monkeypatch, tmp_path):
    """A torque about a point 6 to 15 cm away is a sensor that sits elsewhere; a delay on which the check blames the same is a delay."""
    with_sensor = (*FEW, find_effect("sensor_translation"))
    slipped = read_recording(slipped_log("torque point", 1).write(tmp_path / "log"))
    told = diagnose(slipped, effects=with_sensor)
    assert (told.verdict, told.lacking.parameters["slip"].code) == ("not_enough", "setup-torque-about-another-point")
    monkeypatch.setattr("core.gap.diagnosis.check_setup", lambda _: SetUp(told.lacking))
    late = diagnose(recorded(delay_s=0.02), effects=with_sensor)
    assert (late.verdict, late.effects[0].id) == ("explained", "time_delay")
    assert diagnose(recorded(delay_s=0.02), effects=FEW).lacking == told.lacking  # nothing to hold against it
    assert diagnose(recorded(), effects=with_sensor).lacking == told.lacking  # nothing else is named for it
    units = Message.of("setup-motion-agrees", slip=Message.of("setup-force-in", unit="kgf"))
    monkeypatch.setattr("core.gap.diagnosis.check_setup", lambda _: SetUp(units))
    assert diagnose(recorded(delay_s=0.02), effects=with_sensor).lacking == units


def test_a_real_recording_without_wrench_is_answered_with_what_is_missing():
    diagnosis = diagnose(read_recording(REAL / "kuka-lwr4-torques-1"))
    assert diagnosis.verdict == "not_enough"
    assert diagnosis.lacking.code == "gap-no-wrench"


def test_too_short_a_recording_is_answered_not_refused():
    whole = recorded()
    short = replace(
        whole,
        t=whole.t[:1500],
        wrench=whole.wrench[:1500],
        q=whole.q[:1500],
        dq=None,
        q_cmd=None,
        tau=None,
        phase=whole.phase[:1500],
    )
    assert diagnose(short).verdict == "not_enough"
