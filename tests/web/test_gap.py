"""The gap on the tablet: a real recording with a planted fault is uploaded, diagnosed, added to the twin and taken out of it again."""

from __future__ import annotations

import json
import re
import zipfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, Page, Route, expect

from core.effects.library import library, symptoms
from core.gap.answer import Diagnosis, Experiment, Tied, Value
from core.planning.stop import Stop, Swings
from core.recording.folder import write_recording
from core.words.message import Message
from tests.server.real_service import ROOT, Console, RealService
from tests.synthetic import payload, record, run_of
from tests.web.finished_answers import NOISY, OTHER_PAYLOAD, RUBBING
from tests.web.judgement import check_looks, check_nothing_is_cut_off
from tests.web.looks import glimpse, look
from tests.web.screens import show, signed_in
from tests.web.tablet import Tablet
from tests.web.tilted import TILT_RAD, tilted_recording

WORDS = ROOT / "web" / "src" / "words"
BUSY_MS = 300_000
"""Until a diagnosis is done on a machine that others use."""
TURN = [Stop(down=(0.0, 1.0, 0.0), swings=Swings(about="x"))]
WATCHER = {"name": "watcher", "password": "looks on from afar", "roles": ["viewer"]}


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A short run on a base that is not level, as a zip."""
    return tilted_recording(tmp_path_factory.mktemp("tilted"))


@pytest.fixture(scope="module")
def person(service: RealService) -> Iterator[Console]:
    """The first account, which is operator, engineer and administrator; there is somebody who only watches, too."""
    console = Console(service)
    assert console.http.post("/api/accounts", json=WATCHER).status_code == 201
    yield console
    console.leave()


@pytest.fixture(scope="module")
def diagnosed(service: RealService, browser: Browser, recording: Path, person: Console) -> str:
    """The diagnosis of that recording, asked for at the tablet and waited for there."""
    del person
    with signed_in(service, browser) as at:
        at.tap(at.page.get_by_role("link", name="Diagnosis"))
        diagnose = at.page.locator(".recording-upload button")
        expect(diagnose).to_be_disabled()
        check_looks(look(at.page, "gap"))
        at.page.get_by_label("Recording (zip)").set_input_files(recording)
        name = at.page.get_by_label("Name of the recording")
        expect(name).to_have_value("recording")
        name.fill("Line 3 after the move")
        at.tap(diagnose)
        expect(at.page.get_by_role("progressbar")).to_be_visible()
        check_looks(look(at.page, "diagnosis under way"))
        at.page.wait_for_selector(".gap-verdict", timeout=BUSY_MS)
        assert at.complaints == []
        return at.page.url.rsplit("/", 1)[1]


@pytest.fixture
def engineer(service: RealService, browser: Browser) -> Iterator[Tablet]:
    """A tablet of the first account."""
    with signed_in(service, browser) as at:
        yield at


def sentence(text: str) -> Message:
    """A message of its own."""
    return Message.of("text", text=text)


def unfolded(at: Tablet, diagnosis: str) -> Page:
    """The page of a diagnosis with the engineer's evidence."""
    page = show(at, "gap", diagnosis)
    at.tap(page.locator(".evidence > summary"))
    expect(page.locator(".heat")).to_be_visible()
    return page


def answer_of(person: Console, diagnosis: str) -> Diagnosis:
    """What the service says."""
    return Diagnosis.model_validate(person.http.get(f"/api/diagnoses/{diagnosis}").json()["result"])


def test_the_verdict_stands_first_with_its_sign_and_what_to_do_two_taps_from_signing_in(
    engineer: Tablet, person: Console, diagnosed: str
) -> None:
    taps = engineer.taps
    engineer.tap(engineer.page.get_by_role("link", name="Diagnosis"))
    listed = engineer.page.locator(".rows li", has_text="Line 3 after the move")
    expect(listed.locator(".instruction[data-level=act].abnormal")).to_have_text("Level the base")
    engineer.tap(listed.get_by_role("link", name="Open"))
    heading = engineer.page.get_by_role("heading", level=1)
    expect(heading).to_have_text("Level the base")
    assert engineer.taps - taps == 2
    expect(heading.locator("svg")).to_be_visible()
    told = answer_of(person, diagnosed).instruction
    expect(engineer.page.locator(".gap-verdict .sentence")).to_have_text(told.next.text)
    expect(engineer.page.locator(".heat")).to_be_hidden()
    check_looks(look(engineer.page, "verdict"))


def test_a_touch_is_told_with_its_time(engineer: Tablet, person: Console, diagnosed: str) -> None:
    (first, *_) = answer_of(person, diagnosed).effects
    touched = first.model_copy(update={"id": "external_contact", "parameters": {"at_s": Value(value=31.4, std=0.1, unit="s")}})
    page = show_instead(engineer, person, diagnosed, effects=[touched.model_dump()])
    expect(page.get_by_role("heading", level=1)).to_have_text("Somebody or something touched the robot at 0:31")


def test_effects_that_the_verdict_does_not_name_have_their_sizes_behind_one_more_tap(
    engineer: Tablet, person: Console, diagnosed: str
) -> None:
    first, second, *_ = answer_of(person, diagnosed).effects
    many = {f"gain_{k}_share": Value(value=0.01 * k, std=0.01, unit="1") for k in range(30)}
    likely = [first.model_copy(update={"probability": 0.8}), second.model_copy(update={"probability": 0.15, "parameters": many})]
    page = show_instead(engineer, person, diagnosed, effects=[each.model_dump() for each in likely], pairs=[])
    engineer.tap(page.locator(".evidence > summary"))
    shown = page.locator(".which .effect-parameters div:visible")
    expect(shown).to_have_count(len(first.parameters))
    engineer.tap(page.locator(".which .others > summary", has_text="does not name"))
    expect(shown).to_have_count(len(first.parameters) + 6)


def test_a_change_inside_the_interval_before_is_not_called_significant(engineer: Tablet, person: Console, diagnosed: str) -> None:
    payload = answer_of(person, diagnosed).payload
    assert payload is not None
    before = payload.before.model_copy(update={"phi": [2.0, *payload.before.phi[1:]], "std": [0.1, *payload.before.std[1:]]})
    after = payload.after.model_copy(update={"phi": [2.09, *payload.after.phi[1:]], "std": [0.005, *payload.after.std[1:]]})
    page = show_instead(engineer, person, diagnosed, payload={"before": before.model_dump(), "after": after.model_dump()})
    engineer.tap(page.locator(".evidence > summary"))
    mass = page.locator(".payload-change tbody tr").first
    expect(mass).to_contain_text("0.090 kg = not significant")  # 9.2 times the interval after alone


def test_a_chart_zooms_is_read_off_and_saved_under_a_name_that_says_of_what(engineer: Tablet, diagnosed: str) -> None:
    page = unfolded(engineer, diagnosed)
    plot = page.locator(".overlay .plot").first
    over = plot.locator(".u-over")
    over.scroll_into_view_if_needed()
    over.hover()
    readout = plot.locator(".readout")
    expect(readout).to_contain_text(re.compile(r"^[\d.]+ s.*measured −?[\d.]+ N.*before −?[\d.]+ N.*after −?[\d.]+ N"))
    expect(plot.get_by_role("button", name="Show all")).to_have_count(0)
    page.mouse.wheel(0, -300)
    expect(plot.get_by_role("button", name="Show all")).to_be_visible()
    tools = plot.locator(".plot-tools summary")
    engineer.tap(tools)
    engineer.tap(plot.locator(".plot-tools").get_by_text("before", exact=True))
    over.hover(position={"x": 80, "y": 60})
    expect(readout).not_to_contain_text("before")
    with page.expect_download() as saved:
        engineer.tap(plot.get_by_role("button", name="CSV"))
    day = saved.value.suggested_filename.removesuffix(".csv")[-10:]
    assert re.fullmatch(rf"diagnosis-Line_3_after_the_move-\w+-f[xyz]-{day}\.csv", saved.value.suggested_filename)
    assert re.fullmatch(r"\d{4}-\d\d-\d\d", day)
    head, *rows = Path(saved.value.path()).read_text().splitlines()
    assert head == "time (s),measured (N),before (N),after (N)"
    assert len(rows) > 50
    assert all(np.isfinite([float(number) for number in row.split(",")]).all() for row in rows)
    with page.expect_download() as saved:
        engineer.tap(plot.get_by_role("button", name="PNG"))
    assert saved.value.suggested_filename.endswith(".png")
    assert Path(saved.value.path()).read_bytes().startswith(b"\x89PNG")
    engineer.tap(plot.get_by_role("button", name="Show all"))
    expect(plot.get_by_role("button", name="Show all")).to_have_count(0)
    check_looks(look(page, "a chart's tools"))
    assert engineer.complaints == []


def test_a_recording_of_another_robot_is_refused_for_this_cells_twin_and_says_what_would_do(engineer: Tablet, tmp_path: Path) -> None:
    other = record(run_of("ur5e_line", repetitions=1), payload("steel_block"), np.random.default_rng(1))
    write_recording(replace(other, cell=None), tmp_path / "recording")
    with zipfile.ZipFile(tmp_path / "recording.zip", "w") as archive:
        for file in (tmp_path / "recording").iterdir():
            archive.write(file, file.name)
    page = show(engineer, "gap")
    page.get_by_label("Recording (zip)").set_input_files(tmp_path / "recording.zip")
    engineer.tap(page.locator(".recording-upload button"))
    expect(page.locator(".notice:not(.alarm-band)")).to_contain_text("another robot than that of the cell")


def test_a_planted_tilt_is_named_with_its_stage_its_size_and_where_it_lies(engineer: Tablet, person: Console, diagnosed: str):
    page = unfolded(engineer, diagnosed)
    expect(page.locator(".gap-summary h2")).to_have_text("Base not level explains the gap (stage: mounting).")
    answer = answer_of(person, diagnosed)
    assert answer.where is not None
    first = max(answer.where.cells, key=lambda cell: cell.share)
    loudest = max(cell.times_noise for cell in answer.where.cells if (cell.channel, cell.phase) == (first.channel, first.phase))
    expect(page.locator(".heat .most")).to_have_text(f"{loudest:.0f}")
    expect(page.locator(".heat tbody tr")).to_have_count(6)
    size = page.locator(".effect-parameters div", has_text="about x").inner_text()
    value, half = (float(number) for number in re.findall(r"[\d.]+", size))
    assert abs(value - np.rad2deg(TILT_RAD)) < 1.5 * half < 0.1
    advised = re.search(r"turn it by ([\d.]+) deg about x", page.locator(".gap-summary .advice").inner_text())
    assert advised is not None
    assert abs(float(advised[1]) - value) < 0.01  # the same number with the same sign
    check_looks(look(page, "diagnosis"))
    assert engineer.complaints == []


def test_none_and_unknown_have_bars_beside_the_effects_with_numbers_and_words(engineer: Tablet, person: Console, diagnosed: str):
    bars = unfolded(engineer, diagnosed).locator(".bars li")
    answer = answer_of(person, diagnosed)
    best = max(answer.effects, key=lambda effect: effect.probability)
    expect(bars.filter(has_text="Base not level")).to_contain_text(f"{100 * best.probability:.0f} %")
    assert answer.none_probability < 0.05 and answer.unknown_probability < 0.1
    expect(bars.filter(has_text="None: ")).to_contain_text("very unlikely")
    words = "unlikely" if answer.unknown_probability >= 0.05 else "very unlikely"  # probabilities are learnt from time to time
    expect(bars.filter(has_text="Unknown: ")).to_contain_text(f"{100 * answer.unknown_probability:.1f} % {words}")


def test_how_far_it_closes_stands_in_numbers_for_the_whole_and_for_each_channel(engineer: Tablet, person: Console, diagnosed: str):
    page = unfolded(engineer, diagnosed)
    gap = answer_of(person, diagnosed).gap
    assert gap is not None
    expect(page.locator(".how-far")).to_contain_text(f"{gap.before:.2f} → {gap.after:.2f}")
    for channel, change in gap.by_channel.items():
        row = page.locator(".channel-bars tbody tr", has_text=channel)
        expect(row).to_contain_text(f"{change.before:.1f}")
        expect(row).to_contain_text(f"{change.after:.1f}")
    expect(page.locator(".payload-change tbody tr")).to_have_count(10)


def test_measured_and_simulated_are_drawn_for_the_channel_and_the_motion_that_are_chosen(engineer: Tablet, diagnosed: str):
    overlay = unfolded(engineer, diagnosed).locator(".overlay")
    expect(overlay.locator("canvas")).to_have_count(2)
    engineer.tap(overlay.get_by_text("tz", exact=True))
    expect(overlay).to_contain_text("tz, N m")
    expect(overlay.locator("canvas")).to_have_count(4)
    engineer.tap(overlay.get_by_text("tz", exact=True))
    expect(overlay.locator("canvas")).to_have_count(2)
    expect(overlay.get_by_role("status")).not_to_contain_text("Whole recording")
    engineer.press("Whole recording")
    expect(overlay.get_by_role("status")).to_contain_text("Whole recording")
    engineer.press("Next motion")
    expect(overlay.get_by_role("status")).not_to_contain_text("Whole recording")
    assert engineer.complaints == []


def test_it_is_said_in_german_with_a_decimal_comma_and_in_the_chosen_units(engineer: Tablet, person: Console, diagnosed: str):
    engineer.page.evaluate("localStorage.setItem('heft.language', 'de'), localStorage.setItem('heft.units', 'mm_g')")
    engineer.page.reload()
    page = show(engineer, "gap", diagnosed)
    expect(page.get_by_role("heading", level=1)).to_have_text("Basis waagrecht ausrichten")
    engineer.tap(page.locator(".evidence > summary"))
    expect(page.locator(".gap-summary h2")).to_have_text("Die Abweichung ist erklärt: Schiefe Basis (Stufe: Montage).")
    gap = answer_of(person, diagnosed).gap
    assert gap is not None
    expect(page.locator(".how-far")).to_contain_text(f"{gap.before:.2f}".replace(".", ","))
    expect(page.locator(".payload-change tbody tr").nth(1)).to_contain_text("g mm")
    check_looks(look(page, "diagnosis in German"))


def test_words_that_are_longer_have_their_place(engineer: Tablet, diagnosed: str):
    for page, there in (("gap", ".recording-upload"), (f"gap/{diagnosed}", ".overlay canvas"), ("trials", ".trials h2")):
        engineer.page.evaluate("localStorage.setItem('heft.evidence', 'yes')")
        engineer.page.goto(f"http://{engineer.service.address}/?words=longer#/{page}")
        engineer.wait(there)
        check_nothing_is_cut_off(glimpse(engineer.page, f"{page}, longer"))


def test_the_effect_goes_into_the_twin_and_out_again_in_two_taps(engineer: Tablet, person: Console, diagnosed: str):
    page = show(engineer, "gap", diagnosed)
    engineer.press("Add to the twin")
    expect(page.locator(".actions")).to_contain_text("Base not level is in the twin.")
    expect(page.get_by_role("button", name="Add to the twin")).to_be_disabled()
    assert effects_of(person) == ["base_tilt"]
    engineer.press("All diagnoses")
    expect(page.locator(".twin li")).to_contain_text("about x")
    engineer.press("Remove")
    check_looks(look(page, "gap with a twin"))
    assert effects_of(person) == ["base_tilt"]
    engineer.press("Remove permanently")
    expect(page.locator(".twin li")).to_have_count(0)
    assert effects_of(person) == []
    assert engineer.complaints == []


def effects_of(person: Console) -> list[str]:
    """What the twin of the cell has."""
    return [entry["effect"] for entry in person.http.get("/api/cells/lwr4_bench/twin").json()["effects"]]


def test_who_may_only_watch_sees_everything_and_which_role_may_do_what(service: RealService, browser: Browser, diagnosed: str):
    with signed_in(service, browser, WATCHER["name"], WATCHER["password"]) as at:
        page = show(at, "gap", diagnosed)
        expect(page.get_by_role("button", name="Add to the twin")).to_be_disabled()
        expect(page.locator(".actions")).to_contain_text("Only an engineer may do this.")
        check_looks(look(page, "diagnosis watched"))
        at.press("All diagnoses")
        expect(page.locator(".recording-upload button")).to_be_disabled()
        expect(page.locator(".recording-upload")).to_contain_text("Only an engineer or an operator may do this.")
        at.tap(page.get_by_role("link", name="Blind trials"))
        expect(page.get_by_role("button", name="Start a blind trial")).to_be_disabled()


def test_what_is_not_settled_names_both_and_the_motion_that_settles_it(engineer: Tablet, person: Console, diagnosed: str):
    alike, turning = sentence("They bend alike."), sentence("Turn about x.")
    tie = Tied(ids=("base_tilt", "joint_offset"), distance_sigma=2.1, why=alike, splits=turning)
    motion = Experiment(
        id="x",
        motion=turning,
        stops=TURN,
        splits=[tie.ids],
        sigma_before=2.1,
        sigma_after=11.4,
        seconds=12.0,
        planned=True,
    )
    page = show_instead(engineer, person, diagnosed, verdict="ambiguous", indistinguishable=[tie], next_experiment=motion)
    expect(page.get_by_role("heading", level=1)).to_have_text("Measure once more")
    expect(page.locator(".gap-verdict")).to_contain_text("a base that is not level or joint encoders whose zero is off")
    engineer.tap(page.locator(".evidence > summary"))
    expect(page.locator(".gap-summary h2")).to_contain_text("Not settled: Base not level or Joint encoder offset")
    expect(page.locator(".ties")).to_contain_text("2.1 standard deviations apart")
    expect(page.locator(".next-motion")).to_contain_text("Turn about x.")
    expect(page.locator(".next-motion")).to_contain_text("11.4 σ")
    expect(page.locator(".bars li", has_text="Joint encoder offset")).to_have_count(1)
    check_looks(look(page, "not settled"))
    engineer.press("Plan this motion")
    expect(page.locator(".notice:not(.alarm-band)")).to_contain_text("motion")  # the service knows that its own answer proposes none


@pytest.mark.parametrize(
    ("verdict", "said"),
    [
        ("unknown", "Ask an engineer: something is wrong that Heft does not know"),
        ("no_gap", "Nothing to do"),
        ("not_enough", "Record again"),
    ],
)
def test_a_verdict_that_names_no_effect_offers_none_for_the_twin(
    engineer: Tablet, person: Console, diagnosed: str, verdict: str, said: str
):
    nothing = {"effects": [], "where": None, "gap": None, "payload": None} if verdict == "not_enough" else {}
    page = show_instead(engineer, person, diagnosed, verdict=verdict, **nothing)
    expect(page.get_by_role("heading", level=1)).to_contain_text(said)
    expect(page.get_by_role("button", name="Add to the twin")).to_have_count(0)
    assert engineer.complaints == []


def test_an_effect_that_the_twin_does_not_take_is_not_offered_and_the_reason_is_said(
    engineer: Tablet, person: Console, diagnosed: str
) -> None:
    best, *others = answer_of(person, diagnosed).effects
    assert best.addable
    why = "base_tilt closing 1 % of the gap (3.000 before, 2.990 after, noise is 1)"
    refused = [best.model_copy(update={"addable": False, "why_not": sentence(why)}), *others]
    page = show_instead(engineer, person, diagnosed, effects=[effect.model_dump() for effect in refused])
    expect(page.get_by_role("heading", level=1)).to_have_text("Level the base")
    expect(page.get_by_role("button", name="Add to the twin")).to_have_count(0)
    engineer.tap(page.locator(".evidence > summary"))
    expect(page.locator(".gap-summary")).to_contain_text(why)
    expect(page.locator("body")).not_to_contain_text("or add the effect to the twin")
    check_looks(look(page, "an effect that the twin does not take"))


def test_what_is_seen_elsewhere_stands_beside_the_verdict_with_its_measure_and_what_to_do(
    engineer: Tablet, person: Console, diagnosed: str
) -> None:
    page = show_instead(engineer, person, diagnosed, verdict="no_gap", effects=[], also=[OTHER_PAYLOAD, NOISY, RUBBING])
    expect(page.get_by_role("heading", level=1)).to_have_text("Check the payload: it is not the one that was expected")
    expect(page.locator(".gap-verdict .further")).to_have_text("Check the cable of the sensor")
    engineer.tap(page.locator(".evidence > summary"))
    expect(page.locator(".gap-summary h2")).to_contain_text("Simulation and recording agree")
    also = page.locator(".also")
    expect(also.get_by_role("heading", level=3)).to_have_text(["Payload differs from the reference", "More sensor noise than stated"])
    expect(also).to_contain_text(OTHER_PAYLOAD["message"]["text"])
    expect(also).to_contain_text("Against the reference payload; 4.0 times what is stated or tolerated")
    expect(also).to_contain_text(NOISY["advice"]["text"])
    expect(page.locator(".minor")).to_contain_text(RUBBING["message"]["text"])
    expect(page.locator("body")).to_contain_text("Follow the advice.")
    check_looks(look(page, "seen elsewhere"))
    assert engineer.complaints == []


def show_instead(at: Tablet, person: Console, diagnosis: str, **changed: object) -> Page:
    """The page of a diagnosis whose answer is the real one but for what is changed."""
    answer = Diagnosis.model_validate(answer_of(person, diagnosis).model_dump() | changed)

    def answered(route: Route) -> None:
        response = route.fetch()
        route.fulfill(response=response, json=response.json() | {"result": json.loads(answer.model_dump_json())})

    at.page.route(f"**/api/diagnoses/{diagnosis}", answered)
    page = show(at, "gap", diagnosis)
    at.wait(".gap-verdict")
    return page


def test_a_run_that_was_stopped_is_diagnosed_from_the_list(engineer: Tablet, person: Console):
    person.take_control()
    run = person.queue(pace="real_time")
    person.wait(run, "Idle")
    assert person.release(run).status_code == 200
    person.wait_moving(run)
    person.command(run, "stop")
    person.wait(run, "Stopped")
    page = show(engineer, "gap")
    engineer.tap(page.locator(f".rows li[id='{run}']", has_text="Stopped").get_by_role("button", name="Diagnose"))
    expect(page).to_have_url(re.compile(r"#/gap/.+"))
    listed = person.http.get("/api/diagnoses").json()
    assert [each["run"] for each in listed if each["diagnosis"] == page.url.rsplit("/", 1)[1]] == [run]


@pytest.mark.parametrize("language", ["en", "de"])
def test_every_effect_has_a_name_and_every_stage_a_word(language: str):
    known = set(re.findall(r"^    (\w+): '", (WORDS / f"{language}-effects.ts").read_text(), re.MULTILINE))
    effects = (*library(), *symptoms())
    assert {effect.id for effect in effects} | {effect.stage for effect in effects} <= known
