"""A hose or cable pulls at the payload."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.effects.effect import Effect, Parameter
from core.effects.rigid_body import cross
from core.effects.scene import Scene

Array = NDArray[np.float64]

CREEP = 0.003
"""m/s, speed at which two thirds of the Coulomb friction act."""


class CableDrag(Effect):
    """A spring to a fixed point and Coulomb friction act on the payload at r: `F = c - k (p - p_0) - mu v / sqrt(v^2 + v_c^2)`, base axes.

    c is the pull in the first sample (so the fixed point is `p_0 + c / k`); p and v are of the point r, sensor axes.
    The sensor reads `-F` and `-r x F`.
    """

    id = "cable_drag"
    title = "a hose or cable that pulls"
    stage = "environment"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """See `Effect.parameters`."""
        return (
            Parameter("stiffness_n_per_m", "N/m", 0.0, -5.0, 100.0, 5.0),
            *(Parameter(f"pull_{axis}_n", "N", 0.0, -50.0, 50.0, 3.0) for axis in "xyz"),
            Parameter("friction_n", "N", 0.0, -1.0, 10.0, 0.5),
            *(Parameter(f"at_{axis}_m", "m", 0.0, -0.5, 0.5, 0.1) for axis in "xyz"),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """See `Effect.wrench`."""
        if scene.position is None:
            raise ValueError("cable drag needs a scene with positions (see Effect.missing)")
        r = theta[5:8]
        p = scene.position + scene.rotation @ r
        v = np.diff(p, axis=0, prepend=p[:1]) / scene.period
        F = theta[1:4] - theta[0] * (p - p[0]) - theta[4] * v / np.sqrt(np.sum(v * v, axis=1, keepdims=True) + CREEP**2)
        f = np.einsum("ni,nij->nj", F, scene.rotation)
        return np.asarray(w - np.hstack([f, cross(np.broadcast_to(r, f.shape), f)]))

    def missing(self, scene: Scene) -> str | None:
        """See `Effect.missing`."""
        if scene.position is None:
            return "the recording does not say where the sensor is"
        return None if np.ptp(scene.position, axis=0).max() > 0.01 else "the sensor stays in one place"

    def advice(self, scene: Scene, theta: Array) -> str:
        """See `Effect.advice`."""
        pull = float(np.linalg.norm(theta[1:4]))
        return (
            f"Free the hose or cable: it pulls with {pull:.1f} N at the start, changes by {theta[0]:.1f} N per metre "
            f"and rubs with {theta[4]:.1f} N."
        )
