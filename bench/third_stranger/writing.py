"""The folder of a recording, as the specification describes it, in the form that a scene has."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pinocchio as pin
import pyarrow as pa
import pyarrow.parquet as pq

from bench.second_stranger.arms import describe_arm
from bench.second_stranger.array import Array
from bench.second_stranger.reading import Reference, convert
from bench.second_stranger.sensing import Samples
from bench.second_stranger.writing import CHANNELS, ENCODER_STEP, LEAST_RANGE, Columns, label_phases
from bench.third_stranger.reading import find_steps
from bench.third_stranger.scene import AVERAGED, Scene

JOINT_NOISE, SPEED_NOISE = 2e-6, 4e-4
"""rad and rad/s."""
DIGITS_OF_POSE = 7
SHARE_WITH_HALL, SHARE_WITHOUT_NOISE = 0.12, 0.1
"""Of recordings: those with a temperature that has nothing to do with the wrench, and those that do not state the noise."""
LEAST_RATE_OF_SPEEDS = 60
"""Hz, below which no speeds are recorded."""


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
        (folder / "robot.urdf").write_text(describe_arm(scene.rig.arm))
    manifest = _describe(rng, scene, wrench, reference, sign)
    (folder / "recording.json").write_text(json.dumps(manifest, indent=1))


def _list_columns(rng: np.random.Generator, scene: Scene, samples: Samples, wrench: Array, temperature: Array | None) -> Columns:
    """By name, in the order of the file."""
    rig, form = scene.rig, scene.form
    began_s = float(np.round(rng.uniform(1e3, 9e4), 3)) if rng.random() < 0.35 else 0.0
    columns: Columns = {"t": np.round(rig.times + began_s, 6)}
    columns |= _list_joints(rng, scene, samples) if form.log == "joints" else _list_poses(scene, samples)
    columns |= {name: wrench[:, i] for i, name in enumerate(CHANNELS)}
    if temperature is None and rng.random() < SHARE_WITH_HALL:
        temperature = 22 + rng.uniform(-0.4, 0.8) * rig.t / rig.seconds
    if temperature is not None:
        read_off = np.interp(rig.times, rig.t, temperature)
        columns["temperature"] = np.round(read_off + 0.04 * rng.normal(size=len(rig.times)), 1)
    if rng.random() < 0.4:
        columns["phase"] = label_phases(rig)
    return columns


def _list_joints(rng: np.random.Generator, scene: Scene, samples: Samples) -> Columns:
    rig, form = scene.rig, scene.form
    step = np.radians(form.joint_step_deg) if form.joint_step_deg else ENCODER_STEP
    q = convert(samples.joints.q + JOINT_NOISE * rng.normal(size=samples.joints.q.shape), step)
    columns: Columns = {f"q_{i + 1}": q[:, i] for i in range(rig.joint_count)}
    has_speeds = rng.random() < 0.4 and form.rate >= LEAST_RATE_OF_SPEEDS and not form.poses and not form.joint_step_deg
    if has_speeds:
        dq = convert(samples.joints.dq + SPEED_NOISE * rng.normal(size=q.shape), SPEED_NOISE / 4)
        columns |= {f"dq_{i + 1}": dq[:, i] for i in range(rig.joint_count)}
    return columns


def _list_poses(scene: Scene, samples: Samples) -> Columns:
    """Orientation with a positive qw, as controllers send it, and the place where that is recorded."""
    motion = samples.motion
    quaternions = np.array([pin.Quaternion(R).coeffs() for R in motion.R])
    quaternions = np.round(quaternions * np.where(quaternions[:, 3:] < 0, -1, 1), DIGITS_OF_POSE)
    columns: Columns = {f"q{axis}": quaternions[:, i] for i, axis in enumerate("xyzw")}
    if scene.form.log == "poses":
        columns |= {f"p{axis}": np.round(motion.p[:, i], DIGITS_OF_POSE) for i, axis in enumerate("xyz")}
    return columns


def _describe(rng: np.random.Generator, scene: Scene, wrench: Array, reference: Reference | None, sign: int) -> dict[str, object]:
    """The manifest."""
    rig, form = scene.rig, scene.form
    sensor: dict[str, object] = {"sign": sign}
    if form.poses or rng.random() > SHARE_WITHOUT_NOISE:
        sensor["noise_std"] = np.round(scene.stated_noise, 6).tolist()
    if rng.random() < 0.8:
        sensor["range"] = np.ceil(np.maximum(np.abs(wrench).max(0) * 1.4, LEAST_RANGE)).tolist()
    sensor["resolution"] = np.round(find_steps(scene), 9).tolist()
    manifest: dict[str, object] = {"format": "recording/1"}
    if form.log == "joints":
        names = [f"j{i + 1}" for i in range(rig.joint_count)]
        manifest["robot"] = {"urdf": "robot.urdf", "joints": names, "base_frame": "base", "sensor_frame": "ft_sensor"}
    manifest |= {"gravity": rig.gravity.tolist(), "sensor": sensor}
    if form.poses:
        manifest |= {"samples": "averaged", "count": AVERAGED}
    if reference is not None:
        manifest["payload_reference"] = {
            "mass": float(reference.mass),
            "first_moment": np.round(reference.first_moment, 7).tolist(),
            "inertia": np.round(reference.inertia[np.triu_indices(3)], 8).tolist(),
            "source": "CAD",
        }
    return manifest
