"""Cells of robots as they come: descriptions of the package example-robot-data, made into cells by a small conversion of the tests' own.

Meshes are copied beside the URDF, joints beside the arm are fixed where they stand, continuous joints get limits, a sensor frame is put at
the flange; what hangs behind the sensor is dropped, or counts as a part of the arm where the sensor is put behind it. Each stands on a
table above a floor with two protected zones, at the default clearances; home is a configuration that the independent checker finds free.
"""

from __future__ import annotations

import shutil
import sysconfig
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from core.array import Array
from core.cell.cell import Box, Cell, Obstacle, Payload, Pose, Robot, Sensor, Zone
from core.cell.folder import contradictions_of
from tests.independent_arm import Arm, pose
from tests.independent_checker import IndependentChecker

SHARE = Path(sysconfig.get_paths()["purelib"]) / "cmeel.prefix" / "share"
SENSOR = "ft_sensor"
SENSORS = Sensor(
    name="made up",
    noise_std=(0.06, 0.06, 0.06, 0.003, 0.003, 0.003),
    range=(150.0, 150.0, 300.0, 8.0, 8.0, 8.0),
    resolution=(0.05, 0.05, 0.05, 0.0015, 0.0015, 0.0015),
)
TABLE_M = 0.05
"""Thickness."""
ROOM_AT_HOME_M = 0.02
"""Beyond what is required."""
HARDLY_ROOM_M = 0.002
"""The same where there is no more: a UR's upper arm is never far from the table that it stands on."""
_TRIES = 1500
_ENOUGH_M = 0.08
_DRAWS = 20


@dataclass(frozen=True)
class Description:
    """Where a robot's URDF is and what of it is the arm.

    Args:
        urdf: below the package's folder of robots.
        flange: the link that carries the sensor; what is fixed behind it is dropped.
        base: the link that the arm begins with.
        acceleration_rad_s2: of all joints; the descriptions say nothing of it.
        stands_m: height of the base link above the table; None where the robot brings its own stand and no table is put under it.
        bodies: shapes of moving links that the description leaves out altogether, as elements of a URDF.
        adjacent: pairs of links that are as near as they are by construction.
    """

    urdf: str
    base: str
    flange: str
    acceleration_rad_s2: float = 10.0
    stands_m: float | None = 0.0
    bodies: tuple[tuple[str, str], ...] = ()
    adjacent: tuple[tuple[str, str], ...] = ()


_UR = "ur_description/urdf/{}_robot.urdf"
BASES = {"table": Pose(), "ceiling": Pose(rpy_rad=(np.pi, 0.0, 0.0)), "wall": Pose(rpy_rad=(0.0, np.pi / 2, 0.0))}
FLOORS_M = {"table": -0.75, "ceiling": -2.2, "wall": -1.2}
"""Below the base."""
ROBOTS = {
    "panda": Description("panda_description/urdf/panda.urdf", "panda_link0", "panda_hand_tcp"),
    "ur3": Description(_UR.format("ur3"), "base_link", "tool0"),
    "ur5": Description(_UR.format("ur5"), "base_link", "tool0"),
    "ur10": Description(_UR.format("ur10"), "base_link", "tool0"),
    "xarm7": Description("xarm_description/urdf/xarm7.urdf", "link_base", "link_eef"),
    "z1": Description("z1_description/urdf/z1.urdf", "link00", "link06"),
    "kinova": Description("kinova_description/robots/kinova.urdf", "j2s6s200_link_base", "j2s6s200_end_effector"),
    "tiago": Description(
        "tiago_description/robots/tiago.urdf",
        "base_footprint",
        "arm_tool_link",
        stands_m=None,
        bodies=(("arm_7_link", '<cylinder radius="0.025" length="0.03"/>'),),
        adjacent=(("arm_1_link", "torso_fixed_column_link"),),
    ),
    "talos": Description("talos_data/robots/talos_left_arm.urdf", "arm_left_1_link", "wrist_left_ft_link", stands_m=0.25),
}
"""The arms; the package has no iiwa."""


def robot_folder(name: str, folder: Path) -> Path:
    """Writes `robot.urdf` of one robot and its meshes into a folder, which it makes."""
    description = ROBOTS[name]
    root = ET.parse(SHARE / "example-robot-data" / "robots" / description.urdf).getroot()
    for element in [*root.findall("gazebo"), *root.findall("transmission"), *root.findall("material")]:
        root.remove(element)
    joints = {joint.find("child").get("link"): joint for joint in root.findall("joint")}  # type: ignore[union-attr]  # each of these joints has one
    chain = set(_upwards(joints, description.flange))
    for link, joint in joints.items():
        if link not in chain or joint.get("type") == "prismatic":
            _fix(joint)
        elif joint.get("type") == "continuous":
            joint.set("type", "revolute")
            joint.find("limit").attrib.update(lower=str(-2 * np.pi), upper=str(2 * np.pi))  # type: ignore[union-attr]  # each of these joints has one
    behind = _below(joints, description.flange) - {description.flange}
    for link in root.findall("link"):
        if link.get("name") in behind:
            root.remove(link)
        else:
            _complete(link, joints, dict(description.bodies))
    for link, joint in joints.items():
        if link in behind:
            root.remove(joint)
    ET.SubElement(root, "link", name=SENSOR)
    sensor = ET.SubElement(root, "joint", name="ft_sensor_joint", type="fixed")
    ET.SubElement(sensor, "parent", link=description.flange)
    ET.SubElement(sensor, "child", link=SENSOR)
    folder.mkdir(parents=True)
    for k, mesh in enumerate(root.iter("mesh")):
        source = SHARE / mesh.get("filename", "").removeprefix("package://")
        target = Path("meshes") / f"{k}_{source.name}"
        (folder / "meshes").mkdir(exist_ok=True)
        shutil.copyfile(source, folder / target)
        mesh.set("filename", str(target))
    (folder / "robot.urdf").write_text(ET.tostring(root, encoding="unicode"))
    return folder


def real_cell(name: str, folder: Path, *, payload_box: Box | None = None, mounting: str = "table", seed: int = 0) -> Cell:
    """A cell of one robot, written into a folder: table, floor, two protected zones.

    Args:
        mounting: "table", "ceiling" or "wall"; a robot with a stand of its own stands on the floor.

    Raises:
        RuntimeError: no configuration was found that is free.
    """
    folder = robot_folder(name, folder)
    description = ROBOTS[name]
    urdf = (folder / "robot.urdf").read_text()
    base = BASES[mounting]
    arm = Arm(urdf, folder, description.base, SENSOR, pose(base.xyz_m, base.rpy_rad))
    return place(name, folder, arm, base, payload_box or Box(size_m=(0.1, 0.1, 0.1), pose=Pose(xyz_m=(0.0, 0.0, 0.05))), mounting, seed)


def place(name: str, folder: Path, arm: Arm, base: Pose, payload_box: Box, mounting: str, seed: int) -> Cell:
    """The cell round an arm."""
    description = ROBOTS[name]
    reach = reach_of(arm)
    shoulder = arm.frames(np.zeros((1, arm.n)))[0, 1, :3, 3]
    floor = 0.0 if description.stands_m is None else FLOORS_M[mounting]
    cell = Cell(
        name=f"{name}_{mounting}_{seed}",
        title=name,
        robot=Robot(
            base_frame=description.base,
            sensor_frame=SENSOR,
            home_rad=tuple(0.5 * (arm.lower + arm.upper)),
            acceleration_rad_s2=(description.acceleration_rad_s2,) * arm.n,
            base=base,
            adjacent=description.adjacent,
        ),
        sensor=SENSORS,
        floor_z_m=floor,
        payload_box=payload_box,
        obstacles=tuple(_mounting(description, base, mounting)),
        zones=tuple(_zones(shoulder, reach, floor)),
        folder=folder,
    )
    robot = cell.robot.model_copy(update={"home_rad": home_of(cell, payload_box, seed)})
    return Cell.model_validate(cell.model_dump() | {"robot": robot.model_dump(), "folder": folder})


def home_of(cell: Cell, payload_box: Box, seed: int) -> tuple[float, ...]:
    """A free configuration with much room among random ones.

    Raises:
        RuntimeError: there is none.
    """
    checker = IndependentChecker(cell, payload_box)
    rng = np.random.default_rng([seed, 31415])
    low, high = np.maximum(checker.arm.lower + 0.1, -np.pi), np.minimum(checker.arm.upper - 0.1, np.pi)
    low, high = np.where(low < high, low, checker.arm.lower + 0.1), np.where(low < high, high, checker.arm.upper - 0.1)
    best, room = None, HARDLY_ROOM_M
    for _ in range(_TRIES):
        q = rng.uniform(low, high)
        if checker.is_free(q, room) and checker.flights(q[None].repeat(3, axis=0), 0.001)[0] > ROOM_AT_HOME_M:
            best, room = q, max(1.3 * room, min(ROOM_AT_HOME_M, 3.0 * room))
            if room > _ENOUGH_M:
                break
    if best is None:
        raise RuntimeError(f"no configuration of {cell.name} is free")
    return tuple(float(x) for x in best)


def reach_of(arm: Arm) -> float:
    """Largest distance of the sensor from the first joint's frame among random configurations, m."""
    q = np.random.default_rng(1).uniform(np.maximum(arm.lower, -np.pi), np.minimum(arm.upper, 2 * np.pi), (2000, arm.n))
    frames = arm.frames(q)
    return float(np.linalg.norm((frames[:, -1] @ arm.sensor)[:, :3, 3] - frames[:, 1, :3, 3], axis=1).max())


def _mounting(description: Description, base: Pose, mounting: str) -> Iterator[Obstacle]:
    """What the robot is bolted to: a slab behind its base plane."""
    if description.stands_m is None:
        return
    T = pose(base.xyz_m, base.rpy_rad) @ pose([0.0, 0.0, -description.stands_m - 0.5 * TABLE_M], [0.0, 0.0, 0.0])
    side = {"table": 1.2, "ceiling": 1.0, "wall": 1.0}[mounting]
    where = Pose(xyz_m=tuple(T[:3, 3].tolist()), rpy_rad=base.rpy_rad)
    yield Obstacle(name="table" if mounting == "table" else mounting, shape=Box(size_m=(side, side, TABLE_M), pose=where))


def _zones(shoulder: Array, reach: float, floor: float) -> Iterator[Zone]:
    """Where people are: before the robot beyond its workplace, and at its right."""
    for name, bearing in (("operator", 0.0), ("walkway", -0.5 * np.pi)):
        at = shoulder[:2] + (0.85 * reach + 0.4) * np.array([np.cos(bearing), np.sin(bearing)])
        size = (0.8, 2.0, 2.2)
        where = Pose(xyz_m=(float(at[0]), float(at[1]), floor + 1.1), rpy_rad=(0.0, 0.0, bearing))
        yield Zone(name=name, shape=Box(size_m=size, pose=where))


def _upwards(joints: dict[Any, ET.Element], link: str) -> Iterator[str]:
    while link in joints:
        yield link
        link = joints[link].find("parent").get("link", "")  # type: ignore[union-attr]  # each of these joints has one


def _below(joints: dict[Any, ET.Element], link: str) -> set[str]:
    children = [child for child, joint in joints.items() if joint.find("parent").get("link") == link]  # type: ignore[union-attr]  # each of these joints has one
    return {link}.union(*(_below(joints, child) for child in children))


def _fix(joint: ET.Element) -> None:
    """A joint beside the arm stands still; limits and what it mimics mean nothing then."""
    joint.set("type", "fixed")
    for element in list(joint):
        if element.tag not in ("origin", "parent", "child"):
            joint.remove(element)


def _complete(link: ET.Element, joints: dict[Any, ET.Element], bodies: dict[str, str]) -> None:
    """A moving link without collision geometry gets what is seen of it, or what is stated; nobody collides with what is only seen."""
    moves = link.get("name") in joints and joints[link.get("name")].get("type") != "fixed"
    if moves and link.find("collision") is None:
        given = bodies.get(str(link.get("name")))
        if given is not None:
            link.append(ET.fromstring(f"<collision><geometry>{given}</geometry></collision>"))
        for visual in link.findall("visual"):
            body = ET.SubElement(link, "collision")
            body.extend(element for element in visual if element.tag in ("origin", "geometry"))
    for visual in link.findall("visual"):
        link.remove(visual)


MOUNTINGS = ("table", "ceiling", "wall")
_MARGIN_M = 0.01
"""Of the payload box round the payload."""


def random_real_cell(name: str, seed: int, folder: Path) -> Cell:
    """A random cell of one robot: mounted anyhow, some boxes in its way, a payload that may reach back beside the wrist.

    `payloads["random"]` is what it carries, `payload_box` what is known of that. The same numbers give the same cell on every machine.
    """
    description = ROBOTS[name]
    rng = np.random.default_rng([seed, *name.encode()])
    for attempt in range(_DRAWS):
        mounting = "table" if description.stands_m is None else str(rng.choice(MOUNTINGS))
        payload = _payload(rng)
        box_of = Box(size_m=_three(np.array(payload.box.size_m) + 2 * _MARGIN_M), pose=payload.box.pose)
        try:
            cell = real_cell(name, folder / str(attempt), payload_box=box_of, mounting=mounting, seed=seed)
        except RuntimeError:  # with such a payload nothing is free
            continue
        cell = cell.model_copy(update={"name": f"{name}_{seed}", "payloads": {"random": payload}})
        for k in range(int(rng.integers(0, 4))):
            cell = _with_a_box(cell, rng, k)
        return Cell.model_validate(cell.model_dump() | {"folder": cell.folder})
    raise RuntimeError(f"no payload with which {name} has a free configuration")


def _with_a_box(cell: Cell, rng: np.random.Generator, k: int) -> Cell:
    """The cell with one more box where home remains free with room; the same cell where no place was found."""
    home = np.array(cell.robot.home_rad)
    for _ in range(_DRAWS):
        bearing, away = rng.uniform(-np.pi, np.pi), rng.uniform(0.25, 0.9)
        at = np.array(cell.robot.base.xyz_m) + np.array([away * np.cos(bearing), away * np.sin(bearing), rng.uniform(-0.5, 0.9)])
        shape = Box(size_m=_three(rng.uniform(0.08, 0.5, 3)), pose=Pose(xyz_m=_three(at), rpy_rad=(0.0, 0.0, float(bearing))))
        larger = cell.model_copy(update={"obstacles": (*cell.obstacles, Obstacle(name=f"box_{k}", shape=shape))})
        if contradictions_of(larger):
            continue
        checker = IndependentChecker(larger, larger.payload_box)
        if checker.is_free(home, HARDLY_ROOM_M) and not checker.touches_base(f"box_{k}"):
            return larger
    return cell


def _payload(rng: np.random.Generator) -> Payload:
    """A cuboid of 0.2 to 2 kg with an uneven density, before the flange, beside it, or back along the wrist."""
    mass = float(np.exp(rng.uniform(np.log(0.2), np.log(2.0))))
    size = rng.uniform(0.04, 0.2, 3)
    centre = np.array([*rng.uniform(-0.03, 0.03, 2), 0.5 * size[2] + rng.uniform(0.0, 0.03)])
    if rng.random() < 0.4:
        side = rng.uniform(-np.pi, np.pi)
        beside = 0.5 * float(np.linalg.norm(size[:2])) + rng.uniform(0.05, 0.1)
        centre = np.array([beside * np.cos(side), beside * np.sin(side), rng.uniform(-0.1, 0.05)])
    com = centre + 0.2 * size * rng.uniform(-1.0, 1.0, 3)
    about_com = mass / 12.0 * np.diag(size @ size - size**2) * rng.uniform(0.6, 0.9)
    I = about_com + mass * (com @ com * np.eye(3) - np.outer(com, com))  # noqa: E741 - the name in the formula
    return Payload(
        title="random",
        mass_kg=mass,
        first_moment_kg_m=_three(mass * com),
        inertia_kg_m2=(I[0, 0], I[0, 1], I[0, 2], I[1, 1], I[1, 2], I[2, 2]),
        box=Box(size_m=_three(size), pose=Pose(xyz_m=_three(centre))),
        source="random",
    )


def _three(values: Array) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in values)
    return x, y, z
