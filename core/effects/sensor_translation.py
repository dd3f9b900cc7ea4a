"""The sensor's origin is not where the kinematics believe."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Effect, Parameter
from core.effects.rigid_body import wrench_change
from core.effects.scene import Scene
from core.effects.vectors import find_specific_force
from core.payload.inertia import Motion
from core.words.message import Message


class SensorTranslation(Effect):
    """The true origin lies at d (sensor axes) from the believed one: `a + alpha x d + omega x (omega x d)`. Nothing static shows it."""

    id = "sensor_translation"
    title = Message.of("effect-sensor-translation-title")
    stage = "mounting"
    only_adds = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The true origin from the believed one (3), m, sensor axes."""
        return tuple(Parameter(f"{axis}_m", "m", 0.0, -0.1, 0.1, 0.004) for axis in "xyz")

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus what the payload asks more under `a + alpha x d + omega x (omega x d)`."""
        m = scene.motion
        a = find_specific_force(m, theta) + m.g
        return w + wrench_change(scene, Motion(m.g, a, m.omega, m.alpha))

    def explain_absence(self, scene: Scene) -> Message | None:
        """A reason where the sensor does not turn."""
        return None if np.any(scene.motion.omega) else Message.of("effect-nothing-turns")

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises moving the sensor frame in the URDF, mm."""
        x, y, z = theta
        return Message.of("advice-sensor-translation", x_m=x, y_m=y, z_m=z)
