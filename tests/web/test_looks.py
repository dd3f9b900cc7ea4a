"""Every screen in both orientations and themes: can it be read and hit, and does colour mean what it should?"""

from __future__ import annotations

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
