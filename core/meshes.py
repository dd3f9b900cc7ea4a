"""Meshes of a robot, each read once: what has been read is known by its content, scale and use."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from core.confinement import Arrays, Order, ask
from core.errors import BadRobot
from core.jail import find_inside
from core.mesh_reader import read_parts
from core.urdf import MAX_MESH_BYTES
from core.urdf_elements import UrdfShape

Array = NDArray[np.float64]

MOST_KNOWN = 500


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


_known: dict[str, Mesh] = {}


def read_meshes(folder: Path, wanted: Sequence[WantedMesh]) -> list[Mesh]:
    """One mesh for each that is wanted; those that are not known yet are read by one process.

    Raises:
        BadRobot: a mesh that cannot be used, with its link and file.
    """
    orders = [_order(folder, each) for each in wanted]
    digests = [_digest(order) for order in orders]
    new = {digest: order for digest, order in zip(digests, orders, strict=True) if digest not in _known}
    found = _known | dict(zip(new, map(_mesh, ask(read_parts, list(new.values()))), strict=True))
    if len(found) <= MOST_KNOWN:
        _known.update(found)
    else:
        _known.clear()
    return [found[digest] for digest in digests]


def _order(folder: Path, wanted: WantedMesh) -> Order:
    shape = wanted.shape
    where = f"{wanted.where}: mesh {shape.file!r}"
    file = find_inside(folder, shape.file, BadRobot, max_bytes=MAX_MESH_BYTES, where=where)
    return {"file": str(file), "scale": shape.sizes, "where": where, "solid": wanted.solid}


def _digest(order: Order) -> str:
    """Of the content, the kind of the file, the scale and the use."""
    file = Path(order["file"])
    try:
        content = hashlib.sha256(file.read_bytes()).hexdigest()
    except OSError as error:
        raise BadRobot(order["where"], f"a file that cannot be read ({error.strerror})", "a readable file") from error
    return f"{content} {file.suffix} {order['scale']} {order['solid']}"


def _mesh(arrays: Arrays) -> Mesh:
    vertices, triangles, *parts = arrays
    return Mesh(vertices, triangles, tuple(parts))
