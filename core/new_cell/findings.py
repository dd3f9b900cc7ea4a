"""Everything that is wrong or doubtful in a cell, in words.

What is *wrong* keeps the cell from being planned in. What is *doubtful* may be as it should be: somebody who knows the cell should look.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Literal, NamedTuple

import coal
import numpy as np
from numpy.typing import NDArray

from core.cell.cell import CELL_FILE, Box, Cell
from core.cell.folder import read_cell_folder
from core.cell.tools import add_cell_tools
from core.errors import BadInput
from core.new_cell.cell_text import NOT_STATED
from core.new_cell.masses import G, weight_torques
from core.payload.inertia import InertialParameters
from core.robot.bodies import Body, corners_of, link_bodies, make_fixed_body, payload_body
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.watched_pairs import OVERLAPPING

Array = NDArray[np.float64]

NEAR_HOME = 2.0  # times what is required
FLANGE_M = 0.005  # of the payload box from the flange face
HUGE_BOX = 0.4  # of the arm's reach
SPEED_M_S = 0.5  # faster is no slow motion
ACCELERATIONS = (0.5, 40.0)  # rad/s2 of an arm's joint
FLOOR_BELOW_M = 2.0
FULL, EMPTY = 0.8, 0.02  # of a sensor's range


class CellFinding(NamedTuple):
    """One thing that is wrong or doubtful.

    Args:
        where: file and key. found: what is there. advice: what to do.
    """

    severity: Literal["wrong", "doubtful"]
    where: str
    found: str
    advice: str


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
        found = [
            CellFinding("wrong", cell.robot.urdf, f"a model that cannot be built ({str(error)[:200]})", "mend its links and meshes"),
            *found,
        ]
    return sorted(found, key=lambda finding: finding.severity == "doubtful")


def _wrong(error: BadInput, *, others: bool = True) -> list[CellFinding]:
    flaws = (error, *error.others) if others else (error,)
    return [CellFinding("wrong", flaw.where, flaw.found, f"expected is {flaw.expected}") for flaw in flaws]


def _doubt(key: str, found: str, advice: str) -> CellFinding:
    return CellFinding("doubtful", f"{CELL_FILE}: {key}", found, advice)


def _of_values(cell: Cell) -> Iterator[CellFinding]:
    up = cell.gravity[2] / max(float(np.linalg.norm(cell.gravity)), 1e-9)
    if up > -0.999:
        tilt = np.degrees(np.arccos(np.clip(-up, -1.0, 1.0)))
        yield _doubt(
            "gravity_m_s2",
            f"{list(cell.gravity_m_s2)}, {tilt:.0f} deg off straight down",
            "turn the robot by robot.base.rpy_rad, not gravity",
        )
    speed = cell.limits.cartesian_speed_m_s
    if speed > SPEED_M_S:
        yield _doubt("limits.cartesian_speed_m_s", f"{speed:g} m/s", f"at most {SPEED_M_S:g}, where people are near")
    for value in cell.robot.acceleration_rad_s2:
        if not ACCELERATIONS[0] <= value <= ACCELERATIONS[1]:
            low, high = ACCELERATIONS
            yield _doubt("robot.acceleration_rad_s2", f"{value:g} rad/s2", f"what the robot's maker states; {low:g} to {high:g} is usual")
            break
    if cell.robot.friction is None:
        yield _doubt(
            "robot.friction", "nothing", "what is known of the drives; without it a diagnosis judges friction by the tracking error alone"
        )
    if not cell.zones:
        yield _doubt("zones", "none", "a [[zones]] for every place where people may be; without one nothing is kept away from them")
    if not cell.payloads:
        yield _doubt("payloads", "none", "a [payloads.NAME] to simulate a run or to compare the answer with; planning needs none")
    for first, second in cell.robot.adjacent:
        advice = "look at the two on the robot: nothing watches how far they are from each other"
        yield _doubt("robot.adjacent", f"{first!r} and {second!r} left out", advice)
    for link in cell.robot.visual_shapes:
        advice = "a shape for collisions in the URDF, with cables and covers, if the visual one lacks them"
        yield _doubt("robot.visual_shapes", f"{link!r} as it looks", advice)


def _of_sensor(cell: Cell) -> Iterator[CellFinding]:
    sensor = cell.sensor
    if sensor.name.startswith(NOT_STATED):
        yield _doubt("sensor", f"{sensor.name!r}", "noise, range and resolution of the sensor that is there: intervals count with them")
    if sensor.mount is None:
        yield _doubt(
            "sensor.mount", "nothing", "the sensor frame in the flange, without which a payload is exported in the sensor frame alone"
        )
    for name, payload in cell.payloads.items():
        weight = payload.mass_kg * G
        least = min(sensor.range[:3])
        if weight > FULL * least:
            yield _doubt("sensor.range", f"{least:g} N for the {weight:.0f} N of {name!r}", "a sensor with room for what a motion adds")
        elif weight < EMPTY * least:
            yield _doubt("sensor.range", f"{least:g} N for the {weight:.2g} N of {name!r}", "a finer sensor: its errors go with its range")


def _of_efforts(cell: Cell, robot: RobotModel) -> Iterator[CellFinding]:
    weights = weight_torques(robot, add_cell_tools(cell, InertialParameters(np.zeros(10))))
    for name, effort, needed in zip(robot.description.joints, robot.model.upperEffortLimit, weights, strict=True):
        where = f"{cell.robot.urdf}: joint {name!r}: limit"
        if effort <= 0.0:
            yield CellFinding("doubtful", where, f"an effort of {effort:g} N m", "the joint's greatest torque: without it none is checked")
        elif effort < needed:
            found = f"an effort of {effort:g} N m, where the arm and its tools may ask {needed:.0f} N m when it is stretched out"
            yield CellFinding("doubtful", where, found, "the joint's greatest torque and the links' masses as the maker states them")


def _of_room(cell: Cell, robot: RobotModel, bodies: list[Body]) -> Iterator[CellFinding]:
    reach = float(np.linalg.norm([np.asarray(joint.translation) for joint in robot.model.jointPlacements][2:], axis=1).sum())
    reach += float(np.linalg.norm(robot.model.frames[robot.sensor_frame_id].placement.translation))
    boxes = {"payload_box": cell.payload_box, **{f"payloads.{name}.box": payload.box for name, payload in cell.payloads.items()}}
    for key, box in boxes.items():
        yield from _of_box(key, box, reach)
    base = [body for body in bodies if body.joint == 0]
    lowest = min((float(body.corners[:, 2].min()) for body in base), default=float(cell.robot.base.translation[2]))
    if cell.floor_z_m > lowest + 0.001:
        yield _doubt(
            "floor_z_m", f"{cell.floor_z_m:g} m, above the lowest point of the robot's base at {lowest:.3f} m", "the height of the floor"
        )
    elif cell.floor_z_m < lowest - FLOOR_BELOW_M:
        yield _doubt("floor_z_m", f"{lowest - cell.floor_z_m:.1f} m below the robot's base", "the height of the floor, in the world frame")
    shoulder = np.asarray(robot.model.jointPlacements[1].translation)
    span = reach + float(np.linalg.norm(corners_of([*bodies, payload_body(robot, cell.payload_box)]).local, axis=1).max())
    for zone in cell.zones:
        distance = _distance(make_fixed_body(zone.name, zone.shape), shoulder)
        if distance < span:
            found = f"at most {max(distance, 0.0):.2f} m from the shoulder of an arm that reaches {span:.2f} m"
            yield _doubt(f"zones.{zone.name}", found, "a guard that does not depend on planning, wherever people may be in it")


def _of_box(key: str, box: Box, reach: float) -> Iterator[CellFinding]:
    depth = box.depth(np.zeros(3))
    if depth < -FLANGE_M:
        found = f"a box {-depth:.3f} m away from the flange face"
        yield _doubt(key, found, "a box that begins at the sensor frame's origin: what holds the payload takes room, too")
    longest = max(box.size_m)
    if longest > HUGE_BOX * reach:
        yield _doubt(key, f"{longest:g} m long, for an arm of {reach:.2f} m", "the size of what hangs there: little may be left to move in")


def _distance(body: Body, point: Array) -> float:
    """From a fixed body's surface, m."""
    shapes = [coal.Transform3s(body.placement.rotation, body.placement.translation), coal.Transform3s(np.eye(3), point)]
    return float(coal.distance(body.geometry, shapes[0], coal.Sphere(1e-6), shapes[1], coal.DistanceRequest(), coal.DistanceResult()))


def _of_home(cell: Cell, collision: CollisionModel) -> Iterator[CellFinding]:
    nearest = collision.nearest(np.array(cell.robot.home_rad))
    if nearest.distance_m < NEAR_HOME * nearest.required_m:
        found = f"{nearest.first!r} {nearest.distance_m:.3f} m from {nearest.second!r}, of which {nearest.required_m:.3f} m are required"
        yield _doubt("robot.home_rad", found, "a home with more room: every run begins and ends there")


def _of_overlaps(collision: CollisionModel) -> Iterator[CellFinding]:
    for pair in collision.left_out:
        if pair.why == OVERLAPPING:
            found = f"{pair.first!r} and {pair.second!r}, whose shapes overlap at every angle of the joints between them, left out"
            yield CellFinding(
                "doubtful", collision.cell.robot.urdf, found, "look at the two: if they can meet on the robot, mend their shapes"
            )
