"""Recordings from a generator of their own, for the coverage of the intervals: nothing of the engine takes part in making them.

A random serial arm of six or seven hinges moves along minimum-jerk joint paths between random postures, holds still, and swings its wrist.
Its kinematics are propagated link by link, velocities and accelerations in closed form; the payload is a handful of point masses that obey
Newton's law. What a real sensor, real encoders and a real recorder do to that is added on top. Only the format is the engine's.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.payload.calibration import SensorCalibration
from core.payload.site import GRAVITY_STD_M_S2, Site
from core.recording.recording import Recording, RobotDescription, SensorDescription
from tests.foreign_arm import Arm, Moving, Path, rotation_of

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
class Truth:
    """What a recording was made of.

    Args:
        path: of the joints; t: (N,), s, when the wrench of each sample was felt. masses: (P,); places: (P, 3), of the payload.
        mount: (3, 3), of the sensor on the flange; gravity: (3,), base frame.
        kept: (N,), samples that were recorded; None where rows are means of them.
    """

    arm: Arm
    path: Path
    t: Array
    masses: Array
    places: Array
    mount: Array
    gravity: Array
    kept: NDArray[np.bool_] | None


@dataclass(frozen=True)
class Made:
    """A recording and the truth, `phi` (10,) in the frame of the sensor as it is mounted."""

    recording: Recording
    phi: Array
    truth: Truth


def make(condition: Condition, seed: int, plan: int | None = None) -> Made:
    """One recording under a condition; arm, motion, payload and every error are drawn from the seed.

    Args:
        plan: which of several runs in one cell: they have arm, payload, zeros, gains, mounting and gravity in common.
    """
    rng = np.random.default_rng([seed, 17])
    run = rng if plan is None else np.random.default_rng([seed, 17, plan])
    arm = Arm.draw(rng)
    t = _instants(condition, run)
    true_t = t + condition.jitter_s * run.normal(size=len(t)) * (np.abs(t - t.mean()) < 0.49 * np.ptp(t))
    q_path = Path.draw(arm.n, run, one_axis=condition.one_axis, seconds=float(t[-1]))
    masses, places = _payload(condition.body, rng)
    mount = rotation_of(rng.normal(scale=condition.mount_std_rad, size=3)) if condition.mount_std_rad else np.eye(3)
    zeros = rng.normal(scale=condition.zero_std_rad, size=arm.n) if condition.zero_std_rad else np.zeros(arm.n)
    tilt = rotation_of(np.append(rng.normal(scale=condition.tilt_rad, size=2), 0.0)) if condition.tilt_rad else np.eye(3)
    gravity = tilt @ GRAVITY * (1.0 + GRAVITY_STD_M_S2 / 9.81 * rng.normal())

    late = true_t - condition.delay_s
    wrench = wrench_of(arm.move(*q_path.at(late)), mount, masses, places, gravity)
    wrench = wrench * (1.0 + (rng.normal(scale=condition.gain_std, size=6) if condition.gain_std else np.zeros(6)))
    wrench = wrench + run.normal(size=6) * [4, 4, 4, 0.2, 0.2, 0.2] + _slow(condition, t, run) + NOISE_STD * _noise(condition.noise, t, run)
    q = q_path.at(true_t)[0]
    read = q - zeros + 2e-6 * run.normal(size=q.shape)
    kept = run.random(len(t)) >= condition.lost if condition.lost else np.ones(len(t), dtype=bool)
    if condition.averaged:
        t, wrench, read = average_holds(t, wrench, read, q_path)
    else:
        t, wrench, read = t[kept], wrench[kept], read[kept]
    if condition.quantised:
        wrench = np.round(wrench / RESOLUTION) * RESOLUTION
    truth = Truth(arm, q_path, late, masses, places, mount, gravity, None if condition.averaged else kept)
    return Made(_recording(condition, arm, t, wrench, read), phi_of(masses, places), truth)


def _recording(condition: Condition, arm: Arm, t: Array, wrench: Array, q: Array) -> Recording:
    calibration = replace_gain(condition) if condition.gain_std else condition.calibration
    sensor = SensorDescription(NOISE_STD, RANGE, RESOLUTION, calibration=calibration, mount_std_rad=condition.mount_std_rad)
    plain = Recording(t, GRAVITY, wrench=wrench, sensor=sensor, zero_std_rad=condition.zero_std_rad)
    if not condition.poses:
        joints = tuple(f"j{k + 1}" for k in range(arm.n))
        return replace(plain, q=q, robot=RobotDescription(arm.urdf, joints, "base", "sensor"), site=_SITE)
    pose = arm.move(q, np.zeros_like(q), np.zeros_like(q))
    return replace(plain, orientation=pose.rotation, site=_SITE)


@dataclass(frozen=True)
class LongRun:
    """A sound recording of any length, in pieces: white noise, and nothing wrong with it. The truth (10,) is `phi`."""

    phi: Array
    pieces: Iterator[Recording]


def make_long(seconds: float, rate_hz: float, seed: int, piece_s: float = 30.0) -> LongRun:
    """One recording of so many seconds; arm, motion and payload are drawn from the seed."""
    rng = np.random.default_rng([seed, 18])
    arm = Arm.draw(rng)
    path = Path.draw(arm.n, rng, one_axis=False, seconds=seconds)
    masses, places = _payload("compact", rng)
    offset = rng.normal(size=6) * [4, 4, 4, 0.2, 0.2, 0.2]

    def pieces() -> Iterator[Recording]:
        count, rows = round(seconds * rate_hz), round(piece_s * rate_hz)
        for first in range(0, count, rows):
            t = np.arange(first, min(first + rows, count)) / rate_hz
            moved = path.at(t)
            wrench = wrench_of(arm.move(*moved), np.eye(3), masses, places, GRAVITY) + offset + NOISE_STD * rng.normal(size=(len(t), 6))
            yield _recording(Condition(rate_hz=rate_hz), arm, t, wrench, moved[0] + 2e-6 * rng.normal(size=moved[0].shape))

    return LongRun(phi_of(masses, places), pieces())


def replace_gain(condition: Condition) -> SensorCalibration:
    """A certificate that states the gains' uncertainty as it is."""
    return SensorCalibration(gain_std=(condition.gain_std,) * 6, crosstalk_std=(0.0,) * 6)


_SITE = Site(latitude_deg=50.0)
"""Says that gravity is known as well as a formula knows it; each recording's own is drawn from that."""


def _instants(condition: Condition, rng: np.random.Generator) -> Array:
    seconds = 150.0 if condition.averaged else 34.0
    return np.arange(round(seconds * condition.rate_hz)) / condition.rate_hz + 1e-4 * rng.random()


def average_holds(t: Array, wrench: Array, q: Array, path: Path) -> tuple[Array, Array, Array]:
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
    turn = rotation_of(rng.normal(size=3))
    places = (
        (corners * size * rng.uniform(0.8, 1.2, (8, 1))) @ turn.T + distance * np.array([0.1, -0.15, 1.0]) + rng.normal(scale=0.01, size=3)
    )
    mass = float(rng.uniform(0.8, 3.0))
    return mass * rng.dirichlet(np.full(8, 8.0)), places


def phi_of(masses: Array, places: Array) -> Array:
    inertia = sum(m * (r @ r * np.eye(3) - np.outer(r, r)) for m, r in zip(masses, places, strict=True))
    return np.concatenate(([masses.sum()], masses @ places, np.asarray(inertia)[np.triu_indices(3)]))


def wrench_of(moving: Moving, mount: Array, masses: Array, places: Array, gravity: Array) -> Array:
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
