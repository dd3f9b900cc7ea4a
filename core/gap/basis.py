"""From a recording to the basis of its diagnosis: poses, windows, noise, motions, and the nominal run that effects are applied to."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from core.effects.scene import Scene
from core.errors import HeftError
from core.estimation.kinematics import Poses, axial, poses_of, smooth_motion
from core.estimation.noise import sensor_noise, unknown_noise
from core.estimation.segments import Segment, motionless, segments_of_motion, segments_of_phase
from core.estimation.weak_form import RawFeatures, regressor_of
from core.gap.windows import Basis, window_matrix
from core.inertia import Motion
from core.recording import Recording
from core.robot import RobotModel

Array = NDArray[np.float64]

GRID_S = 0.005
"""Period of the scene that effects are applied to."""
SMOOTHING_S = 0.036
"""Of the motion that effects act on: short enough for the corners of a trapezoid, long enough for the encoders' noise."""
SHORTEST_S = 3.0
NARROW_S = 0.0125
"""Knot spacing of the narrow windows."""
SLOWEST_PERIOD_S = 0.02
NOTHING_MOVES_RAD = 0.02


class TooLittleError(HeftError):
    """The recording is too short or too still to say anything about a gap; the sentence says why."""


def basis_of(recording: Recording) -> Basis:
    """The basis of one recording.

    Raises:
        TooLittleError: no wrench, no motion, or too few samples.
    """
    poses = poses_of(recording)
    if recording.wrench is None:
        raise TooLittleError("the recording has no wrist wrench: the gap of joint torques alone is shown by the joint side only")
    if poses is None:
        raise TooLittleError("the recording has neither joints nor poses")
    if poses.period > SLOWEST_PERIOD_S or len(recording) < 200:
        raise TooLittleError(
            f"{len(recording)} samples at {1.0 / poses.period:.0f} Hz are poses, not motion: only a payload can be fitted to them"
        )
    if recording.t[-1] - recording.t[0] < SHORTEST_S:
        raise TooLittleError(f"{recording.t[-1] - recording.t[0]:.1f} s are too short to say anything")
    if float(np.ptp(poses.g, axis=0).max()) < NOTHING_MOVES_RAD * 9.81:
        raise TooLittleError("the sensor hardly turns: payload, offsets and effects cannot be told apart")
    motion, speed = smooth_motion(poses, window_s=SMOOTHING_S)
    segments = segments_of(recording, motion, speed)
    still = motionless(recording.t, segments)
    noise = sensor_noise(recording.wrench, still, segments, nominal_std=recording.sensor.noise_std) or unknown_noise()
    raw = RawFeatures(poses)
    grid = max(GRID_S, poses.period)
    narrow = max(NARROW_S, 4.0 * poses.period)
    t = np.arange(poses.t[0] + 2.0 * narrow, poses.t[-1] - 2.0 * narrow, grid)
    spread = window_matrix(t, narrow, poses.t)
    g, a, B = (np.asarray(spread @ x.reshape(len(poses.t), -1)).reshape(len(t), *x.shape[1:]) for x in (poses.g, raw.a, raw.B))
    omega = np.column_stack([np.interp(t, poses.t, channel) for channel in motion.omega.T])
    scene = scene_of(recording, poses, Motion(g, a, omega, axial(B)), segments, t)
    return Basis(poses, noise, segments, scene, np.asarray(spread @ recording.wrench), regressor_of(a - g, B), spread, raw.difference)


def segments_of(recording: Recording, motion: Motion, speed: Array) -> tuple[Segment, ...]:
    """Motions by their labels, or found."""
    if recording.phase is not None:
        return segments_of_phase(recording.phase)
    return segments_of_motion(recording.t, motion.omega, speed, motion.g, threshold=np.array([0.01, 0.005]))


def scene_of(recording: Recording, poses: Poses, motion: Motion, segments: tuple[Segment, ...], t: Array) -> Scene:
    """The nominal run on a uniform grid t (N,)."""
    period = float(t[1] - t[0])
    rows = np.clip(np.searchsorted(poses.t, t - 0.5 * poses.period), 0, len(poses.t) - 1)
    phase = np.concatenate([np.full(part.stop - part.start, part.phase) for part in segments])
    robot = None if recording.robot is None else RobotModel(recording.robot)
    q = None if recording.q is None else recording.q[rows]
    dq = None if q is None else np.gradient(q, period, axis=0)
    return Scene(
        t=t,
        phase=phase[rows],
        motion=motion,
        rotation=poses.rotation[rows],
        position=None if poses.position is None else poses.position[rows],
        gravity=poses.gravity,
        phi=np.zeros(10),
        q=q,
        dq=dq,
        jacobian=None if q is None or robot is None else np.stack([robot.sensor_jacobian(row) for row in q]),
        torque=None if q is None or robot is None else joint_torque(recording, robot, q, rows),
        temperature=None if recording.temperature is None else recording.temperature[rows],
        range=recording.sensor.range,
        resolution=recording.sensor.resolution,
    )


def joint_torque(recording: Recording, robot: RobotModel, q: Array, rows: NDArray[np.intp]) -> Array | None:
    """(N, n), measured, or what gravity asks of the arm by its masses; None where the URDF has none."""
    if recording.tau is not None:
        return recording.tau[rows]
    if sum(inertia.mass for inertia in robot.model.inertias) <= 0.0:
        return None
    model = robot.model.copy()
    model.gravity.linear = recording.gravity
    data = model.createData()
    return np.stack([pin.computeGeneralizedGravity(model, data, row) for row in q])
