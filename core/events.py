"""What happens during a run, one frozen model per event. The command line prints them; a server can store and broadcast them."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import closing
from typing import Literal, TypeVar

from pydantic import BaseModel, ConfigDict, Field

from core.errors import Lateness
from core.words.message import Message

Told = TypeVar("Told")
Answer = TypeVar("Answer")


class Event(BaseModel):
    """Something that happened; `kind` tells which."""

    model_config = ConfigDict(frozen=True)


class StartConfigurationFound(Event):
    """Algorithm 6 found where a pose or a rotation starts."""

    kind: Literal["start_configuration_found"] = Field(default="start_configuration_found", description="Tells which event it is.")
    axis: str = Field(
        description="Sensor axis and its sign: `x+` lies along gravity, `x-` against it; `free` where none does.", examples=["x+"]
    )
    clearance_m: float = Field(description="Distance to obstacles and protected zones there, m.", examples=[0.184])
    nearest: str = Field(description="Name of the nearest obstacle or zone.", examples=["bench"])
    manipulability: float = Field(
        description="Smallest over largest singular value of the Jacobian there, without a unit.", examples=[0.12]
    )
    candidates: int = Field(description="How many configurations were tried.", examples=[240])


class TransferPlanned(Event):
    """A collision-free, timed path to a start configuration was found."""

    kind: Literal["transfer_planned"] = Field(default="transfer_planned", description="Tells which event it is.")
    axis: str = Field(description="Sensor axis and its sign at the end of the way.", examples=["x+"])
    robot_s: float = Field(description="Time of the motion, s.", examples=[3.8])
    least_margin_m: float = Field(description="Smallest distance beyond what is required, m.", examples=[0.021])


class Planned(Event):
    """The whole procedure is planned; nothing has moved yet."""

    kind: Literal["planned"] = Field(default="planned", description="Tells which event it is.")
    robot_s: float = Field(description="Time that the robot will need, s.", examples=[58.4])
    plan_s: float = Field(description="Time that planning took, s.", examples=[4.2])
    least_margin_m: float = Field(description="Smallest distance beyond what is required, along all of the plan, m.", examples=[0.013])


class PhaseStarted(Event):
    """The robot begins a step of the plan."""

    kind: Literal["phase_started"] = Field(default="phase_started", description="Tells which event it is.")
    phase: str = Field(description="What the robot does: `transfer`, `hold:x+`, `rotate:x`, `home`.", examples=["rotate:x"])
    toward: str = Field(description="Sensor axis and its sign at the end of the step, or `home`.", examples=["x+"])
    step: int = Field(description="Number of the step, from 1.", examples=[3])
    steps: int = Field(description="Steps of the plan, the way home included.", examples=[7])


class Progress(Event):
    """Some more samples were taken; `estimate_phi` is the paper's estimate so far, None where nothing is known yet."""

    kind: Literal["progress"] = "progress"
    phase: str
    done_s: float
    total_s: float
    estimate_phi: tuple[float | None, ...] | None = None


class RobotStopped(Event):
    """The robot was stopped."""

    kind: Literal["robot_stopped"] = Field(default="robot_stopped", description="Tells which event it is.")
    error: str = Field(description="Name of the error that stopped it.", examples=["TooClose"])
    message: Message = Field(description="Why it was stopped.")
    restart: int = Field(description="How often the guard has stopped this run so far.", examples=[1])
    final: bool = Field(description="The run does not go on.")
    held: bool = Field(
        default=False,
        description="It keeps its place until it is told to go on, along the same plan; otherwise the rest is planned anew unless `final`.",
    )
    lateness: Lateness | None = Field(default=None, description="What was late, where that stopped it.")


class StepFinished(Event):
    """A step of the plan is done: its hold and its rotation are recorded."""

    kind: Literal["step_finished"] = Field(default="step_finished", description="Tells which event it is.")
    step: int = Field(description="Number of the step whose hold and rotation are recorded, from 1.", examples=[3])
    steps: int = Field(description="Steps of the plan, the way home included.", examples=[7])


class TargetReached(Event):
    """The payload is known as exactly as was asked for: holds and rotations that are left are left out, and the robot goes home."""

    kind: Literal["target_reached"] = Field(default="target_reached", description="Tells which event it is.")
    made: int = Field(description="Holds and rotations that are recorded.", examples=[6])
    message: Message = Field(description="The same in words.")


class RecordingWritten(Event):
    """The samples are on disk; also after an interruption."""

    kind: Literal["recording_written"] = Field(default="recording_written", description="Tells which event it is.")
    folder: str = Field(
        description="Folder of the recording on the service's disk.", examples=["data/recordings/019ab1c2d3e44f1c2a9be7/recording"]
    )
    samples: int = Field(description="How many samples it has.", examples=[28400])


class Finished(Event):
    """The end of a run that came through."""

    kind: Literal["finished"] = Field(default="finished", description="Tells which event it is.")
    verdict: Message = Field(description="What the run found, in a sentence.")


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
