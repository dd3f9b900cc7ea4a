"""A random serial arm and its motion, for recordings that nothing of the engine takes part in making.

Kinematics are propagated link by link, velocities and accelerations in closed form.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.array import Array


@dataclass(frozen=True)
class Moving:
    """Sensor frame in the base frame: rotation (N, 3, 3), acceleration of the origin, angular velocity, acceleration (N, 3), base axes."""

    rotation: Array
    a: Array
    omega: Array
    alpha: Array


@dataclass(frozen=True)
class Arm:
    """Hinges about the z axis of frames that are each placed in the one before by `xyz` and `rpy`, (n + 1, 3) each; last the sensor."""

    xyz: Array
    rpy: Array

    @property
    def n(self) -> int:
        return len(self.xyz) - 1

    @classmethod
    def draw(cls, rng: np.random.Generator) -> Arm:
        n = int(rng.integers(6, 8))
        xyz = rng.uniform(-0.06, 0.06, (n + 1, 3)) + np.outer(rng.uniform(0.05, 0.3, n + 1), [0, 0, 1])
        rpy = rng.uniform(-0.2, 0.2, (n + 1, 3))
        rpy[1:, 0] += rng.choice([-0.5, 0.5], n) * np.pi
        return cls(xyz, rpy)

    def move(self, q: Array, dq: Array, ddq: Array) -> Moving:
        """Velocity and acceleration handed from link to link (N rows at once), then turned into the base frame's axes."""
        rows = len(q)
        R = np.broadcast_to(np.eye(3), (rows, 3, 3))
        omega, alpha, a = np.zeros((rows, 3)), np.zeros((rows, 3)), np.zeros((rows, 3))
        for k in range(self.n + 1):
            r = R @ self.xyz[k]
            a = a + np.cross(alpha, r) + np.cross(omega, np.cross(omega, r))
            R = R @ rotation_of_rpy(self.rpy[k])
            if k < self.n:
                z = R[:, :, 2]
                alpha = alpha + ddq[:, k, None] * z + np.cross(omega, dq[:, k, None] * z)
                omega = omega + dq[:, k, None] * z
                c, s = np.cos(q[:, k]), np.sin(q[:, k])
                x, y = R[:, :, 0].copy(), R[:, :, 1].copy()
                R = np.stack((c[:, None] * x + s[:, None] * y, c[:, None] * y - s[:, None] * x, z), axis=2)
        return Moving(R, a, omega, alpha)

    @property
    def urdf(self) -> str:
        """As a robot description."""
        names = ["base", *(f"l{k + 1}" for k in range(self.n)), "sensor"]
        links = "".join(f'<link name="{name}"/>' for name in names)
        joints = ""
        for k in range(self.n + 1):
            kind = "revolute" if k < self.n else "fixed"
            motion = '<axis xyz="0 0 1"/><limit lower="-6" upper="6" velocity="6" effort="100"/>' if k < self.n else ""
            origin = " ".join(map(repr, self.xyz[k].tolist())), " ".join(map(repr, self.rpy[k].tolist()))
            joints += (
                f'<joint name="j{k + 1}" type="{kind}"><parent link="{names[k]}"/><child link="{names[k + 1]}"/>'
                f'<origin xyz="{origin[0]}" rpy="{origin[1]}"/>{motion}</joint>'
            )
        return f'<robot name="arm">{links}{joints}</robot>'


@dataclass(frozen=True)
class Path:
    """Minimum-jerk moves between postures, each held; then a swing of the last three joints, back and forth.

    Args:
        start: (P,), s, of each move; `lasts`: (P,), s; `goal`: (P + 1, n), rad.
    """

    start: Array
    lasts: Array
    goal: Array

    @classmethod
    def draw(cls, n: int, rng: np.random.Generator, *, one_axis: bool, seconds: float) -> Path:
        start: list[float] = []
        lasts: list[float] = []
        goal, now = [rng.uniform(-2.0, 2.0, n)], 1.2
        while now < seconds - 4.0:
            last = goal[-1]
            if one_axis:
                moves = [(last + np.eye(n)[n - 1] * (np.pi if last[n - 1] < 0 else -np.pi) * rng.uniform(0.6, 1.0), 1.6)]
            elif len(start) % 3 == 2:
                moves = _swing(last, rng)
            else:
                moves = [(rng.uniform(-2.2, 2.2, n), rng.uniform(1.5, 2.5))]
            for target, takes in moves:
                start.append(now)
                lasts.append(takes)
                goal.append(target)
                now += takes
            now += 0.9
        return cls(np.array(start), np.array(lasts), np.array(goal))

    def at(self, t: Array) -> tuple[Array, Array, Array]:
        """Position, velocity and acceleration (N, n) at times t (N,)."""
        k = np.searchsorted(self.start, t, side="right") - 1
        begun = np.maximum(k, 0)
        T = self.lasts[begun][:, None]
        s = np.clip((t - self.start[begun])[:, None] / T, 0.0, 1.0) * (k >= 0)[:, None]
        step = self.goal[begun + 1] - self.goal[begun]
        q = self.goal[begun] + (10 * s**3 - 15 * s**4 + 6 * s**5) * step
        dq = (30 * s**2 - 60 * s**3 + 30 * s**4) / T * step
        ddq = (60 * s - 180 * s**2 + 120 * s**3) / T**2 * step
        return q, dq, ddq

    def holds(self) -> Array:
        """(H, 2), s: from when to when it stands still for longer than half a second."""
        ends = np.concatenate(([0.0], self.start + self.lasts))
        begins = np.append(self.start, ends[-1] + 0.9)
        return np.column_stack((ends, begins))[begins - ends > 0.5]


def _swing(q: Array, rng: np.random.Generator) -> list[tuple[Array, float]]:
    n, moves, at = len(q), [], q
    for joint in (n - 3, n - 2, n - 1):
        for side in (1.0, -1.0, 1.0, -1.0):
            at = at + side * 0.55 * np.eye(n)[joint]
            moves.append((at, float(rng.uniform(0.75, 0.85))))
    return moves


def rotation_of(v: Array) -> Array:
    """Of a rotation vector."""
    angle = float(np.linalg.norm(v))
    if angle == 0.0:
        return np.eye(3)
    x, y, z = v / angle
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * K @ K)


def rotation_of_rpy(rpy: Array) -> Array:
    roll, pitch, yaw = np.eye(3)[0] * rpy[0], np.eye(3)[1] * rpy[1], np.eye(3)[2] * rpy[2]
    return rotation_of(yaw) @ rotation_of(pitch) @ rotation_of(roll)
