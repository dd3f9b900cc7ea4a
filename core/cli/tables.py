"""The tables that the command line prints."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from rich.table import Table

from core.estimation.result import Result
from core.gap.answer import SIDES, Also, Diagnosis, Experiment
from core.payload.inertia import PHI_NAMES, PHI_UNITS
from core.planning.plan import Plan
from core.planning.settings import Scope
from core.planning.summary import PlanTorques
from core.report.verification_words import verification_sentence
from core.second_opinion.left_out import describe_left_out
from core.second_opinion.opinion import Opinion

Array = NDArray[np.float64]

SHOWN_EFFECTS = 5
SHOWN_PARAMETERS = 4


def number(value: float | None, digits: int = 5) -> str:
    """A value with significant digits; empty where there is none."""
    return "" if value is None else f"{value:.{digits}g}"


def decimals_of(half_width: float | None) -> int:
    """Decimal places at which a half-width has two digits."""
    return 6 if not half_width else max(0, 1 - math.floor(math.log10(half_width)))


def format_decimals(value: float | None, decimals: int) -> str:
    """A value with decimal places; empty where there is none."""
    return "" if value is None else f"{value:.{decimals}f}"


def parameters_table(result: Result) -> Table:
    """All ten parameters: reference, the paper's estimate, ours with its 95 % half-width, and the error against the reference."""
    title = "Payload in the sensor frame" if result.workpiece is None else "The whole in the sensor frame, tools and workpiece"
    table = Table(title=title, caption="± is the half-width of the 95 % interval; inertia about the sensor origin")
    table.add_column("")
    for heading in ("reference", "paper's method", "Heft", "±", "error"):
        table.add_column(heading, justify="right", no_wrap=True)
    table.add_column("unit", no_wrap=True)
    estimate, reference = result.estimate, result.reference
    for k, (name, unit) in enumerate(zip(PHI_NAMES, PHI_UNITS, strict=True)):
        truth = reference.phi[k] if reference else None
        value = estimate.phi[k] if estimate else None
        std = estimate.std[k] if estimate else None
        known = estimate is not None and estimate.determined[k]
        half = 1.96 * std if known and std is not None else None
        places = decimals_of(half)
        table.add_row(
            name,
            number(truth),
            format_decimals(result.paper.phi[k], places),
            format_decimals(value, places) if known else "not determined",
            format_decimals(half, places),
            format_error(value if known else None, truth),
            unit,
        )
    return table


def format_error(value: float | None, truth: float | None) -> str:
    """Of a value against the truth, relative where that is not zero; empty where either is unknown."""
    if value is None or truth is None:
        return ""
    return f"{value - truth:+.2g}" if truth == 0 else f"{100 * (value / truth - 1):+.3f} %"


def reason_lines(result: Result) -> list[str]:
    """Why parameters are not determined, those with the same reason in one line."""
    reasons = {} if result.estimate is None else result.estimate.reasons
    return [f"{', '.join(name for name in reasons if reasons[name] == why)}: {why}" for why in dict.fromkeys(reasons.values())]


def verification_lines(result: Result) -> list[str]:
    """How well each rotation is predicted by a fit to all the rest."""
    return [verification_sentence(each.phase, each.rms, each.expected, each.ratio) for each in result.verification]


def plan_table(plan: Plan) -> Table:
    """Where each pose is, how close it gets, and how long it takes."""
    table = Table(title="Plan (nothing has moved)")
    for heading in ("axis", "joints, deg", "clearance, m", "nearest", "manipulability", "transfer, s", "least margin, m", "rotation, s"):
        table.add_column(heading, justify="left" if heading in ("axis", "nearest", "joints, deg") else "right")
    for leg in plan.legs:
        table.add_row(
            leg.axis,
            " ".join(f"{v:.0f}" for v in np.degrees(leg.start.q)),
            f"{leg.start.clearance_m:.3f}",
            leg.start.nearest,
            f"{leg.start.manipulability:.3f}",
            f"{leg.transfer.trajectory.duration:.1f}",
            f"{leg.transfer.least_margin_m:.3f}",
            "" if leg.profile is None else f"{leg.profile.duration:.1f}",
        )
    table.add_row("home", "", "", "", "", f"{plan.home.trajectory.duration:.1f}", f"{plan.home.least_margin_m:.3f}", "")
    return table


def not_excited_lines(scope: Scope) -> list[str]:
    """What a part of the procedure does not show, those with the same reason in one line."""
    left_out = scope.not_excited
    return [
        f"Not to be determined by rotations: {', '.join(name for name in left_out if left_out[name] == why)} ({why})"
        for why in dict.fromkeys(left_out.values())
    ]


def opinion_lines(opinion: Opinion) -> list[str]:
    """What the second opinion found, a line for each kind of pair and one for the fastest point."""
    lines = [f"A second opinion on {opinion.samples} set points, sharing no code with the planner:"]
    for each in opinion.approaches:
        limit = f"limit {each.required_m:.3f} m"
        where = f"{each.part!r} after {each.time_s:.3f} s"
        lines.append(f"  {each.kind}: {each.first!r} {each.distance_m:.3f} m from {each.second!r} ({limit}), {where}")
    fast = opinion.fastest
    where = f"{fast.part!r} after {fast.time_s:.3f} s"
    lines.append(f"  fastest point: a corner of {fast.body!r} at {fast.speed_m_s:.3f} m/s (limit {fast.limit_m_s:.3f} m/s), {where}")
    without = describe_left_out(opinion.left_out)
    lines += [*(["Pairs of which nothing is asked:"] if without else []), *(f"  {line}" for line in without)]
    lost = opinion.lost_load
    if lost is None:
        return lines
    where = f"{lost.part!r} after {lost.time_s:.3f} s"
    return [*lines, f"  a load that comes off: flies past zone {lost.zone!r} at {lost.distance_m:.3f} m or more, from {where}"]


def torque_lines(torques: PlanTorques) -> list[str]:
    """What the plan asks of the joints, and which of them could not be judged."""
    carried = f"{torques.mass_kg:.3f} kg ({torques.load})"
    most = torques.largest
    if most is None:
        line = f"Joint torques with {carried}: not judged."
    else:
        of_limit = f"{most.torque_n_m:.1f} N m of {most.limit_n_m:.1f} N m ({100 * most.ratio:.0f} %)"
        line = f"Joint torques with {carried}: at most {of_limit}, {most.joint!r} in {most.part!r} after {most.time_s:.3f} s."
    return [line, *(f"  not judged: {why}" for why in torques.not_judged)]


def diagnosis_table(diagnosis: Diagnosis) -> Table:
    """The effects that may explain the gap, the most probable first."""
    gap = "" if diagnosis.gap is None else f"gap before {diagnosis.gap.before:.2f}, after {diagnosis.gap.after:.2f} (noise is 1)"
    table = Table(title=f"{diagnosis.verdict}: {diagnosis.summary}", caption=gap)
    for heading in ("effect", "probability", "gap after", "closure", "parameters"):
        table.add_column(heading, justify="right" if heading in ("probability", "gap after", "closure") else "left")
    for effect in diagnosis.effects[:SHOWN_EFFECTS]:
        values = ", ".join(
            f"{name} {number(v.value, 4)} ± {number(v.std, 2)}" for name, v in list(effect.parameters.items())[:SHOWN_PARAMETERS]
        )
        more = len(effect.parameters) - SHOWN_PARAMETERS
        values += f" and {more} more" if more > 0 else ""
        table.add_row(effect.id, f"{effect.probability:.3f}", f"{effect.gap_after:.3f}", f"{effect.closure:.3f}", values)
    if diagnosis.effects:
        table.add_row("none", f"{diagnosis.none_probability:.3f}", "", "", "")
        table.add_row("unknown", f"{diagnosis.unknown_probability:.3f}", "", "", "")
    return table


def diagnosis_lines(diagnosis: Diagnosis) -> list[str]:
    """Everything else that a person should read."""
    lines = [diagnosis.where.message.text] if diagnosis.where and diagnosis.verdict != "no_gap" else []
    lines += [f"{' or '.join(tie.ids)}: {tie.why}. What would settle it: {tie.splits}." for tie in diagnosis.indistinguishable]
    lines += [_experiment_line(diagnosis.next_experiment)] if diagnosis.next_experiment else []
    lines += [_also_line(also) for also in diagnosis.also]
    lines += [f"Minor: {minor.id}: {minor.message}" for minor in diagnosis.minor]
    lines += [diagnosis.consequence.text] if diagnosis.consequence else []
    lines += [f"To do: {diagnosis.effects[0].advice}"] if diagnosis.effects and diagnosis.verdict in ("explained", "ambiguous") else []
    return lines + [f"Not looked at: {limit}" for limit in diagnosis.limits]


def _also_line(also: Also) -> str:
    """What is seen elsewhere than in the wrench, and what to do about it where it matters."""
    advice = f" To do: {also.advice}" if also.material else " It does not matter."
    return f"Also, {SIDES[also.side]}: {also.id}: {also.message}{advice}"


def _experiment_line(experiment: Experiment) -> str:
    """What to measure next, and what it is going to tell."""
    pairs = "; ".join(" or ".join(names) for names in experiment.splits)
    how = "planned" if experiment.planned else f"not planned: {experiment.refused}"
    return (
        f"Next: {experiment.motion} ({experiment.seconds:.0f} s of robot time, {how}). It tells {pairs}: "
        f"{experiment.sigma_before:.1f} standard deviations apart now, about {experiment.sigma_after:.1f} with both recordings."
    )
