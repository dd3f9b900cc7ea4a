"""The session of a cell: simulated, or that of the driver that cell.toml names. This is the one place that opens it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.cell.session import RealRobot
from core.payload.inertia import InertialParameters
from core.sensors.opening import open_sensor
from core.sessions.external_sensor import ExternalSensorSession
from core.sessions.franka import FrankaSession
from core.sessions.kuka import KukaSession
from core.sessions.pace import Pace
from core.sessions.session import RobotSession
from core.sessions.simulated import SimulatedSession
from core.sessions.ur import UniversalRobotsSession
from core.sessions.xarm import XarmSession
from core.twin.twin import NOMINAL, Twin

DRIVERS: Mapping[str, Callable[[Cell], RobotSession]] = {
    "ur_rtde": UniversalRobotsSession,
    "xarm": XarmSession,
    "kuka_fri": KukaSession,
    "franka_fci": FrankaSession,
}
"""Makes the session of a real robot; a driver reaches for nothing before it is entered or asked where the robot stands."""


@dataclass(frozen=True)
class Simulation:
    """What the virtual robot is told and no real one: arguments of `SimulatedSession`.

    Args:
        payload: what it carries, sensor frame; a bare flange where None.
        start: (n,), where it stands on the first entry, rad; at home where absent.
    """

    payload: InertialParameters | None
    seed: int = 0
    pace: Pace | None = None
    twin: Twin = NOMINAL
    start: Array | None = None


def is_simulated(cell: Cell) -> bool:
    """Whether the cell's robot is the virtual one."""
    return cell.session.driver == "simulated"


def open_robot_session(cell: Cell, simulation: Simulation) -> RobotSession:
    """The session with the cell's robot, and with the sensor that has a line of its own, to be entered.

    Args:
        simulation: used where the robot is simulated.

    Raises:
        BadRobot, BadPayload: the simulation cannot be built.
        BadCell: the driver lacks something that the cell has to say.
    """
    if is_simulated(cell):
        given = simulation
        carried = given.payload or InertialParameters(np.zeros(10))
        return SimulatedSession(cell, carried, seed=given.seed, pace=given.pace, twin=given.twin, start=given.start)
    robot, link = DRIVERS[cell.session.driver](cell), cell.session
    if not isinstance(link, RealRobot) or link.sensor is None:
        return robot
    return ExternalSensorSession(robot, open_sensor(link.sensor), sign=link.sensor.sign, range_=np.array(cell.sensor.range))
