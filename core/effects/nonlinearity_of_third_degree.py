"""The reading is a polynomial of the load, as calibration certificates state it: pull and push differ, and the middle bends otherwise."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.channels import find_largest_channel, find_load_at_rest, say_load, shares
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_nonlinearity import SensorNonlinearity
from core.words.message import Message


class NonlinearityOfThirdDegree(SensorNonlinearity):
    """`W = w + s w + b w^2 / L + c w^3 / L^2`, L the most that the payload makes of a channel at rest (ISO 376 interpolates so).

    The even term differs in sign between pull and push, which `w |w|` does not.
    """

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Six even terms `b`, then six odd ones `c`, both at the load, then six errors `s` of the slope, all as shares."""
        return (
            *shares("second_degree_share", lower=-0.5, upper=0.5, scale=0.02),
            *shares("third_degree_share", lower=-0.5, upper=0.5, scale=0.02),
            *shares("slope_error_share", lower=-0.5, upper=0.5, scale=0.02),
        )

    def smaller_shape(self, scene: Scene) -> int:
        """Without an error of the slope."""
        return 12

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w + s w + b w^2 / L + c w^3 / L^2` in each channel."""
        x = w / find_load_at_rest(scene.phi)
        return np.asarray(w * (1.0 + theta[12:] + theta[:6] * x + theta[6:12] * x * x))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """All zero."""
        return [np.zeros(18)]  # linear in its parameters: one step finds them

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises checking the linearity with known weights in both directions, with the largest bend in % at the payload's load."""
        bend = np.abs(theta[:6]) + np.abs(theta[6:12])
        k, channel = find_largest_channel(bend)
        load = say_load(float(find_load_at_rest(scene.phi)[k]), k)
        return Message.of("advice-sensor-nonlinearity-polynomial", channel=channel, bend_share=bend[k], load=load)
