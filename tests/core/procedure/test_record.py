"""A plan carried out for its recording alone."""

from __future__ import annotations

import numpy as np

from core.events import drive
from core.planning.settings import Timing
from core.planning.stops import Stops
from core.procedure.identify import carry_out
from core.procedure.record import record
from core.sessions.simulated import SimulatedSession
from tests.core.gap.recorded_run import plan_of


def test_the_recording_is_that_of_the_whole_procedure_with_the_same_plan() -> None:
    cell, plan = plan_of("lwr4_bench", "cylinder")
    assert tuple(leg.stop for leg in plan.legs) == Stops.of_procedure(timing=Timing(robot_s=45.0)).stops
    carried = cell.payloads["cylinder"]

    def session() -> SimulatedSession:
        return SimulatedSession(cell, carried.parameters, seed=3)

    alone = drive(record(cell, session(), carried.box, plan, payload="cylinder", reference=carried))
    whole = drive(carry_out(cell, session(), carried.box, plan, payload="cylinder", reference=carried)).recording
    for name in ("t", "q", "q_cmd", "wrench", "phase"):
        assert np.array_equal(getattr(alone, name), getattr(whole, name))
    assert alone.reference_of_whole is not None
