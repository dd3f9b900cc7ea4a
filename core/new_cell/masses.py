"""What a description leaves out of the arm's masses and torques, estimated from shapes and from what the arm itself weighs."""

from __future__ import annotations

import math

import numpy as np

from core.array import Array
from core.cell.urdf_elements import UrdfLink
from core.cell.urdf_tree import UrdfTree
from core.errors import BadInput
from core.new_cell.frames import ArmFrames
from core.new_cell.robot_tree import RobotTree
from core.payload.inertia import InertialParameters
from core.robot.bodies import Body
from core.robot.model import RobotModel
from core.words.message import Message

DENSITY = 1000.0  # kg/m3 of a link's hull: aluminium and motors with air between them
LEAST_MASS = 0.01  # kg
LEAST_RADIUS = 0.01  # m, of gyration
EFFORT_FACTOR = 2.0
G = 9.81


def complete_masses(
    tree: RobotTree, frames: ArmFrames, robot: RobotModel, bodies: list[Body], notes: list[Message], masses_kg: dict[str, float]
) -> None:
    """Gives every moving link of the arm a mass and an inertia that a body can have, estimated from its shape where it has none.

    Args:
        masses_kg: that somebody has stated, by link.

    Raises:
        BadInput: one of a link that no joint of the arm moves.
    """
    links = {link.name: link for link in tree.checked.bodies}
    moved = [joint.child for joint in frames.joints]
    for name in masses_kg:
        if name not in moved:
            raise BadInput(f"masses_kg.{name}", "newcell-link-unmoved", links=moved)
    for name in moved:
        link, stated = links[name], masses_kg.get(name)
        if stated is None and _can_exist(link):
            continue
        own = [body for body in bodies if body.name == link.name]
        given = stated or (link.mass if link.mass else None)
        mass, com, inertia = _of_shapes(robot, link.name, own, given)
        tree.set_inertia(link.name, mass, com, inertia)
        if stated is not None:
            continue
        if given is None:
            notes.append(Message.of("newcell-mass-taken", link=link.name, mass_kg=mass, density_kg_m3=DENSITY))
        else:
            notes.append(Message.of("newcell-inertia-taken", link=link.name, mass_kg=mass))


def _can_exist(link: UrdfLink) -> bool:
    if not link.mass or link.inertia is None:
        return False
    low, middle, high = np.linalg.eigvalsh(link.inertia)
    return bool(low > 0 and high <= (low + middle) * (1 + 1e-6))


def _of_shapes(robot: RobotModel, link: str, bodies: list[Body], given: float | None) -> tuple[float, Array, Array]:
    """Mass, centre of mass (3,) and inertia (3, 3) about it, in the link's frame."""
    volume, moment, about_origin = 0.0, np.zeros(3), np.zeros((3, 3))
    frame = robot.model.frames[robot.model.getFrameId(link)].placement
    for body in bodies:
        placement = frame.inverse() * body.placement
        size = float(body.geometry.computeVolume())
        com = placement.rotation @ np.asarray(body.geometry.computeCOM()) + placement.translation
        own = placement.rotation @ np.asarray(body.geometry.computeMomentofInertiaRelatedToCOM()) @ placement.rotation.T
        volume, moment = volume + size, moment + size * com
        about_origin += own + size * _point(com)
    if volume <= 0.0:
        mass = given or LEAST_MASS
        return mass, np.zeros(3), mass * LEAST_RADIUS**2 * np.eye(3)
    mass = given or max(LEAST_MASS, round(DENSITY * volume, 3))
    com = moment / volume
    inertia = (about_origin - volume * _point(com)) * mass / volume
    return mass, com, inertia + mass * LEAST_RADIUS**2 * np.eye(3)


def _point(place: Array) -> Array:
    """Moment of inertia (3, 3) of a unit mass at a place (3,)."""
    return np.asarray(place @ place * np.eye(3) - np.outer(place, place))


def complete_efforts(tree: RobotTree, frames: ArmFrames, robot: RobotModel, without: tuple[str, ...], notes: list[Message]) -> None:
    """A torque limit for each of these joints: twice what the arm's own weight and its tool's can ask of it, stretched out."""
    for name, torque in zip((joint.name for joint in frames.joints), weight_torques(robot, tool_of(tree, frames)), strict=True):
        if name in without:
            effort = max(1.0, float(math.ceil(EFFORT_FACTOR * torque)))
            tree.set_limit(name, "effort", effort)
            notes.append(Message.of("newcell-effort-taken", joint=name, effort_n_m=effort, times=EFFORT_FACTOR))


def tool_of(tree: RobotTree, frames: ArmFrames) -> InertialParameters:
    """What hangs behind the sensor, sensor frame; nothing where that is no tool."""
    return UrdfTree(tree.text).merge_links(frames.sensor, frames.tool) if frames.tool else InertialParameters(np.zeros(10))


def weight_torques(robot: RobotModel, tools: InertialParameters) -> Array:
    """(n,), upper bound of what the arm and its tools, sensor frame, ask of each joint by their weight, N m: stretched out level."""
    model = robot.model
    sensor = float(np.linalg.norm(model.frames[robot.sensor_frame_id].placement.translation))
    weight = G * tools.mass  # behind the joint, N; and about its origin, N m
    moment = G * float(np.linalg.norm(tools.first_moment)) + weight * sensor
    torques = np.zeros(robot.n)
    for j in range(robot.n, 0, -1):
        mass = float(model.inertias[j].mass)
        moment += G * mass * float(np.linalg.norm(model.inertias[j].lever))
        weight += G * mass
        torques[j - 1] = moment
        moment += weight * float(np.linalg.norm(model.jointPlacements[j].translation))
    return torques
