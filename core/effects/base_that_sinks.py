"""The base sinks at some time: a foot that settles into soft ground, a shim that creeps out, a clamp that lets go."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.base_tilt import BaseTilt, change_gravity, find_level_axes, turn_gravity
from core.effects.channels import expand_to_channels
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_drift import settling
from core.words.message import Message

RATES, STARTS = (0.0, 0.03, 0.2, 2.0), 9
"""Settling rates, 1/s, and how many times along the run to start from; the quickest is a clamp that lets go."""
LAST = 0.85
"""Share of the run behind which no sinking is started from: little of it would be seen."""
LOOKED_AT = 2000
"""So many rows are enough to see how gravity goes."""


class BaseThatSinks(BaseTilt):
    """`BaseTilt` by `(a, b) + (s_a, s_b) (1 - exp(-k (t - t0))) / (1 - exp(-k 60 s))` from t0 on: as it stands at first, and then sinking
    with one rate; a ramp is `k = 0`.
    """

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The two angles of the tilt at first, rad, by how much they have changed a minute after the start of the sinking, rad, that start,
        s, from the first sample on, and the settling rate, 1/s."""
        seconds = float(scene.t[-1] - scene.t[0])
        return (
            *super().parameters(scene),
            *(Parameter(f"sink_{'xyz'[i]}_rad", "rad", 0.0, -0.2, 0.2, 0.015) for i in find_level_axes(scene)),
            Parameter("start_s", "s", 0.0, 0.0, seconds, max(seconds, scene.period)),
            Parameter("settling_rate_per_s", "1/s", 0.0, 0.0, 5.0, 0.03),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` less `m dg` and `mc x dg`, dg the change of gravity in sensor axes, row by row."""
        vectors = np.zeros((len(scene), 3))
        vectors[:, find_level_axes(scene)] = theta[:2] + _find_course(scene, *theta[4:])[:, None] * theta[2:4]
        return turn_gravity(scene, w, vectors)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The start and rate that explain most of the residual."""
        return self.starts_beside(scene, residual, np.zeros(2))

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """The same beside a tilt."""
        seconds = float(scene.t[-1] - scene.t[0])
        some = slice(None, None, max(1, len(scene) // LOOKED_AT))
        weight = 1.0 / expand_to_channels(1.0, 0.05)
        change, looked = [each[some] * weight for each in _find_changes(scene)], residual[some] * weight
        found = []
        for start in np.linspace(0.0, LAST * seconds, STARTS):
            for rate in RATES:
                course = _find_course(scene, start, rate)[some, None]
                columns = np.column_stack([each.ravel() for each in (*change, *(course * each for each in change))])
                angles, left, _, _ = np.linalg.lstsq(columns, looked.ravel(), rcond=1e-9)
                if left.size:
                    found.append((float(left[0]), np.concatenate([angles, [start, rate]])))
        if not found:
            return []
        best = min(found, key=lambda each: each[0])[1]
        tilt = np.concatenate([plain, np.zeros(4)])
        bounds = self.parameters(scene)
        return [np.clip(tilt + best, [p.lower for p in bounds], [p.upper for p in bounds])]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises putting the base on firm ground and levelling it, with how far it sank in the run, deg, and from when on."""
        sunk = float(np.linalg.norm(theta[2:4]) * abs(_find_course(scene, *theta[4:])[-1]))
        return Message.of("advice-base-tilt-sinks", sunk_rad=sunk, at_s=theta[4])


def _find_course(scene: Scene, start: float, rate: float) -> Array:
    """(N,), 0 up to the start and 1 a minute after it."""
    return settling(np.maximum(scene.elapsed - start, 0.0), rate)


def _find_changes(scene: Scene) -> list[Array]:
    """Of each level axis, (N, 6), N/rad and N m/rad: what a small turn of gravity about it does to the wrench."""
    nothing = np.zeros((len(scene), 6))
    axes = np.eye(3)[find_level_axes(scene)]
    return [change_gravity(scene, nothing, np.cross(axis, scene.gravity) @ scene.rotation) for axis in axes]
