"""A home configuration that is free: away from itself, the floor and the limits of its joints, the arm bent, the payload clear."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from core.array import Array
from core.cell.cell import Limits
from core.errors import BadRobot
from core.robot.bodies import FLOOR, PAYLOAD, Body, floor_body
from core.robot.model import RobotModel
from core.robot.watched_pairs import CONTACT_M, FEW_JOINTS
from core.words.message import Message

Pair = tuple[str, str]

SAMPLES = 512
STEPS = (0.4, 0.2, 0.1)  # rad, of the search round the best sample
CENTRAL = 0.85  # share of each joint's range that is sampled
LIMITS = Limits()
GOOD_M = {"self": 0.08, FLOOR: 0.25, PAYLOAD: 0.12}  # distances beyond which more is worth no more
GOOD_LIMIT = 0.25  # of half a joint's range
ROUND = 2  # decimal places of an angle


@dataclass(frozen=True)
class Home:
    """A home configuration and what was found on the way.

    Args:
        q: (n,), rad.
        nearest: names of the nearest two bodies there. nearest_m: their distance.
        always_overlapping: pairs of links that overlap wherever they were looked at, or are too close with many joints between.
    """

    q: Array
    nearest: Pair
    nearest_m: float
    always_overlapping: tuple[Pair, ...]


class HomeSearch:
    """Distances in 512 configurations, evenly spread and the same every time; of the best of them, and what is round it, `home`.

    Args:
        bodies: of the links. payload: its box.
        floor_z: in the world, m.
        joined: pairs of links that one joint joins; they may touch.
        left_out: pairs of links that count for nothing, by a person's word.
        tool: links behind the sensor, which like the payload must not touch any other.
    """

    def __init__(
        self,
        robot: RobotModel,
        bodies: list[Body],
        payload: Body,
        floor_z: float,
        joined: set[frozenset[str]],
        left_out: set[frozenset[str]],
        tool: tuple[str, ...] = (),
    ) -> None:
        self._robot, self._left_out = robot, left_out
        self._carried = {PAYLOAD, *tool}
        self._scene = _Scene(robot, bodies, payload, floor_z, joined)
        self._low, self._high = _ranges(robot)
        self._samples = self._low + (self._high - self._low) * _evenly(SAMPLES, robot.n)
        ends = [0, -1]  # they turn all or the payload alone, and change little that counts
        self._samples[:, ends] = np.clip(0.0, self._low, self._high)[ends]
        self._distances = np.array([self._scene.distances(q) for q in self._samples])

    @property
    def share_above_floor(self) -> float:
        """Of the configurations, those in which the floor is clear of all that more than two joints move."""
        scene = self._scene
        above = [k for k, pair in enumerate(scene.names) if FLOOR in pair and scene.between[k] > FEW_JOINTS]
        return float((self._distances[:, above] >= LIMITS.clearance_m).all(axis=1).mean())

    def home(self, where: str, given: Array | None = None) -> Home:
        """The best home, or the one that was given, whatever it is like.

        Raises:
            BadRobot: no configuration is free.
        """
        scene, distances = self._scene, self._distances
        most = distances.max(axis=0)
        links = np.array([not self._carried & set(pair) for pair in scene.names])
        excused = links & (scene.between <= FEW_JOINTS)
        required = np.where(excused & (most < scene.required), CONTACT_M, scene.required)
        overlapping = links & (most < np.where(excused, CONTACT_M, scene.required))
        overlapping &= np.array([FLOOR not in pair for pair in scene.names]) | excused
        enough = np.maximum(np.minimum(scene.good, 0.7 * (most - required)), CONTACT_M)
        ignored = overlapping | (links & np.array([frozenset(pair) in self._left_out for pair in scene.names]))
        scene.judge(~ignored, required, enough, _bend_of(self._robot, self._samples))
        scores = np.array([scene.score(q, found) for q, found in zip(self._samples, distances, strict=True)])
        if scores.max() <= 0.0 and given is None:
            in_the_way = int(np.argmax(((distances < required) & ~ignored).sum(axis=0)))
            first, second = scene.names[in_the_way]
            raise BadRobot(Message.of("newcell-home", file=where), "newcell-no-home", count=SAMPLES, first=first, second=second)
        best = np.round(self._samples[int(np.argmax(scores))], ROUND)
        q = _refine(scene, best, self._low, self._high) if given is None else given
        found = np.where(ignored, np.inf, scene.distances(q))
        k = int(np.argmin(found))
        always = [pair for pair, is_so in zip(scene.names, overlapping, strict=True) if is_so and FLOOR not in pair]
        return Home(q, scene.names[k], float(found[k]), tuple(dict.fromkeys(always)))


def _evenly(count: int, dimensions: int) -> Array:
    """(count, dimensions), points spread evenly over the unit cube: multiples of powers of 1/g, less their whole parts.

    g is the root of g^(dimensions + 1) = g + 1 (M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018).
    """
    g = 2.0
    for _ in range(50):
        g = (1.0 + g) ** (1.0 / (dimensions + 1))
    steps = g ** -np.arange(1.0, dimensions + 1)
    return np.asarray((0.5 + np.arange(1, count + 1)[:, None] * steps) % 1.0)


def _ranges(robot: RobotModel) -> tuple[Array, Array]:
    """The central part of each joint's range, at most half a turn to both sides of 0 where 0 lies in it."""
    middle, half = 0.5 * (robot.lower + robot.upper), 0.5 * (robot.upper - robot.lower)
    wide = half > np.pi
    middle, half = np.where(wide, np.clip(0.0, middle - half + np.pi, middle + half - np.pi), middle), np.where(wide, np.pi, half)
    return middle - CENTRAL * half, middle + CENTRAL * half


def _refine(scene: _Scene, q: Array, low: Array, high: Array) -> Array:
    """Climbs from q, one joint at a time."""
    best = scene.score(q)
    for step in STEPS:
        for j in range(1, len(q) - 1):
            for change in (step, -step):
                tried = q.copy()
                tried[j] = round(float(np.clip(q[j] + change, low[j], high[j])), ROUND)
                score = scene.score(tried)
                if score > best:
                    q, best = tried, score
    return q


class _Scene:
    """Bodies of which the distances are looked at, and how good a configuration is."""

    def __init__(self, robot: RobotModel, bodies: list[Body], payload: Body, floor_z: float, joined: set[frozenset[str]]) -> None:
        self._robot = robot
        self._data = robot.model.createData()
        floor = floor_body(floor_z)
        moving = [body for body in (*bodies, payload) if body.joint > 0]
        pairs = [(body, floor) for body in moving if body.joint > 1]
        pairs += [
            (a, b)
            for a in (*bodies, payload)
            for b in bodies
            if a.joint > b.joint and not (a.joint - b.joint == 1 and frozenset((a.name, b.name)) in joined)
        ]
        self.between = np.array([a.joint - b.joint for a, b in pairs])
        """(n_pairs,), joints between two bodies."""
        self.names: list[Pair] = [(a.name, b.name) for a, b in pairs]
        kinds = [PAYLOAD if PAYLOAD in pair and FLOOR not in pair else FLOOR if FLOOR in pair else "self" for pair in self.names]
        self.good = np.array([GOOD_M[kind] for kind in kinds])
        self.required = np.array([LIMITS.clearance_m if FLOOR in pair else LIMITS.self_clearance_m for pair in self.names])
        self._geometry = pin.GeometryModel()
        ids: dict[int, int] = {}
        for pair in pairs:
            self._geometry.addCollisionPair(pin.CollisionPair(*[self._add(body, ids) for body in pair]))
        self._results = self._geometry.createData()
        self._counted = np.ones(len(pairs), dtype=bool)
        self._least = self.required
        self._enough = self.good
        self._bend = 1.0

    def _add(self, body: Body, ids: dict[int, int]) -> int:
        if id(body) not in ids:
            shape: Any = pin.GeometryObject(f"{len(ids)} {body.name}", body.joint, body.placement, body.geometry)
            ids[id(body)] = self._geometry.addGeometryObject(shape)
        return ids[id(body)]

    def distances(self, q: Array) -> Array:
        """(n_pairs,), signed, m."""
        pin.computeDistances(self._robot.model, self._data, self._geometry, self._results, q)
        return np.array([result.min_distance for result in self._results.distanceResults])

    def judge(self, counted: NDArray[np.bool_], required: Array, enough: Array, bend: float) -> None:
        """From here on: which pairs count, what each has to keep, how much more is enough, and what Jacobian is a good one's."""
        self._counted, self._least, self._enough, self._bend = counted, required, enough, bend

    def score(self, q: Array, distances: Array | None = None) -> float:
        """0 and less where it is not free; else the worst of room, limits and bend against what is good, and a tenth of their mean."""
        found = self.distances(q) if distances is None else distances
        margins = (found - self._least)[self._counted]
        if margins.min() <= 0.0:
            return float(margins.min())
        room = float(np.min(margins / self._enough[self._counted]))
        robot = self._robot
        limits = float(np.min(np.minimum(q - robot.lower, robot.upper - q) / np.minimum(0.5 * (robot.upper - robot.lower), np.pi)))
        terms = np.minimum([room, limits / GOOD_LIMIT, _bend(robot, q) / self._bend], 1.0)
        return float(terms.min() + 0.1 * terms.mean())


def _bend(robot: RobotModel, q: Array) -> float:
    """Smallest singular value of the sensor's Jacobian, metres as radians at 0.5 m: 0 where the arm is stretched."""
    J = robot.sensor_jacobian(q).copy()
    J[:3] /= 0.5
    return float(np.linalg.svd(J, compute_uv=False)[-1])


def _bend_of(robot: RobotModel, samples: Array) -> float:
    """What nine of ten configurations do not reach."""
    return max(float(np.quantile([_bend(robot, q) for q in samples], 0.9)), 1e-9)
