"""The delay of the wrench wanders: a network, a busy recorder, clocks that are set now and then."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.delay_that_grows import explain_by_growth, weigh_pieces
from core.effects.effect import Parameter
from core.effects.filters import delay_each
from core.effects.scene import Scene
from core.effects.time_delay import TimeDelay
from core.words.message import Message

KNOTS = 40
KNOT_S = 1.0
"""From one to the next, as far as so many of them last."""
STEP_S = 0.003
"""Plausible change of the delay from one knot to the next where they are a second apart."""
SIGN = 0.2
"""Share of what a constant delay leaves that delays of short pieces explain, or there is no sign of one that changes."""
EVENLY = 0.8
"""Share of that which one that grows evenly from slip to slip explains at most, or it is that."""
RIDGE = 1e-3
"""Of pieces in which no load changes."""


class DelayThatWanders(TimeDelay):
    """`W(t - tau - x(t))`, x a random walk: independent changes in 40 stretches, straight between, each with a prior."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The delay in the first sample, s, then its changes in each stretch, which are not shown."""
        step = STEP_S * float(np.sqrt(_find_spacing(scene)))
        changes = (Parameter(f"knot_{k + 1}_s", "s", 0.0, -0.1, 0.1, step, shown=False) for k in range(KNOTS))
        return (Parameter("delay_s", "s", 0.0, 0.0, 0.2, 0.02), *changes)

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` as it was so much earlier, by a quintic between samples; it is never early."""
        late = np.interp(scene.elapsed, _find_spacing(scene) * np.arange(len(theta)), np.cumsum(theta))
        return delay_each(w, late / scene.period)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """None: how a delay changes shows once it is known."""
        return []

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """The constant delay, where delays of short pieces explain a good part of what it has left."""
        if scene.apart or scene.t[-1] - scene.t[0] < KNOTS * scene.period:
            return []
        late = float(plain[0])
        along, shared, there = weigh_pieces(scene, residual, late, _find_spacing(scene))
        explained = float(along @ np.linalg.solve(shared + RIDGE * np.trace(shared) / len(shared) * np.eye(len(shared)), along))
        wanders = explained > max(SIGN * there, explain_by_growth(scene, residual, late) / EVENLY)
        return [np.append(late, np.zeros(KNOTS))] if wanders else []

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises one clock for wrench and joints: from which to which delay it wanders, ms."""
        late = np.maximum(np.cumsum(theta), 0.0)
        return Message.of("advice-time-delay-wanders", least_s=float(late.min()), most_s=float(late.max()))


def _find_spacing(scene: Scene) -> float:
    return max(KNOT_S, float(scene.t[-1] - scene.t[0]) / KNOTS)
