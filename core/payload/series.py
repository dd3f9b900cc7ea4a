"""A series of identifications of one payload: whether they agree, how they scatter (ISO 5725), and what they say together."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations

import numpy as np
from pydantic import BaseModel, ConfigDict, Field

from core.array import Array
from core.errors import BadInput
from core.payload.comparison import SIGNIFICANT, chance_of, chi_square_tail
from core.payload.inertia import PHI_NAMES, PHI_UNITS
from core.payload.random_effects import GROUPS, Measured, Pooled, difference_covariance, find_excess, pool
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message

LIMIT = 2.8
"""Times the standard deviation: two results differ by more in one of twenty pairs (ISO 5725-6, 1.96 sqrt(2))."""
NORMAL = 1.96
TEMPTING_WEIGHT = 0.5
"""Share of the prior in a parameter from which it is said that the answer is more what was known than what was measured."""


class SeriesPart(BaseModel):
    """Frozen; what is not known is null."""

    model_config = ConfigDict(frozen=True, allow_inf_nan=False)


class Scatter(SeriesPart):
    """One parameter over a series; all in `unit`."""

    name: str = Field(description="Name of the parameter.", examples=["m"])
    unit: str = Field(description="Unit of all numbers but shares.", examples=["kg"])
    values: list[float | None] = Field(description="What each run found; null is what it does not determine.", examples=[[2.781, 2.784]])
    stds: list[float | None] = Field(description="Their standard uncertainties.", examples=[[0.0006, 0.0006]])
    mean: float | None = Field(description="What they say together, see `half_width`.", examples=[2.7829])
    half_width: float | None = Field(description="Half of the 95 % interval of `mean`, Student's t.", examples=[0.0042])
    stated_std: float | None = Field(description="What the runs state of their own scatter, root mean square.", examples=[0.0006])
    repeatability_std: float | None = Field(
        description="Repeatability standard deviation s_r (ISO 5725-2): scatter of runs under one condition; null without a repetition.",
        examples=[0.0011],
    )
    between_std: float | None = Field(
        description="Standard deviation s_L between conditions (ISO 5725-2); null where there is only one.", examples=[0.0009]
    )
    reproducibility_std: float | None = Field(
        description="Reproducibility standard deviation s_R (ISO 5725-2): scatter of runs under different conditions.", examples=[0.0014]
    )
    unstated_std: float = Field(
        description="Scatter between runs beyond what they state, by restricted maximum likelihood, the same for all of one group "
        "(mass; first moment; inertia); 0 where they scatter no more.",
        examples=[0.0008],
    )
    weights: list[float] = Field(description="Share of each run in `mean`.", examples=[[0.48, 0.52]])
    prior_weight: float = Field(description="Share of the prior in `mean`, 0 without one.", examples=[0.0])


class PairOfRuns(SeriesPart):
    """Two runs of a series."""

    first: str = Field(description="Name of the first run.", examples=["monday-1"])
    second: str = Field(description="Name of the second run.", examples=["monday-2"])
    chance: float | None = Field(
        description="Chance, 0 to 1, of a difference at least as large, were the payload the same; null without common parameters.",
        examples=[0.41],
    )
    differ: bool = Field(description="Whether that is too small to believe, given how many pairs there are.")


class RunApart(SeriesPart):
    """The one run without which the others agree, and in which parameter it is off most clearly."""

    run: str = Field(description="Name of the run.", examples=["monday-2"])
    parameter: str = Field(description="Name of the parameter in which it differs most clearly.", examples=["m"])
    unit: str = Field(description="Unit of `difference` and `std`.", examples=["kg"])
    difference: float = Field(description="This run less the mean of the others.", examples=[0.031])
    std: float = Field(description="Its standard uncertainty, from what the runs state of their own scatter.", examples=[0.0008])


class Series(SeriesPart):
    """Several identifications side by side, in one frame."""

    runs: list[str] = Field(description="Names of the runs, in the order of all lists.", examples=[["monday-1", "monday-2"]])
    conditions: list[str] = Field(description="Under which each was made.", examples=[["monday", "monday"]])
    parameters: list[Scatter] = Field(description="The ten parameters in the paper's order.")
    covariance: list[list[float | None]] = Field(description="Of the ten means, SI.", examples=[[[1e-6]]])
    pairs: list[PairOfRuns] = Field(description="Every two runs.")
    chance: float | None = Field(
        description="Chance, 0 to 1, of differences at least as large, were the payload the same; null with one run.",
        examples=[0.22],
    )
    differ: bool = Field(description="Whether that is too small to believe (below 0.01).")
    apart: RunApart | None = Field(
        default=None, description="The one run that differs from the others, which agree; null where none does, or more than one."
    )
    prior_used: bool = Field(default=False, description="Whether something that was known before has a share in the means.")
    prior: str | None = Field(default=None, description="Where the prior is from; null where nobody has said.", examples=["CAD"])
    verdict: Message = Field(description="The same in a sentence.")
    remarks: list[Message] = Field(description="What should be known before the numbers are used.")


def compare_series(
    names: Sequence[str],
    runs: Sequence[Measured],
    *,
    conditions: Sequence[str] | None = None,
    prior: UncertainParameters | None = None,
    prior_source: str | None = None,
) -> Series:
    """Compares and pools runs of what may be one payload, in one frame.

    Args:
        names: of the runs; `conditions`: under which each was made (day, plan, robot), one for all where absent.
        prior: of the payload, with what it is uncertain by; `prior_source`: where it is from.

    Raises:
        BadInput: no run determines anything, or as many conditions as runs are not there.
    """
    under = list(conditions or ["" for _ in runs])
    if len(under) != len(runs):
        raise BadInput("--conditions", "payload-conditions-of-other-runs", count=len(under), runs=len(runs))
    if not any(np.isfinite(run.own.phi).any() for run in runs):
        raise BadInput(", ".join(names), "payload-series-of-nothing")
    pooled = pool(runs, prior)
    chance = chi_square_tail(pooled.excess, pooled.excess_freedom) if pooled.excess_freedom else None
    differ = chance is not None and chance < SIGNIFICANT
    pairs = _pairs(names, runs)
    return Series(
        runs=list(names),
        conditions=under,
        parameters=[_scatter(k, runs, under, pooled) for k in range(10)],
        covariance=[[_number(v) for v in row] for row in pooled.parameters.covariance],
        pairs=pairs,
        chance=chance,
        differ=differ,
        apart=find_run_apart(names, runs, pairs) if differ else None,
        prior_used=prior is not None,
        prior=prior_source if prior is not None else None,
        verdict=_verdict(len(runs), pooled, chance, differ=differ),
        remarks=_remarks(pooled, under, prior),
    )


def _scatter(k: int, runs: Sequence[Measured], conditions: Sequence[str], pooled: Pooled) -> Scatter:
    values, std = np.array([run.own.phi[k] for run in runs]), np.array([run.own.std[k] for run in runs])
    known = np.isfinite(values)
    repeatability, between, reproducibility = analyse_variance(
        values[known], [c for c, flag in zip(conditions, known, strict=True) if flag]
    )
    return Scatter(
        name=PHI_NAMES[k],
        unit=PHI_UNITS[k],
        values=[_number(v) for v in values],
        stds=[_number(v) for v in std],
        mean=_number(pooled.parameters.phi[k]),
        half_width=_number(half_width(k, pooled)),
        stated_std=_number(float(np.sqrt(np.mean(std[known] ** 2)))) if known.any() else None,
        repeatability_std=repeatability,
        between_std=between,
        reproducibility_std=reproducibility,
        unstated_std=float(pooled.between_std[k]),
        weights=[float(w) for w in pooled.weights[:, k]],
        prior_weight=float(pooled.prior_weight[k]),
    )


def analyse_variance(values: Array, conditions: Sequence[str]) -> tuple[float | None, float | None, float | None]:
    """Standard deviations s_r, s_L and s_R of a one-way analysis of variance (ISO 5725-2, 7.4); None where nothing tells."""
    groups = [values[[c == name for c in conditions]] for name in dict.fromkeys(conditions)]
    freedom = len(values) - len(groups)
    within = sum(float(((g - g.mean()) ** 2).sum()) for g in groups) / freedom if freedom > 0 else None
    if len(groups) < 2:
        return (None if within is None else float(np.sqrt(within))), None, None
    sizes = np.array([len(g) for g in groups])
    mean_square = float((sizes * (np.array([g.mean() for g in groups]) - values.mean()) ** 2).sum()) / (len(groups) - 1)
    if within is None:
        return None, None, float(np.sqrt(mean_square))
    size = (sizes.sum() - (sizes**2).sum() / sizes.sum()) / (len(groups) - 1)
    between = max(mean_square - within, 0.0) / size
    return float(np.sqrt(within)), float(np.sqrt(between)), float(np.sqrt(within + between))


def half_width(k: int, pooled: Pooled) -> float:
    """Of the 95 % interval of parameter k: what the runs' scatter says by Student's t, what they have in common by its stated size."""
    common = float(pooled.common_std[k])
    own = np.sqrt(max(float(pooled.parameters.std[k]) ** 2 - common**2, 0.0)) if np.isfinite(pooled.parameters.std[k]) else np.nan
    freedom = pooled.freedom * next(len(range(10)[group]) for group in GROUPS if k in range(10)[group])
    return float(np.hypot(student_factor(freedom) * own, NORMAL * common))


def student_factor(freedom: int) -> float:
    """Half the width of a 95 % interval in standard uncertainties that so many degrees of freedom tell; the normal's with none."""
    if freedom < 1:
        return NORMAL
    low, high = NORMAL, 13.0
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if student_within(middle, freedom) < 0.95 else (low, middle)
    return 0.5 * (low + high)


def student_within(t: float, freedom: int) -> float:
    """Chance that Student's variable lies within t of zero, by its finite series (Abramowitz and Stegun 26.7.3-4)."""
    angle = math.atan(t / math.sqrt(freedom))
    square, term, total = math.cos(angle) ** 2, math.cos(angle) if freedom % 2 else 1.0, 0.0
    for k in range(3 if freedom % 2 else 2, freedom + 1, 2):
        total += term
        term *= square * (k - 1) / k
    if freedom % 2:
        return 2.0 / math.pi * (angle + math.sin(angle) * total)
    return math.sin(angle) * total


def _pairs(names: Sequence[str], runs: Sequence[Measured]) -> list[PairOfRuns]:
    count = len(runs) * (len(runs) - 1) // 2
    found = []
    for i, j in combinations(range(len(runs)), 2):
        first, second = runs[i], runs[j]
        chance = chance_of(second.own.phi - first.own.phi, difference_covariance(first, second))
        found.append(PairOfRuns(first=names[i], second=names[j], chance=chance, differ=chance is not None and chance < SIGNIFICANT / count))
    return found


def find_run_apart(names: Sequence[str], runs: Sequence[Measured], pairs: Sequence[PairOfRuns]) -> RunApart | None:
    """The run that most others differ from, if they agree without it; of two runs nobody can say which is off.

    Args:
        pairs: every two of the runs.
    """
    if len(runs) < 3:
        return None
    of_run = [[pair for pair in pairs if name in (pair.first, pair.second)] for name in names]
    i = max(range(len(runs)), key=lambda k: (sum(pair.differ for pair in of_run[k]), -sum(pair.chance or 0.0 for pair in of_run[k])))
    others = [*runs[:i], *runs[i + 1 :]]
    excess, freedom = find_excess(others)
    if not freedom or chi_square_tail(excess, freedom) < SIGNIFICANT:
        return None
    # only what scatters counts: what all runs have in common parts none of them
    information = np.array([run.own.std for run in others]) ** -2.0
    total = np.nansum(information, axis=0)
    known = np.where(total > 0.0, total, np.nan)
    difference = runs[i].own.phi - np.nansum(information * np.array([run.own.phi for run in others]), axis=0) / known
    std = np.sqrt(runs[i].own.std ** 2 + 1.0 / known)
    times = np.nan_to_num(np.abs(difference / std))
    k = int(np.argmax(times))
    if times[k] == 0.0:
        return None
    return RunApart(run=names[i], parameter=PHI_NAMES[k], unit=PHI_UNITS[k], difference=float(difference[k]), std=float(std[k]))


def _verdict(count: int, pooled: Pooled, chance: float | None, *, differ: bool) -> Message:
    if count == 1:
        return Message.of("payload-series-of-one")
    if chance is None:
        return Message.of("payload-runs-nothing-in-common")
    if not differ:
        return Message.of("payload-series-agrees", runs=count, chance=chance)
    scatter = [
        Message.of(code, std=float(pooled.between_std[k]))
        for code, k in (("payload-scatter-mass", 0), ("payload-scatter-first-moment", 1), ("payload-scatter-inertia", 4))
        if pooled.between_std[k] > 0.0
    ]
    return Message.of("payload-series-differs", runs=count, chance=chance, scatter=scatter)


def _remarks(pooled: Pooled, conditions: Sequence[str], prior: UncertainParameters | None) -> list[Message]:
    said = []
    if 0 < pooled.freedom < 4 and pooled.between_std.any():
        said.append(Message.of("payload-few-runs", runs=pooled.freedom + 1))
    if len(set(conditions)) == 1 and pooled.freedom > 0:
        said.append(Message.of("payload-one-condition"))
    if prior is not None:
        leaning = [name for name, weight in zip(PHI_NAMES, pooled.prior_weight, strict=True) if weight > TEMPTING_WEIGHT]
        if leaning:
            said.append(Message.of("payload-mostly-prior", parameters=leaning))
    return said


def _number(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None
