"""A hose or cable whose friction holds while the arm rests, and yields over a distance first."""

from __future__ import annotations

import numpy as np
from numba import njit

from core.array import Array
from core.effects.cable_drag import CableDrag, wind
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.words.message import Message

YIELD = 9
"""Where it stands among the parameters."""
YIELD_M = 0.02
"""Usual, from which fits start."""


class CableThatSticks(CableDrag):
    """The cable with friction `-mu z`, `z' = (v - |v| z) / d`: it yields over the distance d like a spring, and holds while the arm rests
    (Dahl, A Solid Friction Model, 1968, along a way in space). What rubs on the floor, along the arm or inside a dress pack does so.

    Between two rows the way is straight, along which z is known: `u + (z - u) exp(-s / d)` after s in the direction u, however long s is.
    """

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Those of the cable with the distance over which its friction yields, m, in place of the friction of guides."""
        plain = super().parameters(scene)
        return (*plain[:YIELD], Parameter("yield_m", "m", YIELD_M, 0.001, 0.3, 0.02), *plain[YIELD + 1 :])

    def rub(self, scene: Scene, F: Array, step: Array, theta: Array) -> Array:
        """(N, 3), N, the pull F (N, 3) with friction that holds."""
        past = scene.past("rubbing")
        start = np.zeros(3) if past.rows is None else past.rows[0]
        z = _yield(np.ascontiguousarray(step), theta[YIELD], start)
        past.rows = z[-1:].copy()
        return np.asarray(F * wind(step / scene.period, F, theta[10]) - theta[4] * z)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Those of the cable, with a usual distance."""
        found = super().starts(scene, residual)
        for start in found:
            start[YIELD] = YIELD_M
        return found

    def advice(self, scene: Scene, theta: Array) -> Message:
        """As for the cable without guides."""
        return super().advice(scene, np.where(np.arange(len(theta)) == YIELD, 0.0, theta))


@njit(cache=True)
def _yield(step: Array, distance: float, start: Array) -> Array:
    """(N, 3), z along a way of straight steps (N, 3), m, that begins at `start`."""
    out = np.empty_like(step)
    z = start.copy()
    for k in range(len(step)):
        x, y, up = step[k, 0], step[k, 1], step[k, 2]
        length = np.sqrt(x * x + y * y + up * up)
        kept = np.exp(-length / distance)
        for c in range(3):
            if length > 0.0:
                z[c] = kept * z[c] + (1.0 - kept) * step[k, c] / length
            out[k, c] = z[c]
    return out
