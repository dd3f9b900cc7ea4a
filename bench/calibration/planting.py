"""What is planted by seed: families and their variants, mechanical ones from here, those of signals from the virtual robot's faults."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from bench.calibration import unknowns
from bench.calibration.mechanics import SHAPES, Plant
from bench.calibration.stage import Play, set_stage
from core.array import Array
from core.plant.faults import FAULTS, Fault
from core.recording.recording import Recording

__all__ = ["PLANTS", "Planted", "plant_trial", "unknowns"]  # which registers its shapes

KINDS = {"none": 0.1, "single": 0.6, "double": 0.06, "unknown": 0.24}
OF_SIGNALS = {
    "sensor_drift": ("exponential", "linear", "two_time_constants", "random_walk", "thermostat"),
    "sensor_offset_step": ("step", "fast_ramp", "knock"),
    "sensor_gain": ("linear", "by_load_direction", "wandering_supply", "warming_supply"),
    "sensor_crosstalk": ("linear", "rectified", "product"),
    "sensor_nonlinearity": ("quadratic", "knee", "bow"),
    "sensor_hysteresis": ("play", "bouc_wen", "stick_and_snap"),
    "sensor_creep": ("exponential", "logarithmic"),
    "sensor_saturation": ("clip", "soft"),
    "time_delay": ("constant", "jitter", "slipping_buffer", "drifting_clock"),
    "kinematic_lag": ("first_order", "third_order", "polled"),
    "sensor_lowpass": ("first_order", "second_order", "moving_average", "weighing"),
    "joint_offset": ("warming",),
    "gear_ripple": ("sine", "modulated"),
    "unknown": (
        *("rubbing_seal", "gain_by_joint", "telegraph", "magnetic_field"),
        *("motor_pickup", "skewed_channels"),
    ),
}
"""Faults of the virtual robot that act on signals alone, by family and variant."""
SCALE = {"sensor_drift": 3.0, "sensor_nonlinearity": 4.0, "sensor_creep": 4.0, "sensor_crosstalk": 2.0, "joint_offset": 2.0}
"""Times the size of the virtual robot's, where runs are shorter and loads smaller against the range than there."""
SCALE_OF = {"motor_pickup": 10.0, "skewed_channels": 0.3, "drifting_clock": 0.3, "rubbing_seal": 0.5, "product": 8.0}
"""The same for single variants."""


class Planted(NamedTuple):
    """One trial before it is diagnosed.

    Args:
        families, variants: of what was planted, sorted by family.
        phi: (10,), the true payload.
        sound: the recording without what was planted, the same noise and background in it.
    """

    families: tuple[str, ...]
    variants: tuple[str, ...]
    size: float
    phi: Array
    recording: Recording
    sound: Recording


def _planting(kind: type[Fault]) -> Plant:
    factor = SCALE_OF.get(kind.variant, SCALE.get(kind.id, 1.0))

    def plant(p: Play) -> None:
        p.plant(kind.draw(p.rng, factor * p.size, p.setting))

    return plant


def _collect() -> dict[str, dict[str, Plant]]:
    found = {family: dict(variants) for family, variants in SHAPES.items()}
    for kind in FAULTS:
        if kind.variant in OF_SIGNALS.get(kind.id, ()):
            found.setdefault(kind.id, {})[kind.variant] = _planting(kind)
    return dict(sorted(found.items()))


PLANTS: dict[str, dict[str, Callable[[Play], None]]] = _collect()


def plant_trial(seed: int) -> Planted:
    """Draws what is planted, and plants it."""
    p = set_stage(seed)
    rng = np.random.default_rng([seed, 78])
    kind = str(rng.choice(list(KINDS), p=list(KINDS.values())))
    known = [family for family in PLANTS if family != "unknown"]
    chosen = rng.permutation(known)[: {"none": 0, "single": 1, "double": 2, "unknown": 0}[kind]].tolist()
    families = tuple(sorted(["unknown"] if kind == "unknown" else chosen))
    variants = tuple(str(rng.choice(sorted(PLANTS[family]))) for family in families)
    clean, read = p.wrench.copy(), p.read.copy()
    for family, variant in zip(families, variants, strict=True):
        PLANTS[family][variant](p)
    before = p.rng.bit_generator.state
    recording = p.record(clean)
    p.rng.bit_generator.state, p.wrench, p.read = before, clean.copy(), read
    return Planted(families, variants, p.size, p.body.phi, recording, p.record(clean))
