"""The report's numbers as words: facts, the table of parameters, the table of channels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from core.estimation.estimate import Estimate, Identification
from core.payload.channels import CHANNELS, UNITS
from core.payload.inertia import PHI_NAMES, PHI_UNITS, InertialParameters, symmetric
from core.recording.recording import Recording
from core.report.verification_words import HOLDS_UP_TO, verification_sentence
from core.words.message import Message
from core.words.wording import ENGLISH, Wording

if TYPE_CHECKING:  # whoever only wants a sentence waits for no planner
    from core.planning.start_configuration import StartConfiguration
    from core.procedure.summary import RunSummary

INTERVAL = 1.96  # standard deviations on either side of a 95 % interval
LOUD = 1.5  # times the noise: a residual that is no longer noise
LABELS = ("m", "m c x", "m c y", "m c z", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz")


@dataclass(frozen=True)
class Fact:
    """A value with its name, what qualifies it, and whether it needs attention."""

    name: str
    value: str
    note: str = ""
    alarm: bool = False


@dataclass(frozen=True)
class ParameterRow:
    """One of the ten parameters; empty where there is nothing to say."""

    name: str
    unit: str
    reference: str
    paper: str
    paper_std: str
    ours: str
    interval: str
    paper_error: str
    error: str
    known: bool
    outside: bool
    reason: str


@dataclass(frozen=True)
class ChannelRow:
    """One of the six channels of the sensor."""

    name: str
    unit: str
    offset: str
    offset_interval: str
    residual: str
    noise: str
    ratio: str
    alarm: bool


def round_to_uncertainty(value: float, uncertainty: float | None = None) -> str:
    """A value with the digits that its uncertainty leaves (two of it), or five significant ones."""
    if not np.isfinite(value):
        return ""
    if uncertainty is None or not np.isfinite(uncertainty) or uncertainty <= 0:
        return f"{value:.5g}"
    digits = max(0, 1 - int(np.floor(np.log10(uncertainty))))
    return f"{value:.{min(digits, 9)}f}"


def sentence(said: Message | str, words: Wording) -> str:
    """The words of another part of the program as a sentence of the page."""
    text = words.quote(said).strip().replace("+-", "±")
    return text[:1].upper() + text[1:] + ("" if text.endswith((".", "!", "?")) or not text else ".")


def parameter_rows(identification: Identification, reference: InertialParameters | None, words: Wording = ENGLISH) -> list[ParameterRow]:
    """All ten parameters: reference, the paper's estimate, ours with its interval, the errors of both."""
    return [_parameter_row(identification, reference, k, words) for k in range(10)]


def _parameter_row(identification: Identification, reference: InertialParameters | None, k: int, words: Wording) -> ParameterRow:
    paper, estimate = identification.paper, identification.estimate
    known = estimate is not None and bool(estimate.determined[k])
    value, half = (np.nan, np.nan) if estimate is None else (float(estimate.phi[k]), INTERVAL * float(estimate.std[k]))
    truth = np.nan if reference is None else float(reference.phi[k])
    return ParameterRow(
        name=LABELS[k],
        unit=PHI_UNITS[k].replace("m2", "m²"),
        reference=words.mark(round_to_uncertainty(truth)),
        paper=words.mark(round_to_uncertainty(float(paper.phi[k]), float(paper.std[k]))),
        paper_std=words.mark(two_digits(float(paper.std[k]))),
        ours=words.mark(round_to_uncertainty(value, half)) if known else words.say("report-not-determined"),
        interval=words.mark(two_digits(half)) if known else "",
        paper_error=words.mark(error_of(float(paper.phi[k]), truth)),
        error=words.mark(error_of(value, truth)) if known else "",
        known=known,
        outside=known and bool(abs(value - truth) > half),
        reason="" if known or estimate is None else words.quote(estimate.reasons.get(PHI_NAMES[k], "")),
    )


def two_digits(value: float) -> str:
    """An uncertainty; empty where there is none."""
    return round_to_uncertainty(value, value) if np.isfinite(value) and value > 0 else ""


def error_of(value: float, truth: float) -> str:
    """Of a value against the truth, relative where that is not zero; empty where either is unknown."""
    if not np.isfinite(value - truth):
        return ""
    return f"{value - truth:+.2g}" if truth == 0 else f"{100 * (value / truth - 1):+.2f} %"


def channel_rows(estimate: Estimate, words: Wording) -> list[ChannelRow]:
    """Offset, residual and noise of each channel."""
    rows = []
    for k, (name, unit) in enumerate(zip(CHANNELS, UNITS, strict=True)):
        half = INTERVAL * float(estimate.offset_std[k])
        ratio = float(estimate.residual_rms[k] / estimate.noise_std[k])
        rows.append(
            ChannelRow(
                name,
                unit,
                words.mark(round_to_uncertainty(float(estimate.offset[k]), half)),
                words.mark(two_digits(half)),
                words.mark(two_digits(float(estimate.residual_rms[k]))),
                words.mark(two_digits(float(estimate.noise_std[k]))),
                words.mark(f"{ratio:.2f}"),
                ratio > LOUD,
            )
        )
    return rows


@dataclass(frozen=True)
class JointRow:
    """One joint whose torque the payload was identified from."""

    joint: str
    coulomb: str
    viscous: str
    gain: str
    residual: str
    windows: int


def joint_rows(identification: Identification, words: Wording) -> list[JointRow]:
    """Friction, gain and residual of each joint that could be used."""
    return [
        JointRow(
            each.joint,
            words.mark(f"{each.coulomb_n_m:.3g}"),
            words.mark(f"{each.viscous_n_m_s:.3g}"),
            words.mark(f"{100 * each.gain:.1f} ± {100 * INTERVAL * each.gain_std:.1f}"),
            words.mark(f"{each.residual_n_m:.2g}"),
            each.windows,
        )
        for each in identification.joints
        if each.windows
    ]


@dataclass(frozen=True)
class UnseenRow:
    """A motion that was left out of the fit."""

    sentence: str
    alarm: bool


def unseen_rows(identification: Identification, words: Wording = ENGLISH) -> list[UnseenRow]:
    """How well each rotation is predicted by a fit to all the rest."""
    return [
        UnseenRow(verification_sentence(each.phase, each.rms, each.expected, each.ratio, words), each.ratio > HOLDS_UP_TO)
        for each in identification.verification
    ]


def facts(identification: Identification, run: RunSummary | None, words: Wording = ENGLISH) -> list[Fact]:
    """What one wants to know first."""
    estimate = identification.estimate
    found = [] if estimate is None else [*_payload_facts(estimate, words), *_mounting_facts(estimate, words)]
    if identification.accounted:
        titles = [words.quote(share.title) for share in identification.shares] or list(identification.accounted)
        mass_kg = sum(float(share.change[0]) for share in identification.shares)
        note = words.say("report-accounted-note", mass_kg=mass_kg)
        found.append(Fact(words.say("report-accounted"), ", ".join(titles), note))
    return found if run is None else [*found, *_safety_facts(run, words)]


def _payload_facts(estimate: Estimate, words: Wording) -> list[Fact]:
    found = []
    if estimate.determined[0]:
        half_kg = INTERVAL * float(estimate.std[0])
        value = words.mark(f"{round_to_uncertainty(float(estimate.phi[0]), half_kg)} kg")
        found.append(Fact(words.say("report-mass"), value, words.mark(f"± {two_digits(half_kg)} kg (95 %)")))
    if estimate.determined[:4].all():
        half = 1000 * INTERVAL * estimate.com_std
        com = words.list_numbers(round_to_uncertainty(float(1000 * c), float(h)) for c, h in zip(estimate.com_m, half, strict=True))
        note = words.say("report-com-note", half_widths=words.list_numbers(two_digits(float(h)) for h in half))
        found.append(Fact(words.say("report-com"), f"{com} mm", note))
    if estimate.determined.all():
        moments = np.linalg.eigvalsh(symmetric(estimate.inertia_com))
        text = words.list_numbers(f"{1000 * moment:.3g}" for moment in moments)
        note = words.say("report-moments-note") if estimate.consistent else words.say("report-moments-impossible")
        found.append(Fact(words.say("report-moments"), text, note, alarm=not estimate.consistent))
    return found


def _mounting_facts(estimate: Estimate, words: Wording) -> list[Fact]:
    found = []
    tilt, tilt_std = estimate.base_tilt_rad, estimate.base_tilt_std
    if tilt is not None:
        half = np.degrees(np.zeros(2) if tilt_std is None else INTERVAL * tilt_std)
        value = words.list_numbers(_format_signed(float(np.degrees(a)), float(h)) + "°" for a, h in zip(tilt, half, strict=True))
        note = words.say("report-base-tilt-note", half_widths=words.list_numbers(f"{two_digits(float(h))}°" for h in half))
        found.append(Fact(words.say("report-base-tilt"), value, note))
    if estimate.delay_s is not None:
        half_ms = 0.0 if estimate.delay_std is None else 1000 * INTERVAL * estimate.delay_std
        note = words.say("report-delay-note", half_width=words.mark(two_digits(half_ms)))
        found.append(Fact(words.say("report-delay"), words.mark(f"{_format_signed(1000 * estimate.delay_s, half_ms)} ms"), note))
    return found


def _format_signed(value: float, uncertainty: float) -> str:
    return ("+" if value >= 0 else "") + round_to_uncertainty(value, uncertainty)


def _safety_facts(run: RunSummary, words: Wording) -> list[Fact]:
    limits = run.cell.limits
    found = []
    if run.min_distance_m is not None:
        nearest, limit_m, beyond_m = words.quote(run.nearest or ""), limits.clearance_m, run.beyond_first_m
        if beyond_m is not None and beyond_m > run.min_distance_m:
            note = words.say("report-nearest-beyond-first", name=nearest, limit_m=limit_m, beyond_m=beyond_m)
        else:
            note = words.say("report-nearest", name=nearest, limit_m=limit_m)
        low = run.min_distance_m < limits.clearance_m
        found.append(Fact(words.say("report-smallest-distance"), words.mark(f"{run.min_distance_m:.3f} m"), note, alarm=low))
    fast = run.max_speed_m_s > limits.cartesian_speed_m_s
    note = words.say("report-largest-speed-note", limit_m_s=limits.cartesian_speed_m_s)
    found.append(Fact(words.say("report-largest-speed"), words.mark(f"{run.max_speed_m_s:.3f} m/s"), note, alarm=fast))
    stopped = words.say("report-restarts-some") if run.restarts else words.say("report-restarts-none")
    return [*found, Fact(words.say("report-restarts"), str(run.restarts), stopped, alarm=run.restarts > 0)]


def origin_facts(recording: Recording, run: RunSummary | None, words: Wording) -> list[Fact]:
    """How the answer came about."""
    span_s = float(recording.t[-1] - recording.t[0])
    rate = words.say("report-rate", span_s=span_s, rate_hz=(len(recording) - 1) / span_s)
    found = [Fact(words.say("report-recording"), words.say("report-samples", count=len(recording)), rate)]
    motion = words.say("report-with-joints") if recording.q is not None else words.say("report-with-poses")
    columns = ((words.say("report-wrist-wrench"), recording.wrench), (words.say("report-joint-torques"), recording.tau))
    measured = [name for name, values in columns if values is not None]
    found.append(Fact(words.say("report-measured"), f" {words.say('report-and')} ".join(measured), motion))
    if run is not None:
        names = words.say("report-planning"), words.say("report-robot-time"), words.say("report-estimation")
        seconds = zip(names, (run.plan_s, run.robot_s, run.estimate_s), strict=True)
        found += [Fact(name, words.mark(f"{value:.1f} s")) for name, value in seconds]
        found.append(Fact(words.say("report-seed"), str(run.seed), words.say("report-seed-note")))
    return found


def start_lines(start: StartConfiguration, words: Wording) -> list[str]:
    """A start configuration in words, one line each."""
    nearest, clearance_m, manipulability = words.quote(start.nearest), start.clearance_m, start.manipulability
    if start.axis.endswith("+"):
        clear = words.say(
            "report-start-clear-turning",
            clearance_m=clearance_m, turning_m=start.least_clearance_m, nearest=nearest, manipulability=manipulability,
        )  # fmt: skip
    else:
        clear = words.say("report-start-clear", clearance_m=clearance_m, nearest=nearest, manipulability=manipulability)
    angles = " ".join(f"{v:.0f}°" for v in np.degrees(start.q))
    lines = [clear, words.say("report-start-joints", angles=angles)]
    if start.throw is not None:
        zone, distance_m, speed_m_s = start.throw.zone, start.throw.distance_m, start.throw.speed_m_s
        lines.append(words.say("report-start-throw", zone=zone, distance_m=distance_m, speed_m_s=speed_m_s))
    return lines
