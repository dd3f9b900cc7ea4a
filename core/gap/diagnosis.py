"""The diagnosis of one recording: where the gap lies, which effect causes it, how far it shrinks once that effect is added."""

from __future__ import annotations

import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from itertools import combinations
from multiprocessing import get_context

import numpy as np
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

from core.effects.effect import Effect
from core.effects.library import library
from core.gap.answer import (
    Cell,
    Change,
    Diagnosis,
    Explanation,
    GapPart,
    Minor,
    Pair,
    Payload,
    PayloadPart,
    Tied,
    Value,
    Verdict,
    Where,
)
from core.gap.attribution import Attribution, attribute, leftover
from core.gap.basis import TooLittleError, basis_of
from core.gap.effect_fit import STAGES, EffectFit, fit_effects, fit_nominal
from core.gap.materiality import is_material, payload_shift
from core.gap.residual import CHANNELS, Residual
from core.gap.symptoms import Observed, observed
from core.gap.windows import Windows
from core.recording import Recording

Array = NDArray[np.float64]

PAIRED = 4
"""How many of the best single effects are tried in pairs."""
EXPLAINED = 0.5
"""Probability from which one name is given."""
ONE_IS_ENOUGH = 0.01
"""Share of the excess left over by one effect below which a second one is not sought: it would only pick up what a model gets wrong."""
SECOND_EXPLAINS = 1.0 / 3.0
"""A second effect has to explain most of what the first leaves over, or it is none."""
UNKNOWN_CONSEQUENCE = "What it does to the payload cannot be told as long as its cause is not known: use these numbers with care."
RESAMPLED = 300


@dataclass(frozen=True)
class Evidence:
    """Everything that was fitted to one recording."""

    windows: Windows
    nominal: EffectFit
    singles: tuple[EffectFit, ...]
    pairs: tuple[EffectFit, ...]
    attribution: Attribution
    limits: tuple[str, ...]

    @property
    def best(self) -> EffectFit:
        """The most probable explanation, the nominal twin where there is none."""
        explained = self.attribution.explained
        return explained[0][0] if explained else self.nominal


def diagnose(recording: Recording, effects: Sequence[Effect] | None = None) -> Diagnosis:
    """Answers the three questions for one recording, which is only read.

    Args:
        recording: with a wrist wrench and motion; anything less is answered with what is missing.
        effects: candidates; the whole library where absent.
    """
    return examine(recording, effects)[0]


def examine(recording: Recording, effects: Sequence[Effect] | None = None) -> tuple[Diagnosis, Evidence | None]:
    """The diagnosis together with everything that was fitted; None where the recording is not enough."""
    began = time.perf_counter()
    try:
        windows = Windows(basis_of(recording))
    except TooLittleError as reason:
        return not_enough(str(reason), time.perf_counter() - began), None
    evidence = gather(windows, library() if effects is None else effects)
    return answer(recording, evidence, began), evidence


def gather(windows: Windows, effects: Sequence[Effect]) -> Evidence:
    """Fits all effects singly, and the best in pairs, on all cores."""
    nominal = fit_nominal(windows)
    scene = windows.basis.scene.carrying(nominal.phi)
    missing = {effect.id: reason for effect in effects if (reason := effect.missing(scene)) is not None}
    residual = _on_grid(windows, nominal)
    singly = [((effect,), nominal, effect.starts(scene, residual)) for effect in effects if effect.id not in missing]
    with ProcessPoolExecutor(mp_context=get_context("fork"), initializer=_share, initargs=(windows,)) as pool:
        singles = list(pool.map(_fit, singly))
        best = sorted(singles, key=lambda fit: float(fit.held_out.sum()))[:PAIRED]
        if not best or leftover(nominal, best[0]) < ONE_IS_ENOUGH:
            best = []
        together = [((*a.effects, *b.effects), min(a, b, key=lambda fit: fit.cost), [_joined(a, b)]) for a, b in combinations(best, 2)]
        pairs = [pair for pair in pool.map(_fit, together) if leftover(nominal, pair) < SECOND_EXPLAINS * leftover(nominal, best[0])]
    limits = tuple(f"{name}: {reason}" for name, reason in missing.items())
    return Evidence(windows, nominal, tuple(singles), tuple(pairs), attribute(windows, nominal, [*singles, *pairs]), limits)


_shared: Windows
"""The windows in a worker process: inherited, never sent."""


def _share(windows: Windows) -> None:
    global _shared  # noqa: PLW0603  set once for each worker
    _shared = windows
    threadpool_limits(1)


def _fit(task: tuple[tuple[Effect, ...], EffectFit, list[Array]]) -> EffectFit:
    effects, start, thetas = task
    return fit_effects(_shared, effects, start, thetas)


def _on_grid(windows: Windows, fit: EffectFit) -> Array:
    """(N, 6), residual in standard deviations of the windows' noise, on the scene's grid."""
    scene, centres = windows.basis.scene, windows.centres
    return np.column_stack([np.interp(scene.t, centres, channel) for channel in fit.residual])


def _joined(a: EffectFit, b: EffectFit) -> Array:
    """Parameters of two fits in the order in which their effects act."""
    fits = sorted((a, b), key=lambda fit: STAGES.index(fit.effects[0].stage))
    return np.concatenate([fit.theta for fit in fits])


def answer(recording: Recording, evidence: Evidence, began: float) -> Diagnosis:
    """The evidence in the form that leaves the engine."""
    windows, nominal, best = evidence.windows, evidence.nominal, evidence.best
    attribution = evidence.attribution
    material = is_material(windows, nominal, best)
    seen = observed(recording, windows, best)
    verdict = _verdict(evidence, material)
    told = [it for it in seen if it.finding.material] if verdict in ("no_gap", "unknown") else []
    before = gap_of(windows, nominal)
    if told:
        return _read_off(evidence, told, seen, before, began)
    residual = Residual(windows, nominal)
    ranked = [(fit, p) for fit, p in attribution.explained if len(fit.effects) == 1]
    return Diagnosis(
        verdict=verdict,
        summary=_summary(verdict, evidence),
        effects=[_explanation(windows, nominal, fit, p) for fit, p in ranked] if material else [],
        none_probability=attribution.none if material else 1.0,
        unknown_probability=attribution.unknown if material else 0.0,
        pairs=[_pair(windows, nominal, fit, p) for fit, p in attribution.explained if len(fit.effects) == 2] if material else [],
        minor=[*([] if material else _minor(best)), *(_noted(it) for it in seen)],
        indistinguishable=[_tied(tie.first, tie.second, tie.distance_sigma) for tie in attribution.ties] if material else [],
        where=_where(residual, best, verdict),
        gap=_gap(evidence, best),
        payload=PayloadPart(before=_payload(nominal), after=_payload(best)),
        consequence=payload_shift(nominal, best) if verdict != "unknown" else UNKNOWN_CONSEQUENCE,
        next_experiment=None,
        limits=list(evidence.limits),
        seconds=time.perf_counter() - began,
    )


def _read_off(evidence: Evidence, told: list[Observed], seen: list[Observed], before: float, began: float) -> Diagnosis:
    """The answer where the wrench agrees, or no effect on it explains the gap, but something is plain in the recording itself."""
    windows, nominal = evidence.windows, evidence.nominal
    share = 0.95 / len(told)
    explanations = [
        Explanation(
            id=it.symptom.id,
            title=it.symptom.title,
            stage=it.symptom.stage,
            probability=share,
            parameters=it.parameters,
            gap_after=before,
            closure=0.0,
            closure_interval=(0.0, 0.0),
            advice=it.symptom.advice(it.finding),
        )
        for it in told
    ]
    residual = Residual(windows, nominal)
    return Diagnosis(
        verdict="explained" if len(told) == 1 else "ambiguous",
        summary=" ".join(it.finding.sentence for it in told),
        effects=explanations,
        none_probability=0.03,
        unknown_probability=0.02,
        pairs=[],
        minor=[_noted(it) for it in seen if it not in told],
        indistinguishable=[],
        where=_where(residual, nominal, "unknown").model_copy(update={"stage": told[0].symptom.stage}),
        gap=_gap(evidence, nominal),
        payload=PayloadPart(before=_payload(nominal), after=_payload(nominal)),
        consequence="It is read off the recording itself; the wrench that the payload asks of the sensor is not changed by it.",
        next_experiment=None,
        limits=list(evidence.limits),
        seconds=time.perf_counter() - began,
    )


def _noted(it: Observed) -> Minor:
    return Minor(id=it.symptom.id, parameters=it.parameters, sentence=it.finding.sentence)


def _gap(evidence: Evidence, after: EffectFit) -> GapPart:
    windows, nominal = evidence.windows, evidence.nominal
    return GapPart(
        before=gap_of(windows, nominal),
        after=gap_of(windows, after),
        held_out=sorted({part.phase for part in windows.basis.segments}),
        by_channel={name: Change(before=gap_of(windows, nominal, c), after=gap_of(windows, after, c)) for c, name in enumerate(CHANNELS)},
    )


def gap_of(windows: Windows, fit: EffectFit, channel: int | None = None) -> float:
    """Root mean square over samples of (measured - simulated) over noise, each motion predicted from the others."""
    rows = fit.held_out if channel is None else fit.held_out[channel]
    return float(np.sqrt(max(0.0, 1.0 + (float(rows.mean()) - 1.0) / windows.samples_per_row)))


def closure_of(windows: Windows, nominal: EffectFit, fit: EffectFit) -> tuple[float, tuple[float, float]]:
    """(before - after) / (before - floor) with its 95 % interval, motions resampled."""
    rng = np.random.default_rng(0)
    groups = np.unique(windows.group)
    sums = np.array([[f.held_out[:, windows.group == g].sum() for f in (nominal, fit)] for g in groups])
    counts = np.array([6 * np.count_nonzero(windows.group == g) for g in groups])
    drawn = rng.integers(len(groups), size=(RESAMPLED, len(groups)))
    values = [_closure(sums[rows].sum(axis=0) / counts[rows].sum(), windows.samples_per_row) for rows in drawn]
    low, high = np.percentile(values, [2.5, 97.5])
    return _closure(sums.sum(axis=0) / counts.sum(), windows.samples_per_row), (float(low), float(high))


def _closure(rows: Array, samples_per_row: float) -> float:
    before, after = np.sqrt(np.maximum(0.0, 1.0 + (rows - 1.0) / samples_per_row))
    return float(np.clip((before - after) / (before - 1.0), -10.0, 10.0)) if before > 1.0 + 1e-9 else 0.0


def _verdict(evidence: Evidence, material: bool) -> Verdict:
    attribution = evidence.attribution
    if not material:
        return "no_gap"
    if attribution.unknown > EXPLAINED or not attribution.explained:
        return "unknown"
    if attribution.ties or attribution.explained[0][1] < EXPLAINED:
        return "ambiguous"
    return "explained"


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
    return Pair(ids=(a.id, b.id), probability=probability, gap_after=gap_of(windows, fit), closure=closure_of(windows, nominal, fit)[0])


def _minor(best: EffectFit) -> list[Minor]:
    return [Minor(id=best.name, parameters=_values(best), sentence="detected, but too small to matter")] if best.effects else []


def _tied(a: EffectFit, b: EffectFit, distance: float) -> Tied:
    return Tied(
        ids=(a.name, b.name),
        distance_sigma=distance,
        why=f"with other payload parameters and offsets both predict this recording; they differ by {distance:.1f} standard deviations",
        splits="a rotation about a horizontal axis, in which gravity sweeps through the sensor",
    )


def _where(residual: Residual, best: EffectFit, verdict: Verdict) -> Where:
    top = residual.patches[0]
    stage = best.effects[0].stage if best.effects and verdict in ("explained", "ambiguous") else "sensor"
    return Where(
        cells=[Cell(**vars(patch)) for patch in residual.patches],
        channel=top.channel,
        phase=top.phase,
        stage=stage,
        by_time=residual.by_time(),
        by_direction=residual.by_direction(),
        sentence=residual.sentence(),
    )


def _payload(fit: EffectFit) -> Payload:
    return Payload(phi=fit.phi.tolist(), std=fit.phi_std.tolist())


def not_enough(reason: str, seconds: float) -> Diagnosis:
    """The answer to a recording that cannot say anything about a gap."""
    return Diagnosis(
        verdict="not_enough",
        summary=f"Nothing can be said about the gap: {reason}.",
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
        limits=[reason],
        seconds=seconds,
    )
