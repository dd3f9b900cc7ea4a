"""A fixed line in the wrench: mains, a power supply, the field of a drive."""

from __future__ import annotations

import numpy as np

from core.effects.channels import CHANNELS, SUFFIXES, UNITS, expand_to_channels, in_words
from core.effects.effect import Finding, Parameter, Symptom, View
from core.effects.hold_noise import hold_noise, line_in, rate, steady
from core.recording.recording import Recording
from core.remark import Remark

SOURCES_HZ = (50.0, 60.0, 100.0, 120.0, 150.0, 180.0, 300.0)
"""Mains of both kinds with their strongest harmonics."""
SIGNIFICANT = 5.0
"""Standard deviations."""
MATERIAL = 3.0
"""Amplitude, in standard deviations of a sample's noise."""


class SensorInterference(Symptom):
    """`A sin(2 pi f t + phase)` in each channel, found in the raw wrench of the holds, where no motion hides it.

    Material where the amplitude is more than three times the stated noise of a sample in some channel; where none is stated, the noise
    beside the line. What rings down within the holds is no interference.
    """

    id = "sensor_interference"
    title = "electrical interference in the sensor's signal"
    stage = "sensor"
    side = "reading"
    explains = ("sensor_noise",)

    def parameters(self, recording: Recording) -> tuple[Parameter, ...]:
        """Frequency, Hz, and amplitude in each channel, N and N m."""
        nyquist = 0.5 * rate(recording)
        return (
            Parameter("frequency_hz", "Hz", 50.0, 0.0, nyquist, 50.0),
            *(
                Parameter(f"{channel}_amplitude_{suffix}", unit, 0.0, 0.0, float(100 * scale), float(scale))
                for channel, suffix, unit, scale in zip(CHANNELS, SUFFIXES, UNITS, expand_to_channels(0.3, 0.015), strict=True)
            ),
        )

    def observe(self, recording: Recording, view: View) -> Finding | None:
        """The strongest line in the holds' noise; None where they are too short, it is below five standard deviations, or rings down."""
        noise = hold_noise(recording, view.holds)
        samples_per_second = rate(recording)
        line = line_in(noise, samples_per_second)
        if line is None or line.sigma < SIGNIFICANT:
            return None
        relative = line.amplitude / line.floor
        if not steady(noise, line.frequency, samples_per_second, int(relative.argmax())):
            return None
        stated = recording.sensor.noise_std
        times = relative if stated is None else line.amplitude / stated
        worst = int(times.argmax())
        source, as_alias = _source(line.frequency, samples_per_second)
        sentence = (
            f"There is a line at {line.frequency:.2f} Hz{as_alias} with amplitudes up to "
            f"{in_words(line.amplitude).replace('+', '')}, {times[worst]:.1f} times the noise in {CHANNELS[worst]}."
        )
        values: dict[str, float | str] = {"frequency_hz": line.frequency, "times": float(times[worst]), "channel": CHANNELS[worst]}
        remark = Remark("line", sentence, values) if source is None else Remark("mains_line", sentence, {**values, "source_hz": source})
        theta = np.append(line.frequency, line.amplitude)
        std = np.append(line.frequency_std, line.amplitude_std)
        return Finding(theta, std, line.sigma, bool(times[worst] > MATERIAL), float(times[worst]), remark)

    def advice(self, finding: Finding) -> str:
        """Advises leading the cable away from motor and mains cables and grounding its shield, with the line's frequency in Hz."""
        return (
            "Lead the sensor's cable away from motor and mains cables and ground its shield at one end, "
            f"to be rid of the line at {finding.theta[0]:.1f} Hz."
        )


def _source(frequency: float, samples_per_second: float) -> tuple[float | None, str]:
    """The mains line that appears at this frequency once sampled, Hz, and the same in words; None and nothing where there is none."""
    for source in SOURCES_HZ:
        alias = abs(source - samples_per_second * round(source / samples_per_second))
        if abs(alias - frequency) < 0.01 * source:
            seen = "" if source < 0.5 * samples_per_second else f", seen as its alias at {samples_per_second:.0f} samples per second"
            return source, f" (mains, {source:.0f} Hz{seen})"
    return None, ""
