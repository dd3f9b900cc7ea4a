"""What each page sees in a way of its own: its camera, the box that is typed there, the planned robot, and through what it looks."""

from __future__ import annotations

import threading
from collections import OrderedDict
from dataclasses import dataclass, field, replace

import numpy as np
import viser

from core.array import Array
from core.cell.cell import Box
from core.payload.shapes import Shape
from core.report.faces import Faces, shape_faces
from server.viewer.first_look import find_eye, find_occluded
from server.viewer.in_the_way import EDGE_M, edges
from server.viewer.scene import LOAD, LOAD_OPACITY, PATH, ViewerScene, add_body
from server.viewer.wish import Look, Wish

MOST = 64
"""Pages whose cameras are kept, those that looked last."""
SEEN_THROUGH, SEEN_AGAIN = 0.12, 0.05
"""Shares of the arm behind a thing: from the first on it is drawn see-through, below the second as it is again."""
FADED = 0.13
"""Opacity of what is seen through."""
PLANNED = "/planned"
PLANNED_OPACITY = 0.75
DRAWN_ZONE = "/drawn_zone"
DRAWN_OPACITY = 0.3
NEAREST_M, FARTHEST = 0.25, 6.0
"""How near the camera may come, and how far it may go, times the distance at which everything is seen."""


@dataclass
class View:
    """One page, also while it is not connected.

    Args:
        camera: position and what it looks at, (3,) each, where it has been moved.
    """

    wish: Wish = field(default_factory=Wish)
    camera: tuple[Array, Array] | None = None
    eyes: dict[int, Eye] = field(default_factory=dict)


class Views:
    """All pages that look at one scene."""

    def __init__(self, server: viser.ViserServer, scene: ViewerScene) -> None:
        self._server, self._scene = server, scene
        self._first = np.array(server.initial_camera.position) - np.array(server.initial_camera.look_at)
        self._views: OrderedDict[str, View] = OrderedDict()
        self._lock = threading.RLock()
        server.on_client_connect(self._join)
        server.on_client_disconnect(self._leave)

    def update(self, name: str, wish: Wish, look: Look | None) -> None:
        """A page wants to see this from now on, and from there, once."""
        with self._lock:
            view = self._view(name)
            view.wish = wish
            for eye in view.eyes.values():
                eye.draw(wish)
                if look is not None:
                    eye.look(look, self._first)

    def forget_plans(self) -> None:
        """The robot moves: nobody is shown any more where it would be."""
        with self._lock:
            for view in self._views.values():
                if view.wish.q_rad is not None:
                    view.wish = replace(view.wish, q_rad=None)
                    for eye in view.eyes.values():
                        eye.draw(view.wish)

    def refresh(self) -> None:
        """Robot, box or zones are somewhere else: what stands before the arm now?"""
        with self._lock:
            for view in self._views.values():
                for eye in view.eyes.values():
                    eye.see_through()

    def _view(self, name: str) -> View:
        self._views[name] = view = self._views.pop(name, None) or View()
        while len(self._views) > MOST:
            self._views.popitem(last=False)
        return view

    def _join(self, client: viser.ClientHandle) -> None:
        name = find_name(self._server, client)
        with self._lock:
            view = self._view(name)
            eye = view.eyes[client.client_id] = Eye(client, self._scene)
            if view.camera is not None:
                eye.put(*view.camera)
            eye.draw(view.wish)

        def moved(camera: viser.CameraHandle) -> None:
            with self._lock:
                view.camera = (np.array(camera.position), np.array(camera.look_at))
                eye.see_through()

        client.camera.on_update(moved)

    def _leave(self, client: viser.ClientHandle) -> None:
        with self._lock:
            for view in self._views.values():
                view.eyes.pop(client.client_id, None)


class Eye:
    """One connection of a page."""

    def __init__(self, client: viser.ClientHandle, scene: ViewerScene) -> None:
        self._client, self._scene = client, scene
        self._wish = Wish()
        self._frames: list[viser.FrameHandle] = []
        self._faded: dict[str, Faces] = {}

    def draw(self, wish: Wish) -> None:
        """The box, the zone and the planned robot that are wanted, for this page alone."""
        before, self._wish = self._wish, wish
        if wish.payload_box != before.payload_box:
            self._draw_box(wish.payload_box)
        if wish.zone != before.zone:
            self._draw_zone(wish.zone)
        if wish.q_rad is None or len(wish.q_rad) != self._scene.robot.n:
            self._client.scene.remove_by_name(PLANNED)
            self._frames = []
        else:
            self._draw_planned(np.array(wish.q_rad))
        self.see_through()

    def look(self, look: Look, first: Array) -> None:
        """Turns the camera, once."""
        camera = self._client.camera
        toward = first if look == "reset" else np.array(camera.position) - np.array(camera.look_at)
        eye, middle = find_eye(self._scene.cell, look, self._scene.find_room(self._box), camera.aspect, toward)
        self.put(eye, middle)
        distance = float(np.linalg.norm(eye - middle))
        camera.max_orbit_distance, camera.min_orbit_distance = FARTHEST * distance, NEAREST_M

    def put(self, position: Array, look_at: Array) -> None:
        """The camera is there from now on."""
        with self._client.atomic():
            self._client.camera.position = position
            self._client.camera.look_at = look_at
            self._client.camera.up_direction = np.array([0.0, 0.0, 1.0])

    def see_through(self) -> None:
        """What hides the arm from this camera is drawn so that the arm is seen through it."""
        for gone in self._faded.keys() - {thing.node for thing in self._scene.things}:
            self._client.scene.remove_by_name(gone)
            del self._faded[gone]
        eye, points = np.array(self._client.camera.position), self._points()
        for thing in self._scene.things:
            hidden = float(find_occluded(thing.faces, eye, points).mean())
            faded = self._faded.get(thing.node) is thing.faces
            if hidden > SEEN_THROUGH and not faded:
                add_body(self._client.scene, thing.node, thing.faces, thing.colour, FADED)
                self._faded[thing.node] = thing.faces
            elif hidden < SEEN_AGAIN and thing.node in self._faded:
                self._client.scene.remove_by_name(thing.node)
                del self._faded[thing.node]

    @property
    def _box(self) -> Box:
        return self._wish.payload_box or self._scene.payload_box

    def _points(self) -> Array:
        """Of the robot, and of the planned one where it is drawn."""
        here = self._scene.find_points()
        return here if not self._frames else np.concatenate([here, self._scene.find_points(np.array(self._wish.q_rad))])

    def _draw_box(self, box: Box | None) -> None:
        node = f"{self._scene.last_joint}/payload"
        if box is None:
            self._client.scene.remove_by_name(node)
        else:
            add_body(self._client.scene, node, self._scene.carry(box), LOAD, LOAD_OPACITY)

    def _draw_zone(self, zone: Shape | None) -> None:
        self._client.scene.remove_by_name(DRAWN_ZONE)
        if zone is not None:
            faces = shape_faces(zone)
            add_body(self._client.scene, f"{DRAWN_ZONE}/body", faces, PATH, DRAWN_OPACITY)
            self._client.scene.add_line_segments(f"{DRAWN_ZONE}/edges", edges(faces), PATH, thickness=EDGE_M)

    def _draw_planned(self, q: Array) -> None:
        with self._client.atomic():
            if not self._frames:
                self._frames = self._scene.draw_arm(self._client.scene, PLANNED, PATH, PLANNED_OPACITY)
                carried = f"{PLANNED}/{self._scene.robot.n}/payload"
                add_body(self._client.scene, carried, self._scene.carry(self._box), LOAD, LOAD_OPACITY)
            self._scene.place(self._frames, q)


def find_name(server: viser.ViserServer, client: viser.ClientHandle) -> str:
    """What a page calls its view: the last piece of the address over which it came; empty where it has none."""
    connection = server._websock_server._live_connections.get(client.client_id)
    request = None if connection is None else connection.request
    return "" if request is None else request.path.partition("?")[0].strip("/")
