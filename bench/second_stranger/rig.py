"""A robot at work, drawn whole: its arm and motion, what it carries, its sensor, and what is never quite right on a real one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import pinocchio as pin
from scipy.interpolate import CubicSpline

from bench.second_stranger.arms import ARMS, SPHERE, Arm, load_model
from bench.second_stranger.array import Array
from bench.second_stranger.kinematics import BaseTurn, JointMotion, Kinematics, move_arm
from bench.second_stranger.motions import HURRIED, Stretch, draw_motion, follow_motion
from bench.second_stranger.rigid_body import Body, find_body_wrench
from bench.second_stranger.rotations import rotate_by_vector, tilt_vectors
from bench.second_stranger.signals import STEP_S, derive

G = 9.81
"""m/s^2."""
FIRST_SAMPLE_S, STAMP_S = 0.004, 5e-5
TORQUES_EVERY = 20
"""Steps of the grid."""
MOST_ROWS = 32000


@dataclass(frozen=True)
class Wish:
    """What of a rig is not left to chance.

    Attributes:
        motion: its kind.
        mass_kg: between which the payload's mass lies.
        is_quiet: whether the sensor has about half the noise.
        least_rate: of the samples, Hz.
        seconds: how long it takes about; drawn where None.
        is_upright: whether the arm certainly does not hang from a ceiling.
        is_elastic: whether the joints give a little.
    """

    motion: str
    mass_kg: tuple[float, float]
    is_quiet: bool
    least_rate: int
    seconds: float | None
    is_upright: bool
    is_elastic: bool


@dataclass(frozen=True)
class Background:
    """What every recording has and no one means.

    Attributes:
        zeros: (n,), rad, of the joints.
        tilt: (2,), rad, of gravity about the base's x and y.
        gain: (6,), error of the sensitivity.
        drift: (N, 6), N and N m, within 0.18 of the noise.
    """

    zeros: Array
    tilt: Array
    gain: Array
    drift: Array


@dataclass(frozen=True)
class Rig:
    """All that a recording is made of but the planted causes. N steps of the grid, M samples, n joints.

    Attributes:
        gravity: (3,), m/s^2, base axes.
        motion: its kind.
        rate: of the samples, Hz.
        t: (N,), s.
        q: (N, n), rad, of the motors.
        torques: (N, n), N m, of links and payload.
        noise_std, offset: (6,), N and N m.
        is_elastic: whether the joints give a little under their torques.
        times: (M,), s, of the samples.
        jitter: (M,), s, by which the wrench is taken off these.
    """

    arm: Arm
    gravity: Array
    motion: str
    rate: int
    stretches: Sequence[Stretch]
    t: Array
    q: Array
    torques: Array
    body: Body
    noise_std: Array
    offset: Array
    background: Background
    is_elastic: bool
    times: Array
    jitter: Array

    @property
    def seconds(self) -> float:
        """Of the motion."""
        return self.stretches[-1].end_s

    @property
    def joint_count(self) -> int:
        """n."""
        return self.arm.joint_count

    @property
    def resolution(self) -> Array:
        """(6,), N and N m, of the converter."""
        return np.asarray(self.noise_std * 0.15)

    @cached_property
    def links(self) -> Array:
        """(N, n), rad: the joints as the links have them."""
        q = self.q + self.background.zeros
        return q - self.torques / (1000 * self.arm.torque_limits) if self.is_elastic else q

    @cached_property
    def tilted_gravity(self) -> Array:
        """(N, 3), m/s^2, base axes."""
        about_x, about_y = self.background.tilt
        return tilt_vectors(self.spread_gravity(len(self.t)), about_x + 0 * self.t, about_y + 0 * self.t)

    @cached_property
    def nominal(self) -> Kinematics:
        """How the sensor moves where nothing is planted, on the grid."""
        return self.move(self.links, self.tilted_gravity)

    @cached_property
    def load(self) -> Array:
        """(N, 6), N and N m: what the sensor reads where nothing is planted, without offset and drift."""
        return find_body_wrench(self.nominal, self.body) * (1 + self.background.gain)

    def spread_gravity(self, count: int) -> Array:
        """(count, 3), m/s^2, base axes: as the file states it."""
        return np.tile(self.gravity, (count, 1))

    def move(
        self,
        q: Array,
        gravity: Array,
        base: BaseTurn | None = None,
        turned: Array | None = None,
        moved: Array | None = None,
    ) -> Kinematics:
        """How the sensor moves with joints (N, n), rad, on the grid; the other arguments are those of `move_arm`."""
        path = CubicSpline(self.t, q)
        return move_arm(self.arm, JointMotion(q, path(self.t, 1), path(self.t, 2)), gravity, base, turned, moved)


def draw_rig(rng: np.random.Generator, wish: Wish) -> Rig:
    """A rig; the order of the draws is part of the recordings."""
    arm = ARMS[int(rng.integers(3))]
    is_hung = arm is SPHERE and rng.random() < 0.4 and not wish.is_upright
    gravity = np.array([0, 0, G if is_hung else -G])
    wished_s = wish.seconds or float(rng.uniform(45, 95))
    rate = _draw_rate(rng, wish, wished_s)
    stretches = draw_motion(rng, arm, wish.motion, wished_s, np.sign(gravity[2]))
    seconds = stretches[-1].end_s
    t = np.arange(int(seconds / STEP_S) + 1, dtype=float) * STEP_S
    q = follow_motion(stretches, t)
    body = _draw_body(rng, wish.mass_kg)
    level = body.mass * 0.022 if body.mass > 2.2 else 0.05
    if wish.is_quiet:
        level *= 0.55
    noise_std = np.array([1, 1, 1.35, 0.05, 0.05, 0.04]) * level * rng.uniform(0.88, 1.15, 6)
    zeros = np.radians(0.01) * rng.normal(size=arm.joint_count)
    toward = rng.normal(size=2)
    tilt = np.radians(0.03) * (toward / np.linalg.norm(toward))
    gain = 0.001 * rng.normal(size=6)
    offset = np.array([6, 6, 9, 0.2, 0.2, 0.2]) * rng.uniform(-1, 1, 6)
    drift = _draw_drift(rng, t, seconds, noise_std)
    count = int((seconds - 0.01) * rate)
    return Rig(
        arm=arm,
        gravity=gravity,
        motion=wish.motion,
        rate=rate,
        stretches=stretches,
        t=t,
        q=q,
        torques=find_torques(load_model(arm), body, gravity, t, q),
        body=body,
        noise_std=noise_std,
        offset=offset,
        background=Background(zeros, tilt, gain, drift),
        is_elastic=wish.is_elastic,
        times=np.arange(count) / rate + FIRST_SAMPLE_S,
        jitter=np.clip(STAMP_S * rng.normal(size=count), -2e-4, 2e-4),
    )


def _draw_rate(rng: np.random.Generator, wish: Wish, seconds: float) -> int:
    """Hz; hurried motions are sampled fast, and long ones not too fast."""
    drawn = int(rng.choice([250, 500, 400] if wish.motion in HURRIED else [100, 125, 200, 250, 500]))
    rate = max(drawn, wish.least_rate)
    return min(rate, 250) if seconds * rate > MOST_ROWS else rate


def _draw_body(rng: np.random.Generator, mass_kg: tuple[float, float]) -> Body:
    """A box that grows with its mass, turned, in front of the sensor."""
    mass = float(np.round(rng.uniform(*mass_kg), 4))
    b = np.array([0.09, 0.07, 0.11]) * (mass / 2) ** (1 / 3) * rng.uniform(0.8, 1.3, 3)
    com = np.array([rng.uniform(-0.035, 0.035), rng.uniform(-0.035, 0.035), b[2] / 2 + rng.uniform(0.0, 0.04)])
    R = rotate_by_vector(rng.normal(size=3) * 0.4)
    inertia = mass / 12 * np.diag([b[1] ** 2 + b[2] ** 2, b[0] ** 2 + b[2] ** 2, b[0] ** 2 + b[1] ** 2])
    return Body(mass, com, R @ inertia @ R.T)


def _draw_drift(rng: np.random.Generator, t: Array, seconds: float, noise_std: Array) -> Array:
    phase = rng.uniform(0, 6, (2, 6))
    slow = np.sin(2 * np.pi * t[:, None] / (2.1 * seconds) + phase[0])
    return np.asarray(0.12 * noise_std * (slow + 0.5 * np.sin(2 * np.pi * t[:, None] / (0.7 * seconds) + phase[1])))


def find_torques(model: pin.Model, body: Body, gravity: Array, t: Array, q: Array) -> Array:
    """(N, n), N m, of links and payload along joints (N, n), rad; by Pinocchio, 50 times in a second with splines between;
    the model, one of its own, is changed."""
    frame = model.frames[model.getFrameId("ft_sensor")]
    model.appendBodyToJoint(frame.parentJoint, pin.Inertia(body.mass, body.com, body.inertia_at_com), frame.placement)
    model.gravity.linear = gravity
    data = model.createData()
    dq = derive(q)
    ddq = derive(dq)
    some = np.arange(0, len(t), TORQUES_EVERY)
    return np.asarray(CubicSpline(t[some], np.array([pin.rnea(model, data, q[i], dq[i], ddq[i]) for i in some]))(t))
