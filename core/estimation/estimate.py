"""What an identification says: the paper's estimate, ours beside it, and what can and cannot be said."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.estimation.budget import Budget
from core.estimation.segments import Segment
from core.payload.channels import CHANNELS
from core.payload.inertia import InertialParameters, Motion
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message

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
class DriftEstimate:
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
    def description(self) -> Message:
        """By how much it changed, in the channels where that is seen."""
        seen = [
            Message.of("estimation-drift-of-force", channel=name, range_n=float(size))
            if name.startswith("f")
            else Message.of("estimation-drift-of-torque", channel=name, range_n_m=float(size))
            for name, size, std in zip(CHANNELS, self.range, self.std, strict=True)
            if size > 3.0 * std > 0.0
        ]
        return Message.of("estimation-drift", channels=seen) if seen else Message.of("estimation-no-drift")


@dataclass(frozen=True)
class Estimate(UncertainParameters):
    """All ten parameters from all samples, sensor frame, SI.

    Args:
        covariance: (10, 10), type A and type B together; `budget` says which part is which.
        determined: (10,).
        reasons: name of the parameter -> why it is not determined.
        offset, offset_std: (6,), mean over the recording.
        consistent: whether a body can have these parameters (positive definite pseudo-inertia); enforced, so False only without a mass.
        constrained: whether the data alone asked for a body that cannot exist, at a level of 1 %.
        base_tilt_rad, base_tilt_std: (2,), rotation of the true gravity against the nominal one about base x and y.
        delay_s, delay_std: how late the wrench is against the joints.
        residual_rms, noise_std: (6,), per sample, N and N m; NaN, as the offset, without a wrist sensor.
        converged: whether the iteration came to rest.
    """

    determined: Bools
    reasons: dict[str, Message]
    offset: Array
    offset_std: Array
    consistent: bool
    residual_rms: Array
    noise_std: Array
    drift: DriftEstimate
    budget: Budget
    converged: bool = True
    constrained: bool = False
    base_tilt_rad: Array | None = None
    base_tilt_std: Array | None = None
    delay_s: float | None = None
    delay_std: float | None = None

    @cached_property
    def repeatability(self) -> UncertainParameters:
        """The same parameters with what this recording alone leaves open (type A)."""
        covariance = np.where(np.isnan(self.covariance), np.nan, self.budget.repeatability)
        return UncertainParameters(self.phi, covariance)

    @cached_property
    def parameters(self) -> InertialParameters | None:
        """The payload; None unless all ten are determined."""
        return InertialParameters(self.phi) if bool(self.determined.all()) else None


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
class Verification:
    """One motion, predicted by a fit to all the rest.

    Args:
        phase: of the motion.
        windows: averages of 50 ms and more that were compared.
        rms: (6,), of measured minus predicted, N and N m.
        noise: (6,), what noise alone makes of it.
        expected: (6,), noise and the uncertainty of the prediction together.
    """

    phase: str
    windows: int
    rms: Array
    noise: Array
    expected: Array

    @property
    def ratio(self) -> float:
        """Root mean square over the channels of what is seen against what is expected: near 1 where the estimate holds."""
        return float(np.sqrt(np.mean((self.rms / self.expected) ** 2)))


@dataclass(frozen=True)
class JointTorque:
    """What was found of one joint beside a payload that was identified from torques.

    Args:
        joint: its name.
        coulomb_n_m, viscous_n_m_s: friction.
        gain, gain_std: by what share its torque reads too much, and the standard uncertainty of that.
        residual_n_m: root mean square of what nothing explains.
        windows: how many short averages it could be used in; where there are none, the rest says nothing.
    """

    joint: str
    coulomb_n_m: float
    viscous_n_m_s: float
    gain: float
    gain_std: float
    residual_n_m: float
    windows: int


@dataclass(frozen=True)
class TwinShare:
    """What one entry of a cell's twin does to an estimate.

    Args:
        effect: its identifier; `title`: what it is called.
        recording: that the entry was fitted to.
        change: (10,), the estimate less what it would be without this entry, the others as they are.
    """

    effect: str
    title: Message
    recording: str
    change: Array


def _nothing() -> None:
    return None


@dataclass(frozen=True)
class Identification:
    """The answer to one recording.

    Args:
        paper: the paper's estimate.
        estimate: ours; None where nothing is determined.
        verdict: what of the payload is determined.
        warnings: what the user should know before using the numbers.
        segments: the motionless, rotating and other parts.
        joints: what was found of each, where the payload was identified from their torques.
        accounted: identifiers of the twin's effects that were taken off the wrench; `shares`: what each of them changes.
        drawn: finds the series; `verified`: the verification, nothing where there is no motion to leave out.
    """

    paper: PaperEstimate
    estimate: Estimate | None
    verdict: Message
    warnings: tuple[Message, ...] = ()
    segments: tuple[Segment, ...] = ()
    joints: tuple[JointTorque, ...] = ()
    accounted: tuple[str, ...] = ()
    shares: tuple[TwinShare, ...] = ()
    drawn: Callable[[], TimeSeries | None] = _nothing
    verified: Callable[[], tuple[Verification, ...]] = tuple

    @property
    def has_wrench(self) -> bool:
        """Whether the estimate rests on a wrist sensor's channels, of which there is something to show."""
        return self.estimate is not None and bool(np.isfinite(self.estimate.noise_std).all())

    @cached_property
    def series(self) -> TimeSeries | None:
        """For the report; None where the recording has no motion to show."""
        return self.drawn()

    @cached_property
    def verification(self) -> tuple[Verification, ...]:
        """Each rotation, predicted by a fit to all the rest."""
        return self.verified()
