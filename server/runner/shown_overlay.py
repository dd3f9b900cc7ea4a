"""Measured and simulated wrench of a diagnosis, thinned out for a plot."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.payload.channels import CHANNELS, UNITS
from core.report.diagnosis_page import Overlay
from server.runner.overlay_schemas import ChannelOverlay, OverlayPublic

POINTS = 1000
"""At most; a screen has hardly more columns."""


def thin_overlay(overlay: Overlay, points: int = POINTS) -> OverlayPublic:
    """At most `points` moments of an overlay, the worst of each stretch."""
    rows = _worst_of_each(overlay, points)
    return OverlayPublic(
        t_s=np.round(overlay.t[rows], 4).tolist(),
        phase=overlay.phase[rows].tolist(),
        channels=[
            ChannelOverlay(
                channel=name,
                unit=unit,
                measured=_round(overlay.measured[rows, c]),
                before=_round(overlay.before[rows, c]),
                after=_round(overlay.after[rows, c]),
                std=float(overlay.noise_std[c]),
            )
            for c, (name, unit) in enumerate(zip(CHANNELS, UNITS, strict=True))
        ],
    )


def _worst_of_each(overlay: Overlay, points: int) -> NDArray[np.intp]:
    """Rows in which the gap, over all channels and against its noise, is largest."""
    count = len(overlay.t)
    every = -(-count // points)
    gap = np.sum(((overlay.measured - overlay.before) / overlay.noise_std) ** 2, axis=1)
    padded = np.concatenate((gap, np.full(-count % every, -1.0))).reshape(-1, every)
    return np.asarray(np.arange(len(padded)) * every + np.argmax(padded, axis=1))


def _round(values: NDArray[np.float64]) -> list[float]:
    found: list[float] = np.round(values, 5).tolist()
    return found
