"""What is lost, comes twice or out of order is counted as it was sent."""

from __future__ import annotations

import numpy as np
import pytest

from core.sensors.sequence import Arrival, Sequence, Tally

WRAP = 1 << 32


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("first", [1, WRAP - 500, WRAP // 2 - 3])
def test_losses_repeats_and_overtaken_packets_are_counted_across_the_wrap(seed: int, first: int):
    rng = np.random.default_rng(seed)
    lost = set(rng.choice(np.arange(1, 999), 50, replace=False).tolist())
    sent = [k for k in range(1000) if k not in lost]
    twice = set(rng.choice(sent[1:], 30, replace=False).tolist())
    order = [(k + rng.uniform(0.0, 4.0) if 0 < k < 999 else k, k) for k in sent] + [(k + 5.0, k) for k in twice]
    tally = Tally()
    sequence = Sequence(WRAP, tally)
    placed = [sequence.place((first + k) % WRAP) for _, k in sorted(order)]
    kept = [whole for arrival, whole in placed if arrival is not Arrival.REPEATED]
    assert sorted(kept) == [first + k for k in sent]
    newest = np.maximum.accumulate([whole for _, whole in placed])
    overtaken = sum(arrival is Arrival.OVERTAKEN for arrival, _ in placed)
    assert overtaken == sum(whole < before for whole, before in zip(kept[1:], np.maximum.accumulate(kept)[:-1], strict=True)) > 0
    assert (tally.received, tally.lost, tally.repeated, tally.overtaken) == (len(sent), 50, 30, overtaken)
    assert newest[-1] == first + 999
    assert tally.lost_share == pytest.approx(0.05)


def test_a_sensor_that_begins_anew_is_told_from_a_wrap():
    sequence = Sequence(WRAP, Tally())
    assert sequence.place(1_000_000)[0] is Arrival.NEXT
    assert sequence.place(1) == (Arrival.ANEW, 1)
    wrapped = Sequence(WRAP, Tally())
    wrapped.place(WRAP - 1)
    assert wrapped.place(0) == (Arrival.NEXT, WRAP)
