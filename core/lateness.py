"""Lateness with its cause: which part of the way from the operator to the robot was late, by how much, against which limit."""

from __future__ import annotations

from enum import StrEnum

from pydantic import BaseModel, ConfigDict


class Cause(StrEnum):
    """What was late.

    `network`: answers of the console did not arrive. `page`: they arrived, but the page behind them did not respond. `service`: the
    service gave no sign of life. `store`: the database did not take what happened. `control_process`: the control loop itself got no
    time. `sensor`: the wrench stood still. `robot`: the robot's state came late.
    """

    NETWORK = "network"
    PAGE = "page"
    SERVICE = "service"
    STORE = "store"
    CONTROL_PROCESS = "control_process"
    SENSOR = "sensor"
    ROBOT = "robot"


class Lateness(BaseModel):
    """How late it was, and what was allowed."""

    model_config = ConfigDict(frozen=True)

    cause: Cause
    late_s: float
    limit_s: float

    def __str__(self) -> str:
        return f"{1e3 * self.late_s:.0f} ms (limit {1e3 * self.limit_s:.0f} ms)"
