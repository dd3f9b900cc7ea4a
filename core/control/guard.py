"""The guard: every control tick is checked before its command goes out; what it finds stops the robot.

Checked are: the state (finite, fresh, a live wrench, following the command), joint positions and speeds, the Cartesian
speed of every corner of the links' boxes and of the payload box (measured and commanded), the wrench, and the distance
to obstacles, zones and the robot itself: today's, and that of the *predicted stop*, where the robot would stand if it
braked now, all joints in proportion, as hard as the first of them can (drives that keep to the path while they stop).

An exact distance costs several times as much as everything else together. No margin changes by more than the motion
bound of the collision model, so after an exact query the next is due only when the robot (or its predicted stop) has
moved by the margin found there. Nothing is missed by that as long as obstacles and zones stand still; what moves (a
live zone) is seen by the query every `SAMPLING` seconds, which also goes into the record.

What planning must leave: both distances must keep the whole clearance. The predicted stop of a robot that slows down or
turns in time is ahead of its path by what it travels in the reaction time, less than 1 mm at 0.25 m/s; a few
millimetres of spare margin suffice.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.control.bounds import JointLimits
from core.control.checks import Findings, GuardStop, Numbers, _check
from core.control.faults import make_distance_error, make_frozen_error, make_stop_error
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.pair_group import Nearest
from core.sessions.session import RobotState

SAMPLING = 0.02
"""An exact distance is taken at least this often, s."""

REACTION = 3.0
"""Periods that pass before braking begins: one until the next check, the rest until a stop reaches the arm through its drives."""

SPEED_TOLERANCE = 1.02
"""Measured speeds may exceed a limit by this factor: measurement noise, not permission. Plans keep below the limit itself."""

POSITION_TOLERANCE = 2e-3
"""Measured positions may be past a joint limit by this much, rad; commanded ones not at all."""

LATE = 10.0
"""Periods after which a state counts as late."""

HISTORY = 0.5
"""Time of samples that an error carries, s."""


@dataclass(frozen=True)
class SafetyRecord:
    """What the guard saw.

    Args:
        min_distance_m: smallest distance to obstacles and zones that was sampled, of everything that moves; `nearest` says
            between what, None before the first tick.
        beyond_first_m: the same without the links that only the first joint moves, as in `Guard.distances`.
        min_margin_m: smallest distance beyond what is required, between links too.
        max_speed_m_s: largest measured Cartesian speed, of `fastest`.
        ticks: number of states checked; `queries`: exact distances among them.
    """

    min_distance_m: float
    nearest: Nearest | None
    beyond_first_m: float
    min_margin_m: float
    max_speed_m_s: float
    fastest: str
    ticks: int
    queries: int


class Guard:
    """Checks states and commands of one cell.

    Args:
        cell: limits and sensor.
        robot: kinematics.
        collision: distances; zones may change in it while the robot runs.
        period: control period, s.
        late_s: how long after the last one a state may come; `LATE` periods where absent.
        tracking_limit: largest distance of a joint from its command, rad.
        frozen_after: time without any change in the six wrench channels that counts as a dead sensor, s; `inf` where
            the wrench has no noise.
    """

    def __init__(
        self,
        cell: Cell,
        robot: RobotModel,
        collision: CollisionModel,
        *,
        period: float,
        late_s: float | None = None,
        tracking_limit: float = 0.05,
        frozen_after: float = 0.25,
    ) -> None:
        self.cell, self.robot, self.collision, self.period = cell, robot, collision, period
        self.limits = JointLimits.of(cell, robot)
        self.distances: list[tuple[float, float]] = []
        """Time (s) and smallest `CollisionModel.obstacle_distance` (m), every `SAMPLING` seconds."""
        self._numbers = Numbers(
            period,
            LATE * period if late_s is None else late_s,
            cell.limits.cartesian_speed_m_s,
            SPEED_TOLERANCE,
            POSITION_TOLERANCE,
            tracking_limit,
            REACTION * period,
            *self.limits,
            # a saturated channel reads within one step of the end of its range
            load=np.array(cell.sensor.range) - np.array(cell.sensor.resolution),
            reach=collision.reach,
        )
        self._found = Findings(*[np.zeros(1), np.zeros(1), np.zeros(robot.n), np.zeros((2, robot.n)), np.zeros(2), np.zeros(2)])
        self._fixed = (*robot.chain, collision.points.joint, collision.points.local, self._numbers, self._found)
        self._history: deque[RobotState] = deque(maxlen=max(1, round(HISTORY / period)))
        self._frozen_after = frozen_after
        self._sampling_ticks = max(1, round(SAMPLING / period))
        self._ticks = self._queries = 0
        self._max_speed, self._fastest = 0.0, "nothing"
        self._nearest: Nearest | None = None
        self._left_out: Nearest | None = None
        self._min_margin = math.inf
        self._wrench, self._still_s = np.full(6, np.nan), 0.0  # a sensor that dies may do so between two phases
        self._warm_up()
        self.begin()

    def begin(self) -> None:
        """A phase begins: the clock may have gone on since the last state, obstacles and zones may have moved."""
        self._t = math.nan
        self._until_sample = 0
        self._found.known_margin[:] = -math.inf

    def check(self, state: RobotState, target: Array) -> None:
        """One control tick: the state, and the joint positions (n,) that are about to be commanded.

        Raises:
            BadState, OutOfLimits, TooFast, OverLoad, TooClose: with the last samples; the caller stops the robot.
        """
        self._history.append(state)
        self._ticks += 1
        dt = state.t - self._t
        code, index = _check(*self._fixed, dt, state.q, state.dq, state.q_cmd, state.wrench, target)
        if code or not math.isfinite(state.t):
            raise make_stop_error(
                GuardStop(code or GuardStop.NOT_FINITE), index, float(self._found.value[0]), cell=self.cell, robot=self.robot,
                owner=self.collision.points.owner[index], numbers=self._numbers, samples=self._history,
            )  # fmt: skip
        self._t = state.t
        if self._found.speed[0] > self._max_speed:
            self._max_speed, self._fastest = float(self._found.speed[0]), self.collision.points.owner[index]
        self._check_wrench_lives(state, 0.0 if math.isnan(dt) else dt)
        self._check_distance(state)

    @property
    def record(self) -> SafetyRecord:
        """What was seen so far."""
        beyond = math.inf if self._nearest is None else self._nearest.distance_m
        seen = [each for each in (self._nearest, self._left_out) if each is not None]
        nearest = min(seen, key=lambda each: each.distance_m, default=None)
        least = math.inf if nearest is None else nearest.distance_m
        return SafetyRecord(least, nearest, beyond, self._min_margin, self._max_speed, self._fastest, self._ticks, self._queries)

    def _warm_up(self) -> None:
        """Compiles the checks, or loads them, before anything moves."""
        home, still = np.array(self.cell.robot.home_rad), np.zeros(self.robot.n)
        _check(*self._fixed, math.nan, home, still, home, np.zeros(6), home)

    def _check_wrench_lives(self, state: RobotState, dt: float) -> None:
        self._still_s += dt
        if state.wrench[0] != self._wrench[0] or (state.wrench != self._wrench).any():
            self._wrench, self._still_s = state.wrench, 0.0
        elif self._still_s >= self._frozen_after:
            raise make_frozen_error(self._still_s, self._frozen_after, self._history)

    def _check_distance(self, state: RobotState) -> None:
        """Today's margin and that of the predicted stop, exact where the motion bound does not settle it."""
        certified = self._found.certified
        self._until_sample -= 1
        if self._until_sample <= 0:
            certified[0] = self._remember(0, state.q, self._sample(state))
        elif certified[0] < 0.0:
            certified[0] = self._remember(0, state.q, self.collision.margin(state.q))
        if certified[0] < 0.0:
            raise make_distance_error(self.collision.nearest(state.q), self.collision.cell, predicted=False, samples=self._history)
        stop = self._found.stop
        if certified[1] < 0.0 and self._remember(1, stop, self.collision.margin(stop)) < 0.0:
            raise make_distance_error(self.collision.nearest(stop), self.collision.cell, predicted=True, samples=self._history)

    def _remember(self, k: int, q: Array, margin: float) -> float:
        """Keeps the exact margin at q, today's (k = 0) or the predicted stop's (1)."""
        self._queries += 1
        self._found.known_q[k] = q
        self._found.known_margin[k] = margin
        if k == 0:
            self._min_margin = min(self._min_margin, margin)
        return margin

    def _sample(self, state: RobotState) -> float:
        """The exact margin now, for the record and because zones may move. What was known of the predicted stop is old as well."""
        self._until_sample = self._sampling_ticks
        self._found.known_margin[1] = self._found.certified[1] = -math.inf
        nearest = self.collision.obstacle_distance(state.q)
        self.distances.append((state.t, nearest.distance_m))
        self._nearest = _nearer(self._nearest, nearest)
        self._left_out = _nearer(self._left_out, self.collision.find_nearest_left_out(state.q))
        return min(nearest.margin_m, self.collision.self_margin(state.q))


def _nearer(so_far: Nearest | None, now: Nearest) -> Nearest:
    return now if so_far is None or now.distance_m < so_far.distance_m else so_far
