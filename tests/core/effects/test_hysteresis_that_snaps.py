"""What sticks and snaps on, against a block on a spring that is written down here."""

from __future__ import annotations

import numpy as np
import pytest

from core.effects.channels import full_scale
from core.effects.hysteresis_that_snaps import HysteresisThatSnaps
from core.payload.inertia import regressor
from tests.core.effects.synthetic_scene import NOISE, scene

Array = np.ndarray
RUN = scene()
EFFECT = HysteresisThatSnaps()
HELD, MOST, REST = np.array([0.4, 0.3, 0.0, 0.0, 0.5, 0.0]), 0.06 * np.ptp(RUN.nominal, axis=0), 0.3


def block_on_a_spring() -> Array:
    """(N, 6): each channel's block stays until the spring is pulled by `MOST`, and jumps to where it is pulled by `REST` of that."""
    out = RUN.nominal.copy()
    for c in range(6):
        block = out[0, c]
        for k, w in enumerate(RUN.nominal[:, c]):
            if w - block > MOST[c]:
                block = w - REST * MOST[c]
            elif block - w > MOST[c]:
                block = w + REST * MOST[c]
            out[k, c] = w - HELD[c] * (w - block)
    return out


def planted() -> Array:
    """(13,)."""
    return np.concatenate((HELD, np.log(MOST / full_scale(RUN, RUN.nominal)), [REST]))


def test_it_reads_what_a_block_on_a_spring_lets_through() -> None:
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, planted()), block_on_a_spring(), atol=1e-9)


def test_the_search_before_the_fit_finds_the_channels_and_about_how_much_each_holds_back() -> None:
    change = ((block_on_a_spring() - RUN.nominal) / NOISE).ravel()
    columns = np.concatenate((regressor(RUN.motion), np.tile(np.eye(6), (len(RUN), 1, 1))), axis=2) / NOISE[:, None]
    columns = columns.reshape(len(change), -1)
    residual = change - columns @ np.linalg.lstsq(columns, change, rcond=None)[0]
    start = min(EFFECT.starts(RUN, residual.reshape(-1, 6)), key=lambda theta: abs(theta[12] - REST))
    assert set(np.flatnonzero(HELD)) <= set(np.flatnonzero(start[:6]))
    found = np.exp(start[6:12]) * full_scale(RUN, RUN.nominal)
    assert np.abs(np.log(found / MOST)[HELD > 0.0]).max() < np.log(2.0)


def test_noise_has_no_sawtooth() -> None:
    assert EFFECT.starts(RUN, np.random.default_rng(4).normal(size=RUN.nominal.shape)) == []


def test_the_advice_says_what_the_worst_channel_holds_back() -> None:
    worst = 100.0 * (HELD * MOST / full_scale(RUN, RUN.nominal)).max()
    assert f"{worst:.2f}"[:3] in EFFECT.advice(RUN, planted()).text
    assert EFFECT.explain_tie_to_run(RUN) is not None


@pytest.mark.parametrize("rest", [0.0, 0.9])
def test_what_holds_nothing_back_changes_nothing(rest: float) -> None:
    theta = np.concatenate((np.zeros(6), np.full(6, -3.0), [rest]))
    np.testing.assert_array_equal(EFFECT.wrench(RUN, RUN.nominal, theta), RUN.nominal)


def test_what_may_be_held_back_makes_it_snap_in_this_run() -> None:
    upper = np.exp([p.upper for p in EFFECT.parameters(RUN)[6:12]]) * full_scale(RUN, RUN.nominal)
    wide = np.ptp(RUN.nominal, axis=0) > 0.06 * full_scale(RUN, RUN.nominal)
    np.testing.assert_allclose(upper[wide], 0.5 * np.ptp(RUN.nominal, axis=0)[wide])
    assert wide.any()
