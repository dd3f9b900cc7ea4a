"""By how much the clock of the wrench is behind that of the attitude, with its uncertainty.

The wrench of a rigid payload is linear in its ten parameters and an offset; for every shift of the motion they explain what they can.
Around the shift that leaves least one step of least squares in parameters and shift together gives the rest, and its variance is that of
the sum of the residuals' scores over blocks of half a second, which holds whatever colour the residuals have (H. White, Econometrica 48,
1980; blocks for what is correlated).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from core.array import Array, interpolate
from core.estimation.local_polynomial import derive
from core.estimation.weak_form import regressor_of
from core.recording.recording import Recording
from core.robot.model import RobotModel

GRID_S = 0.01
WINDOW = 25
"""Rows of the grid that a quadratic goes through: motion and wrench are smoothed alike."""
LARGEST_S = 0.5
MOST_S = 120.0
"""Of a long recording its beginning tells enough."""
BLOCK_S = 0.5
STEPS = 4
SEARCHED_ROWS = 200
"""Rows of the grid with which whole rows of shift are tried."""
EXPLAINED = 0.2
"""Share of the wrench's change that a payload may leave."""
MOST_STD_S = 0.05
"""Beyond it nothing can be said."""


class ClockOffset(NamedTuple):
    """s, by which the wrench is late against the attitude (negative: early), and its standard uncertainty."""

    late_s: float
    std_s: float


def estimate_clock_offset(recording: Recording) -> ClockOffset | None:
    """The offset; None where the recording cannot tell it: too short, or the motion hardly shows in the wrench."""
    end = int(np.searchsorted(recording.t, recording.t[0] + MOST_S))
    grid = np.arange(recording.t[0], recording.t[end - 1], GRID_S)
    reach = round(LARGEST_S / GRID_S) + STEPS
    rows = np.arange(WINDOW + reach, len(grid) - WINDOW - reach)
    if recording.wrench is None or len(rows) < 2 * WINDOW or len(rows) * GRID_S < 4 * BLOCK_S:
        return None
    X = _regressor_on(grid, recording, slice(0, end))
    wrench = derive(interpolate(grid, recording.t[:end], recording.wrench[:end]), WINDOW, 2)
    size = np.repeat([max(float(wrench[:, part].std(axis=0).max()), 1e-9) for part in (slice(0, 3), slice(3, 6))], 3)
    X, y = X / size[:, None], wrench / size
    some = rows[:: max(1, len(rows) // SEARCHED_ROWS)]
    shifts = np.arange(-reach + STEPS, reach - STEPS + 1)
    left = [_solve(X[some + k], y[some].ravel())[1] for k in shifts]
    return _refine(X, y[rows].ravel(), rows, int(shifts[np.argmin(left)]), reach)


def _refine(X: Array, y: Array, rows: NDArray[np.intp], k: int, reach: int) -> ClockOffset | None:
    """Least squares in shift and parameters from the best whole row on."""
    if abs(k) >= reach - STEPS:
        return None
    A, slope = X[rows + k], (X[rows + k + 1] - X[rows + k - 1]) / (2.0 * GRID_S)
    theta, _ = _solve(A, y)
    columns = A.reshape(len(y), -1)
    Q = _basis(columns)
    moved = (slope @ theta).ravel()
    moved -= Q @ (Q.T @ moved)
    strength = float(moved @ moved)
    if strength < 1e-12 * len(y):
        return None
    residual = y - Q @ (Q.T @ y)
    ahead_s = float(moved @ residual) / strength
    change = y.reshape(-1, 6) - y.reshape(-1, 6).mean(axis=0)
    if float(residual @ residual) > EXPLAINED * float((change**2).sum()):
        return None  # something else than the payload pushes, and its times say nothing of clocks
    scores = (moved * (residual - moved * ahead_s)).reshape(len(rows), -1).sum(axis=1)
    blocks = np.add.reduceat(scores, np.arange(0, len(rows), round(BLOCK_S / GRID_S)))
    std_s = float(np.sqrt((blocks**2).sum())) / strength
    # motion at t + s explains the wrench at t: the wrench is late by -s
    late_s = -(k * GRID_S + ahead_s)
    return ClockOffset(late_s, std_s) if std_s < MOST_STD_S and abs(ahead_s) < 2.0 * GRID_S else None


def _solve(A: Array, y: Array) -> tuple[Array, float]:
    """Parameters (16,) and the square sum that they leave, where A is (M, 6, 16)."""
    columns = A.reshape(len(y), -1)
    theta: Array = np.asarray(np.linalg.lstsq(columns, y, rcond=1e-8)[0], dtype=float)
    return theta, float(((y - columns @ theta) ** 2).sum())


def _basis(columns: Array) -> Array:
    basis, strength, _ = np.linalg.svd(columns, full_matrices=False)
    return np.asarray(basis[:, strength > 1e-8 * strength[0]])


def _regressor_on(grid: Array, recording: Recording, rows: slice) -> Array:
    """(M, 6, 16): of the ten parameters, and an offset."""
    orientation, position = recording.orientation, recording.position
    if orientation is None and recording.robot is not None and recording.q is not None:
        poses = RobotModel(recording.robot).sensor_poses(recording.q[rows])
        orientation, position = poses.rotation, poses.position
    else:
        orientation = None if orientation is None else orientation[rows]
        position = None if position is None else position[rows]
    assert orientation is not None  # a recording with a wrench has one of both
    R = interpolate(grid, recording.t[rows], orientation.reshape(-1, 9))
    turned = derive(R, WINDOW, 2).reshape(-1, 3, 3)
    bent = derive(R, WINDOW, 2, 2, GRID_S).reshape(-1, 3, 3)
    base = np.swapaxes(turned, 1, 2)
    a = np.zeros((len(grid), 3)) - recording.gravity
    if position is not None:
        a += derive(interpolate(grid, recording.t[rows], position), WINDOW, 2, 2, GRID_S)
    V = regressor_of(np.einsum("nij,nj->ni", base, a), base @ bent)
    return np.concatenate([V, np.broadcast_to(np.eye(6), (len(V), 6, 6))], axis=2)
