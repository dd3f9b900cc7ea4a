"""The virtual robot: arm, drives, controller, encoders and wrist sensor, one period at a time."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array
from core.cell.cell import Cell
from core.cell.tools import add_cell_tools
from core.payload.inertia import InertialParameters
from core.plant.arm import arm_of_cell
from core.plant.controller import JointController
from core.plant.faults.fault import Fault, Setting
from core.plant.imperfections import Imperfections
from core.plant.links import Links
from core.plant.mechanics import NOTHING, PERIOD, Drives, build_model, build_spec
from core.plant.sensor import Encoders, WhiteNoise, WristSensor

Hook = TypeVar("Hook")

TORQUE_NOISE = 1e-3
"""Standard deviation of a measured joint torque, share of the joint's torque limit."""


@dataclass(frozen=True)
class Sample:
    """What the robot reports of one instant, SI; names as in `RobotState`."""

    t: float
    q: Array
    dq: Array
    q_cmd: Array
    wrench: Array
    tau: Array


@dataclass(frozen=True)
class Truth:
    """What really was at the instant of the last sample: for tests, and for effects that a twin adds to the reading.

    Args:
        q, dq, ddq: (n,), joints on the side of the links, counted from the zeros of their encoders.
        tau: (n,), drive torques, N m.
        wrench: (6,), on the payload, sensor axes, about the sensor origin.
        offset: (6,), of the wrist sensor, without drift.
    """

    t: float
    q: Array
    dq: Array
    ddq: Array
    tau: Array
    wrench: Array
    offset: Array


class VirtualRobot:
    """The cell's robot with its tools and a payload, standing at home to begin with.

    Args:
        cell: arm, sensor, tools, gravity, base pose.
        payload: what it carries beside the tools, sensor frame; all zero for nothing. Faults may make something else of it.
        rng: source of all chance: offset first, then the noise of every period.
        imperfections, faults: what is planted.
        drives: mechanical properties of the joints.

    Raises:
        BadRobot, BadPayload: the simulation cannot be built.
    """

    def __init__(
        self,
        cell: Cell,
        payload: InertialParameters,
        rng: np.random.Generator,
        *,
        imperfections: Imperfections | None = None,
        drives: Drives | None = None,
        faults: tuple[Fault, ...] = (),
    ) -> None:
        imperfections, drives = imperfections or Imperfections(), drives or Drives()
        self.arm = arm_of_cell(cell)
        self.carried = add_cell_tools(cell, payload)
        """Tools and payload as one rigid body: what the sensor feels."""
        self.home = np.array(cell.robot.home_rad)
        gravity = tilt_cell_gravity(cell, imperfections.base_tilt_rad)
        self._links = Links(self.arm, build_spec(self.arm, self.carried, gravity, drives), Setting(cell, self.carried), faults)
        self._machine = machine = self._links.machine
        frictionless = Drives(drives.armature_s2, drives.damping_s, friction=0.0)
        self._controller = JointController(
            build_model(self.arm, add_cell_tools(cell, NOTHING), cell.gravity, frictionless),
            torque_limit=self.arm.effort,
            acceleration_limit=2 * np.array(cell.robot.acceleration_rad_s2),
        )
        self._gears = _present(fault.gear(machine) for fault in faults)
        self._encode = _present(fault.encode(machine) for fault in faults)
        self._controller.settle(self.home, self._links.rest(self._where_drives_see(self.home)))
        self._sensor = WristSensor(
            cell.sensor,
            rng,
            period=PERIOD,
            delay=imperfections.wrench_delay_s,
            drift=imperfections.offset_drift,
            sense=_present(fault.sense(machine) for fault in faults),
            amplify=_present(fault.amplify(machine) for fault in faults),
            digitize=_present(fault.digitize(machine) for fault in faults),
        )
        self._encoders = Encoders(self.home, period=PERIOD, noise_std=cell.robot.encoder_std_rad)
        self._noise = WhiteNoise(rng, 6 + 2 * self.arm.n)
        self._torque_noise = TORQUE_NOISE * self.arm.effort
        self._tick = 0
        self._truth: Truth | None = None

    def _where_drives_see(self, q: Array) -> Array:
        """(n,), where the joints stand when the drives see them at q; the errors of gears are small, so this converges at once."""
        there = q
        for _ in range(10 if self._gears else 0):
            seen = there
            for gear in self._gears:
                seen, _ = gear(0.0, seen, np.zeros_like(q))
            there = there + q - seen
        return there

    @property
    def truth(self) -> Truth:
        """What really was at the last sample."""
        if self._truth is None:
            raise RuntimeError("the virtual robot has made no step yet")
        return self._truth

    def step(self, q_cmd: Array) -> Sample:
        """Waits for the next control instant, applies the position commanded for it, and samples.

        Args:
            q_cmd: (n,), rad; kept, so it must not change afterwards.
        """
        n = self.arm.n
        t = PERIOD * self._tick
        q, dq = motor_q, motor_dq = self._links.motors()
        for gear in self._gears:
            motor_q, motor_dq = gear(t, motor_q, motor_dq)
        tau = self._controller.torque(motor_q, motor_dq, q_cmd)
        moved = self._links.step(t, q, dq, tau)
        self._truth = Truth(t, moved.q, moved.dq, moved.ddq, tau, moved.wrench, self._sensor.offset)
        self._tick += 1
        noise = self._noise.row()
        joints = self._encoders.read(motor_q, noise[6 : 6 + n])
        q_read, dq_read = joints.q, joints.dq
        for encode in self._encode:
            q_read, dq_read = encode(t, q_read, dq_read)
        reading = self._sensor.read(t, moved.wrench, noise[:6])
        return Sample(t, q_read, dq_read, q_cmd, reading, tau + self._torque_noise * noise[6 + n :])


def _present(hooks: Iterable[Hook | None]) -> list[Hook]:
    return [hook for hook in hooks if hook is not None]


def tilt_cell_gravity(cell: Cell, tilt_rad: tuple[float, float]) -> Array:
    """(3,), gravity in the world frame of a cell whose base stands tilted; see `Imperfections`."""
    R_base = cell.robot.base.rotation
    tilt = Rotation.from_rotvec([*tilt_rad, 0.0]).as_matrix()
    return np.asarray(R_base @ tilt @ R_base.T @ cell.gravity)
