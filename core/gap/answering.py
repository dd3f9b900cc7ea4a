"""The evidence put into the form that leaves the engine, and beside it what is read off the recording directly."""

from __future__ import annotations

from functools import reduce
from itertools import islice

from core.effects.effect import STAGE_NAMES
from core.gap.addable import split_parameter_rows, why_not_addable
from core.gap.answer import (
    Change,
    Diagnosis,
    Explanation,
    GapPart,
    Minor,
    Pair,
    PatchPart,
    PayloadPart,
    PhiPart,
    Tied,
    Triangle,
    Value,
    Verdict,
    Where,
)
from core.gap.closure import closure_of, gap_of
from core.gap.effect_fit import EffectFit
from core.gap.evidence import EXPLAINED, Evidence
from core.gap.joint_side import joint_side
from core.gap.materiality import payload_shift
from core.gap.payload_after import describe_payload_after, describe_phi
from core.gap.proposal import Proposal
from core.gap.residual import Residual
from core.gap.symptoms import find_leading, observe_symptoms
from core.gap.tie import Tie
from core.gap.weighing import read_figures
from core.gap.windows import OFFSET
from core.payload.channels import CHANNELS
from core.recording.recording import Recording
from core.words.message import Message

OPEN = 0.05
"""Probability from which an explanation of an open verdict is named."""


def answer(recording: Recording, evidence: Evidence) -> Diagnosis:
    """What the wrench says, and beside it what is plain in the recording itself; that explains no gap, and changes no verdict."""
    fitted = with_likely(_answer_from_wrench(recording, evidence))
    also = observe_symptoms(recording, evidence.windows, evidence.nominal, evidence.best, evidence.named)
    summary = reduce(lambda said, more: Message.of("gap-summary-and", said=said, more=more), find_leading(also), fitted.summary)
    return fitted.model_copy(update={"also": also, "summary": summary})


def with_likely(diagnosis: Diagnosis) -> Diagnosis:
    """The diagnosis with the set of its answers that is to hold the truth in nine of ten cases."""
    singles = {effect.id: effect.probability for effect in diagnosis.effects}
    several = {"+".join(pair.ids): pair.probability for pair in diagnosis.pairs}
    told = {**singles, **several, "none": diagnosis.none_probability, "unknown": diagnosis.unknown_probability}
    first, *others = sorted(told, key=lambda name: -told[name])
    likely = [first, *(name for name in others if told[name] >= read_figures().left_out)]
    return diagnosis.model_copy(update={"likely": likely})


def _answer_from_wrench(recording: Recording, evidence: Evidence) -> Diagnosis:
    """What the wrench alone says."""
    windows, nominal, best = evidence.windows, evidence.nominal, evidence.best
    attribution, material, verdict = evidence.attribution, evidence.material, evidence.verdict
    explained = [(fit, evidence.mattering * p) for fit, p in attribution.explained] if material else []
    return Diagnosis(
        verdict=verdict,
        summary=_summarise(verdict, evidence),
        effects=[explain(evidence, fit, p) for fit, p in explained if len(fit.effects) == 1],
        none_probability=evidence.none,
        unknown_probability=evidence.mattering * attribution.unknown if material else 1.0 - evidence.none,
        pairs=[explain_both(evidence, fit, p) for fit, p in explained if len(fit.effects) > 1],
        minor=[] if material else _minor(evidence),
        indistinguishable=[_describe_tie(tie, evidence.proposals) for tie in attribution.ties] if material else [],
        where=_where(recording, Residual(windows, nominal), best, verdict),
        gap=describe_gap(evidence),
        payload=PayloadPart(before=describe_payload(nominal), after=describe_payload_after(evidence)),
        consequence=payload_shift(nominal, best) if verdict != "unknown" else Message.of("gap-payload-in-doubt"),
        next_experiment=evidence.proposals[0].answer if evidence.proposals else None,
        limits=list(evidence.limits),
        seconds=0.0,
    )


def describe_gap(evidence: Evidence) -> GapPart:
    """Before, and after the best explanation."""
    windows, nominal, after = evidence.windows, evidence.nominal, evidence.best
    return GapPart(
        before=gap_of(windows, nominal),
        after=gap_of(windows, after),
        held_out=sorted({part.phase for part in windows.basis.segments}),
        by_channel={name: Change(before=gap_of(windows, nominal, c), after=gap_of(windows, after, c)) for c, name in enumerate(CHANNELS)},
    )


def _summarise(verdict: Verdict, evidence: Evidence) -> Message:
    match verdict:
        case "explained":
            best = evidence.attribution.explained[0][0]
            return Message.of("gap-explained", effects=_name(best), stages=_name_stages([best]))
        case "ambiguous":
            fits = _find_open(evidence)
            effects = reduce(lambda first, second: Message.of("effect-or", first=first, second=second), map(_name, fits))
            return Message.of("gap-ambiguous", effects=effects, stages=_name_stages(fits))
        case "unknown":
            return Message.of("gap-unknown")
        case _:
            return Message.of("gap-none")


def _name(fit: EffectFit) -> Message:
    """What it adds: one effect, or several."""
    return reduce(lambda first, second: Message.of("effect-and", first=first, second=second), [effect.title for effect in fit.effects])


def _name_stages(fits: list[EffectFit]) -> list[Message]:
    """Each once."""
    return [STAGE_NAMES[stage] for stage in dict.fromkeys(effect.stage for fit in fits for effect in fit.effects)]


def _find_open(evidence: Evidence) -> list[EffectFit]:
    """The most probable explanation, and whatever else is probable or cannot be told from it."""
    attribution = evidence.attribution
    best = attribution.explained[0][0]
    tied = {fit.name for tie in attribution.ties if best.name in (tie.first.name, tie.second.name) for fit in (tie.first, tie.second)}
    return [fit for k, (fit, p) in enumerate(attribution.explained) if k == 0 or p >= OPEN or fit.name in tied]


def describe_values(fit: EffectFit) -> dict[str, Value]:
    """Fitted parameters by name."""
    return {
        p.name: Value(value=float(v), std=float(s), unit=p.unit, at_bound=bool(v <= p.lower or v >= p.upper))
        for p, v, s in zip(fit.parameters, fit.theta, fit.theta_std, strict=True)
        if p.shown
    }


def explain(evidence: Evidence, fit: EffectFit, probability: float) -> Explanation:
    """One effect with what it would do to the gap."""
    windows, nominal, effect = evidence.windows, evidence.nominal, fit.effects[0]
    against = why_not_addable(evidence, fit)
    closure, interval = closure_of(windows, nominal, fit)
    return Explanation(
        id=effect.id,
        title=effect.title,
        stage=effect.stage,
        probability=probability,
        parameters=describe_values(fit),
        gap_after=gap_of(windows, fit),
        closure=closure,
        closure_interval=interval,
        advice=effect.advice(windows.basis.scene.with_phi(fit.phi), fit.theta),
        addable=against is None,
        why_not=against,
        covariance=_covariances(evidence, fit)[effect.id] if against is None else [],
    )


def explain_both(evidence: Evidence, fit: EffectFit, probability: float) -> Pair:
    """The same of several effects at once."""
    windows, against = evidence.windows, why_not_addable(evidence, fit)
    values, scene = iter(describe_values(fit).items()), windows.basis.scene.with_phi(fit.phi)
    counts = [(effect, sum(p.shown for p in effect.parameters(windows.basis.scene))) for effect in fit.effects]
    return Pair(
        ids=tuple(effect.id for effect in fit.effects),
        probability=probability,
        gap_after=gap_of(windows, fit),
        closure=closure_of(windows, evidence.nominal, fit)[0],
        parameters={effect.id: dict(islice(values, count)) for effect, count in counts},
        advice={effect.id: effect.advice(scene, fit.theta[rows]) for effect, rows in split_parameter_rows(evidence, fit)},
        addable=against is None,
        why_not=against,
        covariance=_covariances(evidence, fit) if against is None else {},
    )


def _covariances(evidence: Evidence, fit: EffectFit) -> dict[str, Triangle]:
    """Of the parameters of each effect, with what the model gets wrong."""
    whole = fit.uncertainty[len(fit.beta) :, len(fit.beta) :]
    symmetric = 0.5 * (whole + whole.T)
    parts = {effect.id: symmetric[rows, rows].tolist() for effect, rows in split_parameter_rows(evidence, fit)}
    return {name: [row[: k + 1] for k, row in enumerate(part)] for name, part in parts.items()}


def _minor(evidence: Evidence) -> list[Minor]:
    """What is there, but too small to matter; it has a name only where one is probable."""
    best = evidence.best
    if not best.effects or evidence.attribution.explained[0][1] < EXPLAINED:
        return []
    return [Minor(id=best.name, parameters=describe_values(best), message=Message.of("gap-minor"))]


def _describe_tie(tie: Tie, proposals: tuple[Proposal, ...]) -> Tied:
    splitting = [it.motion.sentence for it in proposals if tie in it.ties]
    return Tied(
        ids=(tie.first.name, tie.second.name),
        distance_sigma=tie.distance_sigma,
        why=Message.of("gap-tied", distance_sigma=tie.distance_sigma),
        splits=splitting[0] if splitting else Message.of("gap-no-motion-splits"),
    )


def _where(recording: Recording, residual: Residual, best: EffectFit, verdict: Verdict) -> Where:
    """The stage is that of the effect which explains the gap: one that the verdict rejects says nothing of it."""
    top, explains = residual.patches[0], bool(best.effects) and verdict in ("explained", "ambiguous")
    return Where(
        cells=[PatchPart(**vars(patch)) for patch in residual.patches],
        channel=top.channel,
        phase=top.phase,
        stage=best.effects[0].stage if explains else None,
        by_time=residual.by_time(),
        worst_s=residual.worst_stretch(),
        by_direction=residual.by_direction(),
        by_pose=residual.by_pose(),
        joints=joint_side(recording, best.beta[OFFSET]),
        message=residual.describe(),
    )


def describe_payload(fit: EffectFit) -> PhiPart:
    """What a fit makes of the payload."""
    return describe_phi(fit.phi, fit.phi_std)


def not_enough(reason: Message, seconds: float) -> Diagnosis:
    """The answer to a recording that cannot say anything about a gap."""
    return Diagnosis(
        verdict="not_enough",
        summary=Message.of("gap-nothing-to-say", reason=reason),
        effects=[],
        none_probability=0.0,
        unknown_probability=0.0,
        pairs=[],
        minor=[],
        indistinguishable=[],
        where=None,
        gap=None,
        payload=None,
        consequence=None,
        next_experiment=None,
        limits=[],
        lacking=reason,
        seconds=seconds,
    )
