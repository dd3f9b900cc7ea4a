"""The payload that a Universal Robots controller is set to: read, written and read back. Nothing moves.

It is written by a secondary program, which runs beside the one that is loaded and takes no time of the robot's.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np

from core.cell.cell import Cell
from core.cell.session import UniversalRobot
from core.errors import NotConnected, PayloadNotTaken
from core.robot.model import RobotModel
from core.sessions.rtde import Rtde, RtdeError, Value
from core.sessions.set_payload import STANDING_S, SetPayload, await_taken, check_standing, write_urscript
from core.sessions.ur_connection import check_arm, reach
from core.sessions.ur_controller import STOPPED, Secondary
from core.sessions.ur_readiness import check_ready
from core.sessions.ur_servo import read_number, read_vector

RATE_HZ = 125.0
LINK_S = 1.0
"""Without a sample for this long the line counts as lost."""
SLOW_RAD_S = 1e-6
"""The commanded speed of an arm that stands is below this."""
OUTPUTS = (
    "timestamp", "actual_q", "target_qd", "actual_TCP_pose", "tcp_offset", "robot_mode", "safety_mode", "runtime_state", "speed_scaling",
    "payload", "payload_cog", "payload_inertia",
)  # fmt: skip


def read_payload(cell: Cell) -> SetPayload:
    """What the controller of the cell's robot is set to.

    Raises:
        NotConnected: it cannot be reached, or could not be written as it is; see `write_payload`.
        WrongRobot: it is that of another robot.
        BadCell, BadRobot: the cell does not say enough of it.
    """
    with _standing(cell) as (_, sample):
        return _payload_of(sample)


def write_payload(cell: Cell, wanted: SetPayload, *, before: SetPayload) -> SetPayload:
    """Sets the payload and gives what the controller has then. It zeroes its force/torque sensor by this.

    Args:
        before: what whoever accepted has seen as the present one.

    Raises:
        NotConnected: it cannot be reached; it is in local control, stopped or off; it moves, or a program runs on it; or it has another
            payload than `before`. Nothing was written.
        WrongRobot: it is that of another robot. Nothing was written.
        PayloadNotTaken: what is read back is not what was sent.
    """
    with _standing(cell) as (rtde, sample):
        host = _host_of(cell)
        if before.differing(_payload_of(sample)):
            raise NotConnected("session-payload-set-meanwhile", host=host)
        try:
            secondary = Secondary(host)
        except OSError as error:
            raise NotConnected("session-not-reached", host=host, reason=str(error)[:120]) from error
        try:
            secondary.run(f"sec heft_payload():\n  {write_urscript(wanted)}\nend\n")
            return await_taken(lambda: _report(rtde), wanted, host)
        except OSError as error:
            raise PayloadNotTaken("session-payload-unknown", host=host, reason=str(error)[:120]) from error
        finally:
            secondary.close()


@contextmanager
def _standing(cell: Cell) -> Iterator[tuple[Rtde, dict[str, Value]]]:
    """The line to the controller of a robot that is the cell's, stands, and may be written; with its newest sample."""
    host = _host_of(cell)
    robot = RobotModel.of_cell(cell)
    reached = reach(host, OUTPUTS, (), RATE_HZ)
    try:
        try:
            samples = _watch(reached.rtde)
        except (OSError, RtdeError) as error:
            raise NotConnected("session-not-reached", host=host, reason=str(error)[:120]) from error
        check_ready(samples[-1], reached.found, host, slider=False)
        _check_standing(samples, host)
        check_arm(cell, robot, reached, samples[-1])
        yield reached.rtde, samples[-1]
    finally:
        reached.rtde.close()


def _host_of(cell: Cell) -> str:
    assert isinstance(cell.session, UniversalRobot)
    return cell.session.host


def _watch(rtde: Rtde) -> list[dict[str, Value]]:
    """The samples of `STANDING_S`.

    Raises:
        OSError, RtdeError: none comes any more.
    """
    samples: list[dict[str, Value]] = []
    while not samples or read_number(samples[-1], "timestamp") - read_number(samples[0], "timestamp") < STANDING_S:
        samples += _receive(rtde)
    return samples


def _receive(rtde: Rtde) -> list[dict[str, Value]]:
    found = rtde.receive(LINK_S)
    if not found:
        raise TimeoutError("no sample")
    return found


def _check_standing(samples: list[dict[str, Value]], host: str) -> None:
    q = np.array([read_vector(sample, "actual_q") for sample in samples])
    check_standing(q, np.array([read_vector(sample, "target_qd") for sample in samples]), SLOW_RAD_S, host)
    if any(read_number(sample, "runtime_state") != STOPPED for sample in samples):
        raise NotConnected("session-payload-program-runs", host=host)


def _payload_of(sample: dict[str, Value]) -> SetPayload:
    return SetPayload(read_number(sample, "payload"), read_vector(sample, "payload_cog"), read_vector(sample, "payload_inertia"))


def _report(rtde: Rtde) -> SetPayload:
    """What the next sample says of it.

    Raises:
        OSError: no sample comes any more.
    """
    try:
        return _payload_of(_receive(rtde)[-1])
    except RtdeError as error:
        raise ConnectionError(str(error)) from error
