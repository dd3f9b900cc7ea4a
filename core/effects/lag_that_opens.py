"""Joints smoothed by a filter that opens with their speed (Casiez et al., 1 euro filter, 2012): the slower one turns, the later it is."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.filters import derivative, low_pass
from core.effects.joint_error import true_motion
from core.effects.lag_of_each_joint import LagOfEachJoint
from core.effects.rigid_body import wrench_change
from core.effects.scene import Scene
from core.words.message import Message

STARTS = ((1.5, 1.0), (3.0, 0.3))
"""Lag at rest, in lags that one for all speeds has, and the speed that halves it, rad/s."""
SMOOTHING_S = 0.05


class LagThatOpens(LagOfEachJoint):
    """True joints are `q + tau_j dq_j`, `tau_j = tau / (1 + v_j / v)`, with v_j the smoothed speed of the joint: the corner of the filter
    rises with it."""

    only_adds = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Lag at rest, s, speed that halves it, rad/s, and time constant of the speed, s."""
        return (
            Parameter("lag_at_rest_s", "s", 0.0, 0.0, 0.3, 0.03),
            Parameter("halving_speed_rad_per_s", "rad/s", 1.0, 0.02, 20.0, 1.0),
            Parameter("smoothing_s", "s", SMOOTHING_S, 0.01, 0.5, 0.1),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus what the payload asks more with joints at `q + tau_j dq_j`."""
        if scene.dq is None:
            raise ValueError("lags of joints need a scene with joints (see Effect.explain_lack)")
        speed = low_pass(np.abs(scene.dq), theta[2], scene.period, scene.past("speed of lags"))
        ahead = theta[0] / (1.0 + speed / theta[1]) * scene.dq
        rate = derivative(ahead, scene.period, scene.past("ahead"))
        return w + wrench_change(scene, true_motion(scene, ahead, derivative(rate, scene.period, scene.past("rate ahead")), rate))

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """A longer lag at rest, halved soon or late."""
        return [np.array([min(times * float(plain[0]), 0.3), speed, SMOOTHING_S]) for times, speed in STARTS]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises raw joint positions: how late they are at rest, s, and from which speed on half of that, rad/s."""
        return Message.of("advice-kinematic-lag-opens", lag_s=theta[0], speed_rad_s=theta[1])
