"""The wave of a stop that tells most of the payload through the joints' torques, among waves of several bands and wrists."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

from core.array import Array
from core.cell.cell import Cell
from core.errors import NoPath
from core.payload.inertia import InertialParameters
from core.planning.stop import Wave, wave_shape
from core.planning.torque_information import TorqueInformation
from core.planning.wave import fit_wave
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.trajectory import JointTrajectory

WRISTS = (1.0, 4.0, 16.0)
"""How many times faster the last joint turns than the first. The first moves everything, and what is far out reaches the speed limit."""
BANDS = ((1.0, 1.0), (1.0, 1.0 / 3.0), (2.0, 1.0))
"""Of the lowest and the highest frequency. Slow turns show the mass, quick ones the inertia, and where there is little room only these."""


def list_waves(wave: Wave) -> list[Wave]:
    """The waves that a wave with an open wrist stands for."""
    open_ends = product(BANDS, WRISTS)
    return [
        wave.model_copy(update={"lowest_hz": low * wave.lowest_hz, "highest_hz": high * wave.highest_hz, "wrist": wrist})
        for (low, high), wrist in open_ends
    ]


def choose_wave(
    cell: Cell,
    robot: RobotModel,
    collision: CollisionModel,
    load: InertialParameters,
    q: Array,
    wave: Wave,
    before: Sequence[JointTrajectory],
) -> tuple[Wave, JointTrajectory]:
    """The one that tells most after the motions before it, as large as limits and room allow.

    Args:
        load: what the robot is taken to carry, sensor frame.
        q: (n,), where it begins and ends, rad.
        before: motions that are made anyway, at least one.

    Raises:
        NoPath: none of them has room.
    """
    told = TorqueInformation(cell, robot, load)
    found: list[tuple[float, Wave, JointTrajectory]] = []
    refused: NoPath | None = None
    for each in list_waves(wave):
        try:
            trajectory = fit_wave(cell, robot, collision, q, wave_shape(each, robot.n, before[0].period), before[0].period)
        except NoPath as error:
            refused = error
        else:
            found.append((told.find_open([*before, trajectory]), each, trajectory))
    if not found:
        assert refused is not None  # there is at least one wave
        raise refused
    _, chosen, trajectory = min(found, key=lambda each: each[0])
    return chosen, trajectory
