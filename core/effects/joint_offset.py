"""The zeros of the encoders are off."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.angle_wave import angle_wave
from core.effects.effect import Effect, Parameter
from core.effects.joint_error import find_largest_joint, joint_count, true_motion, without_joints
from core.effects.rigid_body import wrench_change
from core.effects.scene import Scene
from core.words.message import Message


class JointOffset(Effect):
    """True joints are `q + d + c cos(q) + s sin(q)`: a zero that is off, and a disc that is not centred.

    A zero of the first joint about the vertical changes nothing; the prior keeps it at zero.
    """

    id = "joint_offset"
    title = Message.of("effect-joint-offset-title")
    stage = "kinematics"
    only_adds = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The zero's errors of all joints, then all amplitudes of cosine, then all of sine, rad."""
        return tuple(
            Parameter(f"joint_{j + 1}_{part}", "rad", 0.0, -0.15, 0.15, scale)
            for part, scale in (("rad", 0.01), ("cos_rad", 0.005), ("sin_rad", 0.005))
            for j in range(joint_count(scene))
        )

    def smaller_shape(self, scene: Scene) -> int | None:
        """The zeros without waves."""
        return joint_count(scene)

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus what the payload asks more with joints at `q + d + c cos(q) + s sin(q)`."""
        zero, c, s = theta.reshape(3, -1)
        error, acceleration = angle_wave(scene, np.ones(len(zero)), c, s)
        return w + wrench_change(scene, true_motion(scene, zero + error, acceleration))

    def explain_lack(self, scene: Scene) -> Message | None:
        """A reason where the recording has no joint positions."""
        return without_joints(scene)

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises centring the worst encoder where its wave exceeds all zeros' errors, else calibrating the worst zero; errors in deg."""
        zero, *wave = theta.reshape(3, -1)
        uneven = np.hypot(*wave)
        k = find_largest_joint(uneven)
        if uneven[k] > np.abs(zero).max():
            return Message.of("advice-joint-offset-uneven", joint=k + 1, error_rad=uneven[k])
        j = find_largest_joint(zero)
        zeros = [Message.of("effect-angle", angle_rad=x) for x in zero]
        return Message.of("advice-joint-offset", joint=j + 1, error_rad=zero[j], zeros=zeros)
