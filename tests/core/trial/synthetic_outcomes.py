"""Outcomes made up for the tests of the score sheet: one trial each, everything said."""

from __future__ import annotations

from typing import Any

from core.trial.bound import Bound
from core.trial.draw import Sealed
from core.trial.outcome import Named, ParameterEstimate, PayloadTruth, TrialOutcome

PHI = (2.0, 0.02, 0.0, 0.1, 0.01, 0.0, 0.0, 0.01, 0.0, 0.005)
CLEAR = Bound(fault_sigma=100.0, material_sigma=50.0, nearest_rival_sigma=20.0, undescribed_sigma=1.0)


def sealed(seed: int, *ids: str, kind: str = "single", size: float = 1.0) -> Sealed:
    """What was planted."""
    parameters = "[" + ", ".join("{}" for _ in ids) + "]"
    return Sealed(
        seed=seed,
        cell="lwr4_bench",
        payload="cylinder",
        kind=kind,
        ids=ids,
        variants=tuple("plain" for _ in ids),
        size=size,
        truth=parameters,
    )


def none(seed: int, verdict: str = "no_gap", **more: Any) -> TrialOutcome:
    """A run without a fault."""
    return TrialOutcome(sealed=sealed(seed, kind="none"), stopped=None, verdict=verdict, none_probability=1.0, **more)


def single(
    seed: int, planted: str, answered: str, probability: float = 0.9, bound: Bound = CLEAR, size: float = 1.0, **more: Any
) -> TrialOutcome:
    """One fault with a name for an answer."""
    names = (Named(id=answered, probability=probability, closure=0.95),)
    if planted != answered:
        names += (Named(id=planted, probability=1.0 - probability, closure=1.0),)
    rest = 1.0 - sum(effect.probability for effect in names)
    values = {"verdict": "explained", "effects": names, "unknown_probability": rest, "bound": bound} | more
    return TrialOutcome(sealed=sealed(seed, planted, size=size), stopped=None, **values)


def unknown(seed: int, verdict: str = "unknown", **bound: float) -> TrialOutcome:
    """A fault that the library does not have."""
    values = {"fault_sigma": 100.0, "material_sigma": 50.0, "undescribed_sigma": 40.0} | bound
    planted = sealed(seed, "unknown", kind="unknown")
    return TrialOutcome(sealed=planted, stopped=None, verdict=verdict, unknown_probability=1.0, bound=Bound(**values))


def double(seed: int, pair: tuple[str, str], **more: Any) -> TrialOutcome:
    """Two faults, base tilt and a delay, answered by a pair."""
    bound = Bound(fault_sigma=100.0, material_sigma=50.0, second_sigma=30.0, second_material=True)
    values = {"bound": bound, "effects": (Named(id="base_tilt", probability=0.1, closure=0.5),), "pairs": ((pair, 0.9),)} | more
    planted = sealed(seed, "base_tilt", "time_delay", kind="double")
    return TrialOutcome(sealed=planted, stopped=None, verdict="explained", **values)


def estimates(**values: tuple[float, float]) -> dict[str, ParameterEstimate]:
    """Parameters with their uncertainties."""
    return {name: ParameterEstimate(value=value, std=std) for name, (value, std) in values.items()}


def payload(before: float, after: float, std: float) -> PayloadTruth:
    """All parameters off by these shares of what their sizes are: mass, first moment's norm, largest moment."""
    sizes = (2.0, *[(0.02**2 + 0.1**2) ** 0.5] * 3, *[0.01] * 6)
    return PayloadTruth(
        true=PHI,
        before=tuple(p + before * s for p, s in zip(PHI, sizes, strict=True)),
        before_std=tuple(std * s for s in sizes),
        after=tuple(p + after * s for p, s in zip(PHI, sizes, strict=True)),
        after_std=tuple(std * s for s in sizes),
    )
