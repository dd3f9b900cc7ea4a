"""The controller of a UFACTORY arm, and the virtual robot as its arm: state, mode, errors, servo motion, force/torque sensor.

Written from the maker's public manuals (user manual, private TCP protocol, guide to the servo mode). Where they are silent: a stop brakes
all joints together at `BRAKING`; servo motion goes to the newest position at `JOINT_SPEED` at most, on a cubic spline whose acceleration
has no steps, one period late; setting the zero of the force/torque sensor changes its external force and not its raw data.
"""

from __future__ import annotations

import math
from collections import deque

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.fakes.flange import flange_at
from core.payload.inertia import InertialParameters
from core.plant.braking import braking_positions
from core.plant.virtual_robot import VirtualRobot

MOVING, READY, PAUSED, STOPPED, RESET = 1, 2, 3, 4, 5
"""Motion states that a controller reports."""
GO, PAUSE, STOP = 0, 3, 4
"""Motion states that it is told."""
POSITION, SERVO = 0, 1
"""Modes."""
EMERGENCY, COLLISION, SENSOR = 1, 31, 50
"""Error codes: emergency stop, collision, force/torque sensor."""
BRAKING = 6.0
"""Of every joint in a stop, rad/s2."""
JOINT_SPEED = math.pi
MOVING_RAD = 1e-6
"""A robot whose target moves by less in a period stands."""
DRIVES = 0.001
"""Period of the drives, s."""
SPLINE = np.array([[1.0, -3.0, 3.0, -1.0], [4.0, 0.0, -6.0, 3.0], [1.0, 3.0, 3.0, -3.0], [0.0, 0.0, 0.0, 1.0]]) / 6.0
"""(4, 4), shares of four targets in a row, oldest first, for 1, s, s2, s3 of the way s through a period: a uniform cubic B-spline."""


class XarmArm:
    """What the controller knows and does.

    Args:
        cell: gives arm, sensor and where the arm stands.
        payload: what it carries, sensor frame; a bare flange where None.
        seed: of the sensor's offset and noise.
        period: of reports and servo motion, s: 5 ms with a force/torque sensor, 4 ms without.
    """

    def __init__(self, cell: Cell, payload: InertialParameters | None = None, seed: int = 0, *, period: float = 0.005) -> None:
        carried = payload or InertialParameters(np.zeros(10))
        self.cell, self.period = cell, period
        self._robot = VirtualRobot(cell, carried, np.random.default_rng(seed))
        self.n = self._robot.arm.n
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
        self.order = list(range(self.n))
        """Which of the arm's joints the controller counts as its first, second, ...; another order is another robot."""
        self.stretch = 0.0
        """How much farther the flange is along its z than the model says, m: an arm with another calibration."""
        self.periods_followed = self.missed = 0
        """Periods in which servo motion was on, and those of them in which the arm moved and no new command had come."""
        self._wanted: Array | None = None
        self._fresh = False
        self._braking: list[Array] = []
        self.target = self.last = self._robot.home
        self._path = deque([self.target] * 4, maxlen=4)
        self.t = 0.0
        self.samples = [self._robot.step(self.target)]

    @property
    def q(self) -> Array:
        """(n,), where the arm really is, rad."""
        return self._robot.truth.q

    @property
    def moves(self) -> bool:
        """Whether it is on its way."""
        return float(np.abs(self.target - self.last).max()) > MOVING_RAD

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
        # A curve with steps in its velocity has an acceleration of its own in each period. A report that always comes at the same place of
        # the period then tells the force of another moment than the positions do (with parabolas 3 to 4 ms earlier, and 0.3 % less mass).
        self._path.append(self.target)
        steps = round(self.period / DRIVES)
        s = (1.0 + np.arange(steps)) / steps
        self.samples = [self._robot.step(q) for q in np.vander(s, 4, increasing=True) @ SPLINE.T @ np.array(self._path)]
        self.last = before
        self.t += self.period

    def flange(self, q: Array) -> tuple[Array, Array]:
        """Position, m, and rotation of the flange in the base frame, at q in the controller's order."""
        ours = np.empty(self.n)
        ours[self.order] = q
        position, rotation = flange_at(self.cell, self._robot.arm, ours)
        return position + rotation[:, 2] * self.stretch, rotation

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

    def _brake(self) -> None:
        self._wanted = None
        if self._braking:
            return
        dq = (self.target - self.last) / self.period
        if np.abs(dq).max() > 0.0:
            self._braking = list(braking_positions(self.target, dq, np.full(self.n, BRAKING), period=self.period))
