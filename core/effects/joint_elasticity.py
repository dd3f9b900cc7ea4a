"""The joints give under load, between the encoder and the link."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.deflection import LINEAR, Spring, deflection
from core.effects.effect import Effect, Parameter
from core.effects.joint_error import find_largest_joint, joint_count, rigid_load, true_motion, without_joints
from core.effects.rigid_body import wrench_change
from core.effects.scene import Scene
from core.words.message import Message


class JointElasticity(Effect):
    """True joints are `q + e` with `share M e'' + D e' + K e = -tau`, K = 1/C per joint: the links hang back behind the motors that hold
    them, and swing on their springs. tau and M are those of the rigid arm with its payload along the recorded motion of the motors; gears
    that shake the links by r'' ask `share M r''` besides.

    Spong, Modeling and control of elastic joint robots, 1987, with the motors' motion known. A share of 1 is the inertia by the URDF's
    masses, 0 a quasi-static arm, `e = -C tau`.
    """

    id = "joint_elasticity"
    title = Message.of("effect-joint-elasticity-title")
    stage = "kinematics"
    only_adds = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Compliance of each joint, rad/(N m), then the share of the inertia that swings and the damping ratio."""
        return (
            *(Parameter(f"joint_{j + 1}_rad_per_nm", "rad/(N m)", 0.0, 0.0, 1.0 / 500.0, 2e-4) for j in range(joint_count(scene))),
            Parameter("swinging_inertia_share", "1", 1.0, 0.0, 2.0, 0.3),
            Parameter("damping_ratio", "1", 0.1, 0.005, 1.0, 0.1),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus what the payload asks more with joints at `q + e`, e from `share M e'' + D e' + K e = -tau`."""
        n, past = joint_count(scene), scene.past("deflection")
        share, damping = theta[n : n + 2]
        load = rigid_load(scene)
        if scene.shaking is not None:
            load = load + share * np.einsum("nij,nj->ni", scene.joint_inertia, scene.shaking)
        error, acceleration = deflection(scene.joint_inertia, load, theta[:n], damping, scene.period, past, share, self.find_spring(theta))
        return w + wrench_change(scene, true_motion(scene, error, acceleration))

    def find_spring(self, theta: Array) -> Spring:
        """What the springs are beside their stiffness: nothing."""
        del theta
        return LINEAR

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Joints from stiff to soft with the inertia that is known, well damped so that a wrong frequency still points to the right one;
        and a quasi-static arm."""
        n = joint_count(scene)
        swinging = [np.concatenate((np.full(n, compliance), [1.0, 0.2])) for compliance in (1e-4, 2e-4, 4e-4, 8e-4)]
        return [*swinging, np.concatenate((np.full(n, 1e-4), [0.0, 0.2]))]

    def explain_lack(self, scene: Scene) -> Message | None:
        """A reason where the recording has no joint positions."""
        return without_joints(scene)

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises entering the stiffness in the twin: for the joint that gives most its stiffness, N m/rad, and deflection, deg."""
        most = np.abs(rigid_load(scene)).max(axis=0)
        j = find_largest_joint(theta[: len(most)] * most)
        if theta[j] <= 0:
            return Message.of("advice-joint-elasticity-rigid")
        return Message.of("advice-joint-elasticity", joint=j + 1, stiffness_nm_per_rad=1.0 / theta[j], give_rad=theta[j] * most[j])
