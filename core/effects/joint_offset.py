"""The zeros of the encoders are off."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.effects.effect import Effect, Parameter
from core.effects.joint_error import joint_count, largest, true_motion, without_joints
from core.effects.rigid_body import wrench_change
from core.effects.scene import Scene

Array = NDArray[np.float64]


class JointOffset(Effect):
    """True joints are `q + d`. A zero of the first joint about the vertical changes nothing; the prior keeps it at zero."""

    id = "joint_offset"
    title = "joint encoders whose zero is off"
    stage = "kinematics"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """See `Effect.parameters`."""
        return tuple(Parameter(f"joint_{j + 1}_rad", "rad", 0.0, -0.15, 0.15, 0.01) for j in range(joint_count(scene)))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """See `Effect.wrench`."""
        return w + wrench_change(scene, true_motion(scene, np.broadcast_to(theta, (len(scene), len(theta)))))

    def lacking(self, scene: Scene) -> str | None:
        """See `Effect.lacking`."""
        return without_joints(scene)

    def advice(self, scene: Scene, theta: Array) -> str:
        """See `Effect.advice`."""
        j = largest(theta)
        zeros = ", ".join(f"{x:+.2f}" for x in np.degrees(theta))
        return f"Calibrate the zero of joint {j + 1}, which is off by {np.degrees(theta[j]):+.2f} deg (all joints: {zeros} deg)."
