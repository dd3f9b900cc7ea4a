"""The joints give under load, between the encoder and the link."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.effects.effect import Effect, Parameter
from core.effects.joint_error import joint_count, joint_torque, largest, true_motion, without_joints
from core.effects.rigid_body import wrench_change
from core.effects.scene import Scene

Array = NDArray[np.float64]


class JointElasticity(Effect):
    """True joints are `q - C tau`: the link hangs back behind the motor that holds it. C = 1/K per joint, tau as the joints exert it.

    Spong, Modeling and control of elastic joint robots, 1987, quasi-static.
    """

    id = "joint_elasticity"
    title = "joints that give under load"
    stage = "kinematics"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """See `Effect.parameters`."""
        return tuple(Parameter(f"joint_{j + 1}_rad_per_nm", "rad/(N m)", 0.0, 0.0, 1.0 / 500.0, 2e-4) for j in range(joint_count(scene)))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """See `Effect.wrench`."""
        return w + wrench_change(scene, true_motion(scene, -theta * joint_torque(scene)))

    def missing(self, scene: Scene) -> str | None:
        """See `Effect.missing`."""
        return without_joints(scene)

    def advice(self, scene: Scene, theta: Array) -> str:
        """See `Effect.advice`."""
        j = largest(theta * np.abs(joint_torque(scene)).max(axis=0))
        give = np.degrees(theta[j] * np.abs(joint_torque(scene)[:, j]).max())
        stiffness = f"{1e-3 / theta[j]:.1f} kN m/rad" if theta[j] > 0 else "rigid"
        return (
            f"Enter the joints' stiffness in the cell's twin (joint {j + 1}: {stiffness}, it gives by up to {give:.2f} deg), "
            "or use encoders on the link side."
        )
