"""What was late, and how late it was."""

from __future__ import annotations

from enum import StrEnum

from pydantic import BaseModel, ConfigDict, Field


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

    cause: Cause = Field(description="What was late.")
    late_s: float = Field(description="How late it was, s.", examples=[0.42])
    limit_s: float = Field(description="How late it might have been, s.", examples=[0.22])
