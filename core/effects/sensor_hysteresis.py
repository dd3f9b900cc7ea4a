"""The reading depends on the direction from which a load was approached."""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from core.array import Array
from core.effects.channels import find_largest_channel, full_scale, shares, without_range
from core.effects.effect import Effect, Parameter
from core.effects.scene import Scene
from core.payload.channels import CHANNELS
from core.words.message import Message

TURNING = (0.001, 0.003, 0.01, 0.03)
"""Shares of full scale over which a loop may turn, from which fits start."""
SPREAD = np.array([-1.0, 0.0, 1.0])
"""Of the three stops' turning loads, in logarithm and in units of the parameter."""


class SensorHysteresis(Effect):
    """`W = w - h FS z(w)`: what is lost, `z` between -1 and 1, is the mean of three stops `(w - play_R(w)) / R` of graded R.

    `h` is half the height of the loop, positive where the reading stays behind the load and negative where it runs ahead (a creep
    compensation that overdoes it). R is the load over which it turns; equal R of the size `h FS` are the play operator, R graded round a
    larger one turn gently, as sensors do (Prandtl-Ishlinskii). Starts without hysteresis; the constant offset stands for what happened
    before. Source: Visintin, Differential Models of Hysteresis (1994), ch. III.
    """

    id = "sensor_hysteresis"
    title = Message.of("effect-sensor-hysteresis-title")
    stage = "sensor"
    needs_motion = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Half the heights of six loops as shares of full scale, six logarithms of turning loads over full scale, and their spread."""
        turning = (Parameter(f"{channel}_turning_load_log_ratio", "1", math.log(0.01), -9.0, 0.0, 1.0) for channel in CHANNELS)
        return (
            *shares("half_width_share", lower=-0.1, upper=0.1, scale=0.003),
            *turning,
            Parameter("turning_spread_log_ratio", "1", 0.0, 0.0, 0.8, 0.4),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w - h FS z(w)`, z the mean of three stops with graded turning loads."""
        full = full_scale(scene, w)
        radius = np.exp(theta[6:12] + theta[12] * SPREAD[:, None]) * full
        past = scene.past("play")
        start = np.tile(w[0], (len(SPREAD), 1)) if past.rows is None else past.rows
        W, past.rows = _turn_over(np.ascontiguousarray(w), theta[:6] * full, radius, start)
        return np.asarray(W)

    def explain_tie_to_run(self, scene: Scene) -> Message | None:
        """A reason where the sensor's range is not known: shares of it then hold for this run only."""
        return super().explain_tie_to_run(scene) or without_range(scene)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Loops without height that turn over 0.1, 0.3, 1 and 3 % of full scale."""
        # the heights are linear: one step finds them
        return [np.concatenate([np.zeros(6), np.full(6, math.log(share)), [0.3]]) for share in TURNING]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises checking the flanges' bolts, or one side of approach, with the height of the largest loop in % of full scale."""
        k, channel = find_largest_channel(theta[:6])
        return Message.of("advice-sensor-hysteresis", channel=channel, height_share=2 * theta[k])


@njit(cache=True)
def _turn_over(w: Array, height: Array, radius: Array, start: Array) -> tuple[Array, Array]:
    """`w` (N, 6) less `height` times the mean of the stops of `radius` (stops, 6), whose plays begin at `start`; and where these end."""
    out, at = np.empty_like(w), start.copy()
    for k in range(len(w)):
        for c in range(w.shape[1]):
            x, total = w[k, c], 0.0
            for s in range(len(radius)):
                at[s, c] = max(x - radius[s, c], min(x + radius[s, c], at[s, c]))
                total += (x - at[s, c]) / radius[s, c]
            out[k, c] = x - height[c] * (total / len(radius))
    return out, at
