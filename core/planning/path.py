"""Collision-free paths in joint space; the only module that touches OMPL (RRT-Connect: Kuffner and LaValle 2000; RRT*: Karaman and
Frazzoli 2011).

OMPL's own checking resolution is not relied on: each edge is checked by `certificate.is_clear`, which leaves no gap between samples.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from ompl import base, geometric, util

from core.array import Array
from core.cell.body_name import name_body
from core.cell.cell import Cell
from core.errors import NoPath
from core.planning.certificate import LeastMargin, least_margin
from core.planning.effort import PATH_ITERATIONS
from core.planning.joint_torques import JointTorques
from core.planning.pair_margins import PairMargins
from core.planning.room import Room
from core.planning.settings import Planner
from core.planning.shortcut import shorten_path
from core.planning.throw import ThrowCheck
from core.planning.timing import MotionLimits, least_seconds
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.words.message import Message

SPARE_M = 0.005
"""Margin that planning keeps on top of the required clearance, for rounding corners and for the controller's tracking error."""

TIGHT_SPARE_M = 0.002
"""The same where no path is found that keeps `SPARE_M`."""

START, GOAL = Message.of("planning-end-start"), Message.of("planning-end-goal")
"""The ends of a path."""

_STEP_RAD = 0.02
_RANGE_RAD = 1.0
_SHORTENING_ATTEMPTS = 300

util.setLogLevel(util.LOG_NONE)


@dataclass(frozen=True)
class Path:
    """A collision-free path.

    Args:
        q: (N, n), dense joint positions with both ends, at most 0.02 rad apart.
        least_margin_m: smallest distance beyond what is required, along all of it.
        nearest: the pair of bodies at that place, for example "payload - wall".
        length_rad: in joint space.
    """

    q: Array
    least_margin_m: float
    nearest: str
    length_rad: float


def plan_path(
    cell: Cell,
    robot: RobotModel,
    collision: CollisionModel,
    start: Array,
    goal: Array,
    *,
    planner: Planner = "rrt_connect",
    seed: int = 0,
    iterations: int = PATH_ITERATIONS[-1],
    torques: JointTorques | None = None,
    spare_m: float = SPARE_M,
) -> Path:
    """Path from start (n,) to a goal that keeps every required distance, short in time at the cell's Cartesian speed limit.

    Args:
        goal: (n,), or (K, n) for a path to any one of them, whichever is found (see `one_turn_away`).
        seed: the same seed gives the same path, however busy the machine is.
        iterations: bound on the search; RRT* uses all of them.
        torques: with the load that the joints have to hold everywhere; None where they are not to be judged.
        spare_m: margin on top of the required distances.

    Raises:
        NoPath: start or goal outside the limits or too close to something; or nothing found in so many iterations.
    """
    start = np.array(start, dtype=float)
    throws = ThrowCheck(cell)
    check_end(START, start, robot, collision, throws)
    ends = np.stack((start, *_possible_goals(np.atleast_2d(np.array(goal, dtype=float)), robot, collision, throws)))
    limits = MotionLimits.of_cell(cell, robot, collision)
    room = Room(robot, collision, throws, ends, spare_m, torques)

    def cost(q: Array) -> float:
        return least_seconds(q, robot, limits)

    lines = sorted((np.stack((start, q)) for q in ends[1:]), key=cost)
    straight = next((line for line in lines if room.has_all(line)), None)
    found = _find_paths(room, collision, ends, planner, seed, iterations) if straight is None else [straight]
    rng = np.random.default_rng(seed)
    short = [shorten_path(q, cost, room.has_all, rng, attempts=_SHORTENING_ATTEMPTS) for q in found]
    return _describe_path(min(short, key=cost), room.margins, collision)


def one_turn_away(robot: RobotModel, q: Array, near: Array, *, room_rad: float = 0.5) -> Array:
    """(K, n), q (n,) and the configurations that differ from it by one whole turn of one joint, within the limits; nearest to `near` first.

    They are the same pose: a goal behind an obstacle may be free to reach the other way round. The turned ones keep `room_rad` from the
    limits, so that a rotation that starts there has its room.
    """
    turned = [q + sign * 2.0 * np.pi * unit for unit in np.eye(robot.n) for sign in (-1.0, 1.0)]
    low, high = robot.lower + room_rad, robot.upper - room_rad
    within = [row for row in turned if (row >= low).all() and (row <= high).all()]
    return np.stack((q, *sorted(within, key=lambda row: float(np.linalg.norm(row - near)))))


def dense(q: Array, step: float = _STEP_RAD) -> Array:
    """The polyline q with rows at most `step` rad apart; its own rows are kept."""
    rows = [q[:1]]
    for a, b in pairwise(q):
        count = max(1, int(np.ceil(np.linalg.norm(b - a) / step)))
        rows.append(a + (b - a) * np.linspace(0.0, 1.0, count + 1)[1:, None])
    return np.concatenate(rows)


def nearest_names(collision: CollisionModel, least: LeastMargin) -> str:
    """The nearest pair where the margin is least."""
    nearest = collision.nearest(least.q)
    return f"{nearest.first} - {nearest.second}"


def _describe_path(q: Array, margins: PairMargins, collision: CollisionModel) -> Path:
    least = least_margin(margins, q)
    rows = dense(q)
    length = float(np.linalg.norm(np.diff(rows, axis=0), axis=1).sum())
    return Path(rows, least.margin_m, nearest_names(collision, least), length)


def _possible_goals(goals: Array, robot: RobotModel, collision: CollisionModel, throws: ThrowCheck) -> list[Array]:
    """Those that the robot may be at; if there are none, the reason of the first is raised."""
    possible, reasons = [], []
    for q in goals:
        try:
            check_end(GOAL, q, robot, collision, throws)
            possible.append(q)
        except NoPath as reason:
            reasons.append(reason)
    if not possible:
        raise reasons[0]
    return possible


def check_end(end: Message, q: Array, robot: RobotModel, collision: CollisionModel, throws: ThrowCheck) -> None:
    """Whether a path may start or end at q (n,).

    Args:
        end: which end that is, `START` or `GOAL`.

    Raises:
        NoPath: no configuration of this robot, outside the joint limits, too close to something, or a load that comes off there falls into
            a zone.
    """
    if q.shape != (robot.n,) or not np.isfinite(q).all():
        raise NoPath("planning-end-no-configuration", end=end, q_rad=q.tolist(), count=robot.n)
    outside = np.flatnonzero((q < robot.lower) | (q > robot.upper))
    if len(outside):
        j = int(outside[0])
        raise NoPath(
            "planning-end-outside-limits",
            end=end, joint=robot.description.joints[j], angle_rad=q[j], lower_rad=robot.lower[j], upper_rad=robot.upper[j],
        )  # fmt: skip
    nearest = collision.nearest(q)
    if nearest.margin_m < 0.0:
        first, second = name_body(collision.cell, nearest.first), name_body(collision.cell, nearest.second)
        if nearest.distance_m < 0.0:
            raise NoPath("planning-end-inside", end=end, first=first, second=second, depth_m=-nearest.distance_m, in_the_way=nearest.second)
        raise NoPath(
            "planning-end-too-close",
            end=end, first=first, second=second, distance_m=nearest.distance_m, required_m=nearest.required_m, in_the_way=nearest.second,
        )  # fmt: skip
    check_drop(end, q, robot, collision, throws)


def check_drop(end: Message, q: Array, robot: RobotModel, collision: CollisionModel, throws: ThrowCheck) -> None:
    """Nothing where a load that comes off at rest at q (n,) falls into no zone.

    Args:
        end: of the path, `START` or `GOAL`.

    Raises:
        NoPath: it falls into one.
    """
    drop = throws.drop(collision.payload_box, robot.sensor_poses(q[None]))
    if drop is not None and drop.distance_m < 0.0:
        raise NoPath("planning-end-drops-load", end=end, depth_m=-drop.distance_m, zone=drop.zone, in_the_way=drop.zone)


def _find_paths(room: Room, collision: CollisionModel, ends: Array, planner: Planner, seed: int, iterations: int) -> list[Array]:
    """Paths (M, n) from the first row of `ends` to any other: the first that is found, and one more that may be shorter in time."""
    first = _search(room, ends, planner, seed, iterations)
    if not first.arrived:
        raise _not_found(collision, first, ends, planner, iterations)
    if planner == "rrt_star":
        return [first.q]
    second = _search(room, ends, planner, seed + 1, iterations)
    return [first.q, second.q] if second.arrived else [first.q]


@dataclass(frozen=True)
class _Found:
    """Vertices (M, n) of a path from the start, and whether it arrives at the goal."""

    q: Array
    arrived: bool


def _search(room: Room, ends: Array, planner: Planner, seed: int, iterations: int) -> _Found:
    """One search by OMPL. What is returned is a copy: OMPL's states die with it."""
    util.RNG.setSeed(seed + 1)  # 0 would mean a random seed
    n = ends.shape[1]
    space = base.RealVectorStateSpace(n)
    space.setBounds(_bounds(room, ends))
    setup = geometric.SimpleSetup(space)
    information = setup.getSpaceInformation()
    setup.setStateValidityChecker(lambda state: bool(room.has(np.array(state[0:n]))))  # numpy.bool_ would be a bad cast
    information.setMotionValidator(_Edges(information, room, n))
    setup.setStartState(_state(space, ends[0]))
    goals = base.GoalStates(information)
    for q in ends[1:]:
        goals.addState(_state(space, q))
    setup.setGoal(goals)
    search = {"rrt_connect": geometric.RRTConnect, "rrt_star": geometric.RRTstar}[planner](information)
    search.setRange(_RANGE_RAD)
    setup.setPlanner(search)
    setup.solve(base.PlannerTerminationCondition(_Countdown(iterations).is_over))
    if not setup.getProblemDefinition().hasSolution():
        return _Found(ends[:1], False)
    q = np.array([state[0:n] for state in setup.getSolutionPath().getStates()])
    return _Found(q, bool(setup.haveExactSolutionPath()))


def _state(space: base.RealVectorStateSpace, q: Array) -> base.State:
    state = space.allocState()
    for j, value in enumerate(q):
        state[j] = float(value)
    return state


class _Countdown:
    """Ends a search after so many iterations: OMPL asks once in each. Seconds would make the path depend on what else the machine does."""

    def __init__(self, iterations: int) -> None:
        self._left = iterations

    def is_over(self) -> bool:
        """Whether no iteration is left."""
        self._left -= 1
        return self._left < 0


class _Edges(base.MotionValidator):
    """OMPL's question whether the robot may move straight from one state to another."""

    def __init__(self, information: base.SpaceInformation, room: Room, n: int) -> None:
        super().__init__(information)
        self._room, self._n = room, n

    def checkMotion(self, first: base.State, second: base.State) -> bool:  # noqa: N802 - OMPL's name
        return bool(self._room.has_all(np.array([first[0 : self._n], second[0 : self._n]])))


def _bounds(room: Room, ends: Array) -> base.RealVectorBounds:
    """The box round both ends, half a turn wider on either side: a joint that can turn twice is not made to."""
    low = np.maximum(room.lower, ends.min(axis=0) - np.pi)
    high = np.minimum(room.upper, ends.max(axis=0) + np.pi)
    bounds = base.RealVectorBounds(ends.shape[1])
    for j in range(ends.shape[1]):
        bounds.setLow(j, float(low[j]))
        bounds.setHigh(j, float(high[j]))
    return bounds


def _not_found(collision: CollisionModel, best: _Found, ends: Array, planner: Planner, iterations: int) -> NoPath:
    tight = min((collision.nearest(q) for q in ends), key=lambda pair: pair.margin_m)
    left, whole = (float(np.linalg.norm(ends[1:] - q, axis=1).min()) for q in (best.q[-1], ends[0]))
    return NoPath(
        "planning-no-path",
        iterations=iterations,
        planner=planner,
        left_rad=left,
        whole_rad=whole,
        first=name_body(collision.cell, tight.first),
        second=name_body(collision.cell, tight.second),
        distance_m=tight.distance_m,
        required_m=tight.required_m,
        in_the_way=tight.second,
    )
