"""Transmission error of the gears: the link runs ahead and behind the motor, twice per turn of the wave generator."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from core.effects.effect import Effect, Parameter
from core.effects.joint_error import joint_count, true_motion, without_joints
from core.effects.rigid_body import wrench_change
from core.effects.scene import Scene
from core.effects.window_search import weights

Array = NDArray[np.float64]

FINEST = 200.0
"""Highest gear ratio looked for."""


class GearRipple(Effect):
    """True joints are `q + c cos(2 N q) + s sin(2 N q)`, with one ratio N and c, s per joint.

    Small as an angle; its second derivative is what shows, `(2 N dq)^2` times as large. Ripple that is too fast for the rate of the samples
    is faded out, as the filter before the sampling does.
    """

    id = "gear_ripple"
    title = "ripple of the gears"
    stage = "kinematics"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """See `Effect.parameters`."""
        amplitudes = [
            Parameter(f"joint_{j + 1}_{part}_rad", "rad", 0.0, -0.005, 0.005, 1.5e-4)
            for j in range(joint_count(scene))
            for part in ("cos", "sin")
        ]
        return (Parameter("gear_ratio", "1", 100.0, 0.5, FINEST, 50.0), *amplitudes)

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """See `Effect.wrench`."""
        if scene.q is None or scene.dq is None:
            raise ValueError("gear ripple needs a scene with joints (see Effect.lacking)")
        q, dq = scene.past("ripple q").before(scene.q, 1), scene.past("ripple dq").before(scene.dq, 1)
        error, acceleration = _ripple(q, dq, 2.0 * theta[0], theta[1::2].copy(), theta[2::2].copy(), scene.period)
        return w + wrench_change(scene, true_motion(scene, error[-len(w) :], acceleration[-len(w) :]))

    def lacking(self, scene: Scene) -> str | None:
        """See `Effect.lacking`."""
        return without_joints(scene)

    def missing(self, scene: Scene) -> str | None:
        """See `Effect.missing`."""
        if reason := self.lacking(scene):
            return reason
        return None if scene.dq is not None and np.abs(scene.dq).max() > 1e-3 else "no joint moves in this recording"

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Ratios at which the residual, divided by what an acceleration of each joint does to the wrench, is periodic in its angle."""
        size = np.array([p.scale for p in self.parameters(scene)])
        return [np.concatenate(([ratio], 0.3 * size[1:])) for ratio in _ratios(scene, residual)]

    def advice(self, scene: Scene, theta: Array) -> str:
        """See `Effect.advice`."""
        amplitude = np.hypot(theta[1::2], theta[2::2])
        j = int(np.argmax(amplitude))
        return (
            f"Turn joint {j + 1} at another speed while measuring: its gear errs by {60 * np.degrees(amplitude[j]):.2f} arcmin "
            f"{2 * theta[0]:.0f} times per turn."
        )


@njit(cache=True)
def _ripple(q: Array, dq: Array, order: float, c: Array, s: Array, period: float) -> tuple[Array, Array]:
    """`c cos(order q) + s sin(order q)`, faded out near the highest frequency that the samples show, and its second derivative."""
    N, n = q.shape
    error = np.empty((N, n))
    acceleration = np.empty((N, n))
    fastest = 0.8 * np.pi / period
    for k in range(N):
        for j in range(n):
            rate = order * dq[k, j]
            growth = order * (dq[k, j] - dq[max(k - 1, 0), j]) / period
            x = (rate / fastest) ** 2
            visible = 1.0 / (1.0 + x * x * x * x)
            cos, sin = visible * np.cos(order * q[k, j]), visible * np.sin(order * q[k, j])
            error[k, j] = c[j] * cos + s[j] * sin
            acceleration[k, j] = growth * (s[j] * cos - c[j] * sin) - rate * rate * error[k, j]
    return error, acceleration


def _ratios(scene: Scene, residual: Array, count: int = 4) -> list[float]:
    """Gear ratios at which the periodogram over the joint's angle stands out, most prominent first."""
    if scene.q is None or scene.dq is None or scene.jacobian is None:
        return [100.0]
    per_rad = 8.0 * 2.0 * FINEST / (2.0 * np.pi)  # bins, eight per shortest cycle
    size = 1 << int(np.ceil(np.log2(2.0 * np.ptp(scene.q, axis=0).max() * per_rad + 2.0)))
    ratio = np.fft.rfftfreq(size, 1.0 / per_rad) * np.pi  # from cycles per rad: 2 N = 2 pi f
    power = np.zeros(len(ratio))
    m, mc = scene.phi[0], scene.phi[1:4]
    r = residual * weights(scene)
    for j in range(scene.q.shape[1]):
        linear, angular = scene.jacobian[:, :3, j], scene.jacobian[:, 3:, j]
        response = np.hstack([m * linear + np.cross(angular, mc), np.cross(mc, linear)]) * scene.dq[:, j, None] ** 2
        response[:, 3:] += angular * np.abs(scene.phi[[4, 7, 9]]) * scene.dq[:, j, None] ** 2
        energy = float(np.sum((response * weights(scene)) ** 2))
        if energy <= 0.0:
            continue
        bins = ((scene.q[:, j] - scene.q[:, j].min()) * per_rad).astype(int)
        series = np.bincount(bins, np.sum(response * r, axis=1), minlength=size)
        power += np.abs(np.fft.rfft(series)) ** 2 / energy
    power[(ratio < 5.0) | (ratio > FINEST)] = 0.0
    inner = np.arange(1, len(power) - 1)
    peaks = inner[(power[inner] >= power[inner - 1]) & (power[inner] > power[inner + 1])]
    best = [float(ratio[i]) for i in peaks[np.argsort(-power[peaks])][:count]]
    return best or [100.0]
