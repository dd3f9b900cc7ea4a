"""What the control loop needs of a robot, simulated, replayed or real."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from types import TracebackType
from typing import Self

from core.array import Array
from core.words.message import Message


@dataclass(frozen=True)
class RobotState:
    """One sample of the robot, SI.

    Args:
        t: robot's own clock, s.
        q, dq: (n,) measured joint positions and velocities.
        q_cmd: (n,) joint positions commanded at this moment.
        wrench: (6,) raw wrist wrench in the paper's sign, offsets included.
        tau: (n,) joint torques, None where the robot does not give them.
        temperature: of the sensor, degC, None where unknown.
        wrench_measured: whether the wrench was measured at `t`; one that is held for want of it may be looked at, and is not recorded.
    """

    t: float
    q: Array
    dq: Array
    q_cmd: Array
    wrench: Array
    tau: Array | None = None
    temperature: float | None = None
    wrench_measured: bool = True


class RobotSession(ABC):
    """Owns the robot from entry to exit; one control cycle is `state()`, then `command(q)`.

    `state()` waits for the next control period and returns the sample taken then. A cycle without a command holds the last one.
    """

    period: float
    """Control period, s."""
    late_s: float = 0.01
    """A state that comes so long after the last one is too late to move on, s; below the time after which the robot stops by itself."""

    @abstractmethod
    def find_start(self) -> Array:
        """Joint positions (n,) from which the first command has to go on, rad; to be asked before the entry. A driver of a real robot
        connects for it, checks that it is the cell's, and lets it go again without having moved it.

        Raises:
            MissingPackage, NotConnected, WrongRobot: it cannot be used.
        """

    @abstractmethod
    def __enter__(self) -> Self: ...

    @abstractmethod
    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        """Stops the robot if it moves and lets it go."""

    @abstractmethod
    def state(self) -> RobotState:
        """Waits for the next period and returns the robot's state at it."""

    @abstractmethod
    def command(self, q: Array) -> None:
        """Sets the joint positions (n,) to be reached by the next period, rad."""

    @abstractmethod
    def stop(self) -> None:
        """Brakes to standstill within the robot's own limits, from whatever it does. Further commands are refused until a new entry
        or `release()`."""

    def complete(self, state: RobotState) -> RobotState:
        """A state of before with its wrench, where that was not measured then and has come since; else as it was."""
        return state

    def remarks(self) -> list[Message]:
        """What a person should know of the lines to robot and sensor so far: losses, clocks, settings."""
        return []

    @abstractmethod
    def release(self) -> None:
        """Allows commands again after a stop, from the position the robot stands at."""
