"""The offset wanders: a random walk beside the drift, as electronics and temperatures of a hall make it."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from core.array import Array
from core.effects.channels import SUFFIXES, expand_to_channels
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_drift import SensorDrift
from core.payload.channels import CHANNELS, UNITS

KNOTS = 40
KNOT_S = 1.0
"""From one to the next, as far as so many of them last."""
CHANGES = 6 * KNOTS
"""Parameters of the walk."""
STEP = expand_to_channels(0.1, 0.005)
"""Plausible change from one knot to the next where they are a second apart, N and N m."""
LAG_S = 0.4
"""Over which changes within a hold are looked at, and twice that."""
STANDS_OUT = 1.2
"""Median square of these changes, in variances of the noise, from which a channel, and the mean of all, wanders within holds; noise alone
makes it 0.6 to 0.9."""
GOES_ON = 0.3
"""Times the changes between other rows: what wanders does so whether anything moves or not."""
GROWS = 1.2
"""Times the square after twice the time: 2 for a walk, 1 for what shakes."""
ONE_COURSE = 0.6
"""Share of the changes' square in one course of all channels from which something pulls, and no channel wanders by itself."""
FEWEST = 3
"""Channels."""


class DriftThatWanders(SensorDrift):
    """`W = w + drift + sum_k c_k clip((t - t_k) / d, 0, 1)`: independent changes c_k in 40 stretches of d, each with a prior.

    Only where the residual goes on changing while nothing moves, channel by channel: else this could take up whatever is slow.
    """

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Those of the drift, then the changes of six channels in each stretch, which are not shown."""
        step = np.sqrt(find_spacing(scene)) * STEP
        changes = (
            Parameter(f"knot_{k + 1}_{channel}_{suffix}", unit, 0.0, -30.0 * float(s), 30.0 * float(s), float(s), shown=False)
            for k in range(KNOTS)
            for channel, suffix, unit, s in zip(CHANNELS, SUFFIXES, UNITS, step, strict=True)
        )
        return (*super().parameters(scene), *changes)

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus drift and walk."""
        levels = np.vstack((np.zeros(6), np.cumsum(theta[-CHANGES:].reshape(-1, 6), axis=0)))
        return np.asarray(_add_walk(super().wrench(scene, w, theta[:-CHANGES]), scene.elapsed / find_spacing(scene), levels))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Without a walk; nothing where the residual does not wander while nothing moves."""
        if not wanders_in_holds(scene, residual):
            return []
        return [np.concatenate((start, np.zeros(CHANGES))) for start in SensorDrift().starts(scene, residual)[:1]]

    def find_drift(self, scene: Scene, theta: Array) -> Array:
        """Of both together."""
        return np.asarray(super().find_drift(scene, theta[:-CHANGES]) + theta[-CHANGES:].reshape(-1, 6).sum(axis=0))


@njit(cache=True)
def _add_walk(w: Array, at: Array, levels: Array) -> Array:
    """`w` (N, 6) and what lies straight between levels (n, 6) at (N,) of their numbers; the last one goes on."""
    out = np.empty_like(w)
    for k in range(len(w)):
        i = min(max(int(at[k]), 0), len(levels) - 2)
        share = min(max(at[k] - i, 0.0), 1.0)
        for c in range(w.shape[1]):
            out[k, c] = w[k, c] + levels[i, c] + share * (levels[i + 1, c] - levels[i, c])
    return out


def wanders_in_holds(scene: Scene, residual: Array) -> bool:
    """Whether residuals (N, 6), in standard deviations of the noise, change in the holds as they do elsewhere, channel by channel."""
    lag = max(1, round(LAG_S / scene.period))
    if scene.apart or len(residual) < 8 * lag:
        return False
    holds = np.char.startswith(scene.phase.astype(str), "hold")
    inside, far = _find_inside(holds, lag), _find_inside(holds, 2 * lag)
    if inside.sum() < 4 * lag or far.sum() < 2 * lag or inside.all():  # where nothing moves there is nothing to compare with
        return False
    changes = residual[lag:] - residual[:-lag]
    near, twice = changes[inside], (residual[2 * lag :] - residual[: -2 * lag])[far]
    here, there = np.median(near**2, axis=0), np.median(changes[~inside] ** 2, axis=0)
    wandering = (here > STANDS_OUT) & (here > GOES_ON * there)
    goes_on = here.mean() > max(STANDS_OUT, GOES_ON * there.mean())
    grows = np.square(twice).mean(axis=0).sum() > GROWS * np.square(near).mean(axis=0).sum()  # all together: a few holds tell little of one
    power = np.linalg.svd(near / np.sqrt((near**2).mean(axis=0)), compute_uv=False) ** 2
    return bool(wandering.sum() >= FEWEST and goes_on and grows and power[0] < ONE_COURSE * power.sum())


def _find_inside(holds: NDArray[np.bool_], lag: int) -> NDArray[np.bool_]:
    """(N - lag,), whether all rows from one to the row `lag` later are in one hold."""
    total = np.concatenate(([0], np.cumsum(holds)))
    return np.asarray(total[lag + 1 :] - total[: -lag - 1] == lag + 1)


def find_spacing(scene: Scene) -> float:
    """From knot to knot, s."""
    return max(KNOT_S, float(scene.t[-1] - scene.t[0]) / KNOTS)
