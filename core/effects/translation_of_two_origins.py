"""The sensor's torques are taken about points of their own, as where their bridges sit on different beams."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_translation import SensorTranslation
from core.words.message import Message


class TranslationOfTwoOrigins(SensorTranslation):
    """The true origin lies at d from the believed one, and each torque's is split along the other two axes: the torque about x is taken
    `s_z` above the origin, that about y as far below it. The torques' reading is `t + S f`, S symmetric with nothing on its diagonal."""

    wider_shape = True
    only_adds = False

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The true origin from the believed one (3), m, sensor axes, then half of what lies between the origins of two torques (3), m, by
        the axis along which it does."""
        return (*super().parameters(scene), *(Parameter(f"split_{axis}_m", "m", 0.0, -0.1, 0.1, 0.004) for axis in "xyz"))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`(f, t + S f)` of what the sensor carries with its origin at d."""
        W = super().wrench(scene, w, theta[:3])
        x, y, z = theta[3:]
        W[:, 3:] += W[:, :3] @ np.array([[0.0, z, y], [z, 0.0, x], [y, x, 0.0]])
        return W

    def explain_absence(self, scene: Scene) -> Message | None:
        """None: other than where the origin is, a split shows in what is static."""
        return None

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """One; all is nearly linear."""
        return [np.zeros(6)]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises another calibration of the sensor, mm between the origins that lie farthest apart, and the axis along which they do."""
        k = int(np.abs(theta[3:]).argmax())
        return Message.of("advice-sensor-translation-split", axis="xyz"[k], apart_m=2.0 * abs(theta[3 + k]))
