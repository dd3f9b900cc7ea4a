"""The tree of errors. Every sentence says what, where, the value against the limit, and what to do next.

HeftError                      exit code 1
├── BadInput                   2   a file, key or value that cannot be used; nothing was written
│   ├── BadCell                    cell.toml contradicts itself or is malformed
│   ├── BadRobot                   the URDF is malformed, hostile or lacks what is needed
│   ├── BadPayload                 a payload that no rigid body can have
│   ├── BadTwin                    a twin.json that cannot be used, or an effect that cannot be added to it
│   ├── BadZone                    a protected zone that somebody draws and that cannot be so
│   ├── BadRecording               a recording that cannot be read
│   └── MissingPackage             a driver's package is not installed
├── Refused                    3   the cell leaves no safe way to do it; the robot has not moved
│   ├── NoStartConfiguration       no start configuration for an axis (Algorithm 6)
│   ├── NoPath                     no collision-free path, or none that can be timed
│   ├── NoRoomAtHome               the payload box that was asked for is too close to something at home
│   ├── NotConnected               the robot or its sensor cannot be reached, or lets nobody command it
│   ├── WrongRobot                 what is connected is not what the cell describes
│   ├── PayloadNotTaken            a controller has another payload than it was set to
│   ├── UnusableSensor             a sensor is another one than the cell says, or is set up so that it cannot be used
│   ├── TooHeavy                   a joint has not the torque to carry the load as planned
│   └── PlanDisputed               a finished plan that an independent check does not confirm
├── Stopped                    4   the guard stopped the robot; carries the last samples
│   ├── TooClose                   to an obstacle, a protected zone or itself
│   ├── TooFast                    a link, a corner of the payload box, or a joint
│   ├── OutOfLimits                joint position
│   ├── OverLoad                   the wrist wrench
│   ├── BadState                   stale, non-finite or inconsistent robot state
│   │   ├── SensorFrozen           the wrench does not change any more
│   │   ├── RobotStateLate         the robot's state came too late
│   │   ├── ControllerStopped      the robot's controller has stopped it, or obeys no longer
│   │   ├── WrongKinematics        the flange moves otherwise than the cell's kinematics say
│   │   ├── WrongSensor            the wrench does not turn with the robot as the cell says
│   │   ├── SensorLate             a sensor with a line of its own sends nothing
│   │   └── SensorFault            a sensor says that its reading is none
│   ├── Held                       the robot keeps its place and goes on when it is told to
│   │   └── ControlLost            nobody is in control of the robot any more
│   └── Commanded                  somebody asked to stop; no way back into the same run
│       └── HoldExpired            nobody came back in time to a robot that was on hold
└── Interrupted                130 Ctrl-C or SIGTERM; the robot was stopped and the recording closed
"""

from __future__ import annotations

import re
from enum import StrEnum
from typing import TYPE_CHECKING, ClassVar

from pydantic import BaseModel, ConfigDict, Field

from core.words.message import Message, Parameter

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence


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


class HeftError(Exception):
    """Root of all errors that a user can meet; `str(error)` is one sentence meant for them.

    Args:
        code: which message of the catalogue.
        parameters: what it names.

    Attributes:
        message: it as a code with parameters, for people of any language.
    """

    exit_code: ClassVar[int] = 1
    in_the_way: str | None = None
    """Name of the obstacle, zone or link that is in the way, where that is what it is about."""

    def __init__(self, code: str, /, **parameters: Parameter) -> None:
        super().__init__(code)
        self.message = Message.of(code, **parameters)

    def __str__(self) -> str:
        return self.message.text


class BadInput(HeftError):
    """What the user gave cannot be used.

    Args:
        where: the file, with the key, column or row in it.
        code: the message of the catalogue whose `found` and `expected` say what is there and what would have been right.
        parameters: what they name.

    Attributes:
        others: what else is wrong there, each as an error of its own.
    """

    exit_code = 2
    others: tuple[BadInput, ...] = ()

    def __init__(self, where: str | Message, code: str, /, **parameters: Parameter) -> None:
        super().__init__(code, where=where, **parameters)

    @property
    def where(self) -> str:
        """The file, with the key, column or row in it."""
        return str(self.message.parameters["where"])

    @property
    def found(self) -> str:
        """The value that was found."""
        return self.message.say_part("found")

    @property
    def expected(self) -> str:
        """What would have been right."""
        return self.message.say_part("expected")


class BadCell(BadInput):
    """A cell.toml that is malformed or contradicts itself.

    Args:
        in_the_way: name of what stands where the robot is.
    """

    def __init__(self, where: str | Message, code: str, /, in_the_way: str | None = None, **parameters: Parameter) -> None:
        super().__init__(where, code, **parameters)
        self.in_the_way = in_the_way


def together(flaws: Sequence[BadInput]) -> BadInput:
    """All that is wrong with one thing as the error of the first, the rest as its `others`."""
    first = flaws[0]
    first.others = tuple(flaws[1:])
    return first


def refuse(flaws: Sequence[BadInput]) -> None:
    """Nothing where nothing is wrong.

    Raises:
        BadInput: all of them `together`.
    """
    if flaws:
        raise together(flaws)


class BadRobot(BadInput):
    """A URDF that is malformed, hostile, or lacks limits, masses or frames."""


class BadPayload(BadInput):
    """Inertial parameters that no rigid body can have, or an unknown payload name."""


class BadTwin(BadInput):
    """A twin.json that cannot be used, or an effect that cannot be added to it."""


class BadZone(BadInput):
    """A protected zone that somebody draws and that cannot be so."""


class BadRecording(BadInput):
    """A recording folder that cannot be read."""


class MissingPackage(BadInput):
    """A driver's package is optional, and is not installed."""


class Refused(HeftError):
    """The cell leaves no safe way to do what was asked. The robot has not moved.

    Args:
        in_the_way: name of the obstacle, zone or link that is in the way, where that is what it is about.

    Attributes:
        axis: sensor axis, with its sign, that has no room or cannot be reached; None where it is about something else.
        axes_with_room: sensor axes for which there is a plan without it; empty where none is known.
    """

    exit_code = 3
    axis: str | None = None
    axes_with_room: str = ""

    def __init__(self, code: str, /, in_the_way: str | None = None, **parameters: Parameter) -> None:
        super().__init__(code, **parameters)
        self.in_the_way = in_the_way

    def offer_axes(self, axes_with_room: str) -> None:
        """Say too that there is a plan for these sensor axes."""
        self.axes_with_room = axes_with_room
        self.message = Message.of("planning-other-axes", refusal=self.message, axes=",".join(axes_with_room))


class NoStartConfiguration(Refused):
    """Algorithm 6 found no start configuration for an axis.

    Args:
        axis: sensor axis with its sign, for example "x+" (along gravity).
        reasons: how many candidates each check rejected, the most frequent first.
        best_clearance_m: largest distance to anything that was met among reachable candidates, None if none was reachable.
        nearest: the obstacle, zone or link that was nearest in that best candidate.
        in_the_way: name of what keeps most of those with room to stand from being used, or of what was nearest.
    """

    axis: str

    def __init__(
        self,
        axis: str,
        reasons: Mapping[Message, int],
        best_clearance_m: float | None = None,
        nearest: Message | None = None,
        in_the_way: str | None = None,
    ) -> None:
        rejected = sorted(reasons.items(), key=lambda item: -item[1])
        counts = [Message.of("planning-rejected", reason=reason, count=count) for reason, count in rejected]
        code, near = "planning-no-start-configuration", dict[str, Parameter]()
        if best_clearance_m is not None and nearest is not None:
            code, near = "planning-no-start-configuration-near", {"best_clearance_m": best_clearance_m, "nearest": nearest}
        super().__init__(code, in_the_way, axis=axis, rejected=counts, kinds=len(counts), **near)
        self.axis = axis
        self.best_clearance_m = best_clearance_m


class NoPath(Refused):
    """No collision-free path between two configurations was found, or none that keeps the limits; in the way is what was nearest."""


class NoRoomAtHome(Refused):
    """The payload box that was asked for, which is not the cell's own, is too close to something at home, which has to be named."""

    def __init__(self, code: str, /, in_the_way: str, **parameters: Parameter) -> None:
        super().__init__(code, in_the_way, **parameters)


class NotConnected(Refused):
    """The robot or its sensor cannot be reached, or lets nobody command it as it is."""


class WrongRobot(Refused):
    """What is connected is not what the cell describes: model, serial number, firmware, limits or kinematics."""


class PayloadNotTaken(Refused):
    """What a controller reports after a payload was written to it is not what was written."""


class UnusableSensor(Refused):
    """A sensor with a line of its own is another one than the cell says, or is set up so that its wrench cannot be used."""


class TooHeavy(Refused):
    """The load asks more torque of a joint than it has."""


class PlanDisputed(Refused):
    """A finished plan was measured once more by other code with another collision library, and does not keep a limit there."""


class Stopped(HeftError):
    """The guard stopped the robot.

    Args:
        code: the message that says what, where, value against limit, and the next step.
        value: the measured value, SI.
        limit: what it was compared with, SI.
        samples: the last robot states before the stop, oldest first.
        parameters: what the message names besides `value` and `limit`, which it may name too.
    """

    exit_code = 4
    may_go_on: ClassVar[bool] = True
    """Whether the procedure may go on by itself once the robot stands."""
    cause: ClassVar[Cause | None] = None
    """What was late, where that is what the error is about: `value` and `limit` are its times, s."""
    lateness: Lateness | None = None

    def __init__(self, code: str, /, *, value: float, limit: float, samples: Sequence[object] = (), **parameters: Parameter) -> None:
        super().__init__(code, value=value, limit=limit, **parameters)
        self.value = value
        self.limit = limit
        self.samples = tuple(samples)
        if self.cause is not None:
            self.lateness = Lateness(cause=self.cause, late_s=value, limit_s=limit)


class TooClose(Stopped):
    """The robot or the payload box came, or could no longer stop before coming, nearer than the clearance."""


class TooFast(Stopped):
    """A point of a link or of the payload box exceeds the Cartesian limit, or a joint its own."""


class OutOfLimits(Stopped):
    """A joint left its position limits."""


class OverLoad(Stopped):
    """The wrist wrench exceeds the sensor's range or the cell's limit."""


class BadState(Stopped):
    """The robot's state or its wrench is stale or not finite, or does not follow the command: nobody may move on what is not seen."""

    may_go_on = False


class SensorFrozen(BadState):
    """The wrench has not changed for longer than a live sensor's noise allows."""

    cause = Cause.SENSOR


class RobotStateLate(BadState):
    """The robot's state came later than the control loop may wait for it."""

    cause = Cause.ROBOT


class ControllerStopped(BadState):
    """The robot's controller has stopped it by itself, or takes commands no longer."""


class WrongKinematics(BadState):
    """The flange that a controller reports moves otherwise than the cell's kinematics say: another order or sign of its joints."""


class WrongSensor(BadState):
    """The wrench does not turn with the robot as the cell says: another sign, other axes, or no load that could tell."""


class SensorLate(BadState):
    """A sensor with a line of its own has sent nothing for longer than the guard allows."""

    cause = Cause.SENSOR


class SensorFault(BadState):
    """The sensor itself says that its reading is no measurement: saturated, too hot, broken."""


class Held(Stopped):
    """The robot keeps its place and goes on from there when it is told to: somebody asked for it, or something was late."""


class ControlLost(Held):
    """Nobody is in control of the robot any more: the console, the server or the way between them was late.

    Args:
        lateness: which of them, by how much.
    """

    def __init__(self, code: str, /, lateness: Lateness, **parameters: Parameter) -> None:
        super().__init__(code, value=lateness.late_s, limit=lateness.limit_s, samples=(), **parameters)
        self.lateness = lateness


class Commanded(Stopped):
    """Somebody asked to stop."""

    may_go_on = False


class HoldExpired(Commanded):
    """The robot was on hold and nobody was in control of it for longer than a hold may last."""


class Interrupted(HeftError):
    """The operator interrupted the run; the robot was stopped and the recording closed."""

    exit_code = 130


def slug(name: str) -> str:
    """The name of an error as its kind: `BadCell` as `bad-cell`."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "-", name).lower()
