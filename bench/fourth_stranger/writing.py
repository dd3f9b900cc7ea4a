"""The folder of a recording, as the specification describes it, in the form that a scene has."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin
import pyarrow as pa
import pyarrow.parquet as pq
from scipy.interpolate import CubicSpline

from bench.fourth_stranger.machines import describe_machine
from bench.fourth_stranger.reading import find_steps
from bench.fourth_stranger.scene import Scene
from bench.second_stranger.array import Array
from bench.second_stranger.reading import Reference, convert
from bench.second_stranger.rig import Rig
from bench.second_stranger.sensing import Samples
from bench.second_stranger.writing import CHANNELS, ENCODER_STEP, label_phases

JOINT_NOISE, SPEED_NOISE = 2e-6, 4e-4
"""rad and rad/s."""
EPOCH_S = 1_764_300_000.0
COMMANDED_AHEAD_S, DRIVE_FRICTION, DRIVE_NOISE = 0.003, 0.006, 0.002
"""s; and shares of what the joints can bear."""
SHARE_WITH_HALL, SHARE_WITH_CERTIFICATE = 0.12, 0.25
"""Of recordings: those with a temperature that has nothing to do with the wrench, and those with the sensor's certificate."""
Columns = dict[str, "pa.Array[Any] | list[str]"]


def write_recording(
    rng: np.random.Generator,
    folder: Path,
    scene: Scene,
    samples: Samples,
    wrench: Array,
    temperature: Array | None,
    reference: Reference | None,
) -> None:
    """Writes the folder; what stood in it under the same names is overwritten.

    Args:
        samples: the motion as it is recorded but for noise and rounding.
        wrench: (M, 6), N and N m, as the file has it but for its sign.
        temperature: (N,), degrees Celsius, on the grid; without one that of the hall may be recorded.
        reference: what the file says of the payload; nothing for None.
    """
    folder.mkdir(parents=True, exist_ok=True)
    sign = -1 if rng.random() < 0.15 else 1
    columns = _list_columns(rng, scene, samples, sign * wrench, temperature)
    pq.write_table(pa.table(columns), folder / "samples.parquet", compression="zstd")
    if scene.form.log == "joints":
        (folder / "robot.urdf").write_text(describe_machine(scene.rig.arm))
    (folder / "recording.json").write_text(json.dumps(_describe(rng, scene, wrench, reference, sign), indent=1))


def _list_columns(rng: np.random.Generator, scene: Scene, samples: Samples, wrench: Array, temperature: Array | None) -> Columns:
    """By name, in the order of the file."""
    rig, form = scene.rig, scene.form
    began_s = EPOCH_S + float(np.round(rng.uniform(0, 4e5), 3)) if form.is_epoch else 0.0
    columns: Columns = {"t": pa.array(np.round(rig.times + began_s, 6))}
    found = _list_joints(rng, scene, samples) if form.log == "joints" else _list_poses(scene, samples)
    columns |= {name: pa.array(x) for name, x in found.items()}
    stored = pa.float32() if form.is_single else pa.float64()
    columns |= {name: pa.array(wrench[:, i], stored) for i, name in enumerate(CHANNELS)}
    if temperature is None and rng.random() < SHARE_WITH_HALL:
        temperature = 21.5 + rng.uniform(-0.5, 0.7) * rig.t / rig.seconds
    if temperature is not None:
        read_off = np.interp(rig.times, rig.t, temperature)
        columns["temperature"] = pa.array(np.round(read_off + 0.04 * rng.normal(size=len(rig.times)), 1))
    if form.is_labelled:
        columns["phase"] = label_phases(rig)
    return columns


def _list_joints(rng: np.random.Generator, scene: Scene, samples: Samples) -> dict[str, Array]:
    rig, extras = scene.rig, scene.form.extras
    q = convert(samples.joints.q + JOINT_NOISE * rng.normal(size=samples.joints.q.shape), ENCODER_STEP)
    columns = {f"q_{i + 1}": q[:, i] for i in range(rig.joint_count)}
    if extras == "speeds":
        dq = convert(samples.joints.dq + SPEED_NOISE * rng.normal(size=q.shape), SPEED_NOISE / 4)
        columns |= {f"dq_{i + 1}": dq[:, i] for i in range(rig.joint_count)}
    if extras in ("commands", "drives"):
        commanded = CubicSpline(rig.t, rig.q)(np.minimum(rig.times + COMMANDED_AHEAD_S, rig.t[-1]))
        columns |= {f"q_cmd_{i + 1}": commanded[:, i] for i in range(rig.joint_count)}
    if extras == "drives":
        tau = _find_drives(rng, rig, samples)
        columns |= {f"tau_{i + 1}": tau[:, i] for i in range(rig.joint_count)}
    return columns


def _find_drives(rng: np.random.Generator, rig: Rig, samples: Samples) -> Array:
    """(M, n), N m: what the drives report, with the friction of their gears."""
    limits, dq = rig.arm.torque_limits, samples.joints.dq
    needed = np.stack([np.interp(rig.times, rig.t, column) for column in rig.torques.T], 1)
    rubbing = DRIVE_FRICTION * limits * (np.tanh(dq / 0.01) + 0.4 * dq)
    return convert(needed + rubbing + DRIVE_NOISE * limits * rng.normal(size=dq.shape), 2e-4 * limits)


def _list_poses(scene: Scene, samples: Samples) -> dict[str, Array]:
    """Orientation without a jump from one sign to the other, as a filter sends it, and the place where that is recorded."""
    quaternions = np.array([pin.Quaternion(R).coeffs() for R in samples.motion.R])
    turns = np.where(np.sum(quaternions[1:] * quaternions[:-1], 1) < 0, -1, 1)
    quaternions[1:] *= np.cumprod(turns)[:, None]
    columns = {f"q{axis}": np.round(quaternions[:, i], 7) for i, axis in enumerate("xyzw")}
    if scene.form.log == "poses":
        columns |= {f"p{axis}": np.round(samples.motion.p[:, i], 7) for i, axis in enumerate("xyz")}
    return columns


def _describe(rng: np.random.Generator, scene: Scene, wrench: Array, reference: Reference | None, sign: int) -> dict[str, object]:
    """The manifest."""
    rig, form = scene.rig, scene.form
    sensor: dict[str, object] = {"sign": sign}
    if form.stated:
        sensor["noise_std"] = [float(f"{each:.4g}") for each in form.stated * rig.noise_std]
    if form.has_range:
        most = np.maximum(np.abs(wrench).max(0) * 1.4, 1200 * rig.noise_std)
        sensor["range"] = [float(f"{each:.2g}") for each in most]
    sensor["resolution"] = find_steps(scene).tolist()
    if rng.random() < SHARE_WITH_CERTIFICATE:
        sensor["calibration"] = {"gain_std": [0.005] * 6, "crosstalk_std": [0.003] * 6, "source": "certificate"}
    manifest: dict[str, object] = {"format": "recording/1"}
    if form.log == "joints":
        names = [f"j{i + 1}" for i in range(rig.joint_count)]
        manifest["robot"] = {"urdf": "robot.urdf", "joints": names, "base_frame": "base", "sensor_frame": "ft_sensor"}
    manifest["gravity"] = rig.gravity.tolist()
    if form.is_direction:
        manifest["gravity"] = np.round(rig.gravity / np.linalg.norm(rig.gravity), 9).tolist()
        manifest["site"] = {"latitude_deg": scene.site[0], "elevation_m": scene.site[1]}
    manifest["sensor"] = sensor
    if reference is not None:
        manifest["payload_reference"] = {
            "mass": float(reference.mass),
            "first_moment": np.round(reference.first_moment, 8).tolist(),
            "inertia": np.round(reference.inertia[np.triu_indices(3)], 10).tolist(),
            "source": "CAD",
        }
    return manifest
