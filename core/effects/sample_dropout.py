"""Samples are held or lost: an overloaded bus, a sensor slower than the recorder."""

from __future__ import annotations

import math

import numpy as np
from scipy.ndimage import median_filter, uniform_filter1d

from core.array import Array
from core.effects.effect import Finding, Parameter, Symptom, View
from core.recording.held_readings import BLOCK, SIGNIFICANT, find_dead_bands, find_held_share
from core.recording.recording import PAUSE_S, Recording
from core.words.message import Message

MATERIAL = 0.01
"""Share of the samples that are held or lost."""
LEAST = 0.005
"""Share below which nothing is said: an arm that starts and stops makes channels repeat together as well."""
SAID = 5e-4
"""Share from which it is said: with one digit after the point, smaller ones are 0 %."""
ABOUT, STEADY = 101, 0.8
"""Rows about each from which the recorder's period there is taken, and share of them that have it where it is steady."""
QUANTILE_SIGMA, FAR_SIGMA = 1.645, 4.0
"""Of the logarithm of steps: how far the shortest twentieth is from the median, and what is beyond chance, in standard deviations."""
USUAL = 1e-4
"""Share of the rows that a good recorder may hold or lose."""


class SampleDropout(Symptom):
    """Share of rows whose six channels repeat the row before beyond what rounding alone explains, and share of rows missing from the clock.

    Rounded noise repeats a value by chance, each channel on its own: with share `p` held, a channel repeats with `e_i = p + (1 - p) c_i`
    and all six with `p + (1 - p) c_1 ... c_6`; both are counted, `p` is solved for. Material from 1 % of
    the samples; a pause of the recorder loses none, and what a bus has not sent because it changed too little is not held.
    """

    id = "sample_dropout"
    title = Message.of("effect-sample-dropout-title")
    stage = "sensor"
    side = "reading"
    explains = ("sensor_noise", "sensor_quantization")

    def parameters(self, recording: Recording) -> tuple[Parameter, ...]:
        """Share of the samples that are held, and share that are lost."""
        return (Parameter("held_share", "1", 0.0, 0.0, 1.0, 0.3), Parameter("lost_share", "1", 0.0, 0.0, 1.0, 0.3))

    def observe(self, recording: Recording, view: View) -> Finding | None:
        """Counts held rows and gaps of the clock; None without a wrench, below 400 samples, or where too few are held or lost."""
        if recording.wrench is None or len(recording) < 2 * BLOCK:
            return None
        held, informative, longest = find_held_share(recording.wrench)
        held = 0.0 if held and find_dead_bands(recording.wrench).any() else held
        lost = find_lost_share(recording.t)
        std = np.sqrt(np.array([held * (1 - held) + 1e-6, lost * (1 - lost) + 1e-6]) / np.array([max(informative, 1), len(recording)]))
        rows = informative if held >= lost else len(recording)
        sigma = rows * (max(held, lost) - USUAL) / math.sqrt(rows * USUAL + 1)
        if sigma < SIGNIFICANT or max(held, lost) < LEAST:
            return None
        period = float(np.median(np.diff(recording.t)))
        seen = Message.of("symptom-held-or-lost", **_say_shares(held, lost), longest_s=longest * period)
        times = (held + lost) / MATERIAL
        return Finding(np.array([held, lost]), std, sigma, times > 1.0, times, seen)

    def advice(self, finding: Finding) -> Message:
        """Advises matching the recorder's rate to the sensor's or relieving its bus, with both shares in %."""
        return Message.of("advice-sample-dropout", **_say_shares(*finding.theta))


def _say_shares(held: float, lost: float) -> dict[str, float]:
    """Both as they are said: a share that would be rounded to nothing is none."""
    return {name: float(share) if share >= SAID else 0.0 for name, share in (("held_share", held), ("lost_share", lost))}


def find_lost_share(t: Array) -> float:
    """Share of rows that the clock `t` (N,) should have beyond those it has: gaps of one and a half periods and more, and longer than an
    uneven clock makes them. Where a recorder changes its rate, and is steady there, that is its period."""
    steps = np.diff(t)
    period = np.full(len(steps), np.median(steps))
    local = median_filter(steps, ABOUT, mode="nearest")
    steady = uniform_filter1d((np.abs(steps - local) < 0.25 * local).astype(float), ABOUT, mode="nearest") > STEADY
    period[steady] = local[steady]
    times = steps / period
    spread = np.log(1.0 / np.clip(np.quantile(times, 0.05), 1e-3, 1.0)) / QUANTILE_SIGMA  # lost rows lengthen steps: the short ones tell
    lost = (times >= max(1.5, np.exp(FAR_SIGMA * spread))) & (steps <= np.maximum(PAUSE_S, 1.5 * period))  # nothing was due in a pause
    missing = int((np.rint(times[lost]) - 1).sum())
    return missing / (len(t) + missing)
