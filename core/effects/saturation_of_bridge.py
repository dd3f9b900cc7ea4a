"""One bridge of the sensor is at its end: gauges are read before their signals become a wrench, so all channels bend at once."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.channels import find_largest_channel, find_load_at_rest, shares
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_saturation import SensorSaturation
from core.words.message import Message

LARGE_SIGMA, LARGE_SHARE = 8.0, 0.15
"""Rows in which the bridge is beyond its end, before a fit: by their size, and as a share of the largest."""
FEWEST = 20
ONE_WAY = 0.8
"""Share of those rows' square that has to lie along one direction, or there is no sign of one bridge."""


LEAST_ALONG = 0.05
"""Of the bridge's reading, what its own signal makes of it at least: one that hardly feels what it adds to is no bridge."""


class SaturationOfBridge(SensorSaturation):
    """`W = w - d max(0, l . w - c)`: the bridge reads `l . w`, and what is beyond its end c lacks in all channels that it is a part of; so
    much of it that the bridge reads its end, `l . W = c`, which makes `l . d = 1`."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """What each channel has of the bridge's reading, `l`, where that ends, `c`, and how what is beyond lacks among the channels, `d`,
        whose size is no matter; in loads of the payload at rest."""
        return (
            *shares("bridge_share", lower=-3.0, upper=3.0, scale=0.4),
            Parameter("bridge_limit_share", "1", 0.0, -3.0, 3.0, 0.5),
            *shares("lost_share", lower=-3.0, upper=3.0, scale=0.4),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w - d / (l . d) max(0, l . w - c)`."""
        load, lost = find_load_at_rest(scene.phi), theta[7:]
        beyond = np.maximum(0.0, (w / load) @ theta[:6] - theta[6])
        return np.asarray(w - np.outer(beyond, lost / max(float(theta[:6] @ lost), _find_least(theta)) * load))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The direction in which large residuals lie, and the plane in the load by which they grow; none where they lie in several."""
        if scene.noise is None:
            return []
        load = find_load_at_rest(scene.phi)
        size = np.linalg.norm(residual, axis=1)
        large = size > max(LARGE_SIGMA, LARGE_SHARE * float(size.max()))
        if large.sum() < FEWEST:
            return []
        _, singular, ways = np.linalg.svd(residual[large], full_matrices=False)
        if singular[0] ** 2 < ONE_WAY * np.square(singular).sum():
            return []
        lacking = residual[large] @ ways[0]
        way = -ways[0] if np.median(lacking) > 0.0 else ways[0]
        columns = np.column_stack((scene.nominal[large] / load, np.ones(int(large.sum()))))
        *plane, end = np.linalg.lstsq(columns, -(residual[large] @ way), rcond=1e-3)[0]
        steepness = max(float(np.linalg.norm(plane)), 1e-9)
        lost = steepness * way * scene.noise / load
        lower, upper = (np.array([getattr(p, side) for p in self.parameters(scene)]) for side in ("lower", "upper"))
        start = np.clip(np.concatenate((np.array(plane) / steepness, [-end / steepness], lost)), lower, upper)
        return [start] if float(start[:6] @ start[7:]) > _find_least(start) else []

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises a larger range or a lighter payload, with the channel that loses most, and the share of the run in which it does, %."""
        beyond = (scene.nominal / find_load_at_rest(scene.phi)) @ theta[:6] > theta[6]
        _, channel = find_largest_channel(theta[7:])
        return Message.of("advice-sensor-saturation-bridge", channel=channel, share=float(beyond.mean()))


def _find_least(theta: Array) -> float:
    """What `l . d` is at least."""
    return max(1e-9, LEAST_ALONG * float(np.linalg.norm(theta[:6]) * np.linalg.norm(theta[7:])))
