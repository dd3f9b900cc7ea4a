"""In German no verdict is English: what the engine says in sentences stands on no screen, what it found in figures does, in German."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np
import pytest
from playwright.sync_api import Browser, Page, expect

from core.effects.library import library, symptoms
from core.export.exports import TARGETS
from core.gap.answer import Diagnosis
from core.planning.stop import candidates, second_payload
from server.http.problems import kinds_by_name
from server.runs.reason import OWN
from tests.server.real_service import ROOT, Console, RealService
from tests.synthetic import payload, record, run_of
from tests.web.finished_answers import ANSWERS, ENGLISH, diagnosed
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import show, signed_in
from tests.web.tablet import Tablet

WORDS = ROOT / "web" / "src" / "words"
OF_THE_SCREEN = {"unreachable", "not-in-control", "control-not-taken"}
"""Kinds of what goes wrong on the screen alone."""
SAID = {
    "explained": "Die Abweichung ist erklärt: Schiefe Basis",
    "ambiguous": "Nicht entschieden: Verzögertes Kraftsignal oder Tiefpass im Sensor",
    "unknown": "Kein bekannter Effekt erklärt die Abweichung",
    "no_gap": "Simulation und Aufzeichnung stimmen überein",
    "not_enough": "Diese Aufzeichnung enthält zu wenig für eine Diagnose.",
}
LISTED = {
    "explained": "Erklärt: Schiefe Basis",
    "ambiguous": "Nicht entschieden; am wahrscheinlichsten: Verzögertes Kraftsignal",
    "unknown": "Kein bekannter Effekt erklärt die Abweichung.",
    "no_gap": "Simulation und Aufzeichnung stimmen überein",
    "not_enough": "Diese Aufzeichnung enthält zu wenig für eine Diagnose.",
}


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
    said = {answer.summary, answer.consequence, *(effect.advice for effect in answer.effects), *(each.sentence for each in answer.minor)}
    said |= {text for each in answer.also for text in (each.sentence, each.advice)}
    said |= {text for tie in answer.indistinguishable for text in (tie.why, tie.splits)}
    return (said | ({answer.next_experiment.motion} if answer.next_experiment else set())) - {""}


def check_says_none_of(page: Page, english: set[str]) -> None:
    told = page.inner_text("body")
    assert not [sentence for sentence in english if sentence in told]


@pytest.mark.parametrize("verdict", list(ANSWERS))
def test_a_diagnosis_is_german_from_its_verdict_to_what_is_to_be_done(german: Tablet, service: RealService, verdict: str) -> None:
    diagnosis = diagnosed(service, verdict)
    page = show(german, "gap", diagnosis)
    expect(page.get_by_role("heading", level=1)).to_contain_text(SAID[verdict])
    answer = Diagnosis.model_validate(page.request.get(f"http://{service.address}/api/diagnoses/{diagnosis}").json()["result"])
    check_says_none_of(page, sentences(answer))
    assert page.locator("main [lang=en]").count() == 0
    check_looks(look(page, f"{verdict} in German"))
    show(german, "gap")
    listed = page.locator(".rows li", has=page.locator(f"a[href='#/gap/{diagnosis}']"))
    expect(listed).to_contain_text(LISTED[verdict])
    check_says_none_of(page, {ENGLISH})


def test_results_history_and_comparison_are_german(german: Tablet, service: RealService) -> None:
    person = Console(service)
    person.take_control()
    runs = []
    for seed, tool in ((21, "steel_block"), (22, "cylinder")):
        runs.append(person.queue(seed=seed, payload=tool))
        person.wait(runs[-1], "Idle")
        assert person.release(runs[-1]).status_code == 200
        person.wait(runs[-1], "Complete")
    determined = person.run(runs[1])["result"]["determined"]
    stopped = person.queue(seed=23)
    person.wait(stopped, "Idle")
    assert person.http.post(f"/api/runs/{stopped}/commands", json={"command": "stop"}).status_code == 200
    person.wait(stopped, "Stopped")
    verdicts = {person.http.get(f"/api/runs/{run}/result").json()["verdict"] for run in runs}
    differ = person.http.get(f"/api/runs/{runs[0]}/comparison/{runs[1]}").json()["comparison"]["verdict"]
    person.leave()
    page = show(german, "runs", runs[0])
    expect(page.locator(".verdict-words")).to_contain_text("Die Last hat 2,7")
    check_says_none_of(page, verdicts)
    page.locator(".exports summary").tap()
    expect(page.locator(".exports li", has_text="Universal Robots")).to_contain_text("Trägheit um den Schwerpunkt")
    assert page.locator(".warnings [lang=en], .exports li > p > [lang=en]").count() == 0
    show(german, "runs", stopped)
    expect(page.locator(".ended .told")).to_contain_text("Der Lauf wurde auf Wunsch beendet.")
    show(german, "history")
    rows = page.locator(".run-list tbody tr")
    expect(rows.first).to_contain_text("Der Lauf wurde auf Wunsch beendet.")
    expect(rows.nth(1)).to_contain_text("alle zehn Größen bestimmt" if determined == 10 else f"{determined} von 10 Größen bestimmt")
    check_says_none_of(page, verdicts)
    show(german, "history", *runs)
    expect(page.locator(".comparison .verdict")).to_contain_text("Am deutlichsten: ")
    check_says_none_of(page, {differ})
    assert german.complaints == []


def test_every_remedy_and_every_motion_that_can_be_proposed_has_german_words() -> None:
    text = (WORDS / "de-effects.ts").read_text()
    remedies, motions = (
        set(re.findall(r"^    (\w+):", part, re.MULTILINE)) for part in re.findall(r"(?:remedies|motions): {(.+?)\n  }", text, re.DOTALL)
    )
    recording = record(run_of(repetitions=1), payload("steel_block"), np.random.default_rng(1))
    assert recording.q is not None
    proposed = {motion.id for motion in (*candidates(recording, (), np.tile([0.0, 0.0, -9.81], (len(recording), 1))), second_payload(1.0))}
    assert remedies == {effect.id for effect in (*library(), *symptoms())}
    assert motions == proposed


def test_whatever_may_stand_beside_a_verdict_has_german_words() -> None:
    text = (WORDS / "de-effects.ts").read_text()
    seen = text[text.index("  seen: {") : text.index("  pieces: {")]
    engine = "".join(path.read_text() for path in (*(ROOT / "core" / "effects").glob("*.py"), ROOT / "core" / "gap" / "symptoms.py"))
    told = set(re.findall(r'(?:Remark\(|_conclude\(\w+, )"(\w+)"', engine))
    assert len(told) > 10
    assert set(re.findall(r"^    (\w+): ", seen, re.MULTILINE)) == told


def test_what_stands_beside_a_verdict_is_german_with_its_figures(german: Tablet, service: RealService) -> None:
    page = show(german, "gap", diagnosed(service, "no_gap"))
    also = page.locator(".also")
    expect(also).to_contain_text("Last weicht von der Referenz ab")
    expect(also).to_contain_text("Die Last ist nicht die Referenz: 4,0\u202f% leichter, Trägheit um 3,5\u202f% anders.")
    expect(also).to_contain_text("Gegenüber der Referenzlast; das 4,0-Fache des Angegebenen oder Zulässigen")
    expect(also).to_contain_text("Prüfen Sie, ob die richtige Last montiert ist")
    expect(page.locator(".minor")).to_contain_text("Gelenk 5 reibt mit 2,03\u202fN m (Coulomb) und 4,86\u202fN m s/rad (viskos)")
    expect(also).not_to_contain_text("Reibung")


def test_whatever_can_go_wrong_has_german_words() -> None:
    said = set(re.findall(r"^  '?([\w-]+)'?:", (WORDS / "de-problems.ts").read_text(), re.MULTILINE))
    assert said == set(kinds_by_name()) | OWN | OF_THE_SCREEN
    assert set(re.findall(r"new Flaw\('([\w-]+)'\)", (WORDS.parent / "run" / "control.ts").read_text())) <= OF_THE_SCREEN


def test_remarks_of_the_engine_and_its_exports_have_german_words() -> None:
    text = (WORDS / "de-remarks.ts").read_text()
    warnings, undetermined, exports, limits = (
        set(re.findall(r"^    (?:'([^']+)'|(\w+)):", part, re.MULTILINE))
        for part in re.findall(r"^  \w+: {\n(.+?)\n  }", text, re.DOTALL | re.MULTILINE)
    )
    others = (ROOT / "core" / "gap" / "basis.py", ROOT / "core" / "recording" / "workpiece.py")
    engine = "".join(path.read_text() for path in (*(ROOT / "core" / "estimation").glob("*.py"), *others))
    assert {name for _, name in warnings} == set(re.findall(r'(?:Remark|TooLittleError)\(\s*"(\w+)"', engine))
    assert {name for _, name in undetermined} == {"mass", "com", "inertia"}
    assert {name for _, name in exports} == {target.name for target in TARGETS}
    effects = "".join(path.read_text() for path in (ROOT / "core" / "effects").glob("*.py"))
    assert all(f'"{sentence}"' in effects for sentence, _ in limits)
