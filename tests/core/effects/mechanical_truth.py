"""Motion and wrench of a payload of point masses by physics written here: the true pose of the sensor as a function of time, differentiated
numerically; Newton's law."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from core.cell.folder import load_cell
from core.effects.effect import Effect
from core.effects.link_loads import LazyLinkLoads, LinkLoads
from core.effects.scene import Scene
from core.payload.inertia import InertialParameters, Motion, regressor
from core.robot.model import RobotModel

Array = np.ndarray
Path3 = Callable[[Array], Array]

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
G = np.array([0.0, 0.0, -9.81])
SIGMA = np.array([0.055, 0.048, 0.073, 0.0028, 0.003, 0.003])
T = np.arange(1500) / 62.5
POINTS = np.array([[0.05, 0.01, 0.09], [-0.06, 0.03, 0.05], [0.01, -0.05, 0.12], [0.0, 0.04, 0.16]])
MASSES = np.array([0.8, 0.5, 0.6, 0.4])
E0 = np.zeros(3)
ARM = np.diag([1.0, 4.0, 2.0, 3.0, 1.0, 0.6, 0.3])
"""Inertia of the heavy arm at its joints."""


@lru_cache
def robot() -> RobotModel:
    return RobotModel.of_cell(CELL)


def believed(t: Array) -> Array:
    """(N, 7), joints: sums of slow sines."""
    rng = np.random.default_rng(3)
    amplitude, frequency, phase = rng.uniform(0.2, 0.6, (3, 7)), rng.uniform(0.05, 0.35, (3, 7)), rng.uniform(0, 6, (3, 7))
    home = np.array([0.2, 0.5, -0.3, 1.2, 0.4, -0.8, 0.3])
    return home + sum(amplitude[i] * np.sin(2 * np.pi * frequency[i] * t[:, None] + phase[i]) for i in range(3))


@dataclass(frozen=True)
class Truth:
    """True motion of the sensor frame."""

    R: Array
    p: Array
    v: Array
    motion: Motion

    def wrench(self, points: Array = POINTS, masses: Array = MASSES, g: Array = G) -> Array:
        """(N, 6), Newton's law for point masses (K, 3), sensor axes."""
        w = np.zeros((len(self.R), 6))
        for r, m in zip(points, masses, strict=True):
            f = m * at_point(self.motion, r, self.R.transpose(0, 2, 1) @ g)
            w += np.hstack([f, np.cross(r, f)])
        return w


def at_point(motion: Motion, r: Array, g: Array) -> Array:
    """Specific force at r, sensor axes."""
    return motion.a - g + np.cross(motion.alpha, r) + np.cross(motion.omega, np.cross(motion.omega, r))


def truth(path: Path3 = believed, turn: Array = E0, shift: Array = E0, h: float = 1e-3) -> Truth:
    """Differentiates the pose of a sensor that is mounted turned and shifted."""

    def pose(t: Array) -> tuple[Array, Array]:
        poses = robot().sensor_poses(path(t))
        return poses.rotation @ Rotation.from_rotvec(turn).as_matrix(), poses.position + poses.rotation @ shift

    (R0, p0), (R1, p1), (R2, p2) = pose(T - h), pose(T), pose(T + h)
    Rt = R1.transpose(0, 2, 1)
    W, A = Rt @ ((R2 - R0) / (2 * h)), Rt @ ((R2 - 2 * R1 + R0) / h**2)

    def axial(M: Array) -> Array:
        return 0.5 * np.stack([M[:, 2, 1] - M[:, 1, 2], M[:, 0, 2] - M[:, 2, 0], M[:, 1, 0] - M[:, 0, 1]], axis=1)

    a = np.einsum("nij,ni->nj", R1, (p2 - 2 * p1 + p0) / h**2)
    return Truth(R1, p1, (p2 - p0) / (2 * h), Motion(Rt @ G, a, axial(W), axial(A)))


@lru_cache
def scene() -> Scene:
    nominal = truth()
    q, h = believed(T), 1e-5
    return Scene(
        t=T,
        phase=np.full(len(T), "transfer"),
        motion=nominal.motion,
        rotation=nominal.R,
        position=nominal.p,
        gravity=G,
        phi=sum(InertialParameters.from_com(m, r, np.zeros((3, 3))).phi for r, m in zip(POINTS, MASSES, strict=True)),
        q=q,
        dq=(believed(T + h) - believed(T - h)) / (2 * h),
        jacobian=np.stack([robot().sensor_jacobian(row) for row in q]),
        torque=load(T),
    )


def load(t: Array, lag: float = 0.0) -> Array:
    """(N, 7), joint torques that the scene states; they change sides slowly. Behind a lag, s: `1 / (1 + lag s)` of a sine that goes on."""
    omega = 0.35 * (1 + 0.1 * np.arange(7))
    size = np.array([30.0, 60.0, 20.0, 40.0, 10.0, 12.0, 4.0]) / np.hypot(1, omega * lag)
    return size * np.sin(omega * t[:, None] + np.arange(7) - np.arctan(omega * lag))


def brisk_load(t: Array) -> Array:
    """(N, 7), joint torques that jump from side to side within a tenth of a second, so that soft joints swing."""
    jumps = np.tanh(6 * np.sin(0.9 * t[:, None] * (1 + 0.1 * np.arange(7)) + 2 * np.arange(7)))
    return 0.25 * load(t) + np.array([4.0, 8.0, 3.0, 6.0, 2.0, 2.0, 1.0]) * jumps


@lru_cache
def brisk_scene() -> Scene:
    """A heavy arm that is loaded briskly."""
    run = scene()
    arm = brisk_load(T) - np.einsum("nij,ni->nj", run.jacobian, run.nominal)
    links = LinkLoads(np.broadcast_to(ARM, (len(T), 7, 7)), arm, np.zeros((len(T), 3)))
    return replace(run, torque=brisk_load(T), links=LazyLinkLoads(lambda: links))


def change(effect: Effect, theta: Array, run: Scene | None = None) -> Array:
    run = scene() if run is None else run
    return effect.wrench(run, run.nominal, np.asarray(theta, dtype=float)) - run.nominal


def rms(x: Array) -> float:
    return float(np.sqrt(np.mean((x / SIGMA) ** 2)))


@lru_cache
def nuisance() -> Array:
    """(6 N, 16), orthonormal: what payload and offsets can take up, in standard deviations."""
    Z = np.concatenate([regressor(scene().motion), np.broadcast_to(np.eye(6), (len(T), 6, 6))], axis=2) / SIGMA[:, None]
    return np.linalg.qr(Z.reshape(-1, 16))[0]


def without_nuisance(y: Array) -> Array:
    return y - nuisance() @ (nuisance().T @ y)
