"""What a cell's twin adds to the reading of the simulated sensor, one control period at a time."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.effects.scene import Scene
from core.payload.inertia import Motion
from core.plant.virtual_robot import Truth
from core.robot.model import RobotModel
from core.twin.model import compose_effects, make_home_scene
from core.twin.twin import Twin


class TwinWrench:
    """The twin's effects along the motion of the virtual robot, of which only the past is known.

    Args:
        cell: robot, sensor, gravity.
        twin: its effects.
        phi: (10,), payload, sensor frame.
        period: of the control, s.
    """

    def __init__(self, cell: Cell, twin: Twin, phi: Array, period: float) -> None:
        self._robot = RobotModel(RobotModel.of_cell(cell).description)  # without the base's place: scenes are in the base frame
        self._phi = phi
        self._period = period
        known = make_home_scene(cell)
        self._gravity, self._range, self._resolution = known.gravity, known.range, known.resolution
        self._effects = compose_effects(twin, known)

    def change(self, robot: Truth) -> Array:
        """(6,), to be added to the sensor's reading of this period, N and N m."""
        return np.asarray(self._effects.change(self._row(robot))[0])

    def _row(self, robot: Truth) -> Scene:
        q = np.array(robot.q)
        pose = self._robot.sensor_pose(q)
        velocity, acceleration = self._robot.sensor_twist(q, robot.dq, robot.ddq)
        g = self._gravity @ pose.rotation
        return Scene(
            t=np.array([robot.t]),
            phase=np.array([""]),
            motion=Motion(g[None], acceleration[None, :3].copy(), velocity[None, 3:].copy(), acceleration[None, 3:].copy()),
            rotation=pose.rotation[None],
            position=pose.position[None],
            gravity=self._gravity,
            phi=self._phi,
            q=q[None],
            dq=np.array(robot.dq)[None],
            jacobian=self._robot.sensor_jacobian(q)[None],
            torque=np.array(robot.tau)[None],
            range=self._range,
            resolution=self._resolution,
            step=self._period,
        )
