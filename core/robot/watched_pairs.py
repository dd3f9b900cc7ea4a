"""Which pairs of bodies have to keep a distance, how much, and why the others need not be looked at.

Every pair is accounted for. A pair is left out only where its two bodies cannot touch at any joint positions, where they belong together by
construction (no joint between them, one joint that joins them, or declared in the cell), or where their simplified shapes overlap whatever
the joints do. The payload and the tools are never excused: only a proof that they cannot touch a link leaves such a pair out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from enum import Enum
from typing import NamedTuple

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from core.array import Array
from core.cell.cell import Cell
from core.cell.urdf import Urdf, check_urdf
from core.robot.bodies import Body, corners_of, reach_of
from core.robot.model import RobotModel
from core.words.message import Message

CONTACT_M = 0.001
"""Bodies that provably stay this far apart cannot touch; bodies that are always close by construction have to keep it."""

FEW_JOINTS = 2
"""Between two bodies whose whole relative motion can be looked at."""

ANGLES = {1: 96, 2: 24}
"""Of each joint, by the number of joints between two bodies."""

_MOST_DIVISIONS = 20_000
"""Of the joints' ranges in a proof; a pair that needs more is watched."""

ROOM_M = 0.01
"""What planning asks for beyond the required distances, for stopping and for the controller's tracking error."""

Distance = Callable[[Array], float]
"""Of one pair at joint positions (n,), m."""


class Watch(Enum):
    """What a pair has to keep."""

    CLEARANCE = "the cell's clearance"
    TIGHT = "the cell's clearance, and hardly more: their construction never lets them be much farther apart"
    CONTACT = "not to touch: their construction never lets them be as far apart as the cell's clearance"
    NOTHING = "nothing"

    @property
    def share(self) -> float:
        """Of the room beyond the required distance that is asked of other pairs."""
        return 1.0 if self is Watch.CLEARANCE else 0.1


class Rule(NamedTuple):
    """What a pair has to keep, and why where that is nothing."""

    watch: Watch
    why: Message | None = None


class LeftOut(NamedTuple):
    """A pair that nobody watches: two names, and why."""

    first: str
    second: str
    why: Message


KEPT = Rule(Watch.CLEARANCE)
OVERLAPPING = Message.of("robot-pair-overlapping")


class OwnPairs:
    """The rules between bodies of one arm: its links, its base, the payload and the tools."""

    def __init__(self, cell: Cell, robot: RobotModel, bodies: list[Body]) -> None:
        self._cell, self._robot = cell, robot
        self._declared = {frozenset(pair) for pair in cell.robot.adjacent}
        self._joined = set(find_joined_links(check_urdf(cell.urdf, cell.robot.urdf), {body.name for body in bodies}))

    def rule(self, first: Body, second: Body, distance: Distance) -> Rule:
        """Of two bodies, the first carried by the farther joint."""
        names = frozenset((first.name, second.name))
        between = first.joint - second.joint
        if between == 0:
            return Rule(Watch.NOTHING, Message.of("robot-pair-no-joint-between"))
        if not first.carried and names in self._declared:
            return Rule(Watch.NOTHING, Message.of("robot-pair-declared"))
        if not first.carried and names in self._joined:
            return Rule(Watch.NOTHING, Message.of("robot-pair-neighbours"))
        return KEPT if between > FEW_JOINTS else self._rule_of_near((first, second), distance)

    def _rule_of_near(self, pair: tuple[Body, Body], distance: Distance) -> Rule:
        """Of two bodies that can be looked at in all their positions against each other."""
        least, most = _range(self._robot, pair, distance, np.inf)
        if least >= CONTACT_M and keeps(self._robot, pair, distance, CONTACT_M):
            return Rule(Watch.NOTHING, Message.of("robot-pair-cannot-touch"))
        if not pair[0].carried and most < CONTACT_M:
            return Rule(Watch.NOTHING, OVERLAPPING)
        if not pair[0].carried and most < self._cell.limits.self_clearance_m:
            return Rule(Watch.CONTACT)
        return KEPT if most >= self._cell.limits.self_clearance_m + 2.0 * ROOM_M else Rule(Watch.TIGHT)


def rule_of_standing(robot: RobotModel, pair: tuple[Body, Body], distance: Distance, clearance_m: float, *, is_mount: bool) -> Rule:
    """Of a moving body and what stands in the cell.

    What the robot is mounted on may be nearer to its first two links than the clearance where that is so whatever the joints do.
    """
    body = pair[0]
    if body.joint == 1 and keeps(robot, pair, distance, clearance_m):
        return Rule(Watch.NOTHING, Message.of("robot-pair-first-joint-only"))
    if not (is_mount and may_be_near(body)):
        return KEPT
    least, most = _range(robot, pair, distance, clearance_m + 2.0 * ROOM_M)
    if most >= clearance_m:
        return KEPT if most >= clearance_m + 2.0 * ROOM_M else Rule(Watch.TIGHT)
    if least >= CONTACT_M and keeps(robot, pair, distance, CONTACT_M):
        return Rule(Watch.NOTHING, Message.of("robot-pair-mounted-there"))
    return Rule(Watch.CONTACT)


def may_be_near(body: Body) -> bool:
    """Whether a moving body may be nearer to what the robot is mounted on than the clearance, where its construction leaves no choice."""
    return not body.carried and body.joint <= FEW_JOINTS


def keeps(robot: RobotModel, pair: tuple[Body, Body], distance: Distance, required_m: float) -> bool:
    """Whether two bodies keep a distance at all angles of the joints between them, proven by dividing their ranges.

    Within a box of angles no distance is smaller than the one at its centre minus the largest motion from there.
    """
    between = _between(pair)
    reach = reach_of(robot, corners_of([pair[0]]))[between]
    boxes = [_ranges(robot, between)]
    q = pin.neutral(robot.model)
    for _ in range(_MOST_DIVISIONS):
        if not boxes:
            return True
        low, high = boxes.pop()
        q[between] = middle = 0.5 * (low + high)
        least = distance(q) - required_m
        widths = (high - low) * reach
        if least < 0.0:
            return False
        if least < 0.5 * widths.sum():
            k = int(np.argmax(widths))
            for part in (np.array([low[k], middle[k]]), np.array([middle[k], high[k]])):
                ends = np.array([low, high])
                ends[:, k] = part
                boxes.append((ends[0], ends[1]))
    return False


def _range(robot: RobotModel, pair: tuple[Body, Body], distance: Distance, enough_m: float) -> tuple[float, float]:
    """Least and largest distance over a grid of the angles between two bodies; looks no further where one is `enough_m`."""
    between = _between(pair)
    low, high = _ranges(robot, between)
    grid = np.stack(np.meshgrid(*np.linspace(low, high, ANGLES[len(between)]).T), axis=-1).reshape(-1, len(between))
    q = pin.neutral(robot.model)
    least, most = np.inf, -np.inf
    for q[between] in grid:
        found = distance(q)
        least, most = min(least, found), max(most, found)
        if most >= enough_m:
            break
    return least, most


def _between(pair: tuple[Body, Body]) -> NDArray[np.int64]:
    """Indices of the joints that move the two bodies against each other."""
    return np.arange(pair[1].joint, pair[0].joint)


def _ranges(robot: RobotModel, joints: NDArray[np.int64]) -> tuple[Array, Array]:
    """Lowest and highest angle of each joint, one turn at most."""
    low = robot.lower[joints]
    return low, np.minimum(robot.upper[joints], low + 2.0 * np.pi)


def find_joined_links(urdf: Urdf, bodies: set[str]) -> Iterator[frozenset[str]]:
    """Pairs of links with a body and exactly one moving joint between them, and no other link with a body."""
    above = {joint.child: joint for joint in urdf.joints}
    for link in bodies & set(urdf.links):
        here, moving = link, 0
        while here in above and moving <= 1:
            joint = above[here]
            moving, here = moving + (joint.kind != "fixed"), joint.parent
            if here in bodies:
                if moving == 1:
                    yield frozenset((link, here))
                break
