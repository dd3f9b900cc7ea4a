"""Whether what a run has found is good enough for the cell that it was found in."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from core.cell.cell import Cell
from core.payload.inertia import InertialParameters
from core.requirement.answer import Judged, RequirementPart, list_undetermined, requirement_part
from core.requirement.motions import make_brisk_motion
from core.requirement.requirement import require
from core.words.message import Message

if TYPE_CHECKING:  # who only reads verdicts waits for no robot
    from core.robot.model import RobotModel


def judge_estimate(cell: Cell, robot: RobotModel, estimate: Judged | None) -> RequirementPart:
    """The verdict by the cell's thresholds, along moves as brisk as its robot allows.

    Args:
        estimate: of all that the sensor carries; None where nothing was identified.
    """
    motion = make_brisk_motion(cell, robot)
    phi = np.full(10, np.nan) if estimate is None else np.array(estimate.phi, dtype=float)
    if estimate is not None and not list_undetermined(estimate) and phi[0] > 0.0:
        return requirement_part(require(cell, robot, InertialParameters(phi), motion), motion, estimate)
    return RequirementPart(
        assumed=not cell.thresholds.states_contact,
        thresholds=[],
        source=cell.thresholds.source,
        motion="brisk",
        motion_s=motion.duration_s,
        allowed=[],
        adequacy=None,
        message=_say_why_not(estimate),
        details=[],
    )


def _say_why_not(estimate: Judged | None) -> Message:
    lacking = [] if estimate is None else list_undetermined(estimate)
    return Message.of("requirement-not-determined", names=lacking) if lacking else Message.of("requirement-no-body")
