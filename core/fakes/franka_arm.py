"""The controller of a Panda or Franka Research 3, and the virtual robot as its arm: motion generator of joint positions, reflexes, load.

Layouts and states as the published headers and the client library have them; limits, backward differences, what becomes of lost commands
and after how many a motion ends as the maker's documentation of the interface says. What it does not say is decided here, and
docs/robots.md lists it: how hard the arm brakes in a reflex or for `StopMove`, how near the first command has to be, what is told of a
state while nothing moves, that the estimate of external forces is always zero, and that one client is served at a time.
"""

from __future__ import annotations

from collections import deque

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.fakes.franka_protocol import Order, State
from core.fakes.moved_arm import MovedArm
from core.payload.inertia import InertialParameters

OTHER, IDLE, MOVE, GUIDING, REFLEX, USER_STOPPED = range(6)
POSITION_LIMIT, JOINT_REFLEX, START_POSE, SPEED, ACCELERATION, JERK, COMMUNICATION = 0, 6, 11, 13, 14, 15, 25
"""Errors by the places of their flags."""
PERIOD = 0.001
MOST_LOST = 20
"""Commands in a row that may be lost, but for the last."""
START_RAD = 0.01
STANDS_RAD_S = 1e-3
"""A motion may be finished below this speed."""
PANDA_LIMITS = np.array([15, 7.5, 10, 12.5, 15, 20, 20.0]), np.array([7500, 3750, 5000, 6250, 7500, 10000, 10000.0])
RESEARCH_LIMITS = np.full(7, 10.0), np.full(7, 5000.0)
"""Acceleration and jerk, rad/s2 and rad/s3."""
NEAR_RAD_S, NEAR_RAD_S2 = 0.2, 6.0
"""Near the end of a joint it may go only so fast as it can brake with the latter, less the former."""
NUMBER_AT_BEGIN = 812_345
"""The controller has been on for a while."""


class FrankaArm(MovedArm):
    """What the controller knows and does; it has no sensor at its flange.

    Args:
        cell, payload, seed: as of any arm. version: of the server, 5 to 10.
    """

    def __init__(self, cell: Cell, payload: InertialParameters | None = None, seed: int = 0, *, version: int = 10) -> None:
        super().__init__(cell, payload, seed, PERIOD)
        self.version, self.model = version, "panda" if version <= 5 else "fr3"
        self.mode, self.errors, self.reasons = IDLE, set[int](), set[int]()
        self.motion, self.controller = 0, 3
        self.number = NUMBER_AT_BEGIN
        self.mass, self.com, self.inertia = 0.0, np.zeros(3), np.zeros(9)
        self.end_effector_kg = 0.0
        self.tool = np.array([[0.8, -0.6, 0, 0], [0.6, 0.8, 0, 0], [0, 0, 1, 0.1034], [0, 0, 0, 1.0]])
        """End effector in the flange."""
        self.acceleration_limit, self.jerk_limit = PANDA_LIMITS if version <= 5 else RESEARCH_LIMITS
        joints = self._robot.arm.joints
        self.lower, self.upper, self.speed_limit = (np.array([getattr(j, name) for j in joints]) for name in ("lower", "upper", "velocity"))
        self.dq_d, self.ddq_d = np.zeros((2, self.n))
        self.ended: deque[str] = deque()
        """What has become of moves; to be told."""
        self._order: Order | None = None
        self._begun, self._unheard = False, 0
        self._had: deque[bool] = deque(maxlen=100)

    @property
    def obeys(self) -> bool:
        """Whether commands are followed."""
        return self.mode == MOVE

    def begin_move(self) -> None:
        """From now on commands are followed; the arm stands until the first comes."""
        self.mode, self.motion, self.controller = MOVE, 1, 0
        self.reasons.clear()
        self._begun, self._unheard, self._order = False, 0, None
        self._had.clear()
        self.dq_d, self.ddq_d = np.zeros((2, self.n))

    def take(self, order: Order) -> bool:
        """A command; whether it is for the newest state. What is late is dropped."""
        if not self.obeys or order.number != self.number:
            return False
        self._order = order
        return True

    def fail(self, error: int) -> None:
        """A reflex: the arm brakes, and nobody may move it until the error is cleared."""
        moved = self.obeys
        self.errors.add(error)
        self._end(REFLEX, "reflex" if moved else None)

    def press_user_stop(self) -> None:
        """Somebody holds the stop button."""
        self._end(USER_STOPPED, "emergency")

    def guide(self) -> None:
        """Somebody takes the arm by its handle."""
        self._end(GUIDING, "aborted")

    def close_brakes(self) -> None:
        """The joints are locked in Desk."""
        self._end(OTHER, "aborted")

    def stop_move(self) -> None:
        """The motion ends because somebody said so."""
        self._end(IDLE, "preempted")

    def set_load(self, mass: float, com: Array, inertia: Array) -> None:
        """What it is to believe that it carries: centre of mass (3,) in the flange, inertia (9,) about it by columns."""
        self.mass, self.com, self.inertia = mass, com, inertia

    def recover(self) -> None:
        """Errors are cleared."""
        if self.mode == REFLEX:
            self.mode = IDLE
            self.errors.clear()

    def step(self) -> None:
        """One cycle: the command that came for the newest state is followed, or made up for, and the arm moves."""
        before = self.target
        if self._braking:
            self._go_to(self._braking.pop(0))
        elif self.obeys:
            self._follow()
        else:
            self._go_to(self.target)
        self._order = None
        self._move(before)
        self.number += 1

    def state(self) -> bytes:
        """What is sent in this cycle."""
        sample, order = self.samples[-1], self.order
        position, rotation = self.flange(sample.q)
        flange = np.eye(4)
        flange[:3, :3], flange[:3, 3] = rotation, position
        tool = self.tool.ravel(order="F")
        said = {
            "O_T_EE": (flange @ self.tool).ravel(order="F"), "F_T_EE": tool, "F_T_NE": tool,
            "m_ee": np.array([self.end_effector_kg]), "m_load": np.array([self.mass]), "I_load": self.inertia, "F_x_Cload": self.com,
            "tau_J": sample.tau[order], "q": sample.q[order], "dq": sample.dq[order],
            "q_d": self.target[order], "dq_d": self.dq_d[order], "ddq_d": self.ddq_d[order],
            "theta": sample.q[order], "dtheta": sample.dq[order], "O_ddP_O": np.array([0.0, 0.0, -9.81]),
        }  # fmt: skip
        success = sum(self._had) / 100.0 if self.obeys else 0.0
        return State(
            self.number, said, self.motion, self.controller, self.errors, self.reasons, self.mode, success
        ).pack(self.version)  # fmt: skip

    def description(self) -> str:
        """The robot's URDF, as far as anybody looks at it."""
        joints = "".join(
            f'<joint name="{self.model}_joint{k + 1}" type="revolute"><parent link="link{k}"/><child link="link{k + 1}"/>'
            f'<limit effort="87" lower="{self.lower[j]:.6f}" upper="{self.upper[j]:.6f}" velocity="{self.speed_limit[j]:.6f}"/>'
            f'<position_based_velocity_limits velocity_offset="{NEAR_RAD_S}" deceleration_limit="{NEAR_RAD_S2}"/></joint>'
            for k, j in enumerate(self.order)
        )
        links = "".join(f'<link name="link{k}"/>' for k in range(self.n + 1))
        return f'<?xml version="1.0"?><robot name="{self.model}">{links}{joints}</robot>'

    def _follow(self) -> None:
        """To where the client wants it, where that keeps the limits; where it says nothing, on with the same acceleration."""
        order = self._order
        self.periods_followed += self._begun
        self._had.append(order is not None)
        if order is None:
            self.missed += self._begun and self.moves
            self._unheard += self._begun
            if self._unheard >= MOST_LOST:
                self.fail(COMMUNICATION)
                return
            self.dq_d = self.dq_d + PERIOD * self.ddq_d
            self.target = self.target + PERIOD * self.dq_d
            return
        self._unheard = 0
        wanted = np.empty(self.n)
        wanted[self.order] = order.q
        if not self._begun and np.abs(wanted - self.target).max() > START_RAD:
            self.fail(START_POSE)
            return
        if not self._begun:
            self.target = wanted  # the first one counts as standing
        self._begun = True
        error = self._judge(wanted)
        if error is not None:
            self.fail(error)
            return
        self._go_to(wanted)
        if order.finished:
            if np.abs(self.dq_d).max() > STANDS_RAD_S:
                self.fail(ACCELERATION)
                return
            self._end(IDLE, "success")

    def _judge(self, wanted: Array) -> int | None:
        """Which limit a command breaks."""
        if not np.isfinite(wanted).all() or ((wanted < self.lower) | (wanted > self.upper)).any():
            return POSITION_LIMIT
        dq = (wanted - self.target) / PERIOD
        ddq = (dq - self.dq_d) / PERIOD
        dddq = (ddq - self.ddq_d) / PERIOD
        room = np.where(dq > 0.0, self.upper - self.target, self.target - self.lower)
        still_brakes = np.sqrt(2.0 * NEAR_RAD_S2 * np.maximum(room, 0.0)) - NEAR_RAD_S
        for error, found, limit in (
            (SPEED, dq, np.clip(still_brakes, 0.0, self.speed_limit)),
            (ACCELERATION, ddq, self.acceleration_limit),
            (JERK, dddq, self.jerk_limit),
        ):
            if (np.abs(found) > limit).any():
                return error
        return None

    def _go_to(self, q: Array) -> None:
        dq = (q - self.target) / PERIOD
        self.ddq_d, self.dq_d, self.target = (dq - self.dq_d) / PERIOD, dq, q

    def _end(self, mode: int, outcome: str | None) -> None:
        """A motion that is under way ends: the arm brakes."""
        if self.obeys:
            if outcome is not None:
                self.ended.append(outcome)
            self.reasons = set(self.errors)
            self._brake()
        self.mode, self.motion, self.controller = mode, 0, 3
