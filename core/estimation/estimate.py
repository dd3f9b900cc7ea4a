"""What an identification says: the paper's estimate, ours beside it, and in words what can and cannot be said."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from core.estimation.segments import Segment
from core.inertia import InertialParameters, Motion, six_of

Array = NDArray[np.float64]
Bools = NDArray[np.bool_]


@dataclass(frozen=True)
class PaperEstimate:
    """Algorithms 1-5 with the offsets of Eq. (5) and the uncertainties of Eq. (8)-(10).

    Args:
        phi, std: (10,), the paper's order, SI; NaN where the paper's method does not identify it (products of inertia always).
        offset: (6,), N and N m; NaN where no opposed poses were seen.
    """

    phi: Array
    std: Array
    offset: Array


@dataclass(frozen=True)
class Drift:
    """Slow change of the sensor's offset, as estimated.

    Args:
        t: (K,), s.
        value: (K, 6), departure from the mean offset, N and N m.
        std: (6,), uncertainty of its range.
    """

    t: Array
    value: Array
    std: Array

    @property
    def range(self) -> Array:
        """(6,), largest minus smallest value."""
        return np.ptp(self.value, axis=0) if len(self.value) else np.zeros(6)

    @property
    def description(self) -> str:
        """One sentence."""
        channels = ("fx", "fy", "fz", "tx", "ty", "tz")
        seen = [
            f"{name} {size:.2g} {'N' if name[0] == 'f' else 'N m'}"
            for name, size, std in zip(channels, self.range, self.std, strict=True)
            if size > 3.0 * std > 0.0
        ]
        return "the sensor's offset drifted: " + ", ".join(seen) if seen else "no drift of the sensor's offset beyond its noise"


@dataclass(frozen=True)
class Estimate:
    """All ten parameters from all samples, sensor frame, SI.

    Args:
        phi: (10,), the paper's order; NaN where not determined.
        covariance: (10, 10), of `phi`; NaN in the rows and columns of what is not determined.
        determined: (10,).
        reasons: name of the parameter -> why it is not determined.
        offset, offset_std: (6,), mean over the recording.
        consistent: whether a body can have these parameters (positive definite pseudo-inertia); enforced, so False only without a mass.
        constrained: whether that moved what is determined (the data alone asked for a body that cannot exist).
        base_tilt_rad, base_tilt_std: (2,), rotation of the true gravity against the nominal one about base x and y.
        delay_s, delay_std: how late the wrench is against the joints.
        residual_rms, noise_std: (6,), per sample, N and N m.
    """

    phi: Array
    covariance: Array
    determined: Bools
    reasons: dict[str, str]
    offset: Array
    offset_std: Array
    consistent: bool
    residual_rms: Array
    noise_std: Array
    drift: Drift
    constrained: bool = False
    base_tilt_rad: Array | None = None
    base_tilt_std: Array | None = None
    delay_s: float | None = None
    delay_std: float | None = None

    @cached_property
    def std(self) -> Array:
        """(10,), standard uncertainty; NaN where not determined."""
        return np.sqrt(np.diag(self.covariance))

    @cached_property
    def parameters(self) -> InertialParameters | None:
        """The payload; None unless all ten are determined."""
        return InertialParameters(self.phi) if bool(self.determined.all()) else None

    @cached_property
    def com_m(self) -> Array:
        """(3,), centre of mass; NaN where not determined."""
        return np.asarray(self.phi[1:4] / self.phi[0])

    @cached_property
    def com_covariance(self) -> Array:
        """(3, 3), m2, by first-order propagation."""
        J = np.column_stack((-self.com_m / self.phi[0], np.eye(3) / self.phi[0]))
        return _propagate(J, self.covariance[:4, :4])

    @property
    def com_std(self) -> Array:
        """(3,), m."""
        return np.sqrt(np.diag(self.com_covariance))

    @cached_property
    def inertia_com(self) -> Array:
        """(6,), `[Ixx, Ixy, Ixz, Iyy, Iyz, Izz]` about the centre of mass, kg m2; NaN where not determined."""
        return self.phi[4:] - six_of(_steiner(self.phi[:4]))

    @cached_property
    def inertia_com_std(self) -> Array:
        """(6,), kg m2, by first-order propagation."""
        m, mc = self.phi[0], self.phi[1:4]
        J = np.zeros((6, 10))
        J[:, 4:] = np.eye(6)
        J[:, 0] = six_of(_steiner(self.phi[:4])) / m
        for i, e in enumerate(np.eye(3)):
            J[:, 1 + i] = -six_of(2.0 * mc[i] * np.eye(3) - np.outer(mc, e) - np.outer(e, mc)) / m
        return np.sqrt(np.diag(_propagate(J, self.covariance)))


def _steiner(moments: Array) -> Array:
    """3x3 share of the offset centre of mass in the inertia, from `[m, mc]`."""
    m, mc = moments[0], moments[1:]
    return np.asarray((mc @ mc * np.eye(3) - np.outer(mc, mc)) / m)


def _propagate(J: Array, covariance: Array) -> Array:
    """J S J^T in which a NaN spoils only the outputs that depend on it."""
    unknown = np.isnan(np.diag(covariance))
    S = np.where(np.isnan(covariance), 0.0, covariance)
    result = np.where(np.isnan(J), 0.0, J) @ S @ np.where(np.isnan(J), 0.0, J).T
    spoilt = np.isnan(J).any(axis=1) | (np.abs(np.where(np.isnan(J), 1.0, J)) @ unknown > 0)
    result[spoilt, :] = np.nan
    result[:, spoilt] = np.nan
    return np.asarray(result)


@dataclass(frozen=True)
class TimeSeries:
    """Measured against reconstructed, one row per sample, for the report and the gap.

    Args:
        t: (N,), s.
        motion: kinematics in the sensor frame, smoothed without lag.
        measured: (N, 6), wrench minus offset and drift; None without a wrist sensor.
        reconstructed: (N, 6), wrench that the estimate predicts at the same times; None likewise.
    """

    t: Array
    motion: Motion
    measured: Array | None = None
    reconstructed: Array | None = None


@dataclass(frozen=True)
class Identification:
    """The answer to one recording.

    Args:
        paper: the paper's estimate.
        estimate: ours; None where the recording has no wrench.
        verdict: one or two sentences.
        warnings: what the user should know before using the numbers.
        segments: the motionless, rotating and other parts.
        series: for the report; None where the recording has no motion to show.
        bounds: what can be said all the same, in words, for recordings without a wrench.
        accounted: identifiers of the twin's effects that were taken off the wrench.
    """

    paper: PaperEstimate
    estimate: Estimate | None
    verdict: str
    warnings: tuple[str, ...] = ()
    segments: tuple[Segment, ...] = ()
    series: TimeSeries | None = None
    bounds: tuple[str, ...] = field(default=())
    accounted: tuple[str, ...] = ()
