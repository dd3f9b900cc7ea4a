"""The double grid of Algorithm 6 over the workspace, and random postures to start the inverse kinematics from."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from core.array import Array
from core.robot.chain import forward_many
from core.robot.model import RobotModel

NEAR_SHARE = 0.3  # of the postures that are drawn round the configuration the robot comes from
NEAR_STD = 0.6  # rad
_METRES_PER_RADIAN = 0.5  # how far a wrong direction counts against a wrong position


@dataclass(frozen=True)
class Postures:
    """Random joint positions and the sensor frames that belong to them.

    Args:
        q: (M, n), rad.
        rotation, position: (M, 3, 3) and (M, 3), of the sensor in the world.
        axis: (3,), the sensor axis, with its sign, that is to lie along `gravity` (3,), both unit vectors.
    """

    q: Array
    rotation: Array
    position: Array
    axis: Array
    gravity: Array

    @cached_property
    def _tree(self) -> KDTree:
        return KDTree(np.hstack((self.position, _METRES_PER_RADIAN * self.rotation @ self.axis)))

    def nearest(self, vertices: Array, count: int) -> NDArray[np.intp]:
        """(V, count), the postures that put the sensor nearest to each vertex (V, 3) with the axis nearest to gravity."""
        wanted = np.hstack((vertices, np.broadcast_to(_METRES_PER_RADIAN * self.gravity, vertices.shape)))
        return np.asarray(self._tree.query(wanted, k=range(1, count + 1))[1])

    def can_reach(self, vertices: Array, distance: float) -> NDArray[np.bool_]:
        """(V,), whether any posture, whatever its orientation, comes within `distance` of a vertex (V, 3)."""
        return np.asarray(KDTree(self.position).query(vertices)[0] <= distance)

    def align_with_gravity(self, indices: NDArray[np.intp]) -> Array:
        """(N, 3, 3), the sensor orientations of postures turned the shortest way until the axis lies along gravity.

        The orientation about gravity is thereby as random as the postures.
        """
        rotation = self.rotation[indices]
        return np.asarray(shortest_turns(rotation @ self.axis, self.gravity) @ rotation)


def shortest_turns(directions: Array, onto: Array) -> Array:
    """(N, 3, 3), the smallest rotation that turns each unit vector (N, 3) onto another (3,)."""
    cosine = directions @ onto
    cross = np.cross(directions, onto)
    opposite = cosine < -1.0 + 1e-9
    K = np.zeros((len(directions), 3, 3))
    K[:, 0, 1], K[:, 0, 2], K[:, 1, 2] = -cross[:, 2], cross[:, 1], -cross[:, 0]
    K -= K.swapaxes(1, 2).copy()
    turns = np.eye(3) + K + K @ K / (1.0 + np.where(opposite, 1.0, cosine))[:, None, None]
    if opposite.any():
        side = np.linalg.svd(onto[None])[2][1]
        turns[opposite] = 2.0 * np.outer(side, side) - np.eye(3)
    return np.asarray(turns)


def draw_postures(
    robot: RobotModel,
    rng: np.random.Generator,
    count: int,
    *,
    limits: tuple[Array, Array],
    near: Array | None,
    axis: Array,
    gravity: Array,
) -> Postures:
    """Random postures within `limits`; a share of them near a configuration, so that short ways are among the candidates.

    Of a joint that can turn more than once, one turn round `near` (or round 0) is used.
    """
    lower, upper = limits
    centre = np.clip(np.zeros(robot.n) if near is None else near, lower, upper)
    low, high = np.maximum(lower, centre - np.pi), np.minimum(upper, centre + np.pi)
    wide = upper - lower > 2.0 * np.pi
    q = rng.uniform(np.where(wide, low, lower), np.where(wide, high, upper), (count, robot.n))
    if near is not None:
        k = int(NEAR_SHARE * count)
        q[:k] = np.clip(rng.normal(centre, NEAR_STD, (k, robot.n)), lower, upper)
    T = forward_many(robot.chain, q)
    return Postures(q, T[:, :3, :3], T[:, :3, 3], axis, gravity)


def first_grid(postures: Postures, count: int) -> tuple[Array, float]:
    """Vertices (V, 3) of a cubic grid over the reached part of the workspace, about `count` of them, and their spacing, m."""
    low, high = postures.position.min(axis=0), postures.position.max(axis=0)
    spacing = float((np.prod(high - low) / count) ** (1.0 / 3.0))
    for _ in range(2):  # the reached part is smaller than the box round it
        axes = [np.arange(a + 0.5 * spacing, b, spacing) for a, b in zip(low, high, strict=True)]
        vertices = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
        vertices = vertices[postures.can_reach(vertices, 0.6 * spacing)]
        spacing *= (max(len(vertices), 1) / count) ** (1.0 / 3.0)
    return vertices, spacing


def second_grid(centre: Array, spacing: float, per_side: int) -> Array:
    """Vertices (per_side^3, 3) of the smaller grid: it spans two spacings of the first one, centred in its best vertex."""
    steps = np.linspace(-spacing, spacing, per_side)
    return np.asarray(centre + np.stack(np.meshgrid(steps, steps, steps), axis=-1).reshape(-1, 3))
