"""A robot at work in a form of recording, drawn whole: arm, where it stands, motion, payload, sensor, and what is never quite right."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from bench.second_stranger.arms import Arm, load_model
from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Planted, Size
from bench.second_stranger.motions import Stretch, follow_motion
from bench.second_stranger.rig import Background, Rig, find_torques
from bench.second_stranger.rigid_body import Body
from bench.second_stranger.rotations import rotate_by_vector
from bench.second_stranger.signals import STEP_S, resonate
from bench.third_stranger.arms import ARMS, HOLLOW
from bench.third_stranger.forms import Form
from bench.third_stranger.tours import Tour, draw_poses, draw_tour

SITES = (9.8128, 9.7963, 9.8067, 9.7815)
"""m/s^2: Hamburg, Atlanta, Milan, Mexico City or so."""
SHARES = (0.24, 0.38, 0.38)
"""Of recordings that each arm has about."""
STAMP_S, FARTHEST_STAMP_S = 5e-5, 2e-4
ZERO_RAD, TILT_RAD, GAIN = np.radians(0.01), np.radians(0.03), 0.001
FILTER_DAMPING = 0.8
AVERAGED = 20
"""Samples to a pose."""
QUIET = 0.55


@dataclass(frozen=True)
class Wish:
    """What of a scene is not left to chance.

    Attributes:
        seconds: about; poses take as long as there are.
        mass_kg: between which the payload's mass lies.
        is_quiet: whether the sensor has about half the noise.
        is_level: whether the arm certainly stands upright.
        is_elastic: whether the joints give a little.
    """

    form: Form
    tour: Tour
    seconds: float
    mass_kg: tuple[float, float]
    is_quiet: bool
    is_level: bool
    is_elastic: bool


@dataclass(frozen=True)
class Scene:
    """All that a recording is made of but the planted causes.

    Attributes:
        colours: (6,), of the noise: how much of a sample's the next one has.
        always: what is in the background besides what a rig has: the sensor's own filter, where it has one.
        is_tared: whether the zero was set with the load on.
    """

    rig: Rig
    form: Form
    colours: Array
    always: tuple[Planted, ...]
    is_tared: bool

    @property
    def row_noise(self) -> Array:
        """(6,), N and N m, of a row of the recording; the rig's noise, but for one sample of those that a pose is averaged of."""
        return self.rig.noise_std

    @property
    def stated_noise(self) -> Array:
        """(6,), N and N m, of a sample."""
        return np.asarray(self.rig.noise_std * np.sqrt(AVERAGED if self.form.poses else 1))

    def list_resting(self) -> Array:
        """(M,), whether the arm stands still at each sample."""
        ends = np.array([stretch.end_s for stretch in self.rig.stretches])
        is_hold = np.array([stretch.label.startswith("hold") for stretch in self.rig.stretches])
        return np.asarray(is_hold[np.minimum(np.searchsorted(ends, self.rig.times, side="right"), len(ends) - 1)])

    def show_what_counts(self) -> Rig:
        """The rig with those samples alone whose wrench can be predicted: all of them, or at rest where no position is recorded."""
        if self.form.log != "attitude" or self.form.poses:
            return self.rig
        resting = self.list_resting()
        return replace(self.rig, times=self.rig.times[resting], jitter=self.rig.jitter[resting])


def draw_scene(rng: np.random.Generator, wish: Wish) -> Scene:
    """A scene; the order of the draws is part of the recordings."""
    form = wish.form
    arm = ARMS[int(rng.choice(len(ARMS), p=SHARES))]
    gravity = _draw_gravity(rng, arm, wish.is_level)
    up = -gravity / np.linalg.norm(gravity)
    stretches = (
        draw_poses(rng, arm, up, form.poses) if form.poses else draw_tour(rng, arm, up, wish.tour, wish.seconds, form.pauses, form.is_moved)
    )
    t = np.arange(int(stretches[-1].end_s / STEP_S) + 1, dtype=float) * STEP_S
    q = follow_motion(stretches, t)
    body = _draw_body(rng, wish.mass_kg)
    level = max(body.mass * 0.022, 0.04) * (QUIET if wish.is_quiet else 1)
    noise_std = np.array([1, 1, 1.4, 0.05, 0.05, 0.035]) * level * rng.uniform(0.85, 1.2, 6)
    toward = rng.normal(size=2)
    background = Background(
        zeros=ZERO_RAD * rng.normal(size=arm.joint_count),
        tilt=TILT_RAD * toward / np.linalg.norm(toward),
        gain=GAIN * rng.normal(size=6),
        drift=_draw_drift(rng, t, noise_std),
    )
    times = _list_times(form, stretches)
    rig = Rig(
        arm=arm,
        gravity=gravity,
        motion="poses" if form.poses else wish.tour,
        rate=round(form.rate),
        stretches=stretches,
        t=t,
        q=q,
        torques=find_torques(load_model(arm), body, gravity, t, q),
        body=body,
        noise_std=noise_std,
        offset=np.zeros(6),
        background=background,
        is_elastic=wish.is_elastic,
        times=times,
        jitter=np.clip(STAMP_S * rng.normal(size=len(times)), -FARTHEST_STAMP_S, FARTHEST_STAMP_S),
    )
    is_tared = bool(rng.random() < 0.55)
    offset = (
        np.array([3, 3, 5, 0.1, 0.1, 0.1]) * rng.normal(size=6)
        if is_tared
        else np.array([20, 20, 30, 0.8, 0.8, 0.8]) * rng.uniform(-1, 1, 6)
    )
    rig = replace(rig, offset=offset - rig.load[0] if is_tared else offset)
    most = 0.6 if form.rate <= 333 else np.exp(-1 / (form.rate * 0.003))
    colours = rng.uniform(0, most, 6)
    always = (Planted(_filter(form.lowpass), 1.0),) if form.lowpass else ()
    return Scene(rig, form, colours, always, is_tared)


def _draw_gravity(rng: np.random.Generator, arm: Arm, is_level: bool) -> Array:
    """(3,), m/s^2, base axes: most stand, some hang, and some of those with a hollow wrist on a wall that leans or a wedge."""
    g, drawn = SITES[int(rng.integers(len(SITES)))], rng.random()
    lean = np.radians(30 if drawn < 0.2 else 180 if drawn < 0.35 else 0)
    if is_level or (lean == np.radians(30) and arm is not HOLLOW):
        lean = 0.0
    return np.round(g * np.array([np.sin(lean), 0, -np.cos(lean)]), 6) + 0.0


def _draw_body(rng: np.random.Generator, mass_kg: tuple[float, float]) -> Body:
    """A cylinder beside a plate, both turned, in front of the sensor."""
    mass = float(np.round(rng.uniform(*mass_kg), 4))
    size = (mass / 2) ** (1 / 3)
    r, h = 0.045 * size * rng.uniform(0.8, 1.3), 0.13 * size * rng.uniform(0.8, 1.4)
    a, b = 0.16 * size * rng.uniform(0.8, 1.2), 0.11 * size * rng.uniform(0.8, 1.2)
    of_cylinder = np.diag([r * r / 4 + h * h / 12, r * r / 4 + h * h / 12, r * r / 2])
    of_plate = np.diag([b * b, a * a, a * a + b * b]) / 12
    R1, R2 = rotate_by_vector(rng.normal(size=3) * 0.35), rotate_by_vector(rng.normal(size=3) * 0.35)
    share = rng.uniform(0.35, 0.65)
    apart = np.array([rng.uniform(-0.04, 0.04), rng.uniform(-0.04, 0.04), h / 2])
    steiner = share * (1 - share) * (apart @ apart * np.eye(3) - np.outer(apart, apart))
    inertia = mass * (share * R1 @ of_cylinder @ R1.T + (1 - share) * R2 @ of_plate @ R2.T + steiner)
    com = np.array([rng.uniform(-0.03, 0.03), rng.uniform(-0.03, 0.03), h / 2 + rng.uniform(0.01, 0.05)])
    return Body(mass, com, inertia)


def _draw_drift(rng: np.random.Generator, t: Array, noise_std: Array) -> Array:
    """(N, 6), N and N m: a slow bend and slower waves, within a quarter of the noise."""
    x = t[:, None] / t[-1]
    bend = rng.normal(size=6) * 0.15 * (x * (1 + 0.5 * x) - 0.8)
    waves = 0.08 * np.sin(2 * np.pi * (rng.uniform(0.5, 2.2, 6) * x + rng.uniform(0, 1, 6)))
    return np.asarray(noise_std * (bend + waves))


def _list_times(form: Form, stretches: list[Stretch]) -> Array:
    """(M,), s: of the samples, or of the middles of the poses."""
    if form.poses:
        return np.array([0.45 * each.begin_s + 0.55 * each.end_s for each in stretches if each.label.startswith("hold")])
    times = np.arange(int((stretches[-1].end_s - 0.01) * form.rate)) / form.rate + 0.004
    for each in stretches:
        if each.label == "pause":
            times = times[(times < each.begin_s) | (times >= each.end_s)]
    return times


def _filter(hz: float) -> Fault:
    """The sensor's own, of second order."""
    return Fault(
        size=lambda _: Size("the sensor's own filter", hz, "Hz"),
        distort=lambda W, _: resonate(W, hz, FILTER_DAMPING),
    )
