"""An energy chain, or a hose on a trolley: it is drawn along one direction of the cell, and pulls and rubs along that alone."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.cable_drag import CREEP, LOOKED_AT, CableDrag, find_taken_up
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.vectors import add_force, turn_back
from core.effects.window_search import weights
from core.words.message import Message

RISE = np.radians((0.0, 35.0, 65.0))
TURN = np.radians(np.arange(0.0, 360.0, 30.0))
WAYS = np.array(
    [[np.cos(t) * np.cos(r), np.sin(t) * np.cos(r), np.sin(r)] for r in RISE for t in TURN if r > 0.0 or t < np.pi] + [[0.0, 0.0, 1.0]]
)
"""Directions in which it may be drawn, in the search before a fit; which way is forth and which is back makes no difference."""
TRIED = 2
LEAST_N = 0.05
"""Of the friction from which a fit starts: without any there is no direction."""


class CableOnRail(CableDrag):
    """`F = -(mu v_a / sqrt(v_a^2 + v_c^2) + c + k x_a) a` on the point r of the payload, a the direction, x_a its way along that from the
    first place, v_a its speed along it. The parameter is `mu a`, base axes. The sensor reads `-F` and `-r x F`."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Friction along the direction (3), N, stiffness, N/m, pull at the first place, N, where it acts (3), m, and the
        speed v_c at which most of the friction acts, m/s."""
        return (
            *(Parameter(f"friction_{axis}_n", "N", 0.0, -20.0, 20.0, 0.5) for axis in "xyz"),
            Parameter("stiffness_n_per_m", "N/m", 0.0, -100.0, 300.0, 10.0),
            Parameter("pull_n", "N", 0.0, -200.0, 200.0, 5.0),
            *(Parameter(f"at_{axis}_m", "m", 0.0, -0.5, 0.5, 0.1) for axis in "xyz"),
            Parameter("rubbing_speed_m_per_s", "m/s", CREEP, 5e-4, 0.2, 0.01),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` less the pull F in sensor axes and its moment `r x F`."""
        if scene.position is None:
            raise ValueError("cable drag needs a scene with positions (see Effect.explain_lack)")
        mu, r = float(np.linalg.norm(theta[:3])), theta[5:8]
        a = theta[:3] / max(mu, 1e-9)
        x = (scene.position + scene.rotation @ r) @ a
        whole = scene.past("way on the rail").before(x[:, None], 1)
        v = np.diff(whole, axis=0, prepend=whole[:1])[-len(x) :, 0] / scene.period
        way = x - scene.past("first way on the rail").first(x)
        F = -np.outer(mu * v / np.hypot(v, theta[8]) + theta[4] + theta[3] * way, a)
        return np.asarray(add_force(w, -turn_back(scene.rotation, F), r, np.zeros_like(F)))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Along the directions in which rubbing and a spring explain most of the residual, with what they are then."""
        if scene.position is None:
            return []
        rows = slice(0, None, max(1, len(scene) // LOOKED_AT))
        R, p, v = scene.rotation[rows], scene.position[rows] - scene.position[0], np.gradient(scene.position, scene.period, axis=0)[rows]
        scale, Q = weights(scene)[:3], find_taken_up(scene, rows)
        r = residual[rows, :3].ravel()
        found = []
        for a in WAYS:
            amounts = np.column_stack(((v @ a) / np.hypot(v @ a, CREEP), p @ a, np.ones(len(p))))
            columns = (np.einsum("nk,nc->nck", amounts, (a @ R)) * scale[:, None]).reshape(3 * len(p), 3)
            columns = columns - Q @ (Q.T @ columns)
            size = np.linalg.lstsq(columns, r, rcond=1e-6)[0]
            found.append((float(r @ columns @ size), a, size))
        best = sorted(found, key=lambda each: -each[0])[:TRIED]
        unit = float(scene.noise[0]) if scene.noise is not None and (scene.noise > 0).all() else 1.0  # N, that weights are in
        return [np.concatenate((max(unit * mu, LEAST_N) * a, [unit * k, unit * c], np.zeros(3), [CREEP])) for _, a, (mu, k, c) in best]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """As for the cable, with what pulls along the direction."""
        mu = float(np.linalg.norm(theta[:3]))
        return Message.of("advice-cable-drag", pull_n=abs(float(theta[4])), stiffness_n_per_m=theta[3], friction_n=mu)
