"""The payload gains or loses mass once: something falls off, drips, or is put on."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Effect, Parameter
from core.effects.scene import Scene
from core.effects.window_search import best_windows, onset_parameter_scale, ramp
from core.payload.inertia import regressor, six_of
from core.payload.rigid_wrench import wrench as rigid_wrench
from core.words.message import Message


class PayloadMassChange(Effect):
    """From t0 on there is a mass more (or less) at the point r, sensor axes: `phi + m [1, r, r.r 1 - r r^T]`.

    It comes or goes at once, or evenly over a time (a leak).
    """

    id = "payload_mass_change"
    title = Message.of("effect-payload-mass-change-title")
    stage = "payload"
    followed = 4
    only_adds = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Time, s, mass, kg, its place (3), m, sensor axes, and how long it takes to come or go, s."""
        middle, begin, end, spread = onset_parameter_scale(scene)
        return (
            Parameter("at_s", "s", middle, begin, end, spread),
            Parameter("mass_kg", "kg", 0.0, -5.0, 5.0, 0.15),
            *(Parameter(f"place_{axis}_m", "m", 0.0, -0.5, 0.5, 0.1) for axis in "xyz"),
            Parameter("over_s", "s", 0.0, 0.0, 0.9 * (end - begin), 0.2 * (end - begin)),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus the wrench of a point mass at r, ramped from 0 to 1."""
        r = theta[2:5]
        change = theta[1] * np.concatenate(([1.0], r, six_of(r @ r * np.eye(3) - np.outer(r, r))))
        return w + ramp(scene.t, theta[0], theta[-1], scene.period)[:, None] * rigid_wrench(scene.motion, change)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The times at which a jump of mass and first moment explains most of the residual, gained and lost."""
        columns = regressor(scene.motion)[:, :, :4]
        times = [t0 for t0, _ in best_windows(scene, residual, columns, 2, open_end=True)]
        return [np.array([t0, m, 0.0, 0.0, 0.05, over]) for t0 in times for m in (-0.05, 0.05) for over in (0.0, 5.0)]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises checking the payload: time, s, mass gained or lost, g, and its place, mm."""
        at_s, mass_kg, x, y, z = theta[:5]
        if mass_kg > 0:
            return Message.of("advice-payload-mass-gained", at_s=at_s, mass_kg=mass_kg, x_m=x, y_m=y, z_m=z)
        return Message.of("advice-payload-mass-lost", at_s=at_s, mass_kg=-mass_kg, x_m=x, y_m=y, z_m=z)
