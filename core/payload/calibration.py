"""What a wrist sensor's calibration promises: how far its gains and its cross-talk may be off."""

from __future__ import annotations

import numpy as np
from pydantic import Field

from core.array import Array
from core.payload.shapes import Model, NotNegative

SixNotNegative = tuple[NotNegative, NotNegative, NotNegative, NotNegative, NotNegative, NotNegative]

ASSUMED_GAIN_STD = 0.01
"""Of the load, where no certificate is at hand: what makers of wrist sensors promise."""
ASSUMED_CROSSTALK_STD = 0.005
"""Of the range, at full load of another channel, likewise."""
TYPICAL_RANGE = np.repeat([100.0, 5.0], 3)
"""N and N m: how force and torque compare in a sensor whose range nobody has stated; only the ratio counts."""


class SensorCalibration(Model):
    """Standard uncertainties (1 sigma) of a certificate; six values each, force, then torque."""

    gain_std: SixNotNegative | None = Field(
        default=None,
        description="Relative standard uncertainty of each channel's gain; 0.01, and said to be assumed, where null.",
        examples=[[0.005, 0.005, 0.004, 0.006, 0.006, 0.005]],
    )
    crosstalk_std: SixNotNegative | None = Field(
        default=None,
        description="What full load of another channel makes of each channel, as a share of its range, standard uncertainty; "
        "0.005, and said to be assumed, where null.",
        examples=[[0.003, 0.003, 0.003, 0.004, 0.004, 0.004]],
    )
    source: str | None = Field(
        default=None, max_length=200, description="Where the figures are from.", examples=["certificate 4711 of 2026-03-02"]
    )


NOT_STATED = SensorCalibration()


def reading_std(calibration: SensorCalibration, measuring_range: Array | None) -> Array:
    """(6, 6), standard uncertainty of what channel i reads per load of channel j: gains on the diagonal, cross-talk beside it.

    Args:
        measuring_range: (6,), N and N m; a typical ratio of torque to force where absent.
    """
    full = TYPICAL_RANGE if measuring_range is None else measuring_range
    crosstalk = np.full(6, ASSUMED_CROSSTALK_STD) if calibration.crosstalk_std is None else np.array(calibration.crosstalk_std)
    std = crosstalk[:, None] * full[:, None] / full
    np.fill_diagonal(std, ASSUMED_GAIN_STD if calibration.gain_std is None else np.array(calibration.gain_std))
    return np.asarray(std)
