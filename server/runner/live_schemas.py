"""What the process that moves the robot tells while it does. SI; joints in the robot's order; world frame unless a name says otherwise."""

from __future__ import annotations

from typing import Literal

from core.estimation.result import Numbers
from core.events import Event
from core.words.message import Message
from server.http.schemas import Answer


class NearestPart(Answer):
    """The nearest pair of the robot and what stands around it."""

    distance_m: float
    first: str
    second: str
    point_first_m: list[float]
    point_second_m: list[float]


class LiveBatch(Answer):
    """Newest samples of a run.

    Args:
        t_s: robot's clock, one per row of `wrench`.
        wrench: rows of fx fy fz (N) tx ty tz (N m), raw, sensor frame.
        reconstructed: what the estimate so far says the last row should be; null while nothing is known.
        phi, phi_std: the estimate so far in the paper's order, with its standard uncertainty.
        q_rad: joint positions at the last row.
        progress: share of the robot time, 0 to 1; `eta_s` what is left of it by the wall clock.
    """

    kind: Literal["samples"] = "samples"
    phase: str
    t_s: list[float]
    wrench: list[list[float]]
    reconstructed: list[float] | None
    phi: Numbers
    phi_std: Numbers
    q_rad: list[float]
    nearest: NearestPart | None
    progress: float
    eta_s: float | None


class WaitingForZone(Event):
    """The robot stands, and there is no safe way on before a zone moves: `in_the_way` where planning knows it."""

    kind: Literal["waiting_for_zone"] = "waiting_for_zone"
    message: Message
    in_the_way: str | None = None
