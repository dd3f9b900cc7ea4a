"""The report's numbers as words: facts, the table of parameters, the table of channels."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.estimation.estimate import Estimate, Identification
from core.payload.inertia import PHI_NAMES, PHI_UNITS, InertialParameters, symmetric
from core.planning.start_configuration import StartConfiguration
from core.procedure.summary import RunSummary
from core.recording.recording import Recording
from core.report.charts import CHANNELS, UNITS
from core.report.verification_words import HOLDS_UP_TO, verification_sentence

Array = NDArray[np.float64]

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


def sentence(text: str) -> str:
    """The words of another part of the program as a sentence of the page."""
    text = text.strip().replace("+-", "±")
    return text[:1].upper() + text[1:] + ("" if text.endswith((".", "!", "?")) or not text else ".")


def parameter_rows(identification: Identification, reference: InertialParameters | None) -> list[ParameterRow]:
    """All ten parameters: reference, the paper's estimate, ours with its interval, the errors of both."""
    return [_parameter_row(identification, reference, k) for k in range(10)]


def _parameter_row(identification: Identification, reference: InertialParameters | None, k: int) -> ParameterRow:
    paper, estimate = identification.paper, identification.estimate
    known = estimate is not None and bool(estimate.determined[k])
    value, half = (np.nan, np.nan) if estimate is None else (float(estimate.phi[k]), INTERVAL * float(estimate.std[k]))
    truth = np.nan if reference is None else float(reference.phi[k])
    return ParameterRow(
        name=LABELS[k],
        unit=PHI_UNITS[k].replace("m2", "m²"),
        reference=round_to_uncertainty(truth),
        paper=round_to_uncertainty(float(paper.phi[k]), float(paper.std[k])),
        paper_std=two_digits(float(paper.std[k])),
        ours=round_to_uncertainty(value, half) if known else "not determined",
        interval=two_digits(half) if known else "",
        paper_error=error_of(float(paper.phi[k]), truth),
        error=error_of(value, truth) if known else "",
        known=known,
        outside=known and bool(abs(value - truth) > half),
        reason="" if known or estimate is None else str(estimate.reasons.get(PHI_NAMES[k], "")),
    )


def two_digits(value: float) -> str:
    """An uncertainty; empty where there is none."""
    return round_to_uncertainty(value, value) if np.isfinite(value) and value > 0 else ""


def error_of(value: float, truth: float) -> str:
    """Of a value against the truth, relative where that is not zero; empty where either is unknown."""
    if not np.isfinite(value - truth):
        return ""
    return f"{value - truth:+.2g}" if truth == 0 else f"{100 * (value / truth - 1):+.2f} %"


def channel_rows(estimate: Estimate) -> list[ChannelRow]:
    """Offset, residual and noise of each channel."""
    rows = []
    for k, (name, unit) in enumerate(zip(CHANNELS, UNITS, strict=True)):
        half = INTERVAL * float(estimate.offset_std[k])
        ratio = float(estimate.residual_rms[k] / estimate.noise_std[k])
        rows.append(
            ChannelRow(
                name,
                unit,
                round_to_uncertainty(float(estimate.offset[k]), half),
                two_digits(half),
                two_digits(float(estimate.residual_rms[k])),
                two_digits(float(estimate.noise_std[k])),
                f"{ratio:.2f}",
                ratio > LOUD,
            )
        )
    return rows


@dataclass(frozen=True)
class UnseenRow:
    """A motion that was left out of the fit."""

    sentence: str
    alarm: bool


def unseen_rows(identification: Identification) -> list[UnseenRow]:
    """How well each rotation is predicted by a fit to all the rest."""
    return [
        UnseenRow(verification_sentence(each.phase, each.rms, each.expected, each.ratio), each.ratio > HOLDS_UP_TO)
        for each in identification.verification
    ]


def facts(identification: Identification, run: RunSummary | None) -> list[Fact]:
    """What one wants to know first."""
    estimate = identification.estimate
    found = [] if estimate is None else [*_payload_facts(estimate), *_mounting_facts(estimate)]
    accounted = Fact("Effects accounted for", ", ".join(identification.accounted), "as the cell's twin has them")
    return [*found, *([accounted] if identification.accounted else []), *([] if run is None else _safety_facts(run))]


def _payload_facts(estimate: Estimate) -> list[Fact]:
    found = []
    if estimate.determined[0]:
        half_kg = INTERVAL * float(estimate.std[0])
        found.append(Fact("Mass", f"{round_to_uncertainty(float(estimate.phi[0]), half_kg)} kg", f"± {two_digits(half_kg)} kg (95 %)"))
    if estimate.determined[:4].all():
        half = 1000 * INTERVAL * estimate.com_std
        com = ", ".join(round_to_uncertainty(float(1000 * c), float(h)) for c, h in zip(estimate.com_m, half, strict=True))
        note = "sensor frame; ± " + ", ".join(two_digits(float(h)) for h in half) + " mm (95 %)"
        found.append(Fact("Centre of mass", f"{com} mm", note))
    if estimate.determined.all():
        moments = np.linalg.eigvalsh(symmetric(estimate.inertia_com))
        text = ", ".join(f"{1000 * moment:.3g}" for moment in moments)
        note = "g m², about the centre of mass" + ("" if estimate.consistent else "; no rigid body has these parameters")
        found.append(Fact("Principal moments", text, note, alarm=not estimate.consistent))
    return found


def _mounting_facts(estimate: Estimate) -> list[Fact]:
    found = []
    tilt, tilt_std = estimate.base_tilt_rad, estimate.base_tilt_std
    if tilt is not None:
        half = np.degrees(np.zeros(2) if tilt_std is None else INTERVAL * tilt_std)
        value = ", ".join(_format_signed(float(np.degrees(a)), float(h)) + "°" for a, h in zip(tilt, half, strict=True))
        note = "about base x and y, against nominal gravity; ± " + ", ".join(f"{two_digits(float(h))}°" for h in half)
        found.append(Fact("Tilt of the base", value, note))
    if estimate.delay_s is not None:
        half_ms = 0.0 if estimate.delay_std is None else 1000 * INTERVAL * estimate.delay_std
        note = f"against the joints; ± {two_digits(half_ms)} ms (95 %)"
        found.append(Fact("Delay of the wrench", f"{_format_signed(1000 * estimate.delay_s, half_ms)} ms", note))
    return found


def _format_signed(value: float, uncertainty: float) -> str:
    return ("+" if value >= 0 else "") + round_to_uncertainty(value, uncertainty)


def _safety_facts(run: RunSummary) -> list[Fact]:
    limits = run.cell.limits
    found = []
    if run.min_distance_m is not None:
        note = f"to {run.nearest}; limit {limits.clearance_m:.3f} m"
        if run.beyond_first_m is not None and run.beyond_first_m > run.min_distance_m:
            note += f"; {run.beyond_first_m:.3f} m without the links that only the first joint moves"
        low = run.min_distance_m < limits.clearance_m
        found.append(Fact("Smallest distance", f"{run.min_distance_m:.3f} m", note, alarm=low))
    fast = run.max_speed_m_s > limits.cartesian_speed_m_s
    note = f"of any point; limit {limits.cartesian_speed_m_s:.3f} m/s"
    found.append(Fact("Largest speed", f"{run.max_speed_m_s:.3f} m/s", note, alarm=fast))
    stopped = "the guard stopped the robot" if run.restarts else "the guard never stopped the robot"
    return [*found, Fact("Restarts", str(run.restarts), stopped, alarm=run.restarts > 0)]


def origin_facts(recording: Recording, run: RunSummary | None) -> list[Fact]:
    """How the answer came about."""
    span = float(recording.t[-1] - recording.t[0])
    rate = (len(recording) - 1) / span
    found = [Fact("Recording", f"{len(recording)} samples", f"{span:.1f} s, {rate:.4g} per second on average")]
    kind = "joint positions" if recording.q is not None else "poses of the sensor"
    columns = (("wrist wrench", recording.wrench), ("joint torques", recording.tau))
    measured = [name for name, values in columns if values is not None]
    found.append(Fact("Measured", " and ".join(measured), f"with {kind}"))
    if run is not None:
        seconds = (("Planning", run.plan_s), ("Robot time", run.robot_s), ("Estimation", run.estimate_s))
        found += [Fact(name, f"{value:.1f} s") for name, value in seconds]
        found.append(Fact("Seed", str(run.seed), "of planning and simulation"))
    return found


def start_lines(start: StartConfiguration) -> list[str]:
    """A start configuration in words, one line each."""
    clear = f"{start.clearance_m:.3f} m clear"
    if start.axis.endswith("+"):
        clear += f", {start.least_clearance_m:.3f} m in the rotation"
    lines = [f"{clear} (nearest: {start.nearest}), manipulability {start.manipulability:.3f}"]
    lines.append("joints " + " ".join(f"{v:.0f}°" for v in np.degrees(start.q)))
    if start.throw is not None:
        throw = start.throw
        lines.append(f"a load that comes off passes {throw.zone} at {throw.distance_m:.2f} m ({throw.speed_m_s:.2f} m/s)")
    return lines
