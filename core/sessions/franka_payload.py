"""The load that a controller of Franka is set to: read, written and read back. Nothing moves."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.errors import NotConnected, PayloadNotTaken
from core.robot.model import RobotModel
from core.sessions.franka_arm import link_of, reach
from core.sessions.franka_line import FciLine
from core.sessions.franka_messages import Command, Sample, write_load
from core.sessions.franka_readiness import check_ready
from core.sessions.set_payload import STANDING_S, SetPayload, await_taken, check_standing

LINK_S = 1.0
"""Without a state for this long the line counts as lost."""
SLOW_RAD_S = 1e-4
"""The commanded speed of an arm that stands is below this."""


def read_payload(cell: Cell) -> SetPayload:
    """What the controller of the cell's robot is set to, beside the end effector of Desk.

    Raises:
        NotConnected: it cannot be reached, or could not be written as it is; see `write_payload`.
        WrongRobot: it is that of another robot.
        BadCell, BadRobot: the cell does not say enough of it.
    """
    with _standing(cell) as (_, sample):
        return _payload_of(sample)


def write_payload(cell: Cell, wanted: SetPayload, *, before: SetPayload) -> SetPayload:
    """Sets the load (`setLoad`) and gives what the controller has then.

    Args:
        before: what whoever accepted has seen as the present one.

    Raises:
        NotConnected: it cannot be reached; it has an error, its brakes are closed; it moves, or something else moves it; it has another
            load than `before`; or it refuses. Nothing was written.
        WrongRobot: it is that of another robot. Nothing was written.
        PayloadNotTaken: what is read back is not what was sent.
    """
    host = link_of(cell).host
    with _standing(cell) as (line, sample):
        if before.differing(_payload_of(sample)):
            raise NotConnected("session-payload-set-meanwhile", host=host)
        try:
            _, answer = line.ask(Command.SET_LOAD, write_load(wanted.mass_kg, np.array(wanted.com_m), _matrix(wanted.inertia_kg_m2)))
            if answer[0] != 0:
                raise NotConnected("franka-load-refused", host=host, status=answer[0])
            return await_taken(lambda: _payload_of(_receive(line)), wanted, host)
        except OSError as error:
            raise PayloadNotTaken("session-payload-unknown", host=host, reason=str(error)[:120]) from error


@contextmanager
def _standing(cell: Cell) -> Iterator[tuple[FciLine, Sample]]:
    """The line to the controller of a robot that is the cell's, stands, and may be written; with its newest state."""
    host = link_of(cell).host
    with reach(cell, RobotModel.of_cell(cell)).line as line:
        try:
            samples = _watch(line)
        except OSError as error:
            raise NotConnected("session-not-reached", host=host, reason=str(error)[:120]) from error
        check_ready(samples[-1], host)
        check_standing(np.array([one.q for one in samples]), np.array([one.dq_d for one in samples]), SLOW_RAD_S, host)
        yield line, samples[-1]


def _watch(line: FciLine) -> list[Sample]:
    """The states of `STANDING_S`.

    Raises:
        OSError: none comes any more.
    """
    samples: list[Sample] = []
    while not samples or samples[-1].t - samples[0].t < STANDING_S:
        samples.append(_receive(line))
    return samples


def _receive(line: FciLine) -> Sample:
    sample = line.receive(LINK_S)
    if sample is None:
        raise TimeoutError("no state")
    return sample


def _payload_of(sample: Sample) -> SetPayload:
    mass, inertia, com = float(sample.load[0]), sample.load[1:10].reshape(3, 3), sample.load[10:]
    moments = [inertia[0, 0], inertia[1, 1], inertia[2, 2], inertia[0, 1], inertia[0, 2], inertia[1, 2]]
    return SetPayload(mass, tuple(com.tolist()), tuple(float(each) for each in moments))


def _matrix(inertia: tuple[float, ...]) -> Array:
    xx, yy, zz, xy, xz, yz = inertia
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
