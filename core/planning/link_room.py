"""The vector D of Eq. (6): the room of each link and of the payload, normalised so that no link hides what the others have.

As printed, every distance is divided by the diameter of the workspace. A link near the base then often has the least, whatever the pose: an
upper arm 0.1 m above its table stays there, and the objective is flat in all that a pose can change, first of all in the room of the
payload, which Section 3 wants to be large. Here each link's distance is seen against the most room that this link has anywhere.
"""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel

SAMPLES = 300
"""Random configurations that tell the most room of a link: the largest of so many is near enough to the largest of all."""


class LinkRoom:
    """Distances of the links and of the payload to obstacles and zones; to be made anew after `CollisionModel.move`.

    Args:
        limits: lower and upper joint limits (n,), rad.
        diameter: of the workspace, m.

    Attributes:
        names: of the L links that are watched, the payload among them.
        most: (L,), the most room that each has over random configurations, at least the clearance, m.
        scale: (L,), what distances are divided by, m.
    """

    def __init__(self, robot: RobotModel, collision: CollisionModel, limits: tuple[Array, Array], diameter: float) -> None:
        self._collision = collision
        self._required = collision.cell.limits.clearance_m
        pairs = collision.pairs[0]
        self.names = list(dict.fromkeys(body.name for body, _ in pairs))
        self._pairs_of = [[k for k, (body, _) in enumerate(pairs) if body.name == name] for name in self.names]
        drawn = np.random.default_rng(0).uniform(*limits, (SAMPLES, robot.n))
        self.most = self.distances(drawn).max(axis=0, initial=self._required)
        self.scale = diameter * self.most / self.most.max(initial=self._required)

    def distances(self, q: Array) -> Array:
        """(N, L), smallest distance of each link to any obstacle, zone or the floor at q (N, n), m.

        That of links near what the robot is mounted on is counted larger (`CollisionModel.obstacle_rooms`).
        """
        if not (len(q) and self.names):
            return np.zeros((len(q), len(self.names)))
        rooms = np.array([self._collision.obstacle_rooms(row) for row in q])
        return np.stack([rooms[:, own].min(axis=1) for own in self._pairs_of], axis=1) + self._required

    def normalise(self, distances: Array) -> Array:
        """(N, L), D of Eq. (6) for distances (N, L).

        The link that can have the most room is measured by the diameter of the workspace, as printed; each other one by as much less as
        it can have less.
        """
        return np.asarray(np.minimum(distances / self.scale, 1.0))
