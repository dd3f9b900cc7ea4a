"""From signing in to the accepted result, by touch, on the built console and a real service: what it takes, what it says, and whether
every screen of it, in both orientations and themes, can be read and hit, with colours that mean what they should."""

from __future__ import annotations

import gzip
import re

import pytest

from bench.console import first_files
from core.words.catalogue import LANGUAGES
from tests.server.real_service import ROOT
from tests.web.judgement import (
    check_axe,
    check_colours_of_the_abnormal,
    check_nothing_is_cut_off,
    check_room_round_what_moves,
    check_targets,
    is_green,
    is_red,
    is_yellow,
    saturation,
)
from tests.web.way import Way

SCREENS = {"sign in", "cell and tool", "plan", "about to start", "on hold", "watched on hold", "result", "accepted"}
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


def test_a_run_can_be_diagnosed_from_its_result(way: Way):
    assert "Diagnose the gap" in way.told["result"]


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


def test_every_screen_was_looked_at_in_both_orientations_and_themes(way: Way):
    assert {each.page for each in way.looks} >= SCREENS
    assert len(way.looks) == 4 * len({each.page for each in way.looks})


def test_axe_finds_nothing_at_a_contrast_of_seven_to_one(way: Way):
    check_axe(way.looks)


def test_targets_are_large_and_those_that_move_the_robot_larger(way: Way):
    check_targets(way.looks)


def test_nothing_is_near_what_moves_the_robot(way: Way):
    check_room_round_what_moves(way.looks)


def test_red_and_yellow_are_kept_for_what_is_abnormal(way: Way):
    check_colours_of_the_abnormal(way.looks)


def test_start_is_not_red_and_stop_is_not_green(way: Way):
    starts = backgrounds(way, "press press-start")
    stops = backgrounds(way, "press press-stop")
    assert starts
    assert stops
    assert not any(is_red(colour) for colour in starts)
    assert not any(is_green(colour) for colour in stops)
    assert all(saturation(colour) < 0.1 for colour in (*starts, *stops))


def test_nothing_is_cut_off(way: Way):
    check_nothing_is_cut_off(way.looks)


def backgrounds(way: Way, of: str) -> list[str]:
    """Backgrounds of everything with these classes."""
    return [said["colour"] for each in way.looks for said in each.colours if said["of"] == of and said["kind"] == "backgroundColor"]


def test_the_judgement_of_colours_knows_red_yellow_and_green():
    assert is_red("rgb(163, 8, 27)")
    assert is_yellow("rgb(255, 210, 31)")
    assert is_green("rgb(0, 128, 0)")
    assert not any(judged("rgb(20, 24, 27)") for judged in (is_red, is_yellow, is_green))


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_bundle_is_small(language: str):
    """What a tablet loads that carries out runs: everything but other languages and the pages that come when somebody goes there."""
    loaded = first_files(ROOT / "web" / "dist", language)
    assert sum(len(gzip.compress(file.read_bytes())) for file in loaded) <= BUNDLE_BYTES
    assert [file.name[:2] for file in loaded if re.match(r"\w\w-(all|later)-", file.name)] == [language]
    assert not [file.name for file in loaded if "-page-" in file.name]
