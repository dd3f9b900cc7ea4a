"""A page in another language has none of the English words: no heading, label or sentence of its own is the same in both."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import partial
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest

from core.estimation.estimate import Verification
from core.payload.inertia import InertialParameters
from core.payload.known_tool import KnownTool
from core.report.diagnosis_page import write_diagnosis
from core.report.motions import name_motion
from core.report.page import write_report
from core.second_opinion.opinion import Approach, LostLoad, Opinion, PeakSpeed
from core.second_opinion.pairs import AccountedPair, PairKind
from core.words.catalogue import LANGUAGES, Language
from core.words.message import Message
from core.words.wording import Wording
from tests.core.report.made_up_diagnoses import CASES, overlay, with_verdict
from tests.core.report.test_page import case

WORD = re.compile(r"\b[A-Za-zÄÖÜäöüß]{2,}\b")
SAME = {
    "Heft", "CAD", "kg", "mm", "ms", "Hz", "rad", "mrad", "fx", "fy", "fz", "tx", "ty", "tz", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz",
    "Software", "safety_rated", "false", "bench", "operator", "fixture", "gripper", "in", "Gripper", "Sensor", "sensor",
}  # fmt: skip
"""Units, symbols, identifiers, and names that somebody gave."""


class Texts(HTMLParser):
    """Every text that a person reads or hears of a page."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.found: list[str] = []
        self.language: str | None = None
        self.styles = False
        self.feed(page)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.styles = tag == "style"
        self.found += [value or "" for name, value in attrs if name == "aria-label"]
        if tag == "html":
            self.language = dict(attrs)["lang"]

    def handle_endtag(self, _: str) -> None:
        self.styles = False

    def handle_data(self, data: str) -> None:
        if not self.styles:
            self.found.append(" ".join(data.split()))


SILENCE, NAME = Message.of("text", text=""), Message.of("text", text="gripper")


def in_both(english: str, german: str, quoted: set[str]) -> list[str]:
    """Texts with words that stand in both pages, but for names, units and what is quoted from elsewhere."""
    shared = {*Texts(english).found} & {*Texts(german).found} - quoted
    return sorted(text for text in shared if {*WORD.findall(text)} - SAME)


def report(folder: Path, language: Language) -> str:
    """A run with everything that a report can have; what the engine says of it is a message."""
    recording, identification, run = case()
    assert run is not None and identification.estimate is not None
    expected = np.array([0.3, 0.3, 0.3, 0.02, 0.02, 0.02])
    turned = {"rotate:x": 1, "rotate:y": 3}
    left_out = [Verification(motion, 9, rms=k * expected, noise=expected, expected=expected) for motion, k in turned.items()]
    approaches = tuple(Approach(kind, "payload", "bench", 0.05, 0.03, "transfer x+", 1.25) for kind in PairKind)
    lost = LostLoad(zone="operator", distance_m=0.2, speed_m_s=0.2, part="rotation y", time_s=3.0)
    pairs = (AccountedPair("link1", "floor", PairKind.JOINED, 0.0, Message.of("opinion-pair-declared"), (0, 1), 1),)
    opinion = Opinion(approaches, PeakSpeed(0.24, 0.25, "payload", "home", 2.0), pairs, 900, lost)
    tool = KnownTool("gripper", "gripper", InertialParameters.from_com(0.4, np.zeros(3), 1e-4 * np.eye(3)), np.full(10, 1e-4))
    wrong = replace(identification.estimate, determined=np.arange(10) < 4, consistent=False)
    for name, answer in (("whole", identification), ("partly", replace(identification, estimate=wrong))):
        write_report(
            folder / f"{name}.html",
            recording=replace(recording, tools=(tool,), tau=np.zeros((len(recording), 7))),
            identification=replace(answer, verdict=SILENCE, warnings=(), accounted=("base_tilt",), verified=partial(tuple, left_out)),
            run=replace(run, opinion=opinion, restarts=1, beyond_first_m=0.2),
            language=language,
        )
    return "".join((folder / f"{name}.html").read_text(encoding="utf-8") for name in ("whole", "partly"))


def test_a_german_report_has_no_english_words(tmp_path: Path) -> None:
    recording, _, _ = case()
    quoted = {recording.source, "steel block", "KUKA LWR 4+ on a bench, two walls, the operator in front"}
    pages = {language: report(tmp_path, language) for language in LANGUAGES}
    assert {language: Texts(page).language for language, page in pages.items()} == {"en": "en", "de": "de"}
    assert in_both(pages["en"], pages["de"], quoted) == []
    assert "report-" not in pages["de"]


def test_a_german_report_writes_numbers_with_a_comma(tmp_path: Path) -> None:
    read = " ".join(Texts(report(tmp_path, "de")).found)
    assert "2,7841 kg" in read and "+0,500°; -0,250°" in read and "Grenze 0,030 m" in read
    given = read.replace("0.1.0", "")
    assert re.findall(r"\d\.\d+ (?:m|kg|N|s|%|mm)\b", given) == []


@pytest.mark.parametrize("verdict", CASES)
def test_a_german_diagnosis_has_no_english_words(verdict: str, tmp_path: Path) -> None:
    base = CASES[verdict]
    where = None if base.where is None else base.where.model_copy(update={"message": SILENCE, "by_pose": {"x+": 1.0, "x-": 2.0}})
    experiment = base.next_experiment and base.next_experiment.model_copy(update={"motion": SILENCE, "refused": None})
    changes = {
        "summary": SILENCE, "consequence": None, "limits": [], "where": where, "next_experiment": experiment, "twin": ["gripper"],
        "effects": [effect.model_copy(update={"title": NAME, "advice": SILENCE}) for effect in base.effects],
        "also": [each.model_copy(update={"title": NAME, "message": SILENCE, "advice": SILENCE}) for each in base.also],
        "minor": [each.model_copy(update={"id": "gripper", "message": SILENCE}) for each in base.minor],
        "indistinguishable": [each.model_copy(update={"why": SILENCE, "splits": SILENCE}) for each in base.indistinguishable],
    }  # fmt: skip
    silent = base.model_copy(update=changes)
    pages = {}
    for language in LANGUAGES:
        write_diagnosis(tmp_path / "page.html", diagnosis=silent, overlay=overlay(), language=language)
        pages[language] = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert in_both(pages["en"], pages["de"], set()) == []
    assert "report-gap" not in pages["de"]


def test_what_the_engine_says_is_said_in_the_pages_language(tmp_path: Path) -> None:
    axes = Message.of("planning-rejected", reason=Message.of("report-gap-still"), count=3)
    write_diagnosis(
        tmp_path / "page.html", diagnosis=with_verdict("explained").model_copy(update={"summary": axes}), overlay=None, language="de"
    )
    assert "Stillstand 3." in (tmp_path / "page.html").read_text(encoding="utf-8")


def test_motions_are_named_in_the_language() -> None:
    english, german = Wording("en"), Wording("de")
    for name in ("hold:x+", "rotate:y", "transfer:home", "hold x+", "rotation y", "transfer x-", "wave z+", "transfer", "home"):
        assert name_motion(name, english) == name
        assert name_motion(name, german) != name
    assert name_motion("somebody's motion", german) == "somebody's motion"
