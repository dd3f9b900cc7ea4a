"""The sensor reads a load wrongly, at once: supplies, mixed-up moments, stops inside it, a bridge at its rail."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import lag

AMPLIFIER = np.array([0.0, 0.008, -0.03, 0.0, 0.0, -0.02])
CARD = np.array([0.03, -0.004, 0.0, -0.025, 0.0, 0.0])
"""(6,), gain errors: of the amplifier of the axial bridges, and of an exchanged card."""


def gain_supply(rng: np.random.Generator, rig: Rig) -> Fault:
    """The axial bridges' supply is low, and sags a little more while others draw from it."""
    draws = np.repeat(rng.random(len(rig.t) // 4000 + 1) < 0.4, 4000)[: len(rig.t), None].astype(np.float64)
    sags = lag(draws, 0.8)[:, 0]
    shape = 0.92 + 0.2 * sags
    return Fault(
        size=lambda scale: Size(
            "gain error fz (tz two thirds), supply sags by a fifth of it now and then", 100 * scale * AMPLIFIER[2], "%"
        ),
        distort=lambda W, scale: W * (1 + scale * np.outer(shape, AMPLIFIER)),
    )


def gain_card(rng: np.random.Generator, _: Rig) -> Fault:
    """A card of another serial number is in the amplifier."""
    e = CARD * rng.choice([-1, 1])
    return Fault(
        size=lambda scale: Size("gain error fx (tx nearly as much the other way)", 100 * scale * e[0], "%"),
        distort=lambda W, scale: W * (1 + scale * e),
    )


def cross_moments(rng: np.random.Generator, _: Rig) -> Fault:
    """Moments show in forces, as in a cross of beams whose gauges sit too far out."""
    C = np.zeros((6, 6))
    C[2, 4], C[2, 3], C[0, 3], C[1, 5] = np.array([0.9, -0.6, 0.4, 0.5]) * rng.choice([-1, 1])
    return Fault(
        size=lambda scale: Size("moment ty shows in fz", scale * C[2, 4], "N/(N m)"),
        distort=lambda W, scale: W + scale * W @ C.T,
    )


def cross_lateral(rng: np.random.Generator, _: Rig) -> Fault:
    """The lateral forces show in each other and in the axial one, not alike."""
    C = np.zeros((6, 6))
    C[1, 0], C[0, 1], C[2, 0], C[5, 1] = np.array([0.03, 0.012, -0.02, 0.0012]) * rng.choice([-1, 1])
    return Fault(
        size=lambda scale: Size("fx shows in fy", 100 * scale * C[1, 0], "%"),
        distort=lambda W, scale: W + scale * W @ C.T,
    )


def nonlin_stop(rng: np.random.Generator, rig: Rig) -> Fault:
    """A pin that should stop an overload touches too early: above a load of either sign less of it goes through the gauges."""
    most = np.maximum(np.abs(rig.load).max(0), 1e-6)
    knee, width = most * rng.uniform(0.35, 0.55, 6), 0.04 * most
    share = np.array([1, 0.8, 0.5, 0.7, 1, 0.2])

    def touch(W: Array, scale: float) -> Array:
        above = width * (np.logaddexp(0, (W - knee) / width) - np.logaddexp(0, (-W - 1.2 * knee) / width))
        return np.asarray(W - 0.08 * scale * share * above)

    return Fault(size=lambda scale: Size("stiffer above about half the load by", 8 * scale, "%"), distort=touch)


def sat_bridge(rng: np.random.Generator, rig: Rig) -> Fault:
    """One of six bridges ends at its rail, before their signals become a wrench: all channels bend at once."""
    to_wrench = _stand_on_six_legs()
    raw = np.linalg.solve(to_wrench, (rig.load + rig.offset).T).T
    legs = raw.std(0)
    leg = int(rng.choice(np.argsort(legs)[-3:]))
    highest, span = np.quantile(raw[:, leg], 0.985), np.ptp(raw[:, leg])

    def clip(W: Array, scale: float) -> Array:
        s = np.linalg.solve(to_wrench, (W + rig.offset).T).T
        s[:, leg] = np.minimum(s[:, leg], highest - 0.12 * scale * span)
        return np.asarray(s @ to_wrench.T - rig.offset)

    return Fault(
        size=lambda scale: Size(f"bridge {leg + 1} of 6 at its rail, below its peak by share of its span", 0.12 * scale, "-"), distort=clip
    )


def _stand_on_six_legs() -> Array:
    """(6, 6), by which the forces along six slanted legs, N, make a wrench, N and N m."""
    to_wrench = np.zeros((6, 6))
    for leg in range(6):
        low, high = np.radians(60 * (leg + leg % 2)), np.radians(60 * (leg + (leg + 1) % 2))
        foot = 0.035 * np.array([np.cos(low), np.sin(low), 0])
        head = np.array([0.025 * np.cos(high), 0.025 * np.sin(high), 0.022])
        along = (head - foot) / np.linalg.norm(head - foot)
        to_wrench[:3, leg], to_wrench[3:, leg] = along, np.cross(foot, along)
    return to_wrench
