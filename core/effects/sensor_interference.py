"""A fixed line in the wrench: mains, a power supply, the field of a drive."""

from __future__ import annotations

import numpy as np

from core.effects.channels import CHANNELS, SUFFIXES, UNITS, in_words, six
from core.effects.effect import Finding, Parameter, Symptom, View
from core.effects.hold_noise import hold_noise, line_in, rate, steady
from core.recording import Recording

SOURCES_HZ = (50.0, 60.0, 100.0, 120.0, 150.0, 180.0, 300.0)
"""Mains of both kinds with their strongest harmonics."""
SIGNIFICANT = 5.0
"""Standard deviations."""


class SensorInterference(Symptom):
    """`A sin(2 pi f t + phase)` in each channel, found in the raw wrench of the holds, where no motion hides it.

    Material where the line's power exceeds that of the noise of a sample in some channel. What rings down within the holds is no
    interference.
    """

    id = "sensor_interference"
    title = "electrical interference in the sensor's signal"
    stage = "sensor"
    explains = ("sensor_noise",)

    def parameters(self, recording: Recording) -> tuple[Parameter, ...]:
        """See `Symptom.parameters`."""
        nyquist = 0.5 * rate(recording)
        return (
            Parameter("frequency_hz", "Hz", 50.0, 0.0, nyquist, 50.0),
            *(
                Parameter(f"{channel}_amplitude_{suffix}", unit, 0.0, 0.0, float(100 * scale), float(scale))
                for channel, suffix, unit, scale in zip(CHANNELS, SUFFIXES, UNITS, six(0.3, 0.015), strict=True)
            ),
        )

    def observe(self, recording: Recording, view: View) -> Finding | None:
        """See `Symptom.observe`."""
        noise = hold_noise(recording, view.holds)
        samples_per_second = rate(recording)
        line = line_in(noise, samples_per_second)
        if line is None or line.sigma < SIGNIFICANT:
            return None
        relative = line.amplitude / np.sqrt(2) / line.floor
        if not steady(noise, line.frequency, samples_per_second, int(relative.argmax())):
            return None
        sentence = (
            f"a line at {line.frequency:.2f} Hz{_source(line.frequency, samples_per_second)} "
            f"with amplitudes up to {in_words(line.amplitude).replace('+', '')}, {relative.max():.1f} times the noise beside it"
        )
        theta = np.append(line.frequency, line.amplitude)
        std = np.append(line.frequency_std, line.amplitude_std)
        return Finding(theta, std, line.sigma, bool(relative.max() > 1.0), sentence)

    def advice(self, finding: Finding) -> str:
        """See `Symptom.advice`."""
        return (
            "Lead the sensor's cable away from motor and mains cables and ground its shield at one end, "
            f"to be rid of the line at {finding.theta[0]:.1f} Hz."
        )


def _source(frequency: float, samples_per_second: float) -> str:
    """The mains line that appears at this frequency once sampled, in words; empty where there is none."""
    for source in SOURCES_HZ:
        alias = abs(source - samples_per_second * round(source / samples_per_second))
        if abs(alias - frequency) < 0.01 * source:
            seen = "" if source < 0.5 * samples_per_second else f", seen as its alias at {samples_per_second:.0f} samples per second"
            return f" (mains, {source:.0f} Hz{seen})"
    return ""
