"""The folder of a recording, as the specification describes it: samples, manifest, robot."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from bench.second_stranger.arms import describe_arm
from bench.second_stranger.array import Array
from bench.second_stranger.kinematics import JointMotion
from bench.second_stranger.reading import Reference, convert
from bench.second_stranger.rig import Rig

CHANNELS = ("fx", "fy", "fz", "tx", "ty", "tz")
ENCODER_STEP = 2 * np.pi / 2**21
"""rad."""
LEAST_RANGE = (145, 145, 290, 5, 5, 5)
"""N and N m."""
Columns = dict[str, "Array | list[str]"]


def write_recording(
    rng: np.random.Generator,
    folder: Path,
    rig: Rig,
    joints: JointMotion,
    wrench: Array,
    temperature: Array | None,
    reference: Reference | None,
    sign: int,
) -> None:
    """Writes the folder; what stood in it under the same names is overwritten.

    Args:
        joints: at the samples, as they are recorded but for noise.
        wrench: (M, 6), N and N m, as the converter gives it.
        temperature: (N,), degrees Celsius, on the grid; without one a steady one may be recorded.
        reference: what the file says of the payload; nothing for None.
        sign: with which the file has the wrench.
    """
    folder.mkdir(parents=True, exist_ok=True)
    columns = _list_columns(rng, rig, joints, sign * wrench, temperature)
    pq.write_table(pa.table(columns), folder / "samples.parquet")
    (folder / "robot.urdf").write_text(describe_arm(rig.arm))
    (folder / "recording.json").write_text(json.dumps(_describe(rig, wrench, reference, sign), indent=1))


def _list_columns(rng: np.random.Generator, rig: Rig, joints: JointMotion, wrench: Array, temperature: Array | None) -> Columns:
    """By name, in the order of the file."""
    M = len(rig.times)
    q = convert(joints.q + 2e-6 * rng.normal(size=joints.q.shape), ENCODER_STEP)
    columns: Columns = {"t": np.round(rig.times, 6)}
    columns |= {f"q_{i + 1}": q[:, i] for i in range(rig.joint_count)}
    if rng.random() < 0.5:
        columns |= {f"dq_{i + 1}": joints.dq[:, i] + 4e-4 * rng.normal(size=M) for i in range(rig.joint_count)}
    columns |= {name: wrench[:, i] for i, name in enumerate(CHANNELS)}
    if temperature is not None or rng.random() < 0.12:
        read_off = np.interp(rig.times, rig.t, 24 + 0 * rig.t if temperature is None else temperature)
        columns["temperature"] = np.round(read_off + 0.03 * rng.normal(size=M), 2)
    if rng.random() < 0.75:
        columns["phase"] = label_phases(rig)
    return columns


def label_phases(rig: Rig) -> list[str]:
    """(M,), what the arm does at each sample."""
    ends = np.array([stretch.end_s for stretch in rig.stretches])
    places = np.minimum(np.searchsorted(ends, rig.times, side="right"), len(ends) - 1)
    return [rig.stretches[place].label for place in places]


def _describe(rig: Rig, wrench: Array, reference: Reference | None, sign: int) -> dict[str, object]:
    """The manifest."""
    most = np.maximum(np.abs(wrench).max(0) * 1.3, LEAST_RANGE)
    manifest: dict[str, object] = {
        "format": "recording/1",
        "robot": {
            "urdf": "robot.urdf",
            "joints": [f"j{i + 1}" for i in range(rig.joint_count)],
            "base_frame": "base",
            "sensor_frame": "ft_sensor",
        },
        "gravity": rig.gravity.tolist(),
        "sensor": {
            "sign": sign,
            "noise_std": np.round(rig.noise_std, 6).tolist(),
            "range": np.ceil(most).tolist(),
            "resolution": rig.resolution.tolist(),
        },
    }
    if reference is not None:
        upper = reference.inertia[np.triu_indices(3)]
        manifest["payload_reference"] = {
            "mass": float(reference.mass),
            "first_moment": np.round(reference.first_moment, 7).tolist(),
            "inertia": np.round(upper, 8).tolist(),
            "source": "CAD",
        }
    return manifest
