"""The evidence put into the form that leaves the engine, together with what is read off the recording directly."""

from __future__ import annotations

from core.gap.answer import Cell, Change, Diagnosis, Explanation, GapPart, Minor, Pair, Payload, PayloadPart, Tied, Value, Verdict, Where
from core.gap.attribution import LAPSE, Tie
from core.gap.closure import closure_of, gap_of
from core.gap.effect_fit import EffectFit
from core.gap.evidence import EXPLAINED, Evidence
from core.gap.joint_side import joint_side
from core.gap.materiality import payload_shift
from core.gap.proposal import Proposal
from core.gap.residual import CHANNELS, Residual
from core.gap.symptoms import Observed, observed
from core.gap.windows import OFFSET, Windows
from core.recording import Recording
from core.remark import Remark

SEEN = 1.0 - LAPSE
"""Probability of what is plain in the recording itself."""
UNKNOWN_CONSEQUENCE = "What it does to the payload cannot be told as long as its cause is not known: use these numbers with care."
READ_OFF_CONSEQUENCE = "It is read off the recording itself; the wrench that the payload asks of the sensor is not changed by it."


def answer(recording: Recording, evidence: Evidence) -> Diagnosis:
    """The evidence, and what is plain in the recording itself."""
    seen = observed(recording, evidence.windows, evidence.nominal, evidence.best)
    told = [it for it in seen if it.finding.material and concerns(it, evidence)]
    fitted = _fitted(recording, evidence)
    if evidence.verdict in ("no_gap", "unknown"):
        answered = _read_off(fitted, told) if told else fitted
    else:
        answered = _beside(fitted, evidence, told[0]) if told and len(evidence.best.effects) == 1 else fitted
    return answered.model_copy(update={"minor": [*answered.minor, *(_noted(it) for it in seen if it.symptom.id not in _names(answered))]})


def concerns(it: Observed, evidence: Evidence) -> bool:
    """Whether a symptom is an answer, or stands among the minor findings.

    A gap in the wrench that nothing explains may come from samples that were lost, but not from the joints' friction, a wrong reference
    or noise, which is its consequence. Where an effect explains it, the estimated payload hangs on that effect, and is no proof against
    the reference; nor is what looks like the effect itself.
    """
    if evidence.verdict == "unknown":
        return it.symptom.disturbs
    if evidence.verdict == "no_gap":
        return True
    return it.symptom.stage != "payload" and not set(it.symptom.resembled_by) & {effect.id for effect in evidence.best.effects}


def _names(diagnosis: Diagnosis) -> set[str]:
    return {effect.id for effect in diagnosis.effects}


def _fitted(recording: Recording, evidence: Evidence) -> Diagnosis:
    """What the wrench alone says."""
    windows, nominal, best = evidence.windows, evidence.nominal, evidence.best
    attribution, material, verdict = evidence.attribution, evidence.material, evidence.verdict
    explained = attribution.explained if material else ()
    return Diagnosis(
        verdict=verdict,
        summary=_summary(verdict, evidence),
        effects=[_explanation(windows, nominal, fit, p) for fit, p in explained if len(fit.effects) == 1],
        none_probability=attribution.none if material else 1.0 - LAPSE,
        unknown_probability=attribution.unknown if material else LAPSE,
        pairs=[_pair(windows, nominal, fit, p) for fit, p in explained if len(fit.effects) == 2],
        minor=[] if material else _minor(evidence),
        indistinguishable=[_tied(tie, evidence.proposals) for tie in attribution.ties] if material else [],
        where=_where(recording, Residual(windows, nominal), best),
        gap=_gap(evidence),
        payload=PayloadPart(before=_payload(nominal), after=_payload(best)),
        consequence=payload_shift(nominal, best) if verdict != "unknown" else UNKNOWN_CONSEQUENCE,
        next_experiment=evidence.proposals[0].answer if evidence.proposals else None,
        limits=list(evidence.limits),
        seconds=0.0,
    )


def _read_off(fitted: Diagnosis, told: list[Observed]) -> Diagnosis:
    """The answer where no effect on the wrench is the cause, but something is plain in the recording itself."""
    before = 1.0 if fitted.gap is None else fitted.gap.before
    names = [it.symptom.id for it in told]
    alone = len(told) == 1
    single, rest = (SEEN, 1.0 - SEEN) if alone else ((1.0 - SEEN) / len(told), 0.0)
    return fitted.model_copy(
        update={
            "verdict": "explained",
            "summary": " ".join(it.finding.sentence for it in told),
            "effects": [_told(it, single, before) for it in told],
            "pairs": [] if alone else [Pair(ids=(names[0], names[1]), probability=SEEN, gap_after=before, closure=0.0)],
            "none_probability": 0.5 * rest,
            "unknown_probability": 0.5 * rest,
            "indistinguishable": [],
            "gap": None if fitted.gap is None else _as_before(fitted.gap),
            "where": None if fitted.where is None else fitted.where.model_copy(update={"stage": told[0].symptom.stage}),
            "payload": None if fitted.payload is None else fitted.payload.model_copy(update={"after": fitted.payload.before}),
            "consequence": READ_OFF_CONSEQUENCE,
        }
    )


def _as_before(gap: GapPart) -> GapPart:
    """The wrench's gap is not what the symptom is about: it stays."""
    channels = {name: Change(before=change.before, after=change.before) for name, change in gap.by_channel.items()}
    return gap.model_copy(update={"after": gap.before, "by_channel": channels})


def _beside(fitted: Diagnosis, evidence: Evidence, it: Observed) -> Diagnosis:
    """An effect on the wrench explains the gap, and something else is plain in the recording: most probably both at once."""
    first = fitted.effects[0]
    both = Pair(
        ids=(first.id, it.symptom.id), probability=SEEN * first.probability, gap_after=first.gap_after, closure=first.closure,
        parameters={first.id: first.parameters, it.symptom.id: it.parameters},
    )  # fmt: skip
    alone = first.model_copy(update={"probability": (1.0 - SEEN) * first.probability})
    return fitted.model_copy(
        update={
            "summary": f"{_summary(evidence.verdict, evidence)} Besides: {it.finding.sentence}",
            "effects": [alone, *fitted.effects[1:], _told(it, 0.0, first.gap_after)],
            "pairs": [both, *fitted.pairs],
        }
    )


def _told(it: Observed, probability: float, gap: float) -> Explanation:
    return Explanation(
        id=it.symptom.id,
        title=it.symptom.title,
        stage=it.symptom.stage,
        probability=probability,
        parameters=it.parameters,
        gap_after=gap,
        closure=0.0,
        closure_interval=(0.0, 0.0),
        advice=it.symptom.advice(it.finding),
    )


def _noted(it: Observed) -> Minor:
    return Minor(id=it.symptom.id, parameters=it.parameters, sentence=it.finding.sentence)


def _gap(evidence: Evidence) -> GapPart:
    windows, nominal, after = evidence.windows, evidence.nominal, evidence.best
    return GapPart(
        before=gap_of(windows, nominal),
        after=gap_of(windows, after),
        held_out=sorted({part.phase for part in windows.basis.segments}),
        by_channel={name: Change(before=gap_of(windows, nominal, c), after=gap_of(windows, after, c)) for c, name in enumerate(CHANNELS)},
    )


def _summary(verdict: Verdict, evidence: Evidence) -> str:
    titles = " and ".join(effect.title for effect in evidence.best.effects)
    return {
        "no_gap": "Simulation and recording agree as far as it matters.",
        "explained": f"The gap is explained by {titles}.",
        "ambiguous": f"The gap may be explained by {titles}, but this recording does not settle it.",
        "unknown": "There is a gap that no effect of the library explains.",
        "not_enough": "",
    }[verdict]


def _values(fit: EffectFit) -> dict[str, Value]:
    return {
        p.name: Value(value=float(v), std=float(s), unit=p.unit, at_bound=bool(v <= p.lower or v >= p.upper))
        for p, v, s in zip(fit.parameters, fit.theta, fit.theta_std, strict=True)
    }


def _explanation(windows: Windows, nominal: EffectFit, fit: EffectFit, probability: float) -> Explanation:
    effect = fit.effects[0]
    closure, interval = closure_of(windows, nominal, fit)
    return Explanation(
        id=effect.id,
        title=effect.title,
        stage=effect.stage,
        probability=probability,
        parameters=_values(fit),
        gap_after=gap_of(windows, fit),
        closure=closure,
        closure_interval=interval,
        advice=effect.advice(windows.basis.scene.carrying(fit.phi), fit.theta),
    )


def _pair(windows: Windows, nominal: EffectFit, fit: EffectFit, probability: float) -> Pair:
    a, b = fit.effects
    values = list(_values(fit).items())
    count = len(a.parameters(windows.basis.scene))
    return Pair(
        ids=(a.id, b.id),
        probability=probability,
        gap_after=gap_of(windows, fit),
        closure=closure_of(windows, nominal, fit)[0],
        parameters={a.id: dict(values[:count]), b.id: dict(values[count:])},
    )


def _minor(evidence: Evidence) -> list[Minor]:
    """What is there, but too small to matter; it has a name only where one is probable."""
    best = evidence.best
    if not best.effects or evidence.attribution.explained[0][1] < EXPLAINED:
        return []
    return [Minor(id=best.name, parameters=_values(best), sentence="detected, but too small to matter")]


def _tied(tie: Tie, proposals: tuple[Proposal, ...]) -> Tied:
    splitting = [it.motion.sentence for it in proposals if tie in it.ties]
    return Tied(
        ids=(tie.first.name, tie.second.name),
        distance_sigma=tie.distance_sigma,
        why=(
            "with other payload parameters and offsets both predict this recording; "
            f"they differ by {tie.distance_sigma:.1f} standard deviations"
        ),
        splits=splitting[0] if splitting else "none of the motions at hand by itself",
    )


def _where(recording: Recording, residual: Residual, best: EffectFit) -> Where:
    """The stage is that of the effect which closes most of the gap, be it the cause or only like it."""
    top = residual.patches[0]
    return Where(
        cells=[Cell(**vars(patch)) for patch in residual.patches],
        channel=top.channel,
        phase=top.phase,
        stage=best.effects[0].stage if best.effects else "sensor",
        by_time=residual.by_time(),
        by_direction=residual.by_direction(),
        by_pose=residual.by_pose(),
        joints=joint_side(recording, best.beta[OFFSET]),
        sentence=residual.sentence(),
    )


def _payload(fit: EffectFit) -> Payload:
    return Payload(phi=fit.phi.tolist(), std=fit.phi_std.tolist())


def not_enough(reason: Remark, seconds: float) -> Diagnosis:
    """The answer to a recording that cannot say anything about a gap."""
    return Diagnosis(
        verdict="not_enough",
        summary=f"Nothing can be said about the gap: {reason.sentence}.",
        effects=[],
        none_probability=0.0,
        unknown_probability=0.0,
        pairs=[],
        minor=[],
        indistinguishable=[],
        where=None,
        gap=None,
        payload=None,
        consequence="",
        next_experiment=None,
        limits=[],
        lacking=reason,
        seconds=seconds,
    )
