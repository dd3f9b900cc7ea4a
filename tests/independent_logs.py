"""Recordings as other people's loggers write them, with a slip in the set-up or without; nothing of the engine is used.

An arm is read from its URDF by its joints' origins and axes alone, moved along sums of sines or from pose to pose, and carries a handful of
points with mass: the wrench is Newton's law for each of them, the accelerations are differences of their places. Sensor, clock and encoders
are as imperfect as real ones. A slip changes what is written, never what happened.
"""

from __future__ import annotations

import json
import xml.etree.ElementTree as ET
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array

CELLS = Path(__file__).resolve().parent.parent / "cells"
ARMS = ("lwr4_bench", "ur5e_line")
BASE, SENSOR = "base", "ft_sensor"
G = 9.81
STEP_S = 1e-3
"""Of the differences that velocities and accelerations are made of."""


@dataclass(frozen=True)
class Arm:
    """Origins (4, 4) and axes (3,) from base to sensor; None is a fixed joint."""

    urdf: str
    base: str
    sensor: str
    joints: tuple[str, ...]
    origins: tuple[Array, ...]
    axes: tuple[Array | None, ...]

    def place(self, q: Array) -> tuple[Array, Array]:
        """Rotation (N, 3, 3) and place (N, 3) of the sensor at joint angles (N, n)."""
        R, p, k = np.tile(np.eye(3), (len(q), 1, 1)), np.zeros((len(q), 3)), 0
        for origin, axis in zip(self.origins, self.axes, strict=True):
            p = p + R @ origin[:3, 3]
            R = R @ origin[:3, :3]
            if axis is not None:
                R = R @ Rotation.from_rotvec(q[:, k, None] * axis).as_matrix()
                k += 1
        return R, p


def read_arm(cell: str) -> Arm:
    """The arm of one of our cells, or of any folder with a `robot.urdf`."""
    text = (CELLS / cell / "robot.urdf").read_text(encoding="utf-8")
    by_child = {str(j.find("child").get("link")): j for j in ET.fromstring(text).iter("joint") if j.find("child") is not None}  # type: ignore[union-attr]  # those without are left out
    chain, link = [], SENSOR
    while link != BASE:
        chain.append(by_child[link])
        link = str(chain[-1].find("parent").get("link"))  # type: ignore[union-attr]  # each joint has one
    origins, axes, names = [], [], []
    for joint in reversed(chain):
        origin, axis = joint.find("origin"), joint.find("axis")
        T = np.eye(4)
        if origin is not None:
            T[:3, 3] = [float(v) for v in origin.get("xyz", "0 0 0").split()]
            T[:3, :3] = Rotation.from_euler("xyz", [float(v) for v in origin.get("rpy", "0 0 0").split()]).as_matrix()
        origins.append(T)
        moves = joint.get("type") in ("revolute", "continuous")
        axes.append(np.array([float(v) for v in (axis.get("xyz", "1 0 0") if axis is not None else "1 0 0").split()]) if moves else None)
        names += [str(joint.get("name"))] if moves else []
    return Arm(text, BASE, SENSOR, tuple(names), tuple(origins), tuple(axes))


@dataclass(frozen=True)
class Load:
    """Masses (k,) kg at places (k, 3) m in the sensor's axes."""

    masses: Array
    places: Array

    @property
    def mass(self) -> float:
        """kg."""
        return float(self.masses.sum())


def draw_load(rng: np.random.Generator) -> Load:
    """0.4 to 6 kg, its centre 3 to 20 cm in front of the sensor."""
    masses = rng.dirichlet(np.ones(6)) * np.exp(rng.uniform(np.log(0.4), np.log(6.0)))
    centre = np.array([*rng.normal(scale=0.03, size=2), rng.uniform(0.03, 0.2)])
    return Load(masses, centre + rng.normal(size=(6, 3)) * rng.uniform(0.02, 0.06, 3))


def draw_plate(rng: np.random.Generator) -> Load:
    """A plate without thickness, 6 cm in front of the sensor: the moments about two axes add up to the third exactly."""
    return Load(np.full(12, rng.uniform(1.0, 4.0) / 12), np.column_stack((rng.uniform(-0.08, 0.08, (12, 2)), np.full(12, 0.06))))


def draw_rod(rng: np.random.Generator) -> Load:
    """A rod without thickness in any direction: nothing turns about itself."""
    along = rng.normal(size=3)
    along /= np.linalg.norm(along)
    return Load(np.full(8, rng.uniform(1.0, 4.0) / 8), np.array([0.0, 0.0, 0.1]) + np.outer(np.linspace(-0.12, 0.12, 8), along))


@dataclass
class Log:
    """What is written: columns by name, and the manifest.

    Args:
        kind: `motion`, `poses`, `averaged`, `turn` or `orientation`.
    """

    kind: str
    columns: dict[str, Array]
    manifest: dict[str, Any]
    urdf: str | None
    notes: dict[str, float] = field(default_factory=dict)

    def block(self, *names: str) -> Array:
        """Columns side by side, (N, k)."""
        return np.column_stack([self.columns[name] for name in names])

    def put(self, names: tuple[str, ...], values: Array) -> None:
        """Columns replaced."""
        self.columns |= dict(zip(names, values.T, strict=True))

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the columns of the joints, none of a log of poses."""
        return tuple(sorted(name for name in self.columns if name.startswith("q_")))

    def write(self, folder: Path) -> Path:
        """As a recording's folder."""
        folder.mkdir(parents=True)
        names = list(self.columns)
        text = "\n".join(",".join(f"{v:.9g}" for v in row) for row in self.block(*names))
        (folder / "samples.csv").write_text(",".join(names) + "\n" + text + "\n", encoding="utf-8")
        (folder / "recording.json").write_text(json.dumps(self.manifest), encoding="utf-8")
        if self.urdf is not None:
            (folder / "robot.urdf").write_text(self.urdf, encoding="utf-8")
        return folder


FORCE, TORQUE = ("fx", "fy", "fz"), ("tx", "ty", "tz")
QUATERNION, POSITION = ("qx", "qy", "qz", "qw"), ("px", "py", "pz")
NOISE = np.array([0.055, 0.048, 0.073, 0.0028, 0.0030, 0.0030])


@dataclass(frozen=True)
class Setting:
    """What is around the payload: everything that a sound recording may have.

    Args:
        noise: factor on the sensor's usual noise; `stated`: whether the manifest says noise, range and resolution.
        tilt_rad: of the base. drift_n: over the recording. delay_s: of the wrench. zero_rad: of the encoders.
        as_poses: poses are written instead of joints.
    """

    noise: float = 1.0
    tilt_rad: tuple[float, float] = (0.0, 0.0)
    drift_n: float = 0.0
    delay_s: float = 0.0
    zero_rad: float = 0.0
    stated: bool = True
    as_poses: bool = False
    rate_hz: float = 250.0
    seconds: float = 24.0


def make_log(kind: str, rng: np.random.Generator, setting: Setting, load: Load | None = None) -> Log:
    """A sound log of one kind."""
    arm = read_arm(str(rng.choice(ARMS)))
    load = load or draw_load(rng)
    path, t = _path(kind, len(arm.joints), rng, setting)
    wrench, q = _felt(arm, path, t - setting.delay_s, load, setting), path(t)
    wrench += rng.normal(size=6) * [4.0, 4.0, 4.0, 0.2, 0.2, 0.2]
    s = (t - t[0]) / (t[-1] - t[0])
    wrench += np.outer(setting.drift_n * (1.0 - np.exp(-3.0 * s)), [1.0, -0.6, 0.8, 0.02, -0.02, 0.01])
    count = 200 if kind == "averaged" else 1
    wrench += setting.noise * NOISE * rng.normal(size=wrench.shape) / np.sqrt(count)
    if kind != "averaged":
        resolution = np.repeat([1 / 16, 1 / 752], 3)
        wrench = np.round(wrench / resolution) * resolution
    zeros = setting.zero_rad * rng.normal(size=len(arm.joints))
    return _as_log(kind, arm, t, q + zeros + 2e-6 * rng.normal(size=q.shape), wrench, setting)


def _as_log(kind: str, arm: Arm, t: Array, q: Array, wrench: Array, setting: Setting) -> Log:
    sensor: dict[str, Any] = {}
    if setting.stated:
        sensor = {"noise_std": NOISE.tolist(), "range": _range(wrench), "resolution": [*[1 / 16] * 3, *[1 / 752] * 3]}
    manifest: dict[str, Any] = {"format": "recording/1", "gravity": [0.0, 0.0, -G], "sensor": sensor}
    columns: dict[str, Array] = {"t": t}
    urdf = None
    if setting.as_poses or kind == "orientation":
        R, p = arm.place(q)
        columns |= dict(zip(QUATERNION, Rotation.from_matrix(R).as_quat().T, strict=True))
        if kind != "orientation":
            columns |= dict(zip(POSITION, p.T, strict=True))
    else:
        columns |= {f"q_{j + 1}": values for j, values in enumerate(q.T)}
        manifest["robot"] = {"urdf": "robot.urdf", "joints": arm.joints, "base_frame": arm.base, "sensor_frame": arm.sensor}
        urdf = arm.urdf
    columns |= dict(zip((*FORCE, *TORQUE), wrench.T, strict=True))
    return Log(kind, columns, manifest, urdf)


def _range(wrench: Array) -> list[float]:
    """Of the smallest of a family of sensors that this does not overload."""
    largest = np.abs(wrench).max(axis=0)
    size = next(s for s in (1.0, 2.0, 4.0, 8.0, 16.0) if (largest < s * np.array([145, 145, 290, 5, 5, 5])).all())
    return [s * size for s in (145.0, 145.0, 290.0, 5.0, 5.0, 5.0)]


Path_ = Callable[[Array], Array]


def _path(kind: str, n: int, rng: np.random.Generator, setting: Setting) -> tuple[Path_, Array]:
    home = rng.uniform(-1.0, 1.0, n)
    if kind == "averaged":
        poses = rng.uniform(-1.8, 1.8, (int(rng.integers(12, 40)), n))
        return lambda t: poses[np.clip(np.round(t).astype(int), 0, len(poses) - 1)], np.arange(len(poses), dtype=float)
    t = np.arange(0.0, setting.seconds, 1.0 / setting.rate_hz)
    if kind == "turn":
        joint, sweep = int(rng.integers(n - 3, n)), np.pi * float(rng.choice([-1.0, 1.0]))
        return lambda t: home + np.outer(_ease((t - 2.0) / (setting.seconds - 4.0)) * sweep, np.eye(n)[joint]), t
    if kind == "poses":
        stops = np.concatenate((home[None], rng.uniform(-1.6, 1.6, (7, n))))
        return lambda t: _hop(t, stops, setting.seconds), t
    amplitude, phase = rng.uniform(0.15, 0.55, (4, n)), rng.uniform(0.0, 2 * np.pi, (4, n))
    cycles = 2 * np.pi * np.array([0.06, 0.11, 0.23, 0.47])[:, None] * rng.uniform(0.8, 1.25, (4, n))
    damp = np.array([1.0, 0.8, 0.5, 0.3])[:, None]

    def sway(t: Array) -> Array:
        return np.asarray(home + (damp * amplitude * np.sin(cycles * t[:, None, None] + phase)).sum(axis=1))

    return sway, t


def _ease(s: Array) -> Array:
    s = np.clip(s, 0.0, 1.0)
    return np.asarray(10 * s**3 - 15 * s**4 + 6 * s**5)


def _hop(t: Array, stops: Array, seconds: float) -> Array:
    """From stop to stop, with as much time at rest as on the way."""
    each = seconds / len(stops)
    k = np.clip((t / each).astype(int), 0, len(stops) - 1)
    after = np.minimum(k + 1, len(stops) - 1)
    share = _ease((t / each - k - 0.45) / 0.55)
    return np.asarray(stops[k] + share[:, None] * (stops[after] - stops[k]))


def _felt(arm: Arm, path: Path_, t: Array, load: Load, setting: Setting) -> Array:
    """(N, 6): what the sensor exerts on the points, in its own axes, at the times t."""
    gravity = Rotation.from_rotvec([*setting.tilt_rad, 0.0]).apply([0.0, 0.0, -G])
    moving = len(np.unique(np.diff(t).round(6))) > 0 and float(np.diff(t).max()) < 0.5
    places = [_points(arm, path(t + d), load) for d in ((-STEP_S, 0.0, STEP_S) if moving else (0.0,))]
    R, p = arm.place(path(t))
    here = places[len(places) // 2]
    acceleration = (places[0] - 2 * places[1] + places[2]) / STEP_S**2 if moving else np.zeros_like(here)
    push = load.masses[:, None] * (acceleration - gravity)
    moment = np.cross(here - p[:, None], push).sum(axis=1)
    return np.concatenate([np.einsum("nji,nj->ni", R, v) for v in (push.sum(axis=1), moment)], axis=1)


def _points(arm: Arm, q: Array, load: Load) -> Array:
    R, p = arm.place(q)
    return np.asarray(p[:, None] + np.einsum("nij,kj->nki", R, load.places))


# the slips: each takes a sound log and what to draw from, and gives what somebody would have written


def slip_sign(log: Log, rng: np.random.Generator) -> Log:
    """The other convention of the wrench."""
    log.put((*FORCE, *TORQUE), -log.block(*FORCE, *TORQUE))
    return log


def slip_frame(log: Log, rng: np.random.Generator) -> Log:
    """The wrench in the base's axes."""
    R = Rotation.from_matrix(_rotations(log))
    for names in (FORCE, TORQUE):
        log.put(names, R.apply(log.block(*names)))
    return log


def _rotations(log: Log) -> Array:
    if not log.joints:
        return np.asarray(Rotation.from_quat(log.block(*QUATERNION)).as_matrix())
    cell = next(name for name in ARMS if (CELLS / name / "robot.urdf").read_text(encoding="utf-8") == log.urdf)
    return read_arm(cell).place(log.block(*log.joints))[0]


def slip_inverse(log: Log, rng: np.random.Generator) -> Log:
    """The base in the sensor's frame."""
    log.put(QUATERNION, log.block(*QUATERNION) * [-1.0, -1.0, -1.0, 1.0])
    return log


def slip_quaternion(log: Log, rng: np.random.Generator) -> Log:
    """w first."""
    log.put(QUATERNION, log.block("qw", "qx", "qy", "qz"))
    return log


def slip_force_unit(log: Log, rng: np.random.Generator) -> Log:
    """Kilograms or pounds of force."""
    log.put(FORCE, log.block(*FORCE) / rng.choice([9.80665, 4.4482216]))
    return log


def slip_torque_unit(log: Log, rng: np.random.Generator) -> Log:
    """N mm or pound inches."""
    log.put(TORQUE, log.block(*TORQUE) * rng.choice([1000.0, 8.8507458]))
    return log


def slip_time_unit(log: Log, rng: np.random.Generator) -> Log:
    """Milli- or microseconds."""
    log.columns["t"] = log.columns["t"] * rng.choice([1e3, 1e6])
    return log


def slip_angle_unit(log: Log, rng: np.random.Generator) -> Log:
    """Degrees."""
    log.put(log.joints, np.degrees(log.block(*log.joints)))
    return log


def slip_gravity(log: Log, rng: np.random.Generator) -> Log:
    """Up, or along another axis of the base."""
    log.manifest["gravity"] = [[0.0, 0.0, G], [0.0, -G, 0.0], [G, 0.0, 0.0]][int(rng.integers(3))]
    return log


def slip_joints(log: Log, rng: np.random.Generator) -> Log:
    """Two joints in each other's place, or one with the other sign."""
    names = list(log.joints)
    if rng.random() < 0.5:
        i, j = sorted(rng.choice(np.arange(1, len(names)), 2, replace=False))
        names[i], names[j] = names[j], names[i]
        log.put(log.joints, log.block(*names))
    else:
        name = str(rng.choice(names[1:-1]))
        log.columns[name] = -log.columns[name]
    return log


def slip_millimetres(log: Log, rng: np.random.Generator) -> Log:
    """Positions in mm."""
    log.put(POSITION, 1e3 * log.block(*POSITION))
    return log


def slip_axes(log: Log, rng: np.random.Generator) -> Log:
    """Axes exchanged, or force and torque."""
    how = int(rng.integers(3))
    if how == 0:
        log.put((*FORCE, *TORQUE), log.block(*TORQUE, *FORCE))
    elif how == 1:
        log.put((*FORCE, *TORQUE), log.block("fy", "fx", "fz", "ty", "tx", "tz"))
    else:
        log.put((*FORCE, *TORQUE), log.block("fx", "fz", "fy", "tx", "tz", "ty"))
    return log


def slip_torque_point(log: Log, rng: np.random.Generator) -> Log:
    """The torque about a point 6 to 15 cm away from the sensor's origin."""
    arm = rng.normal(size=3)
    arm *= rng.uniform(0.06, 0.15) / np.linalg.norm(arm)
    log.put(TORQUE, log.block(*TORQUE) - np.cross(arm, log.block(*FORCE)))
    return log


def slip_rate(log: Log, rng: np.random.Generator) -> Log:
    """A rate that was believed and not measured: a quarter of it, or four times as much."""
    log.columns["t"] = log.columns["t"] * rng.choice([0.25, 4.0])
    return log


Slip = Callable[[Log, np.random.Generator], Log]
SLIPS: dict[str, tuple[Slip, tuple[str, ...], bool | None]] = {
    "sign": (slip_sign, ("motion", "poses", "averaged"), None),
    "frame": (slip_frame, ("motion", "poses", "averaged"), None),
    "inverse": (slip_inverse, ("motion", "poses", "averaged"), True),
    "quaternion": (slip_quaternion, ("motion", "poses", "averaged"), True),
    "force unit": (slip_force_unit, ("motion", "poses"), None),
    "torque unit": (slip_torque_unit, ("motion", "poses"), None),
    "time unit": (slip_time_unit, ("motion", "poses"), None),
    "angle unit": (slip_angle_unit, ("motion", "poses", "averaged"), False),
    "gravity": (slip_gravity, ("motion", "poses", "averaged"), None),
    "joints": (slip_joints, ("motion", "poses", "averaged"), False),
    "millimetres": (slip_millimetres, ("motion",), True),
    "axes": (slip_axes, ("motion", "poses", "averaged"), None),
    "torque point": (slip_torque_point, ("motion",), None),
    "rate": (slip_rate, ("motion",), None),
}
"""Name of each slip: what it does, the kinds of log that can have it, and whether of poses (True), of joints (False) or of either."""


def draw_setting(rng: np.random.Generator) -> Setting:
    """Everything that a sound recording may have, in ordinary sizes."""
    tilt = rng.normal(scale=0.01, size=2)
    return Setting(
        noise=float(rng.choice([0.5, 1.0, 2.0])),
        tilt_rad=(float(tilt[0]), float(tilt[1])),
        drift_n=float(rng.choice([0.0, 0.0, 0.3])),
        delay_s=float(rng.choice([0.0, 0.004, 0.01])),
        zero_rad=float(rng.choice([0.0, 0.001])),
        stated=bool(rng.random() < 0.6),
        as_poses=bool(rng.random() < 0.5),
        rate_hz=float(rng.choice([100.0, 250.0, 500.0])),
    )


def slipped_log(name: str, seed: int) -> Log:
    """A log with one slip."""
    rng = np.random.default_rng([seed, sum(name.encode())])
    slip, kinds, as_poses = SLIPS[name]
    kind = kinds[seed % len(kinds)]
    setting = draw_setting(rng)
    if as_poses is not None:
        setting = replace(setting, as_poses=as_poses)
    while True:
        sound = make_log(kind, rng, setting)
        before = _rotations(sound)[:, 2]
        log = slip(sound, rng)
        if name != "joints" or kind == "motion" or _turned(before, _rotations(log)[:, 2]) > np.radians(5.0):
            return log


def _turned(before: Array, after: Array) -> float:
    """Angle between directions (N, 3), root mean square, rad: exchanged joints about parallel axes change nothing in a pose."""
    cosines = np.clip((before * after).sum(axis=1), -1.0, 1.0)
    return float(np.sqrt(np.mean(np.arccos(cosines) ** 2)))


SOUND = ("motion", "poses", "averaged", "turn", "orientation", "tilted", "noisy", "drifting", "late", "slow")


def sound_log(seed: int) -> Log:
    """A log without a slip: ten kinds, one after the other."""
    rng = np.random.default_rng([seed, 77])
    kind, setting = SOUND[seed % len(SOUND)], draw_setting(rng)
    changed = {
        "tilted": {"tilt_rad": tuple(np.radians(10.0) * np.array([np.cos(a := float(rng.uniform(0, 6.28))), np.sin(a)]))},
        "noisy": {"noise": float(rng.uniform(5.0, 30.0))},
        "drifting": {"drift_n": 3.0},
        "late": {"delay_s": 0.3},
        "slow": {"rate_hz": 10.0},
    }.get(kind)
    if changed is None:
        return make_log(kind, rng, setting)
    return make_log(str(rng.choice(["motion", "poses"])), rng, replace(setting, **changed))  # type: ignore[arg-type]  # one of its fields
