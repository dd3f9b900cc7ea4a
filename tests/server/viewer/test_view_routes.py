"""Who is signed in says what their page shows; a picture that nobody draws yet has it when somebody does."""

from __future__ import annotations

from tests.server.real_service import Console, RealService
from tests.server.viewer.test_routes import VISER, inside

BOX = {"kind": "box", "size_m": [0.12, 0.13, 0.5], "pose": {"xyz_m": [0.0, 0.0, 0.25]}}


def test_a_wish_is_taken_for_a_cell_that_is_there_and_refused_where_it_makes_no_sense(real: RealService):
    person = Console(real)

    def ask(cell: str = "lwr4_bench", view: str = "v1", **wish: object) -> int:
        return person.http.put(f"/api/cells/{cell}/views/{view}", json=wish).status_code

    assert ask(payload_box=BOX, look="top") == 204
    assert ask(cell="no_such_cell") == 404
    assert ask(look="sideways") == 422
    assert ask(q_rad=[]) == 422
    assert ask(payload_box=BOX | {"size_m": [0.1, 0.1, -1.0]}) == 422
    assert ask(view="not a name") == 422
    person.http.headers.pop("X-CSRF-Token")
    assert ask(look="fit") == 403
    person.leave()


def test_the_previous_plan_vanishes_with_a_refused_box_which_is_drawn_where_the_robot_starts(real: RealService):
    person = Console(real)
    person.take_control()
    with person.socket("/viewer/lwr4_bench/watching", subprotocols=[VISER], max_size=None) as live:

        def until(sign: bytes) -> bytes:
            shown = b""
            while sign not in shown:
                shown = inside(live.recv(timeout=60))
            return shown

        first = person.queue()
        person.wait(first, "Idle")
        until(b"/plan/path")
        person.command(first, "stop")
        person.wait(first, "Stopped")
        refused = person.queue(payload_box=BOX | {"size_m": [0.12, 0.13, 0.9], "pose": {"xyz_m": [0.0, 0.0, 0.45]}})
        told = until("▲ bench".encode())
        answer = person.wait(refused, "Stopped")
        assert (answer["reason_kind"], answer["in_the_way"]) == ("no-room-at-home", "bench")
        assert answer["reason"]["code"] == "robot-box-inside-at-home"
        assert 'The tool\'s box reaches 0.50 m into obstacle "bench" at home' in answer["reason"]["text"]
        assert b"/plan/path" not in told
    with person.socket("/viewer/lwr4_bench/later", subprotocols=[VISER], max_size=None) as live:
        drawn = inside(live.recv(timeout=60))
        assert b"/obstacles/bench" in drawn
        assert b"/plan/path" not in drawn, "whoever looks later sees no plan of an earlier run"
    person.leave()
