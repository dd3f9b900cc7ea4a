"""What `core.requirement` says of a result, as a statement of conformity."""

from __future__ import annotations

import numpy as np

from core.cell.cell import Cell
from core.certificate.conformity import Conformity
from core.errors import HeftError
from core.estimation.result import EstimatePart, Result
from core.payload.inertia import PHI_NAMES, InertialParameters
from core.requirement.answer import AdequacyPart, requirement_part
from core.requirement.motions import make_brisk_motion
from core.requirement.requirement import COVERED, DRAWS, require
from core.robot.model import RobotModel
from core.words.message import Message


def state_conformity(result: Result, cell: Cell | None) -> Conformity:
    """Whether a result is good enough for a cell's controller, along motions as brisk as the cell's limits allow.

    Args:
        cell: whose thresholds count; None where nobody knows it.
    """
    if cell is None:
        return _refrain("certificate-no-cell")
    if result.estimate is None:
        return _refrain("certificate-nothing-identified")
    lacking = [name for name, known in zip(PHI_NAMES, result.estimate.determined, strict=True) if not known]
    if lacking:
        return _refrain("requirement-not-determined", names=lacking)
    try:
        return _judge(result.estimate, cell)
    except HeftError as error:
        return _refrain("certificate-not-judged", reason=error.message)


def _judge(estimate: EstimatePart, cell: Cell) -> Conformity:
    robot = RobotModel.of_cell(cell)
    motion = make_brisk_motion(cell, robot)
    payload = InertialParameters(np.array(estimate.phi, dtype=float))
    found = requirement_part(require(cell, robot, payload, motion), motion, estimate)
    if found.adequacy is None:
        return Conformity(conforms=None, statement=found.message)
    return _state(found.adequacy, found.message, assumed=found.assumed, motion_s=found.motion_s)


def _state(adequacy: AdequacyPart, verdict: Message, *, assumed: bool, motion_s: float) -> Conformity:
    return Conformity(
        conforms=adequacy.good_enough,
        statement=verdict,
        rule=Message.of("certificate-rule", probability=COVERED, risk=1.0 - COVERED, draws=DRAWS, motion_s=motion_s),
        used=adequacy.used,
        margin=adequacy.margin,
        criterion=adequacy.criterion.message,
        decides=adequacy.decides,
        assumed=assumed,
        motion_s=motion_s,
    )


def _refrain(code: str, /, **parameters: Message | list[str]) -> Conformity:
    return Conformity(conforms=None, statement=Message.of(code, **parameters))
