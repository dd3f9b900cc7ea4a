"""What is kept of a diagnosis, one line of JSON each."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict


class Weighed(BaseModel):
    """What a fit was weighed by.

    Attributes:
        name: identifiers joined by plus signs; `none` for the nominal twin.
        effects, free, rows: how many effects, free parameters, and equations.
        chi_square: on unseen motions.
    """

    model_config = ConfigDict(frozen=True)

    name: str
    effects: int
    free: int
    rows: int
    chi_square: float

    @property
    def further(self) -> int:
        """Effects beyond the first."""
        return max(0, self.effects - 1)


class Answer(BaseModel):
    """A diagnosis in short.

    Attributes:
        case: its recording's folder.
        verdict: in one word.
        summary: in a sentence.
        gap: before and after, in multiples of the noise; None where there was too little to compare.
        none, unknown: probabilities.
        effects, pairs: probability and closure of each, the most probable first.
        also: what was read off beside the wrench, and whether it is material.
        minor: what was detected and is not material.
        tied: what could not be told apart.
        weighed: the nominal twin, then each fit; none where nothing could be fitted.
        payload_off: the payload less the recording's reference, in standard uncertainties, of each parameter that is determined; none
            without a reference or an answer.
        cpu: s.
    """

    model_config = ConfigDict(frozen=True)

    case: str
    verdict: str
    summary: str
    gap: tuple[float, float] | None
    none: float
    unknown: float
    effects: tuple[tuple[str, float, float], ...]
    pairs: tuple[tuple[tuple[str, ...], float, float], ...]
    also: tuple[tuple[str, bool], ...]
    minor: tuple[str, ...]
    tied: tuple[tuple[str, ...], ...]
    weighed: tuple[Weighed, ...] = ()
    payload_off: tuple[float, ...] = ()
    cpu: float

    @property
    def named(self) -> str:
        """What the verdict stands for: the most probable effect, several joined by plus signs, or the verdict itself."""
        if self.verdict not in ("explained", "ambiguous"):
            return self.verdict
        likely = [(probability, name) for name, probability, _ in self.effects]
        likely += [(probability, "+".join(sorted(names))) for names, probability, _ in self.pairs]
        return max(likely, key=lambda each: each[0])[1] if likely else self.verdict
