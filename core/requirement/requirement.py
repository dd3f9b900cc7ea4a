"""Which errors of a payload are allowed, and whether an answer's uncertainty stays within them.

Every criterion is a norm of something that is linear in the error of the ten parameters, so the largest allowed error in a direction is the
threshold over the largest response to one unit. Mass, centre of mass and inertia about it are varied one after the other, as they are typed
into a controller; an answer is judged with all of them at once, drawn from its covariance.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.cell.thresholds import ASSUMED_FORCE_N, ContactThresholds
from core.payload.inertia import PHI_NAMES, InertialParameters, symmetric
from core.requirement.motions import JointMotion
from core.requirement.response import Response, respond

if TYPE_CHECKING:  # who only reads requirements waits for no robot
    from core.robot.model import RobotModel

DRAWS = 4096
"""Of the covariance; the 95 % quantile of so many is known to 1 % of itself."""
COVERED = 0.95
NEAR = 0.3
"""Rows whose standard deviation is below so much of the largest decide nothing."""
STRIDE = 8
"""Each so many rows tell which draws come near the quantile."""
CLOSE = 0.85
"""Quantile from which draws are looked at again in every row."""
CHUNK = 16
"""Rows at once: what comes of them and all draws stays in the cache."""


class CriterionKind(StrEnum):
    """What a controller compares with a threshold, or what its maker allows."""

    JOINT_TORQUE = "joint_torque"
    TCP_FORCE = "tcp_force"
    GUIDING_FORCE = "guiding_force"
    MASS = "mass"
    COM = "centre_of_mass"


class PayloadQuantity(StrEnum):
    """What is typed into a controller."""

    MASS = "mass"
    COM = "centre_of_mass"
    INERTIA = "inertia"


GROUPS = {PayloadQuantity.MASS: slice(0, 1), PayloadQuantity.COM: slice(1, 4), PayloadQuantity.INERTIA: slice(4, 10)}
TYPED_NAMES = ("m", "c_x", "c_y", "c_z", *PHI_NAMES[4:])
"""Of what is typed, in its order; the inertia is about the centre of mass."""


@dataclass(frozen=True)
class Criterion:
    """One thing that must stay below a threshold at every time.

    Args:
        joint: number of the joint, counted from 1; None where it is about none.
        threshold: N m, N, kg or m.
        rows: (N, d, 10), per unit of mass (kg), centre of mass (m, three) and inertia about it (kg m2, six); the norm over d counts.
        period_s: between the rows; 0 where they are no times.
    """

    kind: CriterionKind
    joint: int | None
    threshold: float
    rows: Array
    period_s: float


@dataclass(frozen=True)
class Allowed:
    """The largest error of one group, the others right, in whichever direction it lies.

    Args:
        error: kg, m, or kg m2 (Frobenius norm of the error of the inertia about the centre of mass); infinite where nothing limits it.
        criterion: what decides; None where nothing does.
        time_s: when, along the motion.
    """

    group: PayloadQuantity
    error: float
    criterion: Criterion | None
    time_s: float


@dataclass(frozen=True)
class Requirement:
    """What a controller needs to know of a payload.

    Args:
        payload: the one about which errors are counted.
        assumed: whether the cell states no threshold of contact, and `ASSUMED_FORCE_N` is taken.
        allowed: one of each group.
        source: where the cell has its thresholds from; None where it does not say.
    """

    payload: InertialParameters
    criteria: tuple[Criterion, ...]
    allowed: tuple[Allowed, ...]
    assumed: bool
    source: str | None = None


@dataclass(frozen=True)
class Adequacy:
    """Whether an answer is good enough.

    Args:
        used: share of the threshold that the answer's error stays below with 95 % probability: good enough below 1.
        criterion: the one of which most is used.
        decides: whose uncertainty uses most of it.
        shares: of the variance there, by group; they sum to 1 but for correlations between groups.
        parameter: the one of that group whose uncertainty uses most, as `TYPED_NAMES` counts them.
        error: how far it may be off, the others right, kg, m or kg m2; infinite where nothing limits it alone.
        std: its standard uncertainty, in the same unit.
    """

    used: float
    criterion: Criterion
    decides: PayloadQuantity
    shares: dict[PayloadQuantity, float]
    parameter: int
    error: float
    std: float

    @property
    def good_enough(self) -> bool:
        """Whether no threshold is reached."""
        return self.used < 1.0

    @property
    def margin(self) -> float:
        """By how much every standard deviation might grow, or has to shrink."""
        return 1.0 / self.used if self.used > 0.0 else np.inf


def require(cell: Cell, robot: RobotModel, payload: InertialParameters, motion: JointMotion) -> Requirement:
    """What the cell's controller needs to know of a payload (sensor frame) along a motion.

    The thresholds are those of the cell; where it states none of contact, `ASSUMED_FORCE_N` at the sensor frame.
    """
    stated = cell.thresholds
    assumed = not stated.states_contact
    thresholds = stated.model_copy(update={"tcp_force_n": ASSUMED_FORCE_N}) if assumed else stated
    response = respond(cell, robot, motion, thresholds.observer_rate_per_s)
    criteria = tuple(_criteria(thresholds, response, find_typed_jacobian(payload)))
    return Requirement(payload, criteria, tuple(_allow(group, criteria) for group in PayloadQuantity), assumed, stated.source)


def find_typed_jacobian(payload: InertialParameters) -> Array:
    """(10, 10): derivative of Phi by what is typed: mass, centre of mass, inertia about it (the paper's order of six)."""
    m, c = payload.mass, payload.com

    def change(error: Array) -> Array:
        return InertialParameters.from_com(m + error[0], c + error[1:4], payload.inertia_com + symmetric(error[4:])).phi

    unit = np.eye(10)  # of second degree at most in each of them, so these differences are exact
    return np.stack([0.5 * (change(each) - change(-each)) for each in unit], axis=1)


def _criteria(thresholds: ContactThresholds, response: Response, typed: Array) -> list[Criterion]:
    found = []
    if thresholds.joint_torque_nm is not None:
        found += [
            Criterion(CriterionKind.JOINT_TORQUE, joint, limit, response.torque_nm[:, joint - 1 : joint] @ typed, response.period_s)
            for joint, limit in enumerate(thresholds.joint_torque_nm, start=1)
        ]
    for kind, limit, rows in (
        (CriterionKind.TCP_FORCE, thresholds.tcp_force_n, response.force_n),
        (CriterionKind.GUIDING_FORCE, thresholds.guiding_force_n, response.guiding_force_n),
    ):
        if limit is not None:
            found.append(Criterion(kind, None, limit, rows @ typed, response.period_s))
    for kind, limit, group in (
        (CriterionKind.MASS, thresholds.mass_kg, PayloadQuantity.MASS),
        (CriterionKind.COM, thresholds.com_m, PayloadQuantity.COM),
    ):
        if limit is not None:
            found.append(Criterion(kind, None, limit, np.eye(10)[None, GROUPS[group]], 0.0))
    return found


def _allow(group: PayloadQuantity, criteria: tuple[Criterion, ...]) -> Allowed:
    best = Allowed(group, np.inf, None, 0.0)
    for criterion in criteria:
        # Frobenius norm: what stands off the diagonal stands there twice.
        columns = criterion.rows[..., GROUPS[group]] / (np.sqrt([1, 2, 2, 1, 2, 1]) if group is PayloadQuantity.INERTIA else 1.0)
        gains = _largest_gains(columns)
        k = int(gains.argmax()) if len(gains) else 0
        if len(gains) and gains[k] > 0.0 and criterion.threshold / gains[k] < best.error:
            best = Allowed(group, criterion.threshold / float(gains[k]), criterion, criterion.period_s * k)
    return best


def _largest_gains(columns: Array) -> Array:
    """(N,), the largest singular value of each of (N, d, k)."""
    gram = columns @ columns.transpose(0, 2, 1)  # 3 x 3 at most
    return np.asarray(np.sqrt(np.maximum(np.linalg.eigvalsh(gram)[:, -1], 0.0)))


def judge(requirement: Requirement, covariance: Array) -> Adequacy:
    """Whether an answer with this covariance (10, 10) of Phi, finite, is good enough."""
    from scipy.stats import qmc  # noqa: PLC0415 - the service knows what a requirement is, and starts without SciPy

    typed = np.linalg.inv(find_typed_jacobian(requirement.payload))
    spread = typed @ covariance @ typed.T
    values, vectors = np.linalg.eigh(spread)
    root = vectors * np.sqrt(np.maximum(values, 0.0))
    normal = qmc.MultivariateNormalQMC(mean=np.zeros(10), rng=np.random.default_rng(0)).random(DRAWS).T
    rows = [criterion.rows @ root / criterion.threshold for criterion in requirement.criteria]
    coarse = np.array([_largest(each[::STRIDE], normal) for each in rows])
    worst = int(np.quantile(coarse, COVERED, axis=1).argmax())
    used = _find_used(rows, coarse.max(axis=0), normal)
    decides, parameter, shares = _decide(requirement.criteria[worst], spread)
    error = min(_find_allowed_alone(criterion, parameter) for criterion in requirement.criteria)
    std = float(np.sqrt(max(spread[parameter, parameter], 0.0)))
    return Adequacy(used, requirement.criteria[worst], decides, shares, parameter, error, std)


def _largest(rows: Array, normal: Array) -> Array:
    """(K,), the largest share of the threshold that each draw (10, K) uses in rows (N, d, 10), which are per standard deviation."""
    squares = np.zeros(normal.shape[1])
    size = np.linalg.norm(rows, axis=(1, 2))
    near = rows[size >= NEAR * size.max(initial=0.0)]
    for k in range(0, len(near), CHUNK):
        chunk = near[k : k + CHUNK]
        seen = np.square(chunk.reshape(-1, 10) @ normal).reshape(*chunk.shape[:2], -1)
        np.maximum(squares, seen.sum(axis=1).max(axis=0), out=squares)
    return np.sqrt(squares)


def _find_used(rows: list[Array], coarse: Array, normal: Array) -> float:
    """The quantile over all draws, those that come near it looked at in every row."""
    close = coarse >= np.quantile(coarse, CLOSE)
    found = coarse.copy()
    found[close] = np.max([_largest(each, normal[:, close]) for each in rows], axis=0)
    return float(np.quantile(found, COVERED))


def _decide(criterion: Criterion, spread: Array) -> tuple[PayloadQuantity, int, dict[PayloadQuantity, float]]:
    """Whose variance it is where the response is largest: of which group, of which of its parameters, and the shares of all groups."""
    variances = np.einsum("kdi,kdi->k", criterion.rows @ spread, criterion.rows)
    row = criterion.rows[int(variances.argmax())]
    parts = {group: float(np.einsum("di,ij,dj->", row[:, k], spread[k, k], row[:, k])) for group, k in GROUPS.items()}
    total = sum(parts.values()) or 1.0
    shares = {group: part / total for group, part in parts.items()}
    decides = max(shares, key=lambda group: shares[group])
    alone = (row**2).sum(axis=0) * np.diag(spread)
    k = GROUPS[decides]
    return decides, k.start + int(alone[k].argmax()), shares


def _find_allowed_alone(criterion: Criterion, parameter: int) -> float:
    """How far one of what is typed may be off for this criterion, the others right."""
    gain = float(np.linalg.norm(criterion.rows[:, :, parameter], axis=1).max(initial=0.0))
    return criterion.threshold / gain if gain > 0.0 else np.inf
