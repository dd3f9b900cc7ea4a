"""The bridge's supply is off and goes up and down with a slow cycle: a charger or a heater on the same line. The offset takes part."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from core.array import Array
from core.effects.channels import amplitudes, expand_to_channels, find_largest_channel, shares
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_gain import SensorGain
from core.effects.window_search import ROWS, weights
from core.words.message import Message

SHORTEST_S, LONGEST, CYCLES = 8.0, 1.5, 24
"""Cycles that are looked at, from s up to so many lengths of the run."""
SIGN = 0.7
"""Share of the residual's square that the best one leaves at most, or there is no sign of any."""
TRIED = 2
"""Cycles to start from."""
START = 0.02
"""Of the largest gain."""


class GainThatSwings(SensorGain):
    """`W = w + (1 + s sin(2 pi t / c + p)) (g w + A)`; the constant part of A is the sensor's offset."""

    wider_shape = True
    followed = 2

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Six gain errors `g`, as shares, swing `s`, cycle `c`, s, phase `p` at the first sample, rad, then what the offsets (6) take part
        with, N and N m."""
        seconds = max(float(scene.t[-1] - scene.t[0]), scene.period)
        return (
            *shares("gain_error_share", lower=-0.5, upper=0.5, scale=0.03),
            Parameter("swing_share", "1", 0.0, -20.0, 20.0, 1.0),
            Parameter("cycle_s", "s", seconds, 0.5 * SHORTEST_S, 3.0 * max(seconds, SHORTEST_S), 0.2 * seconds),
            Parameter("phase_rad", "rad", 0.0, -2.0 * np.pi, 2.0 * np.pi, 1.0),
            *amplitudes("offset", bound=expand_to_channels(50.0, 2.5), scale=expand_to_channels(1.0, 0.05)),
        )

    def smaller_shape(self, scene: Scene) -> int:
        """Gains alone."""
        return 9

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus what gains and offsets are off by at that time."""
        swing, cycle, phase = theta[6:9]
        course = 1.0 + swing * np.sin(2.0 * np.pi * scene.elapsed / cycle + phase)
        return np.asarray(w + course[:, None] * (theta[:6] * w + theta[9:]))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The cycles that explain most of the residual, about a mean of either sign."""
        columns = np.stack((scene.nominal, np.ones_like(scene.nominal)), axis=2)
        found = _find_cycles(scene, residual, columns)[:TRIED]
        return [_begin(cycle, weights(scene), sign) for cycle in found for sign in (1.0, -1.0)]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises looking at the supply, with the largest error of a gain in %, how far it swings, and the cycle, s."""
        k, channel = find_largest_channel(theta[:6])
        return Message.of(
            "advice-sensor-gain-swing", channel=channel, gain_share=theta[k], swing_share=abs(theta[k] * theta[6]), cycle_s=theta[7]
        )


def _begin(found: _Cycle, weights: Array, sign: float) -> Array:
    """(15,), in the phase of the channel that swings most, with its gain too large or too small in the mean, of which the payload takes
    much; by the weights (6,) of channels in the residual, whose unit is not known."""
    sine, cosine = found.sine / weights[:, None], found.cosine / weights[:, None]
    size = np.hypot(sine[:, 0], cosine[:, 0])
    k = int(np.argmax(size))
    phase = float(np.arctan2(cosine[k, 0], sine[k, 0]))
    gain, offset = (sign * START / max(float(size[k]), 1e-12) * (sine * np.cos(phase) + cosine * np.sin(phase))).T
    return np.concatenate((gain, [sign, found.cycle, phase], offset))


class _Cycle(NamedTuple):
    """A cycle, s, as a residual in standard deviations of the noise shows it.

    Args:
        left: what it leaves of the residual's square.
        sine, cosine: (6, m), coefficients of the columns of each channel with the sine and the cosine from the first sample on.
    """

    left: float
    cycle: float
    sine: Array
    cosine: Array


def _find_cycles(scene: Scene, residual: Array, columns: Array) -> list[_Cycle]:
    """Cycles, the best first, of columns (N, 6, m) that go up and down in each channel by itself, beside a trend; none in a run that is
    too short, and none where the residual shows no sign of them."""
    rows = slice(0, None, max(1, len(scene) // ROWS))
    t, seen, each = scene.elapsed[rows], residual[rows].T, columns[rows].transpose(1, 0, 2)
    if t[-1] < SHORTEST_S:
        return []
    m, trend, found = columns.shape[2], t[:, None] / t[-1], []
    for cycle in np.geomspace(SHORTEST_S, max(LONGEST * float(t[-1]), SHORTEST_S), CYCLES):
        angle = 2.0 * np.pi * t / cycle
        X = [np.hstack((x * np.sin(angle)[:, None], x * np.cos(angle)[:, None], x, trend)) for x in each]
        fits = np.array([np.linalg.lstsq(x, y, rcond=1e-9)[0] for x, y in zip(X, seen, strict=True)])
        left = sum(float(np.square(y - x @ fit).sum()) for x, y, fit in zip(X, seen, fits, strict=True))
        found.append(_Cycle(left, float(cycle), fits[:, :m], fits[:, m : 2 * m]))
    found.sort(key=lambda each: each.left)
    return found if found[0].left < SIGN * float(np.square(seen).sum()) else []
