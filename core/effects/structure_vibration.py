"""What carries the robot shakes: a floor, a table, an arm that was hit. Encoders do not see it, every mass feels it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.signal import butter, detrend, sosfiltfilt, welch

from core.array import Array
from core.effects.effect import Finding, Parameter, Symptom, View
from core.effects.hold_noise import fit_waves, hold_noise, line_in, rate
from core.payload.rotations import cross
from core.recording.recording import Recording
from core.words.message import Message

LOWEST_HZ, HIGHEST = 2.0, 0.4
"""The band that is looked at: from here, below which motions and hands are, to this share of the rate of the rows."""
SEGMENT_S = 2.0
"""Pieces that spectra are averaged over."""
SHORTEST = 40
"""Rows; fewer say too little."""
STANDS_OUT = 4.0
"""Times the median of the spectrum below the peak, above it, and of the whole band that the peak has to be."""
BAND = (0.75, 1.33)
"""Of the frequency, what counts as the same vibration."""
AT_MASS = 0.7
"""Share of the torque's square that the force has to account for when it acts at the payload's centre of mass: what shakes the payload as
a whole does, what pushes or rings elsewhere does not."""
AT_MASS_OF_LINE = 0.9
"""The same of a line, which stands out of all noise."""
OWN = 0.5
"""Share of the vibration that must not follow what the twin expects at that frequency: the rest may be a motion that is known badly."""
MATERIAL = 3.0
"""Amplitude, in standard deviations of a sample's noise."""


SIGNIFICANT = 5.0
"""Standard deviations by which a line in the holds stands out."""


class _Peak(NamedTuple):
    """A frequency, Hz, its uncertainty, and by how many standard deviations of the spectrum's floor it stands above that."""

    hz: float
    std_hz: float
    sigma: float


class StructureVibration(Symptom):
    """`w += m [a, c x a]`, a narrow in frequency and unknown to the encoders, c the payload's centre of mass.

    Sought in what the best explanation leaves of the wrench, and, for frequencies that its windows do not hold, as a line in the raw wrench
    of the holds: an electrical line knows nothing of the lever arm of the payload's mass. Material where the amplitude of a force is more
    than three times the stated noise of a sample; where none is stated, the noise of the holds.
    """

    id = "structure_vibration"
    title = Message.of("effect-structure-vibration-title")
    stage = "environment"
    side = "reading"
    explains = ("sensor_noise", "sensor_interference")
    explains_when_small = True  # an arm that swings little over the run may swing much in the holds, where noise is measured
    resembled_by = ("payload_loose", "joint_elasticity", "tool_flexibility")  # they swing at a frequency of their own, too

    def parameters(self, recording: Recording) -> tuple[Parameter, ...]:
        """Frequency, Hz, and amplitude of the acceleration along each axis of the sensor, m/s2."""
        axes = (Parameter(f"acceleration_{axis}_m_per_s2", "m/s2", 0.0, 0.0, 100.0, 0.3) for axis in "xyz")
        return (Parameter("frequency_hz", "Hz", 10.0, 0.0, 1e3, 5.0), *axes)

    def observe(self, recording: Recording, view: View) -> Finding | None:
        """The strongest vibration; None where none stands out, its torque is not that of the payload's mass, or it is a known motion."""
        if not np.isfinite(view.phi[:4]).all() or view.phi[0] <= 0.0:
            return None
        stated = view.noise_std if recording.sensor.noise_std is None else np.asarray(recording.sensor.noise_std)
        seen = _observe_windows(view, stated) or _observe_holds(recording, view, stated)
        return None if seen is None else _describe(*seen, float(view.phi[0]), stated)

    def advice(self, finding: Finding) -> Message:
        """Advises standing the robot firmly or waiting until it is quiet, with the frequency in Hz."""
        return Message.of("advice-structure-vibration", frequency_hz=finding.theta[0])


def _observe_windows(view: View, noise_std: Array) -> tuple[_Peak, Array] | None:
    """A vibration in what is left of the wrench, with the amplitude of its force (3,), N."""
    rows = _longest_stretch(view.left_t)
    if len(range(*rows.indices(len(view.left_t)))) < SHORTEST:
        return None
    step = float(np.median(np.diff(view.left_t[rows])))
    left, expected = view.left[rows], view.expected[rows]
    peak = _find_peak(left[:, :3], step)
    if peak is None:
        return None
    shaking, known = _pass_band(left, peak.hz, step), _pass_band(expected, peak.hz, step)
    by_noise = len(shaking) * np.square(noise_std[3:]).sum()
    if not _acts_at(_centre(view), shaking, AT_MASS, by_noise) or _follow(shaking[:, :3], known[:, :3], step) > 1.0 - OWN:
        return None
    return peak, np.sqrt(2.0 * np.square(shaking[:, :3]).mean(axis=0)) / np.sinc(peak.hz * step) ** 4  # what the windows have kept of it


def _observe_holds(recording: Recording, view: View, noise_std: Array) -> tuple[_Peak, Array] | None:
    """The same as a line in the holds, where arm and payload rest, faster than windows show; one that does not matter is left to be
    what any line is."""
    noise, samples_per_second = hold_noise(recording, view.holds), rate(recording)
    line = line_in(noise, samples_per_second)
    if line is None or line.sigma < SIGNIFICANT or (line.amplitude[:3] < MATERIAL * noise_std[:3]).all():
        return None
    if len(view.left_t) > SHORTEST and line.frequency < HIGHEST / float(np.median(np.diff(view.left_t))):
        return None  # what swings on known springs after a motion rings in the hold, and is in what the twin expects
    waves = fit_waves(noise, line.frequency, samples_per_second)
    if not _acts_at(_centre(view), waves, AT_MASS_OF_LINE):
        return None
    return _Peak(line.frequency, line.frequency_std, line.sigma), line.amplitude[:3]


def _describe(peak: _Peak, force: Array, mass: float, noise_std: Array) -> Finding:
    """A vibration with forces of amplitudes (3,)."""
    times, size = float((force / noise_std[:3]).max()), float(np.linalg.norm(force))
    theta = np.append(peak.hz, force / mass)
    std = np.append(peak.std_hz, np.full(3, float(force.max()) / mass / max(1.0, peak.sigma)))
    seen = Message.of("symptom-vibration", frequency_hz=peak.hz, force_n=size, acceleration_m_s2=size / mass, times=times)
    return Finding(theta, std, peak.sigma, times > MATERIAL, times, seen)


def _centre(view: View) -> Array:
    """(3,), m, the payload's centre of mass."""
    return np.asarray(view.phi[1:4] / view.phi[0])


def _longest_stretch(t: Array) -> slice:
    """The longest run of rows at times t (K,) without a gap."""
    if len(t) < 2:
        return slice(0, 0)
    apart = np.flatnonzero(np.diff(t) > 1.5 * float(np.median(np.diff(t)))) + 1
    edges = np.concatenate(([0], apart, [len(t)]))
    k = int(np.diff(edges).argmax())
    return slice(int(edges[k]), int(edges[k + 1]))


def _find_peak(force: Array, step: float) -> _Peak | None:
    """The frequency at which forces (K, 3), a row each `step` seconds, are strongest, where it stands out."""
    length = min(len(force), max(16, round(SEGMENT_S / step)))
    f, power = welch(detrend(force, axis=0), 1.0 / step, nperseg=length, axis=0)
    inside = np.flatnonzero((f >= LOWEST_HZ) & (f <= HIGHEST / step))
    if len(inside) < 5:
        return None
    P = power.sum(axis=1)
    k = int(inside[P[inside].argmax()])
    ratio = f / f[k]
    beside = ((ratio > 0.5) & (ratio < BAND[0]), (ratio > BAND[1]) & (ratio < 2.0), (f >= LOWEST_HZ) & (f <= HIGHEST / step))
    floor = max(float(np.median(P[rows])) if rows.any() else 0.0 for rows in beside) or np.finfo(float).tiny
    if floor * STANDS_OUT > P[k]:
        return None
    near = slice(max(1, k - 1), k + 2)
    pieces = 2 * len(force) // length - 1 or 1
    sigma = (float(P[k]) / floor - 1.0) * float(np.sqrt(3.0 * pieces))
    return _Peak(float(np.average(f[near], weights=P[near])), float(f[1]) / float(np.sqrt(12.0 * pieces)), sigma)


def _pass_band(x: Array, hz: float, step: float) -> Array:
    """Rows (K, n) around a frequency."""
    low, high = BAND[0] * hz, min(BAND[1] * hz, 0.48 / step)
    return np.asarray(sosfiltfilt(butter(2, (low, high), btype="bandpass", fs=1.0 / step, output="sos"), x, axis=0))


def _acts_at(point: Array, w: Array, share: float, by_noise: float = 0.0) -> bool:
    """Whether a share of the torques' square of wrenches (K, 6) is that of their forces at a point (3,), but for what noise adds to it."""
    torque, off = w[:, 3:], w[:, 3:] - cross(point, w[:, :3])
    rest, whole = float(np.square(off).sum()), float(np.square(torque).sum())
    return rest <= max((1.0 - share) * whole, by_noise)


def _follow(force: Array, known: Array, step: float) -> float:
    """Share of the square of forces (K, 3) that a linear mixture of known ones (K, 3), of any phase, accounts for."""
    columns = np.hstack((known, step * np.gradient(known, step, axis=0)))
    size = np.sqrt(np.square(columns).mean(axis=0))
    columns = columns[:, size > 1e-9 * max(1e-12, float(size.max()))]
    off = force - columns @ np.linalg.lstsq(columns, force, rcond=1e-6)[0]
    return 1.0 - float(np.square(off).sum()) / max(float(np.square(force).sum()), np.finfo(float).tiny)
