"""Surfaces of meshes for the second opinion, read by trimesh and pycollada in a process of their own and known by their content."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import fcl
import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.files.confinement import Arrays, KnownFiles
from core.second_opinion.mesh_reader import read_surface


@dataclass(frozen=True)
class Surface:
    """Triangles, closed where they are the surface of a solid.

    Args:
        vertices: (k, 3), m.
        triangles: (m, 3), numbers of vertices.
        is_convex: whether the solid is the hull of its vertices.
    """

    vertices: Array
    triangles: NDArray[np.int64]
    is_convex: bool = False

    @cached_property
    def tree(self) -> Any:
        """python-fcl's model of the triangles."""
        model = fcl.BVHModel()
        model.beginModel(len(self.vertices), len(self.triangles))
        model.addSubModel(self.vertices, self.triangles)
        model.endModel()
        return model


def read_surfaces(files: Sequence[Path], scales: Sequence[Array]) -> list[Surface]:
    """One for each file and scale (3,).

    Raises:
        BadRobot: a file cannot be read here.
    """
    both = zip(files, scales, strict=True)
    return _KNOWN.read([{"file": str(file.resolve()), "scale": scale.tolist(), "where": str(file)} for file, scale in both])


def _surface(arrays: Arrays) -> Surface:
    vertices, triangles, is_convex = arrays
    return Surface(vertices, triangles, bool(is_convex))


_KNOWN = KnownFiles(read_surface, _surface)


def winding_number(surface: Surface, point: Array) -> float:
    """How often a closed surface goes round a point (3,): the sum of the triangles' solid angles (Van Oosterom and Strackee 1983)."""
    a, b, c = np.moveaxis(surface.vertices[surface.triangles] - point, 1, 0)
    la, lb, lc = (np.linalg.norm(each, axis=1) for each in (a, b, c))
    volume = np.einsum("mi,mi->m", a, np.cross(b, c))
    dots = [np.einsum("mi,mi->m", u, v) for u, v in ((a, b), (b, c), (c, a))]
    return float(np.arctan2(volume, la * lb * lc + dots[0] * lc + dots[1] * la + dots[2] * lb).sum() / (2.0 * np.pi))
