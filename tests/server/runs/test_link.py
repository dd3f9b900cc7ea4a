"""What is said of the link is what its answers were like."""

from __future__ import annotations

import numpy as np
import pytest

from server.runs.link import ADVISED_SHARE, FEWEST, WINDOW_S, Link

PERIOD = 0.05


def answered(link: Link, round_trips: list[float], begin: float = 100.0) -> float:
    """A stamp every 50 ms, answered in order as on TCP; returns when the last answer came."""
    arrivals = np.maximum.accumulate([begin + k * PERIOD + trip for k, trip in enumerate(round_trips)])
    moments = [(begin + k * PERIOD, 0, begin + k * PERIOD) for k in range(len(round_trips))]
    moments += [(float(arrival), 1, begin + k * PERIOD) for k, arrival in enumerate(arrivals)]
    for at, kind, stamp in sorted(moments):
        if kind == 0:
            link.note_stamp(stamp)
        else:
            link.note_answer(stamp, at)
    return float(arrivals[-1])


def test_before_there_are_enough_answers_nothing_is_said():
    link = Link()
    now = answered(link, [0.01] * (FEWEST - 1))
    assert link.figures(1.0, now) is None


def test_quantiles_are_those_of_the_round_trips():
    trips = np.random.default_rng(1).uniform(0.005, 0.03, 1000).tolist()
    link = Link()
    found = link.figures(1.0, answered(link, trips))
    assert found.round_trip_p50_s == pytest.approx(np.median(trips), abs=1e-3)
    assert found.round_trip_p99_s == pytest.approx(np.quantile(trips, 0.99), abs=1e-3)
    assert found.lost_share == 0.0
    assert found.longest_gap_s == pytest.approx(PERIOD + 0.03, abs=0.03)
    assert found.advised


def test_a_silence_is_the_longest_gap_and_a_release_is_advised_against_where_it_comes_near_the_lease():
    trips = [0.01] * 200
    trips[100] = 0.9  # TCP: what is behind it waits for it
    link = Link()
    found = link.figures(1.0, answered(link, trips))
    assert found.longest_gap_s == pytest.approx(0.9 + PERIOD, abs=0.02)
    assert not found.advised
    assert found.longest_gap_s > ADVISED_SHARE
    assert link.figures(5.0, answered(Link(), trips)).advised


def test_a_silence_that_goes_on_counts_while_it_goes_on():
    link = Link()
    now = answered(link, [0.01] * 100)
    assert link.figures(1.0, now + 0.8).longest_gap_s == pytest.approx(0.81, abs=0.01)


def test_stamps_that_were_never_answered_are_lost():
    link = Link()
    now = answered(link, [0.01] * 100)
    for k in range(100):
        link.note_stamp(now + PERIOD * (k + 1))
    found = link.figures(1.0, now + 100 * PERIOD + 5.0)
    assert found.lost_share == pytest.approx(0.5, abs=0.02)


def test_what_was_longer_ago_than_a_minute_is_forgotten():
    link = Link()
    end = answered(link, [0.5] * 40)
    now = answered(link, [0.01] * 1300, begin=end + 1.0)
    found = link.figures(1.0, now)
    assert found.round_trip_p99_s < 0.02
    assert found.window_s <= WINDOW_S + 1e-6
