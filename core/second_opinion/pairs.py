"""Which pairs of solids the second opinion measures, what each has to keep, and why."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from core.cell import Cell, Obstacle, Zone
from core.second_opinion.arm import PAYLOAD, Arm, Body, Frames, frame_of_pose
from core.second_opinion.solids import PlacedSolid, Solid, distance, place, solid_of_shape

Array = NDArray[np.float64]

CONTACT_M = 0.001
"""How deep solids of one wrist may go into each other: their shapes are simplified."""

ANGLES = 24
"""Of each of two joints, to tell whether solids with these joints between them can touch."""


class Kind(StrEnum):
    """What two solids are to each other."""

    ENVIRONMENT = "obstacles and zones"
    FIRST_LINK = "first link against obstacles and zones"
    """Its distance hardly changes, and would hide what the others do."""
    PAYLOAD = "payload against links"
    LINKS = "links against links"
    NEIGHBOURS = "neighbours in the arm"
    """Few joints between them, the payload among them: they may not go into each other."""
    WRIST = "links of one wrist"
    """Simplified shapes closer at home than links may be: told, not judged."""
    JOINED = "joined"
    """Not looked at: they share a joint, or none is between them."""

    @property
    def is_judged(self) -> bool:
        """Whether something is asked of its pairs."""
        return self not in (Kind.WRIST, Kind.JOINED)

    @property
    def resolution_m(self) -> float:
        """How far from the least distance its figure may be, m; the verdict is exact.

        Distances that hardly change cannot be told apart but by looking at every sample.
        """
        return 0.001 if self == Kind.FIRST_LINK or self.is_close else 0.0

    @property
    def is_close(self) -> bool:
        """Whether few joints are between its pairs, which move little against each other however far the arm moves."""
        return self in (Kind.NEIGHBOURS, Kind.WRIST)


@dataclass(frozen=True)
class Placed:
    """A solid with its placements (N,) in the world; what stands in the cell has a single one."""

    name: str
    joint: int
    solid: Solid
    frames: Frames

    def at(self, k: int) -> PlacedSolid:
        """Where it is at sample k."""
        if len(self.frames.position) == 1:
            k = 0
        return place(self.solid, self.frames.rotation[k], self.frames.position[k])


@dataclass(frozen=True)
class AccountedPair:
    """Two solids and what they have to keep.

    Args:
        first, second: names.
        required_m: least signed distance; 0, and only told against, where the kind is not judged.
        why: that is asked, or nothing, in words.
        bodies: their places in the list of the arm's bodies followed by what stands in the cell.
    """

    first: str
    second: str
    kind: Kind
    required_m: float
    why: str
    bodies: tuple[int, int]


def placed(arm: Arm, q: Array) -> list[Placed]:
    """The arm's bodies at joint positions q (N, n)."""
    frames = arm.frames(q)
    return [Placed(body.name, body.joint, body.solid, frames[body.joint].after(body.placement)) for body in arm.bodies]


def standing(cell: Cell) -> list[Placed]:
    """Obstacles and zones."""
    found = []
    for item in _things(cell):
        pose = frame_of_pose(item.shape.pose)
        found.append(Placed(item.name, 0, solid_of_shape(item.shape), Frames(pose.rotation[None], pose.position[None])))
    return found


def accounted_pairs(cell: Cell, arm: Arm) -> list[AccountedPair]:
    """All pairs of the moving bodies with what stands in the cell, and of the arm's bodies with each other."""
    things = [item.name for item in _things(cell)]
    found = []
    for i, body in enumerate(arm.bodies):
        kind = Kind.FIRST_LINK if body.joint == 1 else Kind.ENVIRONMENT
        for k, thing in enumerate(things):
            if body.joint > 0:
                bodies = i, len(arm.bodies) + k
                found.append(AccountedPair(body.name, thing, kind, cell.limits.clearance_m, "the cell's clearance", bodies))
    return [*found, *_own_pairs(cell, arm)]


def _things(cell: Cell) -> list[Obstacle | Zone]:
    return [*cell.obstacles, *cell.zones]


def _own_pairs(cell: Cell, arm: Arm) -> Iterator[AccountedPair]:
    """Of the arm with itself and the payload."""
    home = placed(arm, np.array([cell.robot.home_rad]))
    for i, first in enumerate(arm.bodies):
        for k, second in enumerate(arm.bodies):
            if first.joint > second.joint or (first.joint == second.joint and i > k):
                at_home = distance(home[i].at(0), home[k].at(0))
                yield AccountedPair(first.name, second.name, *_asked(cell, arm, (first, second), at_home), (i, k))


def _asked(cell: Cell, arm: Arm, pair: tuple[Body, Body], at_home: float) -> tuple[Kind, float, str]:
    """What two bodies of the arm are to each other, what they have to keep, and why."""
    first, second = pair
    between = first.joint - second.joint
    keep = cell.limits.self_clearance_m
    payload = PAYLOAD in (first.name, second.name)
    if between == 0:
        return Kind.JOINED, 0.0, "no joint between them: they do not move against each other"
    if between == 1 and not payload:
        return Kind.JOINED, 0.0, "they share a joint: their shapes meet there"
    if between > 2:
        return Kind.PAYLOAD if payload else Kind.LINKS, keep, "the cell's self-clearance"
    if at_home < (-CONTACT_M if payload else keep):
        return Kind.WRIST, 0.0, f"{1000 * at_home:.1f} mm apart at home already: simplified shapes of one wrist"
    if between == 2 and at_home >= keep and _can_touch(arm, pair, np.array(cell.robot.home_rad)):
        return Kind.PAYLOAD if payload else Kind.LINKS, keep, "the cell's self-clearance"
    return Kind.NEIGHBOURS, -CONTACT_M, f"few joints between them: not more than {1000 * CONTACT_M:.0f} mm into each other"


def _can_touch(arm: Arm, pair: tuple[Body, Body], home: Array) -> bool:
    """Whether two bodies with two joints between them come closer than `CONTACT_M` at some of a grid of their angles."""
    first, second = pair
    joints = [second.joint, second.joint + 1]
    q = np.tile(home, (ANGLES * ANGLES, 1))
    low, high = arm.lower[joints], np.minimum(arm.upper[joints], arm.lower[joints] + 2.0 * np.pi)
    q[:, joints] = np.stack(np.meshgrid(*np.linspace(low, high, ANGLES).T), axis=-1).reshape(-1, 2)
    frames = arm.frames(q)
    a, b = (Placed(body.name, body.joint, body.solid, frames[body.joint].after(body.placement)) for body in (first, second))
    return any(distance(a.at(k), b.at(k)) < CONTACT_M for k in range(len(q)))
