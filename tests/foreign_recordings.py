"""Recordings from a generator of their own, for the coverage of the intervals: nothing of the engine takes part in making them.

A random serial arm of six or seven hinges moves along minimum-jerk joint paths between random postures, holds still, and swings its wrist.
Its kinematics are propagated link by link, velocities and accelerations in closed form; the payload is a handful of point masses that obey
Newton's law. What a real sensor, real encoders and a real recorder do to that is added on top. Only the format is the engine's.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from core.array import Array
from core.payload.calibration import SensorCalibration
from core.payload.site import GRAVITY_STD_M_S2, Site
from core.recording.recording import Recording, RobotDescription, SensorDescription

GRAVITY = np.array([0.0, 0.0, -9.81])
NOISE_STD = np.array([0.05, 0.05, 0.07, 0.003, 0.003, 0.003])
RANGE = np.array([145.0, 145.0, 290.0, 5.0, 5.0, 5.0])
RESOLUTION = np.array([0.0625, 0.0625, 0.0625, 0.00133, 0.00133, 0.00133])
NO_CALIBRATION_ERROR = SensorCalibration(gain_std=(0.0,) * 6, crosstalk_std=(0.0,) * 6)

Noise = Literal["white", "ar1", "pink"]
Body = Literal["compact", "plate", "rod", "far"]


@dataclass(frozen=True)
class Condition:
    """What is wrong with a recording, and what it states of that.

    Args:
        rate_hz: of the samples. jitter_s: standard deviation of the sampling instants, which the stamps do not show.
        lost: share of the rows. walk_n: random walk of the force's offset, N/sqrt(s); torques a twentieth of it in N m.
        zero_std_rad, gain_std, mount_std_rad, tilt_rad: standard deviations that each recording's own error is drawn from; stated.
        poses: rows are poses, without joints. averaged: static poses, one row for each. axes: joints that move, all where absent.
    """

    rate_hz: float = 500.0
    noise: Noise = "white"
    walk_n: float = 0.0
    jitter_s: float = 0.0
    lost: float = 0.0
    quantised: bool = False
    zero_std_rad: float = 0.0
    gain_std: float = 0.0
    mount_std_rad: float = 0.0
    tilt_rad: float = 0.0
    delay_s: float = 0.0
    drift_n: float = 0.0
    poses: bool = False
    averaged: bool = False
    one_axis: bool = False
    body: Body = "compact"
    calibration: SensorCalibration = field(default=NO_CALIBRATION_ERROR)


@dataclass(frozen=True)
class Made:
    """A recording and the truth (10,), in the frame of the sensor as it is mounted."""

    recording: Recording
    phi: Array


def make(condition: Condition, seed: int) -> Made:
    """One recording under a condition; arm, motion, payload and every error are drawn from the seed."""
    rng = np.random.default_rng([seed, 17])
    arm = _Arm.draw(rng)
    t = _instants(condition, rng)
    true_t = t + condition.jitter_s * rng.normal(size=len(t)) * (np.abs(t - t.mean()) < 0.49 * np.ptp(t))
    q_path = _Path.draw(arm.n, rng, one_axis=condition.one_axis, seconds=float(t[-1]))
    masses, places = _payload(condition.body, rng)
    mount = _rotation(rng.normal(scale=condition.mount_std_rad, size=3)) if condition.mount_std_rad else np.eye(3)
    zeros = rng.normal(scale=condition.zero_std_rad, size=arm.n) if condition.zero_std_rad else np.zeros(arm.n)
    tilt = _rotation(np.append(rng.normal(scale=condition.tilt_rad, size=2), 0.0)) if condition.tilt_rad else np.eye(3)
    gravity = tilt @ GRAVITY * (1.0 + GRAVITY_STD_M_S2 / 9.81 * rng.normal())

    late = true_t - condition.delay_s
    wrench = _wrench(arm.move(*q_path.at(late)), mount, masses, places, gravity)
    wrench = wrench * (1.0 + (rng.normal(scale=condition.gain_std, size=6) if condition.gain_std else np.zeros(6)))
    wrench = wrench + rng.normal(size=6) * [4, 4, 4, 0.2, 0.2, 0.2] + _slow(condition, t, rng) + NOISE_STD * _noise(condition.noise, t, rng)
    q = q_path.at(true_t)[0]
    read = q - zeros + 2e-6 * rng.normal(size=q.shape)
    if condition.averaged:
        t, wrench, read = _averaged(t, wrench, read, q_path)
    elif condition.lost:
        kept = rng.random(len(t)) >= condition.lost
        t, wrench, read = t[kept], wrench[kept], read[kept]
    if condition.quantised:
        wrench = np.round(wrench / RESOLUTION) * RESOLUTION
    return Made(_recording(condition, arm, t, wrench, read), _phi(masses, places))


def _recording(condition: Condition, arm: _Arm, t: Array, wrench: Array, q: Array) -> Recording:
    calibration = replace_gain(condition) if condition.gain_std else condition.calibration
    sensor = SensorDescription(NOISE_STD, RANGE, RESOLUTION, calibration=calibration, mount_std_rad=condition.mount_std_rad)
    plain = Recording(t, GRAVITY, wrench=wrench, sensor=sensor, zero_std_rad=condition.zero_std_rad)
    if not condition.poses:
        joints = tuple(f"j{k + 1}" for k in range(arm.n))
        return replace(plain, q=q, robot=RobotDescription(arm.urdf, joints, "base", "sensor"), site=_SITE)
    pose = arm.move(q, np.zeros_like(q), np.zeros_like(q))
    return replace(plain, orientation=pose.rotation, site=_SITE)


def replace_gain(condition: Condition) -> SensorCalibration:
    """A certificate that states the gains' uncertainty as it is."""
    return SensorCalibration(gain_std=(condition.gain_std,) * 6, crosstalk_std=(0.0,) * 6)


_SITE = Site(latitude_deg=50.0)
"""Says that gravity is known as well as a formula knows it; each recording's own is drawn from that."""


@dataclass(frozen=True)
class _Moving:
    """Sensor frame in the base frame: rotation (N, 3, 3), acceleration of the origin, angular velocity, acceleration (N, 3), base axes."""

    rotation: Array
    a: Array
    omega: Array
    alpha: Array


@dataclass(frozen=True)
class _Arm:
    """Hinges about the z axis of frames that are each placed in the one before by `xyz` and `rpy`, (n + 1, 3) each; last the sensor."""

    xyz: Array
    rpy: Array

    @property
    def n(self) -> int:
        return len(self.xyz) - 1

    @classmethod
    def draw(cls, rng: np.random.Generator) -> _Arm:
        n = int(rng.integers(6, 8))
        xyz = rng.uniform(-0.06, 0.06, (n + 1, 3)) + np.outer(rng.uniform(0.05, 0.3, n + 1), [0, 0, 1])
        rpy = rng.uniform(-0.2, 0.2, (n + 1, 3))
        rpy[1:, 0] += rng.choice([-0.5, 0.5], n) * np.pi
        return cls(xyz, rpy)

    def move(self, q: Array, dq: Array, ddq: Array) -> _Moving:
        """Velocity and acceleration handed from link to link (N rows at once), then turned into the base frame's axes."""
        rows = len(q)
        R = np.broadcast_to(np.eye(3), (rows, 3, 3))
        omega, alpha, a = np.zeros((rows, 3)), np.zeros((rows, 3)), np.zeros((rows, 3))
        for k in range(self.n + 1):
            r = R @ self.xyz[k]
            a = a + np.cross(alpha, r) + np.cross(omega, np.cross(omega, r))
            R = R @ _of_rpy(self.rpy[k])
            if k < self.n:
                z = R[:, :, 2]
                alpha = alpha + ddq[:, k, None] * z + np.cross(omega, dq[:, k, None] * z)
                omega = omega + dq[:, k, None] * z
                c, s = np.cos(q[:, k]), np.sin(q[:, k])
                x, y = R[:, :, 0].copy(), R[:, :, 1].copy()
                R = np.stack((c[:, None] * x + s[:, None] * y, c[:, None] * y - s[:, None] * x, z), axis=2)
        return _Moving(R, a, omega, alpha)

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
class _Path:
    """Minimum-jerk moves between postures, each held; then a swing of the last three joints, back and forth.

    Args:
        start: (P,), s, of each move; `lasts`: (P,), s; `goal`: (P + 1, n), rad.
    """

    start: Array
    lasts: Array
    goal: Array

    @classmethod
    def draw(cls, n: int, rng: np.random.Generator, *, one_axis: bool, seconds: float) -> _Path:
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
        q = np.broadcast_to(self.goal[0], (len(t), self.goal.shape[1])).copy()
        dq, ddq = np.zeros_like(q), np.zeros_like(q)
        for k, (begin, T) in enumerate(zip(self.start, self.lasts, strict=True)):
            s = np.clip((t - begin) / T, 0.0, 1.0)[:, None]
            step = self.goal[k + 1] - self.goal[k]
            q += (10 * s**3 - 15 * s**4 + 6 * s**5) * step
            dq += (30 * s**2 - 60 * s**3 + 30 * s**4) / T * step
            ddq += (60 * s - 180 * s**2 + 120 * s**3) / T**2 * step
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


def _instants(condition: Condition, rng: np.random.Generator) -> Array:
    seconds = 150.0 if condition.averaged else 34.0
    return np.arange(round(seconds * condition.rate_hz)) / condition.rate_hz + 1e-4 * rng.random()


def _averaged(t: Array, wrench: Array, q: Array, path: _Path) -> tuple[Array, Array, Array]:
    holds = [np.flatnonzero((t > begin + 0.1) & (t < end - 0.05)) for begin, end in path.holds()]
    rows = [k for k in holds if len(k)]
    return (
        np.array([t[k].mean() for k in rows]),
        np.array([wrench[k].mean(axis=0) for k in rows]),
        np.array([q[k].mean(axis=0) for k in rows]),
    )


def _payload(body: Body, rng: np.random.Generator) -> tuple[Array, Array]:
    """Masses (P,) and places (P, 3) in the sensor frame."""
    size = {"compact": (0.06, 0.05, 0.04), "plate": (0.12, 0.09, 1e-4), "rod": (0.15, 1e-4, 1e-4), "far": (0.04, 0.04, 0.04)}[body]
    distance = 0.3 if body == "far" else 0.06
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)
    turn = _rotation(rng.normal(size=3))
    places = (
        (corners * size * rng.uniform(0.8, 1.2, (8, 1))) @ turn.T + distance * np.array([0.1, -0.15, 1.0]) + rng.normal(scale=0.01, size=3)
    )
    mass = float(rng.uniform(0.8, 3.0))
    return mass * rng.dirichlet(np.full(8, 8.0)), places


def _phi(masses: Array, places: Array) -> Array:
    inertia = sum(m * (r @ r * np.eye(3) - np.outer(r, r)) for m, r in zip(masses, places, strict=True))
    return np.concatenate(([masses.sum()], masses @ places, np.asarray(inertia)[np.triu_indices(3)]))


def _wrench(moving: _Moving, mount: Array, masses: Array, places: Array, gravity: Array) -> Array:
    """(N, 6), in the axes of the sensor, which is turned by `mount` in the nominal frame."""
    R = moving.rotation @ mount
    force, torque = np.zeros((len(R), 3)), np.zeros((len(R), 3))
    for m, place in zip(masses, places, strict=True):
        r = R @ place
        pull = m * (moving.a + np.cross(moving.alpha, r) + np.cross(moving.omega, np.cross(moving.omega, r)) - gravity)
        force, torque = force + pull, torque + np.cross(r, pull)
    return np.concatenate((np.einsum("nji,nj->ni", R, force), np.einsum("nji,nj->ni", R, torque)), axis=1)


def _slow(condition: Condition, t: Array, rng: np.random.Generator) -> Array:
    unit = np.array([1.0, 1.0, 1.0, 0.05, 0.05, 0.05])
    walk = np.cumsum(rng.normal(size=(len(t), 6)), axis=0) * np.sqrt(np.median(np.diff(t)))
    ramp = condition.drift_n * (1.0 - np.exp(-2.0 * t / t[-1]))[:, None]
    return np.asarray((condition.walk_n * walk + ramp) * unit)


def _noise(kind: Noise, t: Array, rng: np.random.Generator) -> Array:
    """(N, 6) of unit variance."""
    fresh = rng.normal(size=(len(t), 6))
    if kind == "ar1":
        for k in range(1, len(t)):
            fresh[k] = 0.9 * fresh[k - 1] + np.sqrt(1.0 - 0.81) * fresh[k]
    elif kind == "pink":
        spectrum = np.fft.rfft(fresh, axis=0)
        spectrum /= np.sqrt(np.maximum(np.arange(len(spectrum)), 1.0))[:, None]
        fresh = np.fft.irfft(spectrum, n=len(t), axis=0)
        fresh = fresh / fresh.std(axis=0)
    return fresh


def _rotation(v: Array) -> Array:
    """Of a rotation vector."""
    angle = float(np.linalg.norm(v))
    if angle == 0.0:
        return np.eye(3)
    x, y, z = v / angle
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * K @ K)


def _of_rpy(rpy: Array) -> Array:
    roll, pitch, yaw = np.eye(3)[0] * rpy[0], np.eye(3)[1] * rpy[1], np.eye(3)[2] * rpy[2]
    return _rotation(yaw) @ _rotation(pitch) @ _rotation(roll)
