"""A log of another program on the console: from its files to a diagnosis, with what was understood, asked and changed on the way."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.core.recording.logs.foreign_logs import LOG, write_ati, write_columns, write_csv, write_undecided
from tests.core.recording.logs.payload_log import MASS_KG
from tests.core.recording.logs.torque_log import write_torque_log
from tests.server.real_service import RealService, wait_for
from tests.torque_recordings import make
from tests.web.judgement import check_looks, check_nothing_is_cut_off
from tests.web.looks import glimpse, look
from tests.web.screens import show, signed_in
from tests.web.tablet import PATIENCE_MS, Tablet

REFUSED = "422 (Unprocessable"
"""What the browser says of a log that cannot be read."""


@pytest.fixture
def at(service: RealService, browser: Browser) -> Iterator[Tablet]:
    with signed_in(service, browser) as found:
        show(found, "gap")
        found.tap(found.page.get_by_role("link", name="Import a log"))
        found.wait(".import .drop-place")
        yield found
        assert [said for said in found.complaints if REFUSED not in said] == []


def choose(page: Page, *files: Path) -> None:
    page.get_by_label("Choose files").set_input_files(files)


def row(page: Page, name: str) -> str:
    """What the table of what was understood says."""
    return page.locator(".understood tr", has=page.get_by_role("rowheader", name=name, exact=True)).locator("td").inner_text()


def test_from_two_files_with_two_clocks_to_a_diagnosis(at: Tablet, service: RealService, tmp_path: Path) -> None:
    page = at.page
    check_looks(look(page, "a log before it is chosen"))
    choose(page, *write_ati(tmp_path))
    expect(page.get_by_text("Nothing speaks against it.")).to_be_visible(timeout=PATIENCE_MS)
    assert "fx fy fz [N]" in row(page, "Force")
    assert "ati.csv" in row(page, "Torque")
    assert row(page, "Sign") == "What the sensor exerts on the payload"
    found = re.match(r"([\d.]+) ± ([\d.]+) kg", row(page, "Payload"))
    assert found is not None
    assert abs(float(found[1]) - MASS_KG) < float(found[2])
    expect(page.locator(".log-look canvas")).to_have_count(3)
    with page.expect_download() as saved:
        at.tap(page.get_by_role("link", name="map.toml"))
    assert 'file = "ati.csv"' in Path(saved.value.path()).read_text()
    at.tap(page.locator(".changes summary"))
    check_looks(look(page, "what was understood of a log"))
    page.get_by_label("Name", exact=True).fill("Cell 4, ATI")
    at.tap(page.get_by_role("button", name="Diagnose", exact=True))
    expect(page).to_have_url(re.compile(r"#/gap/\w+$"))
    expect(page.get_by_role("heading", name="Cell 4, ATI").or_(page.locator(".gap-verdict")).first).to_be_visible(timeout=2 * PATIENCE_MS)
    wait_for(lambda: list((service.data / "imports").iterdir()) == [], "the import to be gone")


def test_the_payload_is_identified_on_the_page_and_its_report_opened(at: Tablet, tmp_path: Path) -> None:
    page = at.page
    choose(page, write_csv(tmp_path))
    expect(page.get_by_text("Nothing speaks against it.")).to_be_visible(timeout=5 * PATIENCE_MS)
    at.press("Identify")
    payload = page.get_by_role("region", name="Result")
    expect(payload.get_by_role("status")).to_contain_text("The payload has", timeout=5 * PATIENCE_MS)
    mass = payload.get_by_role("row", name=re.compile("^Mass")).locator("td").inner_text()
    found = re.match(r"([\d.]+)\s*± ([\d.]+)", mass)
    assert found is not None, mass
    assert abs(float(found[1]) - MASS_KG) < float(found[2])
    expect(payload.locator(".budget-repeats").first).to_contain_text("repeats within")
    report = payload.get_by_role("link", name="Report").get_attribute("href")
    assert report is not None
    assert "Where the uncertainty comes from" in page.request.get(f"http://{at.service.address}{report}").text()
    check_looks(look(page, "a payload identified from a log"))
    at.tap(page.locator(".changes summary"))
    page.get_by_label("Unit of the torque").select_option("N mm")
    expect(payload).to_have_count(0, timeout=PATIENCE_MS)
    expect(page.get_by_role("button", name="Identify", exact=True)).to_be_enabled(timeout=PATIENCE_MS)


@pytest.mark.thorough
def test_two_logs_of_joint_torques_are_compared_with_and_without_the_payload(at: Tablet, tmp_path: Path) -> None:
    page, pair = at.page, make(3, mass_kg=2.8, gain_std=0.005)
    choose(page, *write_torque_log(tmp_path, "arm alone", pair.empty))
    answer_where_the_payload_begins(at)
    assert "tau0" in row(page, "Joint torques")
    expect(page.locator(".log-look canvas")).to_have_count(2)
    at.tap(page.locator(".changes summary"))
    gain = page.locator(".number-change", has=page.get_by_label("uncertainty of the joint torques"))
    expect(gain.get_by_role("button", name="Read anew")).to_be_disabled()
    gain.get_by_role("textbox").fill("0.005")
    gain.get_by_role("button", name="Read anew").tap()
    expect(page.get_by_text("Nothing speaks against it.")).to_be_visible(timeout=5 * PATIENCE_MS)
    at.press("This one is without")
    alone = page.get_by_role("region", name="Without the payload")
    expect(alone).to_contain_text("arm alone.csv")
    expect(page.locator(".understood")).to_have_count(0)
    check_looks(look(page, "a log without the payload put aside"))
    choose(page, *write_torque_log(tmp_path, "with the block", pair.loaded))
    answer_where_the_payload_begins(at)
    at.press("Identify")
    payload = page.get_by_role("region", name="Result")
    expect(payload.get_by_role("status")).to_contain_text("The payload has", timeout=5 * PATIENCE_MS)
    expect(payload).to_contain_text("compared with arm alone.csv")
    mass = payload.get_by_role("row", name=re.compile("^Mass")).locator("td").inner_text()
    found = re.match(r"([\d.]+)\s*± ([\d.]+)", mass)
    assert found is not None, mass
    assert abs(float(found[1]) - pair.phi[0]) < 1.5 * float(found[2])
    check_looks(look(page, "a payload identified from joint torques, with and without"))
    alone.get_by_role("button", name="Remove").tap()
    expect(alone).to_contain_text("put it aside")


def answer_where_the_payload_begins(at: Tablet) -> None:
    question = at.page.locator(".question")
    expect(question.get_by_role("radio", name="tool")).to_be_checked(timeout=PATIENCE_MS)
    at.press("Answer")
    expect(at.page.get_by_text("Nothing speaks against it.")).to_be_visible(timeout=5 * PATIENCE_MS)


def test_what_cannot_be_told_is_asked_with_the_likely_answer_chosen(at: Tablet, tmp_path: Path) -> None:
    page = at.page
    choose(page, write_undecided(tmp_path))
    question = page.locator(".question")
    expect(question).to_contain_text("In which axes is the wrench?", timeout=PATIENCE_MS)
    expect(question.get_by_role("radio", name="Those of the sensor")).to_be_checked()
    check_looks(look(page, "a question about a log"))
    at.press("Answer")
    expect(question).to_contain_text("What does the wrench say?", timeout=PATIENCE_MS)
    question.get_by_role("radio", name="What the payload exerts on the sensor").check(force=True)
    at.press("Answer")
    expect(page.locator(".understood")).to_contain_text("Turned round in the recording", timeout=PATIENCE_MS)
    at.press("Discard")
    at.press("Discard it")
    expect(page.locator(".understood")).to_have_count(0)


def test_a_log_that_contradicts_itself_says_how_and_is_mended_by_a_choice(at: Tablet, tmp_path: Path) -> None:
    page = at.page
    columns = {"t": LOG.t, **dict(zip(("fx", "fy", "fz"), LOG.wrench[:, :3].T, strict=True))}
    columns |= dict(zip(("tx", "ty", "tz"), 1e3 * LOG.wrench[:, 3:].T, strict=True))
    columns |= {f"r{i + 1}{j + 1}": LOG.orientation[:, i, j] for i in range(3) for j in range(3)}
    columns |= dict(zip(("px", "py", "pz"), LOG.position.T, strict=True))
    choose(page, write_columns(tmp_path / "log in N mm.csv", columns))
    expect(page.locator(".warnings")).to_contain_text("N mm", timeout=PATIENCE_MS)
    expect(page.get_by_role("button", name="Diagnose", exact=True)).to_be_disabled()
    check_looks(look(page, "a log that contradicts itself"))
    page.get_by_label("Unit of the torque").select_option("N mm")
    expect(page.get_by_text("Nothing speaks against it.")).to_be_visible(timeout=PATIENCE_MS)
    expect(page.get_by_role("button", name="Diagnose", exact=True)).to_be_enabled()


def test_a_broken_file_is_refused_in_a_sentence_and_taken_away(at: Tablet, tmp_path: Path) -> None:
    page = at.page
    (tmp_path / "log.mcap").write_bytes(b"\x89MCAP0\r\n\x01\xff")
    choose(page, tmp_path / "log.mcap")
    expect(page.get_by_role("alert")).to_contain_text("log.mcap", timeout=PATIENCE_MS)
    at.press("Remove log.mcap")
    expect(page.get_by_role("alert")).to_have_count(0)
    expect(page.locator(".sent-files")).to_have_count(0)


def test_it_is_all_said_in_german_and_longer_words_have_their_place(at: Tablet, tmp_path: Path) -> None:
    page = at.page
    page.evaluate("localStorage.setItem('heft.language', 'de')")
    for query, heading in (("?words=own", "Log eines anderen Programms"), ("?words=longer", "Log")):
        page.goto(f"http://{at.service.address}/{query}#/import")
        expect(page.get_by_role("heading", level=1)).to_contain_text(heading)
        page.locator("input[type=file]").set_input_files([write_csv(tmp_path)])
        page.wait_for_selector(".understood", timeout=PATIENCE_MS)
        check_nothing_is_cut_off(glimpse(page, f"what was understood of a log, {query}"))
        page.locator(".discard button").tap()
        page.locator(".discard .ask-first button").first.tap()
        expect(page.locator(".understood")).to_have_count(0)
