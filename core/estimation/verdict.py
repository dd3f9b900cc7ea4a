"""The verdict on an estimate, and what the user should know before using its numbers."""

from __future__ import annotations

import math

import numpy as np

from core.array import Array
from core.estimation.determination import explain_not_excited
from core.estimation.estimate import Estimate
from core.estimation.fit import Fit
from core.payload.channels import CHANNELS
from core.payload.inertia import PHI_NAMES
from core.recording.recording import Recording
from core.words.message import Message

INTERVAL = 1.96
LARGE_RESIDUAL = 2.0
"""Times the noise that the residual may be before something is said: where an effect becomes material for a diagnosis, too."""
DRIFT_SHARE = 0.05
"""Share of the weight, and of its torque, by which the offset may drift before it is worth a warning; it is in the result anyway."""


def verdict_of(estimate: Estimate, *, static: bool) -> Message:
    """What of the payload is determined, with its mass and the half-width of its 95 % interval."""
    if not estimate.determined[0]:
        return Message.of("estimation-nothing-determined", reason=estimate.reasons["m"])
    mass, half = float(estimate.phi[0]), INTERVAL * float(estimate.std[0])
    decimals = max(0, 1 - math.floor(math.log10(half)))
    missing = [name for name, known in zip(PHI_NAMES, estimate.determined, strict=True) if not known]
    if not missing:
        code = "estimation-all-determined"
    elif missing == list(PHI_NAMES[4:]):
        code = "estimation-inertia-not-determined-standing" if static else "estimation-inertia-not-determined"
    else:
        code = "estimation-partly-determined"
    return Message.of(code, mass_kg=mass, half_width_kg=half, decimals=decimals, missing=missing)


def warnings_of(recording: Recording, estimate: Estimate, found: Fit, *, static: bool) -> tuple[Message, ...]:
    """The most important first."""
    said: list[Message] = []
    stated = recording.sensor.noise_std
    ratio = estimate.residual_rms / (estimate.noise_std if stated is None else stated)
    if (found.noise.measured or stated is not None) and (ratio > LARGE_RESIDUAL).any():
        worst = int(np.argmax(ratio))
        said.append(Message.of("estimation-residual-above-noise", channel=CHANNELS[worst], times=float(ratio[worst])))
    if not estimate.converged:
        said.append(Message.of("estimation-not-converged"))
    if estimate.constrained:
        said.append(Message.of("estimation-no-such-body"))
    if not found.noise.measured and not static:
        said.append(Message.of("estimation-noise-of-residual"))
    said += _saturation(recording)
    tilt = estimate.base_tilt_rad
    if tilt is not None and estimate.base_tilt_std is not None and (np.abs(tilt) > 4.0 * estimate.base_tilt_std).any():
        size = float(np.linalg.norm(tilt))
        if np.degrees(size) > 0.1:
            said.append(Message.of("estimation-base-tilt", angle_rad=size))
    delay, delay_std = estimate.delay_s, estimate.delay_std
    if delay is not None and delay_std is not None and abs(delay) > max(4.0 * delay_std, 1e-3):
        half = INTERVAL * delay_std
        late = Message.of("estimation-wrench-late", late_s=delay, half_width_s=half)
        early = Message.of("estimation-wrench-early", early_s=-delay, half_width_s=half)
        said.append(late if delay > 0 else early)
    least = np.maximum(4.0 * estimate.drift.std, np.maximum(2.0 * estimate.noise_std, DRIFT_SHARE * _load(estimate, recording)))
    if (estimate.drift.range > least).any():
        said.append(Message.of("estimation-drift-accounted", drift=estimate.drift.description))
    return tuple(said)


def _load(estimate: Estimate, recording: Recording) -> Array:
    """(6,), what gravity makes of the payload: N, and N m with a lever of 5 cm at least; zero without a mass."""
    if not estimate.determined[0]:
        return np.zeros(6)
    mass, g = float(estimate.phi[0]), float(np.linalg.norm(recording.gravity))
    lever = max(float(np.nanmax(np.abs(estimate.phi[1:4]), initial=0.0)) / mass, 0.05)
    return np.repeat([mass * g, mass * g * lever], 3)


def on_transfers_alone(estimate: Estimate, turned: str | None) -> list[Message]:
    """Inertial parameters that are determined without any rotation that was meant to show them.

    Args:
        turned: sensor axes that were turned about; None where nobody has said what was done when.
    """
    left_out = {} if turned is None else explain_not_excited(turned)
    names = [name for name, known in zip(PHI_NAMES, estimate.determined, strict=True) if known and name in left_out]
    if not names:
        return []
    axes = [axis for axis in "xyz" if axis not in (turned or "")]
    return [Message.of("estimation-transfers-alone", axes=axes, parameters=names)]


def _saturation(recording: Recording) -> list[Message]:
    if recording.wrench is None or recording.sensor.range is None:
        return []
    clipped = np.asarray((np.abs(recording.wrench) >= 0.999 * np.asarray(recording.sensor.range)).any(axis=0))
    names = [name for name, at_limit in zip(CHANNELS, clipped.tolist(), strict=True) if at_limit]
    return [Message.of("estimation-saturated", channels=names)] if names else []
