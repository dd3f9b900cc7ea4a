"""The sheet as a page with pictures."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np

from core.trial.outcome import Named, TrialOutcome
from core.trial.sheet import confusions, detections, score_sheet, write_sheet
from core.words.catalogue import LANGUAGES
from tests.core.trial.synthetic_outcomes import double, none, payload, sealed, single, unknown

STOPPED = TrialOutcome(sealed=sealed(44, "cable_drag"), stopped="TooFast: the elbow was at 0.3 m/s", verdict="stopped")
SOME = [
    none(0),
    single(1, "time_delay", "time_delay", payload=payload(0.03, 0.001, 0.001)),
    single(2, "time_delay", "sensor_lowpass"),
    single(3, "base_tilt", "base_tilt", verdict="no_gap", effects=()),
    unknown(4),
    double(7, ("base_tilt", "time_delay")),
    STOPPED,
]


def test_every_failure_stands_there_with_the_command_that_replays_it():
    failures = score_sheet(SOME).split("## Not right")[1]
    assert "`heft trial --seed 2`" in failures
    assert "`heft trial --seed 44`: cable_drag (plain)" in failures
    assert "TooFast" in failures
    assert "--seed 1`" not in failures


def test_the_sheet_says_how_it_was_made_and_stands_against_what_was_wanted():
    sheet = score_sheet(SOME)
    assert "`heft trial --seeds 0-4,7,44` (7 trials" in sheet
    assert "| false alarms on runs without effect | <= 0.5 % | 0.0 % (0 of 1;" in sheet
    assert "| unknown called unknown | >= 93 % | 100.0 % (1 of 1;" in sheet


def test_a_calibration_error_stands_beside_what_chance_makes_of_it():
    assert re.search(r"\| calibration error of the first answer \| <= 0\.02 \| [\d.]+ \(by chance [\d.]+-[\d.]+,", score_sheet(SOME))


def test_a_first_name_of_an_open_verdict_is_a_name_but_not_told_outright():
    answers = [single(1, "time_delay", "time_delay"), single(2, "time_delay", "time_delay", verdict="ambiguous")]
    sheet = score_sheet([*answers, single(3, "time_delay", "sensor_lowpass")])
    outright, named, tied = (sheet.index(row) for row in ("told outright", "named, and nothing else", "with declared ties"))
    assert outright < named < tied
    assert "read off beside no gap) | >= 88 % | 33.3 % (1 of 3;" in sheet
    assert "named, and nothing else | >= 88 % | 66.7 % (2 of 3;" in sheet


def test_closures_have_their_worst_tenth_beside_the_median():
    def closing(seed: int, first: float) -> TrialOutcome:
        names = (Named(id="sensor_lowpass", probability=0.9, closure=first), Named(id="time_delay", probability=0.1, closure=0.8))
        return single(seed, "time_delay", "sensor_lowpass", effects=names)

    sheet = score_sheet([closing(k, 0.08 * k) for k in range(11)])
    assert "closure over the true effect's, median | >= 0.98 | 0.5 |" in sheet
    assert "closure over the true effect's, 10th percentile | >= 0.9 | 0.1 |" in sheet


def test_wanted_limits_are_those_of_what_the_rows_measure():
    """The time that is wanted is of two quiet cores, and trials are diagnosed on one."""
    wanted = dict(re.findall(r"^\| ([^|]+) \| ([^|]+) \| [^|]+ \|$", score_sheet(SOME).split("## By kind")[0], re.MULTILINE))
    assert wanted["diagnosis on one core, median"] == "-"
    assert sorted(limit for limit in wanted.values() if "%" in limit and "noise" not in limit) == sorted([
        "<= 0.5 %", ">= 88 %", ">= 88 %", ">= 94 %", ">= 97 %", ">= 98 %", ">= 97 %", ">= 93 %", ">= 85 %", "<= 3 %", "94-96 %", "94-96 %",
    ])  # fmt: skip


def test_confusions_and_detections_are_counted_by_effect():
    assert confusions(SOME)["time_delay", "sensor_lowpass"] == 1
    assert confusions(SOME)["base_tilt", "no_gap"] == 1
    assert detections(SOME)["time_delay"] == [(100.0, True), (100.0, False)]


def test_pictures_are_files_beside_the_page_and_repeatable(tmp_path: Path):
    for folder in (tmp_path / "a", tmp_path / "b"):
        folder.mkdir()
        write_sheet(folder, SOME)
    page = (tmp_path / "a" / "trials.md").read_text()
    for name in ("confusion", "reliability", "closure", "detection"):
        picture = tmp_path / "a" / f"{name}.svg"
        assert f"({name}.svg)" in page
        assert ET.parse(picture).getroot().tag.endswith("svg")
        assert picture.read_bytes() == (tmp_path / "b" / f"{name}.svg").read_bytes()
    assert "base_tilt" in (tmp_path / "a" / "confusion.svg").read_text()
    assert not list(tmp_path.rglob("*.part"))


def test_a_german_sheet_has_no_english_words(tmp_path: Path):
    pages = {}
    for language in LANGUAGES:
        write_sheet(tmp_path, SOME, language)
        pictures = [text for picture in sorted(tmp_path.glob("*.svg")) for text in re.findall(r">([^<>]+)</text>", picture.read_text())]
        cells = re.split(r"[|\n]", (tmp_path / "trials.md").read_text())
        pages[language] = {text.strip() for text in [*cells, *pictures]}
    shared = [text for text in pages["en"] & pages["de"] if {*re.findall(r"\b[A-Za-zÄÖÜäöüß]{2,}\b", text)}]
    assert sorted(shared) == []
    assert any("keine Abweichung" in text for text in pages["de"])
    assert not [text for text in pages["de"] if "sheet-" in text or re.search(r"\d\.\d+ %", text)]


def test_a_sheet_of_stopped_runs_alone_has_no_pictures(tmp_path: Path):
    write_sheet(tmp_path, [STOPPED])
    assert not list(tmp_path.glob("*.svg"))
    assert "none drawn" in (tmp_path / "trials.md").read_text()


def test_a_sheet_holds_no_number_that_is_none(tmp_path: Path):
    rng = np.random.default_rng(0)
    many = [single(k, "time_delay", "time_delay", float(rng.uniform(0.5, 1)), size=float(k + 1)) for k in range(5)]
    assert "nan" not in score_sheet(many).replace("dominant", "")
