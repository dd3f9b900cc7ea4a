"""What counts as right, and what can be asked of a diagnosis at all.

A trial counts where any method could answer it. One fault is to be named from twice the size at which it can be told from nothing, and when
it is material; below that "no gap" is the right answer. A fault that the library does not have counts when it is material and no effect of
the library describes it. Two faults count when the weaker one shows beside the other, and matters. Faults that are read off the recording
directly have no distance in the wrench: they count when they are material by the effect's own measure, by their parameters or by what
they add to the readings against the same run without them.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from core.effects.library import symptoms
from core.gap.limits import SHARES, sizes
from core.trial.outcome import TrialOutcome
from core.trial.truth import Parameters
from core.words.message import Message

DETECTABLE_SIGMA = 3.0
"""Distance from "nothing" below which nothing can find a fault."""
NAMED_SIGMA = 2.0 * DETECTABLE_SIGMA
"""From here on a fault, a second fault and a kind that the library does not have are to be named."""
SIZED_SIGMA = 5.0 * DETECTABLE_SIGMA
"""From here on parameters are to be right."""
TIE_SIGMA, CLEAR_SIGMA = 3.0, 6.0
"""Distance to the nearest rival below which the tie is to be declared, and above which there is to be one name."""
NAMED = ("explained", "ambiguous")
NO_GAP, EXPLAINED, UNKNOWN = "no_gap", "explained", "unknown"
SEEN_BESIDE = frozenset(symptom.id for symptom in symptoms())
"""Faults that are read off the recording directly."""


def material(outcome: TrialOutcome) -> bool:
    """Whether what was planted matters; faults without a measure in the wrench are taken to."""
    share = own_measure(outcome) if outcome.bound.materiality is None else outcome.bound.materiality
    return bool(outcome.sealed.ids) and share >= 1.0


def own_measure(outcome: TrialOutcome) -> float:
    """Materiality, 1 where it begins, of a fault that is read off the recording directly: from its parameters where its shape has them,
    else from what it adds to the readings; 1 where neither is known."""
    told = {name: _MEASURES[name](truth, outcome) for name, truth in outcome.truth.items() if name in _MEASURES}
    added = outcome.bound.added_noise
    seen = {name: added / limit for name, limit in _LIMITS.items() if name in outcome.sealed.ids and added is not None}
    return max((seen | told).values(), default=1.0)


def _mismatch(truth: Parameters, outcome: TrialOutcome) -> float:
    if outcome.payload is None:
        return 1.0
    return float((np.abs(list(truth.values())) / (SHARES * sizes(np.array(outcome.payload.true)))).max())


_MEASURES: dict[str, Callable[[Parameters, TrialOutcome], float]] = {
    "sensor_noise": lambda truth, _: max(truth.values()) / 1.5,
    "sample_dropout": lambda truth, _: truth["held_share"] / 0.01,
    "payload_mismatch": _mismatch,
}
"""As the effects' docstrings say."""
_LIMITS = {"sensor_interference": 3.0 / 2**0.5, "sensor_quantization": 12**-0.5, "sensor_noise": (1.5**2 - 1.0) ** 0.5}
"""The same for what is added to the readings, in standard deviations of their noise."""


def counts(outcome: TrialOutcome) -> bool:
    """Whether any method could give the right answer."""
    bound, kind = outcome.bound, outcome.sealed.kind
    if outcome.stopped is not None:
        return False
    if kind == "none":
        return True
    if kind == "double":
        return (bound.second_sigma or 0.0) >= NAMED_SIGMA and bool(bound.second_material)
    shows = bound.fault_sigma is None or bound.fault_sigma >= NAMED_SIGMA
    if kind == "unknown":
        return material(outcome) and shows and (bound.undescribed_sigma or 0.0) >= NAMED_SIGMA
    return material(outcome) and shows


def find_named_effects(outcome: TrialOutcome) -> frozenset[str]:
    """The most probable explanation: one effect or two."""
    if outcome.verdict not in NAMED or outcome.first is None:
        return frozenset()
    pair = max(outcome.pairs, key=lambda pair: pair[1], default=((), 0.0))
    return frozenset(pair[0]) if pair[1] > outcome.effects[0].probability else frozenset({outcome.first})


def right(outcome: TrialOutcome) -> bool:
    """Whether the answer is right, counted or not.

    None: no gap, and nothing that matters beside. One fault: its name and no other, or a declared tie that holds it; one that is read off
    the recording stands beside the verdict, which names nothing; where it is immaterial, the same as none. Unknown: "unknown"; where it is
    immaterial, the same as none. Two: exactly those; where the weaker one does not count, either of them.
    """
    kind, ids = outcome.sealed.kind, set(outcome.sealed.ids)
    if outcome.stopped is not None:
        return False
    if outcome.verdict == NO_GAP and not outcome.also and not material(outcome):
        return True
    if is_beside(outcome):
        return stands_beside(outcome) and set(outcome.also) == ids
    if kind == "unknown":
        return outcome.verdict == UNKNOWN
    if kind == "double" and counts(outcome):
        return exact_pair(outcome)
    tied = outcome.tied if outcome.verdict in NAMED else frozenset()
    named = find_named_effects(outcome)
    return (bool(named) and named <= ids) or bool((tied | set(outcome.also)) & ids)


def names_truth_alone(outcome: TrialOutcome) -> bool:
    """Whether the verdict names what was planted and nothing else, ties or not: `unknown` with the right name in the list is not right,
    nor is a pair with a wrong second."""
    return right(outcome) if is_beside(outcome) else find_named_effects(outcome) == set(outcome.sealed.ids)


def tells_truth_outright(outcome: TrialOutcome) -> bool:
    """Whether the planted name, and no other, is told without reserve: a first name of `ambiguous` is not, nor is what is read off the
    recording beside a verdict other than `no_gap`."""
    return names_truth_alone(outcome) and outcome.verdict == (NO_GAP if is_beside(outcome) else EXPLAINED)


def gives_right_verdict(outcome: TrialOutcome) -> bool:
    """Whether the verdict is of the right kind, whatever it names: no gap, a name, or unknown."""
    if outcome.sealed.kind == "none" or is_beside(outcome) or not material(outcome):
        return outcome.verdict == NO_GAP
    return outcome.verdict == UNKNOWN if outcome.sealed.kind == "unknown" else outcome.verdict in NAMED


def is_beside(outcome: TrialOutcome) -> bool:
    """Whether all that was planted is read off the recording directly: then the verdict, which is about the wrench, is to name nothing."""
    return bool(outcome.sealed.ids) and set(outcome.sealed.ids) <= SEEN_BESIDE


def stands_beside(outcome: TrialOutcome) -> bool:
    """What was planted stands beside the verdict with its parameters, and the verdict names nothing."""
    return not find_named_effects(outcome) and all(outcome.also.get(name) for name in outcome.sealed.ids)


def exact_pair(outcome: TrialOutcome) -> bool:
    """Both names and no other, each where it belongs: in the verdict, or beside it."""
    ids = set(outcome.sealed.ids)
    return find_named_effects(outcome) == ids - SEEN_BESIDE and ids & SEEN_BESIDE <= set(outcome.also)


def mark(outcome: TrialOutcome) -> Message:
    """In words."""
    if counts(outcome) or outcome.stopped is not None:
        return Message.of("trial-right") if right(outcome) else Message.of("trial-not-right")
    return Message.of("trial-right-does-not-count") if right(outcome) else Message.of("trial-not-right-does-not-count")


def truth_class(outcome: TrialOutcome) -> str:
    """What the probabilities are about, which is the wrench: none, unknown, an effect, or two joined by a plus sign; the verdict is about
    what matters."""
    kind, ids = outcome.sealed.kind, [name for name in outcome.sealed.ids if name not in SEEN_BESIDE]
    if kind == "none" or not ids or not material(outcome):
        return "none"
    if kind != "double" or outcome.bound.second_material is None or outcome.bound.second_material:
        return "+".join(sorted(ids))
    return max(ids, key=lambda name: next((e.closure for e in outcome.effects if e.id == name), 0.0))


def forecast(outcome: TrialOutcome) -> dict[str, float]:
    """Probability of every class that the answer gives one to."""
    singles = {effect.id: effect.probability for effect in outcome.effects}
    pairs = {"+".join(sorted(ids)): probability for ids, probability in outcome.pairs}
    return {"none": outcome.none_probability, "unknown": outcome.unknown_probability, **singles, **pairs}
