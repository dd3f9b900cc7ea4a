"""Something touches the payload during a part of the run."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.effects.effect import Effect, Parameter
from core.effects.scene import Scene
from core.effects.window_search import best_windows, onset_parameter_scale

Array = NDArray[np.float64]


class ExternalContact(Effect):
    """A force fixed in base axes and a torque in sensor axes (about the sensor origin) act on the payload within a window of time.

    The window rises and falls by cosines (Tukey): taper 0 is on and off at once, 1 a single bump, near half a sine. The sensor reads the
    opposite.
    """

    id = "external_contact"
    title = "a contact during part of the run"
    stage = "environment"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """See `Effect.parameters`."""
        middle, begin, end, spread = onset_parameter_scale(scene)
        return (
            Parameter("at_s", "s", middle, begin, end, spread),
            Parameter("duration_s", "s", min(2.0, 0.5 * (end - begin)), 2.0 * scene.period, end - begin, 0.3 * (end - begin)),
            Parameter("taper_share", "1", 0.5, 0.0, 1.0, 0.5),
            *(Parameter(f"force_{axis}_n", "N", 0.0, -100.0, 100.0, 5.0) for axis in "xyz"),
            *(Parameter(f"torque_{axis}_nm", "N m", 0.0, -20.0, 20.0, 0.5) for axis in "xyz"),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """See `Effect.wrench`."""
        on = window(scene.t, theta[0], theta[1], theta[2], scene.period)[:, None]
        push = np.hstack([theta[3:6] @ scene.rotation, np.broadcast_to(theta[6:9], (len(scene), 3))])
        return w - on * push

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The windows in which a constant push explains most of the residual."""
        columns = np.zeros((len(scene), 6, 6))
        columns[:, :3, :3] = scene.rotation.transpose(0, 2, 1)
        columns[:, 3:, 3:] = np.eye(3)
        found = best_windows(scene, residual, columns, 3, open_end=False)
        return [np.array([b, e - b, 0.3, *([0.5] * 3), *([0.02] * 3)]) for b, e in found]

    def advice(self, scene: Scene, theta: Array) -> str:
        """See `Effect.advice`."""
        force = float(np.linalg.norm(theta[3:6]))
        return (
            f"Keep the payload clear: something pushed it with up to {force:.1f} N from {theta[0]:.1f} to {theta[0] + theta[1]:.1f} s; "
            "leave that part out or run again."
        )


def window(t: Array, begin: float, duration: float, taper: float, period: float) -> Array:
    """(N,), Tukey window over [begin, begin + duration]; edges are at least two samples wide so that a fit can move them."""
    edge = np.hypot(0.5 * taper * duration, period)
    rise = np.clip((t - begin) / edge, 0.0, 1.0)
    fall = np.clip((begin + duration - t) / edge, 0.0, 1.0)
    return np.asarray(0.25 * (1.0 - np.cos(np.pi * rise)) * (1.0 - np.cos(np.pi * fall)))
