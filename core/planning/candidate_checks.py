"""What a candidate for a start configuration has to pass: distances, torques, room for the whole rotation within all limits; and no load
that comes off, at whatever moment, flies into a protected zone."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import Self

import numpy as np

from core.array import Array
from core.cell.body_name import name_body
from core.cell.cell import Cell
from core.errors import TooHeavy
from core.planning.candidates import Candidates
from core.planning.certificate import is_clear
from core.planning.joint_torques import HOLDING_SHARE, JointTorques
from core.planning.pair_margins import PairMargins
from core.planning.rotation_room import Obstruction, RotationCheck, Turn
from core.planning.throw import Throw, ThrowCheck, loads_of
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.trajectory import AngularProfile
from core.robot.watched_pairs import ROOM_M
from core.words.message import Message

OBSTRUCTIONS = {
    Obstruction.JOINT_LIMIT: Message.of("planning-rejected-joint-limits"),
    Obstruction.JOINT_SPEED: Message.of("planning-rejected-joint-speed"),
    Obstruction.JOINT_ACCELERATION: Message.of("planning-rejected-joint-acceleration"),
    Obstruction.CARTESIAN_SPEED: Message.of("planning-rejected-cartesian-speed"),
}
"""What rejects a candidate, beside what `Checks` names with a body, a joint or a zone."""


@dataclass(frozen=True)
class Attitude:
    """What is sought: a direction of the sensor along gravity, and what is done there.

    Args:
        name: for messages.
        down: (3,), unit vector in the sensor frame that is to lie along gravity.
        about: (3,), unit vector in the sensor frame that `rotation` turns about, through the sensor origin.
        rotation: positive about the sensor's own axis; None for a pose that is only held.
        smaller: rotations, the largest first, that will do where none of the configurations looked at leaves room for `rotation`.
    """

    name: str
    down: Array
    about: Array
    rotation: AngularProfile | None = None
    smaller: tuple[AngularProfile, ...] = ()

    @classmethod
    def of_axis(cls, axis: str, rotation: AngularProfile | None = None) -> Self:
        """A sensor axis along ("x+") or against ("x-") gravity, and turned about."""
        unit = np.eye(3)["xyz".index(axis[0])]
        return cls(axis, unit if axis[1] == "+" else -unit, unit, rotation)


@dataclass(frozen=True)
class Accepted:
    """A candidate that passed every check, and the rotation for which it did."""

    row: int
    path: Array
    throw: Throw | None
    rotation: AngularProfile | None


@dataclass(frozen=True)
class Stalled:
    """A candidate that passed every check but those of the rotation that was wanted."""

    candidates: Candidates
    row: int
    throw: Throw | None


class Checks:
    """Everything that a candidate has to pass, the cheap checks first; counts what was rejected, and why."""

    def __init__(
        self,
        cell: Cell,
        robot: RobotModel,
        collision: CollisionModel,
        attitude: Attitude,
        limits: tuple[Array, Array],
        torques: JointTorques | None = None,
        room_m: float = ROOM_M,
    ) -> None:
        self._attitude, self._limits, self._torques, self._room_m = attitude, limits, torques, room_m
        self._cell, self._robot, self._collision = cell, robot, collision
        self._margins = PairMargins(collision)
        self._throw = ThrowCheck(cell)
        self._loads = loads_of(collision.payload_box, attitude.about, attitude.rotation)
        self._rotation = None if attitude.rotation is None else self._make_rotation_check(attitude.rotation)
        self.rejected: Counter[Message] = Counter()
        self.stalled: list[Stalled] = []
        self._with_room = 0
        self._thrown_into: Counter[str] = Counter()
        self._too_weak: list[tuple[float, str]] = []

    def check_candidate(self, candidates: Candidates, row: int) -> Accepted | None:
        """The candidate with its rotation, or None, which is counted."""
        throw = self._check_standing(candidates.q[row], candidates.clearance[row])
        if isinstance(throw, Message):
            self.rejected[throw] += 1
            return None
        path = self._check_rotation(candidates.q[row], self._rotation)
        if isinstance(path, Message):
            self.rejected[path] += 1
            self.stalled.append(Stalled(candidates, row, throw))
            return None
        return Accepted(row, path, throw, self._attitude.rotation)

    def check_smaller(self) -> tuple[Candidates, Accepted] | None:
        """The first of the stalled candidates that leaves room for a smaller rotation, the largest of them that any leaves room for.

        None where none does; they are not looked at again.
        """
        stalled, self.stalled = self.stalled, []
        for rotation in self._attitude.smaller:
            check = self._make_rotation_check(rotation)
            for each in stalled:
                path = self._check_rotation(each.candidates.q[each.row], check)
                if not isinstance(path, Message):
                    return each.candidates, Accepted(each.row, path, each.throw, rotation)
        return None

    def _make_rotation_check(self, rotation: AngularProfile) -> RotationCheck:
        return RotationCheck(self._cell, self._robot, self._collision, Turn.of(rotation, self._attitude.about), self._limits)

    @property
    def thrown_into(self) -> str | None:
        """The zone that a load could fly into from most of the candidates that have room to stand."""
        return next((zone for zone, times in self._thrown_into.items() if 2 * times > self._with_room), None)

    def refuse_too_weak(self, axis: str) -> None:
        """Nothing unless holding the load is what keeps most of the candidates that have room to stand from being used.

        Raises:
            TooHeavy: it is.
        """
        if 2 * len(self._too_weak) > self._with_room:
            share, joint = min(self._too_weak)
            raise TooHeavy("planning-too-heavy-to-hold", axis=axis, joint=joint, share=share, most_share=HOLDING_SHARE)

    def _check_standing(self, q: Array, clearance: float) -> Throw | Message | None:
        """The worst throw from q (n,), or the reason for the refusal."""
        if clearance < self._cell.limits.clearance_m + self._room_m:
            return Message.of("planning-rejected-obstacle", body=name_body(self._cell, self._collision.obstacle_distance(q).second))
        if self._collision.self_room(q) < self._room_m:
            first, second = self._tightest(q[None])
            return Message.of("planning-rejected-bodies", first=first, second=second)
        self._with_room += 1
        return self._throw_with_load(q)

    def _check_rotation(self, q: Array, rotation: RotationCheck | None) -> Array | Message:
        """The path of a rotation (K, n) from q (n,), q alone where there is none, or the reason for the refusal."""
        path = q[None] if rotation is None else rotation(q)
        if isinstance(path, Obstruction):
            return OBSTRUCTIONS[path]
        if len(path) > 1 and not is_clear(self._margins, path, self._room_m):
            first, second = self._tightest(path)
            return Message.of("planning-rejected-rotation-bodies", first=first, second=second)
        return path

    def _throw_with_load(self, q: Array) -> Throw | Message | None:
        """The worst throw from q (n,), or why the load may not be there."""
        weak = None if self._torques is None else self._torques.too_weak_to_hold(q)
        if weak is not None:
            joint, share = weak
            self._too_weak.append((share, joint))
            return Message.of("planning-rejected-joint-too-weak", joint=joint)
        pose = self._robot.sensor_pose(q)
        throw = self._throw.nearest(self._loads, pose.rotation, pose.position)
        if throw is not None and throw.distance_m < 0.0:
            self._thrown_into[throw.zone] += 1
            return Message.of("planning-rejected-throw", zone=throw.zone)
        return throw

    def _tightest(self, path: Array) -> tuple[Message, Message]:
        """The two bodies with the least margin on a path (K, n)."""
        nearest = min((self._collision.nearest(q) for q in path), key=lambda pair: pair.margin_m)
        return name_body(self._cell, nearest.first), name_body(self._cell, nearest.second)
