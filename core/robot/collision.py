"""Distances of the robot and the payload box to obstacles, protected zones and themselves: Coal through Pinocchio.

Meshes count as the convex parts that contain them. Every pair has a required distance, see `core.robot.watched_pairs`. A *margin* is a
distance minus what is required; margins are signed, negative where a pair is too close.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import chain, product
from typing import Any

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from core.array import Array
from core.cell.body_name import name_body
from core.cell.cell import Box, Cell, Pose
from core.cell.contradictions import BASE_IN_OBSTACLE
from core.errors import BadCell, NoRoomAtHome
from core.payload.shapes import StandingShape
from core.robot.bodies import (
    FLOOR,
    PAYLOAD,
    Body,
    SpeedPoints,
    corners_of,
    floor_body,
    link_bodies,
    payload_body,
    reach_of,
    standing_bodies,
    tool_bodies,
)  # fmt: skip
from core.robot.model import RobotModel
from core.robot.pair_group import Nearest, PairGroup, measure_distance
from core.robot.watched_pairs import CONTACT_M, LeftOut, OwnPairs, Rule, Watch, may_be_near, rule_of_standing
from core.words.message import Message

MOUNT_M = 0.002
"""A base this near to something is mounted on it."""

__all__ = ["Body", "CollisionModel", "SpeedPoints"]


class CollisionModel:
    """Distances of one robot with one payload box in one cell.

    Pairs are the moving links, the payload box and the tools against all obstacles, zones and the floor, and against each other and the
    base. Which of them are watched, and what each has to keep, says `core.robot.watched_pairs`; the others are in `left_out`.

    Args:
        cell: obstacles, zones, floor and clearances.
        robot: the kinematics of the same cell.
        payload_box: in the sensor frame.

    Raises:
        BadCell: something stands where the robot's base is, or the home configuration is too close to something.
        BadRobot: a mesh, also an obstacle's, that cannot be used.
        NoRoomAtHome: the payload box is, which is another one than the cell's.
    """

    def __init__(self, cell: Cell, robot: RobotModel, payload_box: Box) -> None:
        self.cell = cell
        self.robot = robot
        self.payload_box = payload_box
        bodies = [*link_bodies(cell, robot), *tool_bodies(cell, robot), payload_body(robot, payload_box)]
        self._things = standing_bodies(cell)
        things = [*chain.from_iterable(self._things.values()), floor_body(cell.floor_z_m)]  # whose name may be an obstacle's as well
        self._zones = [part for zone in cell.zones for part in self._things[zone.name]]
        self._base = [body for body in bodies if body.joint == 0]
        self._moving = [body for body in bodies if body.joint > 0]
        self.points = corners_of(bodies)
        self.reach = reach_of(robot, self.points)
        """(n,), the largest distance from axis i of any point behind joint i over all configurations, m."""
        self._why: dict[tuple[str, str], Message] = {}
        self._placements: dict[int, Any] = {}  # of things that were moved
        standing = [(body, thing) for body in self._moving for thing in things]
        first_links = [pair for pair in standing if may_be_near(pair[0])]
        near = [pair for pair in first_links if not self._is_zone(pair[1])]
        asked = {Watch.CLEARANCE: cell.limits.clearance_m, Watch.TIGHT: cell.limits.clearance_m, Watch.CONTACT: CONTACT_M}
        self._standing = {
            watch: PairGroup(robot, required_m, standing if watch is Watch.CLEARANCE else near) for watch, required_m in asked.items()
        }
        self._clear = PairGroup(robot, 0.0, first_links)
        own, keep = self._own_pairs(bodies), cell.limits.self_clearance_m
        asked = {Watch.CLEARANCE: keep, Watch.TIGHT: keep, Watch.CONTACT: CONTACT_M}
        self._own = {watch: PairGroup(robot, required_m, own[watch]) for watch, required_m in asked.items()}
        for parts in (*self._things.values(), things[-1:]):
            self._watch_standing(parts, parts[0].placement)
        _check_base(cell, bodies, things)
        _check_home(cell, self)

    @property
    def pairs(self) -> tuple[list[tuple[Body, Body]], list[tuple[Body, Body]]]:
        """The pairs that are watched: those with obstacles, zones and the floor, and those within the arm."""
        standing, own = ([pair for group in groups.values() for pair in group.active] for groups in (self._standing, self._own))
        return standing, own

    @property
    def watched(self) -> NDArray[np.bool_]:
        """Which pairs are watched: `move` may change it."""
        return np.concatenate([group.watched for group in self._groups])

    @property
    def required_m(self) -> Array:
        """(n_pairs,), what each of `pairs` has to keep, m."""
        return np.concatenate([np.full(len(group.active), group.required_m) for group in self._groups])

    @property
    def share(self) -> Array:
        """(n_pairs,), how much of the room beyond the required distances can be asked of each of `pairs`."""
        groups = [(watch, group) for each in (self._standing, self._own) for watch, group in each.items()]
        return np.concatenate([np.full(len(group.active), watch.share) for watch, group in groups])

    @property
    def left_out(self) -> list[LeftOut]:
        """The pairs of links, payload, tools and things of which nothing is watched, and why."""
        watched = {(first.name, second.name) for pairs in self.pairs for first, second in pairs}
        return [LeftOut(*names, why) for names, why in self._why.items() if names not in watched and names[0] != names[1]]

    @property
    def _groups(self) -> list[PairGroup]:
        return [*self._standing.values(), *self._own.values()]

    def nearest(self, q: Array) -> Nearest:
        """The pair with the smallest margin at q (n,)."""
        return min((group.nearest(q) for group in self._groups), key=lambda pair: pair.margin_m)

    def margin(self, q: Array) -> float:
        """Smallest distance minus required distance over all pairs at q (n,), m; negative if q is not finite."""
        return min(group.margin(q) for group in self._groups)

    def margins(self, q: Array) -> Array:
        """Distance minus required distance at q (n,) of every pair, obstacles and zones first, m; infinite where it is not watched.

        `margins(q)[watched]` are those of `pairs`, in their order.
        """
        return np.concatenate([group.margins(q) for group in self._groups])

    def is_free(self, q: Array, extra_m: float = 0.0) -> bool:
        """Whether every margin at q (n,) exceeds `extra_m`; cheaper than `margin`."""
        return all(group.is_free(q, extra_m) for group in self._groups)

    def obstacle_distance(self, q: Array) -> Nearest:
        """The smallest distance to obstacles, protected zones and the floor at q (n,), without `left_out_distance`."""
        return min((group.nearest(q) for group in self._standing.values()), key=lambda pair: pair.distance_m)

    def find_nearest_left_out(self, q: Array) -> Nearest:
        """The smallest distance at q (n,) of the first links to what they cannot come too close to; infinite where there is none."""
        return self._clear.nearest(q)

    def obstacle_margin(self, q: Array) -> float:
        """Smallest margin to obstacles, zones and the floor at q (n,), m."""
        return min(group.margin(q) for group in self._standing.values())

    def self_margin(self, q: Array) -> float:
        """Smallest margin within the arm, payload included, at q (n,), m."""
        return min(group.margin(q) for group in self._own.values())

    def obstacle_room(self, q: Array) -> float:
        """`obstacle_margin`, those of pairs whose construction leaves them little room counted larger by as much."""
        return min(group.margin(q) / watch.share for watch, group in self._standing.items())

    def obstacle_rooms(self, q: Array) -> Array:
        """The same of every pair with an obstacle, a zone or the floor, in the order of `pairs`."""
        return np.concatenate([group.margins(q)[group.watched] / watch.share for watch, group in self._standing.items()])

    def self_room(self, q: Array) -> float:
        """`self_margin`, counted likewise."""
        return min(group.margin(q) / watch.share for watch, group in self._own.items())

    def room(self, q: Array) -> float:
        """`margin`, counted likewise: what is compared with the room that planning asks for beyond the required distances, m."""
        return min(self.obstacle_room(q), self.self_room(q))

    def motion_bound(self, q_a: Array, q_b: Array) -> float:
        """Upper bound of how far any point moves on the straight line between two configurations, m.

        The sum over the joints of |dq_i| times `reach` i. No margin changes by more than this between q_a and q_b, also
        none between two links.
        """
        return float(np.abs(np.subtract(q_b, q_a)) @ self.reach)

    def move(self, name: str, pose: Pose) -> None:
        """Moves an obstacle or a zone (a live position); world frame.

        Raises:
            BadCell: there is no obstacle or zone of that name.
        """
        if name not in self._things:
            raise BadCell(f"{self.cell.folder.name}/cell.toml", "robot-nothing-of-that-name", name=name, names=list(self._things))
        parts, placement = self._things[name], pin.SE3(pose.rotation, pose.translation)
        for part in parts:
            for group in (*self._standing.values(), self._clear):
                group.move(part, placement)
            self._placements[id(part)] = placement
        self._watch_standing(parts, placement)

    def placement_of(self, thing: Body) -> Any:
        """Where an obstacle, a zone or the floor is now, world frame."""
        return self._placements.get(id(thing), thing.placement)

    def change_zone(self, name: str, shape: StandingShape | None) -> None:
        """A zone is this now: another place, another size, a new one; None takes it away. World frame.

        Raises:
            BadCell: an obstacle has that name.
            BadRobot: a mesh that cannot be used.
        """
        known = next((zone.shape for zone in self.cell.zones if zone.name == name), None)
        if known is None and name in self._things:
            raise BadCell(f"{self.cell.folder.name}/cell.toml", "cell-name-twice", name=name, count=2)
        self.cell = self.cell.with_zone(name, shape)
        if known is not None and shape is not None and known.model_copy(update={"pose": shape.pose}) == shape:
            self.move(name, shape.pose)
            return
        if known is not None:
            self._forget_zone(name)
        if shape is not None:
            self._add_zone(name)

    def _forget_zone(self, name: str) -> None:
        parts = self._things.pop(name)
        self._zones = [each for each in self._zones if each.name != name]
        self._why = {names: why for names, why in self._why.items() if names[1] != name}
        for pair in product(self._moving, parts):
            for group in (*self._standing.values(), self._clear):
                group.use(pair, wanted=False)

    def _add_zone(self, name: str) -> None:
        parts = self._things[name] = standing_bodies(self.cell)[name]
        self._zones.extend(parts)
        pairs = [*product(self._moving, parts)]
        self._standing[Watch.CLEARANCE].add(pairs)
        self._clear.add([pair for pair in pairs if may_be_near(pair[0])])
        self._watch_standing(parts, parts[0].placement)

    def _own_pairs(self, bodies: list[Body]) -> dict[Watch, list[tuple[Body, Body]]]:
        """The pairs within the arm, by what they have to keep."""
        rules = OwnPairs(self.cell, self.robot, bodies)
        found: dict[Watch, list[tuple[Body, Body]]] = {watch: [] for watch in Watch}
        for i, first in enumerate(bodies):
            for k, second in enumerate(bodies):
                if (first.joint, i) > (second.joint, k):
                    rule = rules.rule(first, second, PairGroup(self.robot, 0.0, [(first, second)]).margin)
                    found[rule.watch].append((first, second))
                    self._note((first, second), rule)
        return found

    def _watch_standing(self, parts: Sequence[Body], placement: Any) -> None:
        """Chooses what the moving bodies have to keep from an obstacle, a zone or the floor that is there now."""
        placed = {id(part): replace(part, placement=placement) for part in parts}
        is_mount = not self._is_zone(parts[0]) and any(self._is_mount(there) for there in placed.values())
        for pair in self._standing[Watch.CLEARANCE].bodies:
            if id(pair[1]) in placed:
                there = placed[id(pair[1])]
                distance = PairGroup(self.robot, 0.0, [(pair[0], there)]).margin
                rule = rule_of_standing(self.robot, (pair[0], there), distance, self.cell.limits.clearance_m, is_mount=is_mount)
                for watch, group in self._standing.items():
                    group.use(pair, rule.watch is watch)
                self._clear.use(pair, rule.watch is Watch.NOTHING)
                self._note(pair, rule)

    def _is_zone(self, thing: Body) -> bool:
        return any(thing is zone for zone in self._zones)

    def _is_mount(self, thing: Body) -> bool:
        """Whether the robot's base stands on a thing, hangs from it or is bolted to it."""
        return any(measure_distance(base.geometry, base.placement, thing.geometry, thing.placement) <= MOUNT_M for base in self._base)

    def _note(self, pair: tuple[Body, Body], rule: Rule) -> None:
        """Why nobody watches a pair."""
        if rule.why is not None:
            self._why[pair[0].name, pair[1].name] = rule.why


def _check_base(cell: Cell, bodies: list[Body], things: list[Body]) -> None:
    for base in (body for body in bodies if body.joint == 0):
        for thing in things:
            distance = measure_distance(base.geometry, base.placement, thing.geometry, thing.placement)
            if distance < -BASE_IN_OBSTACLE:
                raise BadCell(
                    f"{cell.folder.name}/cell.toml: {thing.name}",
                    "robot-base-inside",
                    link=base.name,
                    depth_m=-distance,
                    most_m=BASE_IN_OBSTACLE,
                    in_the_way=thing.name,
                )


def _check_home(cell: Cell, collision: CollisionModel) -> None:
    nearest = collision.nearest(np.array(cell.robot.home_rad))
    if nearest.margin_m < 0.0:
        if nearest.first == PAYLOAD and collision.payload_box != cell.payload_box:
            raise _refuse_box(cell, nearest)
        raise BadCell(
            f"{cell.folder.name}/cell.toml: robot.home_rad",
            "robot-home-too-close",
            first=nearest.first,
            distance_m=nearest.distance_m,
            second=nearest.second,
            required_m=nearest.required_m,
            keys=_name_keys_of_requirement(cell, nearest),
            in_the_way=nearest.second,
        )


def _refuse_box(cell: Cell, nearest: Nearest) -> NoRoomAtHome:
    """What is wrong with a payload box that nobody's file states."""
    second = name_body(cell, nearest.second)
    if nearest.distance_m < 0.0:
        return NoRoomAtHome("robot-box-inside-at-home", depth_m=-nearest.distance_m, second=second, in_the_way=nearest.second)
    return NoRoomAtHome(
        "robot-box-near-at-home",
        distance_m=nearest.distance_m, required_m=nearest.required_m, second=second, in_the_way=nearest.second,
    )  # fmt: skip


def _name_keys_of_requirement(cell: Cell, nearest: Nearest) -> Message:
    """The keys of cell.toml that would change the distance required of that pair."""
    if nearest.second in {FLOOR, *(item.name for item in cell.standing)}:
        return Message.of("robot-keys-of-clearance")
    if nearest.first in {PAYLOAD, *cell.tools, *(link for tool in cell.tools.values() for link in tool.links or ())}:
        return Message.of("robot-keys-of-carried")
    return Message.of("robot-keys-of-links")
