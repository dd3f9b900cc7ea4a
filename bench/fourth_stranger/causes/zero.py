"""The sensor's zero moves: a mist of coolant that comes and goes, a battery that runs down, a plug that loses its contact."""

from __future__ import annotations

import numpy as np

from bench.fourth_stranger.draws import draw_direction, draw_stretch, draw_zero, spread_over_grid, step_of
from bench.second_stranger.draws import measure_force
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig

COOLING_S, WARMING_S = 5.0, 19.0
"""How fast the sensor cools in the mist and warms up without, s."""
EVERY = 50
"""Steps of the grid."""


def drift_coolant(rng: np.random.Generator, rig: Rig) -> Fault:
    """A mist of coolant is switched on and off: the sensor cools fast in it, and warms up slowly without."""
    d, t = draw_zero(rng, rig), rig.t[::EVERY]
    turns = np.sort(rng.uniform(0.08, 0.95, 6)) * rig.seconds
    is_on = np.searchsorted(turns, t) % 2 == 1
    cold, z = np.empty(len(t)), 0.0
    for i, on in enumerate(is_on.tolist()):
        z += step_of(EVERY) * (1 - z) / COOLING_S if on else -step_of(EVERY) * z / WARMING_S
        cold[i] = z
    shape = spread_over_grid(rig, cold[:, None], EVERY)[:, 0]
    return Fault(
        size=lambda scale: Size(
            f"coolant's mist three times, cools in {COOLING_S:g} s and warms in {WARMING_S:g} s, force when coldest",
            scale * float(shape.max()) * measure_force(d),
            "N",
        ),
        distort=lambda W, scale: W + scale * np.outer(shape, d),
        temperature=None if rng.random() < 0.5 else 31.0 - 7.0 * shape,
    )


def drift_battery(rng: np.random.Generator, rig: Rig) -> Fault:
    """The battery that feeds the amplifier runs down: evenly first, then over a knee."""
    d, x = draw_zero(rng, rig), rig.t / rig.seconds
    knee = rng.uniform(0.55, 0.7)
    shape = 0.3 * x + 0.7 * (np.maximum(x - knee, 0) / (1 - knee)) ** 2.5
    return Fault(
        size=lambda scale: Size(f"battery runs down, over a knee from {knee * rig.seconds:.0f} s, force", scale * measure_force(d), "N"),
        distort=lambda W, scale: W + scale * np.outer(shape, d),
    )


def step_connector(rng: np.random.Generator, rig: Rig) -> Fault:
    """A plug works loose in a move: one of six bridges has another zero, after half a second in which it comes and goes."""
    stretch = draw_stretch(rng, rig, "transfer", 0.3, 0.7)
    at_s = 0.5 * (stretch.begin_s + stretch.end_s)
    along, foot = draw_direction(rng), 3 * rig.noise_std[3] / rig.noise_std[0] * draw_direction(rng)
    leg = np.concatenate([along, np.cross(foot, along)])
    flickers = np.repeat(rng.random(len(rig.t) // 30 + 1) < 0.5, 30)[: len(rig.t)]
    has_lost = (rig.t > at_s + 0.5) | ((rig.t > at_s) & flickers)
    return Fault(
        size=lambda scale: Size(f"one of six bridges has another zero from {at_s:.1f} s on, after half a second of flicker", scale, "N"),
        distort=lambda W, scale: W + scale * np.outer(has_lost, leg),
    )
