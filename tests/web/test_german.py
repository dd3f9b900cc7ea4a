"""In German no verdict is English: what the engine says in sentences stands on no screen, what it found in figures does, in German."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page, expect

from core.gap.answer import Diagnosis
from tests.server.real_service import Console, RealService
from tests.web.finished_answers import ANSWERS, diagnosed
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import show, signed_in
from tests.web.tablet import Tablet

STOPPED = "gestoppt von operator."
TOLD = {
    "explained": "Basis waagrecht ausrichten",
    "ambiguous": "Fachkraft fragen: Ursache nicht geklärt",
    "unknown": "Fachkraft fragen: Fehler, den Heft nicht kennt",
    "no_gap": "Last prüfen: Es ist nicht die erwartete",
    "not_enough": "Neu aufzeichnen",
}
"""To the person at the robot."""
SAID = {
    "explained": "Die Abweichung ist erklärt: Schiefe Basis",
    "ambiguous": "Nicht entschieden: Verzögertes Kraftsignal oder Tiefpass im Sensor",
    "unknown": "Kein bekannter Effekt erklärt die Abweichung",
    "no_gap": "Simulation und Aufzeichnung stimmen überein",
    "not_enough": "Mit dieser Aufzeichnung ist keine Diagnose möglich.",
}
"""To the engineer."""


@pytest.fixture
def german(service: RealService, browser: Browser) -> Iterator[Tablet]:
    """A tablet of the first account, in German."""
    with signed_in(service, browser) as at:
        at.page.evaluate("localStorage.setItem('heft.language', 'de')")
        at.page.reload()
        at.wait(".setup .cell-facts")
        yield at


def sentences(answer: Diagnosis) -> set[str]:
    """Whatever the engine says in words of its own."""
    said = {answer.summary, *(effect.advice for effect in answer.effects), *(each.message for each in answer.minor)}
    said |= {message for each in answer.also for message in (each.message, each.advice)}
    said |= {message for tie in answer.indistinguishable for message in (tie.why, tie.splits)}
    said |= {answer.instruction.sentence, answer.instruction.next, *answer.instruction.further}
    said |= {message for message in (answer.consequence, answer.lacking) if message}
    return {str(message) for message in said | ({answer.next_experiment.motion} if answer.next_experiment else set())}


def check_says_none_of(page: Page, english: set[str]) -> None:
    told = page.inner_text("body")
    assert not [sentence for sentence in english if sentence in told]


@pytest.mark.parametrize("verdict", list(ANSWERS))
def test_a_diagnosis_is_german_from_its_verdict_to_what_is_to_be_done(german: Tablet, service: RealService, verdict: str) -> None:
    diagnosis = diagnosed(service, verdict)
    page = show(german, "gap", diagnosis)
    expect(page.get_by_role("heading", level=1)).to_contain_text(TOLD[verdict])
    german.tap(page.locator(".evidence > summary"))
    expect(page.locator(".gap-summary h2")).to_contain_text(SAID[verdict])
    answer = Diagnosis.model_validate(page.request.get(f"http://{service.address}/api/diagnoses/{diagnosis}").json()["result"])
    check_says_none_of(page, sentences(answer))
    assert page.locator("main [lang=en]").count() == 0
    check_looks(look(page, f"{verdict} in German"))
    show(german, "gap")
    listed = page.locator(".rows li", has=page.locator(f"a[href='#/gap/{diagnosis}']"))
    expect(listed).to_contain_text(TOLD[verdict])
    check_says_none_of(page, {answer.summary.text})


@pytest.mark.thorough
def test_results_history_and_comparison_are_german(german: Tablet, service: RealService) -> None:
    person = Console(service)
    person.take_control()
    runs = []
    for seed, tool in ((21, "steel_block"), (22, "cylinder")):
        runs.append(person.queue(seed=seed, payload=tool))
        person.wait(runs[-1], "Idle")
        assert person.release(runs[-1]).status_code == 200
        person.finish(runs[-1])
    determined = person.run(runs[1])["result"]["determined"]
    stopped = person.queue(seed=23)
    person.wait(stopped, "Idle")
    assert person.http.post(f"/api/runs/{stopped}/commands", json={"command": "stop"}).status_code == 200
    person.wait(stopped, "Stopped")
    verdicts = {person.http.get(f"/api/runs/{run}/result").json()["verdict"]["text"] for run in runs}
    differ = person.http.get(f"/api/runs/{runs[0]}/comparison/{runs[1]}").json()["comparison"]["verdict"]["text"]
    person.leave()
    page = show(german, "runs", runs[0])
    expect(page.locator(".verdict-words")).to_contain_text("Die Last hat 2,7")
    check_says_none_of(page, verdicts)
    page.locator(".exports summary").tap()
    expect(page.locator(".exports li", has_text="Universal Robots")).to_contain_text("Trägheit um den Schwerpunkt")
    assert page.locator(".warnings [lang=en], .exports [lang=en]").count() == 0
    show(german, "runs", stopped)
    expect(page.locator(".ended .told")).to_contain_text(STOPPED)
    show(german, "history")
    rows = page.locator(".run-list tbody tr")
    expect(rows.first).to_contain_text(STOPPED)
    expect(rows.nth(1)).to_contain_text("alle zehn Größen bestimmt" if determined == 10 else f"{determined} von 10 Größen bestimmt")
    check_says_none_of(page, verdicts)
    show(german, "history", *runs)
    expect(page.locator(".comparison .verdict")).to_contain_text("Am deutlichsten: ")
    check_says_none_of(page, {differ})
    assert german.complaints == []


def test_what_stands_beside_a_verdict_is_german_with_its_figures(german: Tablet, service: RealService) -> None:
    page = show(german, "gap", diagnosed(service, "no_gap"))
    also = page.locator(".also")
    expect(also).to_contain_text("Last weicht von der Referenz ab")
    expect(also).to_contain_text("Die Last ist nicht die Referenz: 4,0 % leichter, Trägheit um 3,5 % anders.")
    expect(also).to_contain_text("Gegenüber der Referenzlast; das 4,0-Fache des Angegebenen oder Zulässigen")
    expect(also).to_contain_text("Prüfen Sie, ob die richtige Last montiert ist")
    expect(page.locator(".minor")).to_contain_text("Gelenk 5 mit 2,03 ± 0,01 N m (Coulomb) und 4,86 ± 0,02 N m s/rad (viskos)")
    expect(also).not_to_contain_text("Reibung")
