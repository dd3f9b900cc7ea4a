"""The PackML state machine (ISA-TR88.00.02) as pure data, and the ISA-95 job state that stands beside it.

A run goes through it once: it is made in Resetting (queued, then planned), waits in Idle for its release, which is the command
`start`, and ends in Complete, Stopped or Aborted. Suspended is a stop by the guard, after which the rest is planned anew; Held is one
that a person asked for. Aborted is left only by an explicit `clear`.
"""

from __future__ import annotations

from enum import StrEnum


class State(StrEnum):
    """The seventeen states."""

    STOPPED = "Stopped"
    RESETTING = "Resetting"
    IDLE = "Idle"
    STARTING = "Starting"
    EXECUTE = "Execute"
    COMPLETING = "Completing"
    COMPLETE = "Complete"
    ABORTING = "Aborting"
    ABORTED = "Aborted"
    CLEARING = "Clearing"
    STOPPING = "Stopping"
    SUSPENDING = "Suspending"
    SUSPENDED = "Suspended"
    UNSUSPENDING = "Unsuspending"
    HOLDING = "Holding"
    HELD = "Held"
    UNHOLDING = "Unholding"


class Command(StrEnum):
    """What may be asked of the machine. `suspend` and `unsuspend` are given by the guard, not by a person."""

    RESET = "reset"
    START = "start"
    HOLD = "hold"
    UNHOLD = "unhold"
    SUSPEND = "suspend"
    UNSUSPEND = "unsuspend"
    STOP = "stop"
    ABORT = "abort"
    CLEAR = "clear"


class JobState(StrEnum):
    """The same run as the MES sees it (ISA-95 job control, OPC 10031-4)."""

    NOT_ALLOWED_TO_START = "NotAllowedToStart"
    ALLOWED_TO_START = "AllowedToStart"
    RUNNING = "Running"
    INTERRUPTED = "Interrupted"
    ENDED = "Ended"
    ABORTED = "Aborted"


class RunOutcome(StrEnum):
    """How a run ended, which `Stopped` and `Aborted` alone do not tell."""

    COMPLETED = "completed"
    """Came through; it has a result."""
    CANCELLED = "cancelled"
    """Taken back before it was released; nothing has moved."""
    REFUSED = "refused"
    """Planning or the service refused it before it was released; nothing has moved."""
    STOPPED = "stopped"
    """Somebody stopped it, or nobody came back to it on hold."""
    ABORTED = "aborted"
    """It failed, or somebody aborted it."""


S, C = State, Command

ABORT_STATES = frozenset({S.ABORTING, S.ABORTED})
STOP_STATES = frozenset({S.STOPPING, S.STOPPED, S.CLEARING}) | ABORT_STATES

COMMANDED: dict[tuple[State, Command], State] = {
    (S.STOPPED, C.RESET): S.RESETTING,
    (S.COMPLETE, C.RESET): S.RESETTING,
    (S.IDLE, C.START): S.STARTING,
    (S.EXECUTE, C.HOLD): S.HOLDING,
    (S.HELD, C.UNHOLD): S.UNHOLDING,
    (S.EXECUTE, C.SUSPEND): S.SUSPENDING,
    (S.SUSPENDED, C.UNSUSPEND): S.UNSUSPENDING,
    (S.ABORTED, C.CLEAR): S.CLEARING,
    **{(state, C.STOP): S.STOPPING for state in S if state not in STOP_STATES},
    **{(state, C.ABORT): S.ABORTING for state in S if state not in ABORT_STATES},
}
"""Where a command leads; what is not here is illegal."""

COMPLETED: dict[State, State] = {
    S.RESETTING: S.IDLE,
    S.STARTING: S.EXECUTE,
    S.EXECUTE: S.COMPLETING,
    S.COMPLETING: S.COMPLETE,
    S.HOLDING: S.HELD,
    S.UNHOLDING: S.EXECUTE,
    S.SUSPENDING: S.SUSPENDED,
    S.UNSUSPENDING: S.EXECUTE,
    S.STOPPING: S.STOPPED,
    S.ABORTING: S.ABORTED,
    S.CLEARING: S.STOPPED,
}
"""Where an acting state leads once it has done what it does."""

FINAL = frozenset({S.COMPLETE, S.STOPPED})
"""A run that is here has let go of its cell."""

MOVING = frozenset(
    {S.STARTING, S.EXECUTE, S.HOLDING, S.UNHOLDING, S.SUSPENDING, S.SUSPENDED, S.UNSUSPENDING, S.STOPPING, S.ABORTING}
)  # fmt: skip
"""The robot may move; somebody must be in control."""


class IllegalCommandError(ValueError):
    """A command that the state does not allow.

    Args:
        state: the machine's.
        command: what was asked.
        legal: what might have been.
    """

    def __init__(self, state: State, command: Command, legal: tuple[Command, ...]) -> None:
        names = ", ".join(legal) or "none"
        super().__init__(f"{command} is not possible in {state}; legal commands here: {names}.")
        self.state, self.command, self.legal = state, command, legal


def legal_commands(state: State) -> tuple[Command, ...]:
    """Commands that lead out of `state`."""
    return tuple(command for command in Command if (state, command) in COMMANDED)


def apply_command(state: State, command: Command) -> State:
    """The state that follows a command.

    Raises:
        IllegalCommandError: naming the legal ones.
    """
    if (state, command) not in COMMANDED:
        raise IllegalCommandError(state, command, legal_commands(state))
    return COMMANDED[state, command]


def job_state(state: State, *, released: bool, aborted: bool) -> JobState:
    """The ISA-95 state of the job: Ended where it came through, Aborted where it did not, whoever wanted that (`RunOutcome` says).

    Args:
        released: whether an operator has let it begin.
        aborted: whether it has been through Aborted; clearing the machine does not mend the job.
    """
    if aborted or state in ABORT_STATES or state is S.STOPPED:
        return JobState.ABORTED
    if state is S.COMPLETE:
        return JobState.ENDED
    if state in (S.RESETTING, S.IDLE):
        return JobState.ALLOWED_TO_START if released else JobState.NOT_ALLOWED_TO_START
    return JobState.RUNNING if state in (S.STARTING, S.EXECUTE, S.COMPLETING) else JobState.INTERRUPTED
