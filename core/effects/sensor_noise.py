"""The wrench is noisier than stated, or its noise is coloured."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.channels import find_largest_channel
from core.effects.effect import Finding, Parameter, Symptom, View
from core.effects.hold_noise import hold_noise, line_in, rate, steady, without_line
from core.effects.sensor_interference import SIGNIFICANT
from core.effects.sensor_quantization import step_of
from core.payload.channels import CHANNELS
from core.recording.held_readings import find_held_share
from core.recording.recording import Recording
from core.words.message import Message

HELD = 0.01
"""Share of held samples from which on they are left out."""
TOLERANCE = 0.1
"""Stated noise figures are not better than this."""
HIDDEN = 2.0
"""Steps of so many standard deviations hide the noise."""
MATERIAL = 1.5
"""Times the stated noise, over all frequencies."""
MATERIAL_SLOW = 1.7
"""Times the stated noise, slow part: what averaging leaves."""
ONLY_SLOW, OWN_FILTER_S = 2.5, 0.005
"""The same of noise that is as large as stated, and how long it is correlated at least: a filter of 30 Hz does."""


class SensorNoise(Symptom):
    """Noise `v_k = rho v_(k-1) + e_k` (AR(1)) of `factor` times the stated standard deviation, in the later part of the holds.

    Trend, mains line, repeated samples and what the visible resolution adds are taken out first. Material where it is more than 1.5 times
    the stated noise, or, correlated, 1.7 times of it in what is slow against the samples, `factor sqrt((1 + rho)/(1 - rho))`. Where it is
    as large as stated, correlation alone is what every sensor's own filter makes, unless it is larger and lasts longer than that.
    """

    id = "sensor_noise"
    title = Message.of("effect-sensor-noise-title")
    stage = "sensor"
    side = "reading"
    resembled_by = ("payload_loose", "joint_elasticity", "tool_flexibility")  # what swings after a motion, swings in the hold

    def parameters(self, recording: Recording) -> tuple[Parameter, ...]:
        """Noise of each channel as a multiple of what is stated, and correlation from sample to sample."""
        factors = (Parameter(f"{channel}_noise_factor", "1", 1.0, 0.0, 100.0, 2.0) for channel in CHANNELS)
        return (*factors, Parameter("correlation", "1", 0.0, -1.0, 1.0, 0.5))

    def observe(self, recording: Recording, view: View) -> Finding | None:
        """Compares the holds' noise with what is stated; None where none is stated, no hold is long enough, or it is not above that."""
        stated, wrench = recording.sensor.noise_std, recording.wrench
        noise = _lineless(recording, view)
        if stated is None or wrench is None or not noise:
            return None
        step = np.array([step_of(channel) or 0.0 for channel in wrench.T])
        variance, rho, spread = _moments(noise)
        effective = np.maximum(1.0, sum(len(part) for part in noise) * (1 - rho**2) / (1 + rho**2))  # Bartlett 1946
        factor = np.sqrt(np.maximum(variance - step**2 / 12, 0.0)) / stated
        hidden = step > HIDDEN * stated
        factor, rho = np.where(hidden, 1.0, factor), np.where(hidden, 0.0, rho)
        std = np.maximum(factor, TOLERANCE) * np.sqrt(1 / (2 * effective) + spread**2)  # rounding may hide all noise of a channel
        common = float(np.median(rho))
        slow = factor * np.sqrt((1 + np.clip(rho, 0, 0.999)) / (1 - np.clip(rho, 0, 0.999)))
        rho_std = 1 / np.sqrt(6 * effective.mean())
        sigma = max(float(((factor - 1 - TOLERANCE) / std).max()), float((common - TOLERANCE) / rho_std))
        if sigma < SIGNIFICANT or not (factor.max() > 1 + TOLERANCE or slow.max() > MATERIAL):
            return None
        k, channel = find_largest_channel(factor)
        seen = Message.of("symptom-noisier", channel=channel, times=factor[k], correlation=common)
        slower = slow > MATERIAL_SLOW
        if factor.max() <= 1 + TOLERANCE:
            lasts_s = -1.0 / (rate(recording) * np.log(np.clip(rho, 1e-9, 0.999)))
            slower = (slow > ONLY_SLOW) & (lasts_s > OWN_FILTER_S)
        material = bool(factor.max() > MATERIAL or slower.any())
        times = float(slow.max() if slow.max() / MATERIAL_SLOW > factor.max() / MATERIAL else factor.max())
        return Finding(np.append(factor, common), np.append(std, rho_std), sigma, material, times, seen)

    def advice(self, finding: Finding) -> Message:
        """Advises checking supply, shield and cable, or stating the higher noise, with the factor of the noisiest channel."""
        k, channel = find_largest_channel(finding.theta[:6])
        return Message.of("advice-sensor-noise", channel=channel, times=finding.theta[k])


def _lineless(recording: Recording, view: View) -> list[Array]:
    """Noise of the holds without the mains line, held samples left out."""
    if recording.wrench is None:
        return []
    if find_held_share(recording.wrench)[0] > HELD:
        fresh = np.concatenate([[True], (np.diff(recording.wrench, axis=0) != 0).any(axis=1)])
        return hold_noise(recording, view.holds, keep=fresh)
    noise = hold_noise(recording, view.holds)
    samples_per_second = rate(recording)
    line = line_in(noise, samples_per_second)
    if line is not None and line.sigma > SIGNIFICANT:
        k = int((line.amplitude / line.floor).argmax())
        if steady(noise, line.frequency, samples_per_second, k):
            noise = without_line(noise, line.frequency, samples_per_second)
    return noise


def _moments(noise: list[Array]) -> tuple[Array, Array, Array]:
    """Variance, correlation from row to row, and the relative uncertainty of the standard deviation as the holds differ in it, (6,) each.

    The median over the holds: a hold in which the arm shakes does not speak for the sensor.
    """
    variance = np.array([part.var(axis=0) for part in noise])
    lag = np.array([(part[1:] * part[:-1]).mean(axis=0) for part in noise])
    middle = np.maximum(np.median(variance, axis=0), np.finfo(float).tiny)
    rho = np.clip(np.median(lag, axis=0) / middle, -0.99, 0.99)
    spread = np.median(np.abs(variance / middle - 1), axis=0) / np.sqrt(len(noise)) / 2
    return middle, rho, spread
