"""`core.gap.materiality`: whom to believe where something acts on the wrench and the payload is not the reference."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np

from core.effects.library import library
from core.gap.closure import gap_of
from core.gap.diagnosis import examine
from core.gap.evidence import Evidence
from core.gap.fit_all import one_by_one
from core.gap.limits import GAP
from core.gap.materiality import find_moved_parameters
from core.payload.inertia import InertialParameters
from core.plant.faults import Setting, variants
from core.plant.mechanics import Drives
from core.procedure.identify import carry_out
from core.recording.recording import Recording
from core.sessions.simulated import SimulatedSession
from core.trial.draw import plan_each_payload, run_to_end

FEW = tuple(effect for effect in library() if effect.id in ("base_tilt", "time_delay", "sensor_gain", "sensor_lowpass"))


@cache
def near_a_magnet() -> tuple[Recording, InertialParameters]:
    """A run past a magnet, which no effect describes: a gap of 1.5, and an inertia that is off. With the true payload."""
    cell, plans = plan_each_payload("ur5e_line")
    carried, plan = cell.payloads["cylinder"], plans["cylinder"]
    kinds = {fault.variant: fault for fault in variants("unknown")}
    magnet = kinds["magnetic_field"].draw(np.random.default_rng(1), 0.45, Setting(cell, carried.parameters, plan.robot_s))
    session = SimulatedSession(cell, carried.parameters, seed=4, faults=(magnet,), drives=Drives(damping_s=0.0, friction=0.0))
    return run_to_end(carry_out(cell, session, carried.box, plan)).recording, carried.parameters


def examined(reference: InertialParameters | None) -> tuple[str, Evidence, set[str]]:
    """Verdict, evidence, and what matters beside them, with that reference; of the joints, which rub less than stated, nothing."""
    recording = replace(near_a_magnet()[0], reference=reference, reference_source="CAD")
    diagnosis, evidence = examine(recording, FEW, fit_all=one_by_one)
    assert evidence is not None
    beside = {each.id for each in diagnosis.also if each.material and each.side != "joints"}
    return diagnosis.verdict, evidence, beside


def test_a_gap_that_may_be_why_the_payload_is_off_is_answered_before_the_reference_is_doubted() -> None:
    _, true = near_a_magnet()
    verdict, evidence, beside = examined(true)
    assert not find_moved_parameters(evidence.nominal, evidence.best).any()  # no effect of the library moves it
    assert 1.2 < gap_of(evidence.windows, evidence.nominal) < GAP
    assert verdict == "unknown"
    assert beside == set()


def test_a_reference_that_is_off_by_far_more_than_the_gap_is_doubted_all_the_same() -> None:
    _, true = near_a_magnet()
    verdict, _, beside = examined(InertialParameters(1.3 * true.phi))
    assert verdict == "no_gap"
    assert beside == {"payload_mismatch"}


def test_without_a_reference_nobody_can_know() -> None:
    verdict, *_ = examined(None)
    assert verdict == "no_gap"
