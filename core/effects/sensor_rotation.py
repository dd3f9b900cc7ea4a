"""The sensor is mounted turned against what the kinematics believe."""

from __future__ import annotations

from core.array import Array
from core.effects.effect import Effect, Parameter
from core.effects.rigid_body import wrench_change
from core.effects.scene import Scene
from core.payload.inertia import Motion
from core.payload.rotations import rotation_of
from core.words.message import Message


class SensorRotation(Effect):
    """The true sensor axes stand turned by the constant rotation vector theta (in sensor axes) against the believed ones.

    Gravity and motion reach the sensor turned, `W = V(R(theta)^T motion) phi`; the payload's parameters are those in the true axes.
    """

    id = "sensor_rotation"
    title = Message.of("effect-sensor-rotation-title")
    stage = "mounting"
    only_adds = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The rotation vector (3), rad, sensor axes."""
        return tuple(Parameter(f"about_{axis}_rad", "rad", 0.0, -0.3, 0.3, 0.02) for axis in "xyz")

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus what the payload asks more with gravity and motion seen from axes turned by R(theta)."""
        R, m = rotation_of(theta), scene.motion
        return w + wrench_change(scene, Motion(m.g @ R, m.a @ R, m.omega @ R, m.alpha @ R))

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises turning the sensor frame in the URDF, deg, or remounting the sensor."""
        x, y, z = theta
        return Message.of("advice-sensor-rotation", x_rad=x, y_rad=y, z_rad=z)
