"""Each joint is read with a lag of its own: drives that are asked one after the other, or that filter differently."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.filters import derivative
from core.effects.joint_error import find_largest_joint, joint_count, true_motion, without_joints
from core.effects.kinematic_lag import KinematicLag
from core.effects.rigid_body import wrench_change
from core.effects.scene import Scene
from core.words.message import Message


class LagOfEachJoint(KinematicLag):
    """True joints are `q + tau_j dq_j`, with a lag for each.

    Their mean acts as the lag of the whole, `w + tau dw/dt`, exactly; what each differs from it as an error of its joint.
    """

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """A lag for each joint, s."""
        return tuple(Parameter(f"joint_{j + 1}_lag_s", "s", 0.0, 0.0, 0.1, 0.015) for j in range(joint_count(scene)))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w + mean(tau) dw/dt`, plus what the payload asks more with joints at `q + (tau - mean(tau)) dq`."""
        if scene.dq is None:
            raise ValueError("lags of joints need a scene with joints (see Effect.explain_lack)")
        mean = theta.mean(keepdims=True)
        ddq = derivative(scene.dq, scene.period, scene.past("dq of lags"))
        dddq = derivative(ddq, scene.period, scene.past("ddq of lags"))
        apart = theta - mean
        true = true_motion(scene, apart * scene.dq, apart * dddq, apart * ddq)
        return super().wrench(scene, w, mean) + wrench_change(scene, true)

    def explain_lack(self, scene: Scene) -> Message | None:
        """A reason where the recording has no joint positions."""
        return without_joints(scene)

    def explain_absence(self, scene: Scene) -> Message | None:
        """A reason where there are no joints, or the sensor stays still."""
        return self.explain_lack(scene) or super().explain_absence(scene)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """None: it shows where one lag for all leaves something."""
        return []

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """The lag of the whole, in each joint."""
        return [np.full(joint_count(scene), float(plain[0]))]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises reading all joints at one instant: the largest lag, its joint, and the smallest, s."""
        j = find_largest_joint(theta)
        return Message.of("advice-kinematic-lag-joints", joint=j + 1, lag_s=theta[j], least_s=theta.min())
