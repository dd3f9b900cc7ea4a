"""Where a run goes when something happens to it: pure functions from a state to the steps that follow."""

from __future__ import annotations

from collections.abc import Callable

from core.errors import HoldExpired
from core.events import Event, PhaseStarted, RobotStopped
from server.runner.live_schemas import WaitingForZone
from server.runs.ledger import Step
from server.runs.packml import Command, State

DONE: Step = None


def from_states(*states: State) -> Callable[[State], list[Step]]:
    """These states are completed; no other is left."""
    return lambda state: [DONE] if state in states else []


def update_in_the_way(event: Event, before: str | None) -> str | None:
    """What is in the way of a run once this has happened to it, and what was before."""
    match event:
        case WaitingForZone():
            return event.in_the_way
        case PhaseStarted():
            return None
    return before


def after(event: Event, state: State) -> list[Step]:
    """Where an event of the procedure leads."""
    match event:
        case PhaseStarted():
            return {State.STARTING: [DONE], State.UNHOLDING: [DONE], State.SUSPENDED: [Command.UNSUSPEND, DONE]}.get(state, [])
        case RobotStopped(final=True, error=error):
            ended = Command.STOP if error == HoldExpired.__name__ else Command.ABORT
            return [] if state in (State.STOPPING, State.ABORTING) else [ended]
        case RobotStopped(held=True):
            return [DONE] if state is State.HOLDING else _from_motion(state, Command.HOLD)
        case RobotStopped():
            return _from_motion(state, Command.SUSPEND)
    return []


def _from_motion(state: State, command: Command) -> list[Step]:
    """A command that only Execute knows, and its end; on the way there that way is finished first."""
    if state is State.EXECUTE:
        return [command, DONE]
    return [DONE, command, DONE] if state in (State.STARTING, State.UNHOLDING) else []
