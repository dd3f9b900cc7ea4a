"""Mechanical causes in numpy: payloads that change or swing, cables, contacts, joints and mountings that give. No code of the effects."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TypeAlias

import numpy as np
from scipy.ndimage import correlate1d

from bench.calibration.stage import PERIOD_S, Play
from core.array import Array
from core.payload.inertia import InertialParameters
from tests.synthetic import GRAVITY, wrench_of

Plant: TypeAlias = Callable[[Play], None]
SHAPES: dict[str, dict[str, Plant]] = {}
"""By family, then by variant."""
FINE = 8
"""Steps of what swings in a period."""
CROSSING_S, HELD_NM = 0.1, 0.5
"""Of play in a joint: how long crossing it takes, and up to which torque friction holds a side."""


def shape(family: str) -> Callable[[Plant], Plant]:
    """Registers what is planted as a variant of a family, under the name of its function."""

    def register(plant: Plant) -> Plant:
        SHAPES.setdefault(family, {})[plant.__name__] = plant
        return plant

    return register


def unit(rng: np.random.Generator) -> Array:
    """(3,), any direction."""
    v = rng.normal(size=3)
    return np.asarray(v / np.linalg.norm(v))


def between(p: Play, low: float, high: float) -> float:
    """Log-uniform, times the size of the trial."""
    return p.size * float(np.exp(p.rng.uniform(np.log(low), np.log(high))))


def lean(p: Play, angle: Array) -> None:
    """Gravity turned by small angles (N, 2) or (2,) about the base's x and y."""
    angle = np.broadcast_to(angle, (len(p.run.t), 2))
    g = GRAVITY + np.cross(np.column_stack((angle, np.zeros(len(angle)))), GRAVITY)
    p.wrench = p.wrench + wrench_of(p.run, p.body, g) - wrench_of(p.run, p.body)


@shape("base_tilt")
def fixed(p: Play) -> None:
    """Leans one way."""
    lean(p, np.radians(between(p, 0.2, 1.5)) * unit(p.rng)[:2])


@shape("base_tilt")
def sags(p: Play) -> None:
    """Leans, and more so the farther the arm reaches."""
    reach = p.place[:, :2] / np.linalg.norm(p.place[:, :2], axis=1).max()
    lean(p, np.radians(between(p, 0.2, 1.5)) * (unit(p.rng)[:2] + 0.4 * np.column_stack((-reach[:, 1], reach[:, 0]))))


@shape("joint_offset")
def zeros(p: Play) -> None:
    """Zeros of one to three joints."""
    joints = p.rng.permutation(p.read.shape[1])[: p.rng.integers(1, 4)]
    off = np.zeros(p.read.shape[1])
    off[joints] = np.radians([between(p, 0.3, 2.0) * p.rng.choice([-1, 1]) for _ in joints])
    p.read = p.read + off


@shape("sensor_rotation")
def turned(p: Play) -> None:
    """The sensor is mounted turned about any axis."""
    rotate(p, np.radians(between(p, 0.3, 2.5)) * unit(p.rng))


@shape("sensor_rotation")
def slips_under_load(p: Play) -> None:
    """Turned, and by a third more where the torque about that axis is large."""
    axis = unit(p.rng)
    torque = p.wrench[:, 3:] @ axis
    rotate(p, np.radians(between(p, 0.3, 2.5)) * np.outer(1.0 + 0.33 * np.tanh(2.0 * torque / np.abs(torque).max()), axis))


def rotate(p: Play, angle: Array) -> None:
    """What a sensor reads whose axes are turned by small vectors (3,) or (N, 3)."""
    angle = np.broadcast_to(angle, (len(p.run.t), 3))
    f, tau = p.wrench[:, :3], p.wrench[:, 3:]
    turn: Callable[[Array], Array] = lambda v: v - np.cross(angle, v) + 0.5 * np.cross(angle, np.cross(angle, v))  # noqa: E731 - used twice
    p.wrench = np.hstack((turn(f), turn(tau)))


@shape("sensor_translation")
def shifted(p: Play) -> None:
    """The sensor's origin lies elsewhere, the payload stays where it is known to be in motion: only the motion tells."""
    d = between(p, 0.006, 0.03) * unit(p.rng)
    run = replace(p.run, a=p.run.a + turned_acceleration(p, d))
    p.wrench = wrench_of(run, p.body)


def turned_acceleration(p: Play, d: Array) -> Array:
    """(N, 3), what a place d (3,), sensor axes, is accelerated by more than the origin; base axes."""
    more = np.cross(p.run.alpha, d) + np.cross(p.run.omega, np.cross(p.run.omega, d))
    return np.asarray(np.einsum("nij,nj->ni", p.run.rotation, more))


@shape("joint_elasticity")
def springs(p: Play) -> None:
    """Every joint gives by its torque."""
    p.read = p.read + p.joint_torque / (np.exp(p.rng.uniform(np.log(2e3), np.log(1e4), p.read.shape[1])) / p.size)


@shape("joint_elasticity")
def hardening_springs(p: Play) -> None:
    """Soft at small torques, twice as hard at large ones."""
    soft = 4e3 / p.size
    p.read = p.read + (p.joint_torque / soft) * (0.5 + 0.5 / (1.0 + np.abs(p.joint_torque) / 20.0))


@shape("joint_backlash")
def flips(p: Play) -> None:
    """Play in two joints, on the side of the torque; friction holds the side until half a newton metre pushes the other way."""
    take_sides(p, np.apply_along_axis(held_side, 0, p.joint_torque))


@shape("joint_backlash")
def flips_softly(p: Play) -> None:
    """The same with grease: it takes 2 N m to go over."""
    take_sides(p, np.tanh(p.joint_torque / 2.0))


def take_sides(p: Play, side: Array) -> None:
    """Two joints lean to their sides (N, n), -1 to 1. It takes them `CROSSING_S` to cross: a torque that changes by 10 N m/s moves 1 kg m2
    through a few milliradians in that time."""
    half = np.zeros(p.read.shape[1])
    half[p.rng.permutation(len(half))[:2]] = np.radians(between(p, 0.05, 0.3))
    rise = np.hanning(round(CROSSING_S / PERIOD_S) + 2)
    there = correlate1d(side, rise / rise.sum(), axis=0, mode="nearest", origin=(len(rise) - 1) // 2)
    p.read = p.read + half * there


def held_side(torque: Array) -> Array:
    """(N,), of a torque (N,): that of the last one beyond `HELD_NM`, at first that of the first."""
    beyond = np.flatnonzero(np.abs(torque) > HELD_NM)
    last = np.maximum.accumulate(np.where(np.abs(torque) > HELD_NM, np.arange(len(torque)), beyond[0] if len(beyond) else 0))
    return np.sign(torque[last])


@shape("payload_mass_change")
def falls_off(p: Play) -> None:
    """Some of the mass at once, at the centre."""
    change_mass(p, np.where(p.share > p.rng.uniform(0.2, 0.8), 1.0, 0.0))


@shape("payload_mass_change")
def leaks(p: Play) -> None:
    """The same bit by bit from some moment on."""
    begin = p.rng.uniform(0.1, 0.5)
    change_mass(p, np.clip((p.share - begin) / p.rng.uniform(0.1, 0.4), 0.0, 1.0))


def change_mass(p: Play, gone: Array) -> None:
    """A share of the payload is gone, as far as `gone` (N,) says."""
    share = min(0.8, between(p, 0.02, 0.1))
    p.wrench = p.wrench - share * gone[:, None] * wrench_of(p.run, p.body)


@shape("payload_shift")
def slips(p: Play) -> None:
    """A part slips at once."""
    slide(p, np.where(p.share > p.rng.uniform(0.2, 0.8), 1.0, 0.0))


@shape("payload_shift")
def slips_slowly(p: Play) -> None:
    """A part slides for a while."""
    begin = p.rng.uniform(0.1, 0.6)
    slide(p, np.clip((p.share - begin) / p.rng.uniform(0.05, 0.3), 0.0, 1.0))


def slide(p: Play, done: Array) -> None:
    """A part of the payload moves from its centre of mass along any direction."""
    mass, way = p.rng.uniform(0.1, 0.5) * p.body.mass, between(p, 0.003, 0.02) * unit(p.rng)
    com = p.body.phi[1:4] / p.body.mass
    add_part(p, mass, com + np.outer(done, way), com)


def add_part(p: Play, mass: float, place: Array, instead_of: Array | None, force: Array | None = None) -> None:
    """Adds the wrench of a part at `place` (N, 3), sensor axes, that moves slowly or whose own acceleration is `force` / mass, and takes it
    off at `instead_of` (3,)."""
    own = np.zeros_like(p.specific) if force is None else force / mass
    spots = [(place, own, 1.0)] if instead_of is None else [(place, own, 1.0), (np.broadcast_to(instead_of, place.shape), 0.0 * own, -1.0)]
    for r, more, sign in spots:
        f = sign * mass * (p.specific + np.cross(p.run.alpha, r) + np.cross(p.run.omega, np.cross(p.run.omega, r)) + more)
        p.wrench = p.wrench + np.hstack((f, np.cross(r, f)))


@shape("payload_loose")
def on_a_spring(p: Play) -> None:
    """A part on a spring along one direction."""
    swing(p, np.inf)


@shape("payload_loose")
def between_stops(p: Play) -> None:
    """The same with stops a few millimetres off on both sides."""
    swing(p, 0.004 * p.size)


@shape("payload_loose")
def in_a_box(p: Play) -> None:
    """A part that slides with friction from wall to wall, by gravity."""
    swing(p, 0.006 * p.size, spring=False)


def swing(p: Play, stop_m: float, *, spring: bool = True) -> None:
    """A part of the payload along one direction, on a spring or not, with stops."""
    mass, axis = float(p.rng.uniform(0.05, 0.3)) * p.body.mass, unit(p.rng)
    com = p.body.phi[1:4] / p.body.mass
    r = com + 0.03 * p.rng.normal(size=3)
    pull = -(p.specific + np.cross(p.run.alpha, r) + np.cross(p.run.omega, np.cross(p.run.omega, r))) @ axis
    w = 2.0 * np.pi * p.rng.uniform(1.5, 5.0) / np.sqrt(p.size) if spring else 0.0
    damping = 2.0 * p.rng.uniform(0.03, 0.2) * (w or 20.0)
    u, du = way_between_stops(pull, w, damping, stop_m)
    ddu = np.gradient(du, PERIOD_S)
    coriolis = 2.0 * np.cross(p.run.omega, np.outer(du, axis))
    add_part(p, mass, r + np.outer(u, axis), r, mass * (np.outer(ddu, axis) + coriolis))


def way_between_stops(pull: Array, w: float, damping: float, stop: float) -> tuple[Array, Array]:
    """Way and rate (N,) of `u'' = pull - w^2 u - damping u'` that hits its stops without bouncing."""
    fine = np.interp(np.arange(len(pull) * FINE) / FINE, np.arange(len(pull)), pull).tolist()
    h, u, du = PERIOD_S / FINE, 0.0, 0.0
    if w:
        u = float(np.clip(fine[0] / w**2, -stop, stop))
    rows = []
    for k, b in enumerate(fine):
        if k % FINE == 0:
            rows.append((u, du))
        du += h * (b - w * w * u - damping * du)
        u += h * du
        if abs(u) > stop:
            u, du = (stop if u > 0 else -stop), 0.0
    way, rate = np.array(rows).T
    return way, rate


@shape("cable_drag")
def pulls(p: Play) -> None:
    """A spring to a place in the room, with a tension."""
    cable(p, 0.0)


@shape("cable_drag")
def hangs_slack(p: Play) -> None:
    """The same with slack: it pulls beyond a length only."""
    cable(p, 1.0)


def cable(p: Play, slack: float) -> None:
    """From a point of the payload to a place half a metre off."""
    hook = p.rng.normal(scale=0.04, size=3) + np.array([0.0, 0.0, 0.05])
    there = p.place + np.asarray(p.run.rotation) @ hook
    anchor = there.mean(axis=0) + p.rng.uniform(0.4, 0.8) * unit(p.rng)
    away = anchor - there
    length = np.linalg.norm(away, axis=1)
    free = np.percentile(length, 35) if slack else length.min()
    tension = between(p, 2.0, 12.0) * np.maximum(length - free, 0.0) + (0.0 if slack else between(p, 0.2, 1.5))
    p.push(away / length[:, None] * tension[:, None], hook)


@shape("external_contact")
def leaned_on(p: Play) -> None:
    """A constant force for some seconds."""
    touch(p, lambda s: np.where((s > 0) & (s < 1), 1.0, 0.0))


@shape("external_contact")
def pushed(p: Play) -> None:
    """A force that rises and falls."""
    touch(p, lambda s: np.where((s > 0) & (s < 1), np.abs(np.sin(np.pi * s)) ** 0.7, 0.0))


@shape("external_contact")
def pressed_more_and_more(p: Play) -> None:
    """A force that grows until it lets go."""
    touch(p, lambda s: np.where((s > 0) & (s < 1), 0.3 + 0.7 * s, 0.0))


def touch(p: Play, course: Callable[[Array], Array]) -> None:
    """At a point of the payload, one way in the base."""
    seconds = p.run.t - p.run.t[0]
    begin, long = p.rng.uniform(0.15, 0.75) * seconds[-1], p.rng.uniform(1.0, 6.0)
    force = between(p, 0.4, 5.0) * course(np.clip((seconds - begin) / long, -1.0, 2.0))
    p.push(np.outer(force, unit(p.rng)), p.rng.normal(scale=0.04, size=3) + np.array([0.0, 0.0, 0.08]))


@shape("payload_mass_change")
def is_put_on(p: Play) -> None:
    """A small thing sits on the payload from some moment on, beside its middle."""
    com = p.rng.normal(scale=0.03, size=3) + np.array([0.0, 0.0, 0.08])
    body = InertialParameters.from_com(between(p, 0.02, 0.15), com, 1e-6 * np.eye(3))
    p.wrench = p.wrench + (p.share > p.rng.uniform(0.2, 0.8))[:, None] * wrench_of(p.run, body)
