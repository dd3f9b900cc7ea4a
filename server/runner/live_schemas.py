"""What the process that moves the robot tells while it does. SI; joints in the robot's order; world frame unless a name says otherwise."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from core.estimation.result_part import Numbers
from core.events import Event
from core.words.message import Message
from server.http.schemas import Answer


class NearestPart(Answer):
    """The nearest pair of the robot and what stands around it."""

    distance_m: float = Field(description="Their distance, m.", examples=[0.131])
    first: str = Field(description="The body of the robot.", examples=["link_5"])
    second: str = Field(description="What stands around it.", examples=["bench"])
    point_first_m: list[float] = Field(description="Nearest point of `first`, m, world frame.", examples=[[0.41, 0.02, 0.63]])
    point_second_m: list[float] = Field(description="Nearest point of `second`, m, world frame.", examples=[[0.41, 0.02, 0.5]])


class LiveBatch(Answer):
    """Newest samples of a run."""

    kind: Literal["samples"] = Field(default="samples", description="Tells which message it is.")
    phase: str = Field(description="What the robot does: `transfer`, `hold:x+`, `rotate:x`, `home`.", examples=["rotate:x"])
    t_s: list[float] = Field(
        description="Times of the samples by the robot's clock, s, one for each row of `wrench`.", examples=[[12.004, 12.006]]
    )
    wrench: list[list[float]] = Field(
        description="Rows of fx fy fz (N) tx ty tz (N m), raw, sensor frame.", examples=[[[-27.3, 0.4, 1.2, 0.01, -1.31, 0.44]]]
    )
    reconstructed: list[float] | None = Field(
        description="What the estimate so far says the last row should be, N and N m; null while nothing is known.",
        examples=[[-27.2, 0.3, 1.2, 0.01, -1.3, 0.44]],
    )
    phi: Numbers = Field(
        description="The estimate so far: mass (kg), first moment (kg m), inertia (kg m2); null is what is not known yet.",
        examples=[[2.78, 0.0, -0.047, 0.1, None, None, None, None, None, None]],
    )
    phi_std: Numbers = Field(
        description="Its standard uncertainties, in the same units.",
        examples=[[0.01, 0.001, 0.001, 0.001, None, None, None, None, None, None]],
    )
    q_rad: list[float] = Field(description="Joint positions at the last row, rad.", examples=[[0.1, 0.9, 0.0, -1.4, 0.2, 1.1, 0.0]])
    nearest: NearestPart | None = Field(description="The nearest pair of the robot and what stands around it; null where nothing does.")
    progress: float = Field(description="Share of the robot's time that is over, 0 to 1.", examples=[0.42])
    eta_s: float | None = Field(description="Time that is left by the wall clock, s; null where it is not known.", examples=[33.9])

    @property
    def newest_row(self) -> LiveBatch:
        """With the last sample alone."""
        return self.model_copy(update={"t_s": self.t_s[-1:], "wrench": self.wrench[-1:]})


class WaitingForZone(Event):
    """The robot stands, and there is no safe way on before a zone moves: `in_the_way` where planning knows it."""

    kind: Literal["waiting_for_zone"] = Field(default="waiting_for_zone", description="Tells which event it is.")
    message: Message = Field(description="Why there is no safe way on.")
    in_the_way: str | None = Field(
        default=None, description="Name of what is in the way; null where planning does not know it.", examples=["operator"]
    )
