"""Everything that is wrong or doubtful in a cell.

What is *wrong* keeps the cell from being planned in. What is *doubtful* may be as it should be: somebody who knows the cell should look.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, Literal

import coal
import numpy as np
from pydantic import BaseModel, ConfigDict

from core.array import Array
from core.cell.cell import CELL_FILE, Box, Cell
from core.cell.folder import read_cell_folder
from core.cell.tools import add_cell_tools
from core.errors import BadInput
from core.new_cell.cell_text import NOT_STATED
from core.new_cell.masses import G, weight_torques
from core.payload.inertia import InertialParameters
from core.robot.bodies import Body, corners_of, link_bodies, payload_body, standing_bodies
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.watched_pairs import OVERLAPPING
from core.words.catalogue import Language
from core.words.message import Message, Parameter

NEAR_HOME = 2.0  # times what is required
FLANGE_M = 0.005  # of the payload box from the flange face
HUGE_BOX = 0.4  # of the arm's reach
SPEED_M_S = 0.5  # faster is no slow motion
ACCELERATIONS = (0.5, 40.0)  # rad/s2 of an arm's joint
FLOOR_BELOW_M = 2.0
FULL, EMPTY = 0.8, 0.02  # of a sensor's range


class CellFinding(BaseModel):
    """One thing that is wrong or doubtful.

    Args:
        message: where it is, what is there, and what is right or usual.
    """

    model_config = ConfigDict(frozen=True)

    severity: Literal["wrong", "doubtful"]
    message: Message

    @property
    def where(self) -> str:
        """File and key."""
        return str(self.message.parameters["where"])

    @property
    def found(self) -> str:
        """What is there."""
        return self.message.say_part("found")

    @property
    def advice(self) -> str:
        """What is right or usual."""
        return self.message.say_part("expected")

    def say(self, language: Language) -> str:
        """All of it as a sentence."""
        if self.severity == "wrong":
            return Message.of("newcell-wrong", flaw=self.message).say(language)
        return Message.of("newcell-doubtful", doubt=self.message).say(language)

    def _asdict(self) -> dict[str, Any]:
        """As JSON has it."""
        return {**self.model_dump(mode="json"), "where": self.where, "found": self.found, "advice": self.advice}


def findings_of(folder: Path) -> list[CellFinding]:
    """Of the cell in a folder, what is wrong first."""
    try:
        read = read_cell_folder(folder)
    except BadInput as error:
        return _wrong(error)
    if read.flaws:
        return [finding for flaw in read.flaws for finding in _wrong(flaw, others=False)]
    cell = read.cell
    found = [*_of_values(cell), *_of_sensor(cell)]
    try:
        robot = RobotModel.of_cell(cell)
        bodies = link_bodies(cell, robot)
        found += [*_of_efforts(cell, robot), *_of_room(cell, robot, bodies)]
        collision = CollisionModel(cell, robot, cell.payload_box)
        found += [*_of_home(cell, collision), *_of_overlaps(collision)]
    except BadInput as error:
        found = _wrong(error) + found
    except (ValueError, RuntimeError, IndexError, ArithmeticError) as error:  # Pinocchio's and Coal's own
        message = Message.of("newcell-no-model", where=cell.robot.urdf, reason=str(error)[:200])
        found = [CellFinding(severity="wrong", message=message), *found]
    return sorted(found, key=lambda finding: finding.severity == "doubtful")


def _wrong(error: BadInput, *, others: bool = True) -> list[CellFinding]:
    flaws = (error, *error.others) if others else (error,)
    return [CellFinding(severity="wrong", message=flaw.message) for flaw in flaws]


def _doubt(key: str, code: str, **parameters: Parameter) -> CellFinding:
    return _doubt_at(f"{CELL_FILE}: {key}", code, **parameters)


def _doubt_at(where: str, code: str, **parameters: Parameter) -> CellFinding:
    return CellFinding(severity="doubtful", message=Message.of(code, where=where, **parameters))


def _of_values(cell: Cell) -> Iterator[CellFinding]:
    up = cell.gravity[2] / max(float(np.linalg.norm(cell.gravity)), 1e-9)
    if up > -0.999:
        tilt = float(np.arccos(np.clip(-up, -1.0, 1.0)))
        yield _doubt("gravity_m_s2", "newcell-gravity-tilted", gravity_m_s2=cell.gravity_m_s2, angle_rad=tilt)
    speed = cell.limits.cartesian_speed_m_s
    if speed > SPEED_M_S:
        yield _doubt("limits.cartesian_speed_m_s", "newcell-speed-high", speed_m_s=speed, most_m_s=SPEED_M_S)
    least, most = ACCELERATIONS
    for value in cell.robot.acceleration_rad_s2:
        if not least <= value <= most:
            yield _doubt(
                "robot.acceleration_rad_s2", "newcell-acceleration-unusual",
                acceleration_rad_s2=value, least_rad_s2=least, most_rad_s2=most,
            )  # fmt: skip
            break
    if cell.robot.friction is None:
        yield _doubt("robot.friction", "newcell-friction-unknown")
    if not cell.zones:
        yield _doubt("zones", "newcell-zones-none")
    if not cell.payloads:
        yield _doubt("payloads", "newcell-payloads-none")
    for first, second in cell.robot.adjacent:
        yield _doubt("robot.adjacent", "newcell-pair-unwatched", first=first, second=second)
    for link in cell.robot.visual_shapes:
        yield _doubt("robot.visual_shapes", "newcell-link-as-it-looks", link=link)


def _of_sensor(cell: Cell) -> Iterator[CellFinding]:
    sensor = cell.sensor
    if sensor.name.startswith(NOT_STATED):
        yield _doubt("sensor", "newcell-sensor-not-stated", name=sensor.name)
    if sensor.mount is None:
        yield _doubt("sensor.mount", "newcell-mount-unknown")
    for name, payload in cell.payloads.items():
        weight = payload.mass_kg * G
        least = min(sensor.range[:3])
        if weight > FULL * least:
            yield _doubt("sensor.range", "newcell-sensor-small", range_n=least, weight_n=weight, payload=name)
        elif weight < EMPTY * least:
            yield _doubt("sensor.range", "newcell-sensor-large", range_n=least, weight_n=weight, payload=name)


def _of_efforts(cell: Cell, robot: RobotModel) -> Iterator[CellFinding]:
    weights = weight_torques(robot, add_cell_tools(cell, InertialParameters(np.zeros(10))))
    for name, effort, needed in zip(robot.description.joints, robot.model.upperEffortLimit, weights, strict=True):
        where = f"{cell.robot.urdf}: joint {name!r}: limit"
        if effort <= 0.0:
            yield _doubt_at(where, "newcell-effort-none", effort_n_m=effort)
        elif effort < needed:
            yield _doubt_at(where, "newcell-effort-low", effort_n_m=effort, needed_n_m=needed)


def _of_room(cell: Cell, robot: RobotModel, bodies: list[Body]) -> Iterator[CellFinding]:
    reach = float(np.linalg.norm([np.asarray(joint.translation) for joint in robot.model.jointPlacements][2:], axis=1).sum())
    reach += float(np.linalg.norm(robot.model.frames[robot.sensor_frame_id].placement.translation))
    boxes = {"payload_box": cell.payload_box, **{f"payloads.{name}.box": payload.box for name, payload in cell.payloads.items()}}
    for key, box in boxes.items():
        yield from _of_box(key, box, reach)
    base = [body for body in bodies if body.joint == 0]
    lowest = min((float(body.corners[:, 2].min()) for body in base), default=float(cell.robot.base.translation[2]))
    if cell.floor_z_m > lowest + 0.001:
        yield _doubt("floor_z_m", "newcell-floor-above-base", floor_z_m=cell.floor_z_m, base_z_m=lowest)
    elif cell.floor_z_m < lowest - FLOOR_BELOW_M:
        yield _doubt("floor_z_m", "newcell-floor-far-below", depth_m=lowest - cell.floor_z_m)
    shoulder = np.asarray(robot.model.jointPlacements[1].translation)
    span = reach + float(np.linalg.norm(corners_of([*bodies, payload_body(robot, cell.payload_box)]).local, axis=1).max())
    standing = standing_bodies(cell)
    for zone in cell.zones:
        distance = min(_distance(part, shoulder) for part in standing[zone.name])
        if distance < span:
            yield _doubt(f"zones.{zone.name}", "newcell-zone-within-reach", distance_m=max(distance, 0.0), reach_m=span)


def _of_box(key: str, box: Box, reach: float) -> Iterator[CellFinding]:
    depth = box.depth(np.zeros(3))
    if depth < -FLANGE_M:
        yield _doubt(key, "newcell-box-off-flange", distance_m=-depth)
    longest = max(box.size_m)
    if longest > HUGE_BOX * reach:
        yield _doubt(key, "newcell-box-long", length_m=longest, reach_m=reach)


def _distance(body: Body, point: Array) -> float:
    """From a fixed body's surface, m."""
    shapes = [coal.Transform3s(body.placement.rotation, body.placement.translation), coal.Transform3s(np.eye(3), point)]
    return float(coal.distance(body.geometry, shapes[0], coal.Sphere(1e-6), shapes[1], coal.DistanceRequest(), coal.DistanceResult()))


def _of_home(cell: Cell, collision: CollisionModel) -> Iterator[CellFinding]:
    nearest = collision.nearest(np.array(cell.robot.home_rad))
    if nearest.distance_m < NEAR_HOME * nearest.required_m:
        yield _doubt(
            "robot.home_rad", "newcell-home-narrow",
            first=nearest.first, second=nearest.second, distance_m=nearest.distance_m, required_m=nearest.required_m,
        )  # fmt: skip


def _of_overlaps(collision: CollisionModel) -> Iterator[CellFinding]:
    for pair in collision.left_out:
        if pair.why == OVERLAPPING:
            yield _doubt_at(collision.cell.robot.urdf, "newcell-shapes-overlap", first=pair.first, second=pair.second)
