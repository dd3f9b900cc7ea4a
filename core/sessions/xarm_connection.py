"""Reaching a UFACTORY controller, and whether what is reached is the cell's arm."""

from __future__ import annotations

import re
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.cell.session import XarmRobot
from core.errors import NotConnected, WrongRobot
from core.robot.model import RobotModel
from core.sessions.controller import ANGLE_RAD, Controller, Kinematics, check_controller, check_identity
from core.sessions.xarm_line import FORWARD, GET_POSE, IS_BEYOND, SERIAL, VERSION, ControlLine, ReportLine, pack_floats
from core.sessions.xarm_reports import (
    FAST_LEAST,
    FAST_PORT,
    METRE,
    SLOTS,
    SLOW_LEAST,
    SLOW_PORT,
    FastReport,
    Pose,
    SlowReport,
    read_fast,
    read_pose,
    read_slow,
    remove_tool,
)  # fmt: skip

LEAST, SUPPORTED = (2, 1), "2.1 and newer"
"""The first version that reports on port 30000, by the maker's description."""
MODELS = {(5, 5): "xArm5", (6, 6): "xArm6", (7, 7): "xArm7", (7, 3): "xArm7", (6, 9): "Lite6", (6, 12): "850"}
"""By number of axes and type."""
_VERSION = re.compile(r"(\d+),(\d+),([^,]*),([^,]*),.*?(\d+\.\d+\.\d+)")
FIRST_S = 3.0
"""How long the first report may take; the slow ones come five times a second."""
CONFIGURATIONS = 6
"""How many the controller's forward kinematics are asked for."""
MIDDLE = 0.6
"""Share of the joints' range in which they are."""
INSIDE_RAD = 1e-3
"""So far inside of the cell's limits the controller is asked whether it goes there."""


class Identity(NamedTuple):
    """What a controller tells of itself."""

    axes: int
    model: str
    serial: str
    version: str


class Reached(NamedTuple):
    """A controller: its open lines, what it is, and its first reports.

    Args:
        turn: how the fast reports state attitudes, see `read_pose`.
    """

    control: ControlLine
    slow_line: ReportLine
    fast_line: ReportLine
    identity: Identity
    slow: SlowReport
    fast: FastReport
    turn: str

    @property
    def flange(self) -> Pose:
        """Where the controller has its flange."""
        return remove_tool(read_pose(self.fast.tool, self.turn), self.slow.offset)

    def close(self) -> None:
        """Lets go of all of them."""
        for line in (self.control, self.slow_line, self.fast_line):
            line.close()


def reach(cell: Cell) -> Reached:
    """Asks the controller what it is, and lets its reports come. Nothing moves.

    Raises:
        NotConnected: it cannot be reached, or does not say what is needed.
        WrongRobot: it is another model, arm or version; the fast reports are asked for only where it has them.
    """
    link = link_of(cell)
    opened: list[ControlLine | ReportLine] = []
    try:
        control = ControlLine(link.host, link.port)
        opened.append(control)
        identity = _read_identity(control)
        check_identity(cell, _controller(identity), supported=SUPPORTED, least=LEAST)
        slow_line = ReportLine(link.host, SLOW_PORT, SLOW_LEAST)
        opened.append(slow_line)
        slow = read_slow(_first(slow_line), identity.axes)
        fast_line = ReportLine(link.host, FAST_PORT, FAST_LEAST)
        opened.append(fast_line)
        fast = read_fast(_first(fast_line), identity.axes)
        return Reached(control, slow_line, fast_line, identity, slow, fast, _find_turn(control, fast))
    except OSError as error:
        _close(opened)
        raise NotConnected("session-not-reached", host=link.host, reason=str(error)[:120]) from error
    except BaseException:
        _close(opened)
        raise


def check_arm(cell: Cell, robot: RobotModel, reached: Reached) -> None:
    """Nothing where the controller is that of the cell's robot: what `check_controller` checks, at the limits that it says it keeps, and
    its forward kinematics at configurations all over the range, where no order and no sign of a joint stays hidden.

    Raises:
        WrongRobot: it is not.
        NotConnected: it does not answer.
    """
    identity, slow = reached.identity, reached.slow
    try:
        position, rotation = reached.flange
        lower = upper = None
        if identity.axes == robot.n:  # kinematics first: another order of the joints has other limits, too
            kinematics = Kinematics(cell, robot)
            kinematics.check(reached.fast.q, position, rotation)
            _check_forward(kinematics, robot, reached)
            lower, upper = _find_limits(reached, robot)
        speed = np.full(identity.axes, slow.joint_speed)
        said = _controller(identity)
        said = Controller(said.model, said.serial, said.firmware, reached.fast.q, position, rotation, lower, upper, speed)
        check_controller(cell, robot, said, supported=SUPPORTED, least=LEAST)
    except OSError as error:
        raise NotConnected("session-not-reached", host=link_of(cell).host, reason=str(error)[:120]) from error
    limit = cell.robot.payload_limit_kg
    if limit is not None and slow.payload[0] > limit:
        raise WrongRobot("session-payload-beyond-limit", found=slow.payload[0], expected=limit)


def check_rate(cell: Cell, reached: Reached, patience_s: float) -> None:
    """The controller reports as often as the cell says.

    Args:
        patience_s: how long a report may take, s.

    Raises:
        NotConnected: it does not; it reports 200 times a second with a force/torque sensor, 250 times without.
    """
    link, stamps = link_of(cell), list[float]()
    try:
        while len(stamps) < 10:
            found = reached.fast_line.receive(patience_s)
            if not found:
                raise TimeoutError("no report")
            stamps += [read_fast(each, reached.identity.axes).t for each in found]
    except OSError as error:
        raise NotConnected("session-not-reached", host=link.host, reason=str(error)[:120]) from error
    found_s, period = float(np.median(np.diff(stamps))), 1.0 / link.rate_hz
    if abs(found_s - period) > 0.1 * period:
        raise NotConnected("xarm-rate", host=link.host, found_s=found_s, expected_s=period)


def link_of(cell: Cell) -> XarmRobot:
    """What the cell says of the line."""
    assert isinstance(cell.session, XarmRobot)
    return cell.session


def _close(lines: list[ControlLine | ReportLine]) -> None:
    for line in lines:
        line.close()


def _first(line: ReportLine) -> bytes:
    found = line.receive(FIRST_S)
    if not found:
        raise TimeoutError("no report")
    return found[-1]


def _read_identity(control: ControlLine) -> Identity:
    told = _text(control.ask(VERSION).data)
    found = _VERSION.match(told)
    if found is None:
        raise ConnectionError(f"a version that reads '{told[:60]}'")
    axes, kind = int(found[1]), int(found[2])
    if not 1 <= axes <= SLOTS:
        raise ConnectionError(f"{axes} axes")
    model = MODELS.get((axes, kind), f"xArm{axes} type {kind}")
    return Identity(axes, model, _text(control.ask(SERIAL).data), found[5])


def _text(data: bytes) -> str:
    return data.split(b"\0")[0].decode("ascii", "replace").strip()


def _controller(identity: Identity) -> Controller:
    """Its kinematics are not looked at yet."""
    nowhere = np.zeros(3)
    return Controller(identity.model, identity.serial, identity.version, np.zeros(identity.axes), nowhere, np.eye(3))


def _find_turn(control: ControlLine, fast: FastReport) -> str:
    """The maker names the three angles of the fast report rx ry rz and does not say what they are; those of the control port are roll,
    pitch and yaw, by its manual. They are a rotation vector, unless only the other reading agrees with it."""
    _, told = _read_told(control.ask(GET_POSE).floats(6))
    fits = {turn: _angle(read_pose(fast.tool, turn)[1], told) < ANGLE_RAD for turn in ("vector", "xyz")}
    return "xyz" if fits["xyz"] and not fits["vector"] else "vector"


def _read_told(numbers: tuple[float, ...]) -> Pose:
    """A pose as the control port tells it."""
    return read_pose(np.array(numbers) * np.repeat([METRE, 1.0], 3), "xyz")


def _angle(first: Array, second: Array) -> float:
    return float(np.arccos(np.clip(0.5 * (np.trace(first.T @ second) - 1.0), -1.0, 1.0)))


def _fill(q: Array) -> bytes:
    """Joint positions as a request has them."""
    return pack_floats(*q, *[0.0] * (SLOTS - q.size))


def _find_limits(reached: Reached, robot: RobotModel) -> tuple[Array, Array]:
    """The joint limits that the controller keeps, (n,) each, rad, as far as the cell needs them: it is asked whether it goes to the cell's,
    and where it does not, how far it goes. In the reduced mode those of that mode count, too.

    Raises:
        OSError: it does not answer.
    """
    found = []
    for limits, sign in ((robot.lower, 1.0), (robot.upper, -1.0)):
        theirs = limits.copy()
        for j in range(robot.n):
            theirs[j] = _find_limit(reached, j, float(limits[j]) + sign * INSIDE_RAD, float(limits[j]))
        found.append(theirs)
    slow = reached.slow
    lower, upper = found
    if slow.lower is not None and slow.upper is not None:
        lower, upper = np.maximum(lower, slow.lower), np.minimum(upper, slow.upper)
    return lower, upper


def _find_limit(reached: Reached, j: int, asked: float, limit: float) -> float:
    """The cell's limit where the controller goes there, else the farthest that it goes to, rad."""
    if not _is_beyond(reached, j, asked):
        return limit
    inside, outside = float(reached.fast.q[j]), asked
    while abs(outside - inside) > INSIDE_RAD:
        middle = 0.5 * (inside + outside)
        if _is_beyond(reached, j, middle):
            outside = middle
        else:
            inside = middle
    return inside


def _is_beyond(reached: Reached, j: int, angle: float) -> bool:
    """Whether the controller would not go to this angle of one joint, the others staying where they are."""
    q = reached.fast.q.copy()
    q[j] = angle
    data = reached.control.ask(IS_BEYOND, _fill(q)).data
    if not data:
        raise ConnectionError(f"register {IS_BEYOND}: no answer")
    return bool(data[0])


def _check_forward(kinematics: Kinematics, robot: RobotModel, reached: Reached) -> None:
    """The controller's forward kinematics against the cell's. Whatever tool they have at their end, it is the same at every configuration:
    it is taken from that at which the arm stands.

    Raises:
        WrongRobot: they differ.
    """
    position, rotation = reached.flange
    here = _forward(reached.control, reached.fast.q)
    to_flange = here[1].T @ (position - here[0]), here[1].T @ rotation
    middle, half = 0.5 * (robot.lower + robot.upper), 0.5 * (robot.upper - robot.lower)
    for share in np.random.default_rng(0).uniform(-MIDDLE, MIDDLE, (CONFIGURATIONS, robot.n)):
        q = middle + share * half
        at, turned = _forward(reached.control, q)
        kinematics.check(q, at + turned @ to_flange[0], turned @ to_flange[1])


def _forward(control: ControlLine, q: Array) -> Pose:
    return _read_told(control.ask(FORWARD, _fill(q)).floats(6))
