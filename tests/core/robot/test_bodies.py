"""The planner's bodies of real robots contain the meshes, and are never farther apart than the second opinion's."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from functools import cache
from pathlib import Path

import coal
import numpy as np
import pinocchio as pin
import pytest
import trimesh
from scipy.spatial import ConvexHull
from scipy.spatial.transform import Rotation

from core.robot.bodies import _hull
from core.robot.meshes import Mesh, WantedMesh, read_meshes
from core.second_opinion.solids import NEAR_M, Solid, distance, place, solids_of_geometries

PREFIX = next(folder for folder in Path(pin.__file__).parents if folder.name == "cmeel.prefix")
ROBOTS = PREFIX / "share" / "example-robot-data" / "robots"
FILES = (
    *(f"panda_description/meshes/collision/link{k}.stl" for k in (0, 3, 5, 7)),
    *(f"ur_description/meshes/ur5/collision/{name}.stl" for name in ("shoulder", "upperarm", "forearm", "wrist2")),
    *(f"kinova_description/meshes/{name}.dae" for name in ("forearm", "wrist_spherical_1")),
)


@cache
def real() -> tuple[list[Mesh], list[Solid]]:
    wanted = [WantedMesh("robot.urdf", file, (1.0, 1.0, 1.0), solid=True) for file in FILES]
    elements = [ET.fromstring(f'<geometry><mesh filename="{file}"/></geometry>') for file in FILES]
    return read_meshes(ROBOTS, wanted), solids_of_geometries(elements, ROBOTS)


@pytest.mark.parametrize("k", range(len(FILES)), ids=FILES)
def test_the_parts_of_a_real_link_contain_it(k: int) -> None:
    mesh, solid = real()[0][k], real()[1][k]
    surface = solid.boundary
    on = trimesh.sample.sample_surface(trimesh.Trimesh(surface.vertices, surface.triangles), 2000, seed=1)[0]  # read by the other reader
    outside = [(each[:, :3] @ on.T + each[:, 3:]).max(axis=0) for each in (ConvexHull(part).equations for part in mesh.parts)]
    assert np.min(outside, axis=0).max() < 1e-6


@pytest.mark.parametrize("seed", range(3))
def test_the_planner_never_puts_real_links_farther_apart_than_the_second_opinion_does(seed: int) -> None:
    meshes, solids = real()
    rng = np.random.default_rng(seed)
    near = 0
    for _ in range(150):
        pair = rng.integers(0, len(FILES), 2)
        turns, places = Rotation.random(2, rng=rng).as_matrix(), rng.uniform(-0.2, 0.2, (2, 3))
        own = distance(*(place(solids[i], turn, spot) for i, turn, spot in zip(pair, turns, places, strict=True)))
        there = [coal.Transform3s(turn, spot) for turn, spot in zip(turns, places, strict=True)]
        planners = min(
            coal.distance(_hull(a), there[0], _hull(b), there[1], coal.DistanceRequest(), coal.DistanceResult())
            for a in meshes[pair[0]].parts
            for b in meshes[pair[1]].parts
        )
        if 0.0 < own < NEAR_M:
            assert planners <= own + 1e-6
            near += 1
        if own <= 0.0:
            assert planners <= 1e-6
        if all(solids[i].surface is None for i in pair) and planners > 0.0:
            assert own == pytest.approx(planners, abs=1e-5)
    assert near > 5
