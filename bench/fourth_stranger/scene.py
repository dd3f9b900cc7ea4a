"""A machine at work, drawn whole: how it is mounted, its motion, payload and sensor, and what is never quite right."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from bench.fourth_stranger.forms import Form
from bench.fourth_stranger.machines import Machine, load_machine
from bench.fourth_stranger.motion import Kind, draw_motion
from bench.second_stranger.array import Array
from bench.second_stranger.draws import normalise
from bench.second_stranger.motions import follow_motion
from bench.second_stranger.rig import Background, Rig, find_torques
from bench.second_stranger.rigid_body import Body
from bench.second_stranger.rotations import rotate_by_vector
from bench.second_stranger.signals import STEP_S

SITES = ((52.3, 55.0), (46.9, 540.0), (64.1, 40.0), (1.3, 15.0), (19.4, 2240.0))
"""Latitude, deg, and elevation, m: Hanover, Berne, Reykjavik, Singapore and Mexico City or so."""
STAMP_S, FARTHEST_STAMP_S = 5e-5, 2e-4
ZERO_RAD, TILT_RAD, GAIN = np.radians(0.01), np.radians(0.03), 0.001
NOISE_PER_KG, LEAST_NOISE_N, QUIET = 0.022, 0.0015, 0.4
"""N/kg; N; and how much of it a quiet sensor has."""
LEVER_OF_NOISE, LEAST_LEVER_M = 0.5, 0.012
"""Noise of torque beside that of force: as share of how far out the payload's centre is, and at least, m."""


@dataclass(frozen=True)
class Wish:
    """What of a scene is not left to chance.

    Attributes:
        seconds: about.
        is_quiet: whether the sensor has less than half the noise.
        is_elastic: whether the joints give a little.
    """

    machine: Machine
    form: Form
    kind: Kind
    seconds: float
    is_quiet: bool
    is_elastic: bool


@dataclass(frozen=True)
class Scene:
    """All that a recording is made of but the planted causes.

    Attributes:
        colours: (6,), of the noise: how much of a sample's the next one has.
        site: latitude, deg, and elevation, m.
        is_tared: whether the zero was set with the load on.
    """

    rig: Rig
    form: Form
    colours: Array
    site: tuple[float, float]
    is_tared: bool

    def list_resting(self) -> Array:
        """(M,), whether the arm stands still at each sample."""
        ends = np.array([stretch.end_s for stretch in self.rig.stretches])
        is_hold = np.array([stretch.label.startswith("hold") for stretch in self.rig.stretches])
        return np.asarray(is_hold[np.minimum(np.searchsorted(ends, self.rig.times, side="right"), len(ends) - 1)])

    def show_what_counts(self) -> Rig:
        """The rig with those samples alone whose wrench can be predicted: all of them, or at rest where no position is recorded."""
        if self.form.log != "attitude":
            return self.rig
        resting = self.list_resting()
        return replace(self.rig, times=self.rig.times[resting], jitter=self.rig.jitter[resting])


def draw_scene(rng: np.random.Generator, wish: Wish) -> Scene:
    """A scene; the order of the draws is part of the recordings."""
    machine, form = wish.machine, wish.form
    site = SITES[int(rng.integers(len(SITES)))]
    down = normalise(list(machine.downs[int(rng.integers(len(machine.downs)))]))
    gravity = np.round(find_g(*site) * down, 6) + 0.0
    stretches = draw_motion(rng, machine, -down, wish.kind, wish.seconds)
    t = np.arange(int(stretches[-1].end_s / STEP_S) + 1, dtype=float) * STEP_S
    q = follow_motion(stretches, t)
    body = _draw_body(rng, machine)
    level = max(body.mass * NOISE_PER_KG, LEAST_NOISE_N) * (QUIET if wish.is_quiet else 1)
    lever = max(LEVER_OF_NOISE * float(np.linalg.norm(body.com)), LEAST_LEVER_M)
    noise_std = np.array([1, 1, 1.35, lever, lever, 0.75 * lever]) * level * rng.uniform(0.85, 1.2, 6) * machine.noise_shape
    background = Background(
        zeros=ZERO_RAD * rng.normal(size=machine.joint_count),
        tilt=TILT_RAD * normalise(rng.normal(size=2)),
        gain=GAIN * rng.normal(size=6),
        drift=_draw_drift(rng, t, noise_std),
    )
    times = _list_times(rng, form, stretches[-1].end_s)
    rig = Rig(
        arm=machine,
        gravity=gravity,
        motion=wish.kind,
        rate=round(form.rate),
        stretches=stretches,
        t=t,
        q=q,
        torques=find_torques(load_machine(machine), body, gravity, t, q),
        body=body,
        noise_std=noise_std,
        offset=np.zeros(6),
        background=background,
        is_elastic=wish.is_elastic,
        times=times,
        jitter=np.clip(STAMP_S * rng.normal(size=len(times)), -FARTHEST_STAMP_S, FARTHEST_STAMP_S),
    )
    is_tared = bool(rng.random() < 0.5)
    offset = (80 if is_tared else 400) * noise_std * rng.uniform(-1, 1, 6)
    rig = replace(rig, offset=offset - rig.load[0] if is_tared else offset)
    return Scene(rig, form, rng.uniform(0, 0.5, 6), site, is_tared)


def find_g(latitude_deg: float, elevation_m: float) -> float:
    """m/s^2, by the international formula of 1980 with the free-air gradient."""
    x = np.radians(latitude_deg)
    return float(9.780327 * (1 + 0.0053024 * np.sin(x) ** 2 - 0.0000058 * np.sin(2 * x) ** 2) - 3.086e-6 * elevation_m)


def _draw_body(rng: np.random.Generator, machine: Machine) -> Body:
    """Three plates askew to each other, whose centre is as far from the sensor as the machine's payloads are."""
    low, high = machine.mass_kg
    mass = float(np.round(low * (high / low) ** rng.random(), 4))
    size = 0.11 * (mass / 2) ** (1 / 3)
    inertia = np.zeros((3, 3))
    for share in rng.dirichlet([4, 4, 4]):
        a, b = size * rng.uniform(0.8, 1.6, 2)
        plate, R = np.diag([b * b, a * a, a * a + b * b]) / 12, rotate_by_vector(rng.normal(size=3))
        apart = 0.35 * size * rng.normal(size=3)
        inertia += mass * share * (R @ plate @ R.T + apart @ apart * np.eye(3) - np.outer(apart, apart))
    toward = normalise([0.5 * rng.normal(), 0.5 * rng.normal(), 1.0])
    return Body(mass, rng.uniform(*machine.reach_m) * toward, inertia)


def _draw_drift(rng: np.random.Generator, t: Array, noise_std: Array) -> Array:
    """(N, 6), N and N m: slow waves, within a quarter of the noise."""
    x = t[:, None] / t[-1]
    slow = 0.14 * np.cos(np.pi * (rng.uniform(0.4, 1.0, 6) * x + rng.uniform(0, 2, 6)))
    return np.asarray(noise_std * (slow + 0.07 * np.sin(2 * np.pi * (rng.uniform(1.0, 2.6, 6) * x + rng.uniform(0, 1, 6)))))


def _list_times(rng: np.random.Generator, form: Form, seconds: float) -> Array:
    """(M,), s: of the samples."""
    count = int((seconds - 0.03) * form.rate)
    times = np.arange(count) / form.rate
    if form.uneven:
        shape = 1 / form.uneven**2
        steps = 0.25 + 0.75 * rng.gamma(shape, 1 / shape, count)
        times = np.cumsum(steps) * (seconds - 0.03) / np.sum(steps)
    if form.is_halved:
        keep = (times < rng.uniform(0.35, 0.65) * seconds) | (np.arange(count) % 2 == 0)
        times = times[keep]
    return np.round(times + 0.006, 6)
