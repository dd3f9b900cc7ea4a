"""A page sees what is drawn while it begins to wait."""

from __future__ import annotations

from threading import Thread

from websockets.sync.client import connect

from server.viewer.scene import open_server
from tests.server.viewer.test_routes import VISER, inside


def test_a_page_that_begins_to_wait_while_something_is_drawn_sees_it():
    server = open_server()
    event = server._websock_server._broadcast_buffer.message_event
    find_loop, drawn = event._get_loop, []

    def draw_meanwhile():  # asked for between the look at the event's value and the wait for it
        if server.scene._handle_from_node_name.get("/first") is not None and not drawn:
            drawn.append("/second")
            drawing = Thread(target=server.scene.add_frame, args=("/second",))
            drawing.start()
            drawing.join()
        return find_loop()

    event._get_loop = draw_meanwhile
    try:
        with connect(f"ws://127.0.0.1:{server.get_port()}", subprotocols=[VISER], max_size=None, compression=None) as live:
            live.recv(timeout=20)
            server.scene.add_frame("/first")
            shown = b""
            while b"/second" not in shown:
                shown = inside(live.recv(timeout=20))
        assert drawn
    finally:
        server.stop()
