"""Makes a cell, from top to bottom: description, frames, joints, shapes, masses, payload box, home, picture.

Everything is built in a folder beside the new one, which gets its name only when it is whole.
"""

from __future__ import annotations

import shutil
import uuid
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core.cell.cell import CELL_FILE, Box, Cell, Robot, Sensor
from core.cell.folder import load_cell
from core.errors import BadInput, BadRobot
from core.new_cell.cell_text import RANGE, CellParts, cell_text
from core.new_cell.expansion import description_text
from core.new_cell.frames import ArmFrames, Ask, choose_frames
from core.new_cell.home import Home, HomeSearch
from core.new_cell.joints import choose_accelerations, complete_limits, fix_others, put_limits
from core.new_cell.masses import G, complete_efforts, complete_masses, tool_of
from core.new_cell.meshes import choose_shapes, copy_meshes
from core.new_cell.order import CellOrder, check_cell_order
from core.new_cell.packages import Packages
from core.new_cell.payload_room import EDGE_M, payload_room
from core.new_cell.picture import draw_home
from core.new_cell.robot_tree import RobotTree
from core.new_cell.values import CellValues
from core.recording.recording import RobotDescription
from core.robot.bodies import Body, link_bodies, payload_body
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.watched_pairs import find_joined_links
from core.words.message import Message

URDF = "robot.urdf"
PICTURE = "home.png"
ROOMS_M = ((EDGE_M, 0.0), (0.1, 0.0), (0.06, 0.0), (0.1, 0.03), (0.06, 0.06), (0.06, 0.1))
"""Edge of the payload box and its gap to the flange face, until one leaves the arm a free home."""

STANDING = 0.02
"""Share of configurations in which the arm of a robot that stands on the floor is above it, at least."""


@dataclass(frozen=True)
class Made:
    """A new cell.

    Args:
        notes: what was chosen, taken or left out.
    """

    folder: Path
    home: Home
    notes: tuple[Message, ...]


def make_cell(order: CellOrder, ask: Ask | None = None, picture: Path | None = None) -> Made:
    """Makes the cell's folder with cell.toml, robot.urdf, meshes and home.png.

    Args:
        ask: asks a person what only a person knows; None where nobody can be asked.
        picture: where the picture of the home stands as well, also where the cell is refused for that home.

    Raises:
        BadInput: of whatever kind: what was given cannot be used, or the folder cannot be written. Nothing is left behind.
    """
    check_cell_order(order)
    notes: list[Message] = []
    values = order.values
    packages = Packages(order.urdf, order.package_paths)
    tree = RobotTree(description_text(packages, order.xacro_arguments), str(order.urdf))
    frames = choose_frames(tree, order, ask, notes)
    fix_others(tree, frames, notes)
    frames = put_limits(tree, frames, values.joints)
    without_effort = complete_limits(tree, frames, notes)
    tree.checked.hinges(frames.base, frames.sensor)
    visual = choose_shapes(tree, notes)
    with _new_folder(order.folder) as folder:
        copy_meshes(tree, packages, folder)
        robot, bodies = _arm(tree, frames, visual, order, folder)
        if not any(body.joint > 0 for body in bodies):
            raise BadRobot(str(order.urdf), "newcell-no-shapes")
        complete_masses(tree, frames, robot, bodies, notes, values.masses_kg)
        robot, bodies = _arm(tree, frames, visual, order, folder)
        complete_efforts(tree, frames, robot, without_effort, notes)
        urdf = tree.checked
        urdf.check_bodies(frames.base, frames.sensor)
        (folder / URDF).write_text(tree.text, encoding="utf-8")
        urdf.check_meshes(folder)
        box, home, floor_z = _box_and_home(tree, frames, robot, bodies, values, notes)
        parts = CellParts(
            name=order.name,
            title=values.title or f"{tree.root.get('name', '')[:150]}, as its description has it",
            source=order.urdf.name,
            base=frames.base,
            sensor=frames.sensor,
            joints=tuple(joint.name for joint in frames.joints),
            home=home.q,
            acceleration=choose_accelerations(frames, list(robot.velocity), values.joints, notes),
            floor_z=floor_z,
            payload_box=box,
            adjacent=home.always_overlapping if values.adjacent is None else values.adjacent,
            visual_shapes=visual,
            tool=frames.tool,
            tool_name="hand_tool" if "hand" in urdf.links else "hand",  # which a link may not be called as well
            sensor_sizes=_sensor_sizes(tree, frames),
            values=values,
        )
        (folder / CELL_FILE).write_text(cell_text(parts), encoding="utf-8")
        shown = [*bodies, payload_body(robot, box)]
        draw_home(folder / PICTURE, robot, shown, home.q, tool=frames.tool, floor_z=floor_z, name=order.name)
        if picture is not None:
            shutil.copyfile(folder / PICTURE, picture)
        _check_made(folder, order.folder)
        proposed = parts.adjacent if values.adjacent is None else ()
        notes += [
            *(Message.of("newcell-pair-left-out", first=first, second=second) for first, second in proposed),
            Message.of("newcell-nearest-at-home", first=home.nearest[0], second=home.nearest[1], distance_m=home.nearest_m),
            *([] if values.sensor else [Message.of("newcell-sensor-of-nobody")]),
        ]
    return Made(order.folder, home, tuple(notes))


def _sensor_sizes(tree: RobotTree, frames: ArmFrames) -> tuple[int, int]:
    """How many times a common sensor's forces and torques, so that the weight of what hangs behind it takes at most half its range."""
    tool = tool_of(tree, frames)
    force, torque = tool.mass * G, float(np.linalg.norm(tool.first_moment)) * G
    return max(1, int(np.ceil(2.0 * force / min(RANGE[:3])))), max(1, int(np.ceil(2.0 * torque / min(RANGE[3:]))))


def _check_made(folder: Path, target: Path) -> None:
    """Nothing is made that planning would refuse; what is refused bears the name that the folder was to have."""
    try:
        cell = load_cell(folder)
        CollisionModel(cell, RobotModel.of_cell(cell), cell.payload_box)
    except BadInput as flaw:
        key = flaw.where.rpartition(f"{folder.name}/")[2]
        named = {name: value for name, value in flaw.message.parameters.items() if name != "where"}
        raise BadInput(str(target / key), flaw.message.code, **named) from flaw


@contextmanager
def _new_folder(target: Path) -> Iterator[Path]:
    """A folder that takes its name when everything in it is done, and is gone where that fails."""
    parents = [folder for folder in (target.parent, *target.parent.parents) if not folder.exists()]
    folder = target.parent / f".{target.name}.{uuid.uuid4().hex[:8]}.part"
    done = False
    try:
        folder.mkdir(parents=True)
        yield folder
        folder.rename(target)
        done = True
    except OSError as error:
        raise BadInput(str(target), "newcell-not-written", reason=error.strerror or str(error)) from error
    finally:
        if not done:
            shutil.rmtree(folder, ignore_errors=True)
            for parent in parents:
                if parent.is_dir() and not any(parent.iterdir()):
                    parent.rmdir()


def _arm(tree: RobotTree, frames: ArmFrames, visual: tuple[str, ...], order: CellOrder, folder: Path) -> tuple[RobotModel, list[Body]]:
    """Kinematics and bodies of the description as it is now, the base frame in the origin of the world."""
    where = str(order.urdf)
    text = tree.text
    (folder / URDF).write_text(text, encoding="utf-8")
    joints = tuple(joint.name for joint in frames.joints)
    robot = RobotModel(RobotDescription(text, joints, frames.base, frames.sensor), where=where)
    cell = Cell(
        name=order.name,
        title=order.name,
        robot=Robot(
            base_frame=frames.base,
            sensor_frame=frames.sensor,
            home_rad=(0.0,) * len(joints),
            acceleration_rad_s2=(1.0,) * len(joints),
            visual_shapes=visual,
        ),
        sensor=Sensor(name="none", noise_std=(1.0,) * 6, range=(100.0,) * 6, resolution=(1.0,) * 6),
        payload_box=Box(size_m=(0.1, 0.1, 0.1)),
        folder=folder,
    )
    return robot, link_bodies(cell, robot)


def _floor(bodies: list[Body]) -> float:
    """Height of the lowest point of what does not move, not above the base frame, to a millimetre below, m."""
    lowest = min((float(body.corners[:, 2].min()) for body in bodies if body.joint == 0), default=0.0)
    return float(np.floor(1000.0 * min(lowest, 0.0) - 1e-6) / 1000.0) if lowest < -1e-6 else 0.0


def _out_of_reach(robot: RobotModel, bodies: list[Body]) -> float:
    """A height below whatever the arm can reach with a payload, in the world, m."""
    lengths = [float(np.linalg.norm(joint.translation)) for joint in robot.model.jointPlacements]
    farthest = max(float(np.linalg.norm(body.corners, axis=1).max()) for body in bodies)
    return -float(np.ceil(10.0 * (sum(lengths) + farthest + 3.0 * EDGE_M)) / 10.0)


def _box_and_home(
    tree: RobotTree, frames: ArmFrames, robot: RobotModel, bodies: list[Body], values: CellValues, notes: list[Message]
) -> tuple[Box, Home, float]:
    """The payload box as stated, else the largest of the default ones with which a home is free; the home; the height of the floor.

    Raises:
        BadInput: the home that was stated is not one for each joint.
        BadRobot: no home is free.
    """
    joined = set(find_joined_links(tree.checked, {body.name for body in bodies}))
    left_out = {frozenset(pair) for pair in values.adjacent or ()}
    names = [joint.name for joint in frames.joints]
    if values.home_rad is not None and len(values.home_rad) != len(names):
        raise BadInput("home_rad", "cell-not-one-for-each-joint", count=len(values.home_rad), joints=names, joint_count=len(names))
    home_given = None if values.home_rad is None else np.array(values.home_rad)
    floor_z = _floor(bodies) if values.floor_z_m is None else values.floor_z_m
    if values.payload_box is not None:
        search = HomeSearch(robot, bodies, payload_body(robot, values.payload_box), floor_z, joined, left_out, frames.tool)
        return values.payload_box, search.home(tree.where, home_given), floor_z
    for edge, gap in ROOMS_M:
        box = payload_room(robot, bodies, frames.tool, edge, gap)
        search = HomeSearch(robot, bodies, payload_body(robot, box), floor_z, joined, left_out, frames.tool)
        if search.share_above_floor < STANDING and values.floor_z_m is None:
            floor_z = _out_of_reach(robot, bodies)
            notes.append(Message.of("newcell-floor-out-of-reach", floor_z_m=floor_z))
            search = HomeSearch(robot, bodies, payload_body(robot, box), floor_z, joined, left_out, frames.tool)
        try:
            home = search.home(tree.where, home_given)
        except BadRobot as error:
            if (edge, gap) == ROOMS_M[-1]:
                raise
            first, second = error.message.parameters["first"], error.message.parameters["second"]
            notes.append(Message.of("newcell-box-without-home", width_m=edge, gap_m=gap, first=first, second=second))
        else:
            break
    x, y, z = box.size_m
    notes.append(Message.of("newcell-payload-box", x_m=x, y_m=y, z_m=z, gap_m=gap))
    return box, home, floor_z
