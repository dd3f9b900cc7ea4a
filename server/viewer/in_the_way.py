"""What is in the way of a run stands out in the scene: by colour, by its edges, and by a sign with its name."""

from __future__ import annotations

from itertools import chain

import numpy as np
import viser

from core.array import Array
from core.cell.cell import Obstacle, Zone
from core.report.faces import Faces, link_parts, standing_faces
from server.viewer.scene import INK, Colour, ViewerScene, add_body

ABNORMAL: Colour = (255, 210, 31)
"""The console's yellow."""
ROOT = "/in_the_way"
OF_LINK = "/robot/{joint}/in_the_way"
SIGN = "▲"
"""As the console has it before the same name, in every language."""
EDGE_M, SWOLLEN = 0.012, 1.01
"""Thickness of the edges; the body is drawn a little larger than the one that it lies about."""
OPACITY = 0.4
"""Of the body: what reaches into it is seen in it."""
LINK_OPACITY = 0.85


class Mark:
    """Over one scene."""

    def __init__(self, server: viser.ViserServer, scene: ViewerScene) -> None:
        self._nodes, self._scene = server.scene, scene
        self._looked_at = np.array(server.initial_camera.look_at)
        self._name: str | None = None
        self._drawn: list[str] = []
        self._hidden: str | None = None

    def show(self, name: str | None) -> None:
        """Marks this obstacle, zone or link; of anything else there is the sign alone. None leaves everything plain."""
        self._name = name
        for node in self._drawn:
            self._nodes.remove_by_name(node)
        self._drawn = []
        self._hide(None)
        if name is None:
            return
        thing = next((it for it in self._scene.cell.standing if it.name == name), None)
        self._drawn.append(ROOT)
        sign = self._show_thing(thing) if thing is not None else self._show_link(name)
        self._nodes.add_label(f"{ROOT}/label", f"{SIGN} {name}", position=tuple(sign), anchor="bottom-center", font_screen_scale=1.5)

    def update_zones(self) -> None:
        """The zones are somewhere else now."""
        self.show(self._name)

    def _show_thing(self, thing: Obstacle | Zone) -> Array:
        """Body and edges in place of what is plain there; where its sign stands."""
        parts = standing_faces(self._scene.cell)[thing.name]
        faces = [*chain.from_iterable(parts)]
        self._hide(f"/{'zones' if isinstance(thing, Zone) else 'obstacles'}/{thing.name}")
        add_body(self._nodes, f"{ROOT}/body", [*chain.from_iterable(map(swell, parts))], ABNORMAL, OPACITY)
        self._nodes.add_line_segments(f"{ROOT}/edges", edges(faces), INK, thickness=EDGE_M)
        return nearest_to(faces, self._scene.find_box_corners(self._scene.payload_box).mean(axis=0))

    def _show_link(self, name: str) -> Array:
        """The link's bodies, which go with it; where its sign stands."""
        for joint, faces in link_parts(self._scene.cell, self._scene.robot, name):
            node = OF_LINK.format(joint=joint)
            add_body(self._nodes, f"{node}/body{len(self._drawn)}", swell(faces), ABNORMAL, LINK_OPACITY)
            self._drawn.append(node)
        return self._looked_at

    def _hide(self, node: str | None) -> None:
        """What is drawn plainly under this name is not seen, and what was hidden before is seen again."""
        if self._hidden is not None:
            self._scene.set_visible(self._hidden, visible=True)
        if node is not None:
            self._scene.set_visible(node, visible=False)
        self._hidden = node


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
