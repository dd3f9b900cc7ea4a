"""`core.gap.evidence`: what is fitted to a recording beyond each effect by itself."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.ndimage import gaussian_filter1d

from bench.calibration.planting import plant_trial
from core.array import Array
from core.effects.crosstalk_of_products import CrosstalkOfProducts
from core.effects.delay_that_grows import DelayThatGrows
from core.effects.delay_that_wanders import DelayThatWanders
from core.effects.drift_in_any_attitude import DriftInAnyAttitude
from core.effects.drift_that_wanders import DriftThatWanders
from core.effects.effect import Effect
from core.effects.lag_of_each_joint import LagOfEachJoint
from core.effects.library import library
from core.effects.lowpass_that_opens import LowpassThatOpens
from core.effects.ripple_that_varies import RippleThatVaries
from core.effects.scene import Scene
from core.effects.sensor_gain import SensorGain
from core.effects.zeros_that_warm_up import ZerosThatWarmUp
from core.gap.basis import basis_of
from core.gap.evidence import EXPLAINED, gather
from core.gap.fit_all import Found, Job, Task, one_by_one
from core.gap.materiality import is_hidden
from core.gap.singles import ONE_IS_CLEAR
from core.gap.sound_gears import ONE_IS_ENOUGH
from core.gap.weighing import find_left_share
from core.gap.windows import Term, Windows
from tests.synthetic import Imperfections, payload, record, run_of

TWO = 24
"""Cross-talk and a delay."""
RUNS_OFF = 42
"""A clock that runs off: too early at first, too late in the end, so that a constant delay explains a fifth."""
FILLS = 190
"""A hose that fills: unknown, and followed by a cable beside products of channels."""


def few(*names: str) -> list[Effect]:
    return [effect for effect in library() if effect.id in names]


def test_a_second_cause_that_matters_by_itself_is_sought_however_little_of_the_gap_it_makes() -> None:
    imperfections = Imperfections(tilt_rad=(0.15, -0.1), drift_n=0.6)
    recording = record(run_of("lwr4_bench", 0, repetitions=1), payload("steel_block"), np.random.default_rng(0), imperfections)
    evidence = gather(Windows(basis_of(recording)), few("base_tilt", "sensor_drift", "time_delay"), one_by_one)
    (tilt,) = (fit for fit in evidence.singles if fit.name == "base_tilt")
    assert find_left_share(evidence.nominal, tilt) < ONE_IS_ENOUGH
    assert evidence.best.name == "base_tilt+sensor_drift"


@pytest.mark.thorough
def test_of_several_effects_at_once_each_has_its_smaller_shape_where_that_says_as_much() -> None:
    """A gain beside a tilt: whether it pulls and pushes alike need not be fitted, and would cost what tells it from a curve."""
    tilted = record(run_of(repetitions=1), payload("steel_block"), np.random.default_rng(0), Imperfections(tilt_rad=(0.03, -0.02)))
    assert tilted.wrench is not None
    recording = replace(tilted, wrench=tilted.wrench * np.array([1.03, 0.98, 1.04, 0.97, 1.02, 1.03]))
    evidence = gather(Windows(basis_of(recording)), few("base_tilt", "sensor_gain"), one_by_one)
    assert evidence.best.name == "base_tilt+sensor_gain"
    assert evidence.best.kept_absent == 6
    assert evidence.best.theta[-6:] == pytest.approx(np.zeros(6), abs=1e-5)
    assert evidence.best.free == 8


def test_a_richer_shape_is_sought_although_four_other_effects_explain_more_than_the_plain_one() -> None:
    names = ("time_delay", "external_contact", "sensor_offset_step", "sensor_creep", "sensor_lowpass")
    effects = [effect for effect in library() if effect.id in names]
    evidence = gather(Windows(basis_of(plant_trial(RUNS_OFF).recording)), effects, one_by_one)
    (effect,) = evidence.best.effects
    assert isinstance(effect, DelayThatGrows)
    assert evidence.attribution.explained[0][1] > EXPLAINED


@pytest.mark.parametrize(
    ("delay_s", "among", "sought"),
    [(0.03, ("time_delay",), False), (0.03, (), True), (0.0005, (), False)],
    ids=["explained by a plain one", "not explained", "hidden behind the noise"],
)
def test_richer_shapes_are_sought_for_a_gap_that_shows_unless_a_plain_one_explains_it(
    delay_s: float, among: tuple[str, ...], sought: bool
) -> None:
    fitted: list[Effect] = []

    def fit_all(windows: Windows, jobs: Sequence[Job[Found]], /) -> list[Found]:
        fitted.extend(effect for job in jobs if isinstance(job, Task) for effect in job.effects)
        return one_by_one(windows, jobs)

    recording = record(
        run_of("lwr4_bench", 0, repetitions=1), payload("steel_block"), np.random.default_rng(0), Imperfections(delay_s=delay_s)
    )
    evidence = gather(Windows(basis_of(recording)), few("sensor_gain", "sensor_offset_step", *among), fit_all)
    least = min(find_left_share(evidence.nominal, fit) for fit in evidence.singles)
    assert (least < ONE_IS_CLEAR) == ("time_delay" in among or delay_s < 0.001)
    assert is_hidden(evidence.windows, evidence.nominal) == (delay_s < 0.001)
    assert any(effect.wider_shape for effect in fitted) == sought


def test_a_delay_that_changes_is_found_beside_a_jump_of_the_offset() -> None:
    recording = record(run_of("lwr4_bench", 0, repetitions=1), payload("steel_block"), np.random.default_rng(0), Imperfections())
    t, wrench = recording.t, np.array(recording.wrench)
    course = sum(np.sin(2.0 * np.pi * (t - t[0]) / period) for period in (31.0, 17.0, 11.0))
    late = CubicSpline(t, wrench)(np.maximum(t - 0.03 - 0.01 * course, t[0]))
    late[t > t.mean(), 0] += 3.0
    evidence = gather(Windows(basis_of(replace(recording, wrench=late))), few("sensor_offset_step", "time_delay"), one_by_one)
    assert evidence.best.name == "time_delay+sensor_offset_step"
    assert isinstance(evidence.best.effects[0], DelayThatGrows | DelayThatWanders)


@pytest.mark.thorough
def test_what_wanders_unseen_by_holds_is_the_last_resort(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(DriftThatWanders, "starts", lambda *_: [])  # as where no hold is long enough
    recording = record(run_of("lwr4_bench", 0, repetitions=1), payload("steel_block"), np.random.default_rng(0), Imperfections())
    noise = np.std(np.diff(np.array(recording.wrench)[:100], axis=0), axis=0)
    walked = gaussian_filter1d(np.cumsum(np.random.default_rng(1).normal(size=np.shape(recording.wrench)), axis=0), 1000, axis=0)
    wrench = np.array(recording.wrench) + 15.0 * noise * walked / walked.std(axis=0)
    names = ("sensor_drift", "external_contact", "sensor_gain", "sensor_offset_step")
    evidence = gather(Windows(basis_of(replace(recording, wrench=wrench))), few(*names), one_by_one)
    assert [type(effect) for effect in evidence.best.effects] == [DriftInAnyAttitude]
    assert evidence.verdict == "explained"


@pytest.mark.parametrize("id_", ["sensor_gain", "time_delay"])
def test_what_the_twin_has_is_kept_in_its_plain_shape_beside_further_effects(id_: str) -> None:
    names = ("time_delay", "sensor_crosstalk", "sensor_gain", "sensor_lowpass")
    few = {effect.id: effect for effect in library() if effect.id in names}
    basis = basis_of(plant_trial(TWO).recording)
    twin = Term(few[id_], np.zeros(len(few[id_].parameters(basis.scene))))
    evidence = gather(Windows(basis, (twin,)), list(few.values()), one_by_one)
    assert (evidence.verdict, evidence.best.name) == ("explained", "time_delay+sensor_crosstalk")
    assert not any(effect.wider_shape for fit in (*evidence.singles, *evidence.joined) for effect in fit.effects if effect.id == id_)


@pytest.mark.parametrize(
    ("seed", "rivals", "shape"),
    [
        (100, ("kinematic_lag", "time_delay", "external_contact"), LagOfEachJoint),
        (129, ("joint_offset", "sensor_crosstalk", "sensor_offset_step"), ZerosThatWarmUp),
        (26, ("sensor_lowpass", "time_delay", "sensor_creep"), LowpassThatOpens),
        (159, ("gear_ripple", "joint_backlash", "time_delay"), RippleThatVaries),
        (340, ("sensor_crosstalk", "sensor_gain", "sensor_nonlinearity"), CrosstalkOfProducts),
    ],
    ids=["lags", "zeros", "filter", "ripple", "products"],
)
def test_what_a_plain_shape_follows_in_part_is_named_in_its_richer_one(seed: int, rivals: tuple[str, ...], shape: type[Effect]) -> None:
    evidence = gather(Windows(basis_of(plant_trial(seed).recording)), few(*rivals), one_by_one)
    assert [type(effect) for effect in evidence.best.effects] == [shape]
    assert evidence.verdict == "explained"


@pytest.mark.thorough
def test_cross_talk_of_products_takes_up_nothing_that_another_effect_leaves() -> None:
    evidence = gather(
        Windows(basis_of(plant_trial(FILLS).recording)), few("cable_drag", "sensor_crosstalk", "external_contact"), one_by_one
    )
    assert CrosstalkOfProducts in {type(effect) for fit in evidence.singles for effect in fit.effects}
    assert CrosstalkOfProducts not in {type(effect) for fit in evidence.joined for effect in fit.effects}
    assert evidence.verdict == "unknown"


class ShowsNowhere(SensorGain):
    """An effect that finds nothing to start from."""

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """None."""
        del scene, residual
        return []


def test_an_effect_that_has_nothing_to_start_from_is_passed_over() -> None:
    recording = record(
        run_of("lwr4_bench", 0, repetitions=1), payload("steel_block"), np.random.default_rng(0), Imperfections(delay_s=0.02)
    )
    evidence = gather(Windows(basis_of(recording)), [ShowsNowhere(), *few("time_delay")], one_by_one)
    assert [fit.name for fit in evidence.singles] == ["time_delay"]
    assert evidence.best.name == "time_delay"
