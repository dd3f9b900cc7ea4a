"""A hose or cable pulls at the payload."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Effect, Parameter
from core.effects.filters import play
from core.effects.scene import Scene
from core.effects.vectors import add_force, turn_back
from core.effects.window_search import weights
from core.payload.inertia import regressor
from core.words.message import Message

CREEP = 0.003
"""m/s, speed at which two thirds of the Coulomb friction act."""


YIELD = 0.1
"""rad, by which a hose twists before it slips along itself."""
ANCHORS = np.stack(np.meshgrid(*[(-0.8, -0.4, 0.0, 0.4, 0.8)] * 3), axis=-1).reshape(-1, 3)
"""m, from the payload's first place: where a cable may be fixed, in the search before a fit."""
SLACK = (0.2, 0.5, 0.8)
"""Quantiles of the distance to its fixed point at which a cable may tighten."""
REEL_M = -5.0
"""A free length far below zero: a reel or a balancer, which pulls alike at any distance."""
STIFF = 10.0
"""N/m, of the cables from which a fit starts; a reel's is less, so that it pulls with some newtons."""
LOOKED_AT = 600
"""The search looks at no more rows than about this many."""
TRIED = 2
TWIST = slice(11, 15)
"""Where the torsion stands among the parameters."""


class CableDrag(Effect):
    """A hose or cable between the payload at r and a fixed point: spring with slack, Coulomb friction, and torsion of the wrist.

    `F = f max(0, 1 - s/|f|) - mu v / sqrt(v^2 + v_c^2)` with `f = c - k (p - p_0)`, base axes; p and v are of the point r. c is the pull
    in the first sample if there were no slack, so the fixed point is `p_0 + c / k`, and `s / k` is the free length: a hose has `s = 0`, and
    what pulls already where it is not stretched, as a reel does, a negative one.
    Friction that acts on each axis of the base on its own, `mu_g v_i / sqrt(v_i^2 + v_c^2)`, has no mechanism behind it that we know
    of, but simulators have it, and linear guides along those axes would look like it. What runs over a drum, round an edge or through an
    eye pulls more while it is paid out and less while it comes in: F times `1 + e u / sqrt(u^2 + v_c^2)` with `u = -v . F / |F|`.
    About the last joint, `T = -(k_1 x + k_2 x^2 + k_3 x^3) - mu_t z` with x the angle since the first sample (the constant is an offset)
    and z from -1 to 1 what a play of 0.1 rad holds back. The sensor reads `-F` and `-r x F - T`.
    """

    id = "cable_drag"
    title = Message.of("effect-cable-drag-title")
    stage = "environment"
    only_adds = True
    needs_motion = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Stiffness, N/m, pull at the first sample (3) and friction, N, place (3), m, slack and guide friction, N, and the friction where
        it is wound, a share of the pull; where the joints are known also the four of the torsion, N m, their terms at one radian."""
        cable = (
            Parameter("stiffness_n_per_m", "N/m", 0.0, -5.0, 300.0, 10.0),
            *(Parameter(f"pull_{axis}_n", "N", 0.0, -200.0, 200.0, 5.0) for axis in "xyz"),
            Parameter("friction_n", "N", 0.0, -1.0, 10.0, 0.5),
            *(Parameter(f"at_{axis}_m", "m", 0.0, -0.5, 0.5, 0.1) for axis in "xyz"),
            Parameter("slack_n", "N", 0.0, -200.0, 200.0, 5.0),
            Parameter("guide_friction_n", "N", 0.0, -1.0, 10.0, 0.5),
            Parameter("winding_friction_share", "1", 0.0, -0.1, 1.0, 0.1),
        )
        if scene.q is None or scene.jacobian is None:
            return cable
        return (
            *cable,
            Parameter("twist_linear_nm", "N m", 0.0, -5.0, 5.0, 0.2),
            Parameter("twist_square_nm", "N m", 0.0, -2.0, 2.0, 0.1),
            Parameter("twist_cube_nm", "N m", 0.0, -1.0, 1.0, 0.05),
            Parameter("twist_friction_nm", "N m", 0.0, -0.1, 1.0, 0.03),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` less the pull F in sensor axes and its moment `r x F`; where the joints are known plus the torque that twists the hose."""
        if scene.position is None:
            raise ValueError("cable drag needs a scene with positions (see Effect.explain_lack)")
        r = theta[5:8]
        p = scene.position + scene.rotation @ r
        whole = scene.past("place").before(p, 1)
        step = np.diff(whole, axis=0, prepend=whole[:1])[-len(p) :]
        F = self.pull(scene, p - scene.past("first place").first(p), theta)
        torque = twist(scene, theta[TWIST]) if len(theta) > TWIST.start else np.zeros_like(F)
        return np.asarray(add_force(w, -turn_back(scene.rotation, self.rub(scene, F, step, theta)), r, torque))

    def pull(self, scene: Scene, way: Array, theta: Array) -> Array:
        """(N, 3), N, on an end that is `way` (N, 3), m, from its first place, without friction."""
        del scene
        return taut(theta[1:4] - theta[0] * way, theta[8])

    def rub(self, scene: Scene, F: Array, step: Array, theta: Array) -> Array:
        """(N, 3), N, the pull F (N, 3) with all friction, as its end moves by `step` (N, 3), m, from row to row."""
        v = step / scene.period
        F = F * wind(v, F, theta[10])
        F = F - theta[4] * v / np.sqrt(np.sum(v * v, axis=1, keepdims=True) + CREEP**2) - theta[9] * v / np.sqrt(v * v + CREEP**2)
        return np.asarray(F)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """A hose, and the two cables with slack whose pull looks most like the residual."""
        parameters = self.parameters(scene)
        hose = np.array([0.3 * p.scale for p in parameters])
        hose[8:] = 0.0
        slack = []
        for anchor, free in _find_cables(scene, residual):
            cable = np.zeros(len(parameters))
            cable[[0, 1, 2, 3, 8]] = STIFF * np.array([1.0, *anchor, free]) / (1.0 if free > 0.0 else 1.0 - free / np.ptp(ANCHORS))
            slack.append(cable)
        return [hose, *slack]

    def explain_lack(self, scene: Scene) -> Message | None:
        """A reason where the recording does not say where the sensor is."""
        return Message.of("effect-no-position") if scene.position is None else None

    def explain_absence(self, scene: Scene) -> Message | None:
        """A reason where the sensor's position is not known or stays within 1 cm along each axis of the base."""
        if scene.position is None:
            return self.explain_lack(scene)
        return None if np.ptp(scene.position, axis=0).max() > 0.01 else Message.of("effect-one-place")

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises freeing the hose: pull at the start, N, change per metre, N, friction, N, and torsion, N m/rad."""
        pull = float(np.linalg.norm(taut(theta[None, 1:4], theta[8])))
        stiffness, friction = theta[0], theta[4] + theta[9]
        twist_nm_per_rad = theta[TWIST.start] if len(theta) > TWIST.start else 0.0
        numbers = {"pull_n": pull, "stiffness_n_per_m": stiffness, "friction_n": friction}
        if abs(twist_nm_per_rad) > 0.01:
            return Message.of("advice-cable-drag-twisting", **numbers, twist_nm_per_rad=twist_nm_per_rad)
        return Message.of("advice-cable-drag", **numbers)


def taut(f: Array, slack: float) -> Array:
    """Pull (N, 3) of a spring f, of which the first newtons take up the slack."""
    size = np.sqrt(np.sum(f * f, axis=1, keepdims=True))
    return np.asarray(f * np.maximum(0.0, 1.0 - slack / np.maximum(size, 1e-12)))


def wind(v: Array, F: Array, share: float) -> Array:
    """(N, 1), times the pull F (N, 3) of what is paid out or comes in as its end moves at v (N, 3), m/s."""
    paid_out = -np.einsum("ni,ni->n", v, F) / np.maximum(np.sqrt(np.einsum("ni,ni->n", F, F)), 1e-12)
    return np.asarray(1.0 + share * paid_out / np.hypot(paid_out, CREEP))[:, None]


def twist(scene: Scene, theta: Array) -> Array:
    """(N, 3), torque with which the payload twists the hose about the last joint's axis, sensor axes."""
    if scene.q is None or scene.jacobian is None:
        raise ValueError("the torsion of a hose needs a scene with joints (see CableDrag.parameters)")
    q = scene.q[:, -1:]
    x = q - scene.past("first angle").first(q)
    held = (q - play(q, np.array([YIELD]), scene.past("twist"))) / YIELD
    torque = x * (theta[0] + x * (theta[1] + x * theta[2])) + theta[3] * held
    return np.asarray(torque * scene.jacobian[:, 3:, -1])


def find_taken_up(scene: Scene, rows: slice) -> Array:
    """(3 n, m), orthonormal: what payload and offsets take up of the force in n rows of the scene, weighed as residuals are."""
    columns = regressor(scene.motion[rows])[:, :3]
    columns = np.concatenate([columns, np.broadcast_to(np.eye(3), (len(columns), 3, 3))], axis=2)
    return np.linalg.svd((columns * weights(scene)[:3, None]).reshape(-1, columns.shape[2]), full_matrices=False)[0]


def _find_cables(scene: Scene, residual: Array) -> list[tuple[Array, float]]:
    """Fixed points (m, from the first place) and free lengths (m) of the cables and of the reel whose pull looks most like the residual.

    What payload and offsets take up does not count.
    """
    if scene.position is None:
        return []
    rows = slice(0, None, max(1, len(scene) // LOOKED_AT))
    R, p = scene.rotation[rows], scene.position[rows] - scene.position[0]
    scale, Q = weights(scene)[:3], find_taken_up(scene, rows)
    cables, gains = [], []
    for anchor in ANCHORS:
        away = anchor - p
        for free in (*np.quantile(np.linalg.norm(away, axis=1), SLACK), REEL_M):
            c = (-np.einsum("ni,nij->nj", taut(away, free), R) * scale).ravel()
            c -= Q @ (Q.T @ c)
            along = float(c @ residual[rows, :3].ravel())
            cables.append((anchor, float(free)))
            gains.append(along * abs(along) / max(float(c @ c), 1e-12))
    best = [cables[k] for k in np.argsort(gains)[::-1]]
    return [*[cable for cable in best if cable[1] > 0.0][:TRIED], *[cable for cable in best if cable[1] < 0.0][:1]]
