"""The offset wanders: a random walk beside the drift, as electronics and temperatures of a hall make it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.effects.channels import SUFFIXES, expand_to_channels
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_drift import SensorDrift
from core.effects.window_search import ROWS, columns_of_payload_and_offsets
from core.payload.channels import CHANNELS, UNITS
from core.words.message import Message

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
MOST = 0.7
"""Share of the residual's square that a walk has to explain."""
AS_LARGE = 0.55
"""Steps of a walk where gravity stays, the third of them in which it turns least, against the third in which it turns most, root mean
squares; of what depends on the attitude they are less than 0.4."""
LESS = 0.75
"""Times as far it has to turn in those as in these at most, or there is nothing to compare with."""
RIDGE = 1e-6
"""Of steps that no row shows."""


class DriftThatWanders(SensorDrift):
    """`W = w + drift + sum_k c_k clip((t - t_k) / d, 0, 1)`: independent changes c_k in 40 stretches of d, each with a prior.

    Only where the residual goes on changing while nothing moves, channel by channel, or as much while the attitude hardly changes as while
    it does: else this could take up whatever is slow.
    """

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Those of the drift, then the changes of six channels in each stretch, which are not shown."""
        step = np.sqrt(_find_spacing(scene)) * STEP
        changes = (
            Parameter(f"knot_{k + 1}_{channel}_{suffix}", unit, 0.0, -30.0 * float(s), 30.0 * float(s), float(s), shown=False)
            for k in range(KNOTS)
            for channel, suffix, unit, s in zip(CHANNELS, SUFFIXES, UNITS, step, strict=True)
        )
        return (*super().parameters(scene), *changes)

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus drift and walk."""
        levels = np.vstack((np.zeros(6), np.cumsum(theta[-CHANGES:].reshape(-1, 6), axis=0)))
        at = _find_spacing(scene) * np.arange(len(levels))
        walk = np.column_stack([np.interp(scene.elapsed, at, channel) if channel.any() else np.zeros(len(scene)) for channel in levels.T])
        return np.asarray(super().wrench(scene, w, theta[:-CHANGES]) + walk)

    def explain_tie_to_run(self, scene: Scene) -> Message | None:
        """It wandered so once."""
        return Message.of("effect-shape-of-run")

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Without a walk; nothing where the residual does not wander whatever moves."""
        if not wanders_in_holds(scene, residual) and not wanders_in_any_attitude(scene, residual):
            return []
        return [np.concatenate((start, np.zeros(CHANGES))) for start in SensorDrift().starts(scene, residual)[:1]]

    def find_drift(self, scene: Scene, theta: Array) -> Array:
        """Of both together."""
        return np.asarray(super().find_drift(scene, theta[:-CHANGES]) + theta[-CHANGES:].reshape(-1, 6).sum(axis=0))


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


def wanders_in_any_attitude(scene: Scene, residual: Array) -> bool:
    """Whether a walk beside payload and offsets explains most of residuals (N, 6), in standard deviations of the noise, and its steps are
    about as large where gravity stays in the sensor as where it turns."""
    if scene.apart or len(residual) < 8 * KNOTS:
        return False
    rows = slice(0, None, max(1, len(scene) // ROWS))
    at, wanted = _find_spacing(scene) * np.arange(KNOTS + 1), residual[rows]
    ramps = np.clip((scene.elapsed[rows, None] - at[:-1]) / at[1], 0.0, 1.0)
    steps, share = _fit_walk(ramps, wanted, np.linalg.qr(columns_of_payload_and_offsets(scene, rows).reshape(wanted.size, -1))[0])
    g = np.column_stack([np.interp(at, scene.elapsed, axis) for axis in scene.motion.g.T])
    turns = np.linalg.norm(np.diff(g, axis=0), axis=1)[at[:-1] < scene.elapsed[-1]]
    order, third = np.argsort(turns), len(turns) // 3
    still, turning = (float(np.square(steps[some]).mean()) for some in (order[:third], order[-third:]))
    return bool(share > MOST and still > AS_LARGE**2 * turning and turns[order[third]] < LESS * turns[order[-third]])


def _fit_walk(ramps: Array, wanted: Array, Q: Array) -> tuple[Array, float]:
    """(KNOTS, 6), steps of each channel by least squares beside what Q takes up, and the share of `wanted` (n, 6) that they explain."""
    n = ramps.shape[1]
    rest = (wanted.ravel() - Q @ (Q.T @ wanted.ravel())).reshape(wanted.shape)
    taken = np.einsum("rk,rcq->ckq", ramps, Q.reshape(*wanted.shape, -1)).reshape(6 * n, -1)
    normal = np.kron(np.eye(6), ramps.T @ ramps) - taken @ taken.T
    along = (ramps.T @ rest).T.ravel()
    steps = np.linalg.solve(normal + RIDGE * np.trace(normal) / len(normal) * np.eye(len(normal)), along)
    return steps.reshape(6, n).T, float(steps @ along) / max(float(np.square(rest).sum()), 1e-300)


def _find_inside(holds: NDArray[np.bool_], lag: int) -> NDArray[np.bool_]:
    """(N - lag,), whether all rows from one to the row `lag` later are in one hold."""
    total = np.concatenate(([0], np.cumsum(holds)))
    return np.asarray(total[lag + 1 :] - total[: -lag - 1] == lag + 1)


def _find_spacing(scene: Scene) -> float:
    return max(KNOT_S, float(scene.t[-1] - scene.t[0]) / KNOTS)
