"""Loads beyond a limit are clipped: a range that is set too small, an amplifier at its end."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numba import njit

from core.array import Array
from core.effects.channels import SUFFIXES, expand_to_channels, say_load
from core.effects.effect import Effect, Parameter
from core.effects.scene import Scene
from core.effects.window_search import ROWS, columns_of_payload_and_offsets, weights
from core.payload.channels import CHANNELS, UNITS
from core.words.message import Message

SHARES = np.linspace(0.08, 0.98, 16)
"""Of the largest load of a channel, limits that are looked at before a fit."""
SEEN = 25.0
"""Chi-square that a limit has to explain to be one."""
CORNER = 0.02
"""Share of the limit over which it is rounded where nothing else is known."""
NONE = 1e-9
"""1/N or 1/(N m), the reciprocal of a limit that no load reaches."""
FAINT = 0.01
"""Share of what the first limit explains that each other one has to explain."""


class SensorSaturation(Effect):
    """`W = clip(w, -1/l, 1/u)` for each channel, with corners rounded over a share of the limit to either side of it.

    The reciprocals are fitted: zero is no limit. Upper and lower limits differ because the sensor clips load and offset together, and `w`
    is without offset. A converter at its end has sharp corners, an amplifier near its end bends early.
    """

    id = "sensor_saturation"
    title = Message.of("effect-sensor-saturation-title")
    stage = "sensor"
    starts_from_most = True
    followed = 4

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Reciprocals of six upper limits, then of six lower ones, 1/N and 1/(N m), and the corner of all of them as a share."""
        limits = (
            Parameter(
                f"{channel}_{side}_limit_per_{suffix}",
                f"1/({unit})" if " " in unit else f"1/{unit}",
                0.0,
                0.0,
                float(20 * scale),
                float(scale),
            )
            for side in ("upper", "lower")
            for channel, suffix, unit, scale in zip(CHANNELS, SUFFIXES, UNITS, expand_to_channels(0.1, 2.0), strict=True)
        )
        return (*limits, Parameter("corner_share", "1", CORNER, 0.005, 0.8, 0.2))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`clip(w, -1/l, 1/u)` in each channel with rounded corners; a reciprocal of zero is no limit."""
        W = w.copy()
        for j in range(6):
            if theta[j] > NONE:
                W[:, j] = limit_softly(W[:, j], 1 / theta[j], theta[12] / theta[j])
            if theta[6 + j] > NONE:
                W[:, j] = -limit_softly(-W[:, j], 1 / theta[6 + j], theta[12] / theta[6 + j])
        return W

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The limits whose missing load looks most like the residual, the first of them and all of them, with sharp and round corners."""
        seen = find_limits(scene, residual, lambda x: SHARES * max(0.0, float(x.max())))
        first, every = np.zeros(12), np.zeros(12)
        for number, (k, limit) in enumerate(seen):
            every[k] = 1.0 / limit
            if number == 0:
                first[k] = every[k]
        upper = [p.upper for p in self.parameters(scene)[:12]]
        limits = [first, every] if len(seen) > 1 else [first]
        return [np.append(np.clip(limit, 0.0, upper), corner) for limit in limits for corner in (CORNER, 0.3)]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises a larger range or a lighter payload, with the limit that is passed most and the load of the run, N or N m."""
        reach = np.abs(scene.nominal).max(axis=0)
        k = int((theta[:12] * np.tile(reach, 2)).argmax())
        channel, limit = k % 6, 1 / max(float(theta[k]), 1e-6)
        name, needed = CHANNELS[channel], say_load(reach[channel], channel)
        if k < 6:
            return Message.of("advice-sensor-saturation-above", channel=name, clipped_at=say_load(limit, channel), needed=needed)
        return Message.of("advice-sensor-saturation-below", channel=name, clipped_at=say_load(-limit, channel), needed=needed)


@njit(cache=True)
def limit_softly(x: Array, limit: float, d: float) -> Array:
    """`min(x, limit)` of (N,), rounded by a parabola from `limit - d` to `limit + d`."""
    out = np.empty(len(x))
    for k in range(len(x)):
        inside = min(max(x[k] - limit + d, 0.0), 2 * d)
        out[k] = min(x[k], limit + d) - inside * inside / (4 * d)
    return out


def find_limits(scene: Scene, residual: Array, levels: Callable[[Array], Array], sign: float = 0.0) -> list[tuple[int, float]]:
    """Sides and limits whose missing load looks most like the residual, one after the other (orthogonal matching pursuit); sides are upper
    ones of six channels, then lower ones, whose limits are of `-w`.

    What payload and offsets take up does not count.

    Args:
        levels: limits (l,) that are looked at, of the load (n,) of one side.
        sign: share of the residual that the first one has to explain, or there is none.
    """
    rows = slice(0, None, max(1, len(scene) // ROWS))
    w, scale, r = scene.nominal[rows], weights(scene), residual[rows].T.ravel()
    Q, _ = np.linalg.qr(columns_of_payload_and_offsets(scene, rows).transpose(1, 0, 2).reshape(6 * len(w), 16))
    sides = {k: (1.0 if k < 6 else -1.0) * w[:, k % 6] for k in range(12)}
    looked_at = {k: levels(x) for k, x in sides.items()}
    columns = {k: scale[k % 6] * (1.0 if k < 6 else -1.0) * _cut_off(x, looked_at[k]) for k, x in sides.items()}
    seen: list[tuple[int, float]] = []
    least = max(SEEN, sign * float(r @ r))
    while columns:
        gains = {k: _gains(c, Q, r, k % 6) for k, c in columns.items()}
        k = max(gains, key=lambda k: float(gains[k].max()))
        best = int(gains[k].argmax())
        if gains[k][best] < least:
            break
        least = max(SEEN, FAINT * float(gains[k][best])) if not seen else least
        seen.append((k, float(looked_at[k][best])))
        q = np.zeros((6, len(w)))
        q[k % 6] = columns.pop(k)[:, best]
        Q = np.linalg.qr(np.column_stack([Q, q.ravel()]))[0]
        r = r - Q @ (Q.T @ r)
    return seen


def _cut_off(x: Array, levels: Array) -> Array:
    """(n, l), what each of the limits takes off a channel (n,)."""
    return np.column_stack([np.minimum(x, level) - x for level in levels])


def _gains(columns: Array, Q: Array, r: Array, channel: int) -> Array:
    """(l,), chi-square of r (6n,) that each column (n, l) of one channel explains beside the orthonormal Q (6n, m)."""
    rows = slice(channel * len(columns), (channel + 1) * len(columns))
    along = columns.T @ r[rows]
    size = (columns**2).sum(axis=0)
    free = size - ((Q[rows].T @ columns) ** 2).sum(axis=0)
    shows = (along > 0) & (free > 1e-6 * size)
    return np.where(shows, along**2 / np.where(shows, free, 1.0), 0.0)
