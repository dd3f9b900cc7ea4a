"""The sensor is turned, and rocks in its seat with the torque on it: bolts that have lost their grip."""

from __future__ import annotations

from itertools import product

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_rotation import SensorRotation
from core.payload.rotations import rotate_by
from core.words.message import Message

START_SHARE, START_RAD = 0.3, 1e-3
"""Of the rotation that is found, how far it rocks where fits start, and at least;"""
SEATED = (1.0, 5.0)
"""and of the largest torque the inverse share with which it is nearly there."""


class SensorThatRocks(SensorRotation):
    """`W = R(s tanh(g tau . e))^T w` with w as `SensorRotation` has it, tau its torque, e along s: by up to |s| to the one side or the
    other, the payload staying where it is."""

    wider_shape = True
    followed = 2
    only_adds = False  # it turns the noise, too

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The rotation vector (3), how far it rocks and about what (3), rad, sensor axes, and how soon it is at its end, 1/(N m)."""
        return (
            *super().parameters(scene),
            *(Parameter(f"slip_{axis}_rad", "rad", 0.0, -0.2, 0.2, 0.01) for axis in "xyz"),
            Parameter("grip_per_nm", "1/(N m)", 1.0, -300.0, 300.0, 5.0),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """The wrench in axes that rock."""
        w = super().wrench(scene, w, theta[:3])
        size = float(np.linalg.norm(theta[3:6]))
        if size == 0.0:
            return w
        back = np.outer(-np.tanh(theta[6] * (w[:, 3:] @ theta[3:6]) / size), theta[3:6])
        return np.hstack((rotate_by(back, w[:, :3]), rotate_by(back, w[:, 3:])))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """None: it shows where a sensor that is turned once leaves something."""
        return []

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """About the axis of the rotation that is found and about those of the sensor, with the torque or against it, soon and late."""
        size = float(np.linalg.norm(plain))
        axes = np.eye(3) if size == 0.0 else np.vstack((plain / size, np.eye(3)))
        torque = np.maximum(1e-6, np.abs(scene.nominal[:, 3:] @ axes.T).max(axis=0))
        slip = max(START_RAD, START_SHARE * size)
        tried = product(zip(axes, torque, strict=True), (1.0, -1.0), SEATED)
        return [np.array([*plain, *(slip * axis), way * seated / most]) for (axis, most), way, seated in tried]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises tightening the bolts: how far it rocks to either side, deg."""
        return Message.of("advice-sensor-rotation-rocks", slip_rad=float(np.linalg.norm(theta[3:6])))
