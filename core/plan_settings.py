"""What a plan is asked to be like: how long the robot stands still, how accurate the answer is to be, how paths are searched."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Planner = Literal["rrt_connect", "rrt_star"]


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
