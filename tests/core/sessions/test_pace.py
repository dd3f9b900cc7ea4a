import pytest

from core.sessions.pace import AsFastAsPossible, RealTime


class WallClock:
    """A clock that only sleeping and the test move."""

    def __init__(self):
        self.now = 100.0
        self.slept = []

    def time(self):
        return self.now

    def sleep(self, seconds):
        assert seconds >= 0
        self.slept.append(seconds)
        self.now += seconds


@pytest.mark.parametrize("speed", [0.5, 1.0, 4.0])
def test_real_time_keeps_to_the_wall_clock_without_adding_up_errors(speed):
    wall = WallClock()
    pace = RealTime(speed, clock=wall.time, sleep=wall.sleep)
    for k in range(1000):
        wall.now += 1e-5  # what the caller does meanwhile
        pace.wait_until(0.001 * k)
    assert wall.now - 100.0 == pytest.approx(0.999 / speed, abs=2e-5)


def test_a_late_session_catches_up_instead_of_sleeping():
    wall = WallClock()
    pace = RealTime(clock=wall.time, sleep=wall.sleep)
    pace.wait_until(0.0)
    wall.now += 0.0105
    for k in range(1, 11):
        pace.wait_until(0.001 * k)
    assert wall.slept == []
    pace.wait_until(0.011)
    assert wall.slept == [pytest.approx(0.0005)]


def test_late_samples_are_counted_with_the_latest_of_them():
    wall = WallClock()
    pace = RealTime(clock=wall.time, sleep=wall.sleep)
    for k, held_up in enumerate([0.0, 0.0, 0.02, 0.0, 0.0]):
        wall.now += held_up
        pace.wait_until(0.01 * k)
    assert (pace.ticks, pace.late) == (5, 1)
    assert pace.latest_s == pytest.approx(0.01)
    assert pace.median_s == pytest.approx(0.0, abs=1e-9)


def test_a_pause_is_neither_late_nor_made_up_for():
    wall = WallClock()
    pace = RealTime(clock=wall.time, sleep=wall.sleep)
    pace.wait_until(0.0)
    wall.now += 30.0
    pace.wait_until(0.001)
    pace.wait_until(0.002)
    assert wall.slept == [pytest.approx(0.001)]
    assert pace.late == 0


def test_real_time_starts_with_the_first_sample_whatever_its_clock_says():
    wall = WallClock()
    pace = RealTime(clock=wall.time, sleep=wall.sleep)
    pace.wait_until(5000.0)
    assert wall.slept == []


def test_as_fast_as_possible_asks_no_clock(monkeypatch):
    def refuse(*_):
        raise AssertionError("a clock was asked")

    monkeypatch.setattr("time.sleep", refuse)
    monkeypatch.setattr("time.monotonic", refuse)
    AsFastAsPossible().wait_until(1e9)
