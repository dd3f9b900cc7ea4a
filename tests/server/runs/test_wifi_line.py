"""The line between console and service is as bad as it says, and loses nothing."""

from __future__ import annotations

import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress

import numpy as np
import pytest

from tests.server.wifi_line import GAP_EVERY_S, GAP_S, GAPS, GOOD, POOR, Gaps, Profile, Way, WifiLine

DRAWN = 4_000_000
"""Enough for the 99.9th percentile to be known to 1 %."""


@contextmanager
def echo() -> Iterator[int]:
    """The port of a server that sends back what it gets."""

    def answer(connection: socket.socket) -> None:
        with suppress(OSError), connection:
            while data := connection.recv(4096):
                connection.sendall(data)

    def accept() -> None:
        with suppress(OSError):
            while True:
                threading.Thread(target=answer, args=(server.accept()[0],), daemon=True).start()

    with socket.create_server(("127.0.0.1", 0)) as server:
        threading.Thread(target=accept, daemon=True).start()
        yield server.getsockname()[1]
        server.shutdown(socket.SHUT_RDWR)


@pytest.fixture
def line() -> Iterator[WifiLine]:
    with echo() as port, WifiLine(port, GOOD) as found:
        yield found


def connected(line: WifiLine) -> socket.socket:
    host, port = line.address.split(":")
    return socket.create_connection((host, int(port)), timeout=30)


def round_trips(profile: Profile) -> np.ndarray:
    """Of single messages, each sent when the one before has come back, s."""
    rng = np.random.default_rng(1)
    return profile.drawn_s(rng, DRAWN) + profile.drawn_s(rng, DRAWN)


def test_a_good_line_takes_5_to_30_ms_there_and_back():
    found = round_trips(GOOD)
    assert found.min() >= 0.005
    assert found.max() <= 0.030


def test_a_poor_line_takes_150_ms_at_the_99th_percentile_and_800_ms_at_the_999th_of_1000():
    p50, p99, p999 = np.quantile(round_trips(POOR), [0.5, 0.99, 0.999])
    assert p50 < 0.03
    assert p99 == pytest.approx(0.150, rel=0.03)
    assert p999 == pytest.approx(0.800, rel=0.03)


def test_what_comes_late_holds_up_all_behind_it():
    way = Way(POOR, Gaps(False, 0), np.random.default_rng(0))
    sent = 0.05 * np.arange(20_000)
    arrived = np.array([way.arrival_s(each) for each in sent])
    alone = POOR.drawn_s(np.random.default_rng(0), len(sent)) + sent
    assert (np.diff(arrived) >= 0).all()
    np.testing.assert_allclose(arrived, np.maximum.accumulate(alone))
    assert (arrived > alone).mean() > 0.005


def test_one_gap_begins_every_minute_and_nothing_arrives_in_it():
    gaps = Gaps(True, 3)
    found = np.array(gaps.within(0.0, 100 * GAP_EVERY_S))
    begin, end = found.T
    assert len(found) == 100
    assert 0.0 <= begin[0] < GAP_EVERY_S
    np.testing.assert_allclose(np.diff(begin), GAP_EVERY_S)
    assert ((end - begin >= GAP_S[0]) & (end - begin <= GAP_S[1])).all()
    assert np.ptp(end - begin) > 1.2
    way = Way(GAPS, gaps, np.random.default_rng(0))
    arrived = np.array([way.arrival_s(each) for each in np.arange(0.0, 600.0, 0.05)])
    assert not any(((arrived > a) & (arrived < b)).any() for a, b in found)
    assert (np.isin(arrived, end).sum()) > 10


def test_a_moment_after_a_gap_passes_as_it_is_due_and_a_line_without_gaps_has_none():
    gaps = Gaps(True, 3)
    [(begin, end)] = gaps.within(0.0, GAP_EVERY_S)
    assert gaps.passes_s(end) == end
    assert gaps.passes_s((begin + end) / 2) == end
    assert gaps.passes_s(begin - 1e-6) == begin - 1e-6
    assert Gaps(False, 3).within(0.0, 1e4) == []


def test_phases_of_the_gaps_are_spread_over_the_minute():
    first = [Gaps(True, seed).within(0.0, GAP_EVERY_S)[0][0] for seed in range(300)]
    assert np.histogram(first, bins=3, range=(0.0, GAP_EVERY_S))[0].min() > 70


def test_everything_comes_back_whole_and_in_order(line: WifiLine):
    sent = np.random.default_rng(0).bytes(3_000_000)
    with connected(line) as near:
        threading.Thread(target=lambda: (near.sendall(sent), near.shutdown(socket.SHUT_WR)), daemon=True).start()
        back = b"".join(iter(lambda: near.recv(65_536), b""))
    assert back == sent


def test_connections_are_carried_beside_each_other(line: WifiLine):
    with connected(line) as one, connected(line) as other:
        other.sendall(b"b")
        assert other.recv(1) == b"b"
        one.sendall(b"a")
        assert one.recv(1) == b"a"


def test_nothing_is_back_sooner_than_the_line_takes_at_least(line: WifiLine):
    with connected(line) as near:
        for _ in range(10):
            began = line.now_s
            near.sendall(b"x")
            assert near.recv(1) == b"x"
            assert line.now_s - began >= 0.005


def test_a_service_that_is_gone_closes_what_its_line_carries():
    with echo() as port:
        pass
    with WifiLine(port, GOOD) as line, connected(line) as near:
        assert near.recv(1) == b""
