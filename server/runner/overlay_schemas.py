"""Measured and simulated wrench side by side, for plots."""

from __future__ import annotations

from pydantic import Field

from server.http.schemas import Answer


class ChannelOverlay(Answer):
    """One channel in `unit`, offsets taken off."""

    channel: str = Field(description="Channel of the wrench.", examples=["ty"])
    unit: str = Field(description="Unit of all that follows.", examples=["N m"])
    measured: list[float] = Field(description="Measured values, one for each time, offsets taken off.", examples=[[-1.31, -1.29]])
    before: list[float] = Field(description="Simulated with the twin as it was.", examples=[[-1.24, -1.22]])
    after: list[float] = Field(description="Simulated with the effect that explains the gap best.", examples=[[-1.31, -1.29]])
    std: float = Field(description="Standard deviation of the noise of one value.", examples=[0.003])


class OverlayPublic(Answer):
    """What a diagnosis compared, thinned out: of each stretch of time the moment in which measured and simulated lie furthest apart."""

    t_s: list[float] = Field(
        description="Times, s: of each stretch the moment in which measured and simulated lie furthest apart.", examples=[[12.0, 12.5]]
    )
    phase: list[str] = Field(description="The motion at each time.", examples=[["rotate:x", "rotate:x"]])
    channels: list[ChannelOverlay] = Field(description="The six channels of the wrench.")
