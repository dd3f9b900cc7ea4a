"""A robot that follows every command perfectly, with a live wrench; a test may spoil its states. No dynamics: the guard's and the loop's
tests need a robot whose truth is known exactly."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import Self

import numpy as np

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.control.guard import Guard
from core.control.speed import fastest_point
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.sessions.session import RobotSession, RobotState

ROOT = Path(__file__).parents[3]
CELLS = ("lwr4_bench", "ur5e_line")
PERIOD = 0.001


@dataclass(frozen=True)
class Bench:
    cell: Cell
    robot: RobotModel
    collision: CollisionModel

    @property
    def home(self) -> np.ndarray:
        return np.array(self.cell.robot.home_rad)

    def guard(self, **options: float) -> Guard:
        return Guard(self.cell, self.robot, self.collision, period=PERIOD, **options)


@cache
def bench(name: str = "lwr4_bench") -> Bench:
    """Shared: a test that moves an obstacle takes `fresh_bench`."""
    return fresh_bench(name)


def fresh_bench(name: str = "lwr4_bench") -> Bench:
    cell = load_cell(ROOT / "cells" / name)
    robot = RobotModel.of_cell(cell)
    return Bench(cell, robot, CollisionModel(cell, robot, cell.payload_box))


@dataclass
class KinematicSession(RobotSession):
    q: np.ndarray
    spoil: Callable[[RobotState], RobotState] = lambda state: state
    period: float = PERIOD
    commands: list[np.ndarray] = field(default_factory=list)
    stops: int = 0

    def __post_init__(self) -> None:
        self.k = -1
        self.dq = np.zeros_like(self.q)
        self.target = self.q
        self.noise = np.random.default_rng(0)

    def find_start(self):
        return self.q

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def state(self) -> RobotState:
        self.k += 1
        self.q, self.dq = self.target, (self.target - self.q) / self.period
        wrench = self.noise.normal(0.0, 0.01, 6)
        return self.spoil(RobotState(self.k * self.period, self.q, self.dq, self.q, wrench))

    def command(self, q: np.ndarray) -> None:
        assert self.stops == 0, "a command after a stop"
        self.commands.append(q.copy())
        self.target = q

    def stop(self) -> None:
        self.stops += 1

    def release(self) -> None:
        self.stops = 0


def spoiled_after(seconds: float, **changes: object) -> Callable[[RobotState], RobotState]:
    """States get `changes` from a time on; a change may be a function of the state."""

    def spoil(state: RobotState) -> RobotState:
        if state.t < seconds:
            return state
        return replace(state, **{name: change(state) if callable(change) else change for name, change in changes.items()})

    return spoil


def fastest_at(it: Bench, q: np.ndarray, dq: np.ndarray) -> tuple[float, int]:
    """Speed of the fastest of the bench's points, m/s, and its number."""
    chain, points = it.robot.chain, it.collision.points
    return fastest_point(chain.placements, chain.axes, points.joint, points.local, q, dq)


def approach(name: str, seed: int) -> np.ndarray:
    """A straight line in joint space from home towards a configuration that is too close to something, at up to 0.24 m/s."""
    it = bench(name)
    rng = np.random.default_rng(seed)
    while True:
        goal = rng.uniform(np.maximum(it.home - 1.2, it.robot.lower), np.minimum(it.home + 1.2, it.robot.upper))
        if it.collision.margin(goal) < 0.0:
            break
    way = goal - it.home
    line = it.home + np.linspace(0, 1, 40)[:, None] * way
    rate = 0.24 / max(fastest_at(it, q, way)[0] for q in line)
    steps = np.minimum(np.arange(0, 1 / rate + 0.2, PERIOD) / 0.2, 1.0) * rate * PERIOD
    return it.home + np.clip(np.cumsum(steps), 0, 1)[:, None] * way
