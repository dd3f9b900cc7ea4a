"""Leaving motions out, against fits that never saw them."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from core.gap.effect_fit import predict_held_out


@pytest.mark.parametrize("precision_of_the_last", [1.0, 1e-14])
def test_what_a_motion_adds_is_what_a_fit_of_the_others_says_of_it(precision_of_the_last: float) -> None:
    """Also where one motion alone shows the last parameter and nothing else tells anything about it."""
    rng = np.random.default_rng(4)
    group = np.repeat([0, 1, 2], 5)
    columns = rng.normal(size=(6 * len(group), 4))
    columns[np.tile(group, 6) != 1, 3] = 0.0
    precision = np.array([0.5, 2.0, 0.1, precision_of_the_last])
    y = columns @ [1.0, -2.0, 0.5, 3.0] + rng.normal(size=len(columns))
    fitted = np.linalg.solve(columns.T @ columns + np.diag(precision), columns.T @ y)
    windows = SimpleNamespace(group=group, target=np.zeros((6, len(group))))
    found = predict_held_out(windows, columns, y - columns @ fitted, precision, fitted)  # type: ignore[arg-type]  # all that is read of it

    def least_cost(rows: np.ndarray) -> float:
        x = np.linalg.lstsq(np.vstack((columns[rows], np.diag(np.sqrt(precision)))), np.append(y[rows], np.zeros(4)), rcond=None)[0]
        return float(np.sum((y[rows] - columns[rows] @ x) ** 2) + precision @ x**2)

    everything = np.ones(len(y), dtype=bool)
    for g in range(3):
        out = np.tile(group, 6) == g
        assert found[:, group == g].sum() == pytest.approx(least_cost(everything) - least_cost(~out), rel=1e-6)
