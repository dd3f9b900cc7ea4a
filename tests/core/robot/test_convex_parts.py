"""Convex parts contain the mesh, whatever it is, and take less room than its hull where that swallows room."""

from __future__ import annotations

import numpy as np
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import ConvexHull

from core.array import Array
from core.robot.convex_parts import MOST_PARTS, convex_parts, stands_off
from tests.core.robot.mesh_bytes import FLAT, elbow


def depth_outside(parts: list[Array], points: Array) -> float:
    """How far the point that is farthest out is from all parts' half spaces, by scipy's hulls; negative where all are in."""
    equations = [ConvexHull(part).equations for part in parts]
    return float(np.min([(points @ each[:, :3].T + each[:, 3]).max(axis=1) for each in equations], axis=0).max())


def points_of(mesh: trimesh.Trimesh) -> Array:
    """On the surface and, of a closed one, in it."""
    on = trimesh.sample.sample_surface(mesh, 1000, seed=1)[0]
    return np.vstack([mesh.vertices, on])


def ring(thickness: float) -> trimesh.Trimesh:
    return trimesh.creation.torus(0.2, thickness, major_sections=24, minor_sections=8)


def cup(wall: float) -> trimesh.Trimesh:
    outline = [[0, 0], [0.1, 0], [0.1, 0.2], [0.1 - wall, 0.2], [0.1 - wall, wall], [0, wall]]
    return trimesh.creation.revolve(np.array(outline), sections=20)


shapes = st.one_of(
    st.builds(ring, st.floats(0.02, 0.08)),
    st.builds(cup, st.floats(0.005, 0.03)),
    st.builds(elbow),
)


@settings(max_examples=6, deadline=None)
@given(mesh=shapes, scale=st.tuples(*[st.floats(0.3, 1.0)] * 3), angles=st.tuples(*[st.floats(-3.0, 3.0)] * 3))
def test_the_parts_contain_the_mesh(mesh: trimesh.Trimesh, scale: tuple[float, ...], angles: tuple[float, ...]) -> None:
    mesh = mesh.copy()
    mesh.apply_transform(trimesh.transformations.euler_matrix(*angles) @ np.diag([*scale, 1.0]))
    parts = convex_parts(np.array(mesh.vertices), np.array(mesh.faces, dtype=np.int64))
    assert 1 <= len(parts) <= MOST_PARTS
    assert depth_outside(parts, points_of(mesh)) < 1e-9
    assert sum(ConvexHull(part).volume for part in parts) < 1.5 * mesh.convex_hull.volume


@settings(max_examples=5, deadline=None)
@given(seed=st.integers(0, 2**32 - 1))
def test_the_parts_contain_triangles_that_are_no_solid(seed: int) -> None:
    rng = np.random.default_rng(seed)
    vertices = rng.uniform(-0.08, 0.08, (20, 3))
    triangles = rng.integers(0, 20, (15, 3))
    parts = convex_parts(vertices, triangles)
    corners = vertices[triangles]
    weights = rng.dirichlet(np.ones(3), 50)
    assert depth_outside(parts, np.einsum("wc,mcx->mwx", weights, corners).reshape(-1, 3)) < 1e-9


def test_an_elbow_is_taken_apart_into_what_it_is_made_of() -> None:
    mesh = elbow()
    parts = convex_parts(np.array(mesh.vertices), np.array(mesh.faces, dtype=np.int64))
    assert len(parts) == 2
    assert sum(ConvexHull(part).volume for part in parts) < 1.35 * mesh.volume < 0.7 * mesh.convex_hull.volume
    inside = np.random.default_rng(2).uniform([0, 0, 0], [0.4, 0.05, 0.05], (500, 3))
    assert depth_outside(parts, np.vstack([inside, inside[:, [1, 0, 2]]])) < 1e-9


def test_a_mesh_that_is_all_but_its_hull_is_its_hull() -> None:
    ball = trimesh.creation.icosphere(radius=0.1)
    (part,) = convex_parts(np.array(ball.vertices), np.array(ball.faces, dtype=np.int64))
    assert len(part) == len(ball.vertices)


def test_a_flat_mesh_has_no_parts() -> None:
    corners = FLAT.reshape(-1, 3)
    assert convex_parts(corners, np.arange(12).reshape(-1, 3)) == []


def test_the_hull_of_a_cup_stands_off_half_as_far_as_it_is_wide() -> None:
    mesh = cup(0.005)
    triangles, hull = np.array(mesh.triangles), np.array(mesh.convex_hull.vertices)
    assert [stands_off(triangles, hull, limit_m) for limit_m in (0.03, 0.089, 0.101)] == [True, True, False]
