"""Reads meshes in a process of its own: triangles, and the convex parts that stand for them."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from core.errors import BadRobot
from core.files.confinement import Arrays, Order, answer_orders
from core.robot.convex_parts import convex_parts, hull_points
from core.robot.mesh_file import read_mesh


def read_parts(order: Order) -> Arrays:
    """Vertices (k, 3), m, triangles (m, 3), and the corners of each convex part.

    Args:
        order: `file`, `scale` (3,), `where`, and whether it is `solid`: what is only looked at is one hull, and none where it is flat.

    Raises:
        BadRobot: the file cannot be read, or has no room in it and should.
    """
    file, where = Path(order["file"]), str(order["where"])
    try:
        content = file.read_bytes()
    except OSError as error:
        raise BadRobot(where, "files-unreadable", reason=str(error.strerror)) from error
    vertices, triangles = read_mesh(content, file.name, np.array(order["scale"]), where)
    if not order["solid"]:
        whole = hull_points(vertices)
        return [vertices, triangles] if whole is None else [vertices, triangles, whole]
    parts = convex_parts(vertices, triangles)
    if not parts:
        x_m, y_m, z_m = (float(length) for length in np.ptp(vertices, axis=0))
        raise BadRobot(where, "mesh-flat", vertices=len(vertices), x_m=x_m, y_m=y_m, z_m=z_m)
    return [vertices, triangles, *parts]


if __name__ == "__main__":
    answer_orders(read_parts)
