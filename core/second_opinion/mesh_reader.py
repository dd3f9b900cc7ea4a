"""Reads a mesh for the second opinion: STL and OBJ with trimesh, DAE with pycollada."""

from __future__ import annotations

from pathlib import Path

import collada
import numpy as np
import trimesh
from numpy.typing import NDArray

from core.errors import BadRobot
from core.files.confinement import Arrays, Order, answer_orders

CONVEX = 0.999
"""Share of its hull's room that a solid fills which counts as convex."""


def read_surface(order: Order) -> Arrays:
    """Vertices (k, 3), m, triangles (m, 3), and whether they bound a convex solid.

    Args:
        order: `file`, `scale` (3,), `where`.

    Raises:
        BadRobot: a mesh that cannot be read here.
    """
    file = Path(order["file"])
    try:
        mesh = _dae(file) if file.suffix.lower() == ".dae" else trimesh.load_mesh(file)
        mesh.merge_vertices(merge_tex=True, merge_norm=True)
        mesh.vertices = mesh.vertices * np.array(order["scale"])
        is_convex = mesh.is_volume and mesh.volume >= CONVEX * mesh.convex_hull.volume
        vertices, triangles = np.array(mesh.vertices, dtype=float), np.array(mesh.faces, dtype=np.int64)
    except Exception as error:  # trimesh and pycollada say in many ways that a file is none of theirs
        raise BadRobot(str(order["where"]), "mesh-unreadable-for-second-opinion", reason=str(error)[:100]) from error
    return [vertices, triangles, np.array(is_convex)]


def _dae(file: Path) -> trimesh.Trimesh:
    """All triangles of the scene, in metres."""
    scene = collada.Collada(str(file), ignore=[collada.common.DaeError])
    parts = [_triangles(part) for geometry in scene.scene.objects("geometry") for part in geometry.primitives()]
    soup = np.concatenate([part for part in parts if len(part)]) * (scene.assetInfo.unitmeter or 1.0)
    return trimesh.Trimesh(soup.reshape(-1, 3), np.arange(3 * len(soup)).reshape(-1, 3))


def _triangles(part: collada.primitive.BoundPrimitive) -> NDArray[np.float64]:
    """(m, 3, 3), corners; of lines none."""
    if isinstance(part, collada.lineset.BoundLineSet):
        return np.empty((0, 3, 3))
    whole = part if isinstance(part, collada.triangleset.BoundTriangleSet) else part.triangleset()
    return np.asarray(whole.vertex[whole.vertex_index], dtype=float)


if __name__ == "__main__":
    answer_orders(read_surface)
