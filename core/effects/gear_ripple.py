"""Transmission error of the gears: the link runs ahead and behind the motor, twice per turn of the wave generator."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.angle_wave import angle_wave
from core.effects.effect import Parameter
from core.effects.gear_search import COARSEST, FINEST, Peak, RippleSearch
from core.effects.joint_error import joint_count
from core.effects.scene import Scene
from core.effects.transmission import Transmission
from core.words.message import Message

SEARCHED_RAD = 3e-4
"""Size of the ripples from which a fit starts: from too small ones, it would jump to another ratio."""


class GearRipple(Transmission):
    """True joints are `q + c cos(2 N q) + s sin(2 N q)`, with a ratio N and c, s per joint: arms have gears of several sizes.

    Small as an angle; its second derivative is what shows, `(2 N dq)^2` times as large.
    """

    id = "gear_ripple"
    title = Message.of("effect-gear-ripple-title")

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """For each joint the gear ratio and the amplitudes of cosine and sine, rad."""
        return tuple(
            parameter
            for j in range(joint_count(scene))
            for parameter in (
                Parameter(f"joint_{j + 1}_gear_ratio", "1", 100.0, COARSEST, FINEST, 50.0),
                Parameter(f"joint_{j + 1}_cos_rad", "rad", 0.0, -0.005, 0.005, 1.5e-4),
                Parameter(f"joint_{j + 1}_sin_rad", "rad", 0.0, -0.005, 0.005, 1.5e-4),
            )
        )

    def find_errors(self, scene: Scene, theta: Array) -> tuple[Array, Array]:
        """(N, n) each, `c cos(2 N q) + s sin(2 N q)`, rad, and its second derivative, rad/s2."""
        ratio, c, s = theta.reshape(-1, 3).T
        return angle_wave(scene, 2.0 * ratio, c, s)

    def explain_absence(self, scene: Scene) -> Message | None:
        """A reason where there are no joints, or none moves faster than 1e-3 rad/s."""
        if reason := self.explain_lack(scene):
            return reason
        return None if scene.dq is not None and np.abs(scene.dq).max() > 1e-3 else Message.of("effect-no-joint-moves")

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Ratios at which the residual, divided by what an acceleration of each joint does to the wrench, is periodic in its angle."""
        return [_find_ripples(scene, residual)]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises another speed for the joint with the largest ripple: amplitude, arcmin, and waves per turn."""
        ratio, c, s = theta.reshape(-1, 3).T
        amplitude = np.hypot(c, s)
        j = int(np.argmax(amplitude))
        return Message.of("advice-gear-ripple", joint=j + 1, amplitude_rad=amplitude[j], per_turn=2 * ratio[j])


def _find_ripples(scene: Scene, residual: Array) -> Array:
    """Parameters (3 n,) by which the residual looks most like ripple: the joint that stands out most first, what it explains taken away
    before the next, and each once more when all others are known. The residual's unit is not known, so all are `SEARCHED_RAD` large."""
    searches = {j: search for j in range(joint_count(scene)) if (search := RippleSearch.of(scene, j)).moves}
    theta = np.tile([100.0, SEARCHED_RAD, 0.0], (joint_count(scene), 1))
    waves: dict[int, Array] = {}
    left = residual.copy()

    def take(j: int, peak: Peak) -> None:
        waves[j], phase = searches[j].wave(peak.ratio, left)
        left[:] -= waves[j]
        theta[j] = peak.ratio, *(SEARCHED_RAD * phase)

    while len(waves) < len(searches):
        peaks = {j: search.peak(left) for j, search in searches.items() if j not in waves}
        strongest = max(peaks, key=lambda j: peaks[j].power)
        take(strongest, peaks[strongest])
    for j in tuple(waves):
        left += waves[j]
        take(j, searches[j].peak(left))
    return theta.ravel()
