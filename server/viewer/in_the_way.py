"""What is in the way of a run stands out in the scene: by colour, by its edges, and by a sign with its name."""

from __future__ import annotations

import numpy as np
import viser

from core.array import Array
from core.cell.cell import Cell, Obstacle, Zone
from core.report.faces import Faces, shape_faces
from server.viewer.scene import INK, Colour, add_body

ABNORMAL: Colour = (255, 210, 31)
"""The console's yellow."""
ROOT = "/in_the_way"
SIGN = "▲"
"""As the console has it before the same name, in every language."""
EDGE_M, SWOLLEN = 0.012, 1.01
"""Thickness of the edges; the body is drawn a little larger than the one that it lies about."""


class Mark:
    """Over one scene.

    Args:
        cell: whose obstacles and zones can be in the way.
    """

    def __init__(self, server: viser.ViserServer, cell: Cell) -> None:
        self._scene, self._cell = server.scene, cell
        self._looked_at = np.array(server.initial_camera.look_at)
        self._name: str | None = None

    def show(self, name: str | None) -> None:
        """Marks this obstacle, zone or link, of which there is the sign alone; None leaves everything plain."""
        self._name = name
        self._scene.remove_by_name(ROOT)
        if name is None:
            return
        things: tuple[Obstacle | Zone, ...] = (*self._cell.obstacles, *self._cell.zones)
        thing = next((it for it in things if it.name == name), None)
        sign = self._looked_at
        if thing is not None:
            faces = shape_faces(thing.shape)
            add_body(self._scene, f"{ROOT}/body", swell(faces), ABNORMAL, 0.5)
            self._scene.add_line_segments(f"{ROOT}/edges", edges(faces), INK, thickness=EDGE_M)
            sign = nearest_to(faces, sign)
        self._scene.add_label(f"{ROOT}/label", f"{SIGN} {name}", position=tuple(sign), anchor="bottom-center", font_screen_scale=1.5)

    def update_zones(self, cell: Cell) -> None:
        """Its zones are somewhere else now."""
        self._cell = cell
        self.show(self._name)


def edges(faces: Faces) -> Array:
    """The edges of flat faces as segments (k, 2, 3), each once."""
    both = np.concatenate([np.stack([face, np.roll(face, -1, axis=0)], axis=1) for face in faces])
    once = {tuple(sorted(map(tuple, np.round(edge, 9)))): edge for edge in both}
    return np.array(list(once.values()))


def swell(faces: Faces) -> Faces:
    """Faces a little further from their middle, so that they hide what they lie about."""
    middle = np.concatenate(faces).mean(axis=0)
    return [middle + SWOLLEN * (face - middle) for face in faces]


def nearest_to(faces: Faces, point: Array) -> Array:
    """Where the box around a body is nearest to a point (3,): seen by whoever looks there, however large the body is."""
    corners = np.concatenate(faces)
    return np.clip(point, corners.min(axis=0), corners.max(axis=0))
