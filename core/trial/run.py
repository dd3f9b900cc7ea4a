"""One trial from the sealed draw to the opened answer."""

from __future__ import annotations

from pathlib import Path

from core.cell.cell import Cell, Friction
from core.errors import Stopped
from core.events import drive
from core.gap.diagnosis import examine
from core.gap.evidence import Evidence
from core.gap.fit_all import one_by_one
from core.plant.faults import Fault, Setting
from core.plant.mechanics import Drives
from core.procedure.record import record
from core.recording.folder import write_recording
from core.recording.recording import Recording
from core.sessions.simulated import SimulatedSession
from core.trial.bound import Bound, bound_of
from core.trial.draw import DrawnTrial
from core.trial.outcome import TrialOutcome, make_outcome, make_stopped_outcome
from core.trial.second_look import second_look
from core.trial.truth import Parameters, difference_of, translate_truth, true_payload_of

SMOOTH = Drives(damping_s=0.0, friction=0.0)
"""Friction is one of the faults: where it is not planted, there is none."""


def run_trial(drawn: DrawnTrial, keep: Path | None = None) -> TrialOutcome:
    """Runs the procedure with the faults, diagnoses without them, and opens the seal. On one core.

    Args:
        keep: folder in which the recording is left, under the trial's seed: at the end, so that a trial which is cut short leaves nothing
            in the way of its next time.
    """
    sealed = drawn.sealed
    try:
        recording = record_procedure(drawn, (*drawn.background, *drawn.faults))
    except Stopped as error:
        return make_stopped_outcome(sealed, error.message)
    diagnosis, evidence = examine(recording, fit_all=one_by_one)
    nominal = drawn.cell.payloads[sealed.payload].parameters
    payload = true_payload_of(drawn.cell, nominal, (*drawn.background, *drawn.faults)).phi
    bound = Bound() if evidence is None or not sealed.ids else _bound(drawn, recording, evidence)
    truth = _truth(drawn)
    after = None if evidence is None else second_look(drawn, recording, evidence, SMOOTH)
    second = None if after is None else make_outcome(sealed, after, truth, payload, bound)
    if keep is not None:
        write_recording(recording, keep / str(sealed.seed))
    return make_outcome(sealed, diagnosis, truth, payload, bound).model_copy(update={"second": second})


def record_procedure(drawn: DrawnTrial, faults: tuple[Fault, ...]) -> Recording:
    """The procedure on the virtual robot.

    Raises:
        Stopped: the guard has given up.
    """
    cell, name = without_friction(drawn.cell), drawn.sealed.payload
    carried = cell.payloads[name]
    session = SimulatedSession(cell, carried.parameters, seed=drawn.sealed.seed, faults=faults, drives=SMOOTH)
    return drive(record(cell, session, carried.box, drawn.plan, payload=name, reference=carried))


def without_friction(cell: Cell) -> Cell:
    """The cell as it is with `SMOOTH` drives: it states that there is none."""
    none = (0.0,) * len(cell.robot.home_rad)
    robot = cell.robot.model_copy(update={"friction": Friction(coulomb_n_m=none, viscous_n_m_s=none)})
    return cell.model_copy(update={"robot": robot})


def _bound(drawn: DrawnTrial, recording: Recording, evidence: Evidence) -> Bound:
    nominal = drawn.cell.payloads[drawn.sealed.payload].parameters
    payload = true_payload_of(drawn.cell, nominal, (*drawn.background, *drawn.faults)).phi
    return bound_of(drawn.sealed.ids, recording, evidence, record_procedure(drawn, drawn.background), nominal.phi, payload)


def _truth(drawn: DrawnTrial) -> dict[str, Parameters]:
    """Parameters of what was planted, in the effects' words; empty ones are left out."""
    nominal = drawn.cell.payloads[drawn.sealed.payload].parameters
    setting = Setting(drawn.cell, nominal, drawn.plan.robot_s)
    told = {name: translate_truth(name, variant, truth, setting) for name, variant, truth in drawn.sealed.planted}
    if "payload_mismatch" in told:
        payload = true_payload_of(drawn.cell, nominal, drawn.faults)
        told["payload_mismatch"] = difference_of(payload.phi, nominal.phi)
    return {name: parameters for name, parameters in told.items() if parameters}
