"""The payload, or a part of it, slips once."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Effect, Parameter
from core.effects.rigid_body import centre_of_mass
from core.effects.scene import Scene
from core.effects.window_search import best_windows, onset_parameter_scale, ramp
from core.payload.inertia import regressor, six_of
from core.payload.rigid_wrench import wrench as rigid_wrench
from core.words.message import Message


class PayloadShift(Effect):
    """The first moment moves by d from t0 on, at once or evenly over a time.

    The inertia changes by `2 c.d 1 - c d^T - d c^T`, as if what slips were at the centre of mass c.
    """

    id = "payload_shift"
    title = Message.of("effect-payload-shift-title")
    stage = "payload"
    only_adds = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Time, s, change of the first moment (3), kg m, sensor axes, and how long it takes, s."""
        middle, begin, end, spread = onset_parameter_scale(scene)
        return (
            Parameter("at_s", "s", middle, begin, end, spread),
            *(Parameter(f"first_moment_{axis}_kgm", "kg m", 0.0, -0.5, 0.5, 0.02) for axis in "xyz"),
            Parameter("over_s", "s", 0.0, 0.0, 0.9 * (end - begin), 0.05 * (end - begin)),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus the wrench of the changes of first moment and inertia, ramped from 0 to 1."""
        d, c = theta[1:4], centre_of_mass(scene)
        inertia = 2.0 * (c @ d) * np.eye(3) - np.outer(c, d) - np.outer(d, c)
        change = np.concatenate(([0.0], d, six_of(inertia)))
        return w + ramp(scene.t, theta[0], theta[-1], scene.period)[:, None] * rigid_wrench(scene.motion, change)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The times at which a jump of the first moment explains most of the residual."""
        columns = regressor(scene.motion)[:, :, 1:4]
        found = best_windows(scene, residual, columns, 3, open_end=True)
        return [np.array([t0, 0.005, 0.005, 0.005, over]) for t0, _ in found for over in (0.0, 3.0)]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises clamping more firmly: time, s, change of first moment, kg mm, and for payloads above 10 g the way of the whole, mm."""
        d = float(np.linalg.norm(theta[1:4]))
        if scene.phi[0] > 0.01:
            return Message.of("advice-payload-shift-of-whole", at_s=theta[0], first_moment_kg_m=d, distance_m=d / scene.phi[0])
        return Message.of("advice-payload-shift", at_s=theta[0], first_moment_kg_m=d)
