"""Start configurations of the decoupling motions and of the motionless poses: Algorithm 6 with Eq. (6) of the paper.

A double grid over the workspace; at each vertex several configurations with the sensor axis along gravity, at a random angle about it.
Candidates are taken best first and have to pass every check: distances, room for the whole rotation within all limits, and no load that
comes off, at whatever moment, flies into a protected zone.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple, Self

import numpy as np

from core.array import Array
from core.cell.body_name import name_body
from core.cell.cell import Cell
from core.errors import NoStartConfiguration, TooHeavy
from core.planning.candidates import Candidates, CandidateSearch, Weights
from core.planning.certificate import is_clear
from core.planning.effort import GRID_ROUNDS
from core.planning.grid import Postures, draw_postures, first_grid, second_grid
from core.planning.joint_torques import HOLDING_SHARE, JointTorques
from core.planning.pair_margins import PairMargins
from core.planning.rotation_room import Obstruction, RotationCheck, Turn
from core.planning.throw import Throw, ThrowCheck, loads_of
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.trajectory import AngularProfile
from core.robot.watched_pairs import ROOM_M
from core.words.message import Message

TIGHT_ROOM_M = 0.002
"""What starts and rotations keep beyond every required distance where none keeps `ROOM_M`: more than the controller's way differs by."""

LIMIT_MARGIN_RAD = 0.05
"""Start configurations and rotations keep this far from the joint limits."""

UNREACHABLE = Message.of("planning-rejected-unreachable")
OBSTRUCTIONS = {
    Obstruction.JOINT_LIMIT: Message.of("planning-rejected-joint-limits"),
    Obstruction.JOINT_SPEED: Message.of("planning-rejected-joint-speed"),
    Obstruction.JOINT_ACCELERATION: Message.of("planning-rejected-joint-acceleration"),
    Obstruction.CARTESIAN_SPEED: Message.of("planning-rejected-cartesian-speed"),
}
"""What rejects a candidate, beside what `Checks` names with a body, a joint or a zone."""


@dataclass(frozen=True)
class Grid:
    """The size of the search.

    Args:
        vertices: N_v of the first grid, about.
        per_vertex: N_c.
        per_side: vertices per side of the second grid, which spans two spacings of the first.
        postures: random postures from which the inverse kinematics starts.
        rounds: how often the search is repeated with other postures, each time with twice the vertices, where nothing was found.
    """

    vertices: int = 500
    per_vertex: int = 10
    per_side: int = 5
    postures: int = 20_000
    rounds: int = GRID_ROUNDS


@dataclass(frozen=True)
class StartConfiguration:
    """Where a rotation starts, or where the robot holds still.

    Args:
        axis: sensor axis with its sign; "x+" lies along gravity, "x-" against it; "free" where none does.
        q: (n,), rad.
        objective: Eq. (6).
        clearance_m: to obstacles and zones at the start.
        least_clearance_m: the same over the whole rotation.
        nearest: name of the obstacle or zone that is nearest during the rotation.
        manipulability: smallest over largest singular value of the Jacobian at the start.
        throw: the flight of a released load that comes nearest to a protected zone; None when the cell has no zones.
        candidates: how many configurations were tried.
        about: sensor axis of the rotation; that of `axis` where empty.
    """

    axis: str
    q: Array
    objective: float
    clearance_m: float
    least_clearance_m: float
    nearest: str
    manipulability: float
    throw: Throw | None
    candidates: int
    about: str = ""


@dataclass(frozen=True)
class Accepted:
    """A candidate that passed every check."""

    row: int
    path: Array
    throw: Throw | None


class Checks:
    """Everything that a candidate has to pass, the cheap checks first; counts what was rejected, and why."""

    def __init__(
        self,
        cell: Cell,
        robot: RobotModel,
        collision: CollisionModel,
        axis: Array,
        rotation: AngularProfile | None,
        limits: tuple[Array, Array],
        torques: JointTorques | None = None,
        room_m: float = ROOM_M,
    ) -> None:
        self._torques, self._room_m = torques, room_m
        self._cell, self._robot, self._collision = cell, robot, collision
        self._margins = PairMargins(collision)
        self._throw = ThrowCheck(cell)
        self._loads = loads_of(collision.payload_box, axis, rotation)
        self._rotation = None
        if rotation is not None:
            self._rotation = RotationCheck(cell, robot, collision, Turn.of(rotation, axis), limits)
        self.rejected: Counter[Message] = Counter()
        self._with_room = 0
        self._thrown_into: Counter[str] = Counter()
        self._too_weak: list[tuple[float, str]] = []

    def check_candidate(self, candidates: Candidates, row: int) -> Accepted | None:
        """The candidate with its rotation, or None, which is counted."""
        outcome = self._check(candidates.q[row], candidates.clearance[row])
        if isinstance(outcome, Message):
            self.rejected[outcome] += 1
            return None
        return Accepted(row, *outcome)

    @property
    def thrown_into(self) -> str | None:
        """The zone that a load could fly into from most of the candidates that have room to stand."""
        return next((zone for zone, times in self._thrown_into.items() if 2 * times > self._with_room), None)

    def refuse_too_weak(self, axis: str) -> None:
        """Nothing unless holding the load is what keeps most of the candidates that have room to stand from being used.

        Raises:
            TooHeavy: it is.
        """
        if 2 * len(self._too_weak) > self._with_room:
            share, joint = min(self._too_weak)
            raise TooHeavy("planning-too-heavy-to-hold", axis=axis, joint=joint, share=share, most_share=HOLDING_SHARE)

    def _check(self, q: Array, clearance: float) -> tuple[Array, Throw | None] | Message:
        """The path of the rotation (K, n) and the worst throw, or the reason for the refusal."""
        if clearance < self._cell.limits.clearance_m + self._room_m:
            return Message.of("planning-rejected-obstacle", body=name_body(self._cell, self._collision.obstacle_distance(q).second))
        if self._collision.self_room(q) < self._room_m:
            first, second = self._tightest(q[None])
            return Message.of("planning-rejected-bodies", first=first, second=second)
        self._with_room += 1
        throw = self._throw_with_load(q)
        if isinstance(throw, Message):
            return throw
        path = q[None] if self._rotation is None else self._rotation(q)
        if isinstance(path, Obstruction):
            return OBSTRUCTIONS[path]
        if len(path) > 1 and not is_clear(self._margins, path, self._room_m):
            first, second = self._tightest(path)
            return Message.of("planning-rejected-rotation-bodies", first=first, second=second)
        return path, throw

    def _throw_with_load(self, q: Array) -> Throw | Message | None:
        """The worst throw from q (n,), or why the load may not be there."""
        weak = None if self._torques is None else self._torques.too_weak_to_hold(q)
        if weak is not None:
            joint, share = weak
            self._too_weak.append((share, joint))
            return Message.of("planning-rejected-joint-too-weak", joint=joint)
        pose = self._robot.sensor_pose(q)
        throw = self._throw.nearest(self._loads, pose.rotation, pose.position)
        if throw is not None and throw.distance_m < 0.0:
            self._thrown_into[throw.zone] += 1
            return Message.of("planning-rejected-throw", zone=throw.zone)
        return throw

    def _tightest(self, path: Array) -> tuple[Message, Message]:
        """The two bodies with the least margin on a path (K, n)."""
        nearest = min((self._collision.nearest(q) for q in path), key=lambda pair: pair.margin_m)
        return name_body(self._cell, nearest.first), name_body(self._cell, nearest.second)


@dataclass(frozen=True)
class Attitude:
    """What is sought: a direction of the sensor along gravity, and what is done there.

    Args:
        name: for messages.
        down: (3,), unit vector in the sensor frame that is to lie along gravity.
        about: (3,), unit vector in the sensor frame that `rotation` turns about, through the sensor origin.
        rotation: positive about the sensor's own axis; None for a pose that is only held.
    """

    name: str
    down: Array
    about: Array
    rotation: AngularProfile | None = None

    @classmethod
    def of_axis(cls, axis: str, rotation: AngularProfile | None = None) -> Self:
        """A sensor axis along ("x+") or against ("x-") gravity, and turned about."""
        unit = np.eye(3)["xyz".index(axis[0])]
        return cls(axis, unit if axis[1] == "+" else -unit, unit, rotation)


def find_start_configuration(
    cell: Cell,
    robot: RobotModel,
    collision: CollisionModel,
    attitude: Attitude,
    *,
    seed: int,
    near: Array | None = None,
    grid: Grid | None = None,
    weights: Weights | None = None,
    torques: JointTorques | None = None,
) -> StartConfiguration:
    """The best configuration with an attitude from which the whole rotation can be done safely.

    Args:
        seed: the same seed gives the same configuration.
        near: (n,), where the robot comes from: every second of the way there costs `weights.travel_per_s`.
        torques: with the load; a configuration that the joints cannot hold is none. None where they are not to be judged.

    Raises:
        NoStartConfiguration: there is none, with what rejected how many candidates.
        TooHeavy: there is none because the joints cannot hold the load.
    """
    grid, weights = grid or Grid(), weights or Weights()
    rng = np.random.default_rng(seed)
    axis, direction = attitude.name, attitude.down
    down = cell.gravity / np.linalg.norm(cell.gravity)
    limits = (robot.lower + LIMIT_MARGIN_RAD, robot.upper - LIMIT_MARGIN_RAD)
    make_checks = partial(Checks, cell, robot, collision, attitude.about, attitude.rotation, limits, torques)
    checks = make_checks()
    search = CandidateSearch(cell, robot, collision, limits=limits, near=near, diameter=2.0 * float(collision.reach[0]), weights=weights)
    rounds: list[_Round] = []
    for k in range(grid.rounds):
        postures = draw_postures(robot, rng, grid.postures, limits=limits, near=near, axis=direction, gravity=down)
        vertices, spacing = first_grid(postures, grid.vertices * 2**k)
        rounds.append(_Round(postures, vertices, spacing, search.at(vertices, postures, grid.per_vertex)))
        if (found := _find_best(rounds[-1], search, checks, grid)) is not None:
            break
    if found is None:
        tight = make_checks(TIGHT_ROOM_M)
        found = next((best for each in rounds if (best := _find_best(each, search, tight, grid)) is not None), None)
    if found is None:
        checks.refuse_too_weak(axis)
        raise _refusal(axis, [each.candidates for each in rounds], checks, collision)
    tried = sum(each.candidates.tried for each in rounds) + grid.per_side**3 * grid.per_vertex
    return _describe_start(axis, *found, collision, tried)


class _Round(NamedTuple):
    """The candidates of a first grid, and what they were made of."""

    postures: Postures
    vertices: Array
    spacing: float
    candidates: Candidates


def _find_best(made: _Round, search: CandidateSearch, checks: Checks, grid: Grid) -> tuple[Candidates, Accepted] | None:
    """The best candidate of a first grid that passes every check, or a better one of the second grid round it."""
    first = made.candidates
    best = _first_accepted(first, checks)
    if best is None:
        return None
    second = search.at(second_grid(made.vertices[first.vertex[best.row]], made.spacing, grid.per_side), made.postures, grid.per_vertex)
    better = _first_accepted(second, checks, above=float(first.score[best.row]))
    return (first, best) if better is None else (second, better)


def _first_accepted(candidates: Candidates, checks: Checks, above: float = -np.inf) -> Accepted | None:
    """The candidate with the best score above a value that passes every check."""
    return next((found for row in candidates.rank(above) if (found := checks.check_candidate(candidates, row))), None)


def _describe_start(axis: str, candidates: Candidates, accepted: Accepted, collision: CollisionModel, tried: int) -> StartConfiguration:
    row = accepted.row
    nearest = min((collision.obstacle_distance(q) for q in accepted.path), key=lambda pair: pair.distance_m)
    return StartConfiguration(
        axis=axis,
        q=candidates.q[row].copy(),
        objective=float(candidates.objective[row]),
        clearance_m=float(candidates.clearance[row]),
        least_clearance_m=min(nearest.distance_m, float(candidates.clearance[row])),
        nearest=nearest.second,
        manipulability=float(candidates.manipulability[row]),
        throw=accepted.throw,
        candidates=tried,
    )


def _refusal(axis: str, everything: list[Candidates], checks: Checks, collision: CollisionModel) -> NoStartConfiguration:
    """The error with its reasons; unreachable are those for which the inverse kinematics has no solution."""
    unreachable = sum(candidates.tried - len(candidates) for candidates in everything)
    reasons = {**checks.rejected, **({UNREACHABLE: unreachable} if unreachable else {})}
    reached = [candidates for candidates in everything if len(candidates)]
    if not reached:
        return NoStartConfiguration(axis, reasons)
    best = max(reached, key=lambda candidates: np.nanmax(candidates.clearance))
    nearest = collision.obstacle_distance(best.q[np.nanargmax(best.clearance)])
    in_the_way = checks.thrown_into or nearest.second
    return NoStartConfiguration(axis, reasons, nearest.distance_m, name_body(collision.cell, nearest.second), in_the_way)
