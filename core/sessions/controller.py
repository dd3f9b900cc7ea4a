"""What a controller says of itself and its arm, held against the cell before anything moves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array
from core.cell.cell import Cell
from core.cell.session import NamedRobot, RealRobot
from core.errors import BadCell, WrongRobot
from core.robot.model import RobotModel

POSITION_M = 0.005
"""The flange may be this far from where the cell has it: arms differ from their nominal model by a few millimetres."""
ANGLE_RAD = 0.01
"""And turned by this much."""


@dataclass(frozen=True)
class Controller:
    """What a controller reports.

    Args:
        model, serial, firmware: as it names them; None where it does not say.
        q: (n,), joint positions, rad, in its order.
        position, rotation: (3,), m, and (3, 3): its flange in its base frame at q, by its own kinematics.
        lower, upper: (n,), joint limits it keeps, rad; None where it does not say.
        velocity: (n,), joint speeds that it allows, rad/s; None where it does not say.
    """

    model: str
    serial: str | None
    firmware: str | None
    q: Array
    position: Array
    rotation: Array
    lower: Array | None = None
    upper: Array | None = None
    velocity: Array | None = None


def check_controller(cell: Cell, robot: RobotModel, said: Controller, *, supported: str, least: tuple[int, ...]) -> None:
    """Model, serial number, firmware, number of joints, limits and kinematics, in this order.

    Args:
        supported: which versions the driver knows, as people write it.
        least: the first of them.

    Raises:
        WrongRobot: what is connected is not what the cell describes.
    """
    check_identity(cell, said, supported=supported, least=least)
    if said.q.size != robot.n:
        raise WrongRobot("session-wrong-joint-count", found=said.q.size, expected=robot.n)
    _check_limits(cell, robot, said)
    Kinematics(cell, robot).check(said.q, said.position, said.rotation)


def check_identity(cell: Cell, said: Controller, *, supported: str, least: tuple[int, ...]) -> None:
    """Model, serial number and firmware.

    Raises:
        WrongRobot: one of them is another.
    """
    link = cell.session
    assert isinstance(link, NamedRobot)
    where = cell.locate("session")
    if said.model.casefold() != link.model.casefold():
        raise WrongRobot("session-wrong-model", found=said.model, expected=link.model, at=where, host=link.host)
    if link.serial is not None and said.serial != link.serial:
        raise WrongRobot("session-wrong-serial", found=said.serial or "-", expected=link.serial, at=where, host=link.host)
    version = said.firmware or "-"
    if link.firmware is not None and not f"{version}.".startswith(link.firmware.rstrip(".") + "."):
        raise WrongRobot("session-wrong-firmware", found=version, expected=link.firmware, at=where)
    if _numbers(version) < least:
        raise WrongRobot("session-unknown-firmware", found=version, supported=supported)


def _numbers(version: str) -> tuple[int, ...]:
    return tuple(int(part) for part in version.split(".") if part.isdigit())


def _check_limits(cell: Cell, robot: RobotModel, said: Controller) -> None:
    """The controller allows what the cell's plans may use.

    Raises:
        WrongRobot: it does not; it would stop the robot on the way.
    """
    speeds = np.array(cell.robot.velocity_rad_s) if cell.robot.velocity_rad_s is not None else robot.velocity
    pairs = (
        ("session-limit-lower", said.lower, -1.0, robot.lower),
        ("session-limit-upper", said.upper, 1.0, robot.upper),
        ("session-limit-speed", said.velocity, 1.0, speeds),
    )
    for code, theirs, sign, ours in pairs:
        if theirs is None:
            continue
        beyond = sign * (ours - theirs)
        j = int(np.argmax(beyond))
        if beyond[j] > 1e-3:
            joint = robot.description.joints[j]
            raise WrongRobot(code, joint=joint, found=float(theirs[j]), expected=float(ours[j]))


class Kinematics:
    """The cell's forward kinematics in the controller's terms: a wrong order, sign or zero of a joint shows as a flange elsewhere.

    Args:
        cell: `sensor.mount` says where its flange is, `session.base` where the controller counts from.

    Raises:
        BadCell: nobody has said where the sensor is on the flange.
    """

    def __init__(self, cell: Cell, robot: RobotModel) -> None:
        link, mount = cell.session, cell.sensor.mount
        if mount is None:
            raise BadCell(cell.locate("sensor.mount"), "session-no-mount")
        assert isinstance(link, RealRobot)
        self._robot = robot
        self._mount_rotation, self._mount_position = mount.rotation, mount.translation
        base = cell.robot.base
        self._base_rotation = base.rotation @ link.base.rotation
        self._base_position = base.rotation @ link.base.translation + base.translation

    def flange(self, q: Array) -> tuple[Array, Array]:
        """Position (3,), m, and rotation (3, 3) of the flange at q (n,) in the controller's base frame."""
        pose = self._robot.sensor_pose(q)
        rotation = pose.rotation @ self._mount_rotation.T
        position = pose.position - rotation @ self._mount_position
        return self._base_rotation.T @ (position - self._base_position), self._base_rotation.T @ rotation

    def distance(self, q: Array, position: Array, rotation: Array) -> tuple[float, float]:
        """How far (m) and how much turned (rad) the flange that a controller reports at q is from the cell's."""
        ours, turned = self.flange(q)
        angle = Rotation.from_matrix(turned.T @ rotation).magnitude()
        return float(np.linalg.norm(position - ours)), float(angle)

    def check(self, q: Array, position: Array, rotation: Array) -> None:
        """Nothing where both have the flange at the same place.

        Raises:
            WrongRobot: they have not; says which swapped joints would explain it.
        """
        far, turned = self.distance(q, position, rotation)
        if far <= POSITION_M and turned <= ANGLE_RAD:
            return
        named: dict[str, Any] = {"distance_m": far, "limit_m": POSITION_M, "angle_rad": turned, "limit_rad": ANGLE_RAD}
        names = self._robot.description.joints
        for i in range(q.size):
            for j in range(i + 1, q.size):
                swapped = q.copy()
                swapped[[i, j]] = q[[j, i]]
                if self._fits(swapped, position, rotation):
                    raise WrongRobot("session-joints-swapped", first=names[i], second=names[j], **named)
        for i in range(q.size):
            turned_round = q.copy()
            turned_round[i] = -q[i]
            if self._fits(turned_round, position, rotation):
                raise WrongRobot("session-joint-sign", joint=names[i], **named)
        raise WrongRobot("session-wrong-kinematics", **named)

    def _fits(self, q: Array, position: Array, rotation: Array) -> bool:
        far, turned = self.distance(q, position, rotation)
        return far <= POSITION_M and turned <= ANGLE_RAD
