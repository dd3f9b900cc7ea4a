"""Where jumps are found: against least squares at every row, and jumps that were put in beside what payload and offsets take up."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.effects.jump_search import EDGE, FEWEST, ROWS, find_jumps
from core.effects.window_search import columns_of_payload_and_offsets
from tests.core.effects.synthetic_scene import scene

RUN = replace(scene(), noise=np.array([0.05, 0.05, 0.08, 0.003, 0.003, 0.002]))
JUMP = np.array([12.0, -20.0, 5.0, 8.0, 2.0, -6.0])
EVERY = len(RUN) // ROWS


def residual_of(jumps: dict[float, float]) -> np.ndarray:
    """Noise, a payload that is off, and shares of the jump, by times in s."""
    rng = np.random.default_rng(5)
    off = columns_of_payload_and_offsets(RUN, slice(None)) @ rng.normal(0.0, 0.5, 16)
    shares = sum(share * (RUN.elapsed > at) for at, share in jumps.items())
    return np.asarray(rng.normal(size=(len(RUN), 6)) + off + np.outer(shares, JUMP))


def test_one_jump_is_where_least_squares_at_every_row_leaves_least() -> None:
    residual = residual_of({0.4 * RUN.elapsed[-1]: 0.05})
    rows = slice(0, None, max(1, EVERY))
    known, wanted = columns_of_payload_and_offsets(RUN, rows), residual[rows]
    n = len(wanted)
    left = {}
    for row in range(EDGE, n - EDGE):
        on = np.einsum("n,cd->ncd", np.arange(n) >= row, np.eye(6))
        X = np.concatenate((known, on), axis=2).reshape(6 * n, -1)
        left[row] = float(np.square(wanted.ravel() - X @ np.linalg.lstsq(X, wanted.ravel(), rcond=None)[0]).sum())
    found = find_jumps(RUN, residual, np.eye(6), 1)
    assert found is not None
    np.testing.assert_allclose(found[0], RUN.elapsed[rows][min(left, key=lambda row: left[row])] - 0.5 * RUN.period)


def test_jumps_that_follow_each_other_within_a_second_are_found_with_their_shares() -> None:
    jumps = {5.0: 0.5, 5.6: 0.3, 6.7: -0.4}
    found = find_jumps(RUN, residual_of(jumps), JUMP[:, None], 3)
    assert found is not None
    np.testing.assert_allclose(found[0], list(jumps), atol=RUN.elapsed[-1] / ROWS + 2.0 * RUN.period)
    np.testing.assert_allclose(found[1][:, 0], list(jumps.values()), atol=0.05)


def test_among_few_rows_none_is_sought() -> None:
    few = RUN[: FEWEST - 1]
    assert find_jumps(few, np.zeros((len(few), 6)), np.eye(6), 2) is None
