"""What is wrong with a file, why something was refused and why a robot was stopped stand on the screen in German, word for word."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Browser, FilePayload, Route, expect

from core.cell.folder import load_cell
from core.control.checks import GuardStop, Numbers
from core.control.faults import make_distance_error, make_frozen_error, make_stop_error
from core.errors import BadCell, HeftError, NoStartConfiguration
from core.robot.model import RobotModel
from core.robot.pair_group import Nearest
from core.words.message import Message
from tests.server.hostile_uploads import CELL, HOSTILE, sound, zipped
from tests.server.real_service import Console, RealService
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import show, signed_in
from tests.web.tablet import Tablet

SHOWN = (
    "no zip", "a link to a file", "a zip bomb", "no cell.toml", "robot.urdf absolute", "mesh by http://", "mesh that says it is huge",
    "XInclude", "a negative mass", "a name twice", "a loop of links", "a clearance that is NaN", "a key that nobody knows",
    "a twin with an effect that there is not", "thousands of names twice", "a hundred thousand links",
)  # fmt: skip
CLOSE = Nearest(0.021, 0.03, "payload", "operator", np.zeros(3), np.zeros(3))
CHECK_MS = 60_000
"""Meshes are read within limits of time; on a busy machine those take long."""


def stops_and_refusals() -> list[HeftError]:
    """Every fault of the guard, each kind of thing that it can be too close to, and refusals with their reasons."""
    cell = load_cell(CELL)
    robot = RobotModel.of_cell(cell)
    limits = (robot.lower, robot.upper, robot.velocity, np.ones(robot.n))
    numbers = Numbers(0.001, 0.01, 0.25, 1.0, 0.01, 0.05, 0.1, *limits, np.ones(6), np.ones(robot.n))
    found: list[HeftError] = [
        make_stop_error(fault, 1, 0.4321, cell=cell, robot=robot, owner="payload", numbers=numbers, samples=())
        for fault in GuardStop
        if fault != GuardStop.NONE
    ]
    near = [replace(CLOSE, second=second) for second in ("operator", "bench", "link3")]
    found += [make_distance_error(each, cell, predicted=predicted, samples=()) for each in near for predicted in (False, True)]
    return [
        *found,
        make_frozen_error(0.3, 0.25, ()),
        NoStartConfiguration("x+", {}),
        BadCell("cell.toml: limits.clearance_m", "schema-greater-than", input="-0.1", gt=0.0),
    ]


@pytest.fixture
def german(service: RealService, browser: Browser) -> Iterator[Tablet]:
    with signed_in(service, browser) as at:
        at.page.evaluate("localStorage.setItem('heft.language', 'de')")
        at.page.reload()
        at.wait(".setup .cell-facts")
        yield at


def choose(at: Tablet, name: str, content: bytes) -> None:
    with at.page.expect_file_chooser() as chooser:
        at.press("ZIP-Datei wählen…")
    chooser.value.set_files(FilePayload(name=name, mimeType="application/zip", buffer=content))


@pytest.mark.thorough
def test_the_flaws_of_an_uploaded_cell_are_said_in_german(german: Tablet) -> None:
    page = show(german, "cells")
    german.wait(".cell-upload")
    told = page.locator(".cell-upload .warnings")
    for k, what in enumerate(SHOWN):
        with page.expect_response("**/api/cells/validate", timeout=CHECK_MS) as answer:
            choose(german, f"{k}.zip", HOSTILE[what]())
        expect(told).to_contain_text(f"{k}.zip ist nicht verwendbar", timeout=CHECK_MS)
        for flaw in answer.value.json()["flaws"]:
            message = Message(code=flaw["code"], parameters=flaw["parameters"])
            found, expected = (message.say_part(part, "de") for part in ("found", "expected"))
            expect(told).to_contain_text(f"gefunden: {found}, erwartet: {expected}")
        assert told.locator("[lang=en]").count() == 0, what
    check_looks(look(page, "flaws in German"))
    named = sound() | {"cell.toml": sound()["cell.toml"].replace(b'"lwr4_bench"', b'"one for two"', 1)}
    choose(german, "named.zip", zipped(named))
    expect(told).to_contain_text("one for two")


def test_stops_and_refusals_are_said_in_german_where_a_run_ended(german: Tablet, service: RealService) -> None:
    person = Console(service)
    ended = person.run(person.queue(seed=7))
    person.http.post(f"/api/runs/{ended['run']}/commands", json={"command": "stop"})
    person.leave()
    said = [error.message for error in stops_and_refusals()]
    runs = [
        ended | {"result": None, "reason_kind": "too-close", "run": f"{len(said) - k:03}", "reason": message.model_dump(mode="json")}
        for k, message in enumerate(said)
    ]
    german.page.route("**/api/runs?*", lambda route: route.fulfill(json=runs))
    show(german, "history")
    told = german.page.locator(".run-list .told")
    expect(told).to_have_count(len(said))
    assert told.all_inner_texts() == [message.say("de") for message in said]
    assert told.locator("[lang=en]").count() == 0
    assert "Gelenk joint2" in " ".join(told.all_inner_texts())


def refuse(problem: dict[str, Any], route: Route) -> None:
    route.fulfill(status=409, json=problem)


def test_what_the_service_refuses_is_said_in_german_and_a_sentence_from_outside_as_it_came(german: Tablet) -> None:
    page = german.page
    for message, words, foreign in (
        (Message.of("runs-control-taken", cell="lwr4_bench", holder="anna"), None, 0),
        (Message.of("text", text="Something else."), "Something else.", 1),
        (Message.of("of-a-newer-service", more=1), "of-a-newer-service {'more': 1}", 1),
    ):
        problem = {
            "type": f"/problems/{message.code}", "title": "Conflict", "status": 409, "detail": message.text, "kind": "conflict",
            "parameters": message.parameters, "request_id": "1",
        }  # fmt: skip
        page.route("**/api/control", partial(refuse, problem))
        german.press("Bedienung übernehmen und planen")
        notice = page.locator(".notice:not(.alarm-band) .told")
        expect(notice).to_have_text(words or message.say("de"))
        assert notice.locator("[lang=en]").count() == foreign
        german.press("Schließen")
        page.unroute("**/api/control")
