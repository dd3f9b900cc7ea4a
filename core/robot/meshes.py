"""Meshes of a robot, each read once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.cell.urdf import MAX_MESH_BYTES
from core.cell.urdf_elements import UrdfShape
from core.errors import BadRobot
from core.files.confinement import Arrays, KnownFiles, Order
from core.files.jail import find_inside
from core.robot.mesh_reader import read_parts


@dataclass(frozen=True)
class Mesh:
    """A mesh in its link's units.

    Args:
        vertices: (k, 3), m.
        triangles: (m, 3), numbers of vertices.
        parts: corners (n, 3) of convex parts that together contain it; none where it is flat and nothing but looked at.
    """

    vertices: Array
    triangles: NDArray[np.int64]
    parts: tuple[Array, ...]


@dataclass(frozen=True)
class WantedMesh:
    """A link's shape that is a mesh.

    Args:
        where: file and key, for the sentence.
        solid: whether something may run into it.
    """

    where: str
    shape: UrdfShape
    solid: bool


def read_meshes(folder: Path, wanted: Sequence[WantedMesh]) -> list[Mesh]:
    """One mesh for each that is wanted.

    Raises:
        BadRobot: a mesh that cannot be used, with its link and file.
    """
    return _KNOWN.read([_order(folder, each) for each in wanted])


def _order(folder: Path, wanted: WantedMesh) -> Order:
    shape = wanted.shape
    where = f"{wanted.where}: mesh {shape.file!r}"
    file = find_inside(folder, shape.file, BadRobot, max_bytes=MAX_MESH_BYTES, where=where)
    return {"file": str(file), "scale": list(shape.sizes), "where": where, "solid": wanted.solid}


def _mesh(arrays: Arrays) -> Mesh:
    vertices, triangles, *parts = arrays
    return Mesh(vertices, triangles, tuple(parts))


_KNOWN = KnownFiles(read_parts, _mesh)
