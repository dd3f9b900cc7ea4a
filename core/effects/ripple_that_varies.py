"""A ripple that is no sine and not the same all around: with an overtone, and stronger on one side of the turn."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.angle_wave import angle_wave
from core.effects.effect import Parameter
from core.effects.gear_ripple import GearRipple
from core.effects.joint_error import joint_count
from core.effects.scene import Scene
from core.effects.splines import smooth_by_splines
from core.effects.window_search import weights
from core.words.message import Message

SIGN = 0.02
"""Share of what a sine leaves that overtone and change around the turn explain, or there is no sign of them."""


class RippleThatVaries(GearRipple):
    """True joints are `q + (1 + u cos q + v sin q) (c cos x + s sin x + c' cos 2 x + s' sin 2 x)`, with `x = 2 N q`."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Of the plain one, then for each joint the overtone, rad, and how its size varies around the turn, shares."""
        return (
            *super().parameters(scene),
            *(
                parameter
                for j in range(joint_count(scene))
                for parameter in (
                    Parameter(f"joint_{j + 1}_overtone_cos_rad", "rad", 0.0, -0.005, 0.005, 5e-5),
                    Parameter(f"joint_{j + 1}_overtone_sin_rad", "rad", 0.0, -0.005, 0.005, 5e-5),
                    Parameter(f"joint_{j + 1}_turn_cos_share", "1", 0.0, -1.0, 1.0, 0.5),
                    Parameter(f"joint_{j + 1}_turn_sin_share", "1", 0.0, -1.0, 1.0, 0.5),
                )
            ),
        )

    def smaller_shape(self, scene: Scene) -> int:
        """A sine, the same all around."""
        return 3 * joint_count(scene)

    def find_errors(self, scene: Scene, theta: Array) -> tuple[Array, Array]:
        """(N, n) each, how far the joints run ahead, rad, and its second derivative, rad/s2."""
        n = joint_count(scene)
        ratio, cos, sin = theta[: 3 * n].reshape(-1, 3).T
        over_cos, over_sin, u, v = theta[3 * n :].reshape(-1, 4).T
        waves = []
        for order, c, s in ((2.0 * ratio, cos, sin), (4.0 * ratio, over_cos, over_sin)):
            # (u cos q + v sin q) (c cos x + s sin x) is one wave in x - q and one in x + q
            behind, ahead = (u * c + v * s, u * s - v * c), (u * c - v * s, u * s + v * c)
            waves += [(order, c, s), (order - 1, *np.divide(behind, 2.0)), (order + 1, *np.divide(ahead, 2.0))]
        return angle_wave(scene, *np.array(waves).transpose(1, 2, 0))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """None: it shows where a sine leaves something."""
        return []

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """The plain one, where what may vary explains enough of what it leaves."""
        start = np.concatenate((plain[: 3 * joint_count(scene)], np.zeros(4 * joint_count(scene))))
        steps = np.diag([p.scale for p in self.parameters(scene)])[3 * joint_count(scene) :]
        at_start = self.wrench(scene, scene.nominal, start)
        changes = (self.wrench(scene, scene.nominal, start + step) - at_start for step in steps)
        seen = [smooth_by_splines(change, scene.period, scene.residual_window) * weights(scene) for change in changes]
        columns = np.stack([change.ravel() for change in seen], axis=1)
        left = residual.ravel() - columns @ np.linalg.lstsq(columns, residual.ravel(), rcond=None)[0]
        return [start] if float(left @ left) < (1.0 - SIGN) * float(np.square(residual).sum()) else []

    def advice(self, scene: Scene, theta: Array) -> Message:
        """As of the plain one."""
        return super().advice(scene, theta[: 3 * joint_count(scene)])
