"""Something touches the payload during a part of the run."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Effect, Parameter
from core.effects.scene import Scene
from core.effects.window_search import best_windows, onset_parameter_scale, weights
from core.payload.rotations import cross
from core.words.message import Message

LONGEST_S = 30.0
"""Of a touch."""
LONGEST_SHARE = 1.0 / 3.0
"""Of the run, likewise. What pushes for longer is no touch: a payload that has changed, or a base that warps."""
ARM = 0.3
"""m, to the farthest point of a payload that a search before a fit believes in."""


class ExternalContact(Effect):
    """A force f fixed in base axes acts on a point r of the payload within a window of time: the sensor reads `-f` and `-r x f`.

    What leans on a payload does so at a point, so there is no torque without a force. The window rises and falls by cosines (Tukey): taper
    0 is on and off at once, 1 a single bump, near half a sine.
    """

    id = "external_contact"
    title = Message.of("effect-external-contact-title")
    stage = "environment"
    only_adds = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Begin and duration, s, taper, force (3), N, base axes, and the point that it acts on (3), m, sensor axes."""
        middle, begin, end, spread = onset_parameter_scale(scene)
        longest = _longest(scene)
        return (
            Parameter("at_s", "s", middle, begin, end, spread),
            Parameter("duration_s", "s", min(2.0, 0.5 * longest), min(2.0 * scene.period, 0.5 * longest), longest, longest),
            Parameter("taper_share", "1", 0.5, 0.0, 1.0, 0.5),
            *(Parameter(f"force_{axis}_n", "N", 0.0, -100.0, 100.0, 5.0) for axis in "xyz"),
            *(Parameter(f"at_{axis}_m", "m", 0.0, -0.5, 0.5, 0.1) for axis in "xyz"),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` less the windowed force f in sensor axes and its moment `r x f`."""
        on = window(scene.t, theta[0], theta[1], theta[2], scene.period)[:, None]
        f = on * (theta[3:6] @ scene.rotation)
        return np.asarray(w - np.hstack([f, cross(theta[6:9], f)]))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The windows, at most four, in which a constant push explains most of the residual, with its direction and point."""
        columns = np.zeros((len(scene), 6, 6))
        columns[:, :3, :3] = scene.rotation.transpose(0, 2, 1)
        columns[:, 3:, 3:] = np.eye(3)
        found = best_windows(scene, residual, columns, 4, open_end=False, longest_s=_longest(scene))
        return [
            np.concatenate([[begin, min(end - begin, _longest(scene)), 0.3], _push(scene, residual, begin, end)]) for begin, end in found
        ]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises keeping the payload clear: force, N, begin and end of the contact, s."""
        force = float(np.linalg.norm(theta[3:6]))
        return Message.of("advice-external-contact", force_n=force, begin_s=theta[0], end_s=theta[0] + theta[1])


def _longest(scene: Scene) -> float:
    """s."""
    return min(LONGEST_S, LONGEST_SHARE * float(scene.t[-1] - scene.t[0]))


def _push(scene: Scene, residual: Array, begin: float, end: float) -> Array:
    """(6,): force of 1 N, base axes, and its point, m, that look most like the residual between two times."""
    on = (scene.t >= begin) & (scene.t <= end)
    if not on.any() or on.all():
        return np.array([0.5, 0.5, 0.5, 0.0, 0.0, 0.0])
    seen = -(residual[on] - residual[~on].mean(axis=0)) / weights(scene)
    force = np.einsum("nij,nj->i", scene.rotation[on], seen[:, :3]) / np.count_nonzero(on)
    f = force @ scene.rotation[on]
    columns = np.stack([cross(axis, f) for axis in np.eye(3)], axis=2)
    point = np.linalg.lstsq(columns.reshape(-1, 3), seen[:, 3:].ravel(), rcond=1e-2)[0]
    return np.concatenate([force / max(float(np.linalg.norm(force)), 1e-12), np.clip(point, -ARM, ARM)])


def window(t: Array, begin: float, duration: float, taper: float, period: float) -> Array:
    """(N,), Tukey window over [begin, begin + duration]; edges are at least two samples wide so that a fit can move them."""
    edge = np.hypot(0.5 * taper * duration, period)
    rise = np.clip((t - begin) / edge, 0.0, 1.0)
    fall = np.clip((begin + duration - t) / edge, 0.0, 1.0)
    return np.asarray(0.25 * (1.0 - np.cos(np.pi * rise)) * (1.0 - np.cos(np.pi * fall)))
