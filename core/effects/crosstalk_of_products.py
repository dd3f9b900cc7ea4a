"""The product of two channels shows in a third: the terms of second order in a balance's calibration."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.channels import find_load_at_rest
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_crosstalk import SensorCrosstalk
from core.effects.splines import smooth_by_splines
from core.effects.window_search import ROWS
from core.payload.channels import CHANNELS
from core.payload.inertia import regressor
from core.words.message import Message

FIRST, SECOND = np.triu_indices(6)
PRODUCTS = tuple((i, j, k) for i in range(6) for j, k in zip(FIRST.tolist(), SECOND.tolist(), strict=True) if not i == j == k)
"""In which channel, of which two; the square of a channel in itself is `sensor_nonlinearity`."""
LINEAR = 31
SIGN = 0.9
"""Share of what linear cross-talk leaves that products explain, or there is no sign of them."""


class CrosstalkOfProducts(SensorCrosstalk):
    """`W_i = w_i + (linear cross-talk) + sum_jk b_ijk L_i (w_j / L_j) (w_k / L_k)`, L the most that the payload makes of a channel at rest.

    Calibrations of strain-gauge balances have these terms beside the linear ones (AIAA R-091).
    """

    wider_shape = True
    stands_alone = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Those of the linear one, then for each channel the products of two, all but its own square, as shares."""
        names = (f"{CHANNELS[i]}_from_{CHANNELS[j]}_times_{CHANNELS[k]}_share" for i, j, k in PRODUCTS)
        return (*super().parameters(scene), *(Parameter(name, "1", 0.0, -5.0, 5.0, 0.05) for name in names))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w`, linear cross-talk of it, and its products."""
        load = find_load_at_rest(scene.phi)
        b = np.zeros((6, 6, 6))
        b[tuple(np.array(PRODUCTS).T)] = theta[LINEAR:]
        products = _multiply(w / load) @ b[:, FIRST, SECOND].T
        return np.asarray(super().wrench(scene, w, theta[:LINEAR]) + load * products)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """None of it, where products explain most of what all that is linear leaves."""
        return [np.zeros(LINEAR + len(PRODUCTS))] if _do_products_show(scene, residual) else []

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises a calibration with loads in several channels at once, with the product that is largest."""
        largest = int(np.abs(theta[LINEAR:]).argmax())
        i, j, k = PRODUCTS[largest]
        share = theta[LINEAR + largest]
        return Message.of("advice-sensor-crosstalk-products", in_channel=CHANNELS[i], first=CHANNELS[j], second=CHANNELS[k], share=share)


def _multiply(w: Array) -> Array:
    """(N, 21), products of two channels each."""
    return np.asarray(w[:, FIRST] * w[:, SECOND])


def _do_products_show(scene: Scene, residual: Array) -> bool:
    """Whether products of channels explain most of a residual (N, 6), beyond what payload, offset and all channels take up of each."""
    rows = slice(0, None, max(1, len(scene) // ROWS))
    w = scene.nominal / find_load_at_rest(scene.phi)
    w, products = (smooth_by_splines(x, scene.period, scene.residual_window)[rows] for x in (w, _multiply(w)))
    V, one = regressor(scene.motion[rows]), np.ones((len(w), 1))
    without = with_them = 0.0
    for i, r in enumerate(residual[rows].T):
        columns = np.hstack((V[:, i], one, w))
        without += _find_rest(columns, r)
        with_them += _find_rest(np.hstack((columns, products)), r)
    return with_them < (1.0 - SIGN) * without


def _find_rest(columns: Array, r: Array) -> float:
    """The square of what columns (K, n) leave of r (K,)."""
    left = r - columns @ np.linalg.lstsq(columns, r, rcond=None)[0]
    return float(left @ left)
