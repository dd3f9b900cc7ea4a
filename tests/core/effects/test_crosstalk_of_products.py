"""Products of two channels in a third, against sums that are written out."""

from __future__ import annotations

import numpy as np
import pytest

from core.array import Array
from core.effects.crosstalk_of_products import CrosstalkOfProducts
from core.effects.sensor_crosstalk import SensorCrosstalk
from core.payload.channels import CHANNELS
from tests.core.effects.mechanical_truth import SIGMA, scene, without_nuisance

RUN = scene()
EFFECT = CrosstalkOfProducts()
NAMES = [p.name for p in EFFECT.parameters(RUN)]
LINEAR = np.zeros(31)
MASS, MOMENT = float(RUN.phi[0]), np.abs(RUN.phi[1:4])
LOAD = 9.80665 * np.array([MASS, MASS, MASS, *(np.hypot(*np.delete(MOMENT, k)) for k in range(3))])


def with_products(**shares: float) -> Array:
    """Parameters by the names of the products, `fx_from_fy_times_tz`."""
    theta = np.zeros(len(NAMES))
    for name, share in shares.items():
        theta[NAMES.index(f"{name}_share")] = share
    return theta


def left_of(planted: Array, noise: float) -> Array:
    """(N, 6), what payload and offsets leave of a change, with noise."""
    rows = (planted / SIGMA + noise * np.random.default_rng(5).normal(size=planted.shape)).ravel()
    return np.asarray(without_nuisance(rows).reshape(-1, 6))


@pytest.mark.parametrize("name", ["fx_from_fy_times_tz", "tz_from_fx_times_fx", "fz_from_fz_times_ty", "ty_from_fy_times_tx"])
def test_a_product_shows_in_its_channel_as_a_share_of_the_loads_at_rest(name: str) -> None:
    shown, first, second = (CHANNELS.index(part) for part in name.replace("_from_", " ").replace("_times_", " ").split())
    expected = RUN.nominal.copy()
    expected[:, shown] += 0.04 * LOAD[shown] * (RUN.nominal[:, first] / LOAD[first]) * (RUN.nominal[:, second] / LOAD[second])
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, with_products(**{name: 0.04})), expected, rtol=1e-9, atol=1e-12)


def test_it_has_all_products_but_a_channels_own_square_beside_linear_cross_talk() -> None:
    assert len(NAMES) == len(set(NAMES)) == 31 + 6 * 20
    assert "fx_from_fx_times_fx_share" not in NAMES
    linear = np.linspace(-0.01, 0.01, 31)
    whole = EFFECT.wrench(RUN, RUN.nominal, np.concatenate((linear, np.zeros(120))))
    np.testing.assert_allclose(whole, SensorCrosstalk().wrench(RUN, RUN.nominal, linear))


def test_it_is_fitted_where_products_explain_nearly_all_that_is_not_linear() -> None:
    w = RUN.nominal
    products = EFFECT.wrench(RUN, w, with_products(fx_from_fy_times_tz=0.1, ty_from_fx_times_fz=-0.05)) - w
    (start,) = EFFECT.starts(RUN, left_of(products, 1.0))
    assert not start.any()
    shaken = 2.0 * np.outer(np.sin(2.0 * np.pi * 3.0 * RUN.t), [1.0, 0.5, 0.2, 0.05, 0.02, 0.1])
    for other in (0.0 * w, shaken):
        assert EFFECT.starts(RUN, left_of(other, 1.0)) == []


def test_the_advice_has_the_largest_product() -> None:
    said = EFFECT.advice(RUN, with_products(fx_from_fy_times_tz=0.1, ty_from_fx_times_fz=-0.05)).text
    assert "fy times tz adds 10.0 % of its load to fx" in said
