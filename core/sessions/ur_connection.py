"""Reaching a Universal Robots controller, and whether what is reached is the cell's arm."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from core.cell.cell import Cell
from core.errors import NotConnected
from core.robot.model import RobotModel
from core.sessions.controller import Controller, check_controller
from core.sessions.rtde import Rtde, RtdeError, Value
from core.sessions.ur_controller import ControllerFound, read_controller
from core.sessions.ur_readiness import flange_of
from core.sessions.ur_servo import read_vector

LEAST = (5, 10)
E_SERIES = frozenset({"UR3", "UR5", "UR10", "UR16"})


class Reached(NamedTuple):
    """A controller: its open line, whose samples come, and what it tells beside them."""

    rtde: Rtde
    found: ControllerFound
    version: str


def reach(host: str, outputs: Sequence[str], inputs: Sequence[str], rate_hz: float) -> Reached:
    """Asks the controller what it is, and lets its samples come. Nothing moves.

    Raises:
        NotConnected: it cannot be reached, or has not what is asked of it.
    """
    rtde: Rtde | None = None
    try:
        found = read_controller(host)
        rtde = Rtde(host)
        version = rtde.find_version()
        rtde.set_up(outputs, inputs, rate_hz)
        rtde.start()
        return Reached(rtde, found, version)
    except (RtdeError, OSError) as error:
        if rtde is not None:
            rtde.close()
        if isinstance(error, RtdeError):
            raise NotConnected("session-ur-rtde-refused", host=host, what=error.what, answer=error.answer) from error
        raise NotConnected("session-not-reached", host=host, reason=str(error)[:120]) from error


def check_arm(cell: Cell, robot: RobotModel, reached: Reached, sample: dict[str, Value]) -> None:
    """Nothing where the controller is that of the cell's robot.

    Args:
        sample: with `actual_q`, `actual_TCP_pose` and `tcp_offset`.

    Raises:
        WrongRobot: it is not.
    """
    found = reached.found
    model = f"{found.model}e" if found.model in E_SERIES else found.model  # some versions leave the e of the series away
    position, rotation = flange_of(sample)
    q, limits = np.array(read_vector(sample, "actual_q")), found.configuration
    said = Controller(model, found.serial, reached.version, q, position, rotation, limits.lower, limits.upper, limits.velocity)
    check_controller(cell, robot, said, supported="5.10 to 5.x", least=LEAST)
