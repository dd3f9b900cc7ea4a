"""An experiment's motion by kinematics alone, before anything is planned: from the first pose of a recording through its stops.

The sensor origin stays where it is and the joints follow the attitude, so what every effect would do is seen along joints as they may
be. Obstacles and limits are left to planning.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation, RotationSpline

from core.array import Array
from core.estimation.kinematics import SLOWEST_PERIOD_S, Poses, axial
from core.planning.settings import Timing
from core.planning.stop import Stop, Swings, Wave, wave_shape
from core.recording.recording import Recording
from core.robot.model import RobotModel

STEP_S = 0.01
"""Between the poses that are worked out."""
RATE = 0.8
"""Of the sensor, rad/s: about what 0.25 m/s leaves to the corner of a payload."""
SPEED = 0.15
"""Of the sensor origin in a wave, m/s."""
ACCELERATION = 4.8
"""Of a swing, rad/s2, as in the paper."""
JOINT_ACCELERATION = 10.0
"""In a wave, rad/s2."""
TIMING = Timing()
RESTARTS = 60


@dataclass(frozen=True)
class Piece:
    """A stretch of motion: joints (K, n), or attitudes (K, 3, 3) where there are none, every `STEP_S`."""

    path: Array
    phase: str


def rehearse(recording: Recording, poses: Poses, stops: tuple[Stop, ...]) -> Recording:
    """The recording's robot going through the stops, without a wrench (zeros), at the recording's period where that is one of motions."""
    actor = _Poses(poses) if recording.q is None or recording.robot is None else _Joints(recording, poses)
    pieces = [Piece(actor.still(TIMING.hold_s), "hold:free")]
    for stop in stops:
        hold = Piece(np.empty(0), f"hold:{stop.label}")
        pieces += [Piece(actor.towards(stop), "transfer"), replace(hold, path=actor.still(TIMING.hold_s))]
        if stop.swings is not None:
            pieces += [
                Piece(actor.make_swings(stop.swings), f"rotate:{stop.swings.about}"),
                replace(hold, path=actor.still(TIMING.settle_s)),
            ]
        if stop.wave is not None:
            pieces += [Piece(actor.make_wave(stop.wave), "transfer"), replace(hold, path=actor.still(TIMING.settle_s))]
    path = np.concatenate([piece.path for piece in pieces])
    coarse = np.arange(len(path), dtype=np.float64) * STEP_S
    t = np.arange(0.0, coarse[-1], min(poses.period, SLOWEST_PERIOD_S))
    phase = np.concatenate([np.full(len(piece.path), piece.phase) for piece in pieces])[np.searchsorted(coarse, t, side="right") - 1]
    bare = Recording(t=t, gravity=recording.gravity, wrench=np.zeros((len(t), 6)), phase=phase, sensor=recording.sensor)
    temperature = None if recording.temperature is None else np.full(len(t), recording.temperature[-1])
    return replace(actor.complete_recording(bare, coarse, path), temperature=temperature)


class _Poses:
    """The sensor by itself."""

    def __init__(self, poses: Poses) -> None:
        self.R = poses.rotation[0]
        self.p = None if poses.position is None else poses.position[0]
        self.down = poses.gravity / np.linalg.norm(poses.gravity)

    def still(self, seconds: float) -> Array:
        return self.turn_through(np.zeros((round(seconds / STEP_S), 3)))

    def towards(self, stop: Stop) -> Array:
        """The shortest turn that brings the stop's direction down."""
        to = self.R.T @ self.down
        axis = np.cross(stop.down, to)
        angle = np.arctan2(np.linalg.norm(axis), np.dot(stop.down, to))
        if np.linalg.norm(axis) < 1e-9:
            axis = np.cross(to, np.eye(3)[int(np.argmin(np.abs(to)))])
        return self.turn_through(_ease(angle, RATE)[:, None] * axis / np.linalg.norm(axis))

    def make_swings(self, swings: Swings) -> Array:
        return self.turn_through(trapezoids(swings)[:, None] * np.eye(3)["xyz".index(swings.about)])

    def make_wave(self, wave: Wave) -> Array:
        """About all axes at once."""
        return self.turn_through(RATE * wave_shape(wave, 3, STEP_S))

    def turn_through(self, vectors: Array) -> Array:
        """Attitudes (K, 3, 3) of rotation vectors (K, 3) from where the sensor is, sensor axes; it stays at the last one."""
        path = self.R @ Rotation.from_rotvec(vectors).as_matrix()
        self.R = path[-1]
        return np.asarray(path)

    def complete_recording(self, bare: Recording, coarse: Array, path: Array) -> Recording:
        R = RotationSpline(coarse, Rotation.from_matrix(path))(bare.t).as_matrix()
        return replace(bare, orientation=R, position=None if self.p is None else np.broadcast_to(self.p, (len(R), 3)))


class _Joints(_Poses):
    """The sensor on its arm."""

    def __init__(self, recording: Recording, poses: Poses) -> None:
        super().__init__(poses)
        if recording.robot is None or recording.q is None or poses.position is None:
            raise ValueError("a recording without joints has no arm to rehearse with")
        self.place = poses.position[0]
        self.description = recording.robot
        self.robot = RobotModel(recording.robot)
        self.q = recording.q[0]

    def turn_through(self, vectors: Array) -> Array:
        return np.stack([self._at(R) for R in super().turn_through(vectors)])

    def towards(self, stop: Stop) -> Array:
        if stop.away_from_rad is None:
            return super().towards(stop)
        start, avoided = self.q.copy(), np.array(stop.away_from_rad)
        super().towards(stop)
        reached = [self.q, *self._other_postures()]
        self.q = max(reached, key=lambda q: float(np.abs(q - avoided).max()))
        s = _ease(1.0, RATE / max(float(np.abs(self.q - start).max()), RATE))
        return np.asarray(start + s[:, None] * (self.q - start))

    def make_wave(self, wave: Wave) -> Array:
        shape = wave_shape(wave, self.robot.n, STEP_S)
        rate = np.gradient(shape, STEP_S, axis=0)
        twist = rate @ self.robot.sensor_jacobian(self.q).T
        linear, angular = (np.linalg.norm(part, axis=1).max() for part in (twist[:, :3], twist[:, 3:]))
        acceleration = np.abs(np.gradient(rate, STEP_S, axis=0)).max()
        return np.asarray(self.q + min(SPEED / linear, RATE / angular, JOINT_ACCELERATION / acceleration) * shape)

    def complete_recording(self, bare: Recording, coarse: Array, path: Array) -> Recording:
        return replace(bare, q=np.asarray(CubicSpline(coarse, path)(bare.t)), robot=self.description)

    def _at(self, R: Array, iterations: int = 1) -> Array:
        """Joints (n,) with the sensor at an attitude (3, 3) and its place, near where they are: damped least squares."""
        for _ in range(iterations):
            pose, J = self.robot.sensor_pose(self.q), self.robot.sensor_jacobian(self.q)
            wrong = np.concatenate((pose.rotation.T @ (self.place - pose.position), axial(pose.rotation.T @ R)))
            step = J.T @ np.linalg.solve(J @ J.T + 1e-5 * np.eye(6), wrong)
            self.q = self.q + step * min(1.0, 0.5 / max(np.abs(step).max(), 1e-9))
        return np.asarray(self.q)

    def _other_postures(self) -> list[Array]:
        """Other joint positions within the limits with the sensor where it is."""
        rng, R, here = np.random.default_rng(0), self.R, self.q
        lower, upper = np.maximum(self.robot.lower, here - np.pi), np.minimum(self.robot.upper, here + np.pi)
        found = []
        for _ in range(RESTARTS):
            self.q = rng.uniform(lower, upper)
            q = self._at(R, iterations=30)
            there = self.robot.sensor_pose(q)
            error = max(np.abs(there.rotation - R).max(), np.abs(there.position - self.place).max())
            if error < 1e-3 and (q > lower).all() and (q < upper).all():
                found.append(q)
        self.q = here
        return found


def trapezoids(swings: Swings) -> Array:
    """(K,), angle every `STEP_S`, out and back.

    Raises:
        ValueError: how often is for a plan to settle.
    """
    if swings.repetitions is None:
        raise ValueError("a rotation without a number of repetitions has no length before it is planned")
    ramp = max(1, round(np.sqrt(swings.excursion_rad / ACCELERATION) / STEP_S))
    out = np.repeat([1.0, -1.0], ramp)
    rate = ACCELERATION * STEP_S * np.cumsum(np.tile(np.concatenate((out, -out)), swings.repetitions))
    return np.asarray(STEP_S * np.cumsum(rate))


def _ease(distance: float, speed: float) -> Array:
    """(K,), from 0 to `distance` with that mean speed, at rest at both ends."""
    s = np.linspace(0.0, 1.0, max(2, round(1.5 * distance / speed / STEP_S)))
    return np.asarray(distance * s**3 * (10.0 - 15.0 * s + 6.0 * s**2))
