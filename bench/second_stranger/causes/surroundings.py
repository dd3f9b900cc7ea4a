"""Something besides gravity and motion acts on the payload: hoses, lines, hands, walls."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.draws import draw_time, normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.kinematics import Kinematics
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import push
from bench.second_stranger.signals import derive, follow_dahl, resonate, rise

TOP_M = 1.5
"""Height from which hoses hang."""


def cable_catenary(_: np.random.Generator, rig: Rig) -> Fault:
    """A hose that hangs through."""
    anchor, at = np.array([0.15, 0.25, TOP_M]), rig.body.com + np.array([0, 0.05, 0.06])
    length = 1.12 * np.sqrt(((anchor - rig.nominal.find_place(at)) ** 2).sum(1)).max()

    def hang(W: Array, k: Kinematics, scale: float) -> Array:
        way = anchor - k.find_place(at)
        across, height = np.maximum(np.linalg.norm(way[:, :2], axis=1), 0.03), way[:, 2]
        weight = 2.5 * scale
        x = _solve_catenary(np.sqrt(length * length - height * height) / across)
        pull = weight * (across / (2 * x))
        lift = weight / 2 * (height * np.cosh(x) / np.sinh(x) - length)
        return push(W, k, np.hstack([pull[:, None] * way[:, :2] / across[:, None], lift[:, None]]), at)

    return Fault(size=lambda scale: Size("hose as catenary from above, weight", 2.5 * scale, "N/m"), touch=hang)


def _solve_catenary(ratio: Array) -> Array:
    """(N,), x with sinh(x) / x equal to a ratio (N,), by Newton's method."""
    x = np.sqrt(6 * (ratio - 1))
    for _ in range(30):
        x = np.maximum(x - (np.sinh(x) - ratio * x) / (np.cosh(x) - ratio), 1e-3)
    return x


def cable_lanyard(_: np.random.Generator, rig: Rig) -> Fault:
    """A line that is slack at first, then taut over an eyelet."""
    anchor, at = np.array([-0.3, 0.5, 0.6 * TOP_M]), rig.body.com + np.array([0.04, 0, 0.05])
    slack = np.quantile(np.linalg.norm(rig.nominal.find_place(at) - anchor, axis=1), 0.35)

    def pull(W: Array, k: Kinematics, scale: float) -> Array:
        way = anchor - k.find_place(at)
        distance = np.linalg.norm(way, axis=1)
        stretch = np.maximum(distance - slack, 0)
        rubbing = 1 + 0.25 * np.tanh(derive(distance) / 0.02)
        force = 12 * scale * stretch * rubbing * np.minimum(1, stretch / 0.004)
        return push(W, k, force[:, None] * way / distance[:, None], at)

    what = f"supply line slack below {slack:.2f} m then taut over a rubbing eyelet, stiffness"
    return Fault(size=lambda scale: Size(what, 12 * scale, "N/m"), touch=pull)


def cable_twist(_: np.random.Generator, rig: Rig) -> Fault:
    """A dress pack about the last joint."""
    q, before = rig.q[:, -1], rig.q[:, -2]
    at = np.array([0.03, 0.04, 0.02])
    rubbing = np.interp(rig.t, rig.t[::5], follow_dahl(np.diff(q[::5]), 0.15))
    torque = 0.12 * (q - q.mean()) + 0.08 * rubbing
    force = 0.9 * np.sin(before - before.mean())

    def twist(W: Array, _: Kinematics, scale: float) -> Array:
        by = np.zeros_like(W)
        by[:, 5], by[:, 0] = scale * torque, scale * force
        by[:, 3:] += np.cross(at, by[:, :3])
        return W + by

    what = "dress pack wound about the last joint: stiffness with Dahl friction"
    return Fault(size=lambda scale: Size(what, 0.12 * scale, "N m/rad"), touch=twist)


def contact_hand(rng: np.random.Generator, rig: Rig) -> Fault:
    """Three times, with tremor."""
    force = np.zeros((len(rig.t), 3))
    at = rig.body.com + np.array([0.05, -0.03, 0.07])
    times_s = np.sort(rng.uniform(0.12, 0.82, 3)) * rig.seconds
    tremor = resonate(rng.normal(size=(len(rig.t), 3)) * 6, 9.0, 0.12)
    for at_s in times_s:
        lasting, up, down = rng.uniform(1.1, 2.2), rng.uniform(0.25, 0.5), rng.uniform(0.2, 0.5)
        x = rig.t - at_s
        held = rise(x / up) * (1 - rise((x - lasting) / down))
        first, later, amount = normalise(rng.normal(size=3)), normalise(rng.normal(size=3)), rng.uniform(0.7, 1.5)
        toward = first + later * np.clip(x / lasting, 0, 1)[:, None] * 0.7
        swaying = (1 + 0.15 * np.sin(2 * np.pi * 0.8 * x + rng.uniform(0, 6)))[:, None]
        force += amount * held[:, None] * (toward * swaying + 0.12 * tremor / np.std(tremor))
    return Fault(
        size=lambda scale: Size("hand, 3 times, with tremor; force about", 5 * scale, "N"),
        touch=lambda W, k, scale: push(W, k, 5 * scale * force, at),
    )


def contact_foam(_: np.random.Generator, rig: Rig) -> Fault:
    """A soft wall where the arm goes farthest."""
    at = rig.body.com + np.array([0.0, 0.06, 0.08])
    normal, face = _find_wall(rig.nominal.find_place(at))

    def brush(W: Array, k: Kinematics, scale: float) -> Array:
        v = k.find_speed(at)
        depth, inward = np.maximum(k.find_place(at) @ normal - face, 0), v @ normal
        F = 4 * scale * (depth / 0.02) ** 1.4 * np.maximum(0, 1 + 0.6 * np.tanh(inward / 0.1))
        F = 30 * scale * np.tanh(F / (30 * scale))
        along = v - np.outer(inward, normal)
        friction = -0.4 * F[:, None] * along / (np.linalg.norm(along, axis=1, keepdims=True) + 0.02)
        return push(W, k, -F[:, None] * normal + friction, at)

    what = "brushes foam wall (Hunt-Crossley, friction 0.4), force at 20 mm"
    return Fault(size=lambda scale: Size(what, 4 * scale, "N"), touch=brush)


def _find_wall(places: Array) -> tuple[Array, float]:
    """The upright wall into which a point at places (N, 3), m, goes about 5 cm: its normal (3,) and where along this it stands, m."""
    found = []
    for azimuth in np.arange(0, 6.2, 0.3):
        normal = np.array([np.cos(azimuth), np.sin(azimuth), 0])
        along = places @ normal
        face = np.quantile(along, 0.82)
        depth = np.maximum(along - face, 0).max()
        if depth > 0.01:
            found.append((abs(depth - 0.05), normal, face))
    _, normal, face = min(found, key=lambda each: each[0])
    return normal, face


def contact_bump(rng: np.random.Generator, rig: Rig) -> Fault:
    """Something bounces against the payload, and leans on it for a while."""
    at = rig.body.com + np.array([-0.04, 0.05, 0.06])
    force = np.zeros((len(rig.t), 3))
    for begin_s in np.sort(rng.uniform(0.1, 0.9, 5)) * rig.seconds:
        toward, at_s = normalise(rng.normal(size=3)), begin_s
        for bounce in range(4):
            x = (rig.t - at_s) / (0.16 * 0.8**bounce)
            blow = np.where((x > 0) & (x < 1), np.sin(np.pi * np.clip(x, 0, 1)) ** 1.5, 0)
            force += np.outer(blow, toward) * 3 * 0.5**bounce
            at_s += 0.3 * 0.7**bounce
        x = rig.t - at_s
        force += np.outer(rise(x / 0.2) * (1 - rise((x - 1.4) / 0.3)), toward) * 0.9
    return Fault(
        size=lambda scale: Size("object bumps, bounces, leans (5 times), lean force", 4.5 * scale, "N"),
        touch=lambda W, k, scale: push(W, k, 5 * scale * force, at),
    )


def contact_once(rng: np.random.Generator, rig: Rig) -> Fault:
    """A push that something else may follow from."""
    at_s = draw_time(rng, rig, 0.2, 0.45)
    at = rig.body.com + np.array([0.05, 0.02, 0.05])
    toward, x = normalise(rng.normal(size=3)), rig.t - at_s
    shape = rise(x / 0.25) * (1 - rise((x - 3.2) / 0.5)) * (1 + 0.2 * np.sin(2 * np.pi * 0.6 * x))
    return Fault(
        size=lambda scale: Size(f"pushed once at {at_s:.1f} s", 8 * scale, "N"),
        touch=lambda W, k, scale: push(W, k, 8 * scale * np.outer(shape, toward), at),
        at_s=at_s,
    )
