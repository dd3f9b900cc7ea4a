"""A robot at work, drawn whole by a seed: its arm and motion, what it carries, its sensor, and what is never quite right on a real one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter1d

from bench.stranger.arms import ARMS, Arm
from bench.stranger.array import Array
from bench.stranger.kinematics import Felt, Kinematics, Loads, find_loads, move_arm
from bench.stranger.motions import Path, draw_motion
from bench.stranger.rigid_body import Body
from bench.stranger.rotations import rotate_by_vector
from bench.stranger.signals import PAD, derive, list_times

GRAVITY = np.array([0, 0, -9.81])
"""(3,), m/s^2, base axes."""
DEGREE = np.pi / 180
ZEROS_DEG, TILT_DEG, GAIN, STAMP_S, ENCODER_RAD = 0.01, 0.03, 1e-3, 5e-5, 1e-5
"""Standard deviations of what is never quite right."""


@dataclass(frozen=True)
class Sensor:
    """Six channels, N and N m: the noise's standard deviation, the offset, the steps of the converter and the range, each (6,)."""

    noise_std: Array
    offset: Array
    resolution: Array
    range: Array


@dataclass(frozen=True)
class Background:
    """What every recording has and no one means.

    Attributes:
        zeros: (n,), rad, of the joints.
        tilt: (3,), rotation vector in rad of gravity, base axes.
        gain: (6,), error of the sensitivity.
        drift: (N, 6), N and N m, 0.15 of the noise from end to end.
        stiffness: (n,), N m/rad, under the payload's weight; None where the joints do not give.
    """

    zeros: Array
    tilt: Array
    gain: Array
    drift: Array
    stiffness: Array | None


@dataclass(frozen=True)
class Rig:
    """All that a recording is made of but the planted causes. N steps of the grid, M samples, n joints.

    Attributes:
        kind: of the motion.
        rate: of the samples, Hz.
        path: what is commanded.
        t: (N,), s.
        seconds: length of the recording.
        q, dq, ddq: (N, n), of the motors: what is commanded, 8 to 30 ms later.
        times: (M,), s, when samples are taken.
        jitter: (M,), s, by which their stamps are off.
        white: (M, 6), the noise in standard deviations.
        encoder_noise: (M, n), rad.
        nominal, loads: as the measured joints have it, without background.
        with_torques: whether the joints' torques are recorded in any case.
    """

    seed: int
    arm: Arm
    kind: str
    rate: int
    path: Path
    t: Array
    seconds: float
    q: Array
    dq: Array
    ddq: Array
    body: Body
    sensor: Sensor
    background: Background
    times: Array
    jitter: Array
    white: Array
    encoder_noise: Array
    nominal: Kinematics
    loads: Loads
    with_torques: bool

    @property
    def steps(self) -> int:
        """N, of the grid."""
        return len(self.t)

    @property
    def joint_count(self) -> int:
        """n."""
        return len(self.arm.joints)

    def sample(self, x: Array, times: Array | None = None) -> Array:
        """(M, k), a signal (N, k) on the grid at the times of the samples, or at others."""
        times = self.times if times is None else times
        return np.stack([np.interp(times, self.t, x[:, i]) for i in range(x.shape[1])], 1)

    def feel(self, k: Felt) -> Felt:
        """What is felt at the times of the samples, of what is felt on the grid."""
        return Felt(self.sample(k.omega), self.sample(k.alpha), self.sample(k.u), self.sample(k.g))


def draw_rig(
    seed: int,
    kind: str | None = None,
    rate: int | None = None,
    mass_kg: tuple[float, float] = (0.6, 4.0),
    elastic: bool | None = None,
    with_torques: bool = False,
) -> Rig:
    """A rig by its seed; what is not given is drawn.

    Args:
        kind: of the motion, as `draw_motion` knows them.
        rate: of the samples, Hz.
        mass_kg: between which the payload's mass lies.
        elastic: whether the joints give a little under the payload.
        with_torques: whether the joints' torques are recorded in any case.
    """
    rng = np.random.default_rng(seed)
    arm = ARMS[str(rng.choice(["sphere6", "offset6", "seven"], p=[0.45, 0.35, 0.2]))]
    rate = rate or int(rng.choice([100, 125, 200, 250, 400, 500], p=[0.25, 0.2, 0.2, 0.15, 0.1, 0.1]))
    kind = kind or str(rng.choice(["proc", "att", "mix", "exc"], p=[0.35, 0.25, 0.2, 0.2]))
    path = draw_motion(rng, arm, kind)
    t = list_times(len(path.q))
    seconds = float(t[-PAD - 1])
    behind = int(rng.uniform(8, 30))
    q = np.vstack([np.repeat(path.q[:1], behind, 0), path.q[:-behind]])
    dq, ddq = derive(q), derive(derive(q))
    body = _draw_body(rng, mass_kg)
    sensor = _draw_sensor(rng)
    background = _draw_background(rng, arm, t, seconds, sensor, elastic)
    times = np.round(np.arange(0, int(seconds * rate)) / rate, 9)
    nominal = move_arm(arm, q, dq, ddq, GRAVITY)
    return Rig(
        seed=seed,
        arm=arm,
        kind=kind,
        rate=rate,
        path=path,
        t=t,
        seconds=seconds,
        q=q,
        dq=dq,
        ddq=ddq,
        body=body,
        sensor=sensor,
        background=background,
        times=times,
        jitter=np.clip(rng.normal(size=len(times)) * STAMP_S, -2e-4, 2e-4),
        white=rng.normal(size=(len(times), 6)),
        encoder_noise=rng.normal(size=(len(times), len(arm.joints))) * ENCODER_RAD,
        nominal=nominal,
        loads=find_loads(arm, q, GRAVITY, nominal, body.mass, body.com),
        with_torques=with_torques,
    )


def _draw_body(rng: np.random.Generator, mass_kg: tuple[float, float]) -> Body:
    """A box of 7 to 20 cm, turned, in front of the sensor."""
    mass = rng.uniform(*mass_kg)
    com = np.array([rng.uniform(-0.035, 0.035), rng.uniform(-0.035, 0.035), rng.uniform(0.03, 0.11)])
    b = rng.uniform(0.07, 0.2, 3)
    inertia = np.diag([b[1] ** 2 + b[2] ** 2, b[0] ** 2 + b[2] ** 2, b[0] ** 2 + b[1] ** 2]) * mass / 12
    R = rotate_by_vector(rng.normal(size=3) * 0.4)
    return Body(mass, com, R @ inertia @ R.T)


def _draw_sensor(rng: np.random.Generator) -> Sensor:
    of_force = rng.uniform(0.03, 0.1) * rng.uniform(0.8, 1.25, 3)
    of_torque = rng.uniform(0.002, 0.006) * rng.uniform(0.8, 1.25, 3)
    noise_std = np.r_[of_force, of_torque]
    force_offset = rng.normal(size=3) * 6
    offset = np.r_[force_offset, rng.normal(size=3) * 0.3]
    offset = offset + np.sign(offset) * np.r_[[0.5] * 3, [0.03] * 3]
    resolution = np.round(noise_std * rng.uniform(0.1, 0.4), 5)
    across, along, torque = rng.choice([150.0, 200.0, 300.0]), rng.choice([300.0, 400.0]), rng.choice([8.0, 10.0, 20.0])
    return Sensor(noise_std, offset, resolution, np.array([across, across, along, torque, torque, torque]))


def _draw_background(rng: np.random.Generator, arm: Arm, t: Array, seconds: float, sensor: Sensor, elastic: bool | None) -> Background:
    n = len(arm.joints)
    zeros = rng.normal(size=n) * ZEROS_DEG * DEGREE
    tilt = np.r_[rng.normal(size=2) * TILT_DEG * DEGREE, 0]
    gain = rng.normal(size=6) * GAIN
    rng.normal(size=60)  # used by nothing; without it all draws that follow would be others
    knots = np.linspace(0, seconds, 60)
    drift = np.stack([np.interp(t, knots, np.cumsum(rng.normal(size=60))) for _ in range(6)], 1)
    drift = gaussian_filter1d(drift, 1500, axis=0)
    drift = drift * (sensor.noise_std * 0.15 / (np.ptp(drift, axis=0) + 1e-9))
    stiffness = None
    if rng.random() < 1 / 3 if elastic is None else elastic:
        stiffness = rng.uniform(2e4, 5e4, n)
        stiffness[arm.mid :] = np.inf
    return Background(zeros, tilt, gain, drift, stiffness)
