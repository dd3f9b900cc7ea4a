"""The nominal run of a recording, to which effects are applied."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from core.array import Array, interpolate
from core.effects.scene import Scene
from core.estimation.kinematics import Poses, local_derivative
from core.estimation.segments import Segment
from core.payload.inertia import Motion
from core.recording.recording import Recording
from core.robot.dynamics import LinkDynamics, has_masses
from core.robot.model import RobotModel

Take = Callable[[Array], Array]
"""What samples (N, ...) are in the scene's rows."""
Links = tuple[Array, Array, Array] | tuple[None, None, None]
SMOOTHING_S = 0.036
"""Of the joints' accelerations."""


def scene_of(recording: Recording, poses: Poses, motion: Motion, segments: tuple[Segment, ...], t: Array) -> Scene:
    """The nominal run on a grid t (N,), uniform but for the gaps of the recording.

    Between samples all that moves is interpolated: at the nearest ones a joint would go by fits and starts wherever the period of the
    recording does not divide that of the grid.
    """
    take = partial(interpolate, t, recording.t)
    rows = np.clip(np.searchsorted(poses.t, t - 0.5 * poses.period), 0, len(poses.t) - 1)
    phase = np.concatenate([np.full(part.stop - part.start, part.phase) for part in segments])
    robot = None if recording.robot is None else RobotModel(recording.robot)
    links = (None, None, None) if robot is None else link_dynamics(recording, robot, take)
    scene = _scene_at(recording, poses, motion, t, rows, take, robot, links)
    return replace(scene, phase=phase[rows], dq=None if scene.q is None else np.gradient(scene.q, t, axis=0))


def scene_of_poses(recording: Recording, poses: Poses, phase: NDArray[np.str_], rows: NDArray[np.intp]) -> Scene:
    """Poses by themselves: some rows of a recording, each motionless, with a label for each."""
    robot = None if recording.robot is None else RobotModel(recording.robot)
    take = partial(np.take, indices=rows, axis=0)
    links: Links = (None, None, None)
    if recording.q is not None and robot is not None and has_masses(robot):
        q = take(recording.q)
        model = LinkDynamics(robot, recording.gravity)
        links = model.inertia(q), model.torque(q, np.zeros_like(q), np.zeros_like(q)), model.first_moment(q)
    scene = _scene_at(recording, poses, Motion.still(poses.g[rows]), poses.t[rows], rows, take, robot, links)
    return replace(scene, phase=phase, dq=None if scene.q is None else np.zeros_like(scene.q), apart=True)


def _scene_at(
    recording: Recording, poses: Poses, motion: Motion, t: Array, rows: NDArray[np.intp], take: Take, robot: RobotModel | None, links: Links
) -> Scene:
    """What the recording says of each row by itself."""
    q, (link_inertia, link_torque, link_moment) = None if recording.q is None else take(recording.q), links
    return Scene(
        t=t,
        phase=np.full(len(t), ""),
        motion=motion,
        rotation=poses.rotation[rows],
        position=None if poses.position is None else take(poses.position),
        gravity=poses.gravity,
        phi=np.zeros(10),
        q=q,
        jacobian=None if q is None or robot is None else robot.sensor_jacobians(q),
        torque=None if recording.tau is None else take(recording.tau),
        link_inertia=link_inertia,
        link_torque=link_torque,
        link_moment=link_moment,
        temperature=None if recording.temperature is None else take(recording.temperature),
        range=recording.sensor.range,
        resolution=recording.sensor.resolution,
    )


def link_dynamics(recording: Recording, robot: RobotModel, take: Take) -> Links:
    """Inertia (N, n, n), torque (N, n) and first moment (N, 3) of the arm without payload in the scene's rows; None where its masses are
    not known."""
    if recording.q is None or not has_masses(robot):
        return None, None, None
    q, dq, ddq = (take(local_derivative(recording.q, order, recording.t, window_s=SMOOTHING_S)) for order in range(3))
    links = LinkDynamics(robot, recording.gravity)
    return links.inertia(q), links.torque(q, dq, ddq), links.first_moment(q)
