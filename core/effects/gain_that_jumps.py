"""The gain changes at once: a strain gauge that comes off its beam, a wire of a bridge that breaks."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.channels import find_largest_channel, shares
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_gain import SensorGain
from core.effects.window_search import best_windows
from core.words.message import Message

TIMES = 3
"""To start from."""


class GainThatJumps(SensorGain):
    """`W = w + g w` from `t0` on, reached within one sample. The payload takes up a gain that all channels have from the start.

    Offsets of its own at `t0` would make of every jump of the offset, which is hardly ever a plain step, a gain.
    """

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Change of each gain (6), as a share, and its time, s, from the first sample on."""
        seconds = float(scene.t[-1] - scene.t[0])
        return (
            *shares("gain_change_share", lower=-0.5, upper=0.5, scale=0.03),
            Parameter("step_time_s", "s", seconds / 2, 0.0, seconds, 0.3 * max(seconds, scene.period)),
        )

    def smaller_shape(self, scene: Scene) -> None:
        """All of them."""

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus what gains have changed from t0 on."""
        since = np.clip((scene.elapsed - theta[6]) / scene.period, 0.0, 1.0)
        return np.asarray(w * (1.0 + np.outer(since, theta[:6])))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The times from which on gains explain most, with the signs by which the residual goes with the load then."""
        columns = scene.nominal[:, :, None] * np.eye(6)
        found = [begin - float(scene.t[0]) for begin, _ in best_windows(scene, residual, columns, TIMES, open_end=True)]
        along = residual * scene.nominal
        signs = [np.sign(along[scene.elapsed >= at].mean(axis=0) - along[scene.elapsed < at].mean(axis=0)) for at in found]
        return [np.concatenate((0.01 * sign, [at - 0.5 * scene.period])) for at, sign in zip(found, signs, strict=True)]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises having the sensor checked, with the time, s, and the largest change of a gain in %."""
        k, channel = find_largest_channel(theta[:6])
        return Message.of("advice-sensor-gain-jump", channel=channel, change_share=theta[k], at_s=theta[6])
