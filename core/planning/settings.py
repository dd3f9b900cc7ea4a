"""What a plan is asked to be like: what of the procedure is wanted, how long the robot stands still, how accurate the answer is to be."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from core.estimation.determination import explain_not_excited
from core.words.message import Message

Planner = Literal["rrt_connect", "rrt_star"]

MAX_EFFORT = 100
"""Times the usual search, see `core.planning.effort`."""


@dataclass(frozen=True)
class Timing:
    """How long the robot stands still, and how accurate the moments of inertia are to be.

    Args:
        hold_s: motionless phase on arrival.
        settle_s: motionless phase after a rotation (the paper: about 1 s).
        inertia_std: wanted relative standard deviation of each moment of inertia, before everything else that limits it.
        robot_s: bound on the robot time of one run; repetitions are cut to keep it.
        swing_rad: angle of a rotation out and back. Only accelerating samples tell about inertia, so many small swings are worth as
            much as few wide ones, at a lower speed of everything that moves along, in less room.
    """

    hold_s: float = 1.5
    settle_s: float = 1.0
    inertia_std: float = 0.004
    robot_s: float = 115.0
    swing_rad: float = 0.25


@dataclass(frozen=True)
class Scope:
    """Which part of the procedure is wanted.

    Args:
        axes: sensor axes that are laid along and against gravity and, where there are rotations, turned about; in the order x, y, z.
        rotations: whether there are any. Holds alone tell mass and first moment.
    """

    axes: str = "xyz"
    rotations: bool = True

    @property
    def not_excited(self) -> dict[str, Message]:
        """Name of each inertial parameter that no rotation of this part shows -> why. Transfers may show it all the same."""
        return explain_not_excited(self.axes if self.rotations else "")


WHOLE = Scope()
"""The whole procedure."""
