"""Something leans on the payload more and more, or lets go bit by bit, and turns its push meanwhile."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.external_contact import ExternalContact, window
from core.effects.scene import Scene
from core.payload.rotations import cross
from core.words.message import Message


class ContactThatChanges(ExternalContact):
    """As a contact, but the force goes on a straight line from one at the begin of the window to another at its end, base axes."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Those of a contact, the force in the middle of the window, then what it changes by from begin to end (3), N, base axes."""
        changes = (Parameter(f"force_change_{axis}_n", "N", 0.0, -100.0, 100.0, 5.0) for axis in "xyz")
        return (*super().parameters(scene), *changes)

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` less the force in sensor axes and its moment."""
        on = window(scene.t, theta[0], theta[1], theta[2], scene.period)[:, None]
        done = np.clip((scene.t - theta[0]) / max(theta[1], scene.period), 0.0, 1.0) - 0.5
        force = theta[3:6] + np.outer(done, theta[9:12])
        f = on * np.einsum("ni,nij->nj", force, scene.rotation)
        return np.asarray(w - np.hstack([f, cross(theta[6:9], f)]))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Pushes that stay as they are, with quick and slow edges."""
        pushes = super().starts(scene, residual)[:2]
        return [np.concatenate((push[:2], [taper], push[3:], np.zeros(3))) for push in pushes for taper in (0.05, 0.5)]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises keeping the payload clear: the larger force, N, of begin and end of the contact, s."""
        ends = theta[3:6] + np.outer([-0.5, 0.5], theta[9:12])
        force = float(np.linalg.norm(ends, axis=1).max())
        return Message.of("advice-external-contact", force_n=force, begin_s=theta[0], end_s=theta[0] + theta[1])
