"""Meshes as files hold them, sound and broken."""

from __future__ import annotations

import struct

import numpy as np
import trimesh

from core.array import Array

TETRAHEDRON = np.array([[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]])[
    np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
]
"""(4, 3, 3), corners of its triangles, m."""


def binary_stl(corners: Array) -> bytes:
    rows = np.zeros((len(corners), 12), dtype="<f4")
    rows[:, 3:] = corners.reshape(-1, 9)
    return bytes(80) + struct.pack("<I", len(corners)) + b"".join(row.tobytes() + b"\0\0" for row in rows)


def ascii_stl(corners: Array, number: str = "{:.9g}") -> bytes:
    lines = ["solid x"]
    for triangle in corners:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex " + " ".join(number.format(x) for x in corner) for corner in triangle]
        lines += ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid x"]).encode()


def dae(nodes: str, unit: str = "1", more: str = "", floats: str | None = None, faces: str = "0 2 1 0 1 3 0 3 2 1 2 3") -> bytes:
    """A tetrahedron with legs of 0.1 units, called #body, in a scene of those nodes."""
    floats = floats or "0 0 0 0.1 0 0 0 0.1 0 0 0 0.1"
    return f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><created>2020-01-01T00:00:00</created><modified>2020-01-01T00:00:00</modified><unit name="u" meter="{unit}"/></asset>
<library_geometries><geometry id="body"><mesh>
<source id="p"><float_array id="pa" count="12">{floats}</float_array><technique_common><accessor source="#pa" count="4" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>{faces}</p></triangles>
</mesh></geometry></library_geometries>{more}
<library_visual_scenes><visual_scene id="s">{nodes}</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>""".encode()


BODY = '<node id="n"><instance_geometry url="#body"/></node>'


def _bomb() -> bytes:
    """Each node holds the next one ten times: 10^12 tetrahedra."""
    nodes = ""
    for k in range(12):
        inside = f'<instance_node url="#b{k + 1}"/>' * 10 if k < 11 else '<instance_geometry url="#body"/>' * 10
        nodes += f'<node id="b{k}">{inside}</node>'
    return dae('<node id="n"><instance_node url="#b0"/></node>', more=f"<library_nodes>{nodes}</library_nodes>")


def _entities() -> bytes:
    laughs = "".join(f'<!ENTITY l{k} "{f"&l{k - 1};" * 10}">' for k in range(1, 10))
    declared = f'<!DOCTYPE COLLADA [<!ENTITY l0 "0 0 0 ">{laughs}]>'
    return dae(BODY, floats="&l9;").replace(b"<COLLADA", declared.encode() + b"<COLLADA", 1)


def _infinite(value: float) -> bytes:
    corners = TETRAHEDRON.copy()
    corners[1, 2, 2] = value
    return binary_stl(corners)


FLAT = TETRAHEDRON * [1.0, 1.0, 0.0]
LIAR = bytes(80) + struct.pack("<I", 2**32 - 1) + bytes(100)

BAD: dict[str, tuple[str, bytes, str, str]] = {
    "flat": ("hand.stl", binary_stl(FLAT), "1 1 1", r"vertices in one plane, 0\.1 x 0\.1 x 0 m"),
    "NaN": ("hand.stl", _infinite(np.nan), "1 1 1", "a vertex that is no number"),
    "infinite": ("hand.stl", _infinite(np.inf), "1 1 1", "a vertex that is no number"),
    "NaN in words": ("hand.stl", ascii_stl(TETRAHEDRON * np.nan), "1 1 1", "a vertex that is no number"),
    "scale zero": ("hand.stl", binary_stl(TETRAHEDRON), "1 0 1", "the scale 1 0 1, expected positive"),
    "scale negative": ("hand.stl", binary_stl(TETRAHEDRON), "-1 1 1", "the scale -1 1 1, expected positive"),
    "garbage": ("hand.stl", bytes(np.random.default_rng(1).integers(0, 256, 5000, dtype=np.uint8)), "1 1 1", "breaks off at 5000 bytes"),
    "garbage that says it is text": ("hand.stl", b"solid " + b"vertex a b c\n" * 30, "1 1 1", "cannot be read"),
    "empty": ("hand.stl", b"", "1 1 1", "an empty file"),
    "no triangle": ("hand.stl", binary_stl(TETRAHEDRON[:0]), "1 1 1", "no triangle"),
    "one triangle": ("hand.stl", binary_stl(TETRAHEDRON[:1]), "1 1 1", "3 vertices in one plane"),
    "one point": ("hand.stl", binary_stl(TETRAHEDRON * 0.0), "1 1 1", "1 vertex in one plane"),
    "too large": ("hand.stl", binary_stl(TETRAHEDRON), "1000 1000 1000", r"a vertex 100 m from the origin, expected at most 20 m"),
    "too many triangles": ("hand.stl", bytes(80) + struct.pack("<I", 600_000) + bytes(50 * 600_000), "1 1 1", "600000 triangles"),
    "says it is huge": ("hand.stl", LIAR, "1 1 1", "breaks off at 184 bytes"),
    "another kind": ("hand.ply", b"ply", "1 1 1", "a file of the kind '.ply'"),
    "OBJ with a face of nothing": ("hand.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "1 1 1", "a face of vertices that there are not"),
    "OBJ of words": ("hand.obj", b"v a b c\n", "1 1 1", "cannot be read"),
    "DAE that is no XML": ("hand.dae", b"PK\x03\x04 zipped", "1 1 1", "XML that does not parse"),
    "DAE without a scene": ("hand.dae", b"<COLLADA/>", "1 1 1", "no triangle"),
    "DAE that nests nodes": ("hand.dae", _bomb(), "1 1 1", "more than 4000 elements in its scene"),
    "DAE in a ring": ("hand.dae", dae('<node id="n"><instance_node url="#n"/></node>'), "1 1 1", "nested more than 32 deep"),
    "DAE that laughs": ("hand.dae", _entities(), "1 1 1", "the declaration <!DOCTYPE"),
    "DAE with a link to nothing": ("hand.dae", dae('<node><instance_geometry url="file:///etc/passwd"/></node>'), "1 1 1", "a link to"),
    "DAE with NaN": ("hand.dae", dae(BODY, floats="0 0 0 nan 0 0 0 0.1 0 0 0 0.1"), "1 1 1", "a vertex that is no number"),
    "DAE with half a face": ("hand.dae", dae(BODY, faces="0 1"), "1 1 1", "cannot be read"),
}  # fmt: skip
"""File, its content, its scale, and what is said of it."""


def elbow() -> trimesh.Trimesh:
    """Two arms of 0.4 m at a right angle, each 0.05 m thick: its hull takes more than twice its room."""
    outline = np.array([[0, 0], [0.4, 0], [0.4, 0.05], [0.05, 0.05], [0.05, 0.4], [0, 0.4]])
    bottom = np.column_stack([outline, np.zeros(6)])
    top = np.column_stack([outline, np.full(6, 0.05)])
    cap = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]])
    sides = [[k, (k + 1) % 6, 6 + (k + 1) % 6] for k in range(6)] + [[k, 6 + (k + 1) % 6, 6 + k] for k in range(6)]
    return trimesh.Trimesh(np.vstack([bottom, top]), np.vstack([cap[:, ::-1], cap + 6, sides]))
