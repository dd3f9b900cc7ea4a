"""The zeros of the joints creep while the arm warms up: links grow, and encoders with them."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.joint_error import find_largest_joint, joint_count, true_motion
from core.effects.joint_offset import JointOffset
from core.effects.rigid_body import wrench_change
from core.effects.scene import Scene
from core.effects.sensor_drift import settling
from core.words.message import Message

RATES = (0.01, 0.05)
"""To start from, 1/s."""


class ZerosThatWarmUp(JointOffset):
    """True joints are `q + d + g (1 - exp(-k t)) / (1 - exp(-k 60 s))`: zeros that are off by d, and then settle with one rate."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The zero's error of each joint, its growth in the first minute, rad, and the settling rate, 1/s."""
        return (
            *(
                Parameter(f"joint_{j + 1}_{part}rad", "rad", 0.0, -0.15, 0.15, 0.01)
                for part in ("", "first_minute_")
                for j in range(joint_count(scene))
            ),
            Parameter("settling_rate_per_s", "1/s", 0.0, -0.02, 2.0, 0.03),
        )

    def smaller_shape(self, scene: Scene) -> int | None:
        """None: zeros that stay are the plain one."""
        return None

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus what the payload asks more with joints at these angles."""
        zero, growth = theta[:-1].reshape(2, -1)
        return w + wrench_change(scene, true_motion(scene, zero + settling(scene.elapsed, theta[-1])[:, None] * growth))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """None: it shows where zeros that stay leave something."""
        return []

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """Zeros that were half as far off at first, at some rates."""
        zero = plain[: joint_count(scene)]
        return [np.concatenate((0.5 * zero, 0.5 * zero, [rate])) for rate in RATES]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises warming the arm up, with the joint whose zero moves most over the run, deg."""
        seconds = float(scene.t[-1] - scene.t[0])
        moved = theta[:-1].reshape(2, -1)[1] * settling(np.array([seconds]), theta[-1])
        j = find_largest_joint(moved)
        return Message.of("advice-joint-offset-warming", joint=j + 1, change_rad=moved[j], within_s=seconds)
