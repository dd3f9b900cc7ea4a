"""Single effects whose first fit ends elsewhere."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.array import Array
from core.effects.saturation_of_bridge import SaturationOfBridge
from core.effects.scene import Scene
from core.effects.sensor_saturation import SensorSaturation
from core.gap.basis import basis_of
from core.gap.fit_all import one_by_one
from core.gap.singles import fit_singly
from core.gap.weighing import find_left_share
from core.gap.windows import Windows
from tests.synthetic import payload, record, run_of


def clip_beams(W: Array, radius_m: float, beams: tuple[int, ...], share: float) -> Array:
    """A sensor on three beams, 120 deg apart, each with a gauge for its load up and down and one across; these gauges are at their ends,
    the same to both sides, in this share of the rows."""
    rows = []
    for angle in np.deg2rad([0.0, 120.0, 240.0]):
        sine, cosine = 2.0 / 3.0 * np.sin(angle), 2.0 / 3.0 * np.cos(angle)
        rows += [[0, 0, 1 / 3, sine / radius_m, -cosine / radius_m, 0], [-sine, cosine, 0, 0, 0, 1 / (3 * radius_m)]]
    to_gauges = np.array(rows)
    gauges = W @ to_gauges.T
    for beam in beams:
        end = np.quantile(np.abs(gauges[:, beam]), 1.0 - share)
        gauges[:, beam] = np.clip(gauges[:, beam], -end, end)
    return np.asarray(gauges @ np.linalg.inv(to_gauges).T)


def record_clipped(beams: tuple[int, ...], share: float) -> Windows:
    sound = record(run_of("lwr4_bench", 0, repetitions=1), payload("steel_block"), np.random.default_rng(0))
    assert sound.wrench is not None
    return Windows(basis_of(replace(sound, wrench=clip_beams(sound.wrench, 0.03, beams, share))))


def test_what_shows_no_start_any_more_is_not_fitted_again(monkeypatch: pytest.MonkeyPatch) -> None:
    windows, asked, find = record_clipped((0, 4), 0.6), [], SaturationOfBridge.starts

    def start(effect: SaturationOfBridge, scene: Scene, residual: Array) -> list[Array]:  # by itself, and from most rows; then not again
        asked.append(residual)
        return find(effect, scene, residual) if len(asked) < 3 else []

    monkeypatch.setattr(SaturationOfBridge, "starts", start)
    monkeypatch.setattr(SaturationOfBridge, "starts_beside", lambda *_: [])
    found = fit_singly(windows, [SensorSaturation()], one_by_one)
    assert len(asked) == 3
    assert isinstance(found.fits[0].effects[0], SaturationOfBridge)


def test_two_bridges_that_are_mostly_at_their_ends_are_found_from_what_the_first_fit_shows() -> None:
    windows = record_clipped((0, 4), 0.6)
    found = fit_singly(windows, [SensorSaturation()], one_by_one)
    best = min(found.fits, key=lambda fit: fit.chi_square)
    assert isinstance(best.effects[0], SaturationOfBridge)
    assert find_left_share(found.nominal, best) < 1e-3
    true = payload("steel_block").phi
    np.testing.assert_allclose(best.phi[:4], true[:4], atol=0.01 * true[0])
