"""From a recording to what it is compared on: grid and windows."""

from dataclasses import replace

import numpy as np
import pytest

from core.effects.time_delay import TimeDelay
from core.gap import basis
from core.gap.basis import basis_of
from core.gap.closure import gap_of
from core.gap.effect_fit import fit_effects, fit_nominal
from core.gap.windows import Windows
from tests.foreign_recordings import make_long


@pytest.fixture(scope="module")
def long_recording():
    """Longer than its grid may be fine, when that may have a thousand instants."""
    pieces = list(make_long(15.0, 500.0, 0).pieces)
    t, wrench, q = (np.concatenate([np.asarray(getattr(piece, name)) for piece in pieces]) for name in ("t", "wrench", "q"))
    return replace(pieces[0], t=t, wrench=wrench, q=q)


@pytest.fixture(autouse=True)
def few_instants(monkeypatch):
    monkeypatch.setattr(basis, "MOST_INSTANTS", 1000)


def test_what_lasts_long_has_a_coarser_grid_and_wider_windows(long_recording):
    found = basis_of(long_recording)
    assert 900 < len(found.scene) <= 1000
    assert found.rows.step == pytest.approx(0.075, rel=0.01)


def test_there_noise_alone_still_has_unit_variance(long_recording):
    windows = Windows(basis_of(long_recording))
    assert gap_of(windows, fit_nominal(windows)) == pytest.approx(1.0, abs=0.05)


def test_there_a_delay_is_still_found_with_its_size(long_recording):
    late = 20
    wrench = np.concatenate((long_recording.wrench[:1].repeat(late, axis=0), long_recording.wrench[:-late]))
    windows = Windows(basis_of(replace(long_recording, wrench=wrench)))
    nominal = fit_nominal(windows)
    fit = fit_effects(windows, (TimeDelay(),), nominal, [np.array([0.02])])
    assert gap_of(windows, nominal) > 2.0
    assert fit.theta[0] == pytest.approx(0.04, abs=0.001)
    assert gap_of(windows, fit) == pytest.approx(1.0, abs=0.05)
