"""Meshes of a robot and of what stands in its cell, each read once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.cell.urdf import MAX_MESH_BYTES
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
    """A shape of a link or of an obstacle that is a mesh.

    Args:
        where: file and key, for the sentence.
        scale: (3,), factors along the mesh's axes.
        solid: whether something may run into it.
    """

    where: str
    file: str
    scale: tuple[float, ...]
    solid: bool


def read_meshes(folder: Path, wanted: Sequence[WantedMesh]) -> list[Mesh]:
    """One mesh for each that is wanted.

    Raises:
        BadRobot: a mesh that cannot be used, with its link and file.
    """
    return _KNOWN.read([_order(folder, each) for each in wanted])


def _order(folder: Path, wanted: WantedMesh) -> Order:
    where = f"{wanted.where}: mesh {wanted.file!r}"
    file = find_inside(folder, wanted.file, BadRobot, max_bytes=MAX_MESH_BYTES, where=where)
    return {"file": str(file), "scale": list(wanted.scale), "where": where, "solid": wanted.solid}


def _mesh(arrays: Arrays) -> Mesh:
    vertices, triangles, *parts = arrays
    return Mesh(vertices, triangles, tuple(parts))


_KNOWN = KnownFiles(read_parts, _mesh)
