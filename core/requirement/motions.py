"""Motions for which a payload has to be known well enough: a program's, or as brisk ones as the cell's limits allow."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.errors import BadInput

if TYPE_CHECKING:  # who only reads requirements waits for no robot
    from core.robot.model import RobotModel

PERIOD_S = 0.005
"""Short against every motion of an arm."""
MOVES = 60
BRISK_ROWS = 12_000
"""Of all brisk moves together; 200 for each find a peak within 1 %, and a slow arm keeps nobody waiting."""
MAX_ROWS = 2_000_000


@dataclass(frozen=True)
class JointMotion:
    """Joint positions and their derivatives at a constant period, at rest before.

    Args:
        period_s: from one row to the next.
        q, dq, ddq: (N, n), rad, rad/s, rad/s2.
        stated: whether somebody has named it; made up of brisk moves otherwise.
    """

    period_s: float
    q: Array
    dq: Array
    ddq: Array
    stated: bool = False

    @property
    def duration_s(self) -> float:
        """From the first row to the last."""
        return self.period_s * (len(self.q) - 1)


def make_brisk_motion(cell: Cell, robot: RobotModel, *, moves: int = MOVES, seed: int = 0) -> JointMotion:
    """Moves between random configurations, each as fast as one joint's largest speed and acceleration allow (minimum-jerk profiles).

    Nothing is asked about collisions: it bounds what a program may do, it is no program.
    """
    rng = np.random.default_rng(seed)
    corners = rng.uniform(robot.lower, robot.upper, (moves + 1, robot.n))
    corners[0] = cell.robot.home_rad
    stated = cell.robot.velocity_rad_s
    fastest, hardest = robot.velocity if stated is None else np.array(stated), np.array(cell.robot.acceleration_rad_s2)
    durations = [_least_duration(end - start, fastest, hardest) for start, end in pairwise(corners)]
    period = max(PERIOD_S, sum(durations) / BRISK_ROWS)
    parts = [_move(*pair, duration, period) for pair, duration in zip(pairwise(corners), durations, strict=True)]
    q, dq, ddq = (np.concatenate(each) for each in zip(*parts, strict=True))
    return JointMotion(period, q, dq, ddq)


def _least_duration(way: Array, fastest: Array, hardest: Array) -> float:
    """Minimum jerk (Flash and Hogan 1985): peak speed 15/8 of the mean, peak acceleration 10/sqrt(3) of way over time squared."""
    return max(float((1.875 * np.abs(way) / fastest).max()), float(np.sqrt((10.0 / np.sqrt(3.0)) * np.abs(way) / hardest).max()))


def _move(start: Array, end: Array, duration: float, period: float) -> tuple[Array, Array, Array]:
    """Such a move in whole periods."""
    way = end - start
    steps = max(int(np.ceil(duration / period)), 2)
    s = np.linspace(0.0, 1.0, steps, endpoint=False)[:, None]
    duration = steps * period
    shape = 10.0 * s**3 - 15.0 * s**4 + 6.0 * s**5
    rate = (30.0 * s**2 - 60.0 * s**3 + 30.0 * s**4) / duration
    change = (60.0 * s - 180.0 * s**2 + 120.0 * s**3) / duration**2
    return start + way * shape, way * rate, way * change


def read_program(path: Path, robot: RobotModel) -> JointMotion:
    """A program's path: a CSV file with a header, the time in s and the joint positions in rad, in that order.

    Between its rows the joints follow a cubic spline that rests at both ends.

    Raises:
        BadInput: the file cannot be read, a row is no number, times do not rise, or a joint is beyond its limits.
    """
    table = _read_table(path, 1 + robot.n)
    t, rows = table[:, 0], table[:, 1:]
    if not (np.diff(t) > 0).all():
        late = int(np.argmin(np.diff(t) > 0)) + 1
        raise BadInput(f"{path}: {late + 2}", "requirement-time-stands", before_s=float(t[late - 1]), time_s=float(t[late]))
    beyond = (rows < robot.lower) | (rows > robot.upper)
    if beyond.any():
        row, joint = (int(k) for k in np.argwhere(beyond)[0])
        raise BadInput(
            f"{path}: {row + 2}", "requirement-beyond-limits", joint=joint + 1, value_rad=float(rows[row, joint]),
            lower_rad=float(robot.lower[joint]), upper_rad=float(robot.upper[joint]),
        )  # fmt: skip
    count = int((t[-1] - t[0]) / PERIOD_S) + 1
    if count > MAX_ROWS:
        raise BadInput(str(path), "requirement-too-long", duration_s=float(t[-1] - t[0]), limit_s=MAX_ROWS * PERIOD_S)
    from scipy.interpolate import CubicSpline  # noqa: PLC0415 - the service knows what a requirement is, and starts without SciPy

    spline = CubicSpline(t, rows, bc_type="clamped")
    at = t[0] + PERIOD_S * np.arange(count)
    return JointMotion(PERIOD_S, spline(at), spline(at, 1), spline(at, 2), stated=True)


def _read_table(path: Path, columns: int) -> Array:
    """(N, columns), at least two rows."""
    try:
        with path.open(newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise BadInput(str(path), "requirement-unreadable", reason=type(error).__name__) from error
    found = []
    for number, row in enumerate(rows[1:], start=2):
        try:
            values = [float(cell) for cell in row]
        except ValueError as error:
            raise BadInput(f"{path}: {number}", "requirement-no-numbers", columns=columns) from error
        if len(values) != columns or not np.isfinite(values).all():
            raise BadInput(f"{path}: {number}", "requirement-no-numbers", columns=columns)
        found.append(values)
    if len(found) < 2:
        raise BadInput(str(path), "requirement-no-rows", columns=columns)
    return np.array(found)
