"""Waves that are kept are what they would be if they were worked out anew, whatever was asked for before."""

from __future__ import annotations

import pickle

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from core.effects.joint_waves import JointWaves

ROWS, PERIOD, WINDOW = 300, 0.005, 0.08
RNG = np.random.default_rng(4)
DQ = np.cumsum(RNG.normal(size=(ROWS, 2)), axis=0) * 0.02
Q = np.cumsum(DQ, axis=0) * PERIOD
ORDERS = (1.0, 2.0, 101.0, 202.0)
SIZES = (0.0, 1e-3, -2e-3)


def by_definition(joint: int, waves: np.ndarray) -> np.ndarray:
    """Sums of sines behind a window of four moving means, and `d2/dt2` of each by the chain rule."""
    q, dq = Q[:, joint], DQ[:, joint]
    ddq = np.diff(dq, prepend=dq[:1]) / PERIOD
    out = np.zeros((2, ROWS))
    for order, c, s in waves:
        seen = np.sinc(order * dq * WINDOW / (2.0 * np.pi)) ** 4
        wave, slope = c * np.cos(order * q) + s * np.sin(order * q), s * np.cos(order * q) - c * np.sin(order * q)
        out += seen * np.array([wave, order * ddq * slope - (order * dq) ** 2 * wave])
    return out


def check(known: JointWaves, joint: int, waves: np.ndarray) -> None:
    """To a millionth of each wave: what windows leave of a very slow one is all of it."""
    off = known.find(Q, DQ, joint, waves, PERIOD, WINDOW) - by_definition(joint, waves)
    size = sum(np.abs(by_definition(joint, wave[None])) for wave in waves)
    assert (np.abs(off) <= 1e-6 * size + 1e-15).all()


asked = st.tuples(
    st.integers(0, 1), st.lists(st.tuples(*(st.sampled_from(each) for each in (ORDERS, SIZES, SIZES))), min_size=1, max_size=4)
)


@settings(deadline=None)
@given(st.lists(asked, min_size=1, max_size=12))
def test_waves_are_those_of_their_definition_whatever_was_asked_before(
    questions: list[tuple[int, list[tuple[float, float, float]]]],
) -> None:
    known = JointWaves()
    for joint, each in questions:
        check(known, joint, np.array(each))


def test_more_waves_than_are_kept_are_still_right() -> None:
    known = JointWaves()
    for order in [*range(1, 2 * JointWaves.MOST_PAIRS), *range(1, 5)]:
        check(known, 0, np.array([[order, 1e-3, 2e-3]]))


def test_nothing_of_it_goes_to_another_process() -> None:
    known = JointWaves()
    known.find(Q, DQ, 0, np.array([[100.0, 1e-3, 0.0]]), PERIOD, WINDOW)
    assert len(pickle.dumps(known)) < 200
