"""The answer to a recording in which something touched the payload: the rest of it is diagnosed for itself."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import reduce
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from core.effects.effect import Effect
from core.effects.external_contact import ExternalContact
from core.gap.answer import ContactPart, Diagnosis, Explanation, Pair, PayloadPart, PhiPart, Value, Where
from core.gap.answering import OPEN, answer, describe_gap, describe_payload, describe_values, with_likely
from core.gap.attribution import Attribution, choose_variants, probabilities
from core.gap.closure import closure_of, gap_of
from core.gap.contacts import Contact, Contacts, find_contacts, find_free, keep_rows
from core.gap.effect_fit import EffectFit
from core.gap.evidence import EXPLAINED, Evidence, join
from core.gap.fit_all import FitAll
from core.gap.materiality import payload_shift
from core.gap.payload_after import describe_average
from core.gap.problem import Problem
from core.gap.singles import Singles, fit_again, fit_singly
from core.gap.symptoms import find_leading
from core.gap.weighing import find_doubts, find_left_share, read_figures
from core.gap.windows import Windows
from core.recording.recording import Recording
from core.words.message import Message

CONTACT = ExternalContact()
NOT_ADDABLE = Message.of("gap-contact-passes")
BESIDE = 6
"""Single effects beside which contacts are sought: as long as those bend its fit, the one that explains the rest is not among the best."""
UNITS = {"s": "s", "n": "N", "m": "m"}


@dataclass(frozen=True)
class Touched:
    """Contacts, and what was fitted to the rest of the recording.

    Args:
        rest: evidence of the rows that nothing touched.
        alone: the nominal twin fitted to the rest, on all rows: of those of the contacts as much is left as of the rest.
        beside: the same with each single effect that may explain the rest, and how probable it is there, the most probable first; none
            where nothing has to, or several effects do.
        probability: that this is why there is a gap.
        unknown: that nothing of the library is.
    """

    contacts: Contacts
    rest: Evidence
    alone: EffectFit
    beside: tuple[tuple[EffectFit, float], ...]
    probability: float
    unknown: float

    @property
    def best(self) -> EffectFit:
        """What explains the rest."""
        return self.beside[0][0] if self.beside else self.alone

    @property
    def each(self) -> list[tuple[EffectFit, float]]:
        """Each effect with the probability that it and the contacts are why there is a gap."""
        share = self.probability * (1.0 - self.rest.attribution.none) / max(1e-12, sum(p for _, p in self.beside))
        return [(fit, share * p) for fit, p in self.beside]


def find_touched(evidence: Evidence, effects: Sequence[Effect], fit_all: FitAll) -> Touched | None:
    """What contacts explain of a gap that no effect explains, by themselves or beside one of the best single effects; None where they
    explain too little of it."""
    windows, nominal = evidence.windows, evidence.nominal
    others = sorted((fit for fit in evidence.singles if fit.name != CONTACT.id), key=lambda fit: fit.chi_square)[:BESIDE]
    for found, fit in chain([(find_contacts(windows, nominal), nominal)], _find_beside(windows, nominal, others, fit_all)):
        touched = None if found is None else _diagnose_rest(evidence, found, fit, effects, fit_all)
        if touched is not None:
            return touched
    return None


def _find_beside(
    windows: Windows, nominal: EffectFit, fits: list[EffectFit], fit_all: FitAll
) -> Iterator[tuple[Contacts | None, EffectFit]]:
    """Contacts beside each effect that explains the rest, and its fit, what explains most first. Its fit to all rows is bent by them, so it
    is fitted again to those that this one does not miss by far."""
    again = [found for fit in fits if (found := _fit_to_free(windows, fit, fit_all)) is not None]
    for fit, free in sorted(again, key=lambda found: find_left_share(nominal, found[0])):
        if _doubt(nominal, fit)[1] >= EXPLAINED:
            yield find_contacts(windows, _carry_over(windows, fit, free)), fit


def _fit_to_free(windows: Windows, fit: EffectFit, fit_all: FitAll) -> tuple[EffectFit, NDArray[np.bool_]] | None:
    """An effect on the rows (K,) that most agree on beside it; None where these are all, or too few."""
    free = find_free(windows, fit)
    if free is None or free.all():
        return None
    rest = keep_rows(windows, free)
    if rest.X.shape[2] != windows.X.shape[2]:
        return None
    (again,) = fit_all(rest, [fit_again(fit, fit)])
    return again, free


def _diagnose_rest(evidence: Evidence, contacts: Contacts, fit: EffectFit, effects: Sequence[Effect], fit_all: FitAll) -> Touched | None:
    """The diagnosis of what contacts leave free, with the fit beside which they were found once more; None where that does not make an
    answer of them."""
    windows, nominal = evidence.windows, evidence.nominal
    free = keep_rows(windows, contacts.free)
    if free.X.shape[2] != windows.X.shape[2]:
        return None  # nothing is free between two pauses: nobody knows what the sensor reads without a load there
    singles = fit_singly(free, effects, fit_all)
    if fit.effects:
        again = fit_all(singles.windows, [fit_again(fit, singles.nominal)])
        singles = replace(singles, fits=tuple(choose_variants(singles.nominal, [*singles.fits, *again])))
    if _most_probable(nominal, singles) < EXPLAINED:
        return None  # effects that are sought together take away from each single one
    rest = join(singles, fit_all)
    beside = _find_explaining(rest)
    explained = beside[0][0] if beside else rest.nominal
    unknown, probability = _doubt(nominal, explained)
    if beside:  # two claims: that it was touched, and what the rest shows
        unknown = 1.0 - (1.0 - unknown) * (1.0 - rest.attribution.unknown)
        probability *= sum(p for _, p in beside)
    if probability < EXPLAINED:
        return None
    alone = _carry_over(windows, rest.nominal, contacts.free)
    carried = tuple((_carry_over(windows, fit, contacts.free), p) for fit, p in beside)
    return Touched(contacts, rest, alone, carried, probability, unknown)


def _find_explaining(rest: Evidence) -> list[tuple[EffectFit, float]]:
    """Single effects that may explain what contacts leave, with their probabilities; none where the best explanation is none of them, or
    one more contact."""
    if rest.verdict not in ("explained", "ambiguous") or len(rest.best.effects) != 1 or rest.best.name == CONTACT.id:
        return []
    return [(fit, p) for fit, p in rest.attribution.explained if len(fit.effects) == 1 and p >= OPEN and fit.name != CONTACT.id]


def _most_probable(nominal: EffectFit, rest: Singles) -> float:
    """Of contacts alone, or beside one effect that explains the rest."""
    shares = probabilities(rest.nominal, list(rest.fits))[2]
    beside = sum(share * _doubt(nominal, fit)[1] for share, fit in zip(shares, rest.fits, strict=True))
    return max(_doubt(nominal, rest.nominal)[1], beside)


def _doubt(nominal: EffectFit, rest: EffectFit) -> tuple[float, float]:
    """Probabilities that nothing of the library is why there is a gap, and that what the rest leaves out is."""
    unknown, lapse = map(float, find_doubts(np.array(find_left_share(nominal, rest)), read_figures().figures))
    return unknown, (1.0 - unknown) * (1.0 - lapse)


def _carry_over(windows: Windows, fit: EffectFit, free: NDArray[np.bool_]) -> EffectFit:
    """A fit to the free rows (K,), on all of them; what a contact took up counts as what the fit leaves of the rest."""
    problem, shape = Problem(windows, fit.effects), windows.target.shape
    change = problem.linearise(fit.theta, fit.phi)[0].reshape(shape) if fit.effects or problem.held else np.zeros(shape)
    held_out = np.repeat(fit.held_out.mean(axis=1, keepdims=True), shape[1], axis=1)
    held_out[:, free] = fit.held_out
    return replace(fit, residual=windows.target - windows.X @ fit.beta - change, held_out=held_out, change=change)


def with_contacts(evidence: Evidence, touched: Touched) -> Evidence:
    """The evidence with the payload of the rest as its best explanation: what its residual still shows are the contacts."""
    return replace(evidence, attribution=Attribution(0.0, touched.unknown, ((touched.best, touched.probability),), (), 0.0))


def answer_touched(recording: Recording, evidence: Evidence, touched: Touched) -> Diagnosis:
    """Verdict, cause and gap of the whole recording; payload, limits and what else is seen, of what nothing touched."""
    whole, rest, shown = answer(recording, evidence), answer(recording, touched.rest), with_contacts(evidence, touched)
    summary = reduce(lambda said, more: Message.of("gap-summary-and", said=said, more=more), find_leading(rest.also), _summarise(touched))
    contact, both = _explain(evidence, touched), _explain_both(evidence, touched)
    beside = rest if touched.best.effects else whole
    left = 1.0 - touched.unknown - touched.probability
    others = left / max(1e-12, 1.0 - beside.none_probability - beside.unknown_probability)
    besides = [each.model_copy(update={"probability": others * each.probability}) for each in beside.effects]
    of_one = sum(each.probability for each in besides if each.id == CONTACT.id)  # one contact says the same with fewer of them
    told = rest.model_copy(
        update={
            "verdict": "ambiguous" if both and contact.probability + both[0].probability < EXPLAINED else "explained",
            "summary": summary,
            "effects": [
                contact.model_copy(update={"probability": contact.probability + of_one}),
                *(each for each in besides if each.id != CONTACT.id),
            ],
            "pairs": [*both, *(each.model_copy(update={"probability": others * each.probability}) for each in beside.pairs)],
            "none_probability": 0.0,
            "unknown_probability": touched.unknown,
            "minor": [],
            "indistinguishable": [],
            "where": None if whole.where is None else _place(whole.where, touched),
            "gap": describe_gap(shown),
            "payload": PayloadPart(before=describe_payload(evidence.nominal), after=_describe_payload(evidence.nominal, touched)),
            "consequence": payload_shift(evidence.nominal, replace(touched.best, effects=(CONTACT,))),
            "next_experiment": None,
            "limits": [Message.of("gap-contacts-left-out", share=1.0 - float(touched.contacts.free.mean())), *rest.limits],
        }
    )
    return with_likely(told)


def _describe_payload(nominal: EffectFit, touched: Touched) -> PhiPart:
    """Of the rest, over what may explain it."""
    return describe_average(nominal, touched.beside or [(touched.alone, 1.0)], read_figures().widened)


def _summarise(touched: Touched) -> Message:
    """When it was touched, and what is left outside of that where it matters."""
    spans = [Message.of("gap-contact", begin_s=each.begin_s, end_s=each.end_s, most_n=each.most_n) for each in touched.contacts.found]
    said = Message.of("gap-contacts", count=len(spans), contacts=spans)
    if touched.best.effects:
        named = [fit.effects[0].title for fit, _ in touched.beside]
        effects = reduce(lambda first, second: Message.of("effect-or", first=first, second=second), named)
        more = Message.of("gap-contacts-beside", effects=effects)
    elif touched.rest.verdict != "no_gap":
        more = Message.of("gap-contacts-rest", gap=gap_of(touched.rest.windows, touched.rest.nominal))
    else:
        return said
    return Message.of("gap-summary-and", said=said, more=more)


def _place(where: Where, touched: Touched) -> Where:
    parts = [
        ContactPart(begin_s=c.begin_s, end_s=c.end_s, most_n=c.most_n, force_n=tuple(c.force.tolist()), point_m=tuple(c.point.tolist()))
        for c in touched.contacts.found
    ]
    return where.model_copy(update={"stage": CONTACT.stage, "contacts": parts})


def _explain(evidence: Evidence, touched: Touched) -> Explanation:
    """The contacts alone, with the parameters of the strongest; where the rest is explained too, as probable as that it has no gap."""
    strongest, windows = touched.contacts.strongest, evidence.windows
    closure, interval = closure_of(windows, evidence.nominal, touched.alone)
    return Explanation(
        id=CONTACT.id,
        title=CONTACT.title,
        stage=CONTACT.stage,
        probability=touched.probability * (touched.rest.attribution.none if touched.best.effects else 1.0),
        parameters=_list_values(strongest),
        gap_after=gap_of(windows, touched.alone),
        closure=closure,
        closure_interval=interval,
        advice=Message.of("advice-external-contact", force_n=strongest.most_n, begin_s=strongest.begin_s, end_s=strongest.end_s),
        why_not=NOT_ADDABLE,
    )


def _explain_both(evidence: Evidence, touched: Touched) -> list[Pair]:
    """The contacts together with each effect that may explain the rest."""
    windows, strongest = evidence.windows, _list_values(touched.contacts.strongest)
    return [
        Pair(
            ids=(CONTACT.id, fit.name),
            probability=probability,
            gap_after=gap_of(windows, fit),
            closure=closure_of(windows, evidence.nominal, fit)[0],
            parameters={CONTACT.id: strongest, fit.name: describe_values(fit)},
            why_not=NOT_ADDABLE,
        )
        for fit, probability in touched.each
    ]


def _list_values(contact: Contact) -> dict[str, Value]:
    """By the names of `ExternalContact`; without uncertainty, since nothing was fitted to the force."""
    numbers = {"at_s": contact.begin_s, "duration_s": contact.end_s - contact.begin_s}
    numbers |= {f"force_{axis}_n": float(force) for axis, force in zip("xyz", contact.force, strict=True)}
    numbers |= {f"at_{axis}_m": float(at) for axis, at in zip("xyz", contact.point, strict=True)}
    return {name: Value(value=value, std=None, unit=UNITS[name.rpartition("_")[2]]) for name, value in numbers.items()}
