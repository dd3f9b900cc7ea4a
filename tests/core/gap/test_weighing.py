"""`core.gap.weighing`: from traces to probabilities, with figures that were learnt."""

from __future__ import annotations

import numpy as np
import pytest

from bench.calibration.trace import BLOCKS, Trace
from core.gap.answering import not_enough, with_likely
from core.gap.weighing import Elsewhere, count, find_doubts, find_left_share, is_in_doubt, read_figures, score, weigh
from core.words.message import Message

ROWS = 6000


def trace(name: str, left: float, free: int = 3, at_bound: int = 0, size: float = 1.0) -> Trace:
    """A fit that leaves so much chi-square per row beyond what noise leaves, the same everywhere."""
    each = ROWS * (1.0 + left)
    return Trace(
        name=name,
        effects=0 if name == "none" else len(name.split("+")),
        free=free,
        at_bound=at_bound,
        size=size,
        rows=ROWS,
        by_block=tuple(each / BLOCKS * (1.0 + 0.1 * np.sin(np.arange(BLOCKS)))),
        by_channel=(each / 6,) * 6,
        by_band=(1.0 + left,) * 3,
        lag=(min(0.9, left),) * 6,
        log_evidence=-0.5 * each,
    )


def test_probabilities_sum_to_one_however_many_fits_there_are() -> None:
    for fits in (0, 1, 20):
        p = weigh(trace("none", 50.0), [trace(f"effect_{k}", 3.0 * k) for k in range(fits)])
        assert p.shape == (2 + fits,)
        assert p.sum() == pytest.approx(1.0)
        assert (p >= 0.0).all()
        assert (p[1:] > 0.0).all() or fits == 0  # no effect is out of the question where the gap is large


def test_what_closes_the_gap_is_more_probable_the_less_it_leaves() -> None:
    shares = [weigh(trace("none", 50.0), [trace("a", left), trace("b", 40.0)])[2] for left in (0.0, 0.5, 5.0, 25.0)]
    assert shares == sorted(shares, reverse=True)
    assert shares[0] > 0.8


def test_of_two_that_leave_next_to_nothing_of_a_large_gap_the_smaller_one_is_more_probable() -> None:
    """A ten-thousandth of the excess is beyond chance, but no more than any arm's imperfections make; a hundredth is more."""
    for left, first in ((0.08, 2), (10.0, 3)):
        assert np.argmax(weigh(trace("none", 1000.0), [trace("few", left), trace("many", 0.0, 31)])) == first


def test_where_no_gap_is_nothing_is_most_probable_and_with_a_large_one_it_is_out_of_the_question() -> None:
    assert np.argmax(weigh(trace("none", 0.0), [trace("a", 0.0), trace("b", 0.0, 12)])) == 0
    assert weigh(trace("none", 50.0), [trace("a", 10.0)])[0] < 0.01


def test_where_much_is_left_over_it_is_unknown() -> None:
    p = weigh(trace("none", 50.0), [trace("a", 35.0), trace("b", 38.0), trace("c+d", 30.0, 12)])
    assert np.argmax(p) == 1


def test_figures_are_shipped_with_where_they_come_from() -> None:
    known = read_figures()
    assert known.provenance.learnt_from >= 200
    assert known.provenance.versions
    assert 0.0 < known.outside < 0.5
    assert all(by > 0.0 for _, by in known.matters.values())


def test_the_more_is_left_the_stronger_are_both_doubts() -> None:
    unknown, lapse = find_doubts(np.array([0.0, 1e-3, 1e-2, 0.1, 1.0]), read_figures().figures)
    assert np.all(np.diff(unknown) > 0.0)
    assert np.all(np.diff(lapse) > 0.0)
    assert unknown[0] < 0.1
    assert unknown[-1] > 0.5


def test_recordings_behind_each_other_are_weighed_as_each_alone() -> None:
    one = count(trace("none", 50.0), [trace("a", 1.0), trace("b", 30.0, 12)])
    two = count(trace("none", 5.0), [trace("a", 0.0), trace("b+c", 0.0, 12)])
    figures = read_figures().figures
    stacked = type(one)(*(np.stack(pair) for pair in zip(one, two, strict=True)))
    assert score(stacked, figures) == pytest.approx(np.stack([score(one, figures), score(two, figures)]))


def test_what_may_be_chance_is_nothing_left() -> None:
    assert find_left_share(trace("none", 10.0), trace("a", 0.02)) == 0.0
    assert find_left_share(trace("none", 10.0), trace("a", 5.0)) == pytest.approx(0.5, abs=0.01)


def test_the_likely_answers_are_those_that_are_not_outside_the_set_of_nine_in_ten() -> None:
    outside = read_figures().outside
    told = not_enough(Message.of("gap-no-wrench"), 0.0)
    near = with_likely(told.model_copy(update={"unknown_probability": 0.9, "none_probability": 1.5 * outside}))
    assert near.likely == ["unknown", "none"]
    assert with_likely(told.model_copy(update={"unknown_probability": 0.9, "none_probability": 0.5 * outside})).likely == ["unknown"]


def test_strangers_teach_the_doubts_and_trials_when_to_look_for_what_no_effect_explains(monkeypatch: pytest.MonkeyPatch) -> None:
    sure = {"unknown": -9.0, "unknown_left": 0.0, "lapse": -9.0, "lapse_left": 0.0}
    elsewhere = Elsewhere(date="", recordings=1, learnt_from=1, doubts=sure, outside=0.1, scores={})
    alone = read_figures().model_copy(update={"elsewhere": None})
    fits = [trace("a", 10.0), trace("b", 45.0)]
    for known, is_doubted in ((alone, True), (alone.model_copy(update={"elsewhere": elsewhere}), False)):
        monkeypatch.setattr("core.gap.weighing.read_figures", lambda known=known: known)
        assert bool(np.argmax(weigh(trace("none", 50.0), fits)) == 1) == is_doubted
        assert is_in_doubt(trace("none", 50.0), *fits)
        assert not is_in_doubt(trace("none", 50.0), trace("a", 0.0))
    assert alone.left_out == alone.outside
    assert alone.model_copy(update={"elsewhere": elsewhere}).left_out == 0.1


def test_each_fit_is_doubted_by_what_it_leaves_itself() -> None:
    """One effect that leaves a third is not believed because three at once, which are improbable, leave little."""
    nominal, few, many = trace("none", 50.0), trace("a", 15.0), trace("b+c+d", 0.5, 40)
    none, unknown, a, _ = weigh(nominal, [few, many])
    assert a / (1.0 - none) < 1.0 - float(find_doubts(np.array(0.3), read_figures().everywhere)[0])
    assert unknown > float(find_doubts(np.array(0.01), read_figures().everywhere)[0])
