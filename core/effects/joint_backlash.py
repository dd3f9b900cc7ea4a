"""Play in the joints: the link leans to the side to which the load pushes it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.effects.effect import Effect, Parameter
from core.effects.joint_error import joint_count, joint_torque, largest, true_motion, without_joints
from core.effects.rigid_body import wrench_change
from core.effects.scene import Scene

Array = NDArray[np.float64]

CONTACT_TORQUE = 0.5
"""N m, at which the teeth are surely in contact on one side."""


class JointBacklash(Effect):
    """True joints are `q - b tanh(tau / tau_c)`, with b half the play per joint and tau as the joints exert it."""

    id = "joint_backlash"
    title = "play in the joints"
    stage = "kinematics"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """See `Effect.parameters`."""
        return tuple(Parameter(f"joint_{j + 1}_rad", "rad", 0.0, 0.0, 0.01, 5e-4) for j in range(joint_count(scene)))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """See `Effect.wrench`."""
        return w + wrench_change(scene, true_motion(scene, -theta * np.tanh(joint_torque(scene) / CONTACT_TORQUE)))

    def lacking(self, scene: Scene) -> str | None:
        """See `Effect.lacking`."""
        return without_joints(scene)

    def missing(self, scene: Scene) -> str | None:
        """See `Effect.missing`."""
        if reason := self.lacking(scene):
            return reason
        tau = joint_torque(scene)
        reversed_ = (tau.min(axis=0) < -CONTACT_TORQUE) & (tau.max(axis=0) > CONTACT_TORQUE)
        return None if reversed_.any() else "no joint's load changes its side: play looks like an offset of the encoder"

    def advice(self, scene: Scene, theta: Array) -> str:
        """See `Effect.advice`."""
        j = largest(theta)
        return f"Have the gear of joint {j + 1} adjusted: it has {2 * np.degrees(theta[j]):.3f} deg of play from side to side."
