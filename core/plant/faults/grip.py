"""Where something outside gets hold of the payload: real forces on its body."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.plant.faults.draws import direction, three
from core.plant.faults.fault import Machine, Three


def cross_vectors(a: Array, b: Array) -> Array:
    """(3,); numpy's own takes ten times as long."""
    ax, ay, az = a.tolist()
    bx, by, bz = b.tolist()
    return np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx])


class Grip:
    """A point of the payload that forces act on.

    Args:
        local: (3,), in the sensor frame, m.
    """

    def __init__(self, machine: Machine, local: Array) -> None:
        self._data, self._body, self._local = machine.data, machine.body("payload"), local
        self._period = machine.period
        self._last: Array | None = None

    def place(self) -> Array:
        """(3,), in the world frame, m."""
        data, body = self._data, self._body
        return np.asarray(data.xpos[body] + data.xmat[body].reshape(3, 3) @ self._local)

    def velocity(self, place: Array) -> Array:
        """(3,), m/s, from the difference to the place given last; zero the first time. To be asked once per period."""
        last, self._last = self._last, place
        return np.zeros(3) if last is None else (place - last) / self._period

    def push(self, place: Array, force: Array) -> None:
        """Applies a force (3,), world frame, N, at a place in the world."""
        data, body = self._data, self._body
        applied = data.xfrc_applied[body]
        applied[:3] += force
        applied[3:] += cross_vectors(place - data.xipos[body], force)


def grip_of(rng: np.random.Generator) -> Three:
    """Where it is fixed on the payload: 3 to 10 cm from the sensor."""
    return three(rng.uniform(0.03, 0.1) * direction(rng))
