"""The folder of a recording, as the specification describes it: samples, manifest, robot."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pinocchio as pin
import pyarrow as pa
import pyarrow.parquet as pq
from scipy.ndimage import gaussian_filter1d

from bench.stranger.arms import describe_arm
from bench.stranger.array import Array
from bench.stranger.fault import Planted, Reference
from bench.stranger.rig import GRAVITY, Rig
from bench.stranger.rigid_body import SYMMETRIC
from bench.stranger.rounding import round_all
from bench.stranger.sensing import find_reported_joints, sense
from bench.stranger.signals import derive

CHANNELS = ("fx", "fy", "fz", "tx", "ty", "tz")
ENCODER_STEP = 5e-6
"""rad."""
Columns = dict[str, "Array | list[str]"]


@dataclass(frozen=True)
class Options:
    """Which columns a recording has beside time, joints and wrench, and the sign with which it has the wrench."""

    dq: bool
    cmd: bool
    tau: bool
    temp: bool
    phase: bool
    sign: int


@dataclass(frozen=True)
class Reading:
    """The wrench (M, 6) as the converter gives it, N and N m, and what causes on the reading's side have changed in it."""

    wrench: Array
    changed: Array


def write_recording(folder: Path, rig: Rig, planted: Sequence[Planted], options: Options) -> Reading:
    """Writes the folder; what stood in it under the same names is overwritten."""
    rng = np.random.default_rng(rig.seed + 77)
    folder.mkdir(parents=True, exist_ok=True)
    reading = read_sensor(rig, planted)
    columns = _list_columns(rng, rig, planted, options, reading)
    pq.write_table(pa.table(columns), folder / "samples.parquet", compression="zstd")
    (folder / "robot.urdf").write_text(describe_arm(rig.arm))
    (folder / "recording.json").write_text(json.dumps(_describe(rng, rig, planted, options), indent=1))
    return reading


def read_sensor(rig: Rig, planted: Sequence[Planted]) -> Reading:
    """What comes out of the converter: the wrench with its noise, in steps."""
    noise = quiet = rig.white * rig.sensor.noise_std
    for fault, scale in planted:
        if fault.change_noise is not None:
            noise = fault.change_noise(noise, scale)
    resolution = rig.sensor.resolution
    wrench = converted = np.round((sense(rig, planted) + noise) / resolution) * resolution
    for fault, scale in planted:
        if fault.convert is not None:
            wrench = fault.convert(wrench, scale)
    return Reading(wrench, (noise - quiet) + (wrench - converted))


def _list_columns(rng: np.random.Generator, rig: Rig, planted: Sequence[Planted], options: Options, reading: Reading) -> Columns:
    """By name, in the order of the file."""
    q, dq, _ = find_reported_joints(rig, planted)
    read = np.round((rig.sample(q) + rig.encoder_noise) / ENCODER_STEP) * ENCODER_STEP
    columns: Columns = {"t": rig.times + rig.jitter, **_split("q", read)}
    if options.dq:
        columns |= _split("dq", rig.sample(dq) + rng.normal(size=read.shape) * 8e-4)
    if options.cmd:
        columns |= _split("q_cmd", rig.sample(rig.path.q))
    if options.tau or rig.with_torques:
        columns |= _split("tau", _find_torques(rng, rig, planted, q, dq))
    columns |= {name: options.sign * reading.wrench[:, i] for i, name in enumerate(CHANNELS)}
    temperature = _find_temperature(rng, rig, planted, options)
    if temperature is not None:
        read_off = np.interp(rig.times, rig.t, temperature) + rng.normal(size=len(rig.times)) * 0.02
        columns["temperature"] = np.asarray(np.round(read_off, 2))
    if options.phase and rig.kind != "exc":
        columns["phase"] = label_phases(rig)
    return columns


def _split(name: str, x: Array) -> Columns:
    """Columns of the joints of (M, n), counted from 1."""
    return {f"{name}_{i + 1}": x[:, i] for i in range(x.shape[1])}


def _find_torques(rng: np.random.Generator, rig: Rig, planted: Sequence[Planted], q: Array, dq: Array) -> Array:
    """(M, n), N m, with friction and noise."""
    ideal, speed = find_rigid_torques(rig, q, dq), rig.sample(dq)
    friction = None
    for fault, scale in planted:
        if fault.rub_joints is not None:
            friction = fault.rub_joints(ideal, speed, scale)
    if friction is None:
        friction = 0.25 * np.tanh(speed / 0.004) + 0.15 * speed
    return np.asarray(ideal + friction + rng.normal(size=ideal.shape) * 0.08)


def find_rigid_torques(rig: Rig, q: Array, dq: Array) -> Array:
    """(M, n), N m, of links and payload along joints (N, n), rad, that move by (N, n), rad/s; by Pinocchio."""
    model = pin.buildModelFromXML(describe_arm(rig.arm))
    frame = model.frames[model.getFrameId("ft_sensor")]
    body = rig.body
    model.appendBodyToJoint(frame.parentJoint, pin.Inertia(body.mass, body.com, body.inertia_at_com), frame.placement)
    data = model.createData()
    along = zip(rig.sample(q), rig.sample(dq), rig.sample(derive(dq)), strict=True)
    return np.array([pin.rnea(model, data, *state) for state in along])


def _find_temperature(rng: np.random.Generator, rig: Rig, planted: Sequence[Planted], options: Options) -> Array | None:
    """(N,), degrees Celsius: the cause's, or one that has nothing to do with anything."""
    told = [fault.temperature for fault, _ in planted if fault.temperature is not None]
    if told or not options.temp:
        return told[-1] if told else None
    mean, period = 27 + rng.uniform(-3, 6), rng.uniform(15, 40)
    wander = gaussian_filter1d(rng.normal(size=rig.steps), 4000) * 3
    return np.asarray(mean + 0.15 * np.sin(rig.t / period) + wander)


def label_phases(rig: Rig) -> list[str]:
    """(M,), which axis of the sensor lies along gravity while the arm stands still, and about which it turns; else `transfer`."""
    felt = rig.feel(rig.nominal)
    speed = np.abs(rig.sample(rig.dq)).max(1)
    labels = np.full(len(rig.times), "transfer", dtype=object)
    for stretch in rig.path.stretches:
        within = (rig.times >= stretch.begin_s) & (rig.times < stretch.end_s)
        if stretch.doing == "hold":
            within &= (rig.times > stretch.begin_s + 0.12) & (speed < 2e-3)
        if not within.any():
            continue
        if stretch.doing == "hold":
            g = felt.g[within].mean(0) / 9.81
            axis = np.abs(g).argmax()
            labels[within] = f"hold:{'xyz'[axis]}{'+' if g[axis] > 0 else '-'}" if abs(g[axis]) > 0.996 else "hold:free"
        else:
            power = (felt.omega[within] ** 2).sum(0)
            if power.max() > 0.97 * power.sum():
                labels[within] = f"rotate:{'xyz'[power.argmax()]}"
    return [str(label) for label in labels]


def _describe(rng: np.random.Generator, rig: Rig, planted: Sequence[Planted], options: Options) -> dict[str, object]:
    """The manifest."""
    body, sensor = rig.body, rig.sensor
    reference = Reference(body.mass, body.first_moment, body.inertia)
    off = np.clip(rng.normal(size=10) * 1e-3, -2e-3, 2e-3)
    for fault, _ in planted:
        reference = fault.reference or reference
    m, mc, inertia = reference
    six = np.array([inertia[i, j] for i, j in SYMMETRIC])
    return {
        "format": "recording/1",
        "robot": {
            "urdf": "robot.urdf",
            "joints": [joint.name for joint in rig.arm.joints],
            "base_frame": "base",
            "sensor_frame": "ft_sensor",
        },
        "gravity": GRAVITY.tolist(),
        "sensor": {
            "sign": options.sign,
            "noise_std": round_all(sensor.noise_std, 4),
            "range": round_all(sensor.range, 4),
            "resolution": round_all(sensor.resolution, 4),
        },
        "payload_reference": {
            "mass": round_all(m * (1 + off[0])),
            "first_moment": round_all(mc + np.linalg.norm(mc) * off[1:4]),
            "inertia": round_all(six + six.max() * off[4:10]),
            "source": str(rng.choice(["CAD", "weighed", "CAD and scale"])),
        },
    }
