"""The nominal run of a recording, to which effects are applied."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from core.array import Array, interpolate
from core.effects.link_loads import LazyLinkLoads, LinkLoads
from core.effects.scene import Scene
from core.estimation.kinematics import Poses, local_derivative
from core.estimation.segments import Segment
from core.payload.inertia import Motion
from core.recording.recording import Recording
from core.robot.dynamics import LinkDynamics, has_masses
from core.robot.model import RobotModel

Take = Callable[[Array], Array]
"""What samples (N, ...) are in the scene's rows."""
Differentiate = Callable[[Array, int], Array]
"""Derivative of this order of positions (N, n) of joints, by time."""
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
    differentiate = partial(local_derivative, t=recording.t, window_s=SMOOTHING_S)
    scene = _scene_at(recording, poses, motion, t, rows, take, robot, differentiate)
    return replace(scene, phase=phase[rows], dq=None if scene.q is None else np.gradient(scene.q, t, axis=0))


def scene_of_poses(recording: Recording, poses: Poses, phase: NDArray[np.str_], rows: NDArray[np.intp]) -> Scene:
    """Poses by themselves: some rows of a recording, each motionless, with a label for each."""
    robot = None if recording.robot is None else RobotModel(recording.robot)
    take = partial(np.take, indices=rows, axis=0)
    scene = _scene_at(recording, poses, Motion.still(poses.g[rows]), poses.t[rows], rows, take, robot, _differentiate_at_rest)
    return replace(scene, phase=phase, dq=None if scene.q is None else np.zeros_like(scene.q), apart=True)


def _scene_at(
    recording: Recording,
    poses: Poses,
    motion: Motion,
    t: Array,
    rows: NDArray[np.intp],
    take: Take,
    robot: RobotModel | None,
    differentiate: Differentiate,
) -> Scene:
    """What the recording says of each row by itself."""
    q = None if recording.q is None else take(recording.q)
    links = None
    if recording.q is not None and robot is not None and has_masses(robot):
        links = LazyLinkLoads(partial(_find_loads, LinkDynamics(robot, recording.gravity), recording.q, take, differentiate))
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
        links=links,
        temperature=None if recording.temperature is None else take(recording.temperature),
        range=recording.sensor.range,
        resolution=recording.sensor.resolution,
    )


def _find_loads(dynamics: LinkDynamics, samples: Array, take: Take, differentiate: Differentiate) -> LinkLoads:
    """In the scene's rows, of joints at samples (M, n)."""
    q, dq, ddq = (take(differentiate(samples, order)) for order in range(3))
    return LinkLoads(dynamics.inertia(q), dynamics.torque(q, dq, ddq), dynamics.first_moment(q))


def _differentiate_at_rest(q: Array, order: int) -> Array:
    return q if order == 0 else np.zeros_like(q)
