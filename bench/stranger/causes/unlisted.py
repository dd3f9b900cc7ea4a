"""Causes that the specification has no name for: a diagnosis should say that it does not know."""

from __future__ import annotations

import numpy as np
from scipy import signal
from scipy.ndimage import gaussian_filter1d

from bench.stranger.array import Array
from bench.stranger.causes.payload import add_moved_part
from bench.stranger.draws import draw_direction, draw_sign
from bench.stranger.fault import Fault
from bench.stranger.kinematics import Kinematics
from bench.stranger.rig import DEGREE, Rig
from bench.stranger.rigid_body import read_push
from bench.stranger.signals import STEP_S, derive, draw_wander, lag_once

UNKNOWN = "unknown"


def attract_to_table(rng: np.random.Generator, rig: Rig) -> Fault:
    """A magnetic gripper."""
    table = rig.nominal.p[:, 2].min() - rng.uniform(0.12, 0.22)
    at_15_cm, place = rng.uniform(3, 7), np.r_[0, 0, 0.12]

    def pull(k: Kinematics, scale: float) -> Array:
        height = np.maximum(k.find_place(place)[:, 2] - table, 0.06)
        force = np.zeros((rig.steps, 3))
        force[:, 2] = -at_15_cm * scale * (0.15 / height) ** 3
        return read_push(k.turn_into_sensor(force), place)

    return Fault(
        family=UNKNOWN,
        variant="magnetic gripper is attracted by a steel table: vertical force with the inverse cube of the distance",
        size=lambda scale: {"F_at_15cm": at_15_cm * scale, "table_z": table},
        add_wrench=pull,
        limits=(0.1, 20),
    )


def blow(rng: np.random.Generator, rig: Rig) -> Fault:
    """A fan."""
    heading = rng.uniform(0, 6.28)
    direction = np.r_[np.cos(heading), np.sin(heading), 0.1]
    most, place, normal = rng.uniform(1.0, 2), rig.body.com + np.r_[0, 0, 0.06], draw_direction(rng)
    gusts = gaussian_filter1d(rng.normal(size=rig.steps), 90)
    gusts = gusts / gusts.std() * 0.2
    breathing = 1 + 0.25 * draw_wander(rng, rig.t, rig.seconds, 1, 2)[:, 0] / 6

    def push(k: Kinematics, scale: float) -> Array:
        stream = k.turn_into_sensor(direction)
        area = 0.3 + 0.7 * np.abs(stream @ normal)
        return read_push(stream * (most * scale * area * (breathing + gusts))[:, None], place)

    return Fault(
        family=UNKNOWN,
        variant="air stream of a fan on a flat tool: drag with the projected area, gusts",
        size=lambda scale: {"F": most * scale, "direction": direction},
        add_wrench=push,
    )


def run_spindle(rng: np.random.Generator, rig: Rig) -> Fault:
    """Its rotor keeps its axis."""
    h = rng.uniform(0.12, 0.3)
    axis = np.r_[rng.uniform(-0.3, 0.3, 2), 1]
    axis /= np.linalg.norm(axis)
    on_s = rng.uniform(0.08, 0.2) * rig.seconds
    y = 1 - np.exp(-np.maximum(rig.t - on_s, 0) / 2.5)

    def turn(k: Kinematics, scale: float) -> Array:
        spin = h * scale * y[:, None] * axis
        return np.hstack([np.zeros((rig.steps, 3)), np.cross(k.omega, spin) + derive(spin)])

    return Fault(
        family=UNKNOWN,
        variant="spindle runs up and stays on: gyroscopic torque of its rotor, run-up reaction",
        size=lambda scale: {"h_Nms": h * scale, "axis": axis, "t_on": on_s},
        add_wrench=turn,
        limits=(0.2, 5),
    )


def feel_rotor_magnets(rng: np.random.Generator, rig: Rig) -> Fault:
    """Offsets by the angle of the last joint."""
    noise_std, q = rig.sensor.noise_std, rig.q[:, rig.arm.roll : rig.arm.roll + 1]
    order = int(rng.choice([2, 3, 4]))
    A, B = noise_std * rng.normal(size=6) * 5, noise_std * rng.normal(size=6) * 4
    phase = rng.uniform(0, 6, 6)

    def add(W: Array, scale: float) -> Array:
        wave = np.sin((order + 1) * q)
        return np.asarray(W + scale * (A * np.sin(order * q + phase) + B * np.sign(wave) * np.abs(wave) ** 0.5))

    return Fault(
        family=UNKNOWN,
        variant="sensor's electronics feel the rotor magnets of the last joint: offsets with multiples of that joint's angle",
        size=lambda scale: {"A": A * scale, "B": B * scale, "order": order},
        put_out=add,
    )


def feel_drives(rng: np.random.Generator, rig: Rig) -> Fault:
    """Offsets while a joint turns."""
    joints = [rig.arm.pitch, rig.arm.roll, 0]
    A = rig.sensor.noise_std * rng.normal(size=(3, 6)) * 6

    def add(W: Array, scale: float) -> Array:
        on = np.stack([lag_once(1 - np.exp(-np.abs(rig.dq[:, joint]) / 0.02), 0.05) for joint in joints], 1)
        return np.asarray(W + scale * on @ A)

    return Fault(
        family=UNKNOWN,
        variant="motor drives that are switched on add a rectified offset while their joint turns, either way",
        size=lambda scale: {"offset_per_joint": A * scale, "joints": joints},
        put_out=add,
    )


def dip_into_bath(rng: np.random.Generator, rig: Rig) -> Fault:
    """Lifted and slowed down below a level."""
    level = np.quantile(rig.nominal.p[:, 2], 0.5)
    place, buoyancy, drag = rig.body.com, rng.uniform(2, 4), rng.uniform(4, 12)

    def lift(k: Kinematics, scale: float) -> Array:
        p = k.find_place(place)
        below = 1 / (1 + np.exp(np.clip((p[:, 2] - level) / 0.02, -40, 40)))
        force = -drag * derive(p) * below[:, None]
        force[:, 2] += buoyancy * below
        return read_push(k.turn_into_sensor(force), place) * scale

    return Fault(
        family=UNKNOWN,
        variant="tool dips into a bath: buoyancy below a level, viscous drag",
        size=lambda scale: {"buoyancy_N": buoyancy * scale, "drag_Ns_m": drag * scale, "level_z": level},
        add_wrench=lift,
    )


def shake_floor(rng: np.random.Generator, rig: Rig) -> Fault:
    """A press stands beside the robot."""
    bands_hz = rng.uniform(2, 4), rng.uniform(5, 9)
    x = np.zeros((rig.steps, 3))
    for band in bands_hz:
        b, a = signal.iirpeak(band, 5, fs=1 / STEP_S)
        y = signal.lfilter(b, a, rng.normal(size=(rig.steps, 3)), axis=0)
        x += y / y.std(0) * np.r_[0.2, 0.2, 0.12]
    x *= (1 + 0.6 * np.sin(2 * np.pi * rig.t / rng.uniform(17, 31)))[:, None]
    return Fault(
        family=UNKNOWN,
        variant="a press beside shakes the floor: random narrow-band accelerations of the base in two bands",
        size=lambda scale: {"rms_m_s2": x.std(0) * scale, "bands_hz": list(bands_hz)},
        shake_base=lambda scale: x * scale,
    )


def rock(rng: np.random.Generator, rig: Rig) -> Fault:
    """The robot stands on a platform on water."""
    f = rng.uniform(0.12, 0.35)
    draw_wander(rng, rig.t, rig.seconds, 2, 0.3)  # used by nothing; without it the sway would be another
    b, a = signal.butter(2, [f * 0.7, f * 1.3], "band", fs=20)
    y = signal.filtfilt(b, a, rng.normal(size=(int((rig.seconds + 3) * 20) + 40, 2)), axis=0)
    y = y / y.std(0)
    t = np.arange(len(y)) / 20 - 1.6
    sway = [np.interp(rig.t, t, y[:, i]) * rng.uniform(*most) for i, most in enumerate(((0.5, 0.9), (0.2, 0.5)))]
    x = gaussian_filter1d(np.stack([*sway, 0 * rig.t], 1) * 0.45 * DEGREE, 200, axis=0)
    return Fault(
        family=UNKNOWN,
        variant="platform on water rocks: irregular sway of the base of zero mean",
        size=lambda scale: {"rms_deg": x[:, :2].std(0) * scale / DEGREE, "hz": f},
        turn_gravity=lambda scale: x * scale,
    )


def work_gripper(rng: np.random.Generator, rig: Rig) -> Fault:
    """A slide goes out and in."""
    period_s = rng.uniform(7, 12)
    across = draw_direction(rng, 2) * 0.2
    stroke = np.r_[across, draw_sign(rng)] * rng.uniform(0.008, 0.02)
    mass = 0.25 * rig.body.mass
    y = 0.5 * (1 + np.tanh(3.5 * np.sin(2 * np.pi * rig.t / period_s + rng.uniform(0, 6))))

    def slide(k: Kinematics, scale: float) -> Array:
        x = y[:, None] * stroke * scale
        return add_moved_part(k, rig.body.com, rig.body.com + x, derive(derive(x)), mass)

    return Fault(
        family=UNKNOWN,
        variant="the tool works by itself: a slide of the gripper goes out and in again and again",
        size=lambda scale: {"mass": mass, "stroke_m": stroke * scale, "period_s": period_s},
        add_wrench=slide,
        limits=(0.3, 4),
    )


def turn_in_field(rng: np.random.Generator, rig: Rig) -> Fault:
    """A magnet in the tool."""
    heading = rng.uniform(0, 6.28)
    direction = np.r_[np.cos(heading), np.sin(heading), 0.3]
    moment = draw_direction(rng) * rng.uniform(0.08, 0.2)

    def turn(k: Kinematics, scale: float) -> Array:
        field = k.turn_into_sensor(direction)
        return np.hstack([np.zeros((rig.steps, 3)), -np.cross(np.broadcast_to(moment, field.shape), field)]) * scale

    return Fault(
        family=UNKNOWN,
        variant="permanent magnet in the tool within a horizontal stray field: pure torque with the attitude",
        size=lambda scale: {"moment_times_field_Nm": moment * scale, "direction": direction},
        add_wrench=turn,
    )
