"""A zone that is a mesh keeps robot and lost loads out as the boxes do that it was made of; neither knows of the other."""

from __future__ import annotations

from pathlib import Path
from shutil import copytree

import fcl
import numpy as np
import pytest
import trimesh
from scipy.spatial.transform import Rotation

from core.array import Array
from core.cell.cell import Box, Cell, Pose, Zone
from core.cell.folder import load_cell
from core.errors import BadCell
from core.planning.solid_distance import Solids, signed_distance, solid_of_hull
from core.planning.throw import PAD_M, ThrowCheck
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel, SensorPose
from core.second_opinion.arm import Frames
from core.second_opinion.lost_load import FINE_M, RESOLUTION_M, nearest_flight

ROOT = Path(__file__).parents[3]
PLACE, TURNED = (0.1, 1.4, 0.0), (0.0, 0.0, 0.3)
BOXES = {"walkway": ((2.0, 0.6, 0.2), (0.0, 0.0, 0.1)), "people": ((0.5, 0.6, 1.8), (-0.75, 0.0, 0.9))}
"""Sizes and centres of what the zone is made of, in its own frame, m."""
LOAD = Box(size_m=(0.08, 0.1, 0.12), pose=Pose(xyz_m=(0.0, 0.0, 0.08)))
PERIOD = 0.01


@pytest.fixture(scope="module")
def meshed(tmp_path_factory: pytest.TempPathFactory) -> Cell:
    folder = copytree(ROOT / "cells" / "lwr4_bench", tmp_path_factory.mktemp("cells") / "lwr4_bench")
    boxes = [trimesh.creation.box(size, trimesh.transformations.translation_matrix(centre)) for size, centre in BOXES.values()]
    trimesh.util.concatenate(boxes).export(folder / "walkway.stl")
    shape = f'{{ kind = "mesh", file = "walkway.stl", pose.xyz_m = {list(PLACE)}, pose.rpy_rad = {list(TURNED)} }}'
    with (folder / "cell.toml").open("a") as file:
        file.write(f'\n[[zones]]\nname = "walkway"\nshape = {shape}\n')
    return load_cell(folder)


@pytest.fixture(scope="module")
def boxed(meshed: Cell) -> Cell:
    return meshed.model_copy(update={"zones": (*meshed.zones[:-1], *boxes_at(Pose(xyz_m=PLACE, rpy_rad=TURNED)))})


def boxes_at(there: Pose) -> list[Zone]:
    made = []
    for name, (size, centre) in BOXES.items():
        x, y, z = (there.rotation @ np.array(centre) + there.translation).tolist()
        made.append(Zone(name=name, shape=Box(size_m=size, pose=Pose(xyz_m=(x, y, z), rpy_rad=there.rpy_rad))))
    return made


def random_motions(count: int) -> list[SensorPose]:
    """Swings of the sensor near the zone, some of them fast."""
    rng = np.random.default_rng(5)
    found = []
    for _ in range(count):
        start, way = rng.uniform([-0.8, 0.2, 0.4], [1.0, 0.9, 1.2]), rng.uniform(-0.5, 0.5, 3)
        share = np.linspace(0.0, 1.0, 30)[:, None]
        turned = Rotation.random(rng=rng) * Rotation.from_rotvec(share * rng.normal(size=3))
        found.append(SensorPose(turned.as_matrix(), start + share * way))
    return found


@pytest.mark.thorough
def test_loads_fly_into_it_where_they_fly_into_its_boxes(meshed: Cell, boxed: Cell) -> None:
    """Three ways to see each flight: the planner's and the second opinion's with the mesh, and the planner's with boxes."""
    seen = {True: 0, False: 0}
    for sensor in random_motions(12):
        mesh, boxes = (cell.model_copy(update={"zones": cell.zones[1:]}) for cell in (meshed, boxed))
        into = ThrowCheck(boxes).into_zone(LOAD, sensor, PERIOD) is not None
        opinion = nearest_flight(mesh, LOAD, Frames(sensor.rotation, sensor.position), PERIOD)
        theirs = nearest_flight(boxes, LOAD, Frames(sensor.rotation, sensor.position), PERIOD)
        assert opinion is not None and theirs is not None
        thrown = ThrowCheck(mesh).into_zone(LOAD, sensor, PERIOD) is not None
        assert thrown or not into, "what flies into a box flies into the mesh that has it"
        if theirs.distance_m > PAD_M + 0.06:
            assert not thrown
        assert (opinion.distance_m < 0.0) == (theirs.distance_m < 0.0) or abs(theirs.distance_m) < RESOLUTION_M + FINE_M
        if 0.0 < theirs.distance_m < 0.05:
            assert opinion.distance_m == pytest.approx(theirs.distance_m, abs=RESOLUTION_M + FINE_M)
        seen[into] += 1
    assert min(seen.values()) >= 2


def test_the_distance_from_a_polyhedron_is_never_too_large_and_hardly_too_small() -> None:
    """python-fcl knows the distance of the same hull."""
    rng = np.random.default_rng(2)
    share = []
    for _ in range(5):
        points = rng.normal(size=(40, 3)) * [0.4, 0.2, 0.05]
        pose = Pose(xyz_m=(0.3, -0.2, 0.1), rpy_rad=(0.5, 0.2, -0.4))
        solids = Solids.of([solid_of_hull(points, pose)])
        hull = trimesh.convex.convex_hull(points)
        faces = np.column_stack([np.full(len(hull.faces), 3), hull.faces]).ravel()
        exact = fcl.CollisionObject(fcl.Convex(hull.vertices, len(hull.faces), faces), fcl.Transform(pose.rotation, pose.translation))
        for point in pose.translation + rng.uniform(-1.0, 1.0, (60, 3)):
            ball = fcl.CollisionObject(fcl.Sphere(1e-9), fcl.Transform(np.eye(3), point))
            asked = fcl.distance(exact, ball, fcl.DistanceRequest(), fcl.DistanceResult())
            found = signed_distance(solids, 0, *point)
            if asked > 0.0:
                assert found <= asked + 1e-5
                share.append(found / asked)
            else:
                assert found <= 1e-5
    assert len(share) > 250
    assert min(share) > 0.9 and np.quantile(share, 0.05) > 0.98


def test_distances_are_those_of_its_boxes_also_after_it_went_and_came_back(meshed: Cell, boxed: Cell) -> None:
    ours, theirs = (CollisionModel(cell, RobotModel.of_cell(cell), cell.payload_box) for cell in (meshed, boxed))
    walkway = meshed.zones[-1].shape
    elsewhere = walkway.model_copy(update={"pose": Pose(xyz_m=(0.2, 1.2, 0.05), rpy_rad=TURNED)})
    moved = boxed.model_copy(update={"zones": (*boxed.zones[:-2], *boxes_at(elsewhere.pose))})
    compare(ours, theirs)
    ours.change_zone("walkway", None)
    compare(ours, CollisionModel(cell := meshed.with_zone("walkway", None), RobotModel.of_cell(cell), cell.payload_box), stands_off_m=1e-6)
    ours.change_zone("walkway", elsewhere)
    compare(ours, CollisionModel(moved, RobotModel.of_cell(moved), moved.payload_box))
    ours.change_zone("walkway", walkway)
    compare(ours, theirs)


def compare(ours: CollisionModel, theirs: CollisionModel, stands_off_m: float = 0.03) -> None:
    """A convex part may stand off a little; nothing is farther away than it is."""
    for q in random_q(ours, 60):
        found, asked = ours.obstacle_distance(q).distance_m, theirs.obstacle_distance(q).distance_m
        assert found <= max(asked, 0.0) + 1e-5
        assert found >= asked - stands_off_m or asked < 0.0


def random_q(collision: CollisionModel, count: int) -> Array:
    return np.random.default_rng(3).uniform(collision.robot.lower, collision.robot.upper, (count, collision.robot.n))


def test_a_file_that_is_not_there_is_refused_with_its_key(meshed: Cell) -> None:
    file = meshed.folder / "cell.toml"
    plain = file.read_text()
    file.write_text(plain.replace("walkway.stl", "nowhere.stl"))
    try:
        with pytest.raises(BadCell, match=r"cell.toml: zones.walkway.shape.file") as refusal:
            load_cell(meshed.folder)
    finally:
        file.write_text(plain)
    assert refusal.value.message.code == "files-missing"
