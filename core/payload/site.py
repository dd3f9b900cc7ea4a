"""Where on the earth a cell stands, and how strong gravity is there."""

from __future__ import annotations

from typing import Annotated

import numpy as np
from pydantic import Field

from core.array import Array
from core.payload.shapes import Model

GRAVITY_STD_M_S2 = 5e-4
"""Of the formula against what is measured: free-air anomalies scatter by some 40 mGal, the building and its height add the rest."""
UNKNOWN_GRAVITY_STD_M_S2 = 0.015
"""Where nobody has said where the cell stands: from equator to pole at sea level gravity spans 9.780 to 9.832 m/s2, evenly spread."""

# World Geodetic System 1984 (NGA.STND.0036): normal gravity on the ellipsoid, its shape, and centrifugal over attracting acceleration
_EQUATOR_M_S2, _SOMIGLIANA, _ECCENTRICITY_2 = 9.7803253359, 0.00193185265241, 0.00669437999013
_SEMI_MAJOR_M, _FLATTENING, _CENTRIFUGAL = 6378137.0, 1.0 / 298.257223563, 0.00344978650684


class Site(Model):
    """Place of a cell on the earth: it gives the strength of gravity, whose direction is stated apart from it."""

    latitude_deg: Annotated[float, Field(strict=True, ge=-90.0, le=90.0)] = Field(
        description="Geographic latitude, deg, north positive.", examples=[48.1]
    )
    elevation_m: Annotated[float, Field(strict=True, ge=-500.0, le=6000.0)] = Field(
        default=0.0, description="Height above sea level, m.", examples=[520.0]
    )

    @property
    def gravity_m_s2(self) -> float:
        """Normal gravity: Somigliana's closed formula on the ellipsoid, then its second-order change with height."""
        s2 = float(np.sin(np.radians(self.latitude_deg))) ** 2
        ground = _EQUATOR_M_S2 * (1.0 + _SOMIGLIANA * s2) / np.sqrt(1.0 - _ECCENTRICITY_2 * s2)
        h = self.elevation_m / _SEMI_MAJOR_M
        return float(ground * (1.0 - 2.0 * (1.0 + _FLATTENING + _CENTRIFUGAL - 2.0 * _FLATTENING * s2) * h + 3.0 * h**2))


def gravity_at(direction: Array, site: Site | None) -> Array:
    """Gravity (3,), m/s2: as stated without a site, in that direction with the site's strength otherwise."""
    return direction if site is None else direction * (site.gravity_m_s2 / np.linalg.norm(direction))
