"""The viewer is reached through the service alone, and shows without commanding."""

from __future__ import annotations

import ast
import inspect
import socket
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import httpx2 as httpx
import numpy as np
import pytest
import zstandard
from viser import _messages as messages
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import ClientConnection, connect

from core.cell.cell import Obstacle, Pose, Sphere, Zone
from core.cell.folder import load_cell
from core.report.faces import box_faces
from server.viewer import scene
from server.viewer.in_the_way import Mark, edges
from server.viewer.scene import ViewerScene, open_server, triangles_of
from tests.server.real_service import ROOT, Console, RealService
from tests.server.zone_at import AT_THE_ROBOT, zone_at

VISER = "viser-v1.1.1"


def test_the_viewer_comes_through_the_service_for_who_is_signed_in_and_nobody_else(real: RealService):
    service = real
    log = service.data.parent / "service.log"
    before = len(log.read_text())
    console = Console(service)
    page = console.http.get("/viewer/lwr4_bench/", timeout=60)
    assert page.status_code == 200
    assert "<html" in page.text.lower()
    kept = console.http.get("/viewer/lwr4_bench/some_view/", headers={"If-None-Match": page.headers["etag"]})
    assert kept.status_code == 304, "the same page for every view; what the browser has is not sent again"
    with console.socket("/viewer/lwr4_bench", subprotocols=[VISER], max_size=None) as live:
        assert live.subprotocol == VISER
        drawn = 0
        while drawn < 3_000:  # compressed; an empty scene is some hundred bytes
            drawn += len(live.recv(timeout=20))
    assert httpx.get(f"http://{service.address}/viewer/lwr4_bench/").status_code == 401
    with pytest.raises(InvalidStatus), connect(f"ws://{service.address}/viewer/lwr4_bench", subprotocols=[VISER]):
        pass
    cookies = "; ".join(f"{name}={value}" for name, value in console.http.cookies.items())
    foreign = {"Cookie": cookies, "Origin": "http://elsewhere.example"}
    with pytest.raises(InvalidStatus), connect(f"ws://{service.address}/viewer/lwr4_bench", additional_headers=foreign):
        pass
    assert console.http.get("/viewer/no_such_cell/").status_code == 404
    console.leave()
    assert "Exception in ASGI application" not in log.read_text()[before:], "who is refused has been answered once"


def test_what_is_in_the_way_of_a_refused_run_gets_a_sign(real: RealService):
    person = Console(real)
    with zone_at(person, AT_THE_ROBOT) as zone, person.socket("/viewer/lwr4_bench", subprotocols=[VISER], max_size=None) as live:
        run = person.queue()
        assert person.wait(run, "Stopped")["in_the_way"] == zone
        shown = b""
        while f"▲ {zone}".encode() not in shown:
            shown = inside(live.recv(timeout=20))
    person.leave()


def test_a_cell_is_drawn_wherever_its_zones_are_and_drawn_anew_when_something_else_stands_in_it(real: RealService):
    person = Console(real)
    file = real.data / "cells" / "lwr4_bench" / "cell.toml"
    sound = file.read_text()
    with zone_at(person, (0.0, 0.0, 0.0)):
        assert person.http.get("/api/cells/lwr4_bench").json()["flaws"]
        assert person.http.get("/viewer/lwr4_bench/", timeout=60).status_code == 200
        with person.socket("/viewer/lwr4_bench", subprotocols=[VISER], max_size=None) as live:
            live.recv(timeout=20)
            file.write_text(sound.replace('name = "fixture"', 'name = "fixture_of_today"', 1))
            wait_until_closed(live)
        with person.socket("/viewer/lwr4_bench", subprotocols=[VISER], max_size=None) as live:
            try:
                shown = b""
                while b"fixture_of_today" not in shown:
                    shown = inside(live.recv(timeout=60))
            finally:
                file.write_text(sound)
            wait_until_closed(live)  # the next test is not to look at a viewer that is about to end
    person.leave()


def wait_until_closed(live: ClientConnection) -> None:
    """Fails where nothing comes and nothing ends."""
    with pytest.raises(ConnectionClosed):
        while True:
            live.recv(timeout=20)


def inside(message: str | bytes) -> bytes:
    """What a message of viser holds; as it is where it is not compressed."""
    assert isinstance(message, bytes)
    begin = message.find(zstandard.FRAME_HEADER)
    return message if begin < 0 else zstandard.ZstdDecompressor().decompressobj().decompress(message[begin:])


def test_it_listens_on_the_loopback_only_and_cannot_be_asked_for_a_public_tunnel():
    server = open_server()
    try:
        assert server.get_host() == "127.0.0.1"
        handlers = server._websock_server._incoming_handlers
        assert messages.ShareUrlRequest not in handlers
        assert messages.ShareUrlDisconnect not in handlers
        own = socket.gethostbyname(socket.gethostname())
        if not own.startswith("127."):
            with pytest.raises(OSError), socket.create_connection((own, server.get_port()), timeout=1):
                pass
        shown = ViewerScene(server, load_cell(ROOT / "cells" / "lwr4_bench"))
        shown.move(np.array(shown.cell.robot.home_rad) + 0.1, None)
    finally:
        server.stop()


def test_the_viewer_knows_no_way_to_a_robot():
    imported = {
        node.module or ""
        for file in Path(inspect.getfile(scene)).parent.glob("*.py")
        for node in ast.walk(ast.parse(file.read_text()))
        if isinstance(node, ast.ImportFrom)
    }
    assert not any(name.startswith(("core.sessions", "core.control", "core.procedure.identify")) for name in imported)


def test_the_triangles_of_a_box_enclose_its_volume():
    corners, triangles = triangles_of(box_faces(np.array([0.1, 0.2, 0.3])))
    a, b, c = (corners[triangles[:, k]] for k in range(3))
    assert np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6 == pytest.approx(0.1 * 0.2 * 0.3)


@pytest.fixture
def drawn() -> Iterator[tuple[Mark, ViewerScene, Callable[[], dict[str, Any]]]]:
    """A mark over a drawn cell, and what stands in the scene, by name."""
    server = open_server()
    scene = ViewerScene(server, load_cell(ROOT / "cells" / "lwr4_bench"))
    yield Mark(server, scene), scene, lambda: dict(server.scene._handle_from_node_name)
    server.stop()


def test_what_is_in_the_way_stands_out_by_colour_edges_and_name_and_is_plain_again_afterwards(drawn):
    mark, _, shown = drawn
    plain = shown()
    cell = load_cell(ROOT / "cells" / "lwr4_bench")
    for thing in (cell.obstacles[0], cell.zones[0]):
        mark.show(thing.name)
        now = shown()
        assert now["/in_the_way/body"].color != plain[name_of(thing)].color
        assert now["/in_the_way/label"].text == f"▲ {thing.name}"
        np.testing.assert_allclose(now["/in_the_way/edges"].points.mean(axis=(0, 1)), thing.shape.pose.xyz_m, atol=1e-6)
        assert [name for name in plain if name.startswith(("/obstacles/", "/zones/")) and not now[name].visible] == [name_of(thing)]
    mark.show(None)
    assert shown().keys() == plain.keys()
    assert all(shown()[name].visible for name in plain if name.startswith(("/obstacles/", "/zones/")))


def name_of(thing: Obstacle | Zone) -> str:
    """In the scene."""
    return f"/{'zones' if isinstance(thing, Zone) else 'obstacles'}/{thing.name}"


def test_a_zone_that_is_in_the_way_is_marked_where_it_is_now(drawn):
    mark, scene, shown = drawn
    cell = load_cell(ROOT / "cells" / "lwr4_bench")
    zone, moved = cell.zones[0], Pose(xyz_m=(1.0, 2.0, 3.0))
    mark.show(zone.name)
    elsewhere = zone.model_copy(update={"shape": zone.shape.model_copy(update={"pose": moved})})
    scene.show_zones(cell.model_copy(update={"zones": (elsewhere, *cell.zones[1:])}))
    mark.update_zones()
    np.testing.assert_allclose(shown()["/in_the_way/edges"].points.mean(axis=(0, 1)), moved.xyz_m, atol=1e-6)


def test_zones_that_come_grow_and_go_are_drawn_so_also_while_one_is_marked(drawn):
    mark, scene, shown = drawn
    plain, cell = shown(), scene.cell
    larger = cell.with_zone("trolley", Sphere(kind="sphere", radius_m=0.4)).with_zone(cell.zones[0].name, None)
    for now, names in (
        (cell.with_zone("trolley", Sphere(kind="sphere", radius_m=0.2)), {"/zones/operator", "/zones/trolley"}),
        (larger, {"/zones/trolley"}),
    ):
        scene.show_zones(now)
        mark.show("trolley")
        assert {name for name in shown() if name.startswith("/zones/")} == names
        assert {thing.node for thing in scene.things if thing.node.startswith("/zones/")} == names
    assert np.abs(shown()["/zones/trolley"].vertices).max() == pytest.approx(0.4, rel=0.1)
    scene.show_zones(cell)
    mark.show(None)
    assert shown().keys() == plain.keys()


def test_a_link_that_is_in_the_way_is_marked_where_it_moves_with_its_joint(drawn):
    mark, _, shown = drawn
    plain = shown()
    mark.show("link5")
    added = shown().keys() - plain.keys()
    assert shown()["/in_the_way/label"].text == "▲ link5"
    assert [name for name in added if name.startswith("/robot/5/in_the_way/body")]
    mark.show("payload")
    assert shown().keys() - plain.keys() == {"/in_the_way", "/in_the_way/label"}
    mark.show(None)
    assert shown().keys() == plain.keys()


def test_each_edge_of_a_box_is_drawn_once():
    segments = edges(box_faces(np.array([0.1, 0.2, 0.3])))
    assert sorted(np.round(np.linalg.norm(segments[:, 1] - segments[:, 0], axis=1), 6)) == [0.1] * 4 + [0.2] * 4 + [0.3] * 4
