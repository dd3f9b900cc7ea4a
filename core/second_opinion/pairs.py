"""Which pairs of solids the second opinion measures, what each has to keep, and why."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

import fcl
import numpy as np
from numpy.typing import NDArray

from core.cell import Cell
from core.second_opinion.arm import PAYLOAD, Arm, Body, Frames, frame_of_pose
from core.second_opinion.solids import Solid, distance, solid_of_shape

Array = NDArray[np.float64]

CONTACT_M = 0.001
"""How deep solids of one wrist may go into each other: their shapes are simplified."""

ANGLES = 32
"""Of each of two joints, to tell whether solids with these joints between them can touch."""


class Kind(StrEnum):
    """What two solids are to each other."""

    ENVIRONMENT = "obstacles and zones"
    PAYLOAD = "payload against links"
    LINKS = "links against links"
    NEIGHBOURS = "neighbours in the arm"
    """Few joints between them: they only may not go into each other."""


@dataclass(frozen=True)
class Placed:
    """A solid with its placements (N,) in the world; what stands in the cell has a single one."""

    name: str
    joint: int
    solid: Solid
    frames: Frames

    def at(self, k: int) -> Any:
        """Its core as python-fcl's object at sample k."""
        if len(self.frames.position) == 1:
            k = 0
        return fcl.CollisionObject(self.solid.core, fcl.Transform(self.frames.rotation[k], self.frames.position[k]))


@dataclass(frozen=True)
class AccountedPair:
    """Two solids, by their places among `Pairs.arm` and `Pairs.standing`, and what they have to keep.

    Args:
        first, second: names.
        required_m: least signed distance; None where nothing is asked.
        why: in words, where it is None or not one of the cell's clearances.
    """

    first: str
    second: str
    kind: Kind
    required_m: float | None
    why: str
    bodies: tuple[int, int]


def placed(arm: Arm, q: Array) -> list[Placed]:
    """The arm's bodies at joint positions q (N, n)."""
    frames = arm.frames(q)
    return [Placed(body.name, body.joint, body.solid, frames[body.joint].after(body.placement)) for body in arm.bodies]


def standing(cell: Cell) -> list[Placed]:
    """Obstacles and zones."""
    found = []
    for item in (*cell.obstacles, *cell.zones):
        pose = frame_of_pose(item.shape.pose)
        found.append(Placed(item.name, 0, solid_of_shape(item.shape), Frames(pose.rotation[None], pose.position[None])))
    return found


def accounted_pairs(cell: Cell, arm: Arm) -> list[AccountedPair]:
    """All pairs in which something moves, with what is asked of each.

    The second index of a pair with an obstacle or a zone counts on from the arm's bodies.
    """
    limits = cell.limits
    things = [item.name for item in (*cell.obstacles, *cell.zones)]
    found = [
        AccountedPair(body.name, thing, Kind.ENVIRONMENT, limits.clearance_m, "the cell's clearance", (i, len(arm.bodies) + k))
        for i, body in enumerate(arm.bodies)
        if body.joint > 0
        for k, thing in enumerate(things)
    ]
    return [*found, *_own_pairs(cell, arm)]


def _own_pairs(cell: Cell, arm: Arm) -> Iterator[AccountedPair]:
    """Of the arm with itself and the payload."""
    home = placed(arm, np.array([cell.robot.home_rad]))
    for i, first in enumerate(arm.bodies):
        for k, second in enumerate(arm.bodies):
            between = first.joint - second.joint
            if between < 0 or (between == 0 and i <= k):
                continue
            kind = Kind.PAYLOAD if PAYLOAD in (first.name, second.name) and between > 1 else Kind.LINKS if between > 1 else Kind.NEIGHBOURS
            at_home = distance(first.solid, home[i].at(0), second.solid, home[k].at(0))
            required, why = _required(cell, arm, (first, second), at_home)
            if between > 1 and required != cell.limits.self_clearance_m:
                kind = Kind.NEIGHBOURS
            yield AccountedPair(first.name, second.name, kind, required, why, (i, k))


def _required(cell: Cell, arm: Arm, pair: tuple[Body, Body], at_home: float) -> tuple[float | None, str]:
    """What two bodies of the arm have to keep, and why."""
    first, second = pair
    between = first.joint - second.joint
    if between == 0:
        return None, "no joint between them: they do not move against each other"
    if between == 1 and PAYLOAD not in (first.name, second.name):
        return None, "links that share a joint: their shapes meet there"
    if between > 2:
        return cell.limits.self_clearance_m, "the cell's self-clearance"
    if at_home < -CONTACT_M:
        return None, f"{1000 * -at_home:.1f} mm into each other at home already: simplified shapes of one wrist"
    if between == 2 and at_home >= cell.limits.self_clearance_m and _can_touch(arm, pair, np.array(cell.robot.home_rad)):
        return cell.limits.self_clearance_m, "the cell's self-clearance"
    return -CONTACT_M, "few joints between them: the planner leaves them out, here they may not go into each other"


def _can_touch(arm: Arm, pair: tuple[Body, Body], home: Array) -> bool:
    """Whether two bodies with two joints between them come closer than `CONTACT_M` at some of a grid of their angles."""
    first, second = pair
    joints = [second.joint, second.joint + 1]
    q = np.tile(home, (ANGLES * ANGLES, 1))
    low, high = arm.lower[joints], np.minimum(arm.upper[joints], arm.lower[joints] + 2.0 * np.pi)
    q[:, joints] = np.stack(np.meshgrid(*np.linspace(low, high, ANGLES).T), axis=-1).reshape(-1, 2)
    frames = arm.frames(q)
    a, b = (Placed(body.name, body.joint, body.solid, frames[body.joint].after(body.placement)) for body in (first, second))
    return any(distance(a.solid, a.at(k), b.solid, b.at(k)) < CONTACT_M for k in range(len(q)))
