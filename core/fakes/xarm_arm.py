"""The controller of a UFACTORY arm, and the virtual robot as its arm: state, mode, errors, servo motion, force/torque sensor.

Written from the maker's public manuals (user manual, private TCP protocol, guide to the servo mode). Where they are silent: a stop brakes
all joints together at `BRAKING`; servo motion goes to the newest position at `JOINT_SPEED` at most; setting the zero of the force/torque
sensor changes its external force and not its raw data.
"""

from __future__ import annotations

import math

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.fakes.moved_arm import BRAKING, MovedArm
from core.payload.inertia import InertialParameters

MOVING, READY, PAUSED, STOPPED, RESET = 1, 2, 3, 4, 5
"""Motion states that a controller reports."""
GO, PAUSE, STOP = 0, 3, 4
"""Motion states that it is told."""
POSITION, SERVO = 0, 1
"""Modes."""
EMERGENCY, COLLISION, SENSOR = 1, 31, 50
"""Error codes: emergency stop, collision, force/torque sensor."""
JOINT_SPEED = math.pi


class XarmArm(MovedArm):
    """What the controller knows and does.

    Args:
        cell, payload, seed: as of any arm.
        period: of reports and servo motion, s: 5 ms with a force/torque sensor, 4 ms without.
    """

    def __init__(self, cell: Cell, payload: InertialParameters | None = None, seed: int = 0, *, period: float = 0.005) -> None:
        super().__init__(cell, payload, seed, period)
        self.type = self.n
        self.serial, self.box_serial, self.version = "XI130506D42L01", "AC130403D23A05", "v2.5.5"
        self.mode, self._state = POSITION, STOPPED
        self.error = self.warning = 0
        self.enabled, self.simulation, self.reduced = True, False, False
        self.tcp_offset = np.array([0.0, 0.0, 0.1, 0.0, 0.3, 0.0])
        """x y z (m), roll pitch yaw (rad), in the flange."""
        self.payload, self.payload_com = 0.0, np.zeros(3)
        self.lower = np.array([joint.lower for joint in self._robot.arm.joints])
        self.upper = np.array([joint.upper for joint in self._robot.arm.joints])
        self.joint_speed = JOINT_SPEED
        self.sensor_on, self.sensor_mode = False, 0
        self.sensor_zero = np.zeros(6)
        self._wanted: Array | None = None
        self._fresh = False

    @property
    def state(self) -> int:
        """The motion state that it reports."""
        return MOVING if self._state == READY and self.moves else self._state

    @property
    def obeys(self) -> bool:
        """Whether it takes servo commands."""
        return self.mode == SERVO and self._state == READY

    def set_state(self, value: int) -> None:
        """0 goes on, where nothing is wrong; 3 pauses; 4 stops."""
        if value == GO:
            if self.enabled and not self.error:
                self._state = READY
        elif value in {PAUSE, STOP}:
            self._state = PAUSED if value == PAUSE else STOPPED
            self._brake()

    def set_mode(self, mode: int) -> None:
        """Another mode ends what moves, and the state has to be set again."""
        self.mode, self._state = mode, RESET
        self._brake()

    def enable(self, on: bool) -> None:
        """Switches the motors on or off; either ends what moves."""
        if on and self.error:
            return
        self.enabled, self._state = on, STOPPED
        self._brake()

    def fail(self, error: int) -> None:
        """An error: the arm brakes, and at an emergency stop its motors go off."""
        self.error, self._state = error, STOPPED
        self.enabled = self.enabled and error != EMERGENCY
        self._brake()

    def servo(self, q: Array) -> None:
        """Where servo motion is to go; discarded where it is off."""
        if self.obeys:
            self._wanted, self._fresh = np.empty(self.n), True
            self._wanted[self.order] = q
            self._braking = []

    def set_load(self, mass: float, com: Array) -> None:
        """A command like those of motion: discarded while the controller is stopped or paused."""
        if self._state == READY:
            self.payload, self.payload_com = mass, com

    def step(self) -> None:
        """One period."""
        before = self.target
        if self._braking:
            self.target = self._braking.pop(0)
        elif self.obeys and self._wanted is not None:
            self.periods_followed += 1
            self.missed += self.moves and not self._fresh
            reach = self.joint_speed * self.period
            self.target = self.target + np.clip(self._wanted - self.target, -reach, reach)
        self._fresh = False
        self._move(before)

    def flange(self, q: Array) -> tuple[Array, Array]:
        """Position, m, and rotation of the flange in the base frame, at q in the controller's order."""
        ours = np.empty(self.n)
        ours[self.order] = q
        return super().flange(ours)

    def is_beyond(self, q: Array) -> bool:
        """Whether a joint is beyond its limits."""
        slack = 1e-6  # of what single precision loses
        return bool(((q < self.lower[self.order] - slack) | (q > self.upper[self.order] + slack)).any())

    def raw_force(self) -> Array:
        """(6,), what the load exerts on the sensor, N and N m; nothing while the sensor is off."""
        return -self.samples[-1].wrench if self.sensor_on else np.zeros(6)

    def external_force(self) -> Array:
        """(6,), without the zero that was set."""
        return self.raw_force() - self.sensor_zero if self.sensor_on else np.zeros(6)

    def set_sensor_zero(self) -> None:
        """What is felt now counts as nothing."""
        self.sensor_zero = self.raw_force()

    def _brake(self, acceleration: float = BRAKING) -> None:
        self._wanted = None
        super()._brake(acceleration)
