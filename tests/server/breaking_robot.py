"""A control process whose robot breaks while it moves: how and when, the run's seed says."""

from __future__ import annotations

import dataclasses
import resource
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from types import TracebackType
from typing import Any, ClassVar
from unittest.mock import patch

import numpy as np

from core.sessions import opening
from core.sessions.session import RobotState
from core.sessions.simulated import SimulatedSession
from server.runner import control
from server.runner.messages import Order

TOLD = "told.npy"
"""Rows of time and commanded joint positions, from the breakdown on."""
FROZEN, NAN, STALE, DISK_FULL = 1, 2, 3, 4
"""The sensor repeats itself; it says nothing that is a number; the clock of the robot's state stands; the run's folder takes no more."""
PER_KIND = 1_000_000
"""Seeds of one kind: the moment of the breakdown in milliseconds."""


def seed_of(kind: int, at_s: float) -> int:
    """The seed of a run whose robot breaks in this way at this moment of its own clock."""
    return kind * PER_KIND + round(1e3 * at_s)


@dataclass(frozen=True)
class Told:
    """What an arm was told after its breakdown.

    Args:
        stop_s: until it was to stand still for good.
        dq: (n,) fastest that was commanded from then on, rad/s; its braking takes what this takes.
    """

    stop_s: float
    dq: np.ndarray


def told(folder: Path) -> Told | None:
    """Of the run whose folder it is; it has to stand in the end. None where something else ended the run before."""
    rows = np.load(folder / TOLD)
    if not len(rows):
        return None
    t, *q = rows.T
    dq = np.diff(np.array(q).T, axis=0) / np.diff(t)[:, None]
    moving = np.flatnonzero((dq != 0.0).any(axis=1))
    assert len(dq) - 1 not in moving, "it stands in the end"
    return Told(float(t[moving[-1] + 1] - t[0]) if len(moving) else 0.0, np.abs(dq).max(axis=0))


class BreakingSession(SimulatedSession):
    """Says the truth until it breaks; what the arm was truly told from then on is left in `folder`."""

    folder: ClassVar[Path]

    def __init__(self, *arguments: Any, seed: int, **options: Any) -> None:
        super().__init__(*arguments, seed=seed, **options)
        self._kind, at_ms = divmod(seed, PER_KIND)
        self._breaks_at_s = at_ms / 1e3
        self._last: RobotState | None = None
        self._told: list[np.ndarray] = []

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        super().__exit__(kind, error, traceback)
        _limit_files(resource.RLIM_INFINITY)
        np.save(self.folder / TOLD, np.array(self._told))

    def state(self) -> RobotState:
        true = super().state()
        if true.t < self._breaks_at_s or not self._kind:
            self._last = true
            return true
        if not self._told and self._kind == DISK_FULL:
            _limit_files(1)
        self._told.append(np.array([true.t, *true.q_cmd]))
        return self._broken(true, self._last or true)

    def _broken(self, true: RobotState, last: RobotState) -> RobotState:
        if self._kind == FROZEN:
            return dataclasses.replace(true, wrench=last.wrench)
        if self._kind == NAN:
            return dataclasses.replace(true, wrench=np.full(6, np.nan))
        if self._kind == STALE:
            return dataclasses.replace(true, t=last.t)
        return true


def _limit_files(most_bytes: int) -> None:
    """No file of this process grows beyond it from now on."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (most_bytes, resource.RLIM_INFINITY))


def main(order: Order, connection: Connection) -> None:
    """As `server.runner.control.main`."""
    BreakingSession.folder = order.folder
    with patch.object(opening, "SimulatedSession", BreakingSession):
        control.main(order, connection)
