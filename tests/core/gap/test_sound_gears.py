"""`core.gap.sound_gears`: what every arm does is not named, and does not hide what is wrong besides. The arm on springs is MuJoCo's."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from core.effects.composition import Term
from core.effects.elasticity_that_loses import ElasticityThatLoses
from core.effects.gear_ripple import GearRipple
from core.effects.joint_elasticity import JointElasticity
from core.effects.library import library
from core.effects.payload_mass_change import PayloadMassChange
from core.effects.time_delay import TimeDelay
from core.estimation.gears import SOFTEST_RAD_PER_NM, SoundGears
from core.events import drive
from core.gap.basis import basis_of
from core.gap.closure import gap_of
from core.gap.diagnosis import examine
from core.gap.effect_fit import EffectFit, fit_effects, fit_nominal
from core.gap.evidence import Evidence, gather
from core.gap.fit_all import Found, Job, Task, one_by_one
from core.gap.materiality import is_hidden
from core.gap.partners import Look, add_effect
from core.gap.problem import Problem
from core.gap.singles import Singles, hold_again
from core.gap.sound_gears import find_better_gears, find_gears_among, find_sound_gears, hold_gears
from core.gap.windows import Windows
from core.plant.faults import Fault
from core.plant.faults.joint_gears import Ripple
from core.plant.faults.joint_springs import ElasticJoints
from core.plant.faults.payload import MassStep
from core.plant.faults.sensor_memory import PlayHysteresis
from core.plant.faults.timing import Delay
from core.plant.mechanics import Drives
from core.procedure.record import record
from core.recording.recording import Recording
from core.sessions.simulated import SimulatedSession
from tests.core.gap.recorded_run import plan_of

STIFF = ElasticJoints((45e3,) * 6)
SOUND = ElasticJoints((24e3,) * 6)
SOFT = ElasticJoints((4e3,) * 6)
PLAY = PlayHysteresis((0.0, 0.45, 0.0, 0.0, 0.0, 0.0))
RIPPLE = Ripple((2e-4,) * 6, (160, 160, 200, 200, 240, 160), (0.3, 1.4, 2.9, 4.0, 5.1, 0.9))
LOST = MassStep(change_kg=-0.02, at_m=(0.0, 0.01, 0.03), begin_s=20.0, duration_s=0.0)
NAMES = ("sensor_hysteresis", "joint_elasticity", "payload_mass_change", "base_tilt", "time_delay", "joint_offset")
FEW = [effect for effect in library() if effect.id in NAMES]


@cache
def moved(*faults: Fault, payload: str = "cylinder") -> Recording:
    cell, plan = plan_of("ur5e_line", payload)
    known = cell.payloads[payload]
    smooth = Drives(damping_s=0.0, friction=0.0)
    session = SimulatedSession(cell, known.parameters, seed=1, faults=faults, drives=smooth)
    return drive(record(cell, session, known.box, plan, payload=payload, reference=known))


def examined(*faults: Fault, payload: str = "cylinder") -> tuple[str, Evidence]:
    told, evidence = examine(moved(*faults, payload=payload), FEW)  # in processes, as everybody does it
    assert evidence is not None
    assert told.twin == []
    assert ("gap-sound-gears" in {limit.code for limit in told.limits}) == bool(evidence.windows.held)
    return told.verdict, evidence


def held(evidence: Evidence) -> list[str]:
    return [term.effect.id for term in evidence.windows.held]


@pytest.mark.thorough
def test_a_stiff_arm_swings_faster_than_is_looked_at() -> None:
    windows = Windows(basis_of(moved(STIFF)))
    assert gap_of(windows, fit_nominal(windows)) < 1.01


def test_an_arm_that_swings_as_every_arm_does_has_no_gap() -> None:
    windows = Windows(basis_of(moved(SOUND, payload="steel_block")))
    assert gap_of(windows, fit_nominal(windows)) > 1.03
    verdict, evidence = examined(SOUND, payload="steel_block")
    assert verdict == "no_gap"
    assert held(evidence) == ["joint_elasticity"]
    assert gap_of(evidence.windows, evidence.nominal) < 1.002
    assert (evidence.windows.held[0].theta[:6] <= SOFTEST_RAD_PER_NM).all()


@pytest.mark.thorough
def test_what_is_wrong_besides_is_named_alone() -> None:
    verdict, evidence = examined(SOUND, LOST)
    assert (verdict, evidence.best.name) == ("explained", "payload_mass_change")
    mass = evidence.best.theta[1]
    assert mass == pytest.approx(LOST.change_kg, abs=4.0 * evidence.best.theta_std[1] + 2e-4)


@pytest.mark.thorough
def test_gears_that_are_little_beside_what_is_wrong_are_no_second_cause() -> None:
    verdict, evidence = examined(SOUND, replace(LOST, change_kg=-0.06))
    assert (verdict, evidence.best.name) == ("explained", "payload_mass_change")
    assert held(evidence) == ["joint_elasticity"]


@pytest.mark.thorough
def test_two_that_are_wrong_besides_are_named_without_a_third() -> None:
    verdict, evidence = examined(SOUND, replace(LOST, change_kg=-0.03), Delay(0.004))
    assert (verdict, evidence.best.name) == ("explained", "payload_mass_change+time_delay")
    assert held(evidence) == ["joint_elasticity"]


@pytest.mark.thorough
def test_springs_are_sought_beside_gears_that_ripple_however_little_these_explain_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    windows = Windows(basis_of(moved(SOUND, RIPPLE, payload="steel_block")))
    nominal = fit_nominal(windows)
    scene, residual = windows.basis.scene.with_phi(nominal.phi), windows.on_grid(nominal.residual)
    ripple = fit_effects(windows, (GearRipple(),), nominal, GearRipple().starts(scene, residual))
    monkeypatch.setattr("core.gap.sound_gears.BESIDE", 0)
    gears = find_sound_gears(windows, nominal, [ripple], one_by_one)
    assert gears is not None
    held = hold_gears(windows, gears)
    together = fit_effects(held, ripple.effects, fit_nominal(held), [ripple.theta])
    assert together.chi_square < 0.5 * ripple.chi_square


@pytest.mark.thorough
def test_softer_joints_beside_something_else_are_named() -> None:
    verdict, evidence = examined(SOFT, replace(LOST, change_kg=-0.1))
    assert (verdict, evidence.best.name) == ("explained", "joint_elasticity+payload_mass_change")
    assert held(evidence) == []


@pytest.mark.thorough
def test_a_sensor_that_hides_the_swinging_is_named() -> None:
    verdict, evidence = examined(STIFF, PLAY)
    assert (verdict, evidence.best.name) == ("explained", "sensor_hysteresis")


@pytest.mark.thorough
def test_joints_that_are_softer_are_named() -> None:
    verdict, evidence = examined(SOFT)
    assert (verdict, evidence.best.name) == ("explained", "joint_elasticity")
    assert held(evidence) == []
    assert np.median(evidence.best.theta[:6]) > SOFTEST_RAD_PER_NM


@pytest.mark.thorough
def test_a_stiff_arm_has_none() -> None:
    verdict, evidence = examined(LOST)
    assert (verdict, evidence.best.name) == ("explained", "payload_mass_change")
    assert held(evidence) == []


@pytest.mark.thorough
def test_gears_that_were_found_beside_less_give_way_to_those_that_show_beside_several() -> None:
    poor = Term(JointElasticity(), np.array([SOFTEST_RAD_PER_NM, *[0.0] * 5, 1.0, 0.1]))
    windows = hold_gears(Windows(basis_of(moved(SOUND, LOST))), poor)
    nominal = fit_nominal(windows)
    scene, residual = windows.basis.scene.with_phi(nominal.phi), windows.on_grid(nominal.residual)
    lost = fit_effects(windows, (PayloadMassChange(),), nominal, PayloadMassChange().starts(scene, residual))
    task = add_effect(windows, lost, JointElasticity(), SoundGears().starts(scene, residual))
    found = find_gears_among(windows, fit_effects(windows, *task), one_by_one)
    assert found is not None
    assert np.median(found.theta[:6]) == pytest.approx(1.0 / 24e3, rel=0.3)
    assert hold_gears(windows, found).held == (found,)


@pytest.mark.thorough
def test_gears_of_which_none_gives_are_none() -> None:
    windows = Windows(basis_of(moved(SOUND, LOST)))
    nominal = fit_nominal(windows)
    scene, residual = windows.basis.scene.with_phi(nominal.phi), windows.on_grid(nominal.residual)
    lost = fit_effects(windows, (PayloadMassChange(),), nominal, PayloadMassChange().starts(scene, residual))

    def fit_all(windows: Windows, jobs: Sequence[Job[EffectFit]], /) -> list[EffectFit]:  # as where a fit only came further beside them
        fits = one_by_one(windows, jobs)
        return [replace(fit, theta=np.zeros_like(fit.theta)) if SoundGears in map(type, fit.effects) else fit for fit in fits]

    assert find_sound_gears(windows, nominal, [lost], fit_all) is None


def test_gears_show_beside_the_cause_though_something_else_bends_more() -> None:
    windows = Windows(basis_of(moved(SOUND, LOST)))
    nominal = fit_nominal(windows)
    scene, residual = windows.basis.scene.with_phi(nominal.phi), windows.on_grid(nominal.residual)
    lost = fit_effects(windows, (PayloadMassChange(),), nominal, PayloadMassChange().starts(scene, residual))
    late = fit_effects(windows, (TimeDelay(),), nominal, TimeDelay().starts(scene, residual))
    bends = replace(late, held_out=0.999 * lost.held_out)
    found = find_sound_gears(windows, nominal, [bends, lost], one_by_one)
    assert found is not None
    assert np.median(found.theta[:6]) == pytest.approx(1.0 / 24e3, rel=0.3)


def test_what_a_further_effect_explains_is_foreseen_beside_gears_that_are_always_on() -> None:
    gears = Term(JointElasticity(), np.array([*[1.0 / 24e3] * 6, 1.0, 0.05]))
    windows = hold_gears(Windows(basis_of(moved(SOUND, replace(LOST, change_kg=-0.03), Delay(0.004)))), gears)
    nominal = fit_nominal(windows)
    scene, residual = windows.basis.scene.with_phi(nominal.phi), windows.on_grid(nominal.residual)
    lost = fit_effects(windows, (PayloadMassChange(),), nominal, PayloadMassChange().starts(scene, residual))
    late = max(Look(lost, (TimeDelay(),)).run(windows), key=lambda partner: partner.gain)
    both = fit_effects(windows, *add_effect(windows, lost, late.effect, [late.theta]))
    fell = float(np.square(lost.residual).sum() - np.square(both.residual).sum())
    assert fell > 1e3
    assert late.gain == pytest.approx(fell, rel=0.05)
    assert late.theta[0] == pytest.approx(0.004, rel=0.2)


def test_gears_that_were_found_beside_one_effect_give_way_to_those_that_show_beside_two() -> None:
    windows = Windows(basis_of(moved(SOUND, replace(LOST, change_kg=-0.03), Delay(0.004))))
    poor, good = (Term(JointElasticity(), np.array([*[1.0 / each] * 6, 1.0, 0.05])) for each in (60e3, 24e3))

    def find(gears: Term) -> Term | None:
        held = hold_gears(windows, gears)
        nominal = fit_nominal(held)
        start = [np.array([20.0, -0.03, 0.0, 0.0, 0.05, 0.0, 0.004])]
        both = fit_effects(held, (PayloadMassChange(), TimeDelay()), nominal, start)
        return find_better_gears(held, nominal, [both], one_by_one)

    found = find(poor)
    assert found is not None
    assert np.median(found.theta[:6]) == pytest.approx(1.0 / 24e3, rel=0.3)
    assert find(found) is None
    assert find_better_gears(windows, fit_nominal(windows), [], one_by_one) is None, "there are none"
    assert find(good) is None


@pytest.mark.thorough
def test_no_two_effects_are_sought_where_the_gap_hides_behind_the_noise() -> None:
    gears = Term(JointElasticity(), np.array([*[1.0 / 24e3] * 6, 1.0, 0.05]))
    windows = hold_gears(Windows(basis_of(moved(SOUND, replace(LOST, change_kg=-0.004)))), gears)
    others = [effect for effect in FEW if effect.id not in (PayloadMassChange.id, JointElasticity.id)]
    sought: set[str] = set()

    def fit_all(windows: Windows, jobs: Sequence[Job[Found]], /) -> list[Found]:
        sought.update(type(job).__name__ for job in jobs)
        return one_by_one(windows, jobs)

    assert is_hidden(windows, fit_nominal(windows))
    evidence = gather(windows, others, fit_all)
    assert evidence.attribution.none < 0.5, "something shows"
    assert "Look" not in sought


@pytest.mark.parametrize(("stiffness", "begun_anew"), [(24e3, False), (200e3, True)], ids=["behind the noise", "beyond it"])
def test_effects_are_begun_anew_with_gears_unless_the_gap_hides_behind_the_noise_then(stiffness: float, begun_anew: bool) -> None:
    windows = Windows(basis_of(moved(SOUND, payload="steel_block")))
    nominal = fit_nominal(windows)
    late = fit_effects(windows, (TimeDelay(),), nominal, [np.array([0.001])])
    found = Singles(windows, nominal, (late,), (TimeDelay(),), (), (), False, ())
    tasks: list[Task] = []

    def fit_all(windows: Windows, jobs: Sequence[Job[Found]], /) -> list[Found]:
        tasks.extend(job for job in jobs if isinstance(job, Task))
        return one_by_one(windows, jobs)

    held = hold_again(found, Term(JointElasticity(), np.array([*[1.0 / stiffness] * 6, 1.0, 0.05])), fit_all)
    assert is_hidden(held.windows, held.nominal) != begun_anew
    assert tasks[0].thetas[0] is late.theta
    assert (len(tasks) > 1) == begun_anew


@pytest.mark.thorough
def test_springs_that_lose_are_sought_as_a_change_of_gears_that_are_always_on() -> None:
    gears = Term(JointElasticity(), np.array([*[4e-5] * 6, 1.0, 0.1]))
    windows = hold_gears(Windows(basis_of(moved(SOUND))), gears)
    problem = Problem(windows, (ElasticityThatLoses(),))
    assert problem.absent[:8].tolist() == gears.theta.tolist()
    assert problem.absent[8:].tolist() == [0.0, 1e-3]
    assert problem.change(problem.absent, windows.basis.scene) == pytest.approx(
        Problem(windows, ()).change(np.zeros(0), windows.basis.scene)
    )


@pytest.mark.thorough
def test_gears_that_the_twin_states_stay_as_they_are() -> None:
    stated = Term(JointElasticity(), np.array([*[2e-5] * 6, 1.0, 0.1]))
    evidence = gather(Windows(basis_of(moved(SOUND, LOST)), (stated,)), FEW, one_by_one)
    assert evidence.windows.held == (stated,)


@pytest.mark.thorough
def test_what_the_swinging_hid_is_looked_at_anew() -> None:
    begun_anew: set[str] = set()

    def fit_all(windows: Windows, jobs: Sequence[Job[Found]], /) -> list[Found]:
        fits = [job for job in jobs if isinstance(job, Task)]
        begun_anew.update(fit.name for fit in fits if windows.held and len(fit.effects) == 1 and len(fit.thetas) > 1)
        return one_by_one(windows, jobs)

    evidence = gather(Windows(basis_of(moved(SOUND, LOST))), FEW, fit_all)
    assert held(evidence) == ["joint_elasticity"]
    assert begun_anew >= {"sensor_hysteresis", "payload_mass_change"}
