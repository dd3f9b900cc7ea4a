"""Measured and simulated wrench side by side, for plots."""

from __future__ import annotations

from server.http.schemas import Answer


class ChannelOverlay(Answer):
    """One channel in `unit`, offsets taken off.

    Args:
        measured: one value for each time.
        before, after: simulated without and with the effect that explains the gap best.
        std: of the noise of one value.
    """

    channel: str
    unit: str
    measured: list[float]
    before: list[float]
    after: list[float]
    std: float


class OverlayAnswer(Answer):
    """What a diagnosis compared, thinned out: of each stretch of time the moment in which measured and simulated lie furthest apart.

    Args:
        t_s: times; `phase` is the motion at each.
    """

    t_s: list[float]
    phase: list[str]
    channels: list[ChannelOverlay]
