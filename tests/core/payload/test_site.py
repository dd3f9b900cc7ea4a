"""Gravity of a place against what absolute gravimeters measured there, and against the formula of another system."""

from __future__ import annotations

import numpy as np
import pytest
from pydantic import ValidationError

from core.payload.site import GRAVITY_STD_M_S2, Site, gravity_at


@pytest.mark.parametrize(
    ("latitude_deg", "elevation_m", "measured_m_s2"),
    [
        pytest.param(48.8294, 66.0, 9.80926, id="BIPM, Sèvres"),
        pytest.param(52.3806, 87.0, 9.81260, id="Geodetic Institute, Potsdam"),
        pytest.param(51.4207, 10.0, 9.81182, id="NPL, Teddington"),
        pytest.param(40.1308, 1682.0, 9.79623, id="Table Mountain, Boulder"),
    ],
)
def test_the_formula_is_as_near_to_measured_gravity_as_it_says(latitude_deg: float, elevation_m: float, measured_m_s2: float) -> None:
    site = Site(latitude_deg=latitude_deg, elevation_m=elevation_m)
    assert abs(site.gravity_m_s2 - measured_m_s2) < 2.0 * GRAVITY_STD_M_S2


@pytest.mark.parametrize("latitude_deg", [0.0, 30.0, 45.0, 60.0, -90.0])
def test_at_sea_level_it_is_the_international_formula_of_1980(latitude_deg: float) -> None:
    s2, s22 = np.sin(np.radians(latitude_deg)) ** 2, np.sin(np.radians(2 * latitude_deg)) ** 2
    series = 9.780327 * (1.0 + 0.0053024 * s2 - 0.0000058 * s22)
    assert Site(latitude_deg=latitude_deg).gravity_m_s2 == pytest.approx(series, abs=3e-6)


def test_a_hundred_metres_up_it_is_weaker_by_the_free_air_gradient() -> None:
    low, high = (Site(latitude_deg=45.0, elevation_m=h).gravity_m_s2 for h in (0.0, 100.0))
    assert low - high == pytest.approx(3.086e-4, rel=2e-3)


def test_a_site_gives_the_strength_and_leaves_the_direction() -> None:
    tilted = np.array([0.0, 0.6, -0.8])
    site = Site(latitude_deg=10.0)
    np.testing.assert_allclose(gravity_at(tilted, site), site.gravity_m_s2 * tilted)
    np.testing.assert_array_equal(gravity_at(np.array([0.0, 0.0, -9.7]), None), [0.0, 0.0, -9.7])


def test_a_latitude_beyond_the_pole_is_refused() -> None:
    with pytest.raises(ValidationError):
        Site(latitude_deg=91.0)
