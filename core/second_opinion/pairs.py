"""Which pairs of solids the second opinion measures, what each has to keep, and why."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.second_opinion.arm import ArmBody, Frames, SolidArm, frame_of_pose
from core.second_opinion.solids import PlacedSolid, Solid, box, distance, hull_distance, place, solids_of_standing
from core.words.message import Message

FLOOR = "floor"

CONTACT_M = 0.001
"""How deep solids that are near by construction may go into each other: their shapes are simplified."""

MOUNT_M = 0.002
"""Between the base and what it is mounted on, at most."""

ANGLES = 24
"""Of each of two joints, to tell how near and how far solids with these joints between them can be."""

OVERLAP = Message.of("opinion-pair-overlapping")
"""Why nothing is asked of links with few joints between them."""

FEW_JOINTS = 2
"""Between two solids whose whole relative motion can be looked at."""

BELOW_M = 1.0
ACROSS_M = 40.0
"""Of the block that stands for the floor: farther than any arm reaches."""


class PairKind(StrEnum):
    """What two solids are to each other."""

    ENVIRONMENT = "obstacles, zones and floor"
    FIRST_LINK = "first link against obstacles, zones and floor"
    """Its distance hardly changes, and would hide what the others do."""
    MOUNT = "first links against what the robot is mounted on"
    """Always nearer than the clearance: they may not go into it."""
    PAYLOAD = "payload against links"
    LINKS = "links against links"
    NEAR = "near each other by construction"
    """Never as far apart as links must be, or never in touch: they may not go into each other."""
    JOINED = "left out"
    """Not looked at: they belong together."""

    @property
    def is_judged(self) -> bool:
        """Whether something is asked of its pairs."""
        return self != PairKind.JOINED

    @property
    def is_close(self) -> bool:
        """Whether few joints are between its pairs, which move little against each other however far the arm moves."""
        return self == PairKind.NEAR

    @property
    def in_words(self) -> Message:
        """It for people."""
        return _IN_WORDS[self]


_IN_WORDS = {
    PairKind.ENVIRONMENT: Message.of("opinion-kind-environment"),
    PairKind.FIRST_LINK: Message.of("opinion-kind-first-link"),
    PairKind.MOUNT: Message.of("opinion-kind-mount"),
    PairKind.PAYLOAD: Message.of("opinion-kind-payload"),
    PairKind.LINKS: Message.of("opinion-kind-links"),
    PairKind.NEAR: Message.of("opinion-kind-near"),
    PairKind.JOINED: Message.of("opinion-kind-joined"),
}


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
        required_m: least signed distance; 0 where the kind is not judged.
        why: that is asked, or nothing.
        bodies: their places in the list of the arm's bodies followed by what stands in the cell.
        joints: between them.
    """

    first: str
    second: str
    kind: PairKind
    required_m: float
    why: Message
    bodies: tuple[int, int]
    joints: int

    @property
    def resolution_m(self) -> float:
        """How far from the least distance its figure may be, m; the verdict is exact.

        With few joints between two solids their distance may hardly change however far they move, and samples of it cannot be told apart
        but by looking at every one.
        """
        return 0.001 if self.joints <= FEW_JOINTS else 0.0


def place_bodies(arm: SolidArm, q: Array) -> list[Placed]:
    """The arm's bodies at joint positions q (N, n)."""
    frames = arm.frames(q)
    return [Placed(body.name, body.joint, body.solid, frames[body.joint].after(body.placement)) for body in arm.bodies]


def place_standing(cell: Cell) -> list[Placed]:
    """Obstacles, zones and, last, the floor."""
    found = []
    for item, solid in zip(cell.standing, solids_of_standing(cell), strict=True):
        pose = frame_of_pose(item.shape.pose)
        found.append(Placed(item.name, 0, solid, Frames(pose.rotation[None], pose.position[None])))
    x, y, _ = cell.robot.base.xyz_m
    middle = np.array([[x, y, cell.floor_z_m - 0.5 * BELOW_M]])
    found.append(Placed(FLOOR, 0, box(np.array([ACROSS_M, ACROSS_M, BELOW_M])), Frames(np.eye(3)[None], middle)))
    return found


def classify_pairs(cell: Cell, arm: SolidArm) -> list[AccountedPair]:
    """All pairs of the moving bodies with what stands in the cell, and of the arm's bodies with each other."""
    things = place_standing(cell)
    zones = range(len(cell.obstacles), len(cell.obstacles) + len(cell.zones))
    mounts = [k not in zones and _is_mount(arm, thing) for k, thing in enumerate(things)]
    found = []
    for i, body in enumerate(arm.bodies):
        for k, thing in enumerate(things):
            if body.joint > 0:
                asked = _classify_against_standing(cell, arm, body, thing, is_mount=mounts[k])
                found.append(AccountedPair(body.name, thing.name, *asked, (i, len(arm.bodies) + k), body.joint))
    return [*found, *_own_pairs(cell, arm)]


def _is_mount(arm: SolidArm, thing: Placed) -> bool:
    """Whether the base is there where a thing is."""
    at = place(thing.solid, thing.frames.rotation[0], thing.frames.position[0])
    bases = [place(body.solid, body.placement.rotation, body.placement.position) for body in arm.bodies if body.joint == 0]
    return any(distance(base, at) <= MOUNT_M for base in bases)


Asked = tuple[PairKind, float, Message]
"""What two solids are to each other, what they have to keep, and why."""


def _classify_against_standing(cell: Cell, arm: SolidArm, body: ArmBody, thing: Placed, *, is_mount: bool) -> Asked:
    clearance = cell.limits.clearance_m
    if is_mount and body.joint <= FEW_JOINTS and not body.carried and _Reach(arm, (body, thing)).is_always_below(clearance + CONTACT_M):
        return PairKind.MOUNT, -CONTACT_M, Message.of("opinion-pair-mounted-there")
    return PairKind.FIRST_LINK if body.joint == 1 else PairKind.ENVIRONMENT, clearance, Message.of("opinion-pair-clearance")


def _own_pairs(cell: Cell, arm: SolidArm) -> Iterator[AccountedPair]:
    """Of the arm with itself and the payload."""
    for i, first in enumerate(arm.bodies):
        for k, second in enumerate(arm.bodies):
            if (first.joint, i) > (second.joint, k):
                yield AccountedPair(
                    first.name, second.name, *_classify_own_pair(cell, arm, (first, second)), (i, k), first.joint - second.joint
                )


def _classify_own_pair(cell: Cell, arm: SolidArm, pair: tuple[ArmBody, ArmBody]) -> Asked:
    first, second = pair
    names = {first.name, second.name}
    keep = PairKind.PAYLOAD if first.carried else PairKind.LINKS, cell.limits.self_clearance_m, Message.of("opinion-pair-self-clearance")
    joined = _why_joined(cell, arm, pair, names)
    if joined is not None:
        return PairKind.JOINED, 0.0, joined
    if first.joint - second.joint > FEW_JOINTS:
        return keep
    reach = _Reach(arm, pair)
    if reach.is_never_below(CONTACT_M):
        return PairKind.NEAR, -CONTACT_M, Message.of("opinion-pair-cannot-touch")
    if first.carried or not reach.is_always_below(keep[1] + CONTACT_M):
        return keep
    if reach.is_always_below(CONTACT_M):
        return PairKind.JOINED, 0.0, OVERLAP
    return PairKind.NEAR, -CONTACT_M, Message.of("opinion-pair-always-near")


def _why_joined(cell: Cell, arm: SolidArm, pair: tuple[ArmBody, ArmBody], names: set[str]) -> Message | None:
    """Why two bodies of the arm belong together; None where they do not."""
    first, second = pair
    if first.joint == second.joint:
        return Message.of("opinion-pair-no-joint-between")
    if not first.carried and names in map(set, cell.robot.adjacent):
        return Message.of("opinion-pair-declared")
    if not first.carried and names in map(set, arm.joined):
        return Message.of("opinion-pair-neighbours")
    return None


class _Reach:
    """How near and how far two bodies can be, over a grid of the one or two joints between them.

    Surfaces are looked at only where their hulls, which are never farther apart, leave a question open.
    """

    def __init__(self, arm: SolidArm, pair: tuple[ArmBody, ArmBody | Placed]) -> None:
        first, second = pair
        joints = list(range(second.joint, first.joint))
        low, high = arm.lower[joints], np.minimum(arm.upper[joints], arm.lower[joints] + 2.0 * np.pi)
        angles = np.stack(np.meshgrid(*np.linspace(low, high, ANGLES).T), axis=-1).reshape(-1, len(joints))
        q = np.zeros((len(angles), len(arm.axes)))
        q[:, joints] = angles
        frames = arm.frames(q)
        a, b = (
            body if isinstance(body, Placed) else Placed(body.name, body.joint, body.solid, frames[body.joint].after(body.placement))
            for body in pair
        )
        placed = [(a.at(k), b.at(k)) for k in range(len(q))]
        hulls = [hull_distance(*each) for each in placed]
        self._nearest_first = [(hulls[k], *placed[k]) for k in np.argsort(hulls)]

    def is_never_below(self, bound: float) -> bool:
        """Whether they are everywhere at least `bound` apart, m."""
        return all(least >= bound or distance(a, b) >= bound for least, a, b in self._nearest_first)

    def is_always_below(self, bound: float) -> bool:
        """Whether they are nowhere as far as `bound` apart, m."""
        return all(least < bound and distance(a, b) < bound for least, a, b in reversed(self._nearest_first))
