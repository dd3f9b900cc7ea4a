"""The motion that an answer asks for, made on the same robot with the same fault, and the answer to both recordings together."""

from __future__ import annotations

from core.errors import Refused, Stopped
from core.events import drive
from core.gap.answer import Diagnosis
from core.gap.choice import choose_experiment
from core.gap.diagnosis import examine
from core.gap.evidence import Evidence
from core.gap.fit_all import one_by_one
from core.planning.stops import Stops
from core.plant.mechanics import Drives
from core.procedure.identify import identify
from core.recording.recording import Recording
from core.sessions.simulated import SimulatedSession
from core.trial.draw import DrawnTrial

NEXT = 1_000_000
"""Added to the seed: other noise and offsets than in the first run."""


def second_look(drawn: DrawnTrial, recording: Recording, evidence: Evidence, drives: Drives) -> Diagnosis | None:
    """None where the answer asks for no motion, or for none that can be made in the cell or gets by the guard."""
    cell, name = drawn.cell, drawn.sealed.payload
    carried = cell.payloads[name]
    faults = (*drawn.background, *drawn.faults)
    if not evidence.proposals:
        return None
    try:
        stops = drive(choose_experiment(cell, recording, evidence, carried.box)).proposal.motion.stops
        if not stops:  # another payload is asked for
            return None
        session = SimulatedSession(cell, carried.parameters, seed=drawn.sealed.seed + NEXT, faults=faults, drives=drives)
        both = drive(identify(cell, session, carried.box, stops=Stops(stops), before=recording)).recording
    except (Refused, Stopped):
        return None
    return examine(both, fit_all=one_by_one)[0]
