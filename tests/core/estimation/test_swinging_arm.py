"""An arm that swings on its gears, as every arm does: mass that resists the motion seems more than mass that weighs. MuJoCo's springs."""

from __future__ import annotations

import numpy as np
import pytest

from core.estimation.identification import identify_recording
from core.events import drive
from core.plant.faults.joint_springs import ElasticJoints
from core.plant.mechanics import Drives
from core.procedure.record import record
from core.sessions.simulated import SimulatedSession
from tests.core.gap.recorded_run import plan_of


@pytest.mark.parametrize(
    ("stiffness_nm_per_rad", "payload"),
    [
        (24e3, "steel_block"),
        pytest.param(50e3, "cylinder", marks=pytest.mark.thorough),
        pytest.param(24e3, "cylinder", marks=pytest.mark.thorough),
        pytest.param(50e3, "steel_block", marks=pytest.mark.thorough),
    ],
)
def test_the_payload_is_right_within_its_uncertainty(stiffness_nm_per_rad: float, payload: str) -> None:
    cell, plan = plan_of("ur5e_line", payload)
    carried = cell.payloads[payload]
    springs = ElasticJoints((stiffness_nm_per_rad,) * 6)
    session = SimulatedSession(cell, carried.parameters, seed=2, faults=(springs,), drives=Drives(damping_s=0.0, friction=0.0))
    answer = identify_recording(drive(record(cell, session, carried.box, plan, payload=payload)))
    found = answer.estimate
    assert found is not None
    assert found.determined.all()
    assert found.phi[0] == pytest.approx(carried.parameters.mass, rel=0.005)
    away = (found.phi - carried.parameters.phi) / found.std
    assert np.abs(away).max() < 2.5
    said = {warning.code for warning in answer.warnings}
    assert "estimation-gears-accounted" in said
    assert not said & {"estimation-base-tilt", "estimation-drift-accounted"}
    assert answer.accounted == ()  # that is the twin's
