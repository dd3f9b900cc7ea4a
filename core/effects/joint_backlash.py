"""Play in the joints: the link leans to the side to which the load pushes it."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.filters import derivative, low_pass
from core.effects.joint_error import find_largest_joint, joint_count, joint_torque
from core.effects.scene import Scene
from core.effects.splines import smooth_by_splines
from core.effects.transmission import Transmission
from core.words.message import Message

CONTACT_TORQUE = 1.0
"""N m, at which the teeth are about in contact on one side."""
START_RAD = 1.5e-4
"""Half the play of every joint, from which fits start."""
AT_ONCE_S = 0.001
"""Crossing that takes no time."""


class JointBacklash(Transmission):
    """True joints are `q - b s`, with b half the play per joint and s the side to which it leans, -1 to 1: `tanh(tau / tau_c)`, tau as the
    joints exert it, behind a lag; and it takes a while to cross (two equal lags).

    Small as an angle; where the load changes its side, its second derivative shows more than the angle.
    """

    id = "joint_backlash"
    title = Message.of("effect-joint-backlash-title")

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Half the play of each joint, rad, then the contact torque, N m, the lag of the load, s, and that of the side, s."""
        return (
            *(Parameter(f"joint_{j + 1}_rad", "rad", 0.0, 0.0, 0.01, 5e-4) for j in range(joint_count(scene))),
            Parameter("contact_torque_nm", "N m", CONTACT_TORQUE, 0.1, 3.0, 1.0),
            Parameter("lag_s", "s", 0.02, 0.003, 0.1, 0.02),
            Parameter("crossing_s", "s", AT_ONCE_S, AT_ONCE_S, 0.1, 0.02),
        )

    def find_errors(self, scene: Scene, theta: Array) -> tuple[Array, Array]:
        """(N, n) each, `-b s`, rad, averaged as the scene's windows show it, and its second derivative, rad/s2."""
        n = joint_count(scene)
        contact_torque, lag, crossing = theta[n : n + 3]
        load = low_pass(joint_torque(scene), lag, scene.period, scene.past("load"))
        side = np.tanh(self.find_pushing_load(scene, load, theta) / contact_torque)
        for stage in ("crosses", "arrives"):
            side = low_pass(side, crossing, scene.period, scene.past(stage))
        error = smooth_by_splines(-theta[:n] * side, scene.period, scene.window)
        rate = derivative(error, scene.period, scene.past("error"))
        return error, derivative(rate, scene.period, scene.past("rate"))

    def find_pushing_load(self, scene: Scene, load: Array, theta: Array) -> Array:
        """(N, n), N m, by which a joint is pushed to a side; here all of its load."""
        del scene, theta
        return load

    def explain_absence(self, scene: Scene) -> Message | None:
        """A reason where there are no joints, or no joint's load goes from below -1 N m to above 1 N m."""
        if reason := self.explain_lack(scene):
            return reason
        tau = joint_torque(scene)
        reversed_ = (tau.min(axis=0) < -CONTACT_TORQUE) & (tau.max(axis=0) > CONTACT_TORQUE)
        return None if reversed_.any() else Message.of("effect-no-load-reverses")

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Light and heavy contact, quick and slow, and one that is crossed slowly."""
        half = np.full(joint_count(scene), START_RAD)
        shapes = [(torque, lag, AT_ONCE_S) for torque in (0.5, 1.5) for lag in (0.01, 0.03)]
        return [np.append(half, shape) for shape in (*shapes, (1.5, 0.01, 0.03))]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises adjusting the gear with most play, deg from side to side."""
        j = find_largest_joint(theta[: joint_count(scene)])
        return Message.of("advice-joint-backlash", joint=j + 1, play_rad=2 * theta[j])
