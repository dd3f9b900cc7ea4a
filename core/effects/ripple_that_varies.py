"""Transmission error that is stronger on one side of the turn and no sine: an eccentric wave generator, uneven teeth."""

from __future__ import annotations

from typing import NamedTuple, Self

import numpy as np

from core.array import Array
from core.effects.angle_wave import angle_waves
from core.effects.effect import Parameter
from core.effects.gear_ripple import SEARCHED_RAD, GearRipple
from core.effects.gear_search import COARSEST, RippleSearch
from core.effects.joint_error import joint_count, true_motion
from core.effects.rigid_body import wrench_change
from core.effects.scene import Scene
from core.words.message import Message

STANDS_OUT = 0.5
"""Share of the highest peak of all joints."""


class _Ripple(NamedTuple):
    """(n,) each: gear ratio N; amplitudes at 2 N waves per turn and at twice as many, rad; how the strength varies over the turn."""

    ratio: Array
    c: Array
    s: Array
    twice_c: Array
    twice_s: Array
    vary_c: Array
    vary_s: Array

    @classmethod
    def of(cls, theta: Array) -> Self:
        """Of the parameters (7 n,): those of the plain ripple, then the others joint by joint."""
        n = len(theta) // 7
        return cls(*theta[: 3 * n].reshape(n, 3).T, *theta[3 * n :].reshape(n, 4).T)


class RippleThatVaries(GearRipple):
    """True joints are `q + (1 + a cos q + b sin q) (c cos(2 N q) + s sin(2 N q) + c' cos(4 N q) + s' sin(4 N q))`."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Those of the plain ripple, then for each joint c' and s', rad, a and b, shares."""
        return (
            *super().parameters(scene),
            *(
                parameter
                for j in range(joint_count(scene))
                for parameter in (
                    Parameter(f"joint_{j + 1}_second_harmonic_cos_rad", "rad", 0.0, -0.005, 0.005, 1.0e-4),
                    Parameter(f"joint_{j + 1}_second_harmonic_sin_rad", "rad", 0.0, -0.005, 0.005, 1.0e-4),
                    Parameter(f"joint_{j + 1}_over_the_turn_cos_share", "1", 0.0, -1.0, 1.0, 0.3),
                    Parameter(f"joint_{j + 1}_over_the_turn_sin_share", "1", 0.0, -1.0, 1.0, 0.3),
                )
            ),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus what the payload asks more with such joints: a product of waves is waves of the sums and differences of their orders."""
        r = _Ripple.of(theta)
        waves = [_vary(2.0 * r.ratio, r.c, r.s, r), _vary(4.0 * r.ratio, r.twice_c, r.twice_s, r)]
        orders, c, s = (np.concatenate([wave[k] for wave in waves]) for k in range(3))
        return w + wrench_change(scene, true_motion(scene, *angle_waves(scene, orders, c, s)))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """None: it shows where a plain ripple leaves something."""
        return []

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """The plain ripple as the first wave, and as the second; and with the ratios that the residual has where it stands out most."""
        ripple = plain.reshape(-1, 3)
        rest, second, twice = np.zeros((len(ripple), 4)), ripple.copy(), np.zeros((len(ripple), 4))
        halved = ripple[:, 0] >= 2.0 * COARSEST
        second[halved] *= [0.5, 0.0, 0.0]
        twice[halved, :2] = ripple[halved, 1:]
        shapes = [(ripple, rest), (second, twice), (_search_again(scene, residual, ripple), rest)]
        return [np.concatenate((first.ravel(), further.ravel())) for first, further in shapes]

    def explain_tie_to_run(self, scene: Scene) -> Message | None:
        """Twins keep a ripple that is the same all round."""
        return Message.of("effect-shape-of-run")

    def advice(self, scene: Scene, theta: Array) -> Message:
        """As of the plain one, by its first wave."""
        return super().advice(scene, theta[: 3 * joint_count(scene)])


def _search_again(scene: Scene, residual: Array, ripple: Array) -> Array:
    """(n, 3), a ripple with what is periodic in its residual instead, in the joints that stand out: there it had another ratio."""
    searches = [RippleSearch.of(scene, j) for j in range(len(ripple))]
    peaks = [search.peak(residual) if search.moves else None for search in searches]
    least = STANDS_OUT * max((peak.power for peak in peaks if peak), default=0.0)
    found = ripple.copy()
    for j, (search, peak) in enumerate(zip(searches, peaks, strict=True)):
        if peak and peak.power > least:
            found[j] = peak.ratio, *(SEARCHED_RAD * search.wave(peak.ratio, residual)[1])
    return found


def _vary(order: Array, c: Array, s: Array, r: _Ripple) -> tuple[Array, Array, Array]:
    """Orders, cosines and sines (3, n) of `(1 + a cos q + b sin q) (c cos(order q) + s sin(order q))`."""
    a, b = 0.5 * r.vary_c, 0.5 * r.vary_s
    return (
        np.stack((order, order + 1.0, order - 1.0)),
        np.stack((c, a * c - b * s, a * c + b * s)),
        np.stack((s, a * s + b * c, a * s - b * c)),
    )
