"""Loads beyond a limit are clipped: a range that is set too small, an amplifier at its end."""

from __future__ import annotations

import numpy as np

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
                W[:, j] = limit_softly(W[:, j], 1 / theta[j], theta[12])
            if theta[6 + j] > NONE:
                W[:, j] = -limit_softly(-W[:, j], 1 / theta[6 + j], theta[12])
        return W

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The limits whose missing load looks most like the residual, the first of them and all of them, with sharp and round corners."""
        seen = _find_limits(scene, residual)
        first, every = np.zeros(12), np.zeros(12)
        for number, (k, reciprocal) in enumerate(seen):
            every[k] = reciprocal
            if number == 0:
                first[k] = reciprocal
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


def limit_softly(x: Array, limit: float, corner: float) -> Array:
    """`min(x, limit)` for a positive limit, rounded by a parabola from `(1 - corner) limit` to `(1 + corner) limit`."""
    d = corner * limit
    inside = np.clip(x - limit + d, 0.0, 2 * d)
    return np.asarray(np.minimum(x, limit + d) - inside**2 / (4 * d))


def _find_limits(scene: Scene, residual: Array) -> list[tuple[int, float]]:
    """Parameters and reciprocal limits whose missing load looks most like the residual, one after the other (orthogonal matching pursuit).

    What payload and offsets take up does not count.
    """
    rows = slice(0, None, max(1, len(scene) // ROWS))
    w, scale, r = scene.nominal[rows], weights(scene), residual[rows].T.ravel()
    Q, _ = np.linalg.qr(columns_of_payload_and_offsets(scene, rows).transpose(1, 0, 2).reshape(6 * len(w), 16))
    sides = {k: (1.0 if k < 6 else -1.0) * w[:, k % 6] for k in range(12)}
    columns = {k: scale[k % 6] * _cut_off(x) * (1.0 if k < 6 else -1.0) for k, x in sides.items() if x.max() > 0}
    seen: list[tuple[int, float]] = []
    least = SEEN
    while columns:
        gains = {k: _gains(c, Q, r, k % 6) for k, c in columns.items()}
        k = max(gains, key=lambda k: float(gains[k].max()))
        best = int(gains[k].argmax())
        if gains[k][best] < least:
            break
        least = max(least, FAINT * float(gains[k][best]))
        seen.append((k, 1.0 / (SHARES[best] * float(sides[k].max()))))
        q = np.zeros((6, len(w)))
        q[k % 6] = columns.pop(k)[:, best]
        Q = np.linalg.qr(np.column_stack([Q, q.ravel()]))[0]
        r = r - Q @ (Q.T @ r)
    return seen


def _cut_off(x: Array) -> Array:
    """(n, levels), what each of the limits takes off a channel (n,)."""
    return np.column_stack([limit_softly(x, share * float(x.max()), CORNER) - x for share in SHARES])


def _gains(columns: Array, Q: Array, r: Array, channel: int) -> Array:
    """(levels,), chi-square of r (6n,) that each column (n, levels) of one channel explains beside the orthonormal Q (6n, m)."""
    rows = slice(channel * len(columns), (channel + 1) * len(columns))
    along = columns.T @ r[rows]
    size = (columns**2).sum(axis=0)
    free = size - ((Q[rows].T @ columns) ** 2).sum(axis=0)
    return np.where((along > 0) & (free > 1e-6 * size), along**2 / np.maximum(free, np.finfo(float).tiny), 0.0)
