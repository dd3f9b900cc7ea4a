"""The delay of the wrench grows steadily: two clocks that run apart, and a buffer between them that slips from time to time."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.filters import delay_each, delay_signal
from core.effects.scene import Scene
from core.effects.splines import smooth_by_splines
from core.effects.time_delay import TimeDelay
from core.effects.window_search import ROWS, columns_of_payload_and_offsets, weights
from core.words.message import Message

BIN_S, MOST_BINS = 0.2, 400
"""Over which a delay is looked at before a fit, at least, and in how many pieces of a run at most."""
LEAST_S = 0.005
"""Of the swing from which a fit starts."""
SHORTEST = 6
"""Pieces from slip to slip, at least."""
FINER, PHASES = 5, 32
"""Numbers of slips in a run are looked at in such parts of one, and as many first slips for each."""
SIGN = 0.05
"""Share of what a constant delay leaves that the best growth explains, or there is no sign of one."""


class DelayThatGrows(TimeDelay):
    """`W(t - tau - g (t - t_m))`, t_m the middle between two slips of the buffer, at `t_1 + k c`: each takes the delay back by `g c`."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The mean delay, s, its growth, s/s, the time from slip to slip, s, and that of one of them, s."""
        begin, end = float(scene.t[0]), float(scene.t[-1])
        return (
            Parameter("delay_s", "s", 0.0, 0.0, 0.2, 0.02),
            Parameter("growth_s_per_s", "s/s", 0.0, -0.1, 0.1, 0.002),
            Parameter("cycle_s", "s", 2.0 * (end - begin), BIN_S, 4.0 * (end - begin), 0.2 * (end - begin)),
            Parameter("slip_s", "s", begin, begin - 4.0 * (end - begin), end, 0.2 * (end - begin)),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` as it was so much earlier, by a quintic between samples; it is never early."""
        late = theta[0] + theta[1] * theta[2] * _sawtooth(scene.t, theta[2], theta[3])
        return delay_each(w, late / scene.period)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """None: how a delay grows shows once the delay is known."""
        return []

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """The growth and the slips by which the delays that short pieces have left are described best."""
        found = None if scene.apart else _find_growth(scene, residual, float(plain[0]))
        return [] if found is None else [found]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises one clock for wrench and joints: how much later it comes in a minute, ms, and from slip to slip, s, where it slips."""
        growth, cycle = float(theta[1]), float(theta[2])
        if cycle < scene.t[-1] - scene.t[0]:
            return Message.of("advice-time-delay-slips", swing_s=abs(growth) * cycle, cycle_s=cycle)
        return Message.of("advice-time-delay-grows", per_minute_s=60.0 * growth)


def _sawtooth(t: Array, cycle: float, slip: float | Array) -> Array:
    """(N,), from -1/2 to 1/2 between slips; (M, N) of slips (M, 1)."""
    return np.asarray((t - slip) / cycle % 1.0 - 0.5)


def _find_growth(scene: Scene, residual: Array, late: float) -> Array | None:
    """(4,), parameters by which the delays of short pieces beyond `late`, s, each of least squares, are described best; None where they
    explain hardly anything."""
    growth = _find_best_growth(scene, residual, late)
    if growth is None or growth.explained < SIGN * growth.there:
        return None
    cycle, slip, swing, *_ = growth
    # the residual's unit is not known: that it comes and goes with the delay is as good a start as any
    return np.array([late, math.copysign(max(late, LEAST_S), swing) / cycle, cycle, slip])


def explain_by_growth(scene: Scene, residual: Array, late: float) -> float:
    """What of a residual (N, 6), squared, a delay explains that grows evenly from slip to slip beyond `late`, s."""
    growth = _find_best_growth(scene, residual, late)
    return 0.0 if growth is None else growth.explained


class _Growth(NamedTuple):
    """From slip to slip, s, one of them, s, the swing, s, what it explains, and what was there."""

    cycle: float
    slip: float
    swing: float
    explained: float
    there: float


def _find_best_growth(scene: Scene, residual: Array, late: float) -> _Growth | None:
    """The one that explains most; None of a run that is too short."""
    piece_s = max(BIN_S, float(scene.t[-1] - scene.t[0]) / MOST_BINS)
    if scene.t[-1] - scene.t[0] < 2 * SHORTEST * piece_s:
        return None
    along, shared, there = weigh_pieces(scene, residual, late, piece_s)
    return _Growth(*_find_sawtooth(scene.t[0] + piece_s * np.arange(0.5, len(along)), along, shared), there)


def weigh_pieces(scene: Scene, residual: Array, late: float, piece_s: float) -> tuple[Array, Array, float]:
    """(n,), (n, n), what a further delay of each piece of a run explains of a residual (N, 6) that the delay `late`, s, has left, and their
    normal matrix; and the residual's square. What payload and offsets take up does not count."""
    t = scene.t
    rows = slice(0, None, max(1, len(scene) // ROWS))
    slope = -np.gradient(delay_signal(scene.nominal, late / scene.period), t, axis=0)
    column = smooth_by_splines(slope, scene.period, scene.residual_window)[rows] * weights(scene)
    Q = np.linalg.qr(columns_of_payload_and_offsets(scene, rows).reshape(column.size, -1))[0]
    seen = residual[rows].ravel()
    r = (seen - Q @ (Q.T @ seen)).reshape(-1, 6)
    which = ((t[rows] - t[0]) / piece_s).astype(int)
    along, alone = (np.bincount(which, x.sum(axis=1)).astype(float) for x in (column * r, column * column))
    taken = np.stack([np.bincount(which, (column * q.reshape(-1, 6)).sum(axis=1)) for q in Q.T], axis=1)
    return along, np.asarray(np.diag(alone) - taken @ taken.T, dtype=float), float((r * r).sum())


def _find_sawtooth(centre: Array, along: Array, shared: Array) -> tuple[float, float, float, float]:
    """Cycle, slip, the swing beside a constant, and what it explains.

    Args:
        centre: (n,), times of pieces, s. along: (n,), what a change of each one's delay explains; shared: (n, n), their normal matrix.
    """
    piece_s = float(centre[1] - centre[0])
    begin, long_s = centre[0] - 0.5 * piece_s, len(centre) * piece_s
    shared = shared - np.outer(shared.sum(axis=1), shared.sum(axis=0)) / max(float(shared.sum()), 1e-300)
    least = 1e-9 * float(np.trace(shared))
    cycles = long_s * FINER / np.arange(FINER, FINER * (len(centre) // SHORTEST) + 1)
    # a cycle longer than the run does not slip in it
    tried = [(2.0 * long_s, np.array([begin - 0.5 * long_s]))]
    tried += [(float(cycle), begin + cycle * np.arange(PHASES) / PHASES) for cycle in cycles]
    found = []
    for cycle, slips in tried:
        saw = _sawtooth(centre, cycle, slips[:, None])
        swing = saw @ along / (((saw @ shared) * saw).sum(axis=1) + least)
        explained = swing * (saw @ along)
        k = int(np.argmax(explained))
        found.append((cycle, float(slips[k]), float(swing[k]), float(explained[k])))
    return max(found, key=lambda each: each[3])
