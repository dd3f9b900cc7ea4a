"""Where a run goes when something happens to it: pure functions from a state to the steps that follow."""

from __future__ import annotations

from collections.abc import Callable

from core.events import Event, PhaseStarted, RobotStopped
from server.event_schemas import WaitingForZone
from server.packml import Command, State
from server.run_ledger import Step

DONE: Step = None


def from_states(*states: State) -> Callable[[State], list[Step]]:
    """These states are completed; no other is left."""
    return lambda state: [DONE] if state in states else []


def in_the_way(event: Event, before: str | None) -> str | None:
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
        case RobotStopped(final=True):
            return [] if state in (State.STOPPING, State.ABORTING) else [Command.ABORT]
        case RobotStopped():
            suspended: list[Step] = [Command.SUSPEND, DONE]
            begun: list[Step] = [DONE, *suspended]
            return {
                State.HOLDING: [DONE], State.EXECUTE: suspended, State.STARTING: begun, State.UNHOLDING: begun,
            }.get(state, [])  # fmt: skip
    return []
