"""The report of a diagnosis: one file, in words first, for every verdict, and in colour only where something is abnormal."""

from __future__ import annotations

import html
import re
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest

from core.gap.answer import Diagnosis, Pair
from core.report import diagnosis_page
from core.report.diagnosis_page import Overlay, worst_motion, write_diagnosis
from tests.core.report.made_up_diagnoses import CASES, explained, overlay, say, with_verdict


def written(folder: Path, diagnosis: Diagnosis, drawn: Overlay | None = None) -> str:
    write_diagnosis(folder / "diagnosis.html", diagnosis=diagnosis, overlay=drawn)
    assert [file.name for file in folder.iterdir()] == ["diagnosis.html"]
    return (folder / "diagnosis.html").read_text(encoding="utf-8")


def words(text: str) -> str:
    """What a person reads."""
    text = re.sub(r"<style>.*?</style>", "", text, flags=re.DOTALL)
    return " ".join(html.unescape(re.sub(r"<[^>]*>", " ", text)).split())


def alarms(text: str) -> list[str]:
    return re.findall(r'<(?:h1|td|dd) class="alarm">(.*?)<', text)


class Tags(HTMLParser):
    """Fails on a tag that is closed twice, or never; keeps the attributes."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.values: list[tuple[str, str]] = []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.values += [(name, value or "") for name, value in attrs]
        if tag not in ("meta", "br"):
            self.open.append(tag)

    def handle_startendtag(self, _: str, attrs: list[tuple[str, str | None]]) -> None:
        self.values += [(name, value or "") for name, value in attrs]

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.mark.parametrize("verdict", CASES)
def test_every_verdict_has_a_page_that_is_well_formed_and_loads_nothing(verdict: str, tmp_path: Path) -> None:
    text = written(tmp_path, CASES[verdict], None if verdict == "not_enough" else overlay())
    values = Tags(text).values
    assert "<script" not in text and "@import" not in text
    assert all(value.startswith("#") for name, value in values if name in ("src", "href", "xlink:href"))
    assert not [value for _, value in values if re.search(r"url\((?!#)", value)]
    read = words(text)
    assert f"This is {verdict}." in read
    assert not re.search(r"\b(nan|inf|None|Undefined)\b", read)
    ids = re.findall(r' id="([^"]*)"', text)
    assert len(ids) == len(set(ids))


def test_an_explained_gap_is_told_in_words_and_numbers(tmp_path: Path) -> None:
    text = words(written(tmp_path, explained(), overlay()))
    for said in (
        "? Ask an engineer: the force arrives late The clocks of robot and sensor have to agree; nothing has to be repaired.",
        "nothing has to be repaired. Check the cable of the sensor",
        "Gap explained",
        "The gap is explained by a late wrench.",
        "What to do Fix a late wrench.",
        "For the payload Left out, it changes the inertia.",
        "Gap 9.80 noise alone is 1",
        "Gap with the effect added 1.25",
        "Probability 93.0 % of a late wrench",
        "Closure 97 % 95 %: 95 to 98 %",
        "A late wrench time_delay 93.0 % 97 % (95 to 98 %) 1.25 delay 12.30 ± 0.40 ms",
        "lag 100 ms (at its bound)",
        "A late wrench and a tilted base time_delay + base_tilt 0.7 % 98 % 1.10",
        "Something that the library does not have 2.0 %",
        "No effect < 0.1 %",
        "Not shown: 1 other effect, together 0.3 %. They would have closed: a tilted base 12 %.",
        "From 9.80 to 1.25 times the noise",
        "predicted from the others: hold:x+, rotate:y.",
        "The worst motion: fz and tx during rotate:y",
        "Noise above what is stated (in the sensor's readings; 2.0 times what is stated or tolerated): There is noise above",
        "Friction (at the joints; 2.0 times what is stated or tolerated): There is friction. It does not matter.",
        "Do without noise above what is stated.",
        "Friction in the joints: Joint 1 rubs. joint 1 Coulomb friction 3.00 ± 0.10 N m",
        "Drift of the sensor's offset: no temperature was recorded.",
        " in 6.1 s",
    ):
        assert said in text, said
    assert "Fix a lag of the motion" not in text
    assert "Do without friction" not in text
    assert "Next experiment" not in text


def test_an_unsettled_gap_says_what_would_settle_it_before_what_to_fix(tmp_path: Path) -> None:
    text = words(written(tmp_path, CASES["ambiguous"]))
    settle, delay, lag = (
        text.index(said)
        for said in ("Settle first which it is", "If it is a late wrench: Fix a late", "If it is a lag of the motion: Fix a lag")
    )
    assert settle < delay < lag
    assert "If it is a tilted base" not in text
    assert "A late wrench or a lag of the motion. 2.1 σ apart: Both are late. It would be settled by: A wide-band motion." in text
    assert "Rotate about a horizontal axis. It takes 12 s." in text
    assert "It tells apart a late wrench from a lag of the motion" in text


def test_an_unknown_cause_has_no_advice_to_add_an_effect(tmp_path: Path) -> None:
    text = words(written(tmp_path, CASES["unknown"]))
    assert "Add no effect to the simulation: none of them is the cause. Look at tx during rotate:y first." in text
    assert "Fix a late wrench" not in text
    assert "90.0 % of an unknown effect" in text
    assert text.index("Something that the library does not have 90.0 %") < text.index("No effect < 0.1 %")
    assert "neither column can be trusted" in text


def test_two_effects_at_once_have_the_advice_of_both(tmp_path: Path) -> None:
    pair = Pair(ids=("time_delay", "base_tilt"), probability=0.95, gap_after=1.0, closure=0.99)
    text = words(written(tmp_path, with_verdict("explained", pairs=[pair])))
    assert "Fix a late wrench. Fix a tilted base." in text
    assert "Probability 95.0 % of a late wrench and a tilted base" in text


def test_a_recording_that_says_too_little_gets_that_and_nothing_else(tmp_path: Path) -> None:
    text = written(tmp_path, CASES["not_enough"])
    assert re.findall(r"<h[23][^>]*>(.*?)</h", text) == ["Too little to say anything", "What this recording cannot say"]
    assert "Record again" in words(text) and "no wrench was recorded" in words(text).lower()
    assert "<svg" not in text and "<table" not in text


def test_colour_is_only_where_something_is_abnormal(tmp_path: Path) -> None:
    calm = written(tmp_path, CASES["no_gap"].model_copy(update={"also": []}))
    assert alarms(calm) == []
    assert '<table class="heat calm">' in calm
    assert "var(--alarm)" not in re.sub(r"<style>.*?</style>", "", calm, flags=re.DOTALL)
    assert alarms(written(tmp_path, explained())) == [
        "? Ask an engineer: the force arrives late",
        "9.80",
        "-5.00 %",
    ]  # the gap, and Ixx of 0.002 over 0.04
    assert alarms(written(tmp_path, CASES["unknown"]))[0] == "? Ask an engineer: something is wrong that Heft does not know"


def test_the_bars_of_what_remains_are_in_colour_where_it_matters(tmp_path: Path) -> None:
    chart = re.findall(r'<svg class="chart".*?</svg>', written(tmp_path, explained()), flags=re.DOTALL)
    assert len(chart) == 1
    assert chart[0].count("var(--alarm)") == 1  # ty, 2.5 after
    assert all(f"{number:.2f}" in chart[0] for number in (9.0, 4.0, 2.5))


def test_the_overlay_shows_the_motion_that_lacks_most_without_joining_others() -> None:
    assert worst_motion(overlay()) == slice(100, 200)


def test_an_overlay_without_a_change_has_one_line(tmp_path: Path) -> None:
    drawn = overlay()
    same = Overlay(drawn.t, drawn.phase, drawn.measured, drawn.before, drawn.before, drawn.noise_std)
    assert "simulated before" not in words(written(tmp_path, explained(), same))
    assert "simulated before" in words(written(tmp_path, explained(), drawn))


def test_words_from_outside_stay_words(tmp_path: Path) -> None:
    attack = "<script>alert(1)</script>"
    base = explained()
    assert base.where is not None
    where = base.where.model_copy(update={"message": say(attack), "cells": [base.where.cells[0].model_copy(update={"phase": attack})]})
    drawn = overlay()
    named = Overlay(drawn.t, np.full(300, attack), drawn.measured, drawn.before, drawn.after, drawn.noise_std)
    text = written(
        tmp_path, with_verdict("explained", summary=say(attack), consequence=say(attack), limits=[say(f"{attack}!")], where=where), named
    )
    assert "<script" not in text
    assert text.count("&lt;script&gt;alert(1)") == 6


def test_a_report_that_fails_leaves_the_older_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "diagnosis.html").write_text("the older one")

    def fail(*_: object) -> Iterator[str]:
        raise RuntimeError("no charts today")

    monkeypatch.setattr(diagnosis_page, "gap_chart", fail)
    with pytest.raises(RuntimeError):
        write_diagnosis(tmp_path / "diagnosis.html", diagnosis=explained(), overlay=None)
    assert (tmp_path / "diagnosis.html").read_text() == "the older one"
    assert len(list(tmp_path.iterdir())) == 1


def test_the_same_answer_gives_the_same_page(tmp_path: Path) -> None:
    assert written(tmp_path, explained(), overlay()) == written(tmp_path, explained(), overlay())
