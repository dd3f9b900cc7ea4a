"""The wrench is late by tenths of a second: two clocks, or a queue in the recorder. No fit gets there from a few milliseconds."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.time_delay import TimeDelay
from core.effects.window_search import columns_of_payload_and_offsets

SEARCHED_S, ROWS = np.arange(0.0, 1.01, 0.02), 500
"""Delays that are tried, and on how many rows of a run, about."""
SMALL_S, LARGE_S = 0.04, 0.1
"""What a large delay is held against, and from which on it is one: less is left to the plain shape. The search finds delays too small by up
to a row of the residual, which is whitened by the rows before it."""
CLEARLY = 0.5
"""Share of what the best small delay leaves that a large one may leave."""
DEGENERATE = 1e-9
"""Of the strongest combination, that a weaker one has to have."""
AS_GOOD = 1.2
"""Times the least, that another minimum may leave to be as good: of a motion that repeats itself the smallest delay is taken."""


class DelayOfClocks(TimeDelay):
    """`W(t - tau)`, tau up to a second."""

    wider_shape = True
    moves_payload = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The delay, s."""
        return (Parameter("delay_s", "s", 0.0, 0.0, 1.0, 0.3),)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The delay that leaves clearly less than small ones, and one row of the residual more; none where small ones leave as little."""
        late = 0.0 if scene.apart else _find_delay(scene, residual)
        return [np.array([late]), np.array([late + scene.residual_window])] if late > LARGE_S else []


def _find_delay(scene: Scene, residual: Array) -> float:
    """s, after which the loads of any payload, with those of another that do not wait, make up most of a residual (N, 6)."""
    rows = np.arange(0, len(scene), max(1, len(scene) // ROWS))
    columns = columns_of_payload_and_offsets(scene, slice(None))
    earlier = np.maximum(rows - np.rint(SEARCHED_S[:, None] / scene.period).astype(int), 0)
    left = np.array([_find_share_left(residual[rows], np.concatenate((columns[rows], columns[then, :, :10]), axis=2)) for then in earlier])
    minima = (left <= np.append(left[1:], np.inf)) & (left <= np.append(np.inf, left[:-1])) & (left <= AS_GOOD * left.min())
    best = int(np.argmax(minima))
    return float(SEARCHED_S[best]) if left[best] < CLEARLY * left[SEARCHED_S <= SMALL_S].min() else 0.0


def _find_share_left(seen: Array, columns: Array) -> float:
    """Of the square of `seen` (n, 6), what columns (n, 6, k) leave."""
    y, A = seen.ravel(), columns.reshape(seen.size, -1)
    A = A / np.maximum(np.linalg.norm(A, axis=0), np.finfo(float).tiny)
    along = A.T @ y
    return 1.0 - float(along @ np.linalg.pinv(A.T @ A, rcond=DEGENERATE, hermitian=True) @ along) / max(float(y @ y), 1e-300)
