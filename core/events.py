"""What happens during a run, one frozen model per event. The command line prints them; a server can store and broadcast them."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import closing
from typing import Literal, TypeVar

from pydantic import BaseModel, ConfigDict

from core.errors import Lateness
from core.words.message import Message

Told = TypeVar("Told")
Answer = TypeVar("Answer")


class Event(BaseModel):
    """Something that happened; `kind` tells which."""

    model_config = ConfigDict(frozen=True)


class StartConfigurationFound(Event):
    """Algorithm 6 found where a pose or a rotation starts."""

    kind: Literal["start_configuration_found"] = "start_configuration_found"
    axis: str
    clearance_m: float
    nearest: str
    manipulability: float
    candidates: int


class TransferPlanned(Event):
    """A collision-free, timed path to a start configuration was found."""

    kind: Literal["transfer_planned"] = "transfer_planned"
    axis: str
    robot_s: float
    least_margin_m: float


class Planned(Event):
    """The whole procedure is planned; nothing has moved yet."""

    kind: Literal["planned"] = "planned"
    robot_s: float
    plan_s: float
    least_margin_m: float


class PhaseStarted(Event):
    """The robot begins a step of the plan."""

    kind: Literal["phase_started"] = "phase_started"
    phase: str
    toward: str
    step: int
    steps: int


class Progress(Event):
    """Some more samples were taken; `estimate_phi` is the paper's estimate so far, None where nothing is known yet."""

    kind: Literal["progress"] = "progress"
    phase: str
    done_s: float
    total_s: float
    estimate_phi: tuple[float | None, ...] | None = None


class RobotStopped(Event):
    """The robot was stopped.

    Args:
        held: it keeps its place until it is told to go on, and goes on along the same plan. Otherwise the procedure goes on from a new
            start configuration unless `final`.
        lateness: what was late, where that stopped it.
    """

    kind: Literal["robot_stopped"] = "robot_stopped"
    error: str
    message: Message
    restart: int
    final: bool
    held: bool = False
    lateness: Lateness | None = None


class StepFinished(Event):
    """A step of the plan is done: its hold and its rotation are recorded."""

    kind: Literal["step_finished"] = "step_finished"
    step: int
    steps: int


class RecordingWritten(Event):
    """The samples are on disk; also after an interruption."""

    kind: Literal["recording_written"] = "recording_written"
    folder: str
    samples: int


class Finished(Event):
    """The end of a run that came through."""

    kind: Literal["finished"] = "finished"
    verdict: Message


def drive(run: Generator[Told, None, Answer], tell: Callable[[Told], object] | None = None) -> Answer:
    """Runs a generator of events to its end and returns what it returns. However this ends, the run is closed: its robot stands.

    Args:
        tell: is told each event as it comes. The run rests meanwhile: whoever is told may wait, or throw something into it.

    Raises:
        HeftError: whatever the run raises.
    """
    with closing(run):
        while True:
            try:
                event = next(run)
            except StopIteration as end:
                answer: Answer = end.value
                return answer
            if tell is not None:
                tell(event)
