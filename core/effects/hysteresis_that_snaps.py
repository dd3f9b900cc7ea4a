"""What a sensor holds back sticks, and snaps on as a whole once it is too much: a sawtooth of the load, no loop."""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from core.array import Array
from core.effects.channels import find_largest_channel, full_scale, shares
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_hysteresis import SensorHysteresis
from core.effects.window_search import ROWS, columns_of_payload_and_offsets
from core.payload.channels import CHANNELS
from core.words.message import Message

MOST_SHARE = 0.5
"""Share of a channel's whole change of load that may be held back: with more it might never snap, and be a gain of that channel."""
USUAL, LEAST_MOST = 0.01, 0.03
"""Of full scale, that is held back as a rule, and that may be held back in a channel that hardly changes."""
HOLDS = np.geomspace(0.003, MOST_SHARE, 80)
"""Shares of that change looked at before a fit."""
RESTS = (0.0, 0.3)
"""Shares of it that a snap may leave."""
SEEN = 0.01
"""Share of the residual that a sawtooth of one channel has to explain to be one."""


class HysteresisThatSnaps(SensorHysteresis):
    """`W = w - s (w - a)`: a share s of what the load has changed since a is held back, a stays until that is `r`, and then follows to
    `rest r` behind it (a clamped joint beside the beams; the slip jump of sticking valves, Choudhury et al. 2005)."""

    wider_shape = True
    jumps = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Six shares that are held back, six logarithms of the changes that are, over full scale, at most as large as makes it snap in
        this run, and the share that a snap leaves."""
        most = np.maximum(MOST_SHARE * np.ptp(scene.nominal, axis=0) / full_scale(scene, scene.nominal), LEAST_MOST)
        holds = (
            Parameter(f"{channel}_turning_load_log_ratio", "1", math.log(USUAL), -9.0, math.log(upper), 1.0)
            for channel, upper in zip(CHANNELS, most.tolist(), strict=True)
        )
        return (*shares("held_share", lower=-1.0, upper=1.0, scale=0.2), *holds, Parameter("rest_share", "1", 0.0, 0.0, 0.9, 0.3))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w - s (w - a)` in each channel that holds anything back."""
        return np.asarray(w - theta[:6] * (w - _stick(np.ascontiguousarray(w), np.exp(theta[6:12]) * full_scale(scene, w), theta[12])))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """For each rest, in each channel the sawtooth that looks most like the residual; none where no channel has one."""
        found = (_find_sawteeth(scene, residual, rest) for rest in RESTS)
        return [start for start in found if start[:6].any()]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises checking the flanges' bolts, or one side of approach, with what the worst channel holds back in % of full scale."""
        held = theta[:6] * np.exp(theta[6:12])
        k, channel = find_largest_channel(held)
        return Message.of("advice-sensor-hysteresis", channel=channel, height_share=float(held[k]))


@njit(cache=True)
def _stick(w: Array, most: Array, rest: float) -> Array:
    """(N, n), where each channel of w (N, n) sticks that follows only when it is more than `most` (n,) away, to `rest` times that."""
    out = np.empty_like(w)
    at = w[0].copy()
    for k in range(len(w)):
        for c in range(w.shape[1]):
            off = w[k, c] - at[c]
            if abs(off) > most[c]:
                at[c] = w[k, c] - rest * most[c] * np.sign(off)
            out[k, c] = at[c]
    return out


def _find_sawteeth(scene: Scene, residual: Array, rest: float) -> Array:
    """(13,), parameters with the sawteeth that look most like a residual (N, 6), one channel after the other (orthogonal matching pursuit);
    what payload and offsets take up does not count. Channels without one hold nothing back."""
    rows = slice(0, None, max(1, len(scene) // ROWS))
    w, r = scene.nominal, residual[rows].T.ravel()
    n = len(r) // 6
    Q = np.linalg.qr(columns_of_payload_and_offsets(scene, rows).transpose(1, 0, 2).reshape(6 * n, -1))[0]
    full, theta = full_scale(scene, w), np.array([p.absent for p in HysteresisThatSnaps().parameters(scene)])
    theta[12], least = rest, SEEN * float(r @ r)
    holds = np.outer(np.ptp(w, axis=0), HOLDS)
    teeth = {c: np.column_stack([w[rows, c] - _stick(w[:, [c]], hold[None], rest)[rows, 0] for hold in holds[c]]) for c in range(6)}
    while teeth:
        gains = {c: _gains(columns, Q[c * n : (c + 1) * n], r[c * n : (c + 1) * n]) for c, columns in teeth.items()}
        c = max(gains, key=lambda c: float(gains[c].max()))
        k = int(np.argmax(gains[c]))
        if gains[c][k] < least:
            break
        theta[c], theta[6 + c] = 0.1, math.log(holds[c, k] / full[c])
        q = np.zeros((6, n))
        q[c] = teeth.pop(c)[:, k]
        Q = np.linalg.qr(np.column_stack((Q, q.ravel())))[0]
        r = r - Q @ (Q.T @ r)
    return theta


def _gains(teeth: Array, Q: Array, r: Array) -> Array:
    """(levels,), square of r (n,) that each sawtooth (n, levels) explains where it takes something off, beside Q (n, m) of its channel."""
    size = (teeth**2).sum(axis=0)
    free, along = size - ((Q.T @ teeth) ** 2).sum(axis=0), r @ teeth
    return np.where((free > 1e-6 * size) & (along < 0.0), along**2 / np.maximum(free, np.finfo(float).tiny), 0.0)
