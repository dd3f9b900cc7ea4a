"""The six channels of a wrist sensor: names, units, and what their full scale is."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.payload.channels import CHANNELS, UNITS
from core.words.message import Message

SUFFIXES = ("n", "n", "n", "nm", "nm", "nm")
"""Units as they stand in the names of parameters."""
STANDARD_GRAVITY_M_S2 = 9.80665


def expand_to_channels(force: float, torque: float) -> Array:
    """(6,): one value for the three forces, one for the three torques."""
    return np.repeat([force, torque], 3)


def shares(what: str, *, lower: float, upper: float, scale: float) -> tuple[Parameter, ...]:
    """Six dimensionless parameters `fx_<what>` to `tz_<what>`, absent at zero."""
    return tuple(Parameter(f"{channel}_{what}", "1", 0.0, lower, upper, scale) for channel in CHANNELS)


def amplitudes(what: str, *, bound: Array, scale: Array, per: str = "") -> tuple[Parameter, ...]:
    """Six parameters `fx_<what>_n` to `tz_<what>_nm`, absent at zero; `bound` and `scale` are (6,).

    Args:
        per: unit by which the amplitudes are divided, if any.
    """
    return tuple(
        Parameter(
            f"{channel}_{what}_{suffix}" + (f"_per_{per.lower()}" if per else ""),
            unit + (f"/{per}" if per else ""),
            0.0,
            -float(b),
            float(b),
            float(s),
        )
        for channel, suffix, unit, b, s in zip(CHANNELS, SUFFIXES, UNITS, bound, scale, strict=True)
    )


def full_scale(scene: Scene, w: Array) -> Array:
    """(6,), N and N m: the sensor's range; where it is unknown the largest load of the run, which alone looks at all rows."""
    if scene.range is not None:
        return np.asarray(scene.range, dtype=float)
    return np.asarray(np.maximum(np.abs(w).max(axis=0), expand_to_channels(1.0, 0.05)))


def find_load_at_rest(phi: Array) -> Array:
    """(6,), N and N m, the most that a payload (10,) makes of each channel at rest."""
    moment = np.square(phi[1:4])
    across = np.sqrt(moment.sum() - moment)
    return np.asarray(np.maximum(STANDARD_GRAVITY_M_S2 * np.concatenate((np.full(3, abs(phi[0])), across)), expand_to_channels(1.0, 0.05)))


def without_range(scene: Scene) -> Message | None:
    """Why shares of full scale have a meaning in this run only, None where the sensor's range is known."""
    if scene.range is not None:
        return None
    return Message.of("effect-no-range")


def find_largest_channel(values: Array) -> tuple[int, str]:
    """Index and name of the channel with the largest magnitude."""
    k = int(np.abs(values).argmax())
    return k, CHANNELS[k]


def say_load(value: float, channel: int) -> Message:
    """A value of one channel with its unit, N or N m."""
    return Message.of("effect-force", force_n=value) if channel < 3 else Message.of("effect-torque", torque_nm=value)


def say_largest(values: Array) -> Message:
    """The largest force and the largest torque of a wrench (6,), with their channels."""
    f, t = int(np.abs(values[:3]).argmax()), 3 + int(np.abs(values[3:]).argmax())
    return Message.of(
        "effect-force-and-torque", force_n=values[f], force_channel=CHANNELS[f], torque_nm=values[t], torque_channel=CHANNELS[t]
    )
