"""Start configurations of the decoupling motions and of the motionless poses: Algorithm 6 with Eq. (6) of the paper.

A double grid over the workspace; at each vertex several configurations with the sensor axis along gravity, at a random angle about it.
Candidates are taken best first and have to pass every check: distances, room for the whole rotation within all limits, and no load that
comes off, at whatever moment, flies into a protected zone.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.cell.body_name import name_body
from core.cell.cell import Cell
from core.errors import NoStartConfiguration
from core.planning.candidate_checks import Accepted, Attitude, Checks
from core.planning.candidates import Candidates, CandidateSearch, Weights
from core.planning.effort import GRID_ROUNDS
from core.planning.grid import Postures, draw_postures, first_grid, second_grid
from core.planning.joint_torques import JointTorques
from core.planning.throw import Throw
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.trajectory import AngularProfile
from core.words.message import Message

TIGHT_ROOM_M = 0.002
"""What starts and rotations keep beyond every required distance where none keeps `ROOM_M`: more than the controller's way differs by."""

LIMIT_MARGIN_RAD = 0.05
"""Start configurations and rotations keep this far from the joint limits."""

UNREACHABLE = Message.of("planning-rejected-unreachable")


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
        rotation: that is made from there, once out and back; None where there is none.
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
    rotation: AngularProfile | None = None


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
    make_checks = partial(Checks, cell, robot, collision, attitude, limits, torques)
    checks = make_checks()
    search = CandidateSearch(cell, robot, collision, limits=limits, near=near, diameter=2.0 * float(collision.reach[0]), weights=weights)
    rounds: list[_Round] = []
    for k in range(grid.rounds):
        postures = draw_postures(robot, rng, grid.postures, limits=limits, near=near, axis=direction, gravity=down)
        vertices, spacing = first_grid(postures, grid.vertices * 2**k)
        rounds.append(_Round(postures, vertices, spacing, search.at(vertices, postures, grid.per_vertex)))
        found = _find_best(rounds[-1], search, checks, grid) or checks.check_smaller()
        if found is not None:
            break
    if found is None:
        tight = make_checks(TIGHT_ROOM_M)
        found = next((best for each in rounds if (best := _find_best(each, search, tight, grid))), None) or tight.check_smaller()
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
        rotation=accepted.rotation,
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
