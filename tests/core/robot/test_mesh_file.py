"""What is read of a mesh is what trimesh reads of it; what is no mesh is refused in a sentence."""

from __future__ import annotations

import io

import numpy as np
import pytest
import trimesh

from core.errors import BadRobot
from core.robot.mesh_file import read_mesh
from tests.core.robot.mesh_bytes import BODY, TETRAHEDRON, ascii_stl, binary_stl, dae

ONE = np.ones(3)
SORTED = np.unique(TETRAHEDRON.reshape(-1, 3), axis=0)


def sphere() -> trimesh.Trimesh:
    return trimesh.creation.icosphere(subdivisions=2, radius=0.1)


@pytest.mark.parametrize("kind", ["stl", "stl_ascii", "obj"])
def test_a_mesh_is_read_as_trimesh_wrote_it(kind: str) -> None:
    ball = sphere()
    content = ball.export(file_type=kind)
    content = content.encode() if isinstance(content, str) else content
    vertices, triangles = read_mesh(content, f"ball.{kind.partition('_')[0].upper()}", np.array([1.0, 2.0, 3.0]), "ball")
    found = trimesh.Trimesh(vertices, triangles, process=False)
    assert len(vertices) == len(ball.vertices)
    assert found.is_volume
    assert found.volume == pytest.approx(6.0 * ball.volume, rel=1e-6)


@pytest.mark.parametrize("content", [binary_stl(TETRAHEDRON), ascii_stl(TETRAHEDRON), b"solid" + binary_stl(TETRAHEDRON)[5:]])
def test_binary_and_ascii_stl_are_told_apart(content: bytes) -> None:
    np.testing.assert_allclose(read_mesh(content, "a.stl", ONE, "a")[0], SORTED, atol=1e-8)


def test_faces_of_an_obj_may_be_polygons_and_count_from_the_end() -> None:
    content = b"# x\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf -4/1/1 -3//1 -2 -1\n"
    vertices, triangles = read_mesh(content, "a.obj", ONE, "a")
    corners = vertices[triangles]
    assert len(triangles) == 2
    assert 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() == 1.0


def test_a_dae_is_placed_by_its_nodes_in_metres() -> None:
    moved = (
        '<node id="n"><translate>1 2 3</translate><rotate>0 0 1 90</rotate><node id="m"><scale>2 2 2</scale>'
        '<instance_geometry url="#body"/></node></node>'
    )
    vertices, _ = read_mesh(dae(moved, unit="0.01"), "a.dae", ONE, "a")
    turned = (2.0 * SORTED) @ np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]).T + [1.0, 2.0, 3.0]
    np.testing.assert_allclose(vertices, np.unique(0.01 * turned.round(12), axis=0), atol=1e-12)


def test_a_dae_that_trimesh_writes_is_read() -> None:
    content = sphere().export(file_type="dae")
    vertices, triangles = read_mesh(content, "a.dae", ONE, "a")
    assert trimesh.Trimesh(vertices, triangles).volume == pytest.approx(sphere().volume, rel=1e-6)


def test_faces_of_a_dae_may_be_polygons() -> None:
    as_list = dae(BODY).replace(b'<triangles count="4">', b'<polylist count="4">').replace(b"</triangles>", b"</polylist>")
    as_list = as_list.replace(b"<p>", b"<vcount>3 3 3 3</vcount><p>")
    vertices, triangles = read_mesh(as_list, "a.dae", ONE, "a")
    assert trimesh.Trimesh(vertices, triangles).volume == pytest.approx(1e-3 / 6.0, rel=1e-9)


def test_a_sentence_names_what_it_is_told_to() -> None:
    with pytest.raises(BadRobot, match=r"^robot.urdf: link 'a': found an empty file, expected a mesh$"):
        read_mesh(io.BytesIO().getvalue(), "a.stl", ONE, "robot.urdf: link 'a'")
