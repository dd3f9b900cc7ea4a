"""Which slip explains that the same number differs along several ways: of the clock, of positions, of units, of the torque's point.

The numbers of a fit are `z = M theta` with theta = (m, mc) or more; M is all ones for a right set-up; a slip puts its factors into it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.estimation.setup.agreement import SIZE, measure_disagreement, relate
from core.estimation.setup.payload_fit import MASS_INERTIA, MASS_WEIGHT, MOMENT_FORCE, MOMENT_INERTIA, MOMENT_WEIGHT, PayloadFit
from core.estimation.setup.search import MOST_NAMED, SetupExplanation
from core.estimation.setup.units import FORCE_UNITS, MILLIMETRES, TIME_UNITS, TORQUE_UNITS
from core.words.message import Message

CONTRADICTION = 60.0
"""Chi-square of seven from which the stated set-up is doubted."""
EXPLAINED = 30.0
TIMES_BETTER = 6.0
APART = 8.0
"""Difference in chi-square from which one slip is told from another."""
CLOSE = 0.06
"""Share by which a clock may miss a unit of time and still be taken for it."""
SMALLEST_STRETCH = 1.25
SHORTEST_SHIFT_M = 0.02


@dataclass(frozen=True)
class Relation:
    """One kind of slip: `M` (11, k) with z = M theta; how many numbers were chosen to make it fit."""

    name: Message
    M: Array
    chosen: int = 0


def explain_relations(fit: PayloadFit) -> SetupExplanation | None:
    """What would be right instead of the stated set-up; None where the numbers agree, or nothing explains them."""
    stated = measure_disagreement(fit)
    if stated < CONTRADICTION:
        return None
    tried = [(measure_disagreement(fit, relation.M) + 2.0 * relation.chosen, relation) for relation in _relations(fit)]
    best = min(tried, key=lambda found: found[0])[0]
    if best > EXPLAINED or stated < TIMES_BETTER * max(best, 7.0):
        return None
    leading = sorted((found for found in tried if found[0] < best + APART), key=lambda found: found[0])[:MOST_NAMED]
    return SetupExplanation(tuple(relation.name for _, relation in leading), float(np.sqrt(stated / max(best, 7.0))))


def sign_by_motion(fit: PayloadFit) -> int:
    """Of the mass by its inertia: 1, -1, or 0 where the motion does not tell."""
    mass, std = fit.z[MASS_INERTIA], float(np.sqrt(fit.covariance[MASS_INERTIA, MASS_INERTIA]))
    return 0 if abs(mass) < 5.0 * std or abs(mass) < 0.3 * abs(fit.mass) else int(np.sign(mass))


def _relations(fit: PayloadFit) -> Iterator[Relation]:
    for unit, k in FORCE_UNITS.items():
        yield Relation(Message.of("setup-force-in", unit=unit), relate(k, k, (1.0, 1.0, k)))
    for unit, k in TORQUE_UNITS.items():
        yield Relation(Message.of("setup-torque-in", unit=unit), relate(1.0, 1.0, (k, k, 1.0)))
    yield Relation(Message.of("setup-positions-in-millimetres"), relate(1.0, 1.0 / MILLIMETRES, (1.0, 1.0 / MILLIMETRES, 1.0)))
    yield Relation(Message.of("setup-sign-of-torque"), relate(1.0, 1.0, (-1.0, -1.0, 1.0)))
    yield Relation(Message.of("setup-gravity-opposite"), relate(-1.0, 1.0, (-1.0, 1.0, 1.0)))
    yield from _clock(fit)
    yield from _point(fit)


def _clock(fit: PayloadFit) -> Iterator[Relation]:
    """Accelerations by the recording's clock are wrong by the square of what the clock is."""
    z = fit.z
    starts = [z[MASS_INERTIA] / z[MASS_WEIGHT], z[MOMENT_FORCE] @ z[MOMENT_WEIGHT] / (z[MOMENT_WEIGHT] @ z[MOMENT_WEIGHT])]
    factors = np.concatenate([start * np.geomspace(0.3, 3.0, 61) for start in starts if start > 0.0 and np.isfinite(start)] or [[]])
    models = [(measure_disagreement(fit, _clock_model(s)), s) for s in factors]
    if not models:
        return
    stretch = float(np.sqrt(min(models)[1]))
    unit = next((name for name, k in TIME_UNITS.items() if abs(stretch / k - 1.0) < CLOSE), None)
    if unit is not None:
        yield Relation(Message.of("setup-time-in", unit=unit), _clock_model(TIME_UNITS[unit] ** 2), 1)
    elif not 1.0 / SMALLEST_STRETCH < stretch < SMALLEST_STRETCH:
        name = Message.of("setup-clock-slow" if stretch < 1.0 else "setup-clock-fast", times=max(stretch, 1.0 / stretch))
        yield Relation(name, _clock_model(stretch**2), 1)


def _clock_model(s: float) -> Array:
    return relate(1.0, s, (1.0, s, s))


def _point(fit: PayloadFit) -> Iterator[Relation]:
    """The torque about another point d has m d more of first moment, the force has not."""
    shift = (fit.z[MOMENT_WEIGHT] - fit.z[MOMENT_FORCE]) / fit.mass
    distance = float(np.linalg.norm(shift))
    if SHORTEST_SHIFT_M < distance < 1.5:
        M = np.concatenate((relate(), np.zeros((SIZE, 3))), axis=1)
        M[MOMENT_WEIGHT, 4:] = M[MOMENT_INERTIA, 4:] = np.eye(3)
        yield Relation(Message.of("setup-torque-about-another-point", shift_m=[round(float(v), 3) for v in shift]), M, 3)
