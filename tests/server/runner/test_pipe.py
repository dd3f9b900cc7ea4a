"""Neither end of the pipe waits for the other."""

from __future__ import annotations

import time
from multiprocessing import Pipe

import pytest

from core.errors import Commanded, Held
from core.sessions.leased import Lease, Renewal
from server.runner.messages import End, Hold, Release, Resume
from server.runner.pipe import Listener, Speaker
from tests.server.sentence import sentence


def until(condition) -> None:
    limit = time.monotonic() + 10
    while not condition():
        assert time.monotonic() < limit
        time.sleep(0.002)


@pytest.fixture
def ends():
    ours, theirs = Pipe()
    yield ours, theirs
    ours.close()
    theirs.close()


def test_a_reader_that_is_frozen_delays_no_speaker_and_loses_only_what_is_old(ends):
    ours, theirs = ends
    speaker: Speaker[object] = Speaker(ours, bytes)
    for k in range(400):
        speaker.tell(bytes([k % 256]) * 10_000)
        speaker.tell(k)
    newest = bytes([399 % 256]) * 10_000
    heard = []
    while 399 not in heard or newest not in heard:
        assert theirs.poll(10.0)
        heard.append(theirs.recv())
    assert [each for each in heard if isinstance(each, int)] == list(range(400))
    assert len([each for each in heard if isinstance(each, bytes)]) < 400
    speaker.close()


def test_what_the_server_says_reaches_the_lease(ends):
    ours, theirs = ends
    lease = Lease(length_s=60.0)
    listener = Listener(theirs, lease)
    ours.send(Renewal(1, 0, time.monotonic()))
    until(lambda: lease.overdue() is None)
    ours.send(Hold())
    until(lambda: isinstance(lease.refusal(), Held))
    ours.send(Resume())
    until(lambda: lease.refusal() is None)
    ours.send(Release("abc"))
    until(lambda: listener.released == "abc")
    ours.send(End(sentence("enough.")))
    until(lambda: isinstance(lease.refusal(), Commanded))


def test_a_server_that_is_gone_ends_the_motion(ends):
    ours, theirs = ends
    lease = Lease(length_s=60.0)
    listener = Listener(theirs, lease)
    ours.close()
    assert listener.ended.wait(10)
    assert "the server is gone" in str(lease.refusal())
