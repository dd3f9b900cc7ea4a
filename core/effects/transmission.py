"""What gears do between a motor and its link, which runs ahead of it or stays behind."""

from __future__ import annotations

from abc import abstractmethod

from core.array import Array
from core.effects.effect import Effect
from core.effects.joint_error import true_motion, without_joints
from core.effects.rigid_body import wrench_change
from core.effects.scene import Scene
from core.words.message import Message


class Transmission(Effect):
    """True joints are `q + r`; springs between gears and links bear `M r''` besides what the motors' motion asks of them."""

    stage = "kinematics"
    only_adds = True
    needs_motion = True

    @abstractmethod
    def find_errors(self, scene: Scene, theta: Array) -> tuple[Array, Array]:
        """(N, n) each, r, rad, and its second derivative, rad/s2."""

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus what the payload asks more with joints at `q + r`."""
        return w + wrench_change(scene, true_motion(scene, *self.find_errors(scene, theta)))

    def explain_lack(self, scene: Scene) -> Message | None:
        """A reason where the recording has no joint positions."""
        return without_joints(scene)
