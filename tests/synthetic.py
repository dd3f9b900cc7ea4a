"""Recordings from independent physics, for the tests and benches of the estimation.

The payload is four point masses, and the wrench is Newton's law for each of them: no regressor, no inertia tensor. The arm's joints follow
the command through a second-order lag that is integrated exactly, so that position, velocity and acceleration belong together; the motion
of the sensor frame comes from Pinocchio.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path

import numpy as np
import pinocchio as pin
from scipy.interpolate import CubicSpline
from scipy.signal import cont2discrete, lfilter

from core.cell.folder import load_cell
from core.payload.inertia import InertialParameters, pseudo_inertia
from core.recording.recording import Recording, SensorDescription
from core.robot.model import RobotModel

CELLS = Path(__file__).resolve().parent.parent / "cells"
NOISE_STD = np.array([0.0548, 0.0480, 0.0728, 0.0028, 0.00305, 0.00303])
RESOLUTION = np.array([1 / 16, 1 / 16, 1 / 16, 1 / 752, 1 / 752, 1 / 752])
GRAVITY = np.array([0.0, 0.0, -9.81])
ALPHA = 4.8
AXES = "xyz"


@dataclass(frozen=True)
class Run:
    """A motion with everything known exactly, one row per sample."""

    cell: str
    robot: RobotModel
    t: np.ndarray
    q: np.ndarray
    rotation: np.ndarray
    a: np.ndarray
    """Of the sensor origin, base frame."""
    omega: np.ndarray
    """Sensor frame, as alpha."""
    alpha: np.ndarray
    phase: np.ndarray


@dataclass(frozen=True)
class Imperfections:
    """What is put between the exact run and the recording."""

    noise_std: np.ndarray = field(default_factory=lambda: NOISE_STD)
    encoder_std: float = 2e-6
    resolution: np.ndarray | None = field(default_factory=lambda: RESOLUTION)
    offset: np.ndarray = field(default_factory=lambda: np.array([3.1, -2.2, 5.3, 0.11, -0.2, 0.07]))
    tilt_rad: tuple[float, float] = (0.0, 0.0)
    """Rotation of the true gravity against the nominal one about base x and y."""
    delay_s: float = 0.0
    drift_n: float = 0.0
    """Over the run, exponential in fx and fz and a ramp in fy; torques a fiftieth of it."""


def payload(name: str, cell: str = "lwr4_bench") -> InertialParameters:
    """A payload of the cell."""
    return load_cell(CELLS / cell).payloads[name].parameters


def random_payload(rng: np.random.Generator) -> InertialParameters:
    """A body of 0.3 to 6 kg about 0.1 m in size in front of the sensor."""
    mass = float(np.exp(rng.uniform(np.log(0.3), np.log(6.0))))
    points = rng.normal(size=(12, 3)) * rng.uniform(0.02, 0.06, 3) + [*rng.normal(scale=0.02, size=2), rng.uniform(0.02, 0.12)]
    shares = rng.dirichlet(np.ones(12)) * mass
    com = shares @ points / mass
    centred = points - com
    inertia = sum(m * (r @ r * np.eye(3) - np.outer(r, r)) for m, r in zip(shares, centred, strict=True))
    return InertialParameters.from_com(mass, com, inertia)


def point_masses(body: InertialParameters) -> tuple[np.ndarray, np.ndarray]:
    """Four equal masses and their places (4, 3) with the body's mass, first moment and inertia."""
    factor = np.linalg.cholesky(pseudo_inertia(body.phi))
    m = body.mass
    # an orthogonal matrix turns the factor's last row into four equal entries
    row, wanted = factor[3] / np.sqrt(m), np.full(4, 0.5)
    v = row - wanted
    householder = np.eye(4) if np.linalg.norm(v) < 1e-12 else np.eye(4) - 2.0 * np.outer(v, v) / (v @ v)
    points = factor @ householder
    return np.full(4, m / 4), (points[:3] / points[3]).T


def wrench_of(run: Run, body: InertialParameters, gravity: np.ndarray = GRAVITY) -> np.ndarray:
    """(N, 6): force and torque on the sensor origin that carry the point masses, sensor axes."""
    result = np.zeros((len(run.t), 6))
    origin = np.einsum("nji,nj->ni", run.rotation, run.a - gravity)
    for mass, r in zip(*point_masses(body), strict=True):
        acceleration = origin + np.cross(run.alpha, r) + np.cross(run.omega, np.cross(run.omega, r))
        result[:, :3] += mass * acceleration
        result[:, 3:] += mass * np.cross(r, acceleration)
    return result


def record(run: Run, body: InertialParameters, rng: np.random.Generator, imperfections: Imperfections | None = None) -> Recording:
    """The run as a sensor and encoders see it."""
    how = imperfections or Imperfections()
    gravity = pin.exp3(np.array([*how.tilt_rad, 0.0])) @ GRAVITY
    wrench = wrench_of(run, body, gravity)
    t = run.t
    if how.delay_s:
        wrench = np.column_stack([np.interp(t - how.delay_s, t, wrench[:, c]) for c in range(6)])
    wrench = wrench + how.offset + _drift(t, how.drift_n) + rng.normal(size=wrench.shape) * how.noise_std
    if how.resolution is not None:
        wrench = np.round(wrench / how.resolution) * how.resolution
    q = run.q + how.encoder_std * rng.normal(size=run.q.shape)
    return Recording(
        t,
        GRAVITY,
        wrench=wrench,
        q=q,
        phase=run.phase,
        robot=run.robot.description,
        sensor=SensorDescription(noise_std=NOISE_STD, resolution=RESOLUTION),
        reference=body,
        cell=run.cell,
    )


def _drift(t: np.ndarray, size: float) -> np.ndarray:
    s = (t - t[0]) / (t[-1] - t[0])
    warm = (1.0 - np.exp(-2.0 * s)) / (1.0 - np.exp(-2.0))
    shape = np.column_stack((warm, -s, warm, s / 50, -warm / 50, s / 50))
    return size * shape


@lru_cache(maxsize=16)
def run_of(
    cell: str = "lwr4_bench",
    seed: int = 0,
    *,
    repetitions: int = 4,
    period: float = 1e-3,
    lag: float = 150.0,
    axes: str = AXES,
    rotate: bool = True,
) -> Run:
    """The procedure's motion at a random place: for each axis against gravity, along it, then opposed trapezoids about it.

    Args:
        lag: rad/s, of the joint controllers.
        rotate: without, only the holds and the transfers between them.
    """
    rng = np.random.default_rng(seed)
    robot = RobotModel.of_cell(load_cell(CELLS / cell))
    while True:
        try:
            parts = _procedure(robot, rng, repetitions, period, axes, rotate)
            break
        except _NotReachableError:
            continue
    command = np.concatenate([part for _, part in parts])
    phase = np.concatenate([np.full(len(part), name) for name, part in parts])
    q, dq, ddq = _followed(command, period, lag)
    return _exact(cell, robot, period, q, dq, ddq, phase)


class _NotReachableError(Exception):
    """The random place cannot be reached with the wanted orientations."""


def _procedure(
    robot: RobotModel, rng: np.random.Generator, repetitions: int, period: float, axes: str, rotate: bool
) -> list[tuple[str, np.ndarray]]:
    home = np.array(load_cell(CELLS / ("lwr4_bench" if robot.n == 7 else "ur5e_line")).robot.home_rad)
    centre = robot.sensor_pose(home).position * [0.8, 0.8, 0.9]
    parts: list[tuple[str, np.ndarray]] = []
    last: np.ndarray | None = None
    for axis in axes:
        i = AXES.index(axis)
        place = centre + rng.uniform(-0.12, 0.12, 3)
        heading = rng.uniform(-np.pi, np.pi)
        for sign in "-+":
            q = _solve(robot, _orientation(i, 1 if sign == "+" else -1, heading), place, home, rng)
            if last is not None:
                parts.append(("transfer", _transfer(last, q, period)))
            parts.append((f"hold:{axis}{sign}", np.tile(q, (round(1.5 / period), 1))))
            last = q
        if rotate:
            assert last is not None
            turned = _rotation(robot, last, i, repetitions, float(rng.uniform(1.3, 1.6)), period)
            parts += [(f"rotate:{axis}", turned), (f"hold:{axis}+", np.tile(turned[-1], (round(1.0 / period), 1)))]
            last = turned[-1]
    return parts


def _orientation(axis: int, sign: int, heading: float) -> np.ndarray:
    """Sensor axes in the base frame with one of them along (+1) or against (-1) gravity."""
    down = np.array([0.0, 0.0, -1.0]) * sign
    side = np.array([np.cos(heading), np.sin(heading), 0.0])
    R = np.empty((3, 3))
    R[:, axis], R[:, (axis + 1) % 3] = down, side
    R[:, (axis + 2) % 3] = np.cross(down, side)
    return R


def _solve(robot: RobotModel, R: np.ndarray, p: np.ndarray, home: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    for _ in range(30):
        q = home + rng.normal(scale=0.7, size=robot.n)
        for _ in range(80):
            error = _error(robot, q, R, p)
            if np.linalg.norm(error) < 1e-10:
                return (q + np.pi) % (2 * np.pi) - np.pi
            J = robot.sensor_jacobian(q)
            step = J.T @ np.linalg.solve(J @ J.T + (1e-4 if np.linalg.norm(error) > 1e-2 else 1e-10) * np.eye(6), error)
            q = q + step * min(1.0, 0.4 / float(np.linalg.norm(step)))
    raise _NotReachableError


def _error(robot: RobotModel, q: np.ndarray, R: np.ndarray, p: np.ndarray) -> np.ndarray:
    pose = robot.sensor_pose(q)
    return np.concatenate((pose.rotation.T @ (p - pose.position), pin.log3(pose.rotation.T @ R)))


def _transfer(start: np.ndarray, goal: np.ndarray, period: float) -> np.ndarray:
    duration = max(1.0, 1.875 * float(np.abs(goal - start).max()) / 1.0)
    s = np.arange(1, round(duration / period) + 1) / round(duration / period)
    return start + np.outer(10 * s**3 - 15 * s**4 + 6 * s**5, goal - start)


def _rotation(robot: RobotModel, q: np.ndarray, axis: int, repetitions: int, top: float, period: float) -> np.ndarray:
    """Two opposed trapezoids, repeated, tracked with the sensor origin at rest."""
    up, flat = round(top / ALPHA / period), round(0.06 / period)
    one = np.concatenate((np.full(up, ALPHA), np.zeros(flat), np.full(up, -ALPHA)))
    alpha = np.tile(np.concatenate((one, -one)), repetitions)
    rate = np.cumsum(alpha) * period
    angle = (np.cumsum(rate) - 0.5 * rate) * period
    start = robot.sensor_pose(q)
    command = np.empty((len(angle), robot.n))
    for k, theta in enumerate(angle):
        R = start.rotation @ pin.exp3(theta * np.eye(3)[axis])
        for _ in range(4):
            error = _error(robot, q, R, start.position)
            if np.linalg.norm(error) < 1e-9:
                break
            J = robot.sensor_jacobian(q)
            step = J.T @ np.linalg.solve(J @ J.T + 1e-9 * np.eye(6), error)
            if np.abs(step).max() > 0.05:
                raise _NotReachableError
            q = q + step
        else:
            raise _NotReachableError
        command[k] = q
    return command


def _followed(command: np.ndarray, period: float, lag: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Position, velocity and acceleration of `q'' = lag^2 (c - q) - 2 lag q'`, exact for a command that is linear between fine steps.

    The steps are a sixteenth of the period: with the period itself the acceleration would ripple between samples (0.3 % at 150 rad/s), and
    samples of it would not be its mean.
    """
    fine = 16
    t = np.arange(len(command))
    steps = np.arange(fine * (len(command) - 1) + 1) / fine
    relative = CubicSpline(t, command)(steps) - command[0]
    result = []
    for numerator in ([lag**2], [lag**2, 0.0], [lag**2, 0.0, 0.0]):
        b, a, _ = cont2discrete((np.array(numerator), np.array([1.0, 2 * lag, lag**2])), period / fine, method="foh")
        result.append(lfilter(b.ravel(), a, relative, axis=0)[::fine])
    return result[0] + command[0], result[1], result[2]


def _exact(cell: str, robot: RobotModel, period: float, q: np.ndarray, dq: np.ndarray, ddq: np.ndarray, phase: np.ndarray) -> Run:
    model, data, frame = robot.model, robot.data, robot.sensor_frame_id
    n = len(q)
    rotation, a, omega, alpha = np.empty((n, 3, 3)), np.empty((n, 3)), np.empty((n, 3)), np.empty((n, 3))
    for k in range(n):
        pin.forwardKinematics(model, data, q[k], dq[k], ddq[k])
        rotation[k] = pin.updateFramePlacement(model, data, frame).rotation
        acceleration = pin.getFrameClassicalAcceleration(model, data, frame, pin.LOCAL)
        a[k] = rotation[k] @ acceleration.linear
        alpha[k] = acceleration.angular
        omega[k] = pin.getFrameVelocity(model, data, frame, pin.LOCAL).angular
    return Run(cell, robot, period * np.arange(n), q, rotation, a, omega, alpha, phase)
