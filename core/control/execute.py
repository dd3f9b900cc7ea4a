"""The one control loop, the same for a simulated, a replayed and a real session."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from core.control.guard import Guard
from core.control.movers import Mover
from core.errors import Stopped
from core.sessions.session import RobotSession, RobotState


class Batch(NamedTuple):
    """Samples of one phase in the order of time."""

    phase: str
    states: list[RobotState]


def execute(session: RobotSession, guard: Guard, mover: Mover, phase: str, *, batch: int = 50) -> Iterator[Batch]:
    """Moves the robot until the mover has ended; every command is checked by the guard before it goes out.

    Whatever ends it early stops the robot: an error of the guard, of the session or of the mover, an interrupt, or a
    consumer that closes the generator. After a `Stopped` the samples up to the stop are still yielded, then the error
    is raised; `session.release()` allows commands again.

    Args:
        session: entered.
        guard: of the same cell.
        mover: what to do; used up.
        phase: name in the recording: `transfer`, `hold:x+`, `rotate:x`.
        batch: number of samples after which they are handed over.

    Raises:
        Stopped: the guard, the mover or the session stopped the robot.
    """
    if not mover.period == guard.period == session.period:
        raise ValueError(f"periods differ: mover {mover.period} s, guard {guard.period} s, session {session.period} s")
    states: list[RobotState] = []
    guard.begin()
    try:
        while True:
            state = session.state()
            states.append(state)
            target = mover.next(state)
            guard.check(state, state.q_cmd if target is None else target)
            if target is None:
                break
            session.command(target)
            if len(states) >= batch:
                full, states = states, []
                yield Batch(phase, full)
    except Stopped:
        session.stop()
        if states:
            yield Batch(phase, states)
        raise
    except BaseException:  # an interrupt, or the consumer has gone
        session.stop()
        raise
    yield Batch(phase, states)
