"""The noise of the wrench while nothing moves: what is left of each hold without its trend, and the narrow line in it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import median_filter
from scipy.special import gammaincc
from scipy.stats import norm

from core.array import Array
from core.recording.recording import Recording

SETTLING = 0.25
"""Share of each hold that is left out at its start, where the arm still rings."""
LEAVING = 0.1
"""The same at its end, where an arm that speeds up is slow and yet accelerates."""
SHORTEST = 64
"""Samples; a shorter hold says too little of noise."""
PIECE_S, HARMONICS = 0.2, 5
"""In which the power of a line is measured, and how many of its multiples with it."""
LOWEST_HZ, HIGHEST = 10.0, 0.49
"""Slower than the first, a line may be the arm or a swinging load; faster than the second, a share of the sample rate, it has no phase."""
DETRENDED = 3
"""Bins of the spectrum that a quadratic trend empties."""
REACH = 16
"""Bins of the spectrum to either side that tell what the noise is there."""


@dataclass(frozen=True)
class Line:
    """A narrow line.

    Args:
        frequency, frequency_std: Hz, as it appears at the sample rate.
        amplitude, amplitude_std: (6,), N and N m.
        sigma: how far it stands above what white noise would show somewhere in the band, standard deviations.
        floor: (6,), standard deviation of the noise beside the line.
    """

    frequency: float
    frequency_std: float
    amplitude: Array
    amplitude_std: Array
    sigma: float
    floor: Array


def rate(recording: Recording) -> float:
    """Samples per second, Hz."""
    return float(1.0 / np.median(np.diff(recording.t)))


def hold_noise(recording: Recording, holds: tuple[slice, ...], *, keep: NDArray[np.bool_] | None = None) -> list[Array]:
    """(M_i, 6) of each hold that is long enough: its middle without a quadratic trend, N and N m; only rows in `keep` (N,)."""
    noise = []
    for hold in holds:
        rows = range(*hold.indices(len(recording)))
        first, stop = rows.start + round(SETTLING * len(rows)), rows.stop - round(LEAVING * len(rows))
        if recording.wrench is None or stop - first < SHORTEST:
            continue
        kept = slice(None) if keep is None else keep[first:stop]
        part = recording.wrench[first:stop][kept]
        if len(part) < SHORTEST // 2:
            continue
        trend, _ = np.linalg.qr(np.vander(np.linspace(-1, 1, len(part)), 3))
        noise.append(part - trend @ (trend.T @ part))
    return noise


def line_in(noise: list[Array], rate: float) -> Line | None:
    """The strongest line in the noise of all holds together, whatever its significance; None where they are too short.

    Averaged periodograms of pieces as long as the shortest hold (Welch 1967); a bin against the median of its neighbours, since noise
    need not be white.
    """
    L = min((len(part) for part in noise), default=0)
    if L < SHORTEST:
        return None
    pieces = _cut(noise, L)
    window = np.hanning(L)[:, None]
    power = (np.abs(np.fft.rfft(pieces * window, axis=1)) ** 2).sum(axis=0)
    K = len(pieces)
    f = np.arange(len(power)) * rate / L
    floor = _floor(power)
    floor *= K / (K - 1 / 3)  # the median of a sum of K exponentials is about K - 1/3 of their scale
    ratio = K * power / floor
    band = (f > max(LOWEST_HZ, 3 * rate / L)) & (f < HIGHEST * rate)
    if not band.any():
        return None
    single = _log_tail(ratio[band], K)
    joint = _log_tail(ratio[band].sum(axis=1), 6 * K)
    best = np.minimum(single.min(axis=1), joint)
    peak = int(np.flatnonzero(band)[best.argmin()])
    sigma = _sigma(float(best.min()) + np.log(7 * band.sum()))
    noise_std = np.sqrt(floor[peak] / (K * (window**2).sum()))
    return _measure_line(pieces, f[peak], rate, noise_std, sigma)


def measure_whole(noise: list[Array], line: Line, rate: float) -> Array:
    """(6,), amplitude, N and N m, of a sinusoid with the power of a line and its harmonics while it is there: the mean of that power over
    the holds, weighted with itself, so that a source that is off in most of them counts as it does where it is on.

    Measured in pieces so short that neither a phase that wanders nor a switch takes any of it away.
    """
    length = min(*(len(part) for part in noise), max(SHORTEST // 2, round(PIECE_S * rate)))
    seen = max(1, min(HARMONICS, int(HIGHEST * rate / line.frequency)))
    multiples = line.frequency * np.arange(1.0, seen + 1)
    amplitudes = np.array([_fit_amplitudes(_cut([part], length), multiples, rate, line.floor) for part in noise])
    power = np.square(amplitudes).sum(axis=1)
    return np.asarray(np.sqrt(np.square(power).sum(axis=0) / np.maximum(power.sum(axis=0), np.finfo(float).tiny)))


def without_line(noise: list[Array], frequency: float, rate: float) -> list[Array]:
    """The noise with a sinusoid of the given frequency fitted to each hold and taken out."""
    left = []
    for part in noise:
        wave, _ = np.linalg.qr(_wave(frequency, len(part), rate))
        left.append(part - wave @ (wave.T @ part))
    return left


def fit_waves(noise: list[Array], frequency: float, rate: float) -> Array:
    """(2 K, 6), cosine and sine of a sinusoid fitted to each of K holds."""
    waves = (_wave(frequency, len(part), rate) for part in noise)
    return np.concatenate([np.linalg.lstsq(wave, part, rcond=None)[0] for wave, part in zip(waves, noise, strict=True)])


def steady(noise: list[Array], frequency: float, rate: float, channel: int) -> bool:
    """Whether the line is as strong late in the holds as early in them; ringing is not."""
    early = np.mean([_power(part[: len(part) // 2, channel], frequency, rate) for part in noise])
    late = np.mean([_power(part[len(part) // 2 :, channel], frequency, rate) for part in noise])
    return bool(late > 0.5 * early)


def _measure_line(pieces: Array, coarse: float, rate: float, noise_std: Array, sigma: float) -> Line:
    """Frequency refined by the power of fitted sinusoids, amplitudes freed of what the noise adds to them."""
    K, L, _ = pieces.shape
    grid = coarse + np.linspace(-1, 1, 41) * rate / L
    weight = 1.0 / np.maximum(noise_std, np.finfo(float).tiny) ** 2
    powers = np.array([_fit_squared_amplitudes(pieces, grid[k : k + 1], rate)[0] for k in range(len(grid))])
    k = int(np.clip((powers @ weight).argmax(), 1, 39))
    y = (powers @ weight)[k - 1 : k + 2]
    bend = y[0] - 2 * y[1] + y[2]
    f = grid[k] + (0.5 * (y[0] - y[2]) / bend if bend < 0 else 0.0) * (grid[1] - grid[0])
    amplitude = _fit_amplitudes(pieces, np.array([f]), rate, noise_std)[0]
    ratio = float((amplitude**2 * weight).sum())
    std = np.sqrt(24 / (max(ratio, 1e-12) * L**3 * K)) * rate / (2 * np.pi)  # Rife and Boorstyn 1974, unknown phase
    return Line(float(f), min(float(std), rate / L), amplitude, noise_std * np.sqrt(2 / (L * K)), sigma, noise_std)


def _cut(noise: list[Array], length: int) -> Array:
    """(K, length, 6), the holds in pieces, what is left at the end of each dropped."""
    return np.array([part[k : k + length] for part in noise for k in range(0, len(part) - length + 1, length)])


def _fit_amplitudes(pieces: Array, frequencies: Array, rate: float, noise_std: Array) -> Array:
    """(n, 6), root mean squares over the pieces of the amplitudes of n sinusoids, freed of what the noise adds to them."""
    squared = _fit_squared_amplitudes(pieces, frequencies, rate) - 4 * noise_std**2 / pieces.shape[1]
    return np.asarray(np.sqrt(np.maximum(squared, 0.0)))


def _fit_squared_amplitudes(pieces: Array, frequencies: Array, rate: float) -> Array:
    """(n, 6), means over the pieces of the squared amplitudes of n sinusoids that are fitted together."""
    waves = np.hstack([_wave(f, pieces.shape[1], rate) for f in frequencies])
    coefficients = np.linalg.solve(waves.T @ waves, np.tensordot(waves.T, pieces, axes=(1, 1)).reshape(waves.shape[1], -1))
    return np.asarray((coefficients**2).reshape(len(frequencies), 2, len(pieces), -1).sum(axis=1).mean(axis=1))


def _floor(power: Array) -> Array:
    """Median of the bins below or above each bin, whichever is larger: beside a slope or a resonance a bin is no line.

    The lowest bins have lost their power with the trend and say nothing of what is beside them.
    """
    size, kept = (REACH, 1), power[DETRENDED:]
    below = median_filter(kept, size=size, mode="reflect", origin=(REACH // 2 - 1, 0))
    above = median_filter(kept, size=size, mode="reflect", origin=(-(REACH // 2), 0))
    floor = np.maximum(np.maximum(below, above), np.finfo(float).tiny)
    return np.concatenate([np.repeat(floor[:1], DETRENDED, axis=0), floor])


def _power(x: Array, frequency: float, rate: float) -> float:
    wave, _ = np.linalg.qr(_wave(frequency, len(x), rate))
    return float(((wave.T @ x) ** 2).sum()) / len(x)


def _wave(frequency: float, length: int, rate: float) -> Array:
    angle = 2 * np.pi * frequency / rate * np.arange(length)
    return np.column_stack([np.cos(angle), np.sin(angle)])


def _log_tail(x: Array, shape: float) -> Array:
    """Logarithm of the probability that a sum of `shape` unit exponentials exceeds `x`; asymptotic where it underflows."""
    tail = gammaincc(shape, x)
    safe = np.maximum(x, shape + 1.0)
    far = (shape - 1) * np.log(safe / shape) - (safe - shape)
    return np.where(tail > 1e-290, np.log(np.maximum(tail, 1e-300)), np.minimum(far, -667.0))


def _sigma(log_p: float) -> float:
    """Standard deviations of a normal variable with the same one-sided probability."""
    if log_p > -30:
        return max(0.0, float(norm.isf(min(1.0, np.exp(log_p)))))
    return float(np.sqrt(-2 * log_p - np.log(-4 * np.pi * log_p)))
