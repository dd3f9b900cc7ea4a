"""The delay of the wrench grows steadily: two clocks that run apart, and a buffer between them that slips from time to time."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.filters import delay_each
from core.effects.scene import Scene
from core.effects.time_delay import TimeDelay
from core.effects.window_search import weights
from core.words.message import Message

BIN_S = 0.5
"""Over which a delay is looked at before a fit."""
SHORTEST_S, CYCLES, PHASES = 1.5, 80, 32
"""Times from slip to slip that are looked at, from the shortest to the run, and how many first slips for each."""
SIGN = 0.01
"""Share that the best growth explains more than a constant delay does, or there is no sign of one."""


class DelayThatGrows(TimeDelay):
    """`W(t - tau - g (t - t_m))`, t_m the middle between two slips of the buffer, at `t_1 + k c`: each takes the delay back by `g c`."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The mean delay, s, its growth, s/s, the time from slip to slip, s, and that of one of them, s."""
        begin, end = float(scene.t[0]), float(scene.t[-1])
        return (
            Parameter("delay_s", "s", 0.0, 0.0, 0.2, 0.02),
            Parameter("growth_s_per_s", "s/s", 0.0, -0.1, 0.1, 0.002),
            Parameter("cycle_s", "s", 2.0 * (end - begin), 0.5 * SHORTEST_S, 4.0 * (end - begin), 0.2 * (end - begin)),
            Parameter("slip_s", "s", begin, begin - 4.0 * (end - begin), end, 0.2 * (end - begin)),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` as it was so much earlier, by a quintic between samples; it is never early."""
        late = theta[0] + theta[1] * theta[2] * _sawtooth(scene.t, theta[2], theta[3])
        return delay_each(w, late / scene.period)

    def explain_tie_to_run(self, scene: Scene) -> Message | None:
        """It slipped so once."""
        return Message.of("effect-shape-of-run")

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The growth and the slips by which delays of half a second each are described best, with short, middling and long delays; none
        where a constant delay describes them as well."""
        found = None if scene.apart else _find_growth(scene, residual)
        if found is None:
            return []
        late, growth, cycle, slip = found
        most = abs(late) + 0.5 * abs(growth) * min(cycle, float(scene.t[-1] - scene.t[0]))
        return [np.array([late / most * delay, growth / most * delay, cycle, slip]) for delay in (0.006, 0.02, 0.05)]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises one clock for wrench and joints: how much later it comes in a minute, ms, and from slip to slip, s, where it slips."""
        growth, cycle = float(theta[1]), float(theta[2])
        if cycle < scene.t[-1] - scene.t[0]:
            return Message.of("advice-time-delay-slips", swing_s=abs(growth) * cycle, cycle_s=cycle)
        return Message.of("advice-time-delay-grows", per_minute_s=60.0 * growth)


def _sawtooth(t: Array, cycle: float, slip: float) -> Array:
    """(N,), from -1/2 to 1/2 between slips."""
    return np.asarray((t - slip) / cycle % 1.0 - 0.5)


def _find_growth(scene: Scene, residual: Array) -> tuple[float, float, float, float] | None:
    """Mean delay and growth, both up to one factor as the residual's unit is not known, cycle and slip, by which delays within short times,
    each of least squares, are described best."""
    t, long_s = scene.t, float(scene.t[-1] - scene.t[0])
    if long_s < 2.0 * SHORTEST_S:
        return None
    column = -np.gradient(scene.nominal, t, axis=0) * weights(scene)
    which = ((t - t[0]) / BIN_S).astype(int)
    along, size = (np.bincount(which, x.sum(axis=1)) for x in (column * residual, column * column))
    centre = t[0] + BIN_S * (np.arange(len(size)) + 0.5)
    best, gain = None, (1.0 + SIGN) * float(along.sum() ** 2 / max(size.sum(), 1e-300))
    for cycle in (*np.geomspace(SHORTEST_S, long_s, CYCLES), 2.0 * long_s):
        # a cycle longer than the run does not slip in it
        slips = t[0] + cycle * np.arange(PHASES) / PHASES if cycle < 1.5 * long_s else [t[0] - 0.5 * long_s]
        for slip in slips:
            X = np.column_stack((np.ones(len(size)), _sawtooth(centre, cycle, slip)))
            right = X.T @ along
            late, swing = np.linalg.lstsq(X.T @ (size[:, None] * X), right, rcond=None)[0]
            if (explained := float(right @ (late, swing))) > gain:
                best, gain = (max(float(late), 0.0), float(swing) / cycle, float(cycle), float(slip)), explained
    return best
