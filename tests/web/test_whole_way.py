"""From signing in to the accepted result, by touch, on the built console and a real service."""

from __future__ import annotations

import gzip
import re

import pytest

from bench.console import first_files
from core.words.catalogue import LANGUAGES
from tests.server.real_service import ROOT
from tests.web.way import Way

BUNDLE_BYTES = 130_000
"""Of what one tablet loads: the words of one language."""


def test_the_whole_way_takes_at_most_eight_taps_beside_typing(way: Way):
    assert 0 < way.taps <= 8


def test_the_result_stands_on_the_screen_with_its_interval_and_who_accepted_it(way: Way):
    told = way.told["accepted"]
    assert "±" in told
    assert "2.78" in told
    assert "✓ Good enough for this cell" in told
    assert "Accepted by operator" in told


def test_what_is_printed_is_the_result_and_nothing_to_tap(way: Way):
    printed = way.told["printed"]
    assert all(word in printed for word in ("2.78", "±", "accepted by operator", "Not a safety function"))
    assert all(word in printed for word in ("Date", "Released by", "Accepted by", "Cell", "lwr4_bench", "Heft 0.", "Plan (SHA-256)"))
    assert re.search(r"\b[0-9a-f]{22}\b", printed), "the run"
    assert re.search(r"\b[0-9a-f]{64}\b", printed), "the plan"
    assert not any(word in printed for word in ("STOP", "Diagnosis", "Settings", "Download", "Print", "New run"))


def test_every_screen_of_a_run_says_how_to_stop_what_comes_next_and_that_it_is_no_safety_function(way: Way):
    for screen in ("plan", "about to start", "on hold"):
        told = way.told[screen]
        assert all(word in told for word in ("STOP", "Next", "Not a safety function", "You have control")), screen


def test_a_run_is_held_and_goes_on_from_every_screen_and_stopped_by_whoever_looks_on(way: Way):
    assert "▶ Resume" in way.told["on hold"]
    assert all(word in way.told["history on hold"] for word in ("STOP", "▶ Resume"))
    assert "STOP" in way.told["watched on hold"]
    assert "▶ Resume" not in way.told["watched on hold"]


def test_the_browser_complains_of_nothing(way: Way):
    assert way.complaints == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_bundle_is_small(language: str):
    """What a tablet loads that carries out runs: everything but other languages and the pages that come when somebody goes there."""
    loaded = first_files(ROOT / "web" / "dist", language)
    assert sum(len(gzip.compress(file.read_bytes())) for file in loaded) <= BUNDLE_BYTES
    assert [file.name[:2] for file in loaded if re.match(r"\w\w-(all|later)-", file.name)] == [language]
    assert not [file.name for file in loaded if "-page-" in file.name]
