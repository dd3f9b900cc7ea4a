"""The tool library: saved where a run is set up, chosen by one tap, found with its picture and last result, changed and deleted."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np
import pytest
from playwright.sync_api import Browser, expect

from core.payload.shapes import Box
from server.runs import ledger as run_ledger
from server.runs.packml import Command
from server.runs.schemas import RunCreate
from server.service import utc_now
from server.store.store import Store
from tests.core.export.cloud import Cloud, cloud
from tests.core.export.known_result import answer
from tests.server.real_service import Console, RealService
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import show, signed_in
from tests.web.tablet import Tablet

CELL = "lwr4_bench"
PATH = f"/api/cells/{CELL}/payloads"
BOX = {"size_m": [0.12, 0.09, 0.18], "pose": {"xyz_m": [0.0, 0.0, 0.09]}}
TAKEN = "409 (Conflict)"
"""What the browser says of a name that is taken."""
MASS_KG = float(cloud(0).masses.sum())


def accepted_run(service: RealService, saved: str, name: str) -> str:
    """A run with the saved tool whose result was accepted, as the service leaves it."""
    store, body = Store(service.store_url), cloud(0)
    with store.write() as db:
        order = RunCreate(cell=CELL, payload=name, payload_box=Box.model_validate(BOX))
        carried = run_ledger.CarriedPayload(saved, None)
        row = run_ledger.add_run(db, order, "account:operator", utc_now(), carried=carried)
        run_ledger.keep_steps(db, row, [None, Command.START, None, None, None], utc_now())
        row.result = answer(Cloud(body.masses, np.array(body.points)), CELL).model_dump_json()
        row.accepted_by, row.accepted_at = "account:operator", utc_now()
        run = row.id
    store.close()
    return run


@pytest.fixture
def at(service: RealService, browser: Browser) -> Iterator[Tablet]:
    with signed_in(service, browser) as found:
        yield found
        assert [said for said in found.complaints if TAKEN not in said] == []


@pytest.fixture
def person_left(person: Console) -> Iterator[Console]:
    """Somebody who leaves no saved tool behind."""
    yield person
    for each in person.http.get(PATH).json():
        if each["id"] is not None:
            person.http.delete(f"{PATH}/{each['id']}")


def test_a_tool_is_saved_where_a_run_is_set_up_chosen_planned_with_and_shows_its_last_result(
    at: Tablet, service: RealService, person_left: Console
) -> None:
    page = at.page
    page.get_by_role("radio", name="Asymmetric steel block").check(force=True)
    page.locator("#field-box").get_by_role("textbox", name="z").fill("0,2")
    page.locator("#field-mass").get_by_role("textbox").fill("4")
    at.press("Save this tool")
    form = page.locator(".tool-form")
    expect(form.get_by_role("button", name="Save")).to_be_disabled()
    form.get_by_label("Name", exact=True).fill("Gehäuse, groß")
    expect(form.get_by_label("Name in orders")).to_have_value("gehause_gross")
    expect(form.get_by_label("from", exact=True)).to_have_value("3.600")
    check_looks(look(page, "a tool that is being saved"))
    form.get_by_label("Name in orders").fill("Operator")
    form.get_by_role("button", name="Save").tap()
    expect(page.locator(".notice")).to_contain_text("a protected zone")
    form.get_by_label("Name in orders").fill("housing")
    form.get_by_role("button", name="Save").tap()
    expect(form).to_have_count(0)
    option = page.get_by_role("radio", name="Gehäuse, groß")
    expect(option).to_be_checked()
    saved = next(each for each in person_left.http.get(PATH).json() if each["name"] == "housing")
    assert (saved["box"]["size_m"][2], saved["mass_least_kg"], saved["saved_by"]) == (0.2, 3.6, "account:operator")
    at.press("Take control and plan")
    page.wait_for_url(re.compile("#/runs/"))
    run = page.url.rpartition("/")[2]
    ordered = person_left.run(run)
    assert (ordered["payload"], ordered["saved_payload"], ordered["order"]["payload_box"]["size_m"][2]) == ("housing", saved["id"], 0.2)
    person_left.http.delete(f"/api/runs/{run}")
    person_left.wait(run, "Stopped")
    done = accepted_run(service, saved["id"], "housing")
    show(at, "tools")
    tile = page.locator(".tool-tile", has_text="Gehäuse, groß")
    expect(tile).to_contain_text(f"{MASS_KG:.3f}")
    expect(tile).to_contain_text("outside the expected range" if not 3.6 <= MASS_KG <= 4.4 else "3.600 kg")
    expect(tile.get_by_role("img")).to_have_attribute("aria-label", re.compile(r"× 0\.200 m"))
    expect(tile.get_by_role("link", name="Result")).to_have_attribute("href", f"#/runs/{done}")
    check_looks(look(page, "tools"))
    tile.get_by_role("link", name="History: 2 runs").tap()
    rows = page.locator(".run-list tbody tr")
    expect(rows).to_have_count(2)
    expect(rows.first).to_contain_text("housing")
    expect(page.get_by_role("combobox", name="Tool")).to_have_value(saved["id"])
    page.get_by_role("combobox", name="Tool").select_option("")
    expect(page.get_by_role("combobox", name="Tool")).to_have_value("")
    assert "saved=" not in page.url


def test_a_result_becomes_a_tool_that_is_changed_used_and_deleted_after_a_question(
    at: Tablet, service: RealService, person_left: Console
) -> None:
    first = person_left.http.post(PATH, json={"name": "rough", "title": "Rough casting", "box": BOX}).json()
    run = accepted_run(service, first["id"], "rough")
    page = show(at, "runs", run)
    at.press("Save as tool")
    form = page.locator(".tool-form")
    expect(form).to_contain_text("are taken from this result")
    form.get_by_label("Name", exact=True).fill("Casting as measured")
    form.get_by_role("button", name="Save").tap()
    expect(form).to_have_count(0)
    show(at, "tools")
    page.get_by_label("Search").fill("measured")
    tile = page.locator(".tool-tile")
    expect(tile).to_have_count(1)
    expect(tile).to_contain_text(f"Heft, run {run}")
    assert "search=measured" in page.url
    tile.get_by_role("button", name="Edit").tap()
    page.locator(".tool-form").get_by_label("Name", exact=True).fill("Casting, measured")
    check_looks(look(page, "a tool that is changed"))
    page.locator(".tool-form").get_by_role("button", name="Save").tap()
    expect(tile.get_by_role("heading")).to_have_text("Casting, measured")
    tile.get_by_role("button", name="Delete").tap()
    expect(tile.get_by_role("group")).to_contain_text("stay in the history")
    tile.get_by_role("button", name="Delete the tool").tap()
    expect(page.get_by_role("status").filter(has_text="No tool contains")).to_be_visible()
    at.press("Show all")
    page.locator(".tool-tile", has_text="Rough casting").get_by_role("button", name="Set up a run").tap()
    expect(page.get_by_role("radio", name="Rough casting")).to_be_checked()
