"""What a page wants to see in a way of its own is drawn for it alone: two pages of one viewer, as viser's client speaks."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import msgspec
import numpy as np
import pytest
from viser import ClientHandle
from viser import _messages as messages
from websockets.sync.client import ClientConnection, connect

from core.cell.cell import Box, Pose
from core.cell.folder import load_cell
from server.viewer.scene import ViewerScene, open_server
from server.viewer.views import FADED, Views
from server.viewer.wish import Wish
from tests.server.real_service import ROOT, wait_for

VISER = "viser-v1.1.1"
BOX = Box(size_m=(0.1, 0.1, 0.9))
OPPOSITE = (-3.0, -3.0, 1.5)


class Page:
    """One connection to the viewer under a name.

    Args:
        views, server: what draws for it.
    """

    def __init__(self, server: Any, views: Views, name: str) -> None:
        self._server, self._views, self.name = server, views, name
        self._line: ClientConnection = connect(f"ws://127.0.0.1:{server.get_port()}/{name}", subprotocols=[VISER], max_size=None)
        self.first = tuple(server.initial_camera.position)
        self.stand(self.first, tuple(server.initial_camera.look_at))
        wait_for(lambda: views._views.get(name) and views._views[name].eyes, "the page to be known")

    @property
    def client(self) -> ClientHandle:
        return next(iter(self._views._views[self.name].eyes.values()))._client

    @property
    def drawn(self) -> dict[str, Any]:
        """For this page alone, by name."""
        return dict(self.client.scene._handle_from_node_name)

    def stand(self, position: tuple[float, float, float], look_at: tuple[float, float, float] = (0.0, 0.0, 0.5)) -> None:
        """Says where its camera is, as viser's page does."""
        said = messages.ViewerCameraMessage(
            wxyz=(1.0, 0.0, 0.0, 0.0), position=tuple(map(float, position)), fov=0.8, near=0.01, far=100.0,
            image_height=600, image_width=800, look_at=tuple(map(float, look_at)), up_direction=(0.0, 0.0, 1.0),
        )  # fmt: skip
        self._line.send(msgspec.msgpack.encode({"type": "ViewerCameraMessage", **vars(said)}))

    def leave(self) -> None:
        self._line.close()
        wait_for(lambda: not self._views._views[self.name].eyes, "the page to be gone")


@pytest.fixture
def open_page() -> Iterator[tuple[Callable[[str], Page], Views, ViewerScene]]:
    server = open_server()
    scene = ViewerScene(server, load_cell(ROOT / "cells" / "lwr4_bench"))
    views = Views(server, scene)
    yield lambda name: Page(server, views, name), views, scene
    server.stop()


def test_a_box_that_is_typed_is_drawn_for_the_page_where_it_is_typed_and_for_no_other(open_page):
    page, views, _ = open_page
    one, other = page("one"), page("other")
    views.update("one", Wish(payload_box=BOX), None)
    corners = one.drawn["/robot/7/payload"].vertices
    assert np.ptp(corners, axis=0).max() == pytest.approx(0.9, abs=1e-6)
    assert "/robot/7/payload" not in other.drawn
    views.update("one", Wish(), None)
    assert "/robot/7/payload" not in one.drawn


def test_a_zone_that_is_being_changed_is_drawn_for_the_page_that_changes_it_and_stays_while_the_robot_moves(open_page):
    page, views, _ = open_page
    one, other = page("one"), page("other")
    zone = Box(size_m=(0.4, 0.4, 1.0), pose=Pose(xyz_m=(1.0, 1.0, 0.5)))
    views.update("one", Wish(zone=zone), None)
    np.testing.assert_allclose(one.drawn["/drawn_zone/body"].vertices.mean(axis=0), (1.0, 1.0, 0.5), atol=1e-6)
    assert not [name for name in other.drawn if name.startswith("/drawn_zone")]
    views.forget_plans()
    assert "/drawn_zone/body" in one.drawn
    views.update("one", Wish(), None)
    assert not [name for name in one.drawn if name.startswith("/drawn_zone")]


def test_the_planned_robot_goes_where_it_is_asked_and_is_gone_when_the_real_one_moves(open_page):
    page, views, scene = open_page
    one = page("one")
    home = tuple(scene.cell.robot.home_rad)
    views.update("one", Wish(q_rad=home), None)
    at_home = np.array(one.drawn["/planned/7"].position)
    views.update("one", Wish(q_rad=(home[0] + 1.0, *home[1:])), None)
    assert np.linalg.norm(np.array(one.drawn["/planned/7"].position) - at_home) > 0.1
    views.update("one", Wish(q_rad=home[:3]), None)
    assert not [name for name in one.drawn if name.startswith("/planned")], "joints of another robot are drawn nowhere"
    views.update("one", Wish(q_rad=home), None)
    views.forget_plans()
    assert not [name for name in one.drawn if name.startswith("/planned")]


def test_what_stands_between_the_camera_and_the_robot_is_see_through_for_that_camera(open_page):
    page, _, _ = open_page
    one, other = page("one"), page("other")
    one.stand(OPPOSITE)
    wait_for(lambda: [name for name in one.drawn if name.startswith("/obstacles/")], "a wall to be see-through")
    walls = {name: body for name, body in one.drawn.items() if name.startswith("/obstacles/")}
    assert all(body.opacity == FADED for body in walls.values())
    assert not walls.keys() & other.drawn.keys()
    one.stand(one.first, tuple(one._server.initial_camera.look_at))
    wait_for(lambda: not walls.keys() & one.drawn.keys(), "the wall to be as it is again")


def test_one_persons_button_turns_no_other_camera_and_a_page_that_comes_back_has_its_own_again(open_page):
    page, views, _ = open_page
    one, other = page("one"), page("other")
    before = np.array(other.client.camera.position)
    views.update("one", Wish(), "top")
    turned = np.array(one.client.camera.position)
    above = turned - np.array(one.client.camera.look_at)
    assert above[2] / np.linalg.norm(above) > 0.99
    np.testing.assert_array_equal(other.client.camera.position, before)
    one.stand(tuple(turned))
    wait_for(lambda: views._views["one"].camera is not None, "the camera to be kept")
    one.leave()
    again = page("one")
    np.testing.assert_allclose(again.client.camera.position, turned, atol=1e-6)
