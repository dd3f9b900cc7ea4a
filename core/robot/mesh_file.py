"""Triangles of a mesh file: STL (binary and ASCII), OBJ and DAE (COLLADA), read as the untrusted files that they are.

Of DAE the unit is heeded and the upward axis is not, as is usual where URDFs are read.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import PurePath

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.errors import BadRobot

Triangles = NDArray[np.int64]

KINDS = (".stl", ".obj", ".dae")
MOST_TRIANGLES = 500_000
LARGEST_M = 20.0
MOST_ELEMENTS = 4_000
"""Of a DAE's scene, each as often as it is referred to."""
MOST_DEPTH = 32
"""Of nodes in a DAE."""

_VERTEX = re.compile(rb"\bvertex\s+(\S+)\s+(\S+)\s+(\S+)")


def read_mesh(content: bytes, name: str, scale: Array, where: str) -> tuple[Array, Triangles]:
    """Different vertices (k, 3), m, and triangles (m, 3), numbers of vertices.

    Args:
        name: of the file, for its kind.
        scale: (3,), factors along the mesh's axes.
        where: for the sentence.

    Raises:
        BadRobot: not such a mesh, empty, too many triangles, vertices that are no numbers or too far away.
    """
    if (scale <= 0.0).any():
        raise BadRobot(where, "mesh-scale-not-positive", scale=" ".join(f"{factor:g}" for factor in scale))
    if not content:
        raise BadRobot(where, "mesh-file-empty")
    read = {".stl": _stl, ".obj": _obj, ".dae": _dae}.get(PurePath(name).suffix.lower())
    if read is None:
        raise BadRobot(where, "mesh-unknown-kind", kind=PurePath(name).suffix, kinds=KINDS)
    try:
        with np.errstate(all="ignore"):  # what is no number is looked for below
            corners = read(content, where) * scale
    except (ValueError, IndexError, OverflowError, RuntimeError) as error:  # RuntimeError: an element that is not there
        raise BadRobot(where, "mesh-unreadable", reason=str(error)[:100]) from error
    _check(corners, where)
    vertices, numbers = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    return vertices, numbers.reshape(-1, 3).astype(np.int64)


def _check(corners: Array, where: str) -> None:
    if len(corners) == 0:
        raise BadRobot(where, "mesh-empty")
    _check_count(len(corners), where)
    if not np.isfinite(corners).all():
        raise BadRobot(where, "mesh-not-finite")
    size = float(np.abs(corners).max())
    if size > LARGEST_M:
        raise BadRobot(where, "mesh-too-large", distance_m=size, most_m=LARGEST_M)


def _check_count(count: int, where: str) -> None:
    if count > MOST_TRIANGLES:
        raise BadRobot(where, "mesh-too-many-triangles", triangles=count, most=MOST_TRIANGLES)


def _stl(content: bytes, where: str) -> Array:
    """(m, 3, 3), corners."""
    said = int.from_bytes(content[80:84], "little") if len(content) >= 84 else -1
    if content.lstrip()[:5] == b"solid" and b"\0" not in content[:400] and len(content) != 84 + 50 * said:
        words = _VERTEX.findall(content)
        if len(words) % 3:
            raise BadRobot(where, "mesh-incomplete-triangle", vertices=len(words))
        _check_count(len(words) // 3, where)
        return np.array(words).astype(np.float64).reshape(-1, 3, 3)
    if len(content) < 84 + 50 * said or said < 0:
        raise BadRobot(where, "mesh-stl-breaks-off", bytes=len(content))
    _check_count(said, where)
    rows = np.frombuffer(content, np.uint8, 50 * said, 84).reshape(-1, 50)
    return rows[:, 12:48].copy().view("<f4").reshape(-1, 3, 3).astype(np.float64)


def _obj(content: bytes, where: str) -> Array:
    vertices: list[list[float]] = []
    faces: list[list[int]] = []
    for line in content.decode("latin-1").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            vertices.append([float(word) for word in words[1:4]])
        elif words[:1] == ["f"]:
            numbers = [int(word.partition("/")[0]) for word in words[1:]]
            fan = [number - 1 if number > 0 else len(vertices) + number for number in numbers]
            faces += [[fan[0], fan[k], fan[k + 1]] for k in range(1, len(fan) - 1)]
            _check_count(len(faces), where)
    return _corners(np.array(vertices, dtype=float).reshape(-1, 3), np.array(faces, dtype=np.int64).reshape(-1, 3), where)


def _corners(vertices: Array, triangles: Triangles, where: str) -> Array:
    if len(triangles) and not 0 <= triangles.min() <= triangles.max() < len(vertices):
        raise BadRobot(where, "mesh-no-such-vertex", vertices=len(vertices))
    return np.asarray(vertices[triangles])


@dataclass
class _Collada:
    """A DAE's elements, by their identifiers and without name spaces."""

    root: ET.Element
    named: dict[str, ET.Element]
    where: str
    elements: int = 0
    count: int = 0

    def of(self, link: str | None) -> ET.Element:
        """What a link such as #name refers to."""
        name = (link or "").removeprefix("#")
        if name not in self.named:
            raise BadRobot(self.where, "mesh-dae-dead-link", name=name[:60])
        return self.named[name]

    def triangles_below(self, node: ET.Element, placement: Array, depth: int = 0) -> Iterator[Array]:
        """(m, 3, 3) each, of a node and the nodes in it, where `placement` (4, 4) puts it."""
        if depth > MOST_DEPTH:
            raise BadRobot(self.where, "mesh-dae-too-deep", most=MOST_DEPTH)
        for element in node:
            self.elements += 1
            if self.elements > MOST_ELEMENTS:
                raise BadRobot(self.where, "mesh-dae-too-many-elements", most=MOST_ELEMENTS)
            match element.tag:
                case "matrix" | "translate" | "rotate" | "scale":
                    placement = placement @ _transform(element.tag, _numbers(element))
                case "node":
                    yield from self.triangles_below(element, placement, depth + 1)
                case "instance_node":
                    yield from self.triangles_below(self.of(element.get("url")), placement, depth + 1)
                case "instance_geometry":
                    for corners in self._triangles(self.of(element.get("url"))):
                        yield corners @ placement[:3, :3].T + placement[:3, 3]

    def _triangles(self, geometry: ET.Element) -> Iterator[Array]:
        for mesh in geometry.findall("mesh"):
            for kind in ("triangles", "polylist", "polygons"):
                for primitive in mesh.findall(kind):
                    found = _corners(*self._faces(primitive), self.where)
                    self.count += len(found)
                    _check_count(self.count, self.where)
                    yield found

    def _faces(self, primitive: ET.Element) -> tuple[Array, Triangles]:
        inputs = primitive.findall("input")
        width = 1 + max(int(each.get("offset", "0")) for each in inputs)
        vertex = next(each for each in inputs if each.get("semantic") == "VERTEX")
        if not 0 <= int(vertex.get("offset", "0")) < width <= 64:
            raise ValueError("offsets of <input>")
        position = next(each for each in self.of(vertex.get("source")).findall("input") if each.get("semantic") == "POSITION")
        floats = next(self.of(position.get("source")).iter("float_array"))
        corners = [_numbers(each).astype(np.int64)[int(vertex.get("offset", "0")) :: width] for each in primitive.findall("p")]
        if primitive.tag == "polylist":
            counts = _numbers(next(primitive.iter("vcount"))).astype(np.int64)
            if (counts < 3).any():
                raise ValueError("a face of fewer than three corners")
            corners = np.split(corners[0], np.cumsum(counts)[:-1])
        elif primitive.tag == "triangles":
            corners = [part.reshape(-1, 3) for part in corners]
            return _numbers(floats).reshape(-1, 3), np.concatenate([np.empty((0, 3), dtype=np.int64), *corners])
        fans = [np.column_stack([np.full(len(face) - 2, face[0]), face[1:-1], face[2:]]) for face in corners]
        return _numbers(floats).reshape(-1, 3), np.concatenate([np.empty((0, 3), dtype=np.int64), *fans])


def _dae(content: bytes, where: str) -> Array:
    for declaration in ("<!DOCTYPE", "<!ENTITY"):
        if any(declaration.encode(code) in content for code in ("utf-8", "utf-16-le", "utf-16-be")):
            raise BadRobot(where, "mesh-dae-declaration", declaration=declaration)
    try:
        root = ET.fromstring(content)
    except (ET.ParseError, ValueError, LookupError) as error:
        raise BadRobot(where, "mesh-dae-does-not-parse", reason=str(error)[:100]) from error
    for element in root.iter():
        element.tag = str(element.tag).rpartition("}")[2]
    file = _Collada(root, {element.get("id", ""): element for element in root.iter()}, where)
    unit = [float(each.get("meter", "1")) for each in root.findall("asset/unit")]
    placement = np.diag([*[unit[0] if unit else 1.0] * 3, 1.0])
    scenes = [file.of(each.get("url")) for each in root.iter("instance_visual_scene")]
    found = [corners for scene in scenes for corners in file.triangles_below(scene, placement)]
    return np.concatenate([np.empty((0, 3, 3)), *found])


def _transform(kind: str, values: Array) -> Array:
    """(4, 4)."""
    if kind == "matrix":
        return values.reshape(4, 4)
    placement = np.eye(4)
    if kind == "translate":
        placement[:3, 3] = values
    elif kind == "scale":
        placement[:3, :3] = np.diag(values)
    else:
        x, y, z = values[:3] / np.linalg.norm(values[:3])
        cross, angle = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]), np.deg2rad(values[3])
        placement[:3, :3] += np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross
    return placement


def _numbers(element: ET.Element) -> Array:
    return np.array((element.text or "").split(), dtype=np.float64)
