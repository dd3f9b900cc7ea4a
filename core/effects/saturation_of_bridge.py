"""Bridges of the sensor are at their ends: gauges are read before their signals become a wrench, so all channels bend at once."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.effects.channels import find_largest_channel, find_load_at_rest
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_saturation import SensorSaturation
from core.payload.channels import CHANNELS
from core.words.message import Message

LARGE_SIGMA, LARGE_SHARE = 8.0, 0.05
"""Rows in which a bridge is beyond its end, before a fit: by their size, and as a share of the largest."""
FEWEST = 20
ALONG = 0.98
"""Cosine to a bridge's direction from which on a row lacks what this bridge lost."""
WAYS = 200
"""Rows whose directions are looked at."""
THOSE_WAYS = 0.8
"""Share of the large rows' square that has to lie in the bridges' directions, or there is no sign of any."""
LEAST_ALONG = 0.05
"""Of the bridge's reading, what its own signal makes of it at least: one that hardly feels what it adds to is no bridge."""
BRIDGES, EACH = 2, 14
"""How many there are, and parameters of each."""


class SaturationOfBridge(SensorSaturation):
    """`W = w - sum over bridges of d (max(0, l . w - u) - max(0, v - l . w))`: a bridge reads `l . w`, and what is beyond one of its ends u
    and v lacks in all channels that it is a part of; so much of it that the bridge reads its end, `l . W = u`, which makes `l . d = 1`."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Of each bridge what the channels have of its reading, `l`, where that ends, `u` and `v`, and how what is beyond lacks among the
        channels, `d`, whose size is no matter; in loads of the payload at rest."""
        return tuple(
            Parameter(f"bridge_{number}_{name}_share", "1", 0.0, -3.0, 3.0, scale)
            for number in range(1, BRIDGES + 1)
            for name, scale in (
                *((channel, 0.4) for channel in CHANNELS),
                ("upper_limit", 0.5),
                ("lower_limit", 0.5),
                *((f"lost_{channel}", 0.4) for channel in CHANNELS),
            )
        )

    def smaller_shape(self, scene: Scene) -> int:
        """One bridge."""
        return EACH

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w - d / (l . d) beyond`, summed over the bridges."""
        load = find_load_at_rest(scene.phi)
        W = w.copy()
        for bridge in theta.reshape(-1, EACH):
            reads, lost = bridge[:6], bridge[8:]
            if lost.any():
                beyond = _find_beyond(w / load, bridge)
                W -= np.outer(beyond, lost / max(float(reads @ lost), _find_least(bridge)) * load)
        return W

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The directions in which large residuals lie, one or two, and for each the plane in the load by which they grow to either side;
        none where they lie in others."""
        large = _find_large(residual)
        ways = list(_find_ways(residual, large))
        if not ways:
            return []
        span, _ = np.linalg.qr(np.column_stack([way for way, _ in ways]))
        if np.square(residual[large] @ span).sum() < THOSE_WAYS * np.square(residual[large]).sum():
            return []
        found = [bridge for bridge in _find_bridges(scene, residual, ways) if float(bridge[:6] @ bridge[8:]) > _find_least(bridge)]
        return [np.concatenate((*found, np.zeros(EACH * (BRIDGES - len(found)))))] if found else []

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """Where this shape itself has left the residual: each of its bridges with the one that shows in what is left."""
        known = [bridge for bridge in plain.reshape(-1, EACH) if bridge.any()] if len(plain) == BRIDGES * EACH else []
        found = _find_bridges(scene, residual, list(_find_ways(residual, _find_large(residual)))[:1])
        return [np.concatenate((bridge, other)) for bridge in known for other in found]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises a larger range or a lighter payload, with the channel that loses most, and the share of the run in which it does, %."""
        lost = np.abs(self.wrench(scene, scene.nominal, theta) - scene.nominal) / find_load_at_rest(scene.phi)
        _, channel = find_largest_channel(lost.sum(axis=0))
        beyond = (lost > 0.0).any(axis=1)
        return Message.of("advice-sensor-saturation-bridge", channel=channel, share=float(beyond.mean()))


def _find_large(residual: Array) -> NDArray[np.bool_]:
    """(N,), the rows in which a bridge is beyond its end."""
    size = np.linalg.norm(residual, axis=1)
    return np.asarray(size > max(LARGE_SIGMA, LARGE_SHARE * float(size.max())))


def _find_bridges(scene: Scene, residual: Array, ways: list[tuple[Array, NDArray[np.bool_]]]) -> list[Array]:
    """(14,) each, whose ends the rows along these directions are beyond; none where the noise is not known."""
    if scene.noise is None:
        return []
    load = find_load_at_rest(scene.phi)
    return [_start(scene.nominal / load, residual, way, scene.noise / load, rows) for way, rows in ways]


def _find_ways(residual: Array, large: NDArray[np.bool_]) -> Iterator[tuple[Array, NDArray[np.bool_]]]:
    """Directions (6,) along which most of the large rows' square lies, and those rows; each of what the ones before have left."""
    left = large.copy()
    for _ in range(BRIDGES):
        if left.sum() < FEWEST:
            return
        rows = residual[left]
        unit = rows / np.linalg.norm(rows, axis=1)[:, None]
        looked_at = unit[:: max(1, len(unit) // WAYS)]
        square = np.square(rows).sum(axis=1)
        way = looked_at[np.argmax((np.abs(looked_at @ unit.T) > ALONG) @ square)]
        along = np.abs(unit @ way) > ALONG
        if along.sum() < FEWEST:
            return
        way = np.linalg.svd(rows[along], full_matrices=False)[2][0]
        chosen = np.zeros_like(left)
        chosen[np.flatnonzero(left)[along]] = True
        yield way, chosen
        left &= ~chosen


def _start(loads: Array, residual: Array, way: Array, noise: Array, rows: NDArray[np.bool_]) -> Array:
    """(14,), the bridge whose ends these rows are beyond; an end that no row is beyond is where the load ends."""
    lacking = residual[rows] @ way
    columns: Array = np.column_stack((loads[rows], lacking < 0.0, lacking >= 0.0))
    plane, ends = np.split(-np.linalg.lstsq(columns, lacking, rcond=1e-3)[0], [6])
    steepness = max(float(np.linalg.norm(plane)), 1e-9)
    reads, lost = plane / steepness, way * noise
    reading = loads @ reads
    upper, lower = -ends / steepness
    upper = upper if (lacking < 0.0).any() else reading.max()
    lower = lower if (lacking >= 0.0).any() else reading.min()
    return np.asarray(np.clip((*reads, upper, lower, *(lost / max(float(np.linalg.norm(lost)), 1e-9))), -3.0, 3.0))


def _find_beyond(loads: Array, bridge: Array) -> Array:
    """(N,), how far a bridge would read beyond its ends, in loads (N, 6) of the payload at rest; below the lower one it is negative."""
    reading = loads @ bridge[:6]
    return np.asarray(np.maximum(0.0, reading - bridge[6]) - np.maximum(0.0, bridge[7] - reading))


def _find_least(bridge: Array) -> float:
    """What `l . d` is at least."""
    return max(1e-9, LEAST_ALONG * float(np.linalg.norm(bridge[:6]) * np.linalg.norm(bridge[8:])))
