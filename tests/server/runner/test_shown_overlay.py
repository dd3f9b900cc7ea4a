"""What a plot shows of an overlay is of the overlay, and its worst moment is among it."""

from __future__ import annotations

import numpy as np
import pytest

from core.report.diagnosis_page import Overlay
from server.runner.shown_overlay import thin_overlay


def overlay(count: int) -> Overlay:
    rng = np.random.default_rng(count)
    measured, before, after = rng.normal(size=(3, count, 6))
    phase = np.where(np.arange(count) < count // 2, "transfer", "rotate:x")
    return Overlay(np.linspace(0.0, 40.0, count), phase, measured, before, after, np.linspace(0.1, 0.6, 6))


@pytest.mark.parametrize(("count", "points"), [(1, 100), (99, 100), (100, 100), (101, 100), (2503, 100)])
def test_every_moment_that_is_shown_is_one_of_the_overlay_and_the_worst_of_all_is_shown(count: int, points: int) -> None:
    whole = overlay(count)
    shown = thin_overlay(whole, points)
    assert min(count, points) / 2 <= len(shown.t_s) <= points
    assert shown.t_s == sorted(set(shown.t_s))
    rows = [int(np.argmin(np.abs(whole.t - t))) for t in shown.t_s]
    assert shown.phase == whole.phase[rows].tolist()
    for c, channel in enumerate(shown.channels):
        np.testing.assert_allclose(channel.measured, whole.measured[rows, c], atol=1e-5)
        np.testing.assert_allclose(channel.before, whole.before[rows, c], atol=1e-5)
        np.testing.assert_allclose(channel.after, whole.after[rows, c], atol=1e-5)
        assert channel.std == whole.noise_std[c]
    gap = (((whole.measured - whole.before) / whole.noise_std) ** 2).sum(axis=1)
    assert int(np.argmax(gap)) in rows
    assert [channel.unit for channel in shown.channels] == ["N"] * 3 + ["N m"] * 3
