"""Play in the joints whose side friction holds: the link stays where it leans until the load pushes it the other way."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.filters import play
from core.effects.joint_backlash import START_RAD, JointBacklash
from core.effects.joint_error import joint_count
from core.effects.scene import Scene


class PlayThatIsHeld(JointBacklash):
    """As `JointBacklash`, but what pushes is the load behind a play operator of radius tau_h: a load that goes to nothing leaves the link
    on its side, and one beyond tau_h takes it over."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Those of `JointBacklash`, then the torque up to which a side is held, N m."""
        return (*super().parameters(scene), Parameter("holding_torque_nm", "N m", 0.0, 0.0, 2.0, 0.5))

    def find_pushing_load(self, scene: Scene, load: Array, theta: Array) -> Array:
        """(N, n), N m, what the play operator lets through."""
        return play(load, np.full(load.shape[1], theta[-1]), scene.past("side"))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Held up to half a newton metre, crossed quickly and slowly."""
        half = np.full(joint_count(scene), START_RAD)
        return [np.append(half, (0.3, 0.01, crossing_s, 0.5)) for crossing_s in (0.01, 0.03)]
