"""Margins of all pairs of bodies at once, and how fast each can change.

The margin of a pair depends only on the joints between its two bodies: a wrist that is always close to its own forearm says nothing about a
turning base. Certifying pair by pair therefore needs far fewer samples than certifying the smallest margin alone.
"""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.robot.bodies import Body
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel


class PairMargins:
    """The pairs that a collision model watches now, those against obstacles and zones first; to be made anew after `CollisionModel.move`.

    Attributes:
        reach: (n_pairs, n); the margin of pair k changes by at most `reach[k] @ |dq|` along a straight joint-space line.
        share: (n_pairs,), how much of the room beyond its required distance can be asked of each pair.
    """

    def __init__(self, collision: CollisionModel) -> None:
        self._collision, self._watched = collision, collision.watched
        self.share = collision.share
        pairs = [_by_joint(pair) for both in collision.pairs for pair in both]
        between = {(id(outer), inner.joint): (outer, inner.joint) for outer, inner in pairs}  # obstacles and the base share theirs
        reach = {key: _reach(collision.robot, *ends) for key, ends in between.items()}
        self.reach = np.array([reach[id(outer), inner.joint] for outer, inner in pairs]).reshape(-1, collision.robot.n)

    def __call__(self, q: Array) -> Array:
        """(n_pairs,), distance minus required distance of every pair at q (n,), m."""
        return np.asarray(self._collision.margins(q)[self._watched])


def _by_joint(pair: tuple[Body, Body]) -> tuple[Body, Body]:
    """The body farther out first."""
    first, second = pair
    return (first, second) if first.joint > second.joint else (second, first)


def _reach(robot: RobotModel, outer: Body, inner_joint: int) -> Array:
    """(n,), largest distance from each axis between the outer body and a joint below it that a point of that body can have."""
    placements, axes = robot.chain.placements, robot.chain.axes
    reach = np.zeros(robot.n)
    length = 0.0
    for j in reversed(range(inner_joint, outer.joint)):
        if j == outer.joint - 1:
            reach[j] = np.linalg.norm(np.cross(axes[j], outer.corners), axis=1).max()
            length = float(np.linalg.norm(outer.corners, axis=1).max())
        else:
            following = placements[j + 1, :3, 3]
            reach[j] = np.linalg.norm(np.cross(axes[j], following)) + length
            length += float(np.linalg.norm(following))
    return reach
