"""Two identifications of what may be the same payload: what differs, by how much, and whether that is more than chance."""

from __future__ import annotations

import math

import numpy as np
from pydantic import BaseModel, ConfigDict, Field

from core.array import Array
from core.payload.channels import CHANNELS, UNITS
from core.payload.inertia import PHI_NAMES, PHI_UNITS
from core.payload.uncertain_parameters import UncertainParameters, propagate, propagate_pair
from core.words.message import Message

SIGNIFICANT = 0.01
"""Chance of a difference at least as large between two runs with one payload, below which they are said to differ."""


class Difference(BaseModel):
    """The second minus the first, in `unit`."""

    model_config = ConfigDict(frozen=True, allow_inf_nan=False)

    name: str = Field(description="Name of the parameter or the channel.", examples=["m"])
    value: float = Field(description="The second minus the first, in `unit`.", examples=[0.012])
    std: float = Field(description="Standard uncertainty of the difference, in `unit`.", examples=[0.004])
    times_std: float = Field(description="The difference in multiples of its standard uncertainty, with its sign.", examples=[3.0])
    unit: str = Field(description="Unit of `value` and `std`.", examples=["kg"])


class Comparison(BaseModel):
    """Two runs side by side; what one of them does not determine is not compared."""

    model_config = ConfigDict(frozen=True, allow_inf_nan=False)

    parameters: list[Difference] = Field(description="The ten parameters in the paper's order, in the frame in which both were given.")
    com: list[Difference] = Field(description="Centre of mass, m.")
    inertia_com: list[Difference] = Field(description="Inertia about the centre of mass, kg m2.")
    offset: list[Difference] = Field(description="Offsets of the sensor, N and N m: how they drifted from one run to the other.")
    chance: float | None = Field(
        description="Chance, 0 to 1, of a difference at least as large, were the payload the same; null without common parameters.",
        examples=[0.37],
    )
    differ: bool = Field(description="Whether that is too small to believe (below 0.01).")
    verdict: Message = Field(description="The same as a message.")


def compare_payloads(
    first: UncertainParameters,
    second: UncertainParameters,
    offset_first: tuple[Array, Array],
    offset_second: tuple[Array, Array],
    *,
    shared: Array | None = None,
) -> Comparison:
    """Compares two runs whose noise is independent; what is wrong with the cell in both alike does not show.

    Args:
        first, second: in one frame.
        offset_first, offset_second: (6,) the sensor's offsets with their standard uncertainties (6,), N and N m.
        shared: (10, 10), covariance of the second with the first, by what is uncertain in both alike; none where absent.
    """
    cross = np.zeros((10, 10)) if shared is None else shared
    covariance = first.covariance + second.covariance - cross - cross.T
    parameters = differences(PHI_NAMES, second.phi - first.phi, _std(covariance), PHI_UNITS)
    chance = chance_of(second.phi - first.phi, covariance)
    differ = chance is not None and chance < SIGNIFICANT
    com, inertia = (
        propagate(a, first.covariance) + propagate(b, second.covariance) - _both(propagate_pair(b, cross, a))
        for a, b in ((first.com_jacobian, second.com_jacobian), (first.inertia_com_jacobian, second.inertia_com_jacobian))
    )
    offset_std = np.hypot(offset_first[1], offset_second[1])
    return Comparison(
        parameters=parameters,
        com=differences(("cx", "cy", "cz"), second.com_m - first.com_m, _std(com), ("m",) * 3),
        inertia_com=differences(PHI_NAMES[4:], second.inertia_com - first.inertia_com, _std(inertia), PHI_UNITS[4:]),
        offset=differences(CHANNELS, offset_second[0] - offset_first[0], offset_std, UNITS),
        chance=chance,
        differ=differ,
        verdict=_verdict(parameters, chance, differ=differ),
    )


def _both(matrix: Array) -> Array:
    return matrix + matrix.T


def _std(covariance: Array) -> Array:
    """Standard uncertainties; NaN where there is none."""
    variance = np.diag(covariance)
    return np.sqrt(np.where(variance >= 0.0, variance, np.nan))


def differences(names: tuple[str, ...], difference: Array, std: Array, units: tuple[str, ...]) -> list[Difference]:
    """Of each number that both know with an uncertainty."""
    found = zip(names, difference, std, units, strict=True)
    return [Difference(name=n, value=d, std=s, times_std=d / s, unit=u) for n, d, s, u in found if np.isfinite(d) and s > 0.0]


def chance_of(difference: Array, covariance: Array) -> float | None:
    """Chance of a difference (n,) at least as large with this covariance (n, n); unknown entries (NaN) are left out."""
    known = np.isfinite(difference) & np.isfinite(np.diag(covariance))
    if not known.any():
        return None
    std = np.sqrt(np.diag(covariance)[known])
    scaled = difference[known] / std
    correlation = covariance[np.ix_(known, known)] / np.outer(std, std)
    distance = float(scaled @ np.linalg.solve(correlation, scaled))
    return chi_square_tail(distance, int(known.sum()))


def chi_square_tail(x: float, freedom: int) -> float:
    """Chance that a chi-square variable exceeds x, by its recursion over the degrees of freedom (Abramowitz and Stegun 26.4.4-5)."""
    half = 0.5 * max(x, 0.0)
    tail = math.erfc(math.sqrt(half)) if freedom % 2 else math.exp(-half)
    for k in range(2 - freedom % 2, freedom, 2):
        tail += math.exp(0.5 * k * math.log(half) - half - math.lgamma(0.5 * k + 1.0)) if half > 0.0 else 0.0
    return min(tail, 1.0)


def _verdict(parameters: list[Difference], chance: float | None, *, differ: bool) -> Message:
    if chance is None:
        return Message.of("payload-runs-nothing-in-common")
    if not differ:
        return Message.of("payload-runs-agree", chance=chance)
    largest = max(parameters, key=lambda difference: abs(difference.times_std))
    return Message.of(
        "payload-runs-differ",
        chance=chance,
        parameter=largest.name,
        difference=largest.value,
        unit=largest.unit,
        times=abs(largest.times_std),
    )
