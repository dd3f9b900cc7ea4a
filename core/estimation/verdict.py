"""The answer in words: the verdict, and what the user should know before using the numbers."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from core.estimation.determination import explain_not_excited
from core.estimation.estimate import Estimate
from core.estimation.generalised_least_squares import Fit
from core.payload.inertia import PHI_NAMES
from core.recording.recording import Recording
from core.remark import Remark

Array = NDArray[np.float64]

CHANNELS = ("fx", "fy", "fz", "tx", "ty", "tz")
INTERVAL = 1.96


def verdict_of(estimate: Estimate, *, static: bool) -> str:
    """One or two sentences."""
    if not estimate.determined[0]:
        return f"The payload is not determined: {estimate.reasons['m']}."
    half = INTERVAL * float(estimate.std[0])
    places = max(0, 1 - math.floor(math.log10(half)))
    mass = f"The payload has {estimate.phi[0]:.{places}f} kg (±{half:.{places}f} kg, 95 %)"
    if estimate.determined.all():
        return f"{mass}; all ten inertial parameters are determined."
    if estimate.determined[:4].all() and not estimate.determined[4:].any():
        why = "static poses only: the inertia is not excited" if static else "the motion does not excite the inertia enough"
        return f"{mass}; mass and first moment are determined, the inertia is not ({why})."
    missing = ", ".join(name for name, known in zip(PHI_NAMES, estimate.determined, strict=True) if not known)
    return f"{mass}; not determined: {missing}."


def warnings_of(recording: Recording, estimate: Estimate, found: Fit, *, static: bool) -> tuple[Remark, ...]:
    """The most important first."""
    said: list[Remark] = []
    ratio = np.sqrt(found.scale)
    if found.noise.measured and (ratio > 1.0).any():
        worst = int(np.argmax(ratio))
        sentence = (
            f"the residual exceeds the sensor's noise, most in {CHANNELS[worst]} ({ratio[worst]:.1f} times with its correlation in time): "
            "something that the model leaves out; the uncertainties were widened, but an error that repeats is not noise"
        )
        said.append(Remark("residual", sentence, {"channel": CHANNELS[worst], "times": float(ratio[worst])}))
    if estimate.constrained:
        said.append(Remark("no_such_body", "the data alone asked for a body that cannot exist; the nearest one that can was taken"))
    if not found.noise.measured and not static:
        sentence = "no motionless part long enough to measure the sensor's noise: it was taken from the residual"
        said.append(Remark("noise_of_residual", sentence))
    said += _saturation(recording)
    tilt = estimate.base_tilt_rad
    if tilt is not None and estimate.base_tilt_std is not None and (np.abs(tilt) > 4.0 * estimate.base_tilt_std).any():
        size = float(np.linalg.norm(tilt))
        if np.degrees(size) > 0.1:
            said.append(Remark("base_tilt", f"the base is not level: {np.degrees(size):.2f} deg; taken into account", {"angle_rad": size}))
    delay, delay_std = estimate.delay_s, estimate.delay_std
    if delay is not None and delay_std is not None and abs(delay) > max(4.0 * delay_std, 1e-3):
        late = "late" if delay > 0 else "early"
        sentence = f"the wrench is {abs(delay) * 1e3:.1f} ms {late} against the joints; taken into account"
        said.append(Remark("delay", sentence, {"delay_s": delay}))
    if (estimate.drift.range > np.maximum(4.0 * estimate.drift.std, 2.0 * estimate.noise_std)).any():
        said.append(Remark("drift", f"{estimate.drift.description}; taken into account"))
    return tuple(said)


def on_transfers_alone(estimate: Estimate, turned: str | None) -> list[Remark]:
    """Inertial parameters that are determined without any rotation that was meant to show them.

    Args:
        turned: sensor axes that were turned about; None where nobody has said what was done when.
    """
    left_out = {} if turned is None else explain_not_excited(turned)
    names = ", ".join(name for name, known in zip(PHI_NAMES, estimate.determined, strict=True) if known and name in left_out)
    if not names:
        return []
    axes = " or ".join(axis for axis in "xyz" if axis not in (turned or ""))
    sentence = f"there was no rotation about {axes}: {names} rest on the transfers alone, and no rotation that was left out verifies them"
    return [Remark("transfers_alone", sentence, {"axes": axes, "parameters": names})]


def _saturation(recording: Recording) -> list[Remark]:
    if recording.wrench is None or recording.sensor.range is None:
        return []
    clipped = np.asarray((np.abs(recording.wrench) >= 0.999 * np.asarray(recording.sensor.range)).any(axis=0))
    names = ", ".join(name for name, at_limit in zip(CHANNELS, clipped.tolist(), strict=True) if at_limit)
    return [Remark("saturated", f"the sensor reached the end of its range in {names}", {"channels": names})] if names else []
