"""The tables of results and diagnoses that the command line prints, in the terminal's language."""

from __future__ import annotations

import math

from rich.table import Table

from core.cli.terminal import find_wording
from core.estimation.budget import REPEATABILITY, TITLES
from core.estimation.budget_part import BudgetPart
from core.estimation.result import Result
from core.gap.answer import SIDES, Also, Diagnosis, Experiment
from core.gap.instruction import Instruction, find_advice, rank_explanations
from core.payload.inertia import PHI_NAMES, PHI_UNITS
from core.report.parameter_words import parameter_texts
from core.report.verification_words import verification_sentence
from core.words.message import Message
from core.words.wording import Wording

SHOWN_EFFECTS = 5
SHOWN_PARAMETERS = 4
PROBABLE = 0.01
"""Of what is less probable nobody asks how large it would be."""
INTERVAL = 1.96
"""Standard uncertainties on either side of a 95 % interval."""
NAMED_SHARE = 0.1
"""Of a parameter's variance, from which a part of the budget is named."""

VERDICTS = {
    "explained": Message.of("result-explained"),
    "ambiguous": Message.of("result-ambiguous"),
    "unknown": Message.of("result-unknown-cause"),
    "no_gap": Message.of("result-no-gap"),
    "not_enough": Message.of("result-not-enough"),
}


def number(value: float | None, digits: int = 5) -> str:
    """A value with significant digits; empty where there is none."""
    return "" if value is None else find_wording().mark(f"{value:.{digits}g}")


def decimals_of(half_width: float | None) -> int:
    """Decimal places at which a half-width has two digits."""
    return 6 if not half_width else max(0, 1 - math.floor(math.log10(half_width)))


def format_decimals(value: float | None, decimals: int) -> str:
    """A value with decimal places; empty where there is none."""
    return "" if value is None else find_wording().mark(f"{value:.{decimals}f}")


def parameters_table(result: Result) -> Table:
    """All ten parameters: reference, the paper's estimate, ours with its 95 % half-width, and the error against the reference."""
    words = find_wording()
    title = words.say("result-payload-title") if result.workpiece is None else words.say("result-whole-title")
    table = Table(title=title, caption=words.say("result-payload-caption"))
    table.add_column("", no_wrap=True)
    for heading in (words.say("result-reference"), words.say("result-papers-method"), "Heft", "±", words.say("result-error")):
        table.add_column(heading, justify="right", no_wrap=True)
    table.add_column(words.say("result-unit"), no_wrap=True)
    estimate, reference = result.estimate, result.reference
    for k, (name, unit) in enumerate(zip(PHI_NAMES, PHI_UNITS, strict=True)):
        truth = reference.phi[k] if reference else None
        value = estimate.phi[k] if estimate else None
        half = _half_width(result, k)
        known, places = half is not None, decimals_of(half)
        table.add_row(
            name,
            number(truth),
            format_decimals(result.paper.phi[k], places),
            format_decimals(value, places) if known else words.say("result-not-determined"),
            format_decimals(half, places),
            format_error(value if known else None, truth),
            unit,
        )
    return table


def _half_width(result: Result, k: int) -> float | None:
    """Of the 95 % interval; None where the parameter is not determined."""
    estimate = result.estimate
    std = estimate.std[k] if estimate is not None and estimate.determined[k] else None
    return None if std is None else INTERVAL * std


def tabulate_budget(budget: BudgetPart, result: Result) -> Table:
    """Of each parameter that is determined: half-widths all in and by this recording alone, and the parts that contribute most."""
    words = find_wording()
    table = Table(title=words.say("result-budget-title"))
    table.add_column("", no_wrap=True)
    for heading in (words.say("result-all-in"), words.say("result-repeats")):
        table.add_column(heading, justify="right", no_wrap=True)
    table.add_column(words.say("result-mostly"))
    table.add_column(words.say("result-unit"), no_wrap=True)
    for k, (name, unit) in enumerate(zip(PHI_NAMES, PHI_UNITS, strict=True)):
        half, alone = _half_width(result, k), budget.repeatability_std[k]
        if half is not None and alone is not None:
            table.add_row(name, number(half, 2), number(INTERVAL * alone, 2), _parts(budget, k, half / INTERVAL), unit)
    return table


def _parts(budget: BudgetPart, k: int, std: float) -> str:
    """The parts that make up a tenth of a parameter's variance or more, the largest first."""
    words = find_wording()
    parts = [(TITLES[REPEATABILITY], budget.repeatability_std[k]), *((source.title, source.std[k]) for source in budget.sources)]
    shares = sorted(((title, ((part or 0.0) / std) ** 2) for title, part in parts), key=lambda each: -each[1])
    return ", ".join(words.say("result-part-of", source=title, share=share) for title, share in shares if share >= NAMED_SHARE)


def assumption_lines(result: Result) -> list[str]:
    """What nobody has stated of the uncertainty, was assumed and matters."""
    budget = None if result.estimate is None else result.estimate.budget
    return [] if budget is None else [find_wording().say("result-note", remark=each) for each in budget.assumptions]


def format_error(value: float | None, truth: float | None) -> str:
    """Of a value against the truth, relative where that is not zero; empty where either is unknown."""
    if value is None or truth is None:
        return ""
    return find_wording().mark(f"{value - truth:+.2g}" if truth == 0 else f"{100 * (value / truth - 1):+.3f} %")


def reason_lines(result: Result) -> list[str]:
    """Why parameters are not determined, those with the same reason in one line."""
    words, reasons = find_wording(), {} if result.estimate is None else result.estimate.reasons
    return [
        words.say("result-undetermined", names=[name for name in reasons if reasons[name] == why], reason=why)
        for why in dict.fromkeys(reasons.values())
    ]


def verification_lines(result: Result) -> list[str]:
    """How well each rotation is predicted by a fit to all the rest."""
    return [verification_sentence(each.phase, each.rms, each.expected, each.ratio) for each in result.verification]


def diagnosis_table(diagnosis: Diagnosis) -> Table:
    """The effects, alone or several at once, that may explain the gap, the most probable first."""
    words, gap = find_wording(), diagnosis.gap
    title = words.say("result-diagnosis-title", verdict=VERDICTS[diagnosis.verdict], summary=diagnosis.summary)
    table = Table(title=title, caption="" if gap is None else words.say("result-gap", before=gap.before, after=gap.after))
    table.add_column(words.say("result-effect"))
    for heading in (words.say("result-probability"), words.say("result-gap-after"), words.say("result-closure")):
        table.add_column(heading, justify="right")
    table.add_column(words.say("result-parameters"))
    rows = [(e.probability, e.gap_after, e.closure, e.id, [e.parameters]) for e in diagnosis.effects]
    rows += [(p.probability, p.gap_after, p.closure, " + ".join(p.ids), [*p.parameters.values()]) for p in diagnosis.pairs]
    for probability, after, closure, name, parameters in sorted(rows, key=lambda row: -row[0])[:SHOWN_EFFECTS]:
        told = parameters if probability > PROBABLE else []
        said = [text for each in told for text in parameter_texts(each, words, SHOWN_PARAMETERS)]
        table.add_row(name, *(format_decimals(share, 3) for share in (probability, after, closure)), "\n".join(said))
    if diagnosis.effects:
        table.add_row(words.say("result-no-effect"), format_decimals(diagnosis.none_probability, 3), "", "", "")
        table.add_row(words.say("result-unknown-effect"), format_decimals(diagnosis.unknown_probability, 3), "", "", "")
    return table


def diagnosis_lines(diagnosis: Diagnosis) -> list[str]:
    """Everything else that a person should read."""
    words = find_wording()
    lines = _instruction_lines(diagnosis.instruction, words)
    lines += [words.say("result-likely", effects=[_name_answer(name, words) for name in diagnosis.likely])] if diagnosis.likely[1:] else []
    lines += [words.quote(diagnosis.where.message)] if diagnosis.where and diagnosis.verdict != "no_gap" else []
    lines += [
        words.say("result-tie", effects=_either(tie.ids, words), reason=tie.why, splits=tie.splits) for tie in diagnosis.indistinguishable
    ]
    lines += [_experiment_line(diagnosis.next_experiment, words)] if diagnosis.next_experiment else []
    lines += [_also_line(also, words) for also in diagnosis.also]
    lines += [words.say("result-minor", effect=minor.id, seen=minor.message) for minor in diagnosis.minor]
    lines += [words.quote(diagnosis.consequence)] if diagnosis.consequence else []
    if diagnosis.verdict in ("explained", "ambiguous"):
        best = [ids for _, ids in rank_explanations(diagnosis)[:1]]
        lines += [words.say("result-to-do", advice=advice) for ids in best for advice in find_advice(diagnosis, ids).values()]
    return lines + [words.say("result-not-looked-at", limit=limit) for limit in diagnosis.limits]


def _name_answer(name: str, words: Wording) -> str:
    """An answer as the table calls it."""
    others = {"none": "result-no-effect", "unknown": "result-unknown-effect"}
    return words.say(others[name]) if name in others else name.replace("+", " + ")


def _instruction_lines(instruction: Instruction, words: Wording) -> list[str]:
    """What the person at the robot has to do, before anything else."""
    first = words.say("result-instruction", sentence=instruction.sentence, next=instruction.next)
    return [first, *(words.say("result-instruction-further", sentence=each) for each in instruction.further)]


def _either(names: tuple[str, ...], words: Wording) -> str:
    """One of several, in words."""
    said = names[0]
    for name in names[1:]:
        said = words.say("result-either", effect=said, other=name)
    return said


def _also_line(also: Also, words: Wording) -> str:
    """What is seen elsewhere than in the wrench, and what to do about it where it matters."""
    side = SIDES[also.side]
    if also.material:
        return words.say("result-also-material", side=side, effect=also.id, seen=also.message, advice=also.advice)
    return words.say("result-also-immaterial", side=side, effect=also.id, seen=also.message)


def _experiment_line(experiment: Experiment, words: Wording) -> str:
    """What to measure next, and what it is going to tell."""
    refused = experiment.refused or ""
    return words.say(
        "result-next-experiment",
        motion=experiment.motion,
        seconds_s=experiment.seconds,
        how=Message.of("result-planned") if experiment.planned else Message.of("result-not-planned", reason=refused),
        pairs="; ".join(_either(names, words) for names in experiment.splits),
        sigma_before=experiment.sigma_before,
        sigma_after=experiment.sigma_after,
    )
