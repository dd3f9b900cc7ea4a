"""Recordings whose readings are made sample by sample, and what a symptom reads off them."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.signal import lfilter

from core.effects.effect import Finding, Symptom, View
from core.recording.recording import Recording, SensorDescription
from tests.core.effects.synthetic_scene import NOISE, RESOLUTION, scene

Array = np.ndarray
RATE = 500.0
SIX = np.array([1, 1, 1, 0.05, 0.05, 0.05])


def rounded(w: Array, step: Array = RESOLUTION) -> Array:
    return np.round(w / step) * step


def recording(*, seed: int = 0, added: Array | float = 0.0, noise: Array = NOISE, coloured: float = 0.0) -> Recording:
    """18 s at 500 Hz: loads of a moving payload, offsets, white or AR(1) noise, rounding."""
    run = scene(seconds=18.0)
    t = np.arange(round(RATE * run.t[-1])) / RATE
    rng = np.random.default_rng(seed)
    e = rng.standard_normal((len(t), 6))
    if coloured:
        e = lfilter([np.sqrt(1 - coloured**2)], [1, -coloured], e, axis=0)
    wrench = CubicSpline(run.t, run.nominal)(t) + [3, -2, 5, 0.1, -0.2, 0.3] + noise * e + added
    phase = run.phase[np.minimum(np.round(t * 100).astype(int), len(run) - 1)]
    return Recording(
        t=t, gravity=run.gravity, wrench=rounded(wrench), phase=phase, sensor=SensorDescription(noise_std=NOISE, resolution=RESOLUTION)
    )


def times(seconds: float = 17.99) -> Array:
    return np.arange(round(RATE * seconds)) / RATE


def view_of(record: Recording) -> View:
    """Holds by the labels, noise by plain standard deviations."""
    edges = np.flatnonzero(np.concatenate([[True], record.phase[1:] != record.phase[:-1], [True]]))
    holds = tuple(slice(int(a), int(b)) for a, b in pairwise(edges) if record.phase[a].startswith("hold"))
    std = np.median([record.wrench[hold].std(axis=0) for hold in holds], axis=0)
    return View(holds, std, np.full(10, np.nan), np.full(10, np.nan))


def seen(symptom: Symptom, record: Recording) -> Finding | None:
    return symptom.observe(record, view_of(record))


def value(symptom: Symptom, record: Recording, name: str) -> float:
    finding = seen(symptom, record)
    assert finding is not None
    names = [p.name for p in symptom.parameters(record)]
    assert finding.theta.shape == finding.std.shape == (len(names),)
    return float(finding.theta[names.index(name)])
