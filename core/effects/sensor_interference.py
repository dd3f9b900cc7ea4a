"""A fixed line in the wrench: mains, a power supply, the field of a drive."""

from __future__ import annotations

import numpy as np

from core.effects.channels import SUFFIXES, expand_to_channels, say_largest
from core.effects.effect import Finding, Parameter, Symptom, View
from core.effects.hold_noise import hold_noise, line_in, measure_whole, rate, steady
from core.payload.channels import CHANNELS, UNITS
from core.recording.recording import Recording
from core.words.message import Message

SOURCES_HZ = (50.0, 60.0, 100.0, 120.0, 150.0, 180.0, 300.0)
"""Mains of both kinds with their strongest harmonics."""
SIGNIFICANT = 5.0
"""Standard deviations."""
MATERIAL = 3.0
"""Amplitude, in standard deviations of a sample's noise."""


class SensorInterference(Symptom):
    """`A sin(2 pi f t + phase)` in each channel, found in the raw wrench of the holds, where no motion hides it.

    Material where all of it, with the harmonics, has the power of an amplitude of more than three times the stated noise of a sample in
    some channel while it is there; where none is stated, the noise beside the line. What rings down within the holds is no interference.
    """

    id = "sensor_interference"
    title = Message.of("effect-sensor-interference-title")
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
        times = measure_whole(noise, line, samples_per_second) / (line.floor if stated is None else stated)
        worst = int(times.argmax())
        place = _say_frequency(line.frequency, samples_per_second)
        amplitude, channel = say_largest(line.amplitude), CHANNELS[worst]
        seen = Message.of("symptom-line", place=place, amplitude=amplitude, times=times[worst], channel=channel)
        theta = np.append(line.frequency, line.amplitude)
        std = np.append(line.frequency_std, line.amplitude_std)
        return Finding(theta, std, line.sigma, bool(times[worst] > MATERIAL), float(times[worst]), seen)

    def advice(self, finding: Finding) -> Message:
        """Advises leading the cable away from motor and mains cables and grounding its shield, with the line's frequency in Hz."""
        return Message.of("advice-sensor-interference", frequency_hz=finding.theta[0])


def _say_frequency(frequency: float, samples_per_second: float) -> Message:
    """The frequency of a line, Hz, with the mains line that appears there once sampled, where there is one."""
    for source in SOURCES_HZ:
        alias = abs(source - samples_per_second * round(source / samples_per_second))
        if abs(alias - frequency) < 0.01 * source:
            if source < 0.5 * samples_per_second:
                return Message.of("symptom-mains", frequency_hz=frequency, source_hz=source)
            return Message.of("symptom-mains-alias", frequency_hz=frequency, source_hz=source, samples_per_second=samples_per_second)
    return Message.of("symptom-frequency", frequency_hz=frequency)
