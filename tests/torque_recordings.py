"""Recordings of joint torques from a generator of their own: nothing of the engine takes part in making them.

A serial arm of six hinges swings along sums of sines. Its torques are those of Newton and Euler, link by link in world axes; every joint
adds the friction of Canudas de Wit et al. 1995 (LuGre: bristles, Stribeck, viscous) with a part that goes with the load, a rotor behind a
gear, an offset, and a torque that is read with a wrong constant. The URDF states links that are not quite the true ones.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.recording.recording import Recording, RobotDescription

GRAVITY = np.array([0.0, 0.0, -9.81])
MASSES = np.array([6.0, 8.0, 4.0, 2.0, 1.5, 0.6])
LENGTHS = np.array([0.15, 0.4, 0.35, 0.1, 0.1, 0.08])
TURNS = np.array([0.0, np.pi / 2, 0.0, 0.0, np.pi / 2, -np.pi / 2])
"""About x, of each joint against the one before."""
EFFORT = np.array([200.0, 200.0, 120.0, 40.0, 40.0, 40.0])
RATE_HZ = 200.0
SECONDS = 30.0
Body = tuple[float, Array, Array]
Points = tuple[tuple[float, Array], ...]


@dataclass(frozen=True)
class Made:
    """Recordings with and without a payload, and the truth (10,), sensor frame."""

    loaded: Recording
    empty: Recording
    phi: Array


@dataclass(frozen=True)
class _Friction:
    coulomb: Array
    static: Array
    viscous: Array
    stribeck: Array
    bristle: Array
    load: Array


def make(seed: int, *, mass_kg: float = 2.0, same_motion: bool = False, gain_std: float = 0.0, gains: Array | None = None) -> Made:
    """One pair; every error is drawn from the seed.

    Args:
        gain_std: stated, and what the torques' constants are drawn from; gains: (6,), these instead, and nothing is stated.
    """
    rng = np.random.default_rng([seed, 23])
    links = draw_links(rng)
    points, truth = draw_payload(rng, mass_kg)
    coulomb = rng.uniform(0.02, 0.06, 6) * EFFORT
    friction = _Friction(
        coulomb=coulomb,
        static=coulomb * rng.uniform(1.1, 1.5, 6),
        viscous=rng.uniform(0.02, 0.06, 6) * EFFORT,
        stribeck=rng.uniform(0.02, 0.08, 6),
        bristle=coulomb / rng.uniform(5e-4, 2e-3, 6),
        load=rng.uniform(0.0, 0.06, 6),
    )
    rotor, offset = rng.uniform(0.002, 0.012, 6) * EFFORT, rng.normal(scale=0.005, size=6) * EFFORT
    read = 1.0 + (gain_std * rng.normal(size=6) if gains is None else gains)
    described = _describe(links, rng)
    first = _Sines(rng)
    recordings = []
    for carried, motion in ((points, first), ((), first if same_motion else _Sines(rng))):
        t = np.arange(int(SECONDS * RATE_HZ)) / RATE_HZ
        q, dq, ddq = motion(t)
        load = newton_euler(q, dq, ddq, links, carried)
        warm = 1.0 + 0.05 * rng.normal(size=6)
        torque = load + rotor * ddq + warm * _lugre(dq, load, friction) + offset + 0.001 * EFFORT * rng.normal(size=6)
        tau = read * torque + 0.002 * EFFORT * rng.normal(size=q.shape)
        measured = q + 2e-5 * rng.normal(size=q.shape)
        recordings.append(
            Recording(
                t=t, gravity=GRAVITY, q=measured, tau=tau, robot=described, link_mass_std=0.1,
                torque_gain_std=gain_std if gains is None else None,
            )
        )  # fmt: skip
    return Made(recordings[0], recordings[1], truth)


def draw_links(rng: np.random.Generator) -> list[Body]:
    """Mass, centre and inertia about it of each link, in its joint's frame."""
    return [
        (m, rng.normal(scale=0.02, size=3) + np.array([0.0, 0.0, 0.4 * a]), _gyration(rng, m)) for m, a in zip(MASSES, LENGTHS, strict=True)
    ]


def _gyration(rng: np.random.Generator, mass: float) -> Array:
    return np.diag(mass * rng.uniform(0.04, 0.09, 3) ** 2)


def draw_payload(rng: np.random.Generator, mass_kg: float) -> tuple[Points, Array]:
    """Eight point masses at places in the sensor's frame, and their ten parameters."""
    masses = rng.dirichlet(np.full(8, 4.0)) * mass_kg
    places = rng.uniform(-0.08, 0.08, (8, 3)) + np.array([0.0, 0.02, 0.08])
    inertia = sum(m * (p @ p * np.eye(3) - np.outer(p, p)) for m, p in zip(masses, places, strict=True))
    six = np.asarray(inertia)[[0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]]
    return tuple(zip(masses.tolist(), places, strict=True)), np.concatenate(([mass_kg], masses @ places, six))


class _Sines:
    """Sums of sines that begin and end anywhere: positions, velocities, accelerations."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.w = 2.0 * np.pi * rng.uniform(0.05, 0.6, (5, 6))
        self.a = rng.uniform(0.3, 0.8, (5, 6)) / self.w * 0.7
        self.a *= np.minimum(1.0, 0.8 / self.a)
        self.p = rng.uniform(0.0, 2.0 * np.pi, (5, 6))
        self.q0 = np.array([0.0, -1.0, 1.0, 0.3, 1.0, 0.0]) + rng.normal(scale=0.3, size=6)

    def __call__(self, t: Array) -> tuple[Array, Array, Array]:
        x = self.w * t[:, None, None] + self.p
        q = self.q0 + (self.a * np.sin(x)).sum(axis=1)
        return q, (self.a * self.w * np.cos(x)).sum(axis=1), -(self.a * self.w**2 * np.sin(x)).sum(axis=1)


def _turn_x(angle: float) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])


def _turn_z(angle: Array) -> Array:
    R = np.zeros((len(angle), 3, 3))
    R[:, 0, 0], R[:, 0, 1], R[:, 1, 0], R[:, 1, 1], R[:, 2, 2] = np.cos(angle), -np.sin(angle), np.sin(angle), np.cos(angle), 1.0
    return R


def newton_euler(q: Array, dq: Array, ddq: Array, links: list[Body], points: Points) -> Array:
    """(N, 6), torques; joint j sits `LENGTHS[j - 1]` along z of the one before, and turns about its own z."""
    count = len(q)
    R, origin = np.tile(np.eye(3), (count, 1, 1)), np.zeros((count, 3))
    omega, alpha, a = np.zeros((count, 3)), np.zeros((count, 3)), np.tile(-GRAVITY, (count, 1))
    axes, origins, pulls = [], [], []
    for j in range(6):
        r = R @ np.array([0.0, 0.0, LENGTHS[j - 1] if j else 0.2])
        a = a + np.cross(alpha, r) + np.cross(omega, np.cross(omega, r))
        origin = origin + r
        R = R @ _turn_x(float(TURNS[j])) @ _turn_z(q[:, j])
        z = R[:, :, 2]
        alpha = alpha + z * ddq[:, j, None] + np.cross(omega, z) * dq[:, j, None]
        omega = omega + z * dq[:, j, None]
        axes.append(z)
        origins.append(origin)
        bodies = [links[j], *([(m, p + np.array([0.0, 0.0, LENGTHS[5]]), np.zeros((3, 3))) for m, p in points] if j == 5 else [])]
        for m, c, inertia in bodies:
            arm = R @ c
            force = m * (a + np.cross(alpha, arm) + np.cross(omega, np.cross(omega, arm)))
            world = R @ inertia @ np.swapaxes(R, 1, 2)
            spin = np.einsum("nij,nj->ni", world, omega)
            moment = np.einsum("nij,nj->ni", world, alpha) + np.cross(omega, spin)
            pulls.append((j, origin + arm, force, moment))
    tau = np.zeros((count, 6))
    for j, (z, o) in enumerate(zip(axes, origins, strict=True)):
        for k, place, force, moment in pulls:
            if k >= j:
                tau[:, j] += np.einsum("ni,ni->n", z, np.cross(place - o, force) + moment)
    return tau


def _lugre(v: Array, load: Array, of: _Friction) -> Array:
    """(N, 6), friction of bristles that are carried along."""
    extra = of.load * np.abs(load)
    level = of.coulomb + extra + (of.static - of.coulomb) * np.exp(-((v / of.stribeck) ** 2))
    F, z, step = np.zeros_like(v), np.zeros(6), 1.0 / RATE_HZ
    for k in range(len(v)):
        speed = np.maximum(np.abs(v[k]), 1e-9)
        rest = level[k] / of.bristle * np.sign(v[k])
        z = rest + (z - rest) * np.exp(-of.bristle * speed / level[k] * step)
        F[k] = of.bristle * z
    return F + of.viscous * v


def _describe(links: list[Body], rng: np.random.Generator) -> RobotDescription:
    """A URDF whose links are off by a tenth of their mass, a centimetre of their centre and a fifth of their moments."""
    wrong = [
        (max(m * (1.0 + 0.1 * rng.normal()), 0.1), c + 0.01 * rng.normal(size=3), inertia * np.exp(0.15 * rng.normal(size=3)))
        for m, c, inertia in links
    ]
    return describe_exactly(wrong)


def describe_exactly(links: list[Body]) -> RobotDescription:
    """The URDF of these links; diagonal inertias."""
    parts = ['<link name="base"/>']
    for j, (m, c, inertia) in enumerate(links):
        x, y, z = np.diag(inertia)
        parts.append(
            f'<link name="l{j}"><inertial><origin xyz="{c[0]} {c[1]} {c[2]}"/><mass value="{m}"/>'
            f'<inertia ixx="{x}" iyy="{y}" izz="{z}" ixy="0" ixz="0" iyz="0"/></inertial></link>'
            f'<joint name="j{j}" type="revolute"><parent link="{f"l{j - 1}" if j else "base"}"/><child link="l{j}"/>'
            f'<origin xyz="0 0 {LENGTHS[j - 1] if j else 0.2}" rpy="{TURNS[j]} 0 0"/><axis xyz="0 0 1"/>'
            f'<limit lower="-6.28" upper="6.28" effort="{EFFORT[j]}" velocity="3"/></joint>'
        )
    parts.append(
        '<link name="tool"/><joint name="mount" type="fixed"><parent link="l5"/><child link="tool"/>'
        f'<origin xyz="0 0 {LENGTHS[5]}"/></joint>'
    )
    urdf = f'<robot name="six">{"".join(parts)}</robot>'
    return RobotDescription(urdf, tuple(f"j{j}" for j in range(6)), "base", "tool")
