"""What `core.requirement` says of a result, as a statement of conformity."""

from __future__ import annotations

from core.cell.cell import Cell
from core.certificate.conformity import Conformity
from core.errors import HeftError
from core.estimation.result import Result
from core.requirement.answer import AdequacyPart
from core.requirement.requirement import COVERED, DRAWS
from core.requirement.verdict import judge_estimate
from core.robot.model import RobotModel
from core.words.message import Message


def state_conformity(result: Result, cell: Cell | None) -> Conformity:
    """Whether a result is good enough for the controller of its cell: as was judged at the end of the run, else now.

    Args:
        cell: whose thresholds count where nothing was judged yet; None where nobody knows it.
    """
    if result.estimate is None:
        return _refrain("certificate-nothing-identified")
    found = result.requirement
    if found is None:
        if cell is None:
            return _refrain("certificate-no-cell")
        try:
            found = judge_estimate(cell, RobotModel.of_cell(cell), result.estimate)
        except HeftError as error:
            return _refrain("certificate-not-judged", reason=error.message)
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


def _refrain(code: str, /, **parameters: Message) -> Conformity:
    return Conformity(conforms=None, statement=Message.of(code, **parameters))
