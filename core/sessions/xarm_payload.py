"""The payload that a UFACTORY controller is set to: read, written and read back. Nothing moves.

By the maker's published client setting it is a command that waits in the queue of motions, so the controller is made ready for motion for
it where it was stopped; the queue is empty by then.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np

from core.cell.cell import Cell
from core.errors import NotConnected, PayloadNotTaken
from core.robot.model import RobotModel
from core.sessions.set_payload import STANDING_S, SetPayload, await_taken, check_standing
from core.sessions.xarm_connection import Reached, check_arm, link_of, reach
from core.sessions.xarm_line import SET_LOAD, SET_MODE, SET_STATE, pack_floats
from core.sessions.xarm_readiness import GO, POSITION, READY, RESET, STOPPED, check_ready
from core.sessions.xarm_reports import METRE, FastReport, SlowReport, read_fast, read_slow

LINK_S = 1.0
"""Without a report for this long the line counts as lost."""
SLOW_RAD_S = 1e-4
"""The commanded speed of an arm that stands is below this."""


def read_payload(cell: Cell) -> SetPayload:
    """What the controller of the cell's robot is set to.

    Raises:
        NotConnected: it cannot be reached, or could not be written as it is; see `write_payload`.
        WrongRobot: it is that of another robot.
        BadCell, BadRobot: the cell does not say enough of it.
    """
    with _standing(cell) as reached:
        return _payload_of(reached.slow)


def write_payload(cell: Cell, wanted: SetPayload, *, before: SetPayload) -> SetPayload:
    """Sets the payload and gives what the controller has then. It has it until it is switched off.

    Args:
        before: what whoever accepted has seen as the present one.

    Raises:
        NotConnected: it cannot be reached; it has an error, its motors are off; it moves, or something else moves it; or it has another
            payload than `before`. Nothing was written.
        WrongRobot: it is that of another robot. Nothing was written.
        PayloadNotTaken: what is read back is not what was sent.
    """
    host = link_of(cell).host
    with _standing(cell) as reached:
        if before.differing(_payload_of(reached.slow)):
            raise NotConnected("session-payload-set-meanwhile", host=host)
        try:
            with _made_ready(reached):
                reached.control.ask(SET_LOAD, pack_floats(wanted.mass_kg, *(value / METRE for value in wanted.com_m)))
                return await_taken(lambda: _receive(reached), wanted, host)
        except OSError as error:
            raise PayloadNotTaken("session-payload-unknown", host=host, reason=str(error)[:120]) from error


@contextmanager
def _standing(cell: Cell) -> Iterator[Reached]:
    """The lines to the controller of a robot that is the cell's, stands, and may be written."""
    host, robot = link_of(cell).host, RobotModel.of_cell(cell)
    reached = reach(cell)
    try:
        check_arm(cell, robot, reached)
        check_ready(reached.slow, host)
        try:
            _check_standing(_watch(reached), host)
        except OSError as error:
            raise NotConnected("session-not-reached", host=host, reason=str(error)[:120]) from error
        yield reached
    finally:
        reached.close()


@contextmanager
def _made_ready(reached: Reached) -> Iterator[None]:
    """A controller that was stopped takes commands meanwhile, and is stopped again."""
    stopped = reached.fast.state in {STOPPED, RESET}
    if stopped:
        reached.control.ask(SET_MODE, bytes([POSITION, 0]))
        reached.control.ask(SET_STATE, bytes([GO]))
    try:
        yield
    finally:
        if stopped:
            reached.control.ask(SET_STATE, bytes([STOPPED]))


def _watch(reached: Reached) -> list[FastReport]:
    """The samples of `STANDING_S`.

    Raises:
        OSError: none comes any more.
    """
    samples: list[FastReport] = []
    while not samples or samples[-1].t - samples[0].t < STANDING_S:
        found = reached.fast_line.receive(LINK_S)
        if not found:
            raise TimeoutError("no report")
        samples += [read_fast(each, reached.identity.axes) for each in found]
    return samples


def _check_standing(samples: list[FastReport], host: str) -> None:
    check_standing(np.array([sample.q for sample in samples]), np.array([sample.target_dq for sample in samples]), SLOW_RAD_S, host)
    for sample in samples:
        at_rest = sample.state in {STOPPED, RESET} or (sample.state == READY and sample.mode == POSITION)
        if sample.queued or not at_rest:
            raise NotConnected("session-payload-program-runs", host=host)


def _payload_of(slow: SlowReport) -> SetPayload:
    mass, *com = slow.payload
    return SetPayload(mass, tuple(com))


def _receive(reached: Reached) -> SetPayload:
    """What the next report says of it.

    Raises:
        OSError: no report comes any more.
    """
    reports = reached.slow_line.receive(LINK_S)
    if not reports:
        raise TimeoutError("no report")
    return _payload_of(read_slow(reports[-1], reached.identity.axes))
