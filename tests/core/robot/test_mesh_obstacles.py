"""An obstacle that is a mesh keeps the robot away as the boxes do that it was made of; neither knows of the other."""

from __future__ import annotations

from pathlib import Path
from shutil import copytree

import numpy as np
import pytest
import trimesh

from core.array import Array
from core.cell.cell import Box, Cell, Mesh, Obstacle, Pose
from core.cell.contradictions import contradictions
from core.cell.folder import load_cell
from core.errors import BadCell, BadRobot
from core.report.faces import standing_faces
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.second_opinion.pairs import place_standing
from core.second_opinion.solids import distance

ROOT = Path(__file__).parents[3]
ANGLE = (0.0, 0.0, 0.4)
STANDS_OFF_M = 0.02
"""What a convex part may stand off from a mesh, m."""
PLACE = (0.5, -0.35, 0.02)
BOXES_MM = {"foot": ((400.0, 300.0, 60.0), (0.0, 0.0, 30.0)), "wall": ((60.0, 300.0, 500.0), (-170.0, 0.0, 250.0))}
"""Sizes and centres of what an angle bracket is made of, as its file has them."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = copytree(ROOT / "cells" / "lwr4_bench", tmp_path_factory.mktemp("cells") / "lwr4_bench")
    boxes = [trimesh.creation.box(size, trimesh.transformations.translation_matrix(centre)) for size, centre in BOXES_MM.values()]
    trimesh.util.concatenate(boxes).export(folder / "bracket.stl")
    return folder


def bracket(folder: Path, file: str = "bracket.stl") -> str:
    """The cell with the bracket behind what stands there, as text."""
    text = (folder / "cell.toml").read_text()
    mesh = f'kind = "mesh", file = "{file}", scale = [0.001, 0.001, 0.001]'
    new = f'\n[[obstacles]]\nname = "bracket"\nshape = {{ {mesh}, pose.xyz_m = {list(PLACE)}, pose.rpy_rad = {list(ANGLE)} }}\n'
    return text.replace("\n[[zones]]", f"{new}\n[[zones]]", 1)


@pytest.fixture(scope="module")
def meshed(folder: Path) -> Cell:
    plain = (folder / "cell.toml").read_text()
    (folder / "cell.toml").write_text(bracket(folder))
    found = load_cell(folder)
    (folder / "cell.toml").write_text(plain)
    return found


@pytest.fixture(scope="module")
def boxed(folder: Path) -> Cell:
    """The same of boxes, one obstacle each."""
    cell = load_cell(folder)
    return cell.model_copy(update={"obstacles": (*cell.obstacles, *(Obstacle(name=name, shape=box_of(name)) for name in BOXES_MM))})


def box_of(name: str, place: tuple[float, float, float] = PLACE) -> Box:
    size_mm, centre_mm = BOXES_MM[name]
    there = Pose(xyz_m=place, rpy_rad=ANGLE)
    centre = there.rotation @ (0.001 * np.array(centre_mm)) + there.translation
    x, y, z = (0.001 * length for length in size_mm)
    return Box(size_m=(x, y, z), pose=Pose(xyz_m=tuple(centre.tolist()), rpy_rad=ANGLE))


def model_of(cell: Cell) -> CollisionModel:
    return CollisionModel(cell, RobotModel.of_cell(cell), cell.payload_box)


def random_q(collision: CollisionModel, count: int) -> Array:
    return np.random.default_rng(3).uniform(collision.robot.lower, collision.robot.upper, (count, collision.robot.n))


def test_distances_are_those_of_the_boxes_that_it_was_made_of_and_never_more(meshed: Cell, boxed: Cell) -> None:
    ours, theirs = model_of(meshed), model_of(boxed)
    assert compare(ours, theirs, 200).count("bracket") > 20


def test_it_is_moved_as_a_whole(meshed: Cell, boxed: Cell) -> None:
    elsewhere = (0.45, 0.4, 0.05)
    ours = model_of(meshed)
    ours.move("bracket", Pose(xyz_m=elsewhere, rpy_rad=ANGLE))
    moved = [Obstacle(name=name, shape=box_of(name, elsewhere)) for name in BOXES_MM]
    theirs = model_of(boxed.model_copy(update={"obstacles": (*meshed.obstacles[:-1], *moved)}))
    assert compare(ours, theirs, 60).count("bracket") > 6


def compare(ours: CollisionModel, theirs: CollisionModel, count: int) -> list[str]:
    """What ours finds nearest; convex parts may stand off a little, and nothing is farther away than it is."""
    nearest = []
    for q in random_q(ours, count):
        found, asked = ours.obstacle_distance(q), theirs.obstacle_distance(q)
        assert found.distance_m <= max(asked.distance_m, 0.0) + 1e-5
        assert found.distance_m >= asked.distance_m - STANDS_OFF_M or asked.distance_m < 0.0
        nearest.append(found.second)
    return nearest


def test_the_second_opinion_reads_it_itself(meshed: Cell, boxed: Cell) -> None:
    ours = next(each for each in place_standing(meshed) if each.name == "bracket").at(0)
    theirs = [each.at(0) for each in place_standing(boxed) if each.name in BOXES_MM]
    rng = np.random.default_rng(1)
    near = 0
    for _ in range(200):
        ball = next(iter(place_standing(ball_at(meshed, rng.uniform([0.1, -0.8, 0.0], [0.9, 0.1, 0.7]))))).at(0)
        found, asked = distance(ours, ball), min(distance(each, ball) for each in theirs)
        if asked > 0.0:
            assert found <= asked + 1e-9, "never farther than it is"
            assert found == pytest.approx(asked, abs=1e-6) or found > 0.029, "exact near it"
            near += asked < 0.05
        else:
            assert found < 1e-9
    assert near > 15


def ball_at(cell: Cell, point: Array) -> Cell:
    shape = {"kind": "sphere", "radius_m": 0.02, "pose": {"xyz_m": point.tolist()}}
    return cell.model_copy(update={"obstacles": (Obstacle.model_validate({"name": "ball", "shape": shape}),), "zones": ()})


def test_it_is_drawn_where_it_is(meshed: Cell) -> None:
    corners = np.concatenate([face for part in standing_faces(meshed)["bracket"] for face in part])
    asked = np.concatenate([box_of(name).corners for name in BOXES_MM])
    assert corners.min(axis=0) == pytest.approx(asked.min(axis=0), abs=1e-6)
    assert corners.max(axis=0) == pytest.approx(asked.max(axis=0), abs=1e-6)


def test_a_base_within_it_is_said(meshed: Cell) -> None:
    around = meshed.with_pose_of("bracket", Pose(xyz_m=(0.17, 0.0, 0.0)))  # its wall goes through the base
    assert list(contradictions(around)) == []
    with pytest.raises(BadCell) as refusal:
        model_of(around)
    assert refusal.value.message.code == "robot-base-inside"


@pytest.mark.parametrize(
    ("file", "code"),
    [
        ("nowhere.stl", "files-missing"),
        ("../robot.stl", "files-leads-outside"),
        ("package://cell/bracket.stl", "description-mesh-elsewhere"),
        ("/etc/passwd", "description-mesh-elsewhere"),
    ],
)
def test_a_file_that_is_not_there_is_refused_with_its_key(folder: Path, file: str, code: str) -> None:
    plain = (folder / "cell.toml").read_text()
    (folder / "cell.toml").write_text(bracket(folder, file))
    try:
        with pytest.raises(BadCell) as refusal:
            load_cell(folder)
    finally:
        (folder / "cell.toml").write_text(plain)
    assert refusal.value.message.code == code
    assert "cell.toml: obstacles.bracket.shape.file" in str(refusal.value)


@pytest.mark.parametrize(("content", "code"), [(b"garbage", "mesh-stl-breaks-off"), (b"", "mesh-file-empty")])
def test_a_file_that_is_no_mesh_is_refused_with_the_obstacle(folder: Path, meshed: Cell, content: bytes, code: str) -> None:
    (folder / "bad.stl").write_bytes(content)
    shape = meshed.obstacles[-1].shape
    assert isinstance(shape, Mesh)
    bad = Obstacle(name="bracket", shape=shape.model_copy(update={"file": "bad.stl"}))
    with pytest.raises(BadRobot) as refusal:
        model_of(meshed.model_copy(update={"obstacles": (bad,)}))
    assert refusal.value.message.code == code
    assert "cell.toml: obstacles.bracket: mesh 'bad.stl'" in str(refusal.value)
