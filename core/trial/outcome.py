"""One trial as it is kept: the truth, what the diagnosis said of it, and what any method could have said."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict

from core.array import Array
from core.gap.answer import Diagnosis, Explanation, PayloadPart, Value
from core.trial.bound import Bound
from core.trial.draw import Sealed
from core.trial.truth import Parameters
from core.version import code_version
from core.words.message import Message


class TrialPart(BaseModel):
    """Frozen, without NaN."""

    model_config = ConfigDict(frozen=True, allow_inf_nan=False)


class ParameterEstimate(TrialPart):
    """A parameter with its standard uncertainty; None where none is stated or the value sits on its bound."""

    value: float
    std: float | None


class Named(TrialPart):
    """One effect of the answer. Parameters are kept of the first name and of what was planted."""

    id: str
    probability: float
    closure: float
    parameters: dict[str, ParameterEstimate] = {}


class PayloadTruth(TrialPart):
    """Phi, ten values each: as it was, and as it was found before and after the effect was added, with standard uncertainties."""

    true: tuple[float, ...]
    before: tuple[float, ...]
    before_std: tuple[float, ...]
    after: tuple[float, ...]
    after_std: tuple[float, ...]


class TrialOutcome(TrialPart):
    """One trial.

    Args:
        stopped: why there is no answer: what the guard says, or an error.
        verdict: of the diagnosis; "stopped" where there is none.
        effects: most probable first; none where the verdict is `no_gap`.
        pairs: two effects at once, or three, with their probability.
        minor: identifiers that were detected in the wrench and called immaterial.
        also: what was seen elsewhere than in the wrench and called material, with its parameters.
        ties: pairs of identifiers with their distance in sigma.
        truth: parameters of what was planted by effect, in the effect's own words; where the shapes agree.
        payload: None where no payload was estimated.
        seconds: of the diagnosis, on one core.
        version: of the program.
        second: after the motion that the answer asked for; None where it asked for none.
    """

    sealed: Sealed
    stopped: Message | None
    verdict: str
    effects: tuple[Named, ...] = ()
    pairs: tuple[tuple[tuple[str, ...], float], ...] = ()
    none_probability: float = 0.0
    unknown_probability: float = 0.0
    minor: tuple[str, ...] = ()
    also: dict[str, dict[str, ParameterEstimate]] = {}
    ties: tuple[tuple[tuple[str, ...], float], ...] = ()
    gap_before: float | None = None
    gap_after: float | None = None
    truth: dict[str, Parameters] = {}
    payload: PayloadTruth | None = None
    bound: Bound = Bound()
    seconds: float = 0.0
    version: str = ""
    second: TrialOutcome | None = None

    @property
    def final(self) -> TrialOutcome:
        """The last answer."""
        return self.second or self

    @property
    def first(self) -> str | None:
        """The first name."""
        return self.effects[0].id if self.effects else None

    @property
    def tied(self) -> frozenset[str]:
        """Every name of a declared tie."""
        return frozenset(name for names, _ in self.ties for name in names)


def make_outcome(sealed: Sealed, diagnosis: Diagnosis, truth: dict[str, Parameters], payload: Array, bound: Bound) -> TrialOutcome:
    """The outcome of a trial that was diagnosed; `payload` (10,) is the true one."""
    kept = {*sealed.ids, *(effect.id for effect in diagnosis.effects[:1])}
    return TrialOutcome(
        sealed=sealed,
        stopped=None,
        verdict=diagnosis.verdict,
        effects=tuple(_summarise_effect(effect, kept) for effect in diagnosis.effects),
        pairs=tuple((pair.ids, pair.probability) for pair in diagnosis.pairs),
        none_probability=diagnosis.none_probability,
        unknown_probability=diagnosis.unknown_probability,
        minor=tuple(sorted({name for minor in diagnosis.minor for name in minor.id.split("+")})),
        also={also.id: _estimates(also.parameters) for also in diagnosis.also if also.material},
        ties=tuple((tie.ids, tie.distance_sigma) for tie in diagnosis.indistinguishable),
        gap_before=None if diagnosis.gap is None else diagnosis.gap.before,
        gap_after=None if diagnosis.gap is None else diagnosis.gap.after,
        truth=truth,
        payload=None if diagnosis.payload is None else _payload(diagnosis.payload, payload),
        bound=bound,
        seconds=diagnosis.seconds,
        version=code_version(),
    )


def make_stopped_outcome(sealed: Sealed, reason: Message) -> TrialOutcome:
    """The outcome of a trial that the guard stopped, or that failed."""
    return TrialOutcome(sealed=sealed, stopped=reason, verdict="stopped", version=code_version())


def _summarise_effect(effect: Explanation, kept: set[str]) -> Named:
    parameters = _estimates(effect.parameters) if effect.id in kept else {}
    return Named(id=effect.id, probability=effect.probability, closure=effect.closure, parameters=parameters)


def _estimates(parameters: dict[str, Value]) -> dict[str, ParameterEstimate]:
    return {name: ParameterEstimate(value=v.value, std=None if v.at_bound else v.std) for name, v in parameters.items()}


def _payload(found: PayloadPart, true: Array) -> PayloadTruth:
    before, after = found.before, found.after
    return PayloadTruth(
        true=tuple(true.tolist()),
        before=tuple(before.phi),
        before_std=tuple(before.std),
        after=tuple(after.phi),
        after_std=tuple(after.std),
    )
